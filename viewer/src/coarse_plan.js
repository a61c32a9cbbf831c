// SPDX-License-Identifier: GPL-3.0-or-later
// A plan with fewer triangles, for the time that a model moves: vertices in one cell of a grid become one (J. Rossignac and P. Borrel,
// 1993). Those on the outline stay, so that walls meet the surfaces, and fault blocks stay apart.

/** The number of the connected piece that each vertex of a plan is in. */
function piecesOf({ corner, vertices }) {
  const parent = Int32Array.from({ length: vertices }, (_, v) => v);
  const root = (v) => {
    while (parent[v] !== v) v = parent[v] = parent[parent[v]];
    return v;
  };
  for (let i = 0; i < corner.length; i += 3)
    for (const k of [1, 2]) {
      const [a, b] = [root(corner[i]), root(corner[i + k])];
      parent[Math.max(a, b)] = Math.min(a, b);
    }
  return parent.map((_, v) => root(v));
}

/** For each vertex the one that stands for it when there are about so many cells: that nearest to the cell's middle. */
export function representatives(plan, cells) {
  const { low, high } = plan.box;
  const side = Math.sqrt(((high[0] - low[0]) * (high[1] - low[1])) / cells) || 1;
  const across = Math.ceil((high[0] - low[0]) / side) + 1;
  const down = Math.ceil((high[1] - low[1]) / side) + 1;
  const piece = piecesOf(plan);
  const isKept = new Uint8Array(plan.vertices);
  for (let i = 0; i < plan.outline.length; i += 3) isKept[plan.outline[i]] = isKept[plan.outline[i + 1]] = 1;
  const best = new Map(); // cell -> [vertex, distance from its middle]
  const cellOf = (v) => {
    const i = Math.floor((plan.x[v] - low[0]) / side);
    const j = Math.floor((plan.y[v] - low[1]) / side);
    const far = Math.hypot(plan.x[v] - low[0] - (i + 0.5) * side, plan.y[v] - low[1] - (j + 0.5) * side);
    return [(piece[v] * down + j) * across + i, far];
  };
  for (let v = 0; v < plan.vertices; ++v) {
    if (isKept[v]) continue;
    const [cell, far] = cellOf(v);
    const found = best.get(cell);
    if (!found || far < found[1]) best.set(cell, [v, far]);
  }
  return Uint32Array.from({ length: plan.vertices }, (_, v) => (isKept[v] ? v : best.get(cellOf(v)[0])[0]));
}

/** The first `used` corners of `index` by representatives, without triangles that have become lines, seen from above like the plan's. */
export function coarseIndex({ x, y }, index, used, stands) {
  const coarse = [];
  for (let i = 0; i < used; i += 3) {
    const [a, b, c] = [stands[index[i]], stands[index[i + 1]], stands[index[i + 2]]];
    if (a === b || b === c || c === a) continue;
    const turn = (x[b] - x[a]) * (y[c] - y[a]) - (x[c] - x[a]) * (y[b] - y[a]);
    if (turn >= 0) coarse.push(a, b, c);
    else coarse.push(a, c, b);
  }
  return Uint32Array.from(coarse);
}
