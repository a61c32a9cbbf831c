// SPDX-License-Identifier: GPL-3.0-or-later
// Memory, a phone, other models.
import assert from 'node:assert/strict';
import path from 'node:path';
import test from 'node:test';
import { hasTable, modelFolder, openPage, pictures } from './pages.js';
import { browser, page, place, reset } from './session.js';

test('a thousand changes leave nothing behind', async () => {
  await reset();
  const after = (count) =>
    page.evaluate(async (n) => {
      const app = window.stratareeb;
      const state = (i) => ({
        cut: ['off', 'x', 'y', 'z', 'azimuth'][i % 5], cutAt: (i % 17) / 17, block: ['off', 'remove', 'keep'][i % 3], slab: i % 4 === 0 ? i % 20 : 0,
        explode: i % 6 === 0 ? 0.3 : 0, contours: ['off', 'solids', '0', '2'][i % 4], reeb: ['off', '2', '4', 'layered'][i % 4], picked: `a${i % 6}`,
        compare: i % 11 === 0 ? 'straight' : 'off', hidden: i % 7 === 0 ? [1] : [], opacity: i % 9 === 0 ? 0.5 : 1, smooth: i % 2 === 0, edges: i % 50 === 0, palette: ['model', 'safe'][i % 2],
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
  // A log stands below the model, not over it.
  await phone.evaluate(() => window.stratareeb.settings.set({ hole: 10, holes: true }));
  await phone.waitForSelector('.log:not([hidden])');
  const [log, drawing, controls] = [await box('.log'), await box('canvas'), await box('.side')];
  assert.ok(log.y >= drawing.y + drawing.height - 1 && log.y + log.height <= controls.y + 1);
  assert.ok(drawing.height > 300);
  await phone.screenshot({ path: path.join(pictures, 'phone_log.png') });
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
