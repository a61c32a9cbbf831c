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

  /** Walls of a layer, seen from outside: nine coordinates a triangle, in the order of the program's solids. */
  wallsOf(layer) {
    const { x, y, outline } = this;
    const top = this.horizons[layer];
    const base = this.horizons[layer + 1];
    const walls = [];
    const add = (...points) => {
      for (const [v, z] of points) walls.push(x[v], y[v], z);
    };
    for (let i = 0; i < outline.length; i += 3) {
      if (!this.presence[layer][outline[i + 2]]) continue;
      const [a, b] = [outline[i], outline[i + 1]];
      const [up, vp] = [[a, top[a]], [b, top[b]]];
      const [down, vdown] = [[a, base[a]], [b, base[b]]];
      const thinA = top[a] === base[a];
      const thinB = top[b] === base[b];
      if (thinA && thinB) continue;
      if (thinA) add(up, vdown, vp);
      else if (thinB) add(down, vp, up);
      else if (Math.abs(vp[1] - down[1]) <= Math.abs(vdown[1] - up[1])) add(down, vdown, vp, down, vp, up);
      else add(down, vdown, up, up, vdown, vp);
    }
    return new Float32Array(walls);
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
