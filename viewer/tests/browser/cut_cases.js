// SPDX-License-Identifier: GPL-3.0-or-later
// Cuts, hidden layers and heights, by pixels.
import assert from 'node:assert/strict';
import test from 'node:test';
import { run } from './pages.js';
import { keep, page, picture, place, reset, set, values } from './session.js';

/** Pixels at the middles of layers in a plane against the layers' colours: how many were looked at, and which were wrong. */
function facesWrong(points) {
  return page.evaluate((places) => {
    const app = window.stratareeb;
    const wrong = [];
    let count = 0;
    for (const [x, y] of places)
      for (let layer = 0; layer < app.units.length; ++layer) {
        const p = window.look.middle(layer, x, y, 4);
        if (!p) continue;
        const [px, py] = app.project(p);
        const found = app.pointer.at(px, py);
        if (!found || Math.hypot(...p.map((c, k) => c - found.shown[k])) > 2) continue; // something stands before it
        ++count;
        const seen = window.look.pixel(px, py);
        if (seen !== app.colors[layer] || found.layer !== layer) wrong.push([layer, seen, app.colors[layer], found.layer]);
      }
    return { count, wrong };
  }, points);
}

test('a cut has filled faces in the colours of its layers', async () => {
  for (const [cut, view] of [['x', 'west'], ['y', 'south']]) {
    await reset(view);
    await set({ cut, cutAt: 0.5, holes: false, frame: false });
    const along = Array.from({ length: 25 }, (_, i) => (i - 12) * 30);
    const { count, wrong } = await facesWrong(along.map((c) => (cut === 'x' ? [0, c] : [c, 0])));
    assert.deepEqual(wrong, []);
    assert.ok(count > 8, `${cut}: only ${count} places`);
  }
  await keep('cut_y');
});

test('a level cut shows the unit at that elevation that query names', async () => {
  await reset('top');
  await set({ cut: 'z', cutAt: 0.5, holes: false, frame: false });
  const places = await page.evaluate(() => {
    const app = window.stratareeb;
    const list = [];
    for (let i = -5; i <= 5; ++i)
      for (let j = -5; j <= 5; ++j) {
        const p = [i * 61, j * 67, -1e-6];
        const column = app.model.column(p[0], p[1]);
        if (!column || column.some((z) => Math.abs(z) < 0.7) || column[0] < 0 || column.at(-1) > 0) continue;
        const [px, py] = app.project(p);
        list.push({ at: p.map((c, k) => c + app.datum[k]), color: window.look.pixel(px, py), colors: app.colors, codes: app.units.map(({ code }) => code) });
      }
    return list;
  });
  assert.ok(places.length > 20, `only ${places.length} places`);
  for (const { at, color, colors, codes } of places.slice(0, 12)) {
    const answer = JSON.parse(run('query', place, '--at', at.join(), '--json'));
    assert.equal(color, colors[codes.indexOf(answer.unit)], `at ${at}`);
  }
});

test('a block taken out and a dipping plane have filled faces too', async () => {
  await reset('oblique');
  await set({ block: 'remove', holes: false, frame: false });
  const west = Array.from({ length: 12 }, (_, i) => [1e-3, -40 * (i + 1)]);
  const south = Array.from({ length: 12 }, (_, i) => [-40 * (i + 1), 1e-3]);
  const block = await facesWrong([...west, ...south]);
  assert.deepEqual(block.wrong, []);
  assert.ok(block.count > 5, `only ${block.count} places`);
  await keep('block');
  await reset('south');
  await set({ cut: 'azimuth', azimuth: 0, dip: 60, cutAt: 0.5, holes: false, frame: false });
  const wrong = await page.evaluate(() => {
    const app = window.stratareeb;
    const list = [];
    for (let i = -9; i <= 9; ++i)
      for (let z = -20; z < 25; z += 2.3) {
        const p = [i * 35, -z / Math.tan(Math.PI / 3), z]; // on the plane through the middle
        const column = app.model.column(p[0], p[1]);
        const layer = column ? column.findIndex((top, k) => z < top - 1 && z > column[k + 1] + 1) : -1;
        if (layer < 0) continue;
        const seen = window.look.pixel(...app.project(p).slice(0, 2));
        list.push(seen === app.colors[layer]);
      }
    return list;
  });
  assert.ok(wrong.length > 15 && wrong.every((right) => right), JSON.stringify(wrong));
});

test('hidden layers are gone, from the picture and from under the pointer', async () => {
  await reset('top');
  await set({ holes: false, frame: false });
  const found = () =>
    page.evaluate(() => {
      const app = window.stratareeb;
      const counts = {};
      for (let px = 60; px < app.stage.size[0]; px += 40)
        for (let py = 60; py < app.stage.size[1]; py += 40) {
          const what = app.pointer.at(px, py);
          if (what) counts[what.layer] = (counts[what.layer] ?? 0) + 1;
        }
      return counts;
    });
  const all = await found();
  assert.ok(all[0] > 5 && all[2] > 5);
  const whole = await picture();
  await page.locator('#layer-0').uncheck();
  assert.deepEqual((await values()).hidden, [0]);
  const rest = await found();
  assert.equal(rest[0], undefined);
  assert.ok(rest[2] > all[2]);
  assert.notEqual(await picture(), whole);
  await page.locator('.buttons button', { hasText: 'None' }).click();
  assert.equal(await page.evaluate(() => window.look.covered()), 0);
  await page.locator('.buttons button', { hasText: 'All' }).click();
  assert.equal(await picture(), whole);
});

test('exaggeration scales heights and nothing else', async () => {
  await reset('south');
  await set({ orthographic: true, exaggeration: 2 });
  const spans = () =>
    page.evaluate(() => {
      const { project, box } = window.stratareeb;
      const app = window.stratareeb;
      app.stage.draw();
      const [low, high] = [project.call(app, box.low), project.call(app, box.high)];
      return [high[0] - low[0], low[1] - high[1]];
    });
  const [wide, tall] = await spans();
  await page.locator('#type-exaggeration').fill('6');
  await page.locator('#type-exaggeration').press('Enter');
  assert.equal((await values()).exaggeration, 6);
  const [wideNow, tallNow] = await spans();
  assert.ok(Math.abs(tallNow / tall - 3) < 0.01, `${tallNow / tall}`);
  assert.ok(Math.abs(wideNow / wide - 1) < 1e-6);
});
