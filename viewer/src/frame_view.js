// SPDX-License-Identifier: GPL-3.0-or-later
// A frame around the model with coordinates along its edges.
import { Group, LineBasicMaterial, LineSegments } from 'three';
import { GrowingPositions } from './growing_buffers.js';
import { levelsBetween, roundUp } from './level_lines.js';
import { h } from './ui.js';

const kTicks = 4;
const kCrowd = 44; // pixels between labels

/** Round values along a side, as many as are easily read. */
function ticks(low, high, datum) {
  const interval = roundUp((high - low) / kTicks);
  return levelsBetween(low + datum, high + datum, interval).map((value) => ({ at: value - datum, text: String(+value.toPrecision(9)) }));
}

export class FrameView {
  constructor(place) {
    this.root = new Group();
    this.material = new LineBasicMaterial({ transparent: true, opacity: 0.45 });
    this.lines = new GrowingPositions();
    const object = new LineSegments(this.lines.geometry, this.material);
    object.frustumCulled = false;
    this.root.add(object);
    this.place = place; // element that holds the labels
    this.labels = [];
  }

  setInk(color) {
    this.material.color.set(color);
  }

  /** `box` to frame, `datum` to add for map coordinates. */
  set(box, datum) {
    const { low, high } = box;
    this.marks = [0, 1, 2].map((axis) => ticks(low[axis], high[axis], datum[axis]));
    this.box = box;
    this.lines.begin();
    const corner = (i) => [0, 1, 2].map((k) => ((i >> k) & 1 ? high[k] : low[k]));
    for (const [a, b] of [[0, 1], [1, 3], [3, 2], [2, 0], [0, 4], [1, 5], [2, 6], [3, 7]]) {
      this.lines.put(...corner(a));
      this.lines.put(...corner(b));
    }
    this.lines.end();
    const count = this.marks.reduce((sum, list) => sum + list.length, 0);
    while (this.labels.length < count) {
      this.labels.push(h('span', { class: 'tick-label', 'aria-hidden': 'true' }));
      this.place.append(this.labels.at(-1));
    }
    this.labels.forEach((label, i) => (label.hidden = i >= count));
  }

  /** The edge along an axis that is lowest on the screen (for z: the leftmost), so that labels stand outside. */
  #edge(axis, project) {
    const { low, high } = this.box;
    const others = [0, 1, 2].filter((k) => k !== axis);
    let best = null;
    for (const a of [0, 1])
      for (const b of [0, 1]) {
        if (axis !== 2 && others[1] === 2 && b === 1) continue; // along the bottom
        const p = [0, 0, 0];
        p[others[0]] = a ? high[others[0]] : low[others[0]];
        p[others[1]] = b ? high[others[1]] : low[others[1]];
        p[axis] = (low[axis] + high[axis]) / 2;
        const [x, y] = project(p);
        const rank = axis === 2 ? -x : y;
        if (!best || rank > best.rank) best = { rank, p };
      }
    return best.p;
  }

  /** Put the labels where their ticks are seen. */
  label(project, shown) {
    this.place.hidden = !shown;
    if (!shown || !this.box) return;
    let i = 0;
    for (const axis of [0, 1, 2]) {
      const edge = this.#edge(axis, project);
      const [mx] = project([0, 1, 2].map((k) => (this.box.low[k] + this.box.high[k]) / 2));
      let last = null;
      const ends = [this.box.low, this.box.high].map((corner) => project(edge.map((c, k) => (k === axis ? corner[axis] : c))));
      const isSeen = Math.hypot(ends[0][0] - ends[1][0], ends[0][1] - ends[1][1]) > kCrowd;
      for (const { at, text } of this.marks[axis]) {
        const p = edge.slice();
        p[axis] = at;
        const [x, y, inFront] = project(p);
        const label = this.labels[i++];
        const isFar = !last || Math.hypot(x - last[0], (y - last[1]) * 2.5) > kCrowd;
        label.hidden = !isSeen || !inFront || !isFar;
        if (label.hidden) continue;
        last = [x, y];
        const side = axis === 2 || x < mx ? -1 : 1;
        label.textContent = text;
        label.style.transform = `translate(${x.toFixed(1)}px,${y.toFixed(1)}px) translate(${side < 0 ? '-100%' : '0'}, ${axis === 2 ? '-50%' : '2px'})`;
      }
    }
  }

  /** The labels that are seen, for a picture: { text, x, y }. */
  texts(canvas) {
    const box = canvas.getBoundingClientRect();
    return this.labels
      .filter((label) => !label.hidden)
      .map((label) => {
        const { left, bottom } = label.getBoundingClientRect();
        return { text: label.textContent, x: left - box.left, y: bottom - box.top - 3 };
      });
  }
}
