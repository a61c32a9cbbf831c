// SPDX-License-Identifier: GPL-3.0-or-later
// Words and numbers for what is shown.
import { slabRange } from './cut.js';
import { pickedIn } from './graphs.js';
import { grouped } from './model.js';
import { columnAt } from './plan_grid.js';

/** What may stand beside the model. */
export const kOthers = {
  unrefined: { title: 'before refinement', note: 'Left: the predicted surfaces that refinement began with, in the triangles of its control mesh.' },
  straight: { title: 'straight between boreholes', note: 'Left: the boreholes’ triangles with the model’s elevations at the holes.' },
};

/** A unit's volume, with a power of ten where it is large. */
export function volumeText(app, { volume }) {
  if (volume === undefined) return '';
  const power = volume >= 1e6 ? 3 * Math.floor(Math.log10(volume) / 3) : 0;
  const digits = { 6: '⁶', 9: '⁹', 12: '¹²', 15: '¹⁵' }[power];
  return `${grouped(volume / 10 ** power, 3)}${digits ? `·10${digits}` : ''} ${app.lengthUnit}³`;
}

/** Which slab is shown, and where it lies. */
export function slabText(app, values) {
  if (values.slab === 0) return 'all depths';
  const [from, to] = slabRange(app.box, Math.min(values.slab, values.slabs) - 1, values.slabs);
  return `slab ${values.slab} of ${values.slabs}, z ${app.model.coordinate(from, 2)} to ${app.model.coordinate(to, 2)} ${app.lengthUnit}`;
}

/** A graph in numbers, and what is picked of it. */
export function graphText(app, graph, picked) {
  const counts = `${graph.nodes.length} nodes, ${graph.arcs.length} arcs${graph.layer === null ? '' : `, ${graph.loops} loops`}`;
  const share = graph.share > 0 ? `, without what rises less than ${+(100 * graph.share).toFixed(1)} % of the height` : '';
  const found = pickedIn(graph, picked);
  if (!found) return `${counts}${share}. Pick a node or an arc.`;
  const z = (node) => `${app.model.coordinate(graph.nodes[node].at[2], 2)} ${app.lengthUnit}`;
  if (found.node !== undefined) return `${graph.nodes[found.node].type === 'level' ? 'Level' : graph.nodes[found.node].type} at ${z(found.node)}. ${counts}${share}.`;
  const arc = graph.arcs[found.arc];
  return `${app.units[arc.layer].name}: arc from ${z(arc.from)} to ${z(arc.to)}. ${counts}${share}.`;
}

/** An interval of a borehole: its layer, elevations and depths. */
export function holeLabel(app, { hole, layer, top, base, whole }) {
  const z = (value) => app.model.coordinate(value, 2);
  const { id, top: ground } = app.holes[hole];
  const depth = ground === null ? '' : `, depth ${(ground - top).toFixed(2)}–${(ground - base).toFixed(2)}`;
  return `${id}: ${app.units[layer].name}, z ${z(top)} to ${whole ? '' : 'below '}${z(base)}${depth} ${app.lengthUnit}`;
}

/** Words for what the pointer is over: [[what, text], …]. */
export function wordsFor(app, found) {
  if (!found) return [];
  const { point, layer } = found;
  const at = [0, 1, 2].map((axis) => [['x', 'y', 'z'][axis], app.model.coordinate(point[axis], axis)]);
  if (found.kind === 'hole') return [['hole', holeLabel(app, found.column)], ...at];
  const column = columnAt((app.halves[found.half] ?? app.halves[1]).grid, point[0], point[1]);
  const facts = column
    ? [['thickness', `${(column[layer] - column[layer + 1]).toFixed(2)} ${app.lengthUnit}`], ['depth', `${Math.max(0, column[0] - point[2]).toFixed(2)} ${app.lengthUnit}`]]
    : [];
  return [['layer', app.units[layer].name], ...at, ...facts];
}
