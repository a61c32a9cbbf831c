// SPDX-License-Identifier: GPL-3.0-or-later
// Where layers end, and where surfaces lie in one place, each pixel has one layer's colour: the one that is there.
import assert from 'node:assert/strict';
import path from 'node:path';
import test from 'node:test';
import { modelFolder, openPage, pictures } from './pages.js';
import { browser, page, reset, set } from './session.js';

/**
 * Pixels of triangles at a layer's end (one corner without thickness) in which the layer is the uppermost shown, looked at from this
 * direction: how many, and where the colour's hue is not the layer's.
 */
function rimsWrong(tab, view, settings) {
  return tab.evaluate(([direction, changes]) => {
    const app = window.stratareeb;
    app.settings.set({ holes: false, frame: false, ...changes });
    app.stage.show('top');
    app.stage.camera.position.copy(app.stage.controls.target);
    const radius = 2.2 * app.stage.radius();
    const length = Math.hypot(...direction);
    direction.forEach((c, k) => (app.stage.camera.position[['x', 'y', 'z'][k]] += (c / length) * radius));
    app.stage.controls.update();
    app.stage.draw();
    const gl = app.stage.renderer.getContext();
    const color = (px, py) => {
      const bytes = new Uint8Array(4);
      gl.readPixels(Math.floor(px), gl.drawingBufferHeight - 1 - Math.floor(py), 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
      return [...bytes].slice(0, 3);
    };
    const linear = (c) => (c / 255) ** 2.2;
    const hue = (rgb) => {
      const lin = rgb.map(linear);
      const sum = lin[0] + lin[1] + lin[2] || 1;
      return lin.map((c) => c / sum);
    };
    const own = app.colors.map((hex) => hue([1, 3, 5].map((i) => parseInt(hex.slice(i, i + 2), 16))));
    const { plan } = app.model;
    const shown = app.shownLayers();
    let count = 0;
    const wrong = [];
    for (let t = 0; t < plan.triangles; ++t) {
      const layer = shown.find((i) => plan.presence[i][t]);
      if (layer === undefined) continue;
      const corners = [0, 1, 2].map((k) => plan.corner[3 * t + k]);
      if (!corners.some((v) => plan.thickness(layer, v) === 0)) continue;
      const at = (values) => corners.reduce((sum, v) => sum + values[v] / 3, 0);
      const p = [at(plan.x), at(plan.y), at(plan.horizons[layer])];
      const [px, py] = app.project([p[0], p[1], p[2] + app.lift[layer]]);
      if (px < 2 || py < 2 || px > app.stage.size[0] - 2 || py > app.stage.size[1] - 2) continue;
      const found = app.pointer.at(px, py);
      if (found?.layer !== layer || Math.hypot(...p.map((c, k) => c - found.point[k])) > 0.02 * app.stage.radius()) continue; // hidden
      const pixels = [-1, 0, 1].flatMap((dx) => [-1, 0, 1].map((dy) => [Math.floor(px) + 0.5 + dx, Math.floor(py) + 0.5 + dy]));
      if (pixels.some(([x, y]) => app.pointer.at(x, y)?.layer !== layer)) continue; // another layer is near
      ++count;
      const seen = hue(color(px, py));
      const off = seen.reduce((sum, c, k) => sum + Math.abs(c - own[layer][k]), 0);
      if (off > 0.16) wrong.push([t, layer, off]);
    }
    return { count, wrong };
  }, [view, settings]);
}

const kLow = [-0.8, -1, 0.25];
const kHigh = [0.3, -0.4, 1];

test('layers end without a flicker: whole, one hidden, seen from two sides', async () => {
  for (const view of [kLow, kHigh])
    for (const settings of [{}, { hidden: [0] }, { hidden: [0, 2] }, { explode: 0.15, hidden: [] }]) {
      await reset();
      const { count, wrong } = await rimsWrong(page, view, settings);
      assert.ok(count > 20, `${JSON.stringify(settings)}: ${count} places`);
      assert.deepEqual(wrong, [], JSON.stringify([view, settings]));
    }
});

test('no pixel of the ground changes its layer when the eye moves a little', async () => {
  await reset();
  await set({ holes: false, frame: false, palette: 'safe' });
  const changed = await page.evaluate(() => {
    const app = window.stratareeb;
    const layers = [];
    for (const shift of [0, 1e-4, 2e-4]) {
      app.stage.show('oblique');
      app.stage.camera.position.x += shift * app.stage.radius();
      app.stage.controls.update();
      app.stage.draw();
      const gl = app.stage.renderer.getContext();
      const [w, h] = [gl.drawingBufferWidth, gl.drawingBufferHeight];
      const bytes = new Uint8Array(4 * w * h);
      gl.readPixels(0, 0, w, h, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
      layers.push(bytes);
    }
    let [seen, off] = [0, 0];
    for (let i = 0; i < layers[0].length; i += 4) {
      if (layers[0][i] === layers[0][0] && layers[0][i + 1] === layers[0][1]) continue;
      ++seen;
      const far = (a, b) => Math.abs(a[i] - b[i]) + Math.abs(a[i + 1] - b[i + 1]) + Math.abs(a[i + 2] - b[i + 2]);
      if (far(layers[0], layers[1]) > 80 || far(layers[1], layers[2]) > 80) ++off;
    }
    return off / seen;
  });
  assert.ok(changed < 0.002, `${changed} of the pixels`);
});

test('a model with faults: steps, blocks and a cut along its outline', async () => {
  const tab = await openPage(browser, modelFolder('graben'));
  const { whole, cut, steps } = await tab.evaluate(() => {
    const app = window.stratareeb;
    app.settings.set({ holes: false, frame: false });
    app.stage.show('west');
    const first = window.look.picture();
    app.settings.set({ cut: 'x', cutAt: 0 }); // along the western wall, of which nothing goes
    app.handle.root.visible = false;
    const second = window.look.picture();
    app.settings.set({ cut: 'off' });
    // Where the base of the loam jumps across a fault, both sides are told apart by the pointer's column.
    const list = [];
    for (let x = -590; x < 590; x += 10) {
      const column = app.model.column(x, -100);
      if (column) list.push(column[0] - column[1]);
    }
    const jumps = list.filter((c, i) => i > 0 && Math.abs(c - list[i - 1]) > 5).length;
    return { whole: first, cut: second, steps: jumps };
  });
  assert.equal(cut, whole);
  assert.equal(steps, 2, 'the loam is thicker between the two faults');
  const wrong = await tab.evaluate(() => {
    const app = window.stratareeb;
    app.settings.set({ cut: 'y', cutAt: 0.5 });
    app.stage.show('south');
    const list = [];
    for (let i = -14; i <= 14; ++i)
      for (let layer = 0; layer < app.units.length; ++layer) {
        const p = window.look.middle(layer, i * 41, 0, 2);
        if (p) list.push(window.look.pixel(...app.project(p).slice(0, 2)) === app.colors[layer]);
      }
    return list;
  });
  assert.ok(wrong.length > 80 && wrong.every((right) => right), JSON.stringify(wrong));
  await tab.evaluate(() => {
    window.stratareeb.settings.set({ explode: 0.2, cutAt: 0.4 });
    window.stratareeb.stage.show('oblique');
  });
  await tab.screenshot({ path: path.join(pictures, 'faults.png') });
  assert.deepEqual(tab.said, []);
  await tab.context().close();
});

test('the surfaces before refinement stand beside the refined ones', async () => {
  const tab = await openPage(browser, modelFolder('refined'), { fragment: '#compare=unrefined&cut=y' });
  const said = await tab.evaluate(() => {
    const app = window.stratareeb;
    const [left, right] = app.halves;
    return {
      comparable: app.comparable,
      ratio: right.grid.plan.triangles / left.grid.plan.triangles,
      title: document.querySelector('.halves span').textContent,
      split: app.stage.split,
      cut: left.view.layers.some(({ faces }) => faces.vertices > 0),
    };
  });
  assert.deepEqual(said, { comparable: ['unrefined', 'straight'], ratio: 4, title: 'before refinement', split: true, cut: true });
  await tab.screenshot({ path: path.join(pictures, 'unrefined.png') });
  assert.deepEqual(tab.said, []);
  await tab.context().close();
});
