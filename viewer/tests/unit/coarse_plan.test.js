// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import test from 'node:test';
import { coarseIndex, representatives } from '../../src/coarse_plan.js';
import { LayerPlan } from '../../src/layer_plan.js';
import { roughPlan } from './shapes.js';

const areaOf = ({ x, y }, index) => {
  let sum = 0;
  for (let i = 0; i < index.length; i += 3) {
    const [a, b, c] = index.slice(i, i + 3);
    sum += ((x[b] - x[a]) * (y[c] - y[a]) - (x[c] - x[a]) * (y[b] - y[a])) / 2;
  }
  return sum;
};

test('a coarse plan has a fraction of the triangles and covers the same area', () => {
  for (let seed = 1; seed <= 20; ++seed) {
    const plan = roughPlan(seed, 60);
    const stands = representatives(plan, 200);
    const coarse = coarseIndex(plan, plan.corner, plan.corner.length, stands);
    assert.ok(coarse.length < 0.3 * plan.corner.length, `${coarse.length} of ${plan.corner.length}`);
    const area = areaOf(plan, coarse); // folds, turned over, count twice
    assert.ok(area > 100 - 1e-9 && area < 105, `${area}`);
  }
});

test('no triangle of a coarse plan is seen from below', () => {
  const plan = roughPlan(3, 60);
  const coarse = coarseIndex(plan, plan.corner, plan.corner.length, representatives(plan, 150));
  for (let i = 0; i < coarse.length; i += 3) assert.ok(areaOf(plan, coarse.slice(i, i + 3)) >= 0);
});

test('vertices on the outline stand for themselves, and each representative for itself', () => {
  const plan = roughPlan(5, 40);
  const stands = representatives(plan, 60);
  for (let i = 0; i < plan.outline.length; i += 3) assert.equal(stands[plan.outline[i]], plan.outline[i]);
  for (const v of stands) assert.equal(stands[v], v);
});

test('pieces of a plan that touch stay apart', () => {
  // Two triangle fans over the same square, as the two sides of a fault that lie close.
  const half = (x0) => ({ x: [x0, x0 + 1, x0 + 1, x0, x0 + 0.5], y: [0, 0, 1, 1, 0.5] });
  const [a, b] = [half(0), half(0.1)];
  const fan = (o) => [o, o + 1, o + 4, o + 1, o + 2, o + 4, o + 2, o + 3, o + 4, o + 3, o, o + 4];
  const x = Float64Array.from([...a.x, ...b.x]);
  const y = Float64Array.from([...a.y, ...b.y]);
  const flat = (z) => new Float64Array(10).fill(z);
  const plan = new LayerPlan({ corner: Uint32Array.from([...fan(0), ...fan(5)]), x, y, horizons: [flat(1), flat(0)] });
  assert.deepEqual([...representatives(plan, 1)], [0, 1, 2, 3, 4, 5, 6, 7, 8, 9]);
});
