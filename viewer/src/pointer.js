// SPDX-License-Identifier: GPL-3.0-or-later
// What the pointer is over, what a click or tap picks, and measuring.
import { BufferAttribute, BufferGeometry, Group, LineBasicMaterial, LineSegments } from 'three';
import { firstColumn, firstLayer } from './ray.js';
import { h } from './ui.js';
import { holeLabel } from './words.js';

const kReach = 6; // pixels around the head of a borehole that mean it
const kTouchReach = 16;
const kClick = 6; // pixels that a pointer may move between down and up

export class Pointer {
  constructor(app, stage, place) {
    this.app = app;
    this.stage = stage;
    this.measuring = false;
    this.ends = [];
    this.root = new Group();
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(new Float32Array(6), 3));
    this.line = new LineSegments(geometry, new LineBasicMaterial({ depthTest: false, transparent: true }));
    this.line.frustumCulled = false;
    this.line.renderOrder = 20;
    this.line.visible = false;
    this.root.add(this.line);
    this.label = h('div', { class: 'measure', hidden: true, role: 'status' });
    this.tip = h('div', { class: 'tip', hidden: true, 'aria-hidden': 'true' });
    place.append(this.label, this.tip);
    this.#listen(stage.canvas);
  }

  #listen(canvas) {
    canvas.addEventListener('pointerdown', (event) => {
      this.down = [event.clientX, event.clientY];
      this.tip.hidden = true;
    });
    canvas.addEventListener('pointermove', (event) => {
      if (event.buttons !== 0 || event.pointerType === 'touch') return;
      this.over = this.#place(event);
      this.#askSoon();
    });
    canvas.addEventListener('pointerleave', (event) => {
      if (event.pointerType === 'touch') return; // what was tapped stays told
      this.over = null;
      this.#askSoon();
    });
    canvas.addEventListener('pointerup', (event) => {
      const moved = this.down ? Math.hypot(event.clientX - this.down[0], event.clientY - this.down[1]) : Infinity;
      this.down = null;
      if (moved <= kClick && event.button === 0) this.#click(this.#place(event), event.pointerType === 'touch');
    });
  }

  #place(event) {
    const box = this.stage.canvas.getBoundingClientRect();
    return [event.clientX - box.left, event.clientY - box.top];
  }

  #askSoon() {
    if (this.asked) return;
    this.asked = requestAnimationFrame(() => {
      this.asked = 0;
      this.#hover();
    });
  }

  /** What is meant at a place on the canvas: what is seen there, or the head of a borehole close by. */
  near(px, py, reach) {
    const found = this.at(px, py);
    if (found?.kind === 'hole' || !this.app.settings.values.holes) return found;
    let best = null;
    for (const hole of this.app.holesView.heads) {
      const [x, y, isInFront] = this.stage.project([hole.x, hole.y, hole.top + this.app.lift[0]]);
      const far = Math.hypot(x - px, y - py);
      if (isInFront && far <= (best?.far ?? reach)) best = { far, x, y };
    }
    const head = best ? this.at(best.x, best.y) : null;
    return head?.kind === 'hole' ? head : found;
  }

  /** What is seen at a place on the canvas: { kind: 'layer' | 'hole', layer, point, shown, column }, or null. */
  at(px, py) {
    const { origin, direction, half } = this.stage.ray(px, py);
    const { settings, lift, cut } = this.app;
    const shown = this.app.shownLayers();
    const part = this.app.halves[half] ?? this.app.halves[1];
    const layer = firstLayer(part.grid, cut, shown, lift, origin, direction);
    const holes = this.app.holesView;
    const column = settings.values.holes
      ? firstColumn(holes.columns, this.app.holeRadius(), settings.values.holesCut ? cut : null, lift, origin, direction)
      : null;
    if (column && (!layer || column.t <= layer.t || this.app.isSeeThrough(layer.layer)))
      return { kind: 'hole', layer: column.column.layer, column: column.column, point: column.point, shown: column.shown, half };
    return layer ? { kind: 'layer', half, ...layer } : null;
  }

  #hover() {
    const found = this.over ? this.near(...this.over, kReach) : null;
    this.app.tell(found);
    this.tip.hidden = found?.kind !== 'hole';
    if (!this.tip.hidden) {
      this.tip.textContent = holeLabel(this.app, found.column);
      this.tip.style.transform = `translate(${this.over[0] + 14}px,${this.over[1] + 10}px)`;
    }
    this.stage.canvas.style.cursor = this.measuring ? 'crosshair' : found?.kind === 'hole' ? 'pointer' : 'default';
  }

  #click(place, byTouch) {
    const found = this.near(...place, byTouch ? kTouchReach : kReach);
    if (byTouch) this.app.tell(found);
    if (this.measuring) {
      if (found) this.#addEnd(found);
      return;
    }
    const graph = this.app.graphView.near(...place, (p) => this.stage.project(p), this.app.lift, byTouch ? 18 : 9);
    if (graph) {
      this.app.settings.set({ picked: graph.node !== undefined ? `n${graph.node}` : `a${graph.arc}` });
    } else if (found?.kind === 'hole') {
      this.app.settings.set({ hole: found.column.hole });
    }
  }

  setMeasuring(measuring) {
    this.measuring = measuring;
    this.ends = [];
    this.#drawMeasure();
  }

  #addEnd(found) {
    if (this.ends.length === 2) this.ends = [];
    this.ends.push(found);
    this.#drawMeasure();
  }

  #drawMeasure() {
    const [a, b] = this.ends;
    this.line.visible = this.ends.length === 2;
    this.label.hidden = this.ends.length === 0;
    if (b) {
      const position = this.line.geometry.getAttribute('position');
      position.array.set([...a.shown, ...b.shown]);
      position.needsUpdate = true;
      this.label.textContent = this.#distanceText(a.point, b.point);
    } else if (a) {
      this.label.textContent = 'Pick the other end';
    }
    this.stage.request();
  }

  #distanceText(a, b) {
    const [dx, dy, dz] = [0, 1, 2].map((k) => b[k] - a[k]);
    const flat = Math.hypot(dx, dy);
    const azimuth = ((Math.atan2(dx, dy) * 180) / Math.PI + 360) % 360;
    const slope = (Math.atan2(dz, flat) * 180) / Math.PI;
    const u = this.app.lengthUnit;
    return `${Math.hypot(flat, dz).toFixed(2)} ${u}   (in plan ${flat.toFixed(2)}, up ${dz.toFixed(2)}; azimuth ${azimuth.toFixed(1)}°, slope ${slope.toFixed(1)}°)`;
  }

  /** Keep the label at the line's middle. */
  follow(project) {
    const [a, b] = this.ends;
    if (!a) return;
    const middle = b ? a.shown.map((c, k) => (c + b.shown[k]) / 2) : a.shown;
    const [x, y] = project(middle, a.half);
    this.label.style.transform = `translate(${x.toFixed(1)}px,${y.toFixed(1)}px) translate(-50%,-150%)`;
  }
}
