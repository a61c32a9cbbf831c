// SPDX-License-Identifier: GPL-3.0-or-later
// Models made in code.
import { LayerPlan } from '../../src/layer_plan.js';

/** Numbers from 0 to 1, the same for a seed in every run. */
export function random(seed) {
  let state = seed >>> 0;
  return () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return state / 2 ** 32;
  };
}

/**
 * A square of n × n cells over [0, size]², each two triangles, inner vertices moved a little by `next`; horizons by functions of x, y,
 * ground first.
 */
export function squarePlan(n, size, horizons, next = () => 0.5) {
  const [x, y, corner] = [[], [], []];
  const step = size / n;
  for (let j = 0; j <= n; ++j)
    for (let i = 0; i <= n; ++i) {
      const isInner = i > 0 && i < n && j > 0 && j < n;
      x.push((i + (isInner ? 0.5 * (next() - 0.5) : 0)) * step);
      y.push((j + (isInner ? 0.5 * (next() - 0.5) : 0)) * step);
    }
  const at = (i, j) => j * (n + 1) + i;
  for (let j = 0; j < n; ++j)
    for (let i = 0; i < n; ++i) corner.push(at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j), at(i + 1, j + 1), at(i, j + 1));
  return new LayerPlan({
    corner: Uint32Array.from(corner),
    x: Float64Array.from(x),
    y: Float64Array.from(y),
    horizons: horizons.map((f) => Float64Array.from(x, (_, v) => f(x[v], y[v]))),
  });
}

/** Rough ground, three layers below it of which the middle one is a lens, on a jittered square of side 10. */
export function roughPlan(seed, n = 12) {
  const next = random(seed);
  const [p, q] = [1 + next(), 1 + next()];
  const ground = (x, y) => 5 + Math.sin(p * x) + 0.5 * Math.cos(q * y);
  const first = (x, y) => ground(x, y) - 1 - 0.3 * Math.sin(x * y);
  const lens = (x, y) => Math.max(0, 1.5 - 0.4 * Math.hypot(x - 5, y - 5));
  const second = (x, y) => first(x, y) - lens(x, y);
  const third = (x, y) => Math.min(second(x, y) - 0.5, -1 + 0.2 * x);
  return squarePlan(n, 10, [ground, first, second, third], next);
}
