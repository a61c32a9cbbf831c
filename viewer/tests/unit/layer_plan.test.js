// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import test from 'node:test';
import { roughPlan, squarePlan } from './shapes.js';

/** All triangles of a layer's solid, nine coordinates each, seen from outside. */
export function solidOf(plan, layer) {
  const index = plan.trianglesOf(layer);
  const soup = [];
  for (const [k, order] of [[layer, [0, 1, 2]], [layer + 1, [0, 2, 1]]])
    for (let i = 0; i < index.length; i += 3)
      for (const c of order) soup.push(plan.x[index[i + c]], plan.y[index[i + c]], plan.horizons[k][index[i + c]]);
  return [...soup.map(Math.fround), ...plan.wallsOf(layer)];
}

function unpairedEdges(soup) {
  const count = new Map();
  for (let i = 0; i < soup.length; i += 9)
    for (let k = 0; k < 3; ++k) {
      const at = (c) => soup.slice(i + 3 * c, i + 3 * c + 3).join();
      const [a, b] = [at(k), at((k + 1) % 3)];
      if (a === b) continue; // a rim
      const [key, sign] = a < b ? [`${a}|${b}`, 1] : [`${b}|${a}`, -1];
      count.set(key, (count.get(key) ?? 0) + sign);
    }
  return [...count.values()].filter((n) => n !== 0).length;
}

function volume(soup) {
  let sum = 0;
  for (let i = 0; i < soup.length; i += 9) {
    const [ax, ay, az, bx, by, bz, cx, cy, cz] = soup.slice(i, i + 9);
    sum += ax * (by * cz - bz * cy) + ay * (bz * cx - bx * cz) + az * (bx * cy - by * cx);
  }
  return sum / 6;
}

function prismVolume(plan, layer) {
  let sum = 0;
  for (let t = 0; t < plan.triangles; ++t) {
    const [a, b, c] = [0, 1, 2].map((k) => plan.corner[3 * t + k]);
    const all = (plan.x[b] - plan.x[a]) * (plan.y[c] - plan.y[a]) - (plan.x[c] - plan.x[a]) * (plan.y[b] - plan.y[a]);
    sum += (all / 6) * [a, b, c].reduce((total, v) => total + plan.thickness(layer, v), 0);
  }
  return sum;
}

test('tops, bases and walls make a closed solid of the right volume', () => {
  for (const seed of [1, 2, 3, 4])
    for (const layer of [0, 1, 2]) {
      const plan = roughPlan(seed, 9);
      const soup = solidOf(plan, layer);
      assert.equal(unpairedEdges(soup), 0);
      assert.ok(Math.abs(volume(soup) / prismVolume(plan, layer) - 1) < 1e-5);
    }
});

test('a layer that wedges out on the outline has walls of one triangle there', () => {
  const plan = squarePlan(2, 2, [(x) => x / 2, () => 0]);
  assert.equal(unpairedEdges(solidOf(plan, 0)), 0);
  // two sides of one whole and one half wall's triangles each, a whole side of two walls
  assert.equal(plan.wallsOf(0).length / 9, 2 * (1 + 2) + 4);
});

test('an absent layer has no triangles, and normals of a plane are its own', () => {
  const plan = squarePlan(3, 3, [(x) => 1 + 0.5 * x, () => 0, () => 0]);
  assert.equal(plan.trianglesOf(1).length, 0);
  assert.equal(plan.wallsOf(1).length, 0);
  const normals = plan.normalsOf(0);
  const length = Math.hypot(0.5, 1);
  for (let i = 0; i < normals.length; i += 3) {
    assert.ok(Math.abs(normals[i] / 32767 + 0.5 / length) < 1e-4);
    assert.ok(Math.abs(normals[i + 2] / 32767 - 1 / length) < 1e-4);
  }
});

test('the outline goes once around, the inside to its left', () => {
  const plan = squarePlan(3, 3, [() => 1, () => 0]);
  let area = 0;
  for (let i = 0; i < plan.outline.length; i += 3) {
    const [a, b] = [plan.outline[i], plan.outline[i + 1]];
    area += (plan.x[a] * plan.y[b] - plan.x[b] * plan.y[a]) / 2;
  }
  assert.equal(plan.outline.length / 3, 12);
  assert.ok(Math.abs(area - 9) < 1e-12);
});
