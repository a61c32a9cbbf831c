// SPDX-License-Identifier: GPL-3.0-or-later
// What a ray meets first: the layers are solid, so the first place at which it is inside one that is shown and not cut away.
// No triangles are hit: walls, cut faces and surfaces need no cases of their own.

/** The part of [from, to] where value + t·slope ≥ 0, or null. */
function limited(range, value, slope) {
  if (slope === 0) return value >= 0 ? range : null;
  const t = -value / slope;
  const [from, to] = slope > 0 ? [Math.max(range[0], t), range[1]] : [range[0], Math.min(range[1], t)];
  return from <= to ? [from, to] : null;
}

const along = ({ n, d }, o, v) => [n[0] * o[0] + n[1] * o[1] + n[2] * o[2] + d, n[0] * v[0] + n[1] * v[1] + n[2] * v[2]];

function within(planes, origin, direction, range) {
  let left = range;
  for (const plane of planes) {
    if (left) left = limited(left, ...along(plane, origin, direction));
  }
  return left;
}

/** Where a ray may meet something: what the cut leaves of it, one or two ranges. */
function keptRanges(cut, origin, direction, range) {
  const kept = within(cut.planes, origin, direction, range);
  if (!kept) return [];
  const gone = cut.block ? within(cut.block, origin, direction, kept) : null;
  if (!gone) return [kept];
  return [[kept[0], gone[0]], [gone[1], kept[1]]].filter(([from, to]) => to > from);
}

/** The range over a plan triangle, or null. */
function overTriangle(plan, t, origin, direction, range) {
  const { x, y, corner } = plan;
  let left = range;
  for (let k = 0; k < 3 && left; ++k) {
    const [a, b] = [corner[3 * t + k], corner[3 * t + ((k + 1) % 3)]];
    const [ex, ey] = [x[b] - x[a], y[b] - y[a]];
    left = limited(left, ex * (origin[1] - y[a]) - ey * (origin[0] - x[a]), ex * direction[1] - ey * direction[0]);
  }
  return left;
}

/** A horizon over a triangle as a plane: z = value at the origin + t·slope along the ray. */
function alongHorizon(plan, t, z, origin, direction) {
  const { x, y, corner } = plan;
  const [a, b, c] = [corner[3 * t], corner[3 * t + 1], corner[3 * t + 2]];
  const all = (x[b] - x[a]) * (y[c] - y[a]) - (x[c] - x[a]) * (y[b] - y[a]);
  if (all === 0) return [z[a], 0];
  const gx = ((z[b] - z[a]) * (y[c] - y[a]) - (z[c] - z[a]) * (y[b] - y[a])) / all;
  const gy = ((z[c] - z[a]) * (x[b] - x[a]) - (z[b] - z[a]) * (x[c] - x[a])) / all;
  return [z[a] + gx * (origin[0] - x[a]) + gy * (origin[1] - y[a]), gx * direction[0] + gy * direction[1]];
}

/** t from which a box in plan holds the ray, and to which. */
function overPlan({ low, high }, origin, direction) {
  let range = [0, Infinity];
  for (let k = 0; k < 2 && range; ++k) {
    range = limited(range, origin[k] - low[k], direction[k]);
    if (range) range = limited(range, high[k] - origin[k], -direction[k]);
  }
  return range;
}

/**
 * The first layer that a ray meets: { t, layer, point (in the model, not lifted) }, or null.
 * @param layers numbers of those that are shown
 * @param lift of each layer: how far it is drawn above its place
 */
export function firstLayer(grid, cut, layers, lift, origin, direction) {
  const { plan } = grid;
  const whole = overPlan(plan.box, origin, direction);
  if (!whole) return null;
  const lowered = layers.map((layer) => [origin[0], origin[1], origin[2] - lift[layer]]);
  const ranges = lowered.map((from) => keptRanges(cut, from, direction, whole));
  let best = null;
  const enter = (t, i, range) => {
    const layer = layers[i];
    const [top, topSlope] = alongHorizon(plan, t, plan.horizons[layer], lowered[i], direction);
    const [base, baseSlope] = alongHorizon(plan, t, plan.horizons[layer + 1], lowered[i], direction);
    const z = lowered[i][2];
    let inside = limited(range, top - z, topSlope - direction[2]);
    if (inside) inside = limited(inside, z - base, direction[2] - baseSlope);
    if (inside && inside[1] > inside[0] && (!best || inside[0] < best.t)) best = { t: inside[0], layer };
  };
  const visitTriangle = (t) => {
    const over = overTriangle(plan, t, origin, direction, whole);
    if (!over) return;
    for (let i = 0; i < layers.length; ++i) {
      if (!plan.presence[layers[i]][t]) continue;
      for (const [from, to] of ranges[i]) {
        const range = [Math.max(from, over[0]), Math.min(to, over[1])];
        if (range[0] < range[1]) enter(t, i, range);
      }
    }
  };
  const isVertical = direction[0] === 0 && direction[1] === 0;
  if (isVertical) grid.near(origin[0], origin[1], visitTriangle);
  else
    grid.along(origin, direction, whole[0], whole[1], (held, first, end, leave) => {
      for (let i = first; i < end; ++i) visitTriangle(held[i]);
      return best !== null && best.t <= leave;
    });
  if (!best) return null;
  const lifted = origin.map((c, k) => c + best.t * direction[k]);
  return { ...best, point: [lifted[0], lifted[1], lifted[2] - lift[best.layer]], shown: lifted };
}

/**
 * The first interval of a borehole that a ray meets: { t, hole, interval, point, shown }, or null.
 * @param columns [{ hole, interval, layer, x, y, top, base }]
 */
export function firstColumn(columns, radius, cut, lift, origin, direction) {
  let best = null;
  const a = direction[0] ** 2 + direction[1] ** 2;
  for (const column of columns) {
    const [ox, oy] = [origin[0] - column.x, origin[1] - column.y];
    const b = ox * direction[0] + oy * direction[1];
    const inside = b * b - a * (ox * ox + oy * oy - radius * radius);
    if (inside < 0 || a === 0) continue;
    const root = Math.sqrt(inside);
    const lowered = [origin[0], origin[1], origin[2] - lift[column.layer]];
    let range = [Math.max(0, (-b - root) / a), (-b + root) / a];
    range = range[1] < 0 ? null : limited(range, column.top - lowered[2], -direction[2]);
    if (range) range = limited(range, lowered[2] - column.base, direction[2]);
    const kept = range && cut ? keptRanges(cut, lowered, direction, range)[0] : range;
    if (!kept || (best && kept[0] >= best.t)) continue;
    const shown = origin.map((c, k) => c + kept[0] * direction[k]);
    best = { t: kept[0], column, shown, point: [shown[0], shown[1], shown[2] - lift[column.layer]] };
  }
  return best;
}
