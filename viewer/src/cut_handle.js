// SPDX-License-Identifier: GPL-3.0-or-later
// The outline of the cutting plane and a handle to drag it by.
import { Group, LineBasicMaterial, LineSegments } from 'three';
import { cutNormal, spanAlong } from './cut.js';
import { GrowingPositions } from './growing_buffers.js';
import { clipped } from './polygon.js';
import { h } from './ui.js';

/** The plane's polygon within a box: [x, y, z, 0, …]. */
export function planeInBox(n, at, { low, high }) {
  const size = 4 * Math.hypot(...low.map((c, k) => high[k] - c)) + 1;
  const side = Math.abs(n[2]) < 0.9 ? [-n[1], n[0], 0] : [1, 0, 0];
  const length = Math.hypot(...side);
  const u = side.map((c) => c / length);
  const v = [n[1] * u[2] - n[2] * u[1], n[2] * u[0] - n[0] * u[2], n[0] * u[1] - n[1] * u[0]];
  const middle = low.map((c, k) => (c + high[k]) / 2);
  const shift = at - n.reduce((sum, c, k) => sum + c * middle[k], 0);
  let polygon = [[-1, -1], [1, -1], [1, 1], [-1, 1]].flatMap(([a, b]) => [
    ...[0, 1, 2].map((k) => middle[k] + shift * n[k] + size * (a * u[k] + b * v[k])),
    0,
  ]);
  for (let k = 0; k < 3; ++k) {
    const margin = 1e-9 * size;
    polygon = clipped(polygon, (...p) => p[k] - low[k] + margin, 0);
    polygon = clipped(polygon, (...p) => high[k] - p[k] + margin, 0);
  }
  return polygon;
}

export class CutHandle {
  constructor(app, place) {
    this.app = app;
    this.root = new Group();
    this.outline = new GrowingPositions();
    this.material = new LineBasicMaterial({ depthTest: false, transparent: true });
    this.lines = new LineSegments(this.outline.geometry, this.material);
    this.lines.frustumCulled = false;
    this.lines.renderOrder = 5;
    this.root.add(this.lines);
    this.knob = h('button', { type: 'button', class: 'knob', title: 'drag the cut', 'aria-label': 'drag the cutting plane' }, '⇔');
    this.knob.addEventListener('pointerdown', (event) => this.#grab(event));
    place.append(this.knob);
  }

  setInk(color) {
    this.material.color.set(color);
  }

  set(settings) {
    this.root.visible = settings.cut !== 'off';
    this.outline.begin();
    this.anchor = null;
    if (this.root.visible) {
      const n = cutNormal(settings);
      const [least, most] = spanAlong(n, this.app.box);
      const polygon = planeInBox(n, least + settings.cutAt * (most - least), this.app.box);
      this.normal = n;
      this.span = most - least;
      for (let i = 0; i < polygon.length; i += 4) {
        const j = (i + 4) % polygon.length;
        this.outline.put(polygon[i], polygon[i + 1], polygon[i + 2]);
        this.outline.put(polygon[j], polygon[j + 1], polygon[j + 2]);
      }
      this.anchor = highestEdge(polygon);
    }
    this.outline.end();
  }

  /** Keep the knob at the plane's upper edge. */
  follow(project) {
    this.knob.hidden = !this.anchor;
    if (!this.anchor) return;
    const [x, y] = project(this.anchor);
    const [ax, ay] = project(this.anchor.map((c, k) => c + this.normal[k] * this.span * 0.01));
    const turn = Math.atan2(ay - y, ax - x);
    this.knob.style.transform = `translate(${x.toFixed(1)}px,${y.toFixed(1)}px) translate(-50%,-50%) rotate(${turn.toFixed(3)}rad)`;
  }

  /** How far the pointer moves on the screen for a whole way through the model. */
  #screenWay() {
    const from = this.app.project(this.anchor);
    const step = 0.02;
    const to = this.app.project(this.anchor.map((c, k) => c + this.normal[k] * this.span * step));
    return [(to[0] - from[0]) / step, (to[1] - from[1]) / step];
  }

  #grab(event) {
    event.preventDefault();
    this.knob.setPointerCapture(event.pointerId);
    const start = [event.clientX, event.clientY];
    const [wx, wy] = this.#screenWay();
    const { settings } = this.app;
    const at = settings.values.cutAt;
    const square = Math.max(wx * wx + wy * wy, 400);
    const move = (moved) => {
      const way = (moved.clientX - start[0]) * wx + (moved.clientY - start[1]) * wy;
      settings.set({ cutAt: Math.min(1, Math.max(0, at + way / square)) });
    };
    const end = () => {
      this.knob.removeEventListener('pointermove', move);
      this.knob.removeEventListener('pointerup', end);
      this.knob.removeEventListener('pointercancel', end);
    };
    this.knob.addEventListener('pointermove', move);
    this.knob.addEventListener('pointerup', end);
    this.knob.addEventListener('pointercancel', end);
  }
}

/** The middle of the edge of a polygon that is highest. */
function highestEdge(polygon) {
  let best = null;
  for (let i = 0; i < polygon.length; i += 4) {
    const j = (i + 4) % polygon.length;
    const middle = [0, 1, 2].map((k) => (polygon[i + k] + polygon[j + k]) / 2);
    const long = Math.hypot(...[0, 1, 2].map((k) => polygon[i + k] - polygon[j + k]));
    const rank = middle[2] + 1e-6 * long;
    if (!best || rank > best.rank) best = { rank, middle };
  }
  return best ? best.middle : null;
}
