// SPDX-License-Identifier: GPL-3.0-or-later
// The page as a reader has it: each control changes what is drawn as it should.
import assert from 'node:assert/strict';
import { statSync } from 'node:fs';
import path from 'node:path';
import test, { after, before } from 'node:test';
import { hasTable, launch, modelFolder, openPage, pictures, run } from './pages.js';

let browser;
let place;
let page;

before(async () => {
  place = modelFolder('sighthill');
  browser = await launch();
  page = await openPage(browser, place);
});
after(() => browser?.close());

const set = (changes) => page.evaluate((c) => window.stratareeb.settings.set(c), changes);
const reset = (view = 'oblique') =>
  page.evaluate((v) => {
    window.stratareeb.settings.reset();
    window.stratareeb.stage.show(v);
  }, view);
const values = () => page.evaluate(() => window.stratareeb.settings.values);
const picture = () => page.evaluate(() => window.look.picture());
const keep = (name) => page.screenshot({ path: path.join(pictures, `${name}.png`) });
const open = (id) => page.evaluate((i) => (document.getElementById(`section-${i}`).open = true), id);

test('opens from disk without a network, says nothing in the console, names all layers', async () => {
  assert.deepEqual(page.asked.filter((url) => !url.startsWith('file://') && !url.startsWith('data:') && !url.startsWith('blob:')), []);
  assert.equal(page.asked.filter((url) => url.startsWith('file://')).length, 1);
  assert.deepEqual(page.said, []);
  assert.equal(await page.title(), 'sighthill');
  const names = await page.locator('.legend .name').allTextContents();
  assert.equal(names.length, 7);
  assert.ok(names.includes('made_ground'));
  assert.ok((await page.evaluate(() => window.look.covered())) > 0.1);
  await keep('sighthill');
});

test('nothing is drawn while nothing changes', async () => {
  await page.waitForTimeout(300);
  const frames = () => page.evaluate(() => window.stratareeb.stage.frames);
  const first = await frames();
  await page.waitForTimeout(500);
  assert.equal(await frames(), first);
});

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

test('the pointer says which layer, where and how thick, as query does', async () => {
  await reset('top');
  await set({ holes: false });
  for (const [x, y] of [[40, 60], [-150, 20], [120, -180]]) {
    const { px, py, at } = await page.evaluate(([fx, fy]) => {
      const app = window.stratareeb;
      app.stage.draw();
      const z = app.model.column(fx, fy)[0];
      const [sx, sy] = app.project([fx, fy, z]);
      return { px: sx, py: sy, at: [fx + app.datum[0], fy + app.datum[1]] };
    }, [x, y]);
    await page.mouse.move(px + 30, py);
    await page.mouse.move(px, py);
    await page.waitForFunction((want) => Math.abs(Number(document.querySelector('[data-fact=x]')?.textContent) - want) < 3, at[0]);
    const fact = (what) => page.locator(`[data-fact=${what}]`).textContent();
    const place2 = [Number(await fact('x')), Number(await fact('y'))];
    const answer = JSON.parse(run('query', place, '--at', place2.join(), '--json'));
    const unit = answer.units.find(({ thickness }) => thickness > 0);
    assert.equal(await fact('layer'), unit.name);
    assert.ok(Math.abs(Number(await fact('z')) - unit.top) < 0.06, `${await fact('z')} instead of ${unit.top}`);
    assert.ok(Math.abs(parseFloat(await fact('thickness')) - unit.thickness) < 0.06);
  }
});

test('a borehole says its interval under the pointer and shows its log when clicked', async () => {
  await reset('top');
  const hole = await page.evaluate(() => {
    const app = window.stratareeb;
    app.stage.draw();
    const i = app.holes.findIndex(({ id }) => id === 'GBH04');
    app.settings.set({ hidden: [0, 1, 2, 3, 4, 5, 6], holeSize: 2 });
    app.settings.set({ hidden: [] , opacity: 0.4 });
    const { x, y, top } = app.holes[i];
    return app.project([x, y, top]);
  });
  await page.mouse.move(hole[0] + 15, hole[1] + 15);
  await page.mouse.move(hole[0], hole[1]);
  await page.waitForSelector('.tip:not([hidden])');
  assert.match(await page.locator('.tip').textContent(), /^GBH04: topsoil, z 52\.61 to 51\.91, depth 0\.00–0\.70 m$/);
  await page.mouse.click(hole[0], hole[1]);
  await page.waitForSelector('.card h2');
  assert.equal(await page.locator('.card h2').first().textContent(), 'GBH04');
  const rows = await page.locator('.card tbody tr').allTextContents();
  assert.deepEqual(rows, ['topsoil0.000.70', 'made_ground0.706.40', 'clay6.4010.00', 'rock10.00>11.20']);
  assert.equal(await page.locator('.hole-tag').textContent(), 'GBH04');
  await keep('log');
  await page.keyboard.press('Escape');
  assert.equal(await page.locator('.card:not(.help)').isVisible(), false);
});

test('each control changes the picture', async () => {
  for (const id of ['layers', 'cut', 'holes', 'contours', 'reeb', 'compare', 'look', 'output']) await open(id);
  const slide = (id, value) => async () => {
    await page.locator(`#set-${id}`).evaluate((e, v) => {
      e.value = v;
      e.dispatchEvent(new Event('input', { bubbles: true }));
    }, String(value));
  };
  const check = (id, on) => () => page.locator(`#set-${id}`).setChecked(on);
  const select = (id, value) => () => page.locator(`#set-${id}`).selectOption(value);
  const press = (id, value) => () => page.locator(`#set-${id} button[data-value="${value}"]`).click();
  const type = (id, value) => async () => {
    await page.locator(`#${id}`).fill(value);
    await page.locator(`#${id}`).press('Enter');
  };
  const controls = [
    slide('opacity', 0.5), slide('explode', 0.3), slide('exaggeration', 0.7), slide('holeSize', 0.8),
    check('smooth', false), check('edges', true), check('frame', false), check('holes', false),
    select('palette', 'safe'), select('palette', 'ordered'), select('theme', 'dark'),
    select('contours', 'solids'), select('contours', '0'), select('reeb', '2'), select('reeb', 'layered'),
    press('cut', 'x'), press('cut', 'azimuth'), press('block', 'remove'), press('block', 'keep'),
    slide('slab', 0.3), check('compare', true),
  ];
  await reset();
  const start = await picture();
  for (const control of controls) {
    await control();
    assert.notEqual(await picture(), start, control.toString());
    await reset();
  }
  assert.equal(await picture(), start);
  // Second-order controls, each after the one that it belongs to.
  const pairs = [
    [press('cut', 'x'), slide('cutAt', 0.3)], [press('cut', 'x'), type('type-cutAt', '259700')], [press('cut', 'x'), check('cutFlip', true)],
    [press('cut', 'azimuth'), type('set-azimuth', '120')], [press('cut', 'azimuth'), type('set-dip', '35')],
    [press('cut', 'x'), check('holesCut', false)], [press('block', 'remove'), slide('block-1', 0.8)],
    [select('contours', 'solids'), type('set-interval', '1')], [select('contours', 'solids'), type('set-level', '50')],
    [slide('slab', 0.3), type('set-slabs', '7')],
  ];
  for (const [first, second] of pairs) {
    await first();
    const between = await picture();
    await second();
    assert.notEqual(await picture(), between, second.toString());
    await reset();
  }
  assert.equal(await picture(), start);
  assert.deepEqual(page.said, []);
});

test('a typed position is a map coordinate', async () => {
  await reset();
  await set({ cut: 'x' });
  await page.locator('#type-cutAt').fill('259800');
  await page.locator('#type-cutAt').press('Enter');
  const east = await page.evaluate(() => {
    const app = window.stratareeb;
    const { n, d } = app.cut.planes[0];
    return -d / n[0] + app.datum[0];
  });
  assert.ok(Math.abs(east - 259800) < 1e-6, `${east}`);
});

test('the handle drags the cut', async () => {
  await reset();
  await set({ cut: 'x', cutAt: 0.5 });
  await picture(); // the handle is placed with the frame
  const knob = await page.locator('.knob').boundingBox();
  const [x, y] = [knob.x + knob.width / 2, knob.y + knob.height / 2];
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 60, y - 12, { steps: 4 });
  await page.mouse.up();
  assert.ok((await values()).cutAt > 0.55);
});

test('a graph is picked in the diagram and in the model', async () => {
  await reset();
  await open('reeb');
  await set({ reeb: '2', holes: false });
  const arcs = await page.locator('.graph .arc').count();
  assert.ok(arcs > 3);
  const before = await picture();
  await page.locator('.graph .node').first().click({ force: true });
  assert.match((await values()).picked, /^n\d+$/);
  assert.match(await page.locator('#graph-note').textContent(), /at \d+\.\d\d m/);
  assert.notEqual(await picture(), before);
  await page.locator('.graph .arc').first().focus();
  await page.keyboard.press('Enter');
  assert.match((await values()).picked, /^a\d+$/);
  // The largest arc's part of the surface is drawn in the arc's colour; every triangle of the solid has an arc.
  const { used, all, vertices } = await page.evaluate(() => {
    const app = window.stratareeb;
    const counts = new Map();
    for (const arc of app.graph.arcOf) counts.set(arc, (counts.get(arc) ?? 0) + 1);
    const [largest, most] = [...counts].sort((a, b) => b[1] - a[1])[0];
    app.settings.set({ picked: `a${largest}` });
    const { index, walls } = app.layersView.layers[2];
    return { used: most, all: [app.graph.arcOf.length, (2 * index.length) / 3 + walls.length / 9], vertices: app.graphView.part.vertices };
  });
  assert.equal(all[0], all[1]);
  assert.equal(vertices, 3 * used);
  await keep('reeb');
  const node = await page.evaluate(() => {
    const app = window.stratareeb;
    app.settings.set({ picked: '' });
    app.stage.draw();
    return app.project(app.graph.nodes[0].at);
  });
  await page.mouse.click(node[0], node[1]);
  assert.match((await values()).picked, /^n\d+$/);
  await set({ reeb: 'layered', picked: 'n2' });
  assert.ok((await page.evaluate(() => window.stratareeb.graphView.contours.vertices)) > 10);
  await keep('layered');
});

test('raw beside smooth: two halves that differ, and the pointer knows which', async () => {
  await reset('oblique');
  await set({ compare: true, cut: 'y' });
  const { left, right, same } = await page.evaluate(() => {
    const app = window.stratareeb;
    app.stage.show('south');
    app.stage.draw();
    const p = [60, 0, 0];
    const z = app.halves[0].grid.plan.box.low[2];
    const [lx, ly] = app.stage.project([p[0], p[1], z + 20], 0);
    const [rx, ry] = app.stage.project([p[0], p[1], z + 20], 1);
    const [a, b] = [app.pointer.at(lx, ly), app.pointer.at(rx, ry)];
    return { left: a?.half, right: b?.half, same: Math.abs(rx - lx - app.stage.size[0] / 2) < 1e-6 && Math.abs(ly - ry) < 1e-6 };
  });
  assert.deepEqual([left, right, same], [0, 1, true]);
  await keep('compare');
});

test('measuring gives the distance between two boreholes', async () => {
  await reset('top');
  await set({ holes: false });
  const ends = await page.evaluate(() => {
    const app = window.stratareeb;
    app.stage.draw();
    return ['GBH04', 'GBH02'].map((id) => {
      const hole = app.holes.find((other) => other.id === id);
      return [...app.project([hole.x, hole.y, hole.top]).slice(0, 2), hole.x, hole.y];
    });
  });
  await page.keyboard.press('m');
  for (const [x, y] of ends) await page.mouse.click(x, y);
  const text = await page.locator('.measure').textContent();
  const flat = Math.hypot(ends[0][2] - ends[1][2], ends[0][3] - ends[1][3]);
  assert.ok(Math.abs(Number(/in plan ([\d.]+)/.exec(text)[1]) - flat) < 3, `${text}; ${flat}`);
  await page.keyboard.press('Escape');
  assert.equal(await page.locator('.measure').isVisible(), false);
});

test('keys do what the help says', async () => {
  await reset();
  await page.locator('canvas').focus();
  const after = async (key) => {
    await page.keyboard.press(key);
    return values();
  };
  assert.deepEqual((await after('3')).hidden, [2]);
  assert.deepEqual((await after('3')).hidden, []);
  assert.equal((await after('x')).cut, 'x');
  assert.ok((await after('ArrowRight')).cutAt > 0.5);
  assert.equal((await after('x')).cut, 'off');
  assert.equal((await after('p')).orthographic, true);
  assert.equal((await after('b')).holes, false);
  assert.equal((await after('c')).contours, 'solids');
  assert.ok((await after('+')).exaggeration > 5);
  const eye = () => page.evaluate(() => window.stratareeb.stage.cameraState().slice(0, 3).map(Math.round).join());
  const seen = new Set();
  for (const key of ['t', 'n', 'e', 's', 'w', 'o']) {
    await page.keyboard.press(key);
    seen.add(await eye());
  }
  assert.equal(seen.size, 6);
  await page.keyboard.press('r');
  const turned = await eye();
  await page.waitForFunction((from) => window.stratareeb.stage.cameraState().slice(0, 3).map(Math.round).join() !== from, turned);
  await page.keyboard.press('Escape');
  await page.keyboard.press('?');
  assert.ok(await page.locator('.help').isVisible());
  await page.keyboard.press('Escape');
});

test('an address brings the view back', async () => {
  await reset('east');
  await set({ cut: 'azimuth', azimuth: 30, dip: 70, cutAt: 0.4, hidden: [0, 3], contours: '3', explode: 0.2, palette: 'safe' });
  await page.evaluate(() => window.stratareeb.stage.show('north'));
  const fragment = await page.evaluate(() => window.stratareeb.fragment());
  await page.waitForTimeout(600);
  assert.equal(decodeURIComponent(new URL(page.url()).hash), `#${decodeURIComponent(fragment)}`);
  const other = await openPage(browser, place, { fragment: `#${fragment}` });
  assert.equal(await other.evaluate(() => window.stratareeb.fragment()), fragment);
  await reset();
  await page.waitForTimeout(600); // until the address has followed
  await page.evaluate((f) => (location.hash = f), fragment);
  await page.waitForFunction(() => window.stratareeb.settings.get('cut') === 'azimuth');
  assert.equal(await other.evaluate(() => window.look.picture()), await picture());
  await other.context().close();
});

test('an address that this model can’t follow does no harm', async () => {
  const other = await openPage(browser, place, { fragment: '#reeb=99&contours=77&hole=5000&hidden=3,99,-1&picked=a999&cut=nowhere' });
  const { reeb, contours, hole, hidden, cut } = await other.evaluate(() => window.stratareeb.settings.values);
  assert.deepEqual([reeb, contours, hole, hidden, cut], ['off', 'off', -1, [3], 'off']);
  assert.deepEqual(other.said, []);
  await other.context().close();
});

test('the picture is a PNG of twice the size', async () => {
  await reset();
  const file = page.waitForEvent('download');
  await page.keyboard.press('Shift+S');
  const download = await file;
  assert.equal(download.suggestedFilename(), 'sighthill.png');
  const target = path.join(pictures, 'saved.png');
  await download.saveAs(target);
  assert.ok(statSync(target).size > 20000);
  const size = await page.evaluate(async () => {
    const image = await createImageBitmap(await window.stratareeb.picture());
    return [image.width, image.height, ...window.stratareeb.stage.size];
  });
  assert.deepEqual(size.slice(0, 2), [2 * size[2], 2 * size[3]]);
});

test('a thousand changes leave nothing behind', async () => {
  await reset();
  const after = (count) =>
    page.evaluate(async (n) => {
      const app = window.stratareeb;
      const state = (i) => ({
        cut: ['off', 'x', 'y', 'z', 'azimuth'][i % 5], cutAt: (i % 17) / 17, block: ['off', 'remove', 'keep'][i % 3], slab: i % 4 === 0 ? i % 20 : 0,
        explode: i % 6 === 0 ? 0.3 : 0, contours: ['off', 'solids', '0', '2'][i % 4], reeb: ['off', '2', '4', 'layered'][i % 4], picked: `a${i % 6}`,
        compare: i % 11 === 0, hidden: i % 7 === 0 ? [1] : [], opacity: i % 9 === 0 ? 0.5 : 1, smooth: i % 2 === 0, edges: i % 50 === 0, palette: ['model', 'safe'][i % 2],
        hole: i % 30, orthographic: i % 13 === 0, theme: i % 2 ? 'dark' : 'light',
      });
      for (let i = 0; i < n; ++i) {
        app.settings.set(state(i));
        if (i % 100 === 0) app.stage.draw();
      }
      app.settings.reset();
      app.stage.draw();
      for (let i = 0; i < 3; ++i) {
        window.gc();
        await new Promise((done) => setTimeout(done, 20));
      }
      const { geometries, textures } = app.stage.renderer.info.memory;
      return { heap: performance.memory.usedJSHeapSize, geometries, textures, programs: app.stage.renderer.info.programs.length, elements: document.querySelectorAll('*').length };
    }, count);
  await after(120);
  const first = await after(20);
  const last = await after(1000);
  // What is drawn for the first time is uploaded then: a few more at most.
  assert.ok(last.geometries <= first.geometries + 12, `${first.geometries} geometries became ${last.geometries}`);
  assert.ok(last.programs <= first.programs + 3, `${first.programs} programs became ${last.programs}`);
  assert.equal(last.textures, first.textures);
  assert.equal(last.elements, first.elements);
  assert.ok(last.heap < first.heap * 1.1 + 1e6, `${first.heap} bytes became ${last.heap}`);
  assert.deepEqual(page.said, []);
});

test('on a phone: sheet, tap, drag', async () => {
  const phone = await openPage(browser, place, { phone: true });
  const box = async (selector) => phone.locator(selector).boundingBox();
  const closed = await box('.side');
  await phone.locator('.grip').tap();
  await phone.waitForTimeout(100);
  assert.ok((await box('.side')).height > closed.height + 150);
  await phone.locator('.grip').tap();
  const wide = await phone.evaluate(() => document.documentElement.scrollWidth);
  assert.equal(wide, 390);
  await phone.waitForFunction(() => window.stratareeb.stage.size[1] > 600); // the drawing has grown again
  const middle = await phone.evaluate(() => {
    const app = window.stratareeb;
    app.settings.set({ holes: false });
    app.stage.show('top');
    app.stage.draw();
    return app.project([0, 0, app.model.column(0, 0)[0]]);
  });
  await phone.touchscreen.tap(middle[0], middle[1]);
  await phone.waitForSelector('[data-fact=layer]');
  const before = await phone.evaluate(() => window.stratareeb.stage.cameraState().join());
  const session = await phone.context().newCDPSession(phone);
  const touch = (type, points) => session.send('Input.dispatchTouchEvent', { type, touchPoints: points.map(([x, y], id) => ({ x, y, id })) });
  await touch('touchStart', [[150, 300]]);
  for (let i = 1; i < 6; ++i) await touch('touchMove', [[150 + 15 * i, 300 + 8 * i]]);
  await touch('touchEnd', []);
  const turned = await phone.evaluate(() => window.stratareeb.stage.cameraState());
  assert.notEqual(turned.join(), before);
  await touch('touchStart', [[120, 300], [250, 300]]);
  for (let i = 1; i < 6; ++i) await touch('touchMove', [[120 - 10 * i, 300], [250 + 10 * i, 300]]);
  await touch('touchEnd', []);
  const far = ([x, y, z, a, b, c]) => Math.hypot(x - a, y - b, z - c);
  assert.ok(far(await phone.evaluate(() => window.stratareeb.stage.cameraState())) < 0.9 * far(turned));
  await phone.evaluate(() => window.stratareeb.stage.show('oblique'));
  await phone.screenshot({ path: path.join(pictures, 'phone.png') });
  assert.deepEqual(phone.said, []);
  await phone.context().close();
});

for (const name of ['thesis', 'teapot'])
  test(`opens ${name}`, async (t) => {
    if (!hasTable(name)) return t.skip('its table is not there');
    const other = await openPage(browser, modelFolder(name), { dark: name === 'thesis' });
    assert.deepEqual(other.said, []);
    const wrong = await other.evaluate(() => {
      const app = window.stratareeb;
      app.settings.set({ cut: 'y', cutAt: 0.5, holes: false, frame: false });
      app.stage.show('south');
      const list = [];
      const size = app.box.high[0] - app.box.low[0];
      for (let i = -8; i <= 8; ++i)
        for (let layer = 0; layer < app.units.length; ++layer) {
          const p = window.look.middle(layer, (i / 18) * size, 0, (app.box.high[2] - app.box.low[2]) / 30);
          if (p) list.push(window.look.pixel(...app.project(p).slice(0, 2)) === app.colors[layer]);
        }
      return list;
    });
    assert.ok(wrong.length > 15 && wrong.every((right) => right), JSON.stringify(wrong));
    await other.screenshot({ path: path.join(pictures, `${name}.png`) });
    await other.context().close();
  });
