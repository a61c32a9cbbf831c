// SPDX-License-Identifier: GPL-3.0-or-later
// Lines of equal elevation over the layers.
import { Group, LineBasicMaterial, LineSegments } from 'three';
import { GrowingPositions } from './growing_buffers.js';
import { levelLine, levelLineOfSoup, levelsBetween, suitableInterval } from './level_lines.js';

/** Elevations (with `datum` added) that the settings ask for, without it again. */
export function contourLevels(settings, low, high, datum) {
  if (settings.level !== '' && Number.isFinite(Number(settings.level))) return [Number(settings.level) - datum];
  const interval = settings.interval > 0 ? settings.interval : suitableInterval(low, high);
  return levelsBetween(low + datum, high + datum, interval).map((z) => z - datum);
}

/** Pieces of a solid's line at a level: its top, its base and its walls. */
export function solidLine(plan, layer, index, walls, level, emit) {
  for (const k of [layer, layer + 1]) {
    const z = plan.horizons[k];
    levelLine({ x: plan.x, y: plan.y, z }, z, index, level, emit);
  }
  levelLineOfSoup(walls, level, emit);
}

export class ContoursView {
  constructor(layersView, clip) {
    this.view = layersView;
    this.root = new Group();
    this.material = clip.applyTo(new LineBasicMaterial({ transparent: true, opacity: 0.8 }));
    this.lines = layersView.layers.map(() => new GrowingPositions());
    this.objects = this.lines.map((positions) => {
      const object = new LineSegments(positions.geometry, this.material);
      object.frustumCulled = false;
      this.root.add(object);
      return object;
    });
  }

  setInk(color) {
    this.material.color.set(color);
  }

  /** Fill the lines: over all solids, or over one horizon (then they move with the layer below it). */
  set(settings, datum) {
    const { plan, layers } = this.view;
    this.lines.forEach((positions) => positions.begin());
    if (settings.contours === 'solids') this.#overSolids(settings, datum);
    else if (settings.contours !== 'off') {
      const k = Math.min(Number(settings.contours) || 0, plan.layers);
      const z = plan.horizons[k];
      const positions = this.lines[Math.min(k, plan.layers - 1)];
      const index = k === 0 ? plan.corner : layers[k - 1].index;
      const [low, high] = rangeOver(z, index);
      for (const level of contourLevels(settings, low, high, datum))
        levelLine({ x: plan.x, y: plan.y, z }, z, index, level, (...p) => put(positions, p));
    }
    this.lines.forEach((positions) => positions.end());
  }

  #overSolids(settings, datum) {
    const { plan, layers } = this.view;
    const levels = contourLevels(settings, plan.box.low[2], plan.box.high[2], datum);
    layers.forEach(({ index, walls }, layer) => {
      const [low, high] = [rangeOver(plan.horizons[layer + 1], index)[0], rangeOver(plan.horizons[layer], index)[1]];
      for (const level of levels)
        if (level > low && level <= high) solidLine(plan, layer, index, walls, level, (...p) => put(this.lines[layer], p));
    });
  }

  /** Where lines are seen: with their layers, unless they belong to a horizon. */
  place(settings, lift, isShown) {
    const solids = settings.contours === 'solids';
    this.objects.forEach((object, i) => {
      object.position.z = lift[i];
      object.visible = this.lines[i].vertices > 0 && (!solids || isShown(i));
    });
  }
}

function put(positions, p) {
  positions.put(p[0], p[1], p[2]);
  positions.put(p[3], p[4], p[5]);
}

function rangeOver(z, index) {
  let [low, high] = [Infinity, -Infinity];
  for (const v of index) {
    if (z[v] < low) low = z[v];
    if (z[v] > high) high = z[v];
  }
  return [low, high];
}
