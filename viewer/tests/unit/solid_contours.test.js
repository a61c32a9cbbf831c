// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import test from 'node:test';
import { contoursOfArcs, solidContours } from '../../src/solid_contours.js';
import { roughPlan, squarePlan } from './shapes.js';

/** How many ends of segments stand alone. */
function looseEnds(segments) {
  const count = new Map();
  for (let i = 0; i < segments.length; i += 3) {
    const key = segments.slice(i, i + 3).map((c) => c.toFixed(7)).join();
    count.set(key, (count.get(key) ?? 0) + 1);
  }
  return [...count.values()].filter((n) => n % 2 === 1).length;
}

test('contours of solids are closed', () => {
  let seen = 0;
  for (const seed of [1, 2, 3, 4])
    for (const layer of [0, 1, 2]) {
      const plan = roughPlan(seed);
      for (let level = plan.box.low[2] + 0.1; level < plan.box.high[2]; level += 0.37)
        for (const { segments, triangles } of solidContours(plan, layer, level)) {
          assert.equal(looseEnds(segments), 0);
          assert.equal(segments.length, 6 * triangles.length);
          ++seen;
        }
    }
  assert.ok(seen > 50);
});

test('a slab has one contour as long as its outline, two hills have two', () => {
  const slab = squarePlan(5, 5, [() => 2, () => 0]);
  const [piece, ...others] = solidContours(slab, 0, 1);
  assert.equal(others.length, 0);
  let length = 0;
  for (let i = 0; i < piece.segments.length; i += 6)
    length += Math.hypot(piece.segments[i] - piece.segments[i + 3], piece.segments[i + 1] - piece.segments[i + 4]);
  assert.ok(Math.abs(length - 20) < 1e-9);
  const hills = squarePlan(20, 10, [(x) => 1 + Math.cos((2 * Math.PI * x) / 5), () => -1]);
  assert.equal(solidContours(hills, 0, 1.5).length, 3); // two halves at the sides, one in the middle
});

test('contours belong to the arc that most of their triangles have', () => {
  const pieces = [{ triangles: [0, 1, 2] }, { triangles: [3, 4] }];
  assert.deepEqual(contoursOfArcs(pieces, [7, 7, 1, 1, 1], new Set([7])), [pieces[0]]);
});
