// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import test from 'node:test';
import { levelLine, levelLineOfSoup, levelsBetween, roundUp, suitableInterval } from '../../src/level_lines.js';
import { random, squarePlan } from './shapes.js';

function length(plan, level) {
  const z = plan.horizons[0];
  let sum = 0;
  levelLine({ x: plan.x, y: plan.y, z }, z, plan.corner, level, (ax, ay, az, bx, by, bz) => {
    assert.ok(Math.abs(az - level) < 1e-12 && Math.abs(bz - level) < 1e-12);
    sum += Math.hypot(ax - bx, ay - by);
  });
  return sum;
}

test('contours of a plane are as long as the square is wide', () => {
  const plan = squarePlan(7, 4, [(x) => x, () => -1], random(2));
  for (const level of [0.1, 1, 2.5, 3.99]) assert.ok(Math.abs(length(plan, level) - 4) < 1e-9);
  assert.equal(length(plan, 4.1), 0);
});

test('contours of a cone are circles', () => {
  const plan = squarePlan(120, 2, [(x, y) => -Math.hypot(x - 1, y - 1), () => -9]);
  assert.ok(Math.abs(length(plan, -0.6) / (2 * Math.PI * 0.6) - 1) < 2e-3);
});

test('a level at vertices is drawn once, all along', () => {
  const plan = squarePlan(4, 4, [(x) => x, () => -1]);
  assert.ok(Math.abs(length(plan, 2) - 4) < 1e-12);
});

test('triangles by coordinates have the same lines', () => {
  let count = 0;
  levelLineOfSoup([0, 0, 0, 1, 0, 0, 0, 1, 1, 0, 0, 5, 1, 0, 5, 0, 1, 6], 0.5, () => ++count);
  assert.equal(count, 1);
});

test('levels are round', () => {
  assert.equal(roundUp(0.3), 0.5);
  assert.equal(roundUp(20), 20);
  assert.equal(roundUp(2.1), 5);
  assert.equal(suitableInterval(0, 60), 5);
  assert.deepEqual(levelsBetween(-1, 1, 0.5), [-1, -0.5, 0, 0.5, 1]);
  assert.equal(levelsBetween(0, 1e9, 1).length, 400);
});
