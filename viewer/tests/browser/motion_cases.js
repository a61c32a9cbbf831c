// SPDX-License-Identifier: GPL-3.0-or-later
// While the model moves too slowly less is drawn, and all of it when it rests.
import assert from 'node:assert/strict';
import test from 'node:test';
import { browser, page, picture, place, reset } from './session.js';
import { openPage } from './pages.js';

const drawn = () =>
  page.evaluate(() => {
    const { pace, renderer } = window.stratareeb.stage;
    const { triangles, calls } = renderer.info.render;
    return { level: pace.level, coarse: pace.applied.coarse, ratio: renderer.getPixelRatio(), triangles, calls };
  });
const dragTo = async (x, y) => {
  const frames = await page.evaluate(() => window.stratareeb.stage.frames);
  await page.mouse.move(x, y);
  await page.waitForFunction((n) => window.stratareeb.stage.frames > n && !window.stratareeb.stage.pace.busy, frames);
};

test('less is drawn while turning is slow, all at rest', async () => {
  await reset();
  const start = await picture();
  const whole = await drawn();
  await page.evaluate(() => (window.stratareeb.stage.pace.slow = 0)); // every frame is too slow
  await page.mouse.move(300, 300);
  await page.mouse.down();
  for (let i = 1; i <= 9; ++i) await dragTo(300 + 6 * i, 300);
  await dragTo(300, 300);
  const moving = await drawn();
  await page.mouse.up();
  await page.waitForFunction(() => !window.stratareeb.stage.pace.moving);
  await page.waitForFunction((n) => window.stratareeb.stage.renderer.info.render.triangles === n, whole.triangles);
  const still = await drawn();
  assert.ok(moving.coarse && moving.ratio === 0.5, JSON.stringify(moving));
  assert.ok(moving.triangles < 0.7 * whole.triangles, `${moving.triangles} of ${whole.triangles}`);
  assert.deepEqual([still.coarse, still.ratio, still.triangles, still.calls], [false, 1, whole.triangles, whole.calls]);
  await page.evaluate(() => {
    window.stratareeb.stage.show('oblique');
    Object.assign(window.stratareeb.stage.pace, { slow: 40, level: 0 });
  });
  assert.equal(await picture(), start);
  assert.deepEqual(page.said, []);
});

test('few calls draw the model, and a frame costs the page little', async (t) => {
  await reset();
  const { calls, layers, script } = await page.evaluate(() => {
    const app = window.stratareeb;
    app.stage.draw();
    const begun = performance.now();
    for (let i = 0; i < 5; ++i) app.stage.draw();
    return { calls: app.stage.renderer.info.render.calls, layers: app.units.length, script: (performance.now() - begun) / 5 };
  });
  t.diagnostic(`${calls} calls, ${script.toFixed(1)} ms of script a frame`);
  assert.ok(calls <= 5 * layers + 6, `${calls} calls`); // top, base, walls, faces of a cut and their lines; boreholes, frame
});

test('coarse surfaces look like the whole ones', async () => {
  await reset();
  const share = await page.evaluate(() => {
    const app = window.stratareeb;
    const gl = app.stage.renderer.getContext();
    const read = () => {
      const bytes = new Uint8Array(4 * gl.drawingBufferWidth * gl.drawingBufferHeight);
      gl.readPixels(0, 0, gl.drawingBufferWidth, gl.drawingBufferHeight, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
      return bytes;
    };
    app.settings.set({ holes: false });
    app.stage.draw();
    const whole = read();
    app.layersView.setCoarse(true);
    app.stage.draw();
    const coarse = read();
    app.layersView.setCoarse(false);
    let [seen, off] = [0, 0];
    for (let i = 0; i < whole.length; i += 4) {
      if (whole[i] === whole[0] && whole[i + 1] === whole[1] && whole[i + 2] === whole[2]) continue;
      ++seen;
      if (Math.abs(whole[i] - coarse[i]) + Math.abs(whole[i + 1] - coarse[i + 1]) + Math.abs(whole[i + 2] - coarse[i + 2]) > 60) ++off;
    }
    return off / seen;
  });
  assert.ok(share < 0.05, `${share} of the pixels differ`);
});

test('a newcomer has a cut and a log after a key and a click', async (t) => {
  const begun = Date.now();
  const tab = await openPage(browser, place);
  assert.match(await tab.locator('.status').textContent(), /X cuts.*click a borehole/);
  await tab.keyboard.press('x');
  await tab.waitForSelector('.knob:not([hidden])');
  const target = await tab.evaluate(() => {
    const app = window.stratareeb;
    const list = app.holes.map(({ x, y, top }) => (top === null ? [0, 0, false] : app.project([x, y, top])));
    const i = list.findIndex(([x, y, isInFront]) => isInFront && app.pointer.near(x, y, 4)?.kind === 'hole');
    return { at: list[i], id: app.holes[app.pointer.near(list[i][0], list[i][1], 4).column.hole].id };
  });
  await tab.mouse.click(target.at[0] + 3, target.at[1] + 3); // nobody hits it exactly
  await tab.waitForSelector('.log h2');
  assert.equal(await tab.locator('.log h2').first().textContent(), target.id);
  assert.ok((await tab.locator('.log tbody tr').count()) > 0);
  const colors = await tab.evaluate(() => {
    const app = window.stratareeb;
    return app.layersView.layers.filter(({ faces }) => faces.vertices > 0).length;
  });
  assert.ok(colors >= 3, 'the cut shows layers');
  t.diagnostic(`${((Date.now() - begun) / 1000).toFixed(1)} s from opening the page to the log`);
  await tab.screenshot({ path: 'pictures/newcomer.png' });
  assert.deepEqual(tab.said, []);
  await tab.context().close();
});
