// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import test from 'node:test';
import { boxByShares, cutFaces, cutNormal, cutOf, isKept, planeNormal, slabRange, spanAlong } from '../../src/cut.js';
import { area, outside } from '../../src/polygon.js';
import { kDefaults } from '../../src/settings.js';
import { random, roughPlan, squarePlan } from './shapes.js';

const near = (a, b, slack = 1e-9) => assert.ok(Math.abs(a - b) <= slack, `${a} instead of ${b}`);

function areas(plan, cut) {
  const sums = new Array(plan.layers).fill(0);
  const all = sums.map((_, i) => i);
  cutFaces(plan, cut, all, (layer, polygon) => (sums[layer] += area(polygon)));
  return sums;
}

/** Volume of each layer that a cut keeps, by the exact rule for prisms where it keeps all, by counting points where it does not. */
function keptVolumes(plan, cut, next, count) {
  const sums = new Array(plan.layers).fill(0);
  const { low, high } = plan.box;
  for (let i = 0; i < count; ++i) {
    const p = low.map((c, k) => c + next() * (high[k] - c));
    if (isKept(cut, p)) {
      const layer = layerAt(plan, p);
      if (layer >= 0) sums[layer] += 1;
    }
  }
  const box = low.reduce((product, c, k) => product * (high[k] - c), 1);
  return sums.map((n) => (n / count) * box);
}

function layerAt(plan, p) {
  for (let t = 0; t < plan.triangles; ++t) {
    const [a, b, c] = [0, 1, 2].map((k) => plan.corner[3 * t + k]);
    const all = (plan.x[b] - plan.x[a]) * (plan.y[c] - plan.y[a]) - (plan.x[c] - plan.x[a]) * (plan.y[b] - plan.y[a]);
    const wb = ((p[0] - plan.x[a]) * (plan.y[c] - plan.y[a]) - (plan.x[c] - plan.x[a]) * (p[1] - plan.y[a])) / all;
    const wc = ((plan.x[b] - plan.x[a]) * (p[1] - plan.y[a]) - (p[0] - plan.x[a]) * (plan.y[b] - plan.y[a])) / all;
    if (Math.min(wb, wc, 1 - wb - wc) < 0) continue;
    const z = plan.horizons.map((h) => (1 - wb - wc) * h[a] + wb * h[b] + wc * h[c]);
    for (let i = 0; i < plan.layers; ++i) if (p[2] <= z[i] && p[2] > z[i + 1]) return i;
    return -1;
  }
  return -1;
}

const slab = squarePlan(4, 8, [() => 3, () => 1, () => 1, () => 0]);

test('a plane through a slab lays bare its length times thickness', () => {
  for (const cut of ['x', 'y']) {
    const sums = areas(slab, cutOf({ ...kDefaults, cut, cutAt: 0.37 }, slab.box));
    near(sums[0], 16);
    near(sums[1], 0);
    near(sums[2], 8);
  }
  const diagonal = areas(slab, cutOf({ ...kDefaults, cut: 'azimuth', azimuth: 45 }, slab.box));
  near(diagonal[0], 16 * Math.SQRT2);
  const level = areas(slab, cutOf({ ...kDefaults, cut: 'z', cutAt: 0.9 }, slab.box));
  near(level[0], 64);
  near(level[2], 0);
});

test('a dipping plane lays bare its area by the cosine of the dip', () => {
  const sums = areas(slab, cutOf({ ...kDefaults, cut: 'azimuth', azimuth: 90, dip: 20, cutAt: 0.5 }, slab.box));
  // over x the plane falls by tan 20°, so it is in the upper layer over 2 / tan 20° of the 8 m, as far as the square reaches
  const n = planeNormal(90, 20);
  const [least, most] = spanAlong(n, slab.box);
  const x = (z) => ((least + most) / 2 - n[2] * z) / n[0];
  const clamp = (v) => Math.min(8, Math.max(0, v));
  near(sums[0], (8 * (clamp(x(1)) - clamp(x(3)))) / Math.cos((20 * Math.PI) / 180), 1e-9);
});

test('a plane through a vertex, along edges and along the outline has each place once', () => {
  for (const cutAt of [0, 0.25, 0.5, 0.75, 1]) {
    const sums = areas(slab, cutOf({ ...kDefaults, cut: 'x', cutAt }, slab.box));
    assert.ok(cutAt === 0 || cutAt === 1 ? sums[0] === 0 || Math.abs(sums[0] - 16) < 1e-9 : Math.abs(sums[0] - 16) < 1e-9, `${cutAt}: ${sums[0]}`);
  }
});

test('the area of a cut is the rate at which volume is cut away', () => {
  // Volumes by sections: the integral of areas along x, y and z is the same volume for every layer.
  for (const seed of [1, 2, 3]) {
    const plan = roughPlan(seed);
    const volumes = ['x', 'y', 'z'].map((cut) => {
      const sums = new Array(plan.layers).fill(0);
      const steps = 150;
      const [least, most] = spanAlong(cutNormal({ cut }), plan.box);
      for (let i = 0; i < steps; ++i)
        areas(plan, cutOf({ ...kDefaults, cut, cutAt: (i + 0.5) / steps }, plan.box)).forEach((a, k) => (sums[k] += (a * (most - least)) / steps));
      return sums;
    });
    for (let k = 0; k < plan.layers; ++k) {
      near(volumes[1][k] / volumes[0][k], 1, 5e-3);
      near(volumes[2][k] / volumes[0][k], 1, 1e-2);
    }
  }
});

test('faces of a block taken out and of the block itself are the same', () => {
  const plan = roughPlan(5);
  const shares = [0.2, 0.7, 0.1, 0.65, 0.3, 0.8];
  const kept = areas(plan, cutOf({ ...kDefaults, block: 'keep', blockShares: shares }, plan.box));
  const taken = areas(plan, cutOf({ ...kDefaults, block: 'remove', blockShares: shares }, plan.box));
  kept.forEach((sum, k) => near(taken[k], sum, 1e-9));
  assert.ok(kept.every((sum) => sum > 0));
});

test('a plane and a block together: their faces meet and do not overlap', () => {
  const plan = roughPlan(6);
  const settings = { ...kDefaults, cut: 'x', cutAt: 0.5, block: 'remove', blockShares: [0, 0.6, 0, 0.5, 0, 1] };
  const whole = areas(plan, cutOf({ ...settings, block: 'off' }, plan.box));
  const both = cutOf(settings, plan.box);
  let onPlane = 0;
  let inBlock = 0;
  cutFaces(plan, both, [0, 1, 2], (layer, polygon) => {
    for (let i = 0; i < polygon.length; i += 4) {
      const p = [polygon[i], polygon[i + 1], polygon[i + 2]];
      const slack = { planes: both.planes.map(({ n, d }) => ({ n, d: d + 1e-9 })), block: both.block.map(({ n, d }) => ({ n, d: d - 1e-9 })) };
      assert.ok(isKept(slack, p), `${p} is cut away`);
    }
    const middle = polygon.filter((_, i) => i % 4 === 0).reduce((a, b) => a + b) / (polygon.length / 4);
    if (Math.abs(middle - 5) < 1e-9) onPlane += area(polygon);
  });
  cutFaces(plan, { planes: [...cutOf({ ...settings, block: 'off' }, plan.box).planes, ...cutOf({ ...settings, cut: 'off', block: 'keep' }, plan.box).planes], block: null }, [0, 1, 2], (layer, polygon) => {
    if (Math.abs(polygon[0] - 5) < 1e-9 && Math.abs(polygon[4] - 5) < 1e-9 && Math.abs(polygon[8] - 5) < 1e-9) inBlock += area(polygon);
  });
  near(onPlane + inBlock, whole[0] + whole[1] + whole[2], 1e-9);
  assert.ok(inBlock > 0 && onPlane > 0);
});

test('slabs part the whole height; a slab keeps its share of the volume', () => {
  const plan = roughPlan(7, 6);
  const [lowest, highest] = [slabRange(plan.box, 19, 20)[0], slabRange(plan.box, 0, 20)[1]];
  near(lowest, plan.box.low[2]);
  near(highest, plan.box.high[2]);
  const whole = keptVolumes(plan, cutOf(kDefaults, plan.box), random(1), 4000);
  const parts = [1, 2, 3].map((slab) => keptVolumes(plan, cutOf({ ...kDefaults, slab, slabs: 3 }, plan.box), random(1), 4000));
  whole.forEach((sum, k) => near(parts[0][k] + parts[1][k] + parts[2][k], sum, 1e-9));
});

test('what is left outside a body is the polygon less what is inside', () => {
  const square = [0, 0, 0, 0, 4, 0, 0, 0, 4, 4, 0, 0, 0, 4, 0, 0];
  const part = boxByShares({ low: [0, 0, -1], high: [4, 4, 1] }, [0.25, 0.5, 0.25, 0.75, 0, 1]);
  assert.deepEqual(part.low, [1, 1, -Infinity]);
  const planes = [{ n: [1, 0, 0], d: -1 }, { n: [-1, 0, 0], d: 2 }, { n: [0, 1, 0], d: -1 }, { n: [0, -1, 0], d: 3 }];
  const sum = outside(square, planes, 2).reduce((total, piece) => total + area(piece), 0);
  near(sum, 14);
});
