// SPDX-License-Identifier: GPL-3.0-or-later
// A Reeb graph as a flat drawing over an axis of elevations; nodes and arcs can be picked by pointer and keyboard.
import { kNodeColors } from './palette.js';
import { levelsBetween, suitableInterval } from './level_lines.js';

const kWidth = 300;
const kHeight = 360;
const kLeft = 52;
const kMargin = 16;

function svg(tag, attributes, ...children) {
  const element = document.createElementNS('http://www.w3.org/2000/svg', tag);
  for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
  element.append(...children);
  return element;
}

/** Scales of a drawing: x of a column, y of an elevation. */
function scales(graph) {
  const zs = graph.nodes.map(({ at }) => at[2]);
  const [low, high] = [Math.min(...zs), Math.max(...zs)];
  const columns = [...graph.nodes, ...graph.arcs].map(({ column }) => column);
  const [first, last] = [Math.min(...columns), Math.max(...columns)];
  const wide = kWidth - kLeft - 2 * kMargin;
  return {
    low,
    high,
    x: (column) => kLeft + kMargin + (last > first ? ((column - first) / (last - first)) * wide : wide / 2),
    y: (z) => kHeight - kMargin - (high > low ? ((z - low) / (high - low)) * (kHeight - 2 * kMargin) : kHeight / 2 - kMargin),
  };
}

function axis({ low, high, y }, datum) {
  const ticks = levelsBetween(low + datum, high + datum, suitableInterval(low, high) * 2);
  return ticks.flatMap((z) => [
    svg('line', { x1: kLeft, x2: kWidth - 4, y1: y(z - datum), y2: y(z - datum), class: 'tick' }),
    svg('text', { x: kLeft - 6, y: y(z - datum) + 4, class: 'tick-text' }, String(+z.toPrecision(6))),
  ]);
}

function pickable(element, word, label, onPick) {
  element.setAttribute('tabindex', '0');
  element.setAttribute('role', 'button');
  element.setAttribute('aria-label', label);
  element.dataset.picks = word;
  element.append(svg('title', {}, label));
  element.addEventListener('click', () => onPick(word));
  element.addEventListener('keydown', (event) => {
    if (event.key !== 'Enter' && event.key !== ' ') return;
    event.preventDefault();
    event.stopPropagation();
    onPick(word);
  });
  return element;
}

/** All layers together: a lane for each layer, a line across for each level that all are cut at. */
function drawLanes(drawing, graph, { y }, { names, picked, onPick, height, colors }) {
  const lanes = [...new Set(graph.arcs.map(({ layer }) => layer))].sort((a, b) => a - b);
  const wide = kWidth - kLeft - 2 * kMargin;
  const x = (layer) => kLeft + kMargin + (lanes.length > 1 ? (lanes.indexOf(layer) / (lanes.length - 1)) * wide : wide / 2);
  graph.nodes.forEach((node, i) => {
    const word = `n${i}`;
    const level = y(node.at[2]);
    const group = svg('g', { class: picked === word ? 'level picked' : 'level' });
    group.append(svg('path', { d: `M${kLeft + 4} ${level}H${kWidth - 4}`, class: 'line' }), svg('path', { d: `M${kLeft + 4} ${level}H${kWidth - 4}`, class: 'reach' }));
    drawing.append(pickable(group, word, `level ${height(node)}: ${node.layers.map((l) => names[l]).join(', ')}`, onPick));
  });
  graph.arcs.forEach((arc, i) => {
    const [a, b] = [graph.nodes[arc.from], graph.nodes[arc.to]];
    const word = `a${i}`;
    const d = `M${x(arc.layer)} ${y(a.at[2])}V${y(b.at[2])}`;
    const group = svg('g', { class: picked === word ? 'arc picked' : 'arc' });
    group.append(svg('path', { d, stroke: arc.color, class: 'line lane' }), svg('path', { d, class: 'reach' }));
    drawing.append(pickable(group, word, `${names[arc.layer]}: from ${height(a)} to ${height(b)}`, onPick));
  });
  for (const layer of lanes) drawing.append(svg('circle', { cx: x(layer), cy: 6, r: 4.5, fill: colors[layer], class: 'lane-head' }, svg('title', {}, names[layer])));
}

/** The drawing. `datum`: elevation of the frame's z = 0; `names` of the layers; `onPick(word)`. */
export function graphDiagram(graph, { datum, names, colors, unit, picked, onPick }) {
  const scale = scales(graph);
  const { x, y } = scale;
  const drawing = svg('svg', { viewBox: `0 0 ${kWidth} ${kHeight}`, class: 'graph', role: 'group', 'aria-label': 'Reeb graph' });
  drawing.append(...axis(scale, datum));
  const height = (node) => `${(node.at[2] + datum).toFixed(2)} ${unit}`;
  if (graph.layer === null) {
    drawLanes(drawing, graph, scale, { names, picked, onPick, height, colors });
    return drawing;
  }
  graph.arcs.forEach((arc, i) => {
    const [a, b] = [graph.nodes[arc.from], graph.nodes[arc.to]];
    const [x0, y0, x1, y1, xm] = [x(a.column), y(a.at[2]), x(b.column), y(b.at[2]), x(arc.column)];
    const bend = Math.min(18, Math.abs(y1 - y0) / 2);
    const d = `M${x0} ${y0}C${x0} ${y0 - bend / 2} ${xm} ${y0 - bend / 2} ${xm} ${y0 - bend}L${xm} ${y1 + bend}C${xm} ${y1 + bend / 2} ${x1} ${y1 + bend / 2} ${x1} ${y1}`;
    const word = `a${i}`;
    const label = `${names[arc.layer]}: from ${height(a)} to ${height(b)}`;
    const group = svg('g', { class: picked === word ? 'arc picked' : 'arc' });
    group.append(svg('path', { d, stroke: arc.color, class: 'line' }), svg('path', { d, class: 'reach' }));
    drawing.append(pickable(group, word, label, onPick));
  });
  graph.nodes.forEach((node, i) => {
    const word = `n${i}`;
    const circle = svg('circle', {
      cx: x(node.column),
      cy: y(node.at[2]),
      r: 5,
      fill: kNodeColors[node.type] ?? '#ffffff',
      class: picked === word ? 'node picked' : 'node',
    });
    drawing.append(pickable(circle, word, `${node.type} at ${height(node)}`, onPick));
  });
  return drawing;
}
