// SPDX-License-Identifier: GPL-3.0-or-later
// A borehole's log: what it drilled through, and beside it what the model has at its place.
import { h } from './ui.js';

function strip(intervals, top, size, colors, names, className) {
  const place = h('div', { class: `strip ${className}` });
  for (const [layer, from, to, whole] of intervals) {
    const box = h('div', { class: whole ? 'interval' : 'interval open', title: `${names[layer]}: ${(from - to).toFixed(2)}` });
    box.style.cssText = `top:${(100 * (top - from)) / size}%;height:${(100 * (from - to)) / size}%;background:${colors[layer]}`;
    place.append(box);
  }
  return place;
}

function modelIntervals(column) {
  return column.slice(1).flatMap((base, layer) => (column[layer] > base ? [[layer, column[layer], base, 1]] : []));
}

/** Rows of a table: layer, from and to as depths, thickness. */
function table(intervals, top, colors, names, unit) {
  const depth = (z) => (top - z).toFixed(2);
  const rows = intervals.map(([layer, from, to, whole]) => {
    const swatch = h('span', { class: 'swatch' });
    swatch.style.background = colors[layer];
    return h('tr', {}, h('td', {}, swatch, names[layer]), h('td', {}, depth(from)), h('td', {}, whole ? depth(to) : `>${depth(to)}`));
  });
  return h('table', {}, h('thead', {}, h('tr', {}, h('th', {}, 'layer'), h('th', {}, `from [${unit}]`), h('th', {}, 'to'))), h('tbody', {}, ...rows));
}

/** The card's content for a hole of the model. */
export function holeLog(model, hole, colors) {
  const names = model.units.map(({ name }) => name);
  const column = model.column(hole.x, hole.y);
  const drilled = hole.intervals;
  const ends = [...drilled.flatMap(([, top, base]) => [top, base]), ...(column ? [column[0], column.at(-1)] : [])];
  const place = h('p', { class: 'note' }, `x ${model.coordinate(hole.x, 0)}  y ${model.coordinate(hole.y, 1)}${hole.top === null ? '' : `  ground ${model.coordinate(hole.top, 2)} ${model.unit}`}`);
  if (ends.length === 0) return [h('h2', {}, hole.id), place, h('p', { class: 'note' }, 'The hole says nothing of any layer.')];
  const [top, base] = [Math.max(...ends), Math.min(...ends)];
  const size = top - base || 1;
  const strips = h('div', { class: 'strips' },
    h('figure', {}, strip(drilled, top, size, colors, names, 'drilled'), h('figcaption', {}, 'drilled')),
    column ? h('figure', {}, strip(modelIntervals(column), top, size, colors, names, 'model'), h('figcaption', {}, 'model')) : null,
    table(drilled, hole.top ?? top, colors, names, model.unit));
  return [h('h2', {}, hole.id), place, strips];
}
