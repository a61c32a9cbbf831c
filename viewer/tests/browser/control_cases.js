// SPDX-License-Identifier: GPL-3.0-or-later
// Each control changes the picture; keys, addresses, pictures.
import assert from 'node:assert/strict';
import { statSync } from 'node:fs';
import path from 'node:path';
import test from 'node:test';
import { openPage, pictures } from './pages.js';
import { browser, open, page, picture, place, reset, set, values } from './session.js';

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
    slide('slab', 0.3), select('compare', 'straight'),
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
  await page.waitForFunction(() => location.hash === '', null, { polling: 100 }); // until the address has followed
  await page.evaluate((f) => (location.hash = f), fragment);
  await page.waitForFunction(() => window.stratareeb.settings.get('cut') === 'azimuth', null, { polling: 100 });
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

test('what is pulled apart stays in the picture until the reader turns it', async () => {
  await reset();
  const seen = () =>
    page.evaluate(() => {
      const app = window.stratareeb;
      app.stage.draw();
      const { low, high } = app.box;
      const corners = [0, 1, 2, 3].flatMap((i) => [high[2] + app.lift[0], low[2]].map((z) => [i & 1 ? high[0] : low[0], i & 2 ? high[1] : low[1], z]));
      const [width, height] = app.stage.size;
      return corners.map((p) => app.project(p)).every(([x, y]) => x > 0 && y > 0 && x < width && y < height);
    });
  assert.ok(await seen());
  await set({ explode: 1 });
  assert.ok(await seen());
  const turned = await page.evaluate(() => {
    const app = window.stratareeb;
    const { controls } = app.stage;
    controls.dispatchEvent({ type: 'start' });
    const before = app.stage.cameraState().join();
    app.settings.set({ explode: 0.5 });
    return [app.stage.view, before === app.stage.cameraState().join()];
  });
  assert.deepEqual(turned, [null, true]);
  await reset();
});
