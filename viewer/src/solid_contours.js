// SPDX-License-Identifier: GPL-3.0-or-later
// Contours of a layer's solid at a level, piece by piece.

function find(parent, i) {
  while (parent[i] !== i) {
    parent[i] = parent[parent[i]];
    i = parent[i];
  }
  return i;
}

/**
 * Connected pieces of the level set of a layer's solid: [{ segments: [ax, ay, az, bx, by, bz, …], triangles: numbers of the triangles
 * crossed }]. A vertex at the level counts as above it.
 */
export function solidContours(plan, layer, level) {
  const index = plan.solidIndex(layer);
  const height = (id) => plan.horizons[id < plan.vertices ? layer : layer + 1][id % plan.vertices];
  const crossed = []; // triangles
  const segments = [];
  const parent = [];
  const byEdge = new Map(); // the first triangle that crosses an edge
  for (let t = 0; t < index.length; t += 3) {
    const isAbove = [0, 1, 2].map((k) => height(index[t + k]) >= level);
    if (isAbove[0] === isAbove[1] && isAbove[1] === isAbove[2]) continue;
    const own = crossed.length;
    crossed.push(t / 3);
    parent.push(own);
    for (let k = 0; k < 3; ++k) {
      if (isAbove[k] === isAbove[(k + 1) % 3]) continue;
      const [a, b] = [index[t + k], index[t + ((k + 1) % 3)]].sort((i, j) => i - j);
      const s = (level - height(a)) / (height(b) - height(a));
      const [p, q] = [plan.solidPoint(layer, a), plan.solidPoint(layer, b)];
      segments.push(p[0] + s * (q[0] - p[0]), p[1] + s * (q[1] - p[1]), level);
      const key = a * 2 * plan.vertices + b;
      const other = byEdge.get(key);
      if (other === undefined) byEdge.set(key, own);
      else parent[find(parent, own)] = find(parent, other);
    }
  }
  const pieces = new Map();
  crossed.forEach((triangle, i) => {
    const root = find(parent, i);
    if (!pieces.has(root)) pieces.set(root, { segments: [], triangles: [] });
    const piece = pieces.get(root);
    piece.triangles.push(triangle);
    for (let k = 0; k < 6; ++k) piece.segments.push(segments[6 * i + k]);
  });
  return [...pieces.values()];
}

/** Those pieces of which more triangles belong to the wanted arcs than to any others. */
export function contoursOfArcs(pieces, arcOf, wanted) {
  return pieces.filter(({ triangles }) => {
    let votes = 0;
    for (const t of triangles) votes += wanted.has(arcOf[t]) ? 1 : -1;
    return votes > 0;
  });
}
