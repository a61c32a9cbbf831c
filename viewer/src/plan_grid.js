// SPDX-License-Identifier: GPL-3.0-or-later
// Finds plan triangles: buckets of equal size, about one a triangle.

export class PlanGrid {
  constructor(plan) {
    this.plan = plan;
    const { low, high } = plan.box;
    this.low = low;
    const size = [high[0] - low[0], high[1] - low[1]];
    this.step = Math.max(Math.sqrt((size[0] * size[1]) / Math.max(plan.triangles, 1)), Math.max(...size) / 2000) || 1;
    this.columns = Math.max(1, Math.ceil(size[0] / this.step));
    this.rows = Math.max(1, Math.ceil(size[1] / this.step));
    this.#fill();
  }

  #column(x) {
    return Math.min(this.columns - 1, Math.max(0, Math.floor((x - this.low[0]) / this.step)));
  }

  #row(y) {
    return Math.min(this.rows - 1, Math.max(0, Math.floor((y - this.low[1]) / this.step)));
  }

  #eachBucket(t, visit) {
    const { x, y, corner } = this.plan;
    const [a, b, c] = [corner[3 * t], corner[3 * t + 1], corner[3 * t + 2]];
    const to = [this.#column(Math.max(x[a], x[b], x[c])), this.#row(Math.max(y[a], y[b], y[c]))];
    const from = [this.#column(Math.min(x[a], x[b], x[c])), this.#row(Math.min(y[a], y[b], y[c]))];
    for (let r = from[1]; r <= to[1]; ++r) for (let k = from[0]; k <= to[0]; ++k) visit(r * this.columns + k);
  }

  #fill() {
    const count = this.plan.triangles;
    this.first = new Uint32Array(this.columns * this.rows + 1);
    for (let t = 0; t < count; ++t) this.#eachBucket(t, (b) => ++this.first[b + 1]);
    for (let b = 1; b < this.first.length; ++b) this.first[b] += this.first[b - 1];
    this.held = new Uint32Array(this.first.at(-1));
    const next = this.first.slice();
    for (let t = 0; t < count; ++t) this.#eachBucket(t, (b) => (this.held[next[b]++] = t));
  }

  /** Calls `visit(triangle)` for the triangles near a place in plan. */
  near(px, py, visit) {
    const b = this.#row(py) * this.columns + this.#column(px);
    for (let i = this.first[b]; i < this.first[b + 1]; ++i) visit(this.held[i]);
  }

  /**
   * Walks along origin + t·direction in plan, t from `from` to `to`, bucket by bucket: `visit(triangles' list, first, end, t at which
   * the walk leaves the bucket)` until it returns true.
   */
  along(origin, direction, from, to, visit) {
    const at = (t) => [origin[0] + t * direction[0], origin[1] + t * direction[1]];
    const [px, py] = at(from);
    let [k, r] = [this.#column(px), this.#row(py)];
    const towards = (axis, cell) => {
      if (direction[axis] === 0) return Infinity;
      const line = this.low[axis] + (cell + (direction[axis] > 0 ? 1 : 0)) * this.step;
      return (line - origin[axis]) / direction[axis];
    };
    while (k >= 0 && k < this.columns && r >= 0 && r < this.rows) {
      const [tx, ty] = [towards(0, k), towards(1, r)];
      const leave = Math.min(tx, ty, to);
      const b = r * this.columns + k;
      if (visit(this.held, this.first[b], this.first[b + 1], leave) || leave >= to) return;
      if (tx <= ty) k += Math.sign(direction[0]);
      else r += Math.sign(direction[1]);
    }
  }
}

/** Weights of a triangle's corners at a place in plan, or null outside. */
export function weightsIn(plan, t, px, py, slack = 1e-9) {
  const { x, y, corner } = plan;
  const [a, b, c] = [corner[3 * t], corner[3 * t + 1], corner[3 * t + 2]];
  const all = (x[b] - x[a]) * (y[c] - y[a]) - (x[c] - x[a]) * (y[b] - y[a]);
  if (all === 0) return null;
  const wb = ((px - x[a]) * (y[c] - y[a]) - (x[c] - x[a]) * (py - y[a])) / all;
  const wc = ((x[b] - x[a]) * (py - y[a]) - (px - x[a]) * (y[b] - y[a])) / all;
  const wa = 1 - wb - wc;
  return Math.min(wa, wb, wc) < -slack ? null : [wa, wb, wc];
}

/** Elevations of all horizons at a place in plan, or null outside the footprint. */
export function columnAt(grid, px, py) {
  const { plan } = grid;
  let column = null;
  grid.near(px, py, (t) => {
    if (column) return;
    const weights = weightsIn(plan, t, px, py);
    if (!weights) return;
    const vs = [0, 1, 2].map((k) => plan.corner[3 * t + k]);
    column = plan.horizons.map((z) => weights[0] * z[vs[0]] + weights[1] * z[vs[1]] + weights[2] * z[vs[2]]);
  });
  return column;
}
