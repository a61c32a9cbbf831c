// SPDX-License-Identifier: GPL-3.0-or-later
// Convex polygons in space: [x, y, z, mark, x, y, z, mark, …]. A corner's mark belongs to the edge that starts there.

const kStride = 4;

/** The part where `side(x, y, z)` ≥ 0, a function linear in the place; the new edge gets the mark. */
export function clipped(polygon, side, mark) {
  const result = [];
  const n = polygon.length;
  if (n === 0) return result;
  let last = n - kStride;
  let lastSide = side(polygon[last], polygon[last + 1], polygon[last + 2]);
  for (let i = 0; i < n; i += kStride) {
    const thisSide = side(polygon[i], polygon[i + 1], polygon[i + 2]);
    if (lastSide >= 0 !== thisSide >= 0) {
      const t = lastSide / (lastSide - thisSide);
      // leaving: the new edge runs from here to where the polygon comes back
      result.push(
        polygon[last] + t * (polygon[i] - polygon[last]),
        polygon[last + 1] + t * (polygon[i + 1] - polygon[last + 1]),
        polygon[last + 2] + t * (polygon[i + 2] - polygon[last + 2]),
        lastSide >= 0 ? mark : polygon[last + 3],
      );
    }
    if (thisSide >= 0) result.push(polygon[i], polygon[i + 1], polygon[i + 2], polygon[i + 3]);
    last = i;
    lastSide = thisSide;
  }
  return result.length >= 3 * kStride ? result : [];
}

/** The part on the kept side of a plane { n, d }: n·p + d ≥ 0. */
export function clippedByPlane(polygon, { n, d }, mark) {
  return clipped(polygon, (x, y, z) => n[0] * x + n[1] * y + n[2] * z + d, mark);
}

/** What is left of a polygon outside the convex body where all planes are ≥ 0, in convex pieces. */
export function outside(polygon, planes, mark) {
  const pieces = [];
  let rest = polygon;
  for (const plane of planes) {
    const flipped = { n: plane.n.map((c) => -c), d: -plane.d };
    const piece = clippedByPlane(rest, flipped, mark);
    if (piece.length > 0) pieces.push(piece);
    rest = clippedByPlane(rest, plane, mark);
    if (rest.length === 0) break;
  }
  return pieces;
}

/** Area of a plane polygon. */
export function area(polygon) {
  let [sx, sy, sz] = [0, 0, 0];
  for (let i = kStride; i + kStride < polygon.length; i += kStride) {
    const u = [0, 1, 2].map((k) => polygon[i + k] - polygon[k]);
    const v = [0, 1, 2].map((k) => polygon[i + kStride + k] - polygon[k]);
    sx += u[1] * v[2] - u[2] * v[1];
    sy += u[2] * v[0] - u[0] * v[2];
    sz += u[0] * v[1] - u[1] * v[0];
  }
  return Math.hypot(sx, sy, sz) / 2;
}
