// SPDX-License-Identifier: GPL-3.0-or-later
// What is under the pointer, and what it picks, drags and measures.
import assert from 'node:assert/strict';
import test from 'node:test';
import { run } from './pages.js';
import { keep, open, page, picture, place, reset, set, values } from './session.js';

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
  await page.waitForSelector('.log h2');
  assert.equal(await page.locator('.log h2').first().textContent(), 'GBH04');
  const rows = await page.locator('.log tbody tr').allTextContents();
  assert.deepEqual(rows, ['topsoil0.000.70', 'made_ground0.706.40', 'clay6.4010.00', 'rock10.00>11.20']);
  await page.waitForSelector('.hole-tag:not([hidden])'); // with the next frame
  assert.equal(await page.locator('.hole-tag').textContent(), 'GBH04');
  await keep('log');
  await page.keyboard.press('Escape');
  assert.equal(await page.locator('.log').isVisible(), false);
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
  await set({ compare: 'straight', cut: 'y' });
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
