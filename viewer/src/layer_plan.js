// SPDX-License-Identifier: GPL-3.0-or-later
// Layers over one plan triangulation: which triangles have which layer, and the walls along the outline.

/** Half-edges without a neighbour, by triangle, then by corner: [from, to, triangle, …]. */
function outlineOf(corner, vertices) {
  const first = new Int32Array(vertices).fill(-1); // half-edges by their smaller vertex
  const next = new Int32Array(corner.length);
  const ends = (h) => [corner[h], corner[h % 3 === 2 ? h - 2 : h + 1]];
  const paired = new Uint8Array(corner.length);
  for (let h = 0; h < corner.length; ++h) {
    const [a, b] = ends(h);
    const key = Math.min(a, b);
    let other = first[key];
    for (; other >= 0; other = next[other]) {
      const [c, d] = ends(other);
      if (c === b && d === a) break;
    }
    if (other >= 0) {
      paired[h] = 1;
      paired[other] = 1;
    }
    next[h] = first[key];
    first[key] = h;
  }
  const outline = [];
  for (let h = 0; h < corner.length; ++h) if (!paired[h]) outline.push(...ends(h), Math.floor(h / 3));
  return outline;
}

export class LayerPlan {
  /** Of what readSurfaces gives. */
  constructor({ corner, x, y, horizons }) {
    Object.assign(this, { corner, x, y, horizons });
    this.vertices = x.length;
    this.triangles = corner.length / 3;
    this.layers = horizons.length - 1;
    this.outline = outlineOf(corner, this.vertices);
    this.box = this.#boxOf();
    this.presence = [];
    for (let i = 0; i < this.layers; ++i) this.presence.push(this.#presentIn(i));
  }

  #boxOf() {
    const low = [Infinity, Infinity, Infinity];
    const high = [-Infinity, -Infinity, -Infinity];
    const take = (values, axis) => {
      for (const value of values) {
        if (value < low[axis]) low[axis] = value;
        if (value > high[axis]) high[axis] = value;
      }
    };
    take(this.x, 0);
    take(this.y, 1);
    take(this.horizons[0], 2);
    take(this.horizons[this.layers], 2);
    return { low, high };
  }

  thickness(layer, vertex) {
    return this.horizons[layer][vertex] - this.horizons[layer + 1][vertex];
  }

  /** A layer is in a triangle where a corner has thickness: 1 in the list there. */
  #presentIn(layer) {
    const { corner } = this;
    const top = this.horizons[layer];
    const base = this.horizons[layer + 1];
    const present = new Uint8Array(this.triangles);
    for (let h = 0; h < corner.length; ++h) if (top[corner[h]] > base[corner[h]]) present[Math.floor(h / 3)] = 1;
    return present;
  }

  /** Three vertices for each triangle that has the layer. */
  trianglesOf(layer) {
    const present = this.presence[layer];
    let count = 0;
    for (const p of present) count += p;
    const index = new Uint32Array(3 * count);
    for (let t = 0, at = 0; t < present.length; ++t) {
      if (!present[t]) continue;
      for (let k = 0; k < 3; ++k) index[at++] = this.corner[3 * t + k];
    }
    return index;
  }

  /** A vertex of a layer's base as a number of its own, unless top and base are one there. */
  baseOf(layer, v) {
    return this.thickness(layer, v) === 0 ? v : this.vertices + v;
  }

  /** Walls of a layer, seen from outside, in the order of the program's solids: three vertices a triangle (v: top, or baseOf). */
  #wallIndex(layer) {
    const { outline } = this;
    const top = this.horizons[layer];
    const base = this.horizons[layer + 1];
    const walls = [];
    for (let i = 0; i < outline.length; i += 3) {
      if (!this.presence[layer][outline[i + 2]]) continue;
      const [a, b] = [outline[i], outline[i + 1]];
      const [a0, b0] = [this.baseOf(layer, a), this.baseOf(layer, b)];
      if (a === a0 && b === b0) continue;
      if (a === a0) walls.push(a, b0, b);
      else if (b === b0) walls.push(a0, b, a);
      else if (Math.abs(top[b] - base[a]) <= Math.abs(base[b] - top[a])) walls.push(a0, b0, b, a0, b, a);
      else walls.push(a0, b0, a, a, b0, b);
    }
    return walls;
  }

  /** The walls' coordinates, nine a triangle. */
  wallsOf(layer) {
    const walls = this.#wallIndex(layer);
    const points = new Float32Array(3 * walls.length);
    walls.forEach((id, i) => points.set(this.solidPoint(layer, id), 3 * i));
    return points;
  }

  /** Where a vertex of a layer's solid stands. */
  solidPoint(layer, id) {
    const v = id % this.vertices;
    return [this.x[v], this.y[v], this.horizons[id < this.vertices ? layer : layer + 1][v]];
  }

  /** All triangles of a layer's solid in the program's order: tops, bases, walls; three vertices each. */
  solidIndex(layer) {
    if (this.lastSolid?.layer === layer) return this.lastSolid.index;
    const tops = this.trianglesOf(layer);
    const walls = this.#wallIndex(layer);
    const index = new Uint32Array(2 * tops.length + walls.length);
    index.set(tops);
    tops.forEach((v, i) => (index[tops.length + i] = this.baseOf(layer, v)));
    index.set(walls, 2 * tops.length);
    this.lastSolid = { layer, index };
    return index;
  }

  /** Normals of a horizon, up, averaged over its triangles by their areas; 16 bits a coordinate. */
  normalsOf(k) {
    const { x, y, corner } = this;
    const z = this.horizons[k];
    const sum = new Float32Array(3 * this.vertices);
    for (let i = 0; i < corner.length; i += 3) {
      const [a, b, c] = [corner[i], corner[i + 1], corner[i + 2]];
      const [ux, uy, uz] = [x[b] - x[a], y[b] - y[a], z[b] - z[a]];
      const [vx, vy, vz] = [x[c] - x[a], y[c] - y[a], z[c] - z[a]];
      const n = [uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx];
      for (const v of [a, b, c]) for (let d = 0; d < 3; ++d) sum[3 * v + d] += n[d];
    }
    const normals = new Int16Array(3 * this.vertices);
    for (let i = 0; i < sum.length; i += 3) {
      const length = Math.hypot(sum[i], sum[i + 1], sum[i + 2]) || 1;
      for (let d = 0; d < 3; ++d) normals[i + d] = Math.round((32767 * sum[i + d]) / length);
    }
    return normals;
  }
}
