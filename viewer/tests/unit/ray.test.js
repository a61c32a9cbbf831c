// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import test from 'node:test';
import { cutOf, isKept } from '../../src/cut.js';
import { PlanGrid, columnAt } from '../../src/plan_grid.js';
import { firstColumn, firstLayer } from '../../src/ray.js';
import { kDefaults } from '../../src/settings.js';
import { random, roughPlan, squarePlan } from './shapes.js';

/** The first place inside a shown layer by small steps along the ray. */
function marched(plan, grid, cut, layers, lift, origin, direction, from, to, step) {
  for (let t = from; t <= to; t += step) {
    const p = origin.map((c, k) => c + t * direction[k]);
    const column = columnAt(grid, p[0], p[1]);
    if (!column || p[0] < plan.box.low[0] || p[0] > plan.box.high[0] || p[1] < plan.box.low[1] || p[1] > plan.box.high[1]) continue;
    for (const layer of layers) {
      const z = p[2] - lift[layer];
      if (z < column[layer] && z > column[layer + 1] && isKept(cut, [p[0], p[1], z])) return { t, layer };
    }
  }
  return null;
}

test('a ray meets what small steps along it meet first', () => {
  const step = 0.01;
  let met = 0;
  for (const seed of [1, 2, 3]) {
    const next = random(seed);
    const plan = roughPlan(seed);
    const grid = new PlanGrid(plan);
    const cuts = [
      { ...kDefaults },
      { ...kDefaults, cut: 'x', cutAt: 0.4 },
      { ...kDefaults, cut: 'azimuth', azimuth: 70, dip: 50, block: 'remove' },
      { ...kDefaults, block: 'remove', blockShares: [0.3, 0.6, 0.2, 0.8, 0, 1] },
      { ...kDefaults, slab: 4, slabs: 9 },
    ].map((settings) => cutOf(settings, plan.box));
    for (let i = 0; i < 60; ++i) {
      const cut = cuts[i % cuts.length];
      const lift = i % 2 === 0 ? [0, 0, 0] : [3, 1.5, 0];
      const layers = i % 3 === 0 ? [0, 2] : [0, 1, 2];
      const origin = [25 * next() - 8, -9, 12 * next()];
      const aim = [10 * next(), 10 * next(), 8 * next() - 2];
      const length = Math.hypot(...aim.map((c, k) => c - origin[k]));
      const direction = aim.map((c, k) => (c - origin[k]) / length);
      const found = firstLayer(grid, cut, layers, lift, origin, direction);
      const expected = marched(plan, grid, cut, layers, lift, origin, direction, 0, 40, step);
      if (!expected) {
        // small steps may miss a thin edge
        if (found) {
          const again = marched(plan, grid, cut, layers, lift, origin, direction, found.t, found.t + step, step / 500);
          assert.ok(again, `seed ${seed}, ray ${i}: nothing at ${found.t}`);
        }
        continue;
      }
      ++met;
      assert.ok(found, `seed ${seed}, ray ${i}: missed layer ${expected.layer} at ${expected.t}`);
      assert.ok(found.t <= expected.t + 1e-9 && (found.layer === expected.layer || found.t < expected.t), `seed ${seed}, ray ${i}`);
      if (found.t < expected.t - step) {
        const again = marched(plan, grid, cut, layers, lift, origin, direction, found.t, found.t + step, step / 500);
        assert.equal(again?.layer, found.layer, `seed ${seed}, ray ${i}: ${found.t} before ${expected.t}`);
      }
    }
  }
  assert.ok(met > 100, `only ${met} rays met anything`);
});

test('a ray straight down meets the ground, or what is left below a cut', () => {
  const plan = squarePlan(4, 8, [() => 3, () => 1, () => 0]);
  const grid = new PlanGrid(plan);
  const down = (settings, x) => firstLayer(grid, cutOf({ ...kDefaults, ...settings }, plan.box), [0, 1], [0, 0], [x, 3.3, 100], [0, 0, -1]);
  assert.deepEqual([down({}, 2).layer, down({}, 2).point[2]], [0, 3]);
  const cut = down({ cut: 'z', cutAt: 0.2 }, 2);
  assert.equal(cut.layer, 1);
  assert.ok(Math.abs(cut.point[2] - 0.6) < 1e-12);
  assert.equal(down({}, 9), null);
  assert.equal(down({ cut: 'x', cutAt: 0.5 }, 3.9), null);
  assert.equal(down({ cut: 'x', cutAt: 0.5 }, 4.1).layer, 0);
});

test('a ray meets a borehole at its side and its top', () => {
  const column = { hole: 7, interval: 0, layer: 0, x: 5, y: 5, top: 3, base: 1 };
  const side = firstColumn([column], 0.5, null, [0], [0, 5, 2], [1, 0, 0]);
  assert.ok(Math.abs(side.t - 4.5) < 1e-12);
  assert.equal(firstColumn([column], 0.5, null, [0], [0, 5.6, 2], [1, 0, 0]), null);
  assert.equal(firstColumn([column], 0.5, null, [0], [0, 5, 3.1], [1, 0, 0]), null);
  assert.ok(firstColumn([column], 0.5, null, [1], [0, 5, 3.1], [1, 0, 0]), 'lifted with its layer');
  const slanted = firstColumn([column], 0.5, null, [0], [4.9, 5, 10], [0.001, 0, -1]);
  assert.ok(Math.abs(slanted.point[2] - 3) < 1e-9);
  const cut = cutOf({ ...kDefaults, cut: 'x', cutAt: 0.505 }, { low: [0, 0, 0], high: [10, 10, 10] });
  assert.ok(Math.abs(firstColumn([column], 0.5, cut, [0], [0, 5, 2], [1, 0, 0]).t - 5.05) < 1e-9);
});

test('a place has the column of its triangle', () => {
  const plan = squarePlan(5, 5, [(x, y) => x + 2 * y + 9, (x) => x, () => -1], random(3));
  const grid = new PlanGrid(plan);
  const next = random(4);
  for (let i = 0; i < 200; ++i) {
    const [x, y] = [5 * next(), 5 * next()];
    const column = columnAt(grid, x, y);
    assert.ok(Math.abs(column[0] - (x + 2 * y + 9)) < 1e-9);
    assert.ok(Math.abs(column[1] - x) < 1e-9);
  }
  assert.equal(columnAt(grid, -0.1, 2), null);
});
