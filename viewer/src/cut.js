// SPDX-License-Identifier: GPL-3.0-or-later
// What the settings cut away: half-spaces that are kept, a block that is taken out, and the faces where the inside shows.
import { clippedByPlane, outside } from './polygon.js';

export const kMostPlanes = 9; // one plane, six of a box, two of a slab
const kOnHorizon = 1; // marks of polygon edges
const kOnCut = 2;

/** Unit normal of a plane with this azimuth (degrees clockwise from north, +y) and dip (90: vertical, 0: horizontal). */
export function planeNormal(azimuth, dip) {
  const a = (azimuth * Math.PI) / 180;
  const t = (dip * Math.PI) / 180;
  const exact = (value) => (Math.abs(value) < 1e-12 ? 0 : value);
  return [exact(Math.sin(a) * Math.sin(t)), exact(Math.cos(a) * Math.sin(t)), exact(Math.cos(t))];
}

const kDirections = { x: [90, 90], y: [0, 90], z: [0, 0] };

/** Normal of the plane that the settings ask for. */
export function cutNormal(settings) {
  const [azimuth, dip] = kDirections[settings.cut] ?? [settings.azimuth, settings.dip];
  return planeNormal(azimuth, dip);
}

const dot = (n, p) => n[0] * p[0] + n[1] * p[1] + n[2] * p[2];

/** Lowest and highest n·p over a box. */
export function spanAlong(n, { low, high }) {
  let [least, most] = [0, 0];
  for (let k = 0; k < 3; ++k) {
    least += Math.min(n[k] * low[k], n[k] * high[k]);
    most += Math.max(n[k] * low[k], n[k] * high[k]);
  }
  return [least, most];
}

/** Six planes of a box, kept inside. */
function boxPlanes(low, high) {
  const planes = [];
  for (let k = 0; k < 3; ++k) {
    const n = [0, 0, 0];
    n[k] = 1;
    planes.push({ n, d: -low[k] }, { n: n.map((c) => (c === 0 ? 0 : -c)), d: high[k] });
  }
  return planes;
}

/** A box by shares of a larger one: [x from, x to, y from, …], 0 to 1. At 0 and 1 it has no side. */
export function boxByShares({ low, high }, shares) {
  const at = (k, share) => low[k] + share * (high[k] - low[k]);
  return {
    low: [0, 1, 2].map((k) => (shares[2 * k] <= 0 ? -Infinity : at(k, shares[2 * k]))),
    high: [0, 1, 2].map((k) => (shares[2 * k + 1] >= 1 ? Infinity : at(k, shares[2 * k + 1]))),
  };
}

/** Elevations between which slab i of n lies, counted from the top. */
export function slabRange({ low, high }, i, n) {
  const step = (high[2] - low[2]) / n;
  return [high[2] - (i + 1) * step, high[2] - i * step];
}

/**
 * The cut of a model with this box: { planes: half-spaces whose intersection is kept, block: planes of the body taken out of it, or
 * null }. Planes are { n, d }, n·p + d ≥ 0 on their inside.
 */
export function cutOf(settings, box) {
  const planes = [];
  let block = null;
  if (settings.cut !== 'off') {
    const n = cutNormal(settings);
    const [least, most] = spanAlong(n, box);
    const at = least + settings.cutAt * (most - least);
    // what is above a level plane goes, and what is in front (west, south) of an upright one
    const sign = n[2] > 0.7 === settings.cutFlip ? 1 : -1;
    planes.push({ n: n.map((c) => (c === 0 ? 0 : sign * c)), d: -sign * at });
  }
  if (settings.block !== 'off') {
    const part = boxByShares(box, settings.blockShares);
    const sides = boxPlanes(part.low, part.high).filter(({ d }) => Number.isFinite(d));
    if (settings.block === 'keep') planes.push(...sides);
    else if (sides.length > 0) block = sides;
  }
  if (settings.slab > 0) {
    const [from, to] = slabRange(box, settings.slab - 1, settings.slabs);
    if (settings.slab < settings.slabs) planes.push({ n: [0, 0, 1], d: -from });
    if (settings.slab > 1) planes.push({ n: [0, 0, -1], d: to });
  }
  return { planes, block };
}

/** Whether a place is kept. */
export function isKept(cut, p) {
  const inside = ({ n, d }) => dot(n, p) + d >= 0;
  return cut.planes.every(inside) && !(cut.block && cut.block.every(inside));
}

/** Where a vertical plane crosses a plan triangle: [xa, ya, shares of the corners, …] of two places, or null. */
function crossing(plan, t, side) {
  const ends = [];
  for (let k = 0; k < 3; ++k) {
    const a = plan.corner[3 * t + k];
    const b = plan.corner[3 * t + ((k + 1) % 3)];
    if (side[a] >= 0 === side[b] >= 0) continue;
    ends.push({ a, b, share: side[a] / (side[a] - side[b]) });
  }
  return ends.length === 2 ? ends : null;
}

const between = (values, { a, b, share }) => values[a] + share * (values[b] - values[a]);

/** The face of a vertical plane: a trapezoid for each triangle and layer that it crosses. */
function verticalSections(plan, { n, d }, wanted, emit) {
  const side = new Float64Array(plan.vertices);
  for (let v = 0; v < side.length; ++v) side[v] = n[0] * plan.x[v] + n[1] * plan.y[v] + d;
  for (let t = 0; t < plan.triangles; ++t) {
    const ends = crossing(plan, t, side);
    if (!ends) continue;
    const [p, q] = ends;
    const [px, py, qx, qy] = [between(plan.x, p), between(plan.y, p), between(plan.x, q), between(plan.y, q)];
    for (const layer of wanted) {
      if (!plan.presence[layer][t]) continue;
      const [top, base] = [plan.horizons[layer], plan.horizons[layer + 1]];
      const corners = [
        [px, py, between(top, p), kOnHorizon],
        [qx, qy, between(top, q), 0],
        [qx, qy, between(base, q), kOnHorizon],
        [px, py, between(base, p), 0],
      ];
      emit(layer, corners.flat());
    }
  }
}

/** The face of any other plane. `wanted`: layers, top first. */
function slopingSections(plan, { n, d }, wanted, emit) {
  const { x, y, corner } = plan;
  const height = new Float64Array(plan.vertices); // of the plane
  for (let v = 0; v < height.length; ++v) height[v] = -(n[0] * x[v] + n[1] * y[v] + d) / n[2];
  for (let t = 0; t < plan.triangles; ++t) {
    const [a, b, c] = [corner[3 * t], corner[3 * t + 1], corner[3 * t + 2]];
    for (const layer of wanted) {
      if (!plan.presence[layer][t]) continue;
      const top = plan.horizons[layer];
      if (height[a] > top[a] && height[b] > top[b] && height[c] > top[c]) break; // and above all that is deeper
      const base = plan.horizons[layer + 1];
      if (height[a] < base[a] && height[b] < base[b] && height[c] < base[c]) continue;
      const polygon = sectionOver([a, b, c], x, y, height, top, base);
      if (polygon.length > 0) emit(layer, polygon);
    }
  }
}

/** The part of a triangle over which the plane lies between top and base, at the plane's height. */
function sectionOver(vs, x, y, height, top, base) {
  const polygon = vs.flatMap((v) => [x[v], y[v], height[v], 0]);
  let below = vs.map((v) => top[v] - height[v]);
  let above = vs.map((v) => height[v] - base[v]);
  if (Math.min(...below) >= 0 && Math.min(...above) >= 0) return polygon;
  const first = clippedByValues(polygon, below, above);
  [below, above] = [first.others, first.values];
  return clippedByValues(first.polygon, below, above).polygon;
}

/** The part of a polygon where values, given at its corners, are ≥ 0; other values at the corners are kept along. */
function clippedByValues(polygon, values, others) {
  const result = { polygon: [], values: [], others: [] };
  const count = values.length;
  const put = (i, j, t, mark) => {
    for (let k = 0; k < 3; ++k) result.polygon.push(polygon[4 * i + k] + t * (polygon[4 * j + k] - polygon[4 * i + k]));
    result.polygon.push(mark);
    result.values.push(values[i] + t * (values[j] - values[i]));
    result.others.push(others[i] + t * (others[j] - others[i]));
  };
  for (let j = 0, i = count - 1; j < count; i = j++) {
    if (values[i] >= 0 !== values[j] >= 0)
      put(i, j, values[i] / (values[i] - values[j]), values[i] >= 0 ? kOnHorizon : polygon[4 * i + 3]);
    if (values[j] >= 0) put(j, j, 0, polygon[4 * j + 3]);
  }
  return result.values.length >= 3 ? result : { polygon: [], values: [], others: [] };
}

/** The faces that a cut lays bare: `emit(layer, polygon)` for each convex piece; edges that lie on horizons are marked 1. */
export function cutFaces(plan, cut, wanted, emit) {
  const sections = (plane) => (Math.abs(plane.n[2]) < 1e-9 ? verticalSections : slopingSections);
  cut.planes.forEach((plane, i) => {
    const others = cut.planes.filter((_, k) => k !== i);
    sections(plane)(plan, plane, wanted, (layer, polygon) => {
      let piece = polygon;
      for (const other of others) piece = clippedByPlane(piece, other, kOnCut);
      if (piece.length === 0) return;
      for (const part of cut.block ? outside(piece, cut.block, kOnCut) : [piece]) emit(layer, part);
    });
  });
  (cut.block ?? []).forEach((plane, i) => {
    const others = [...cut.block.filter((_, k) => k !== i), ...cut.planes];
    sections(plane)(plan, plane, wanted, (layer, polygon) => {
      let piece = polygon;
      for (const other of others) piece = clippedByPlane(piece, other, kOnCut);
      if (piece.length > 0) emit(layer, piece);
    });
  });
}
