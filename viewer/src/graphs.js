// SPDX-License-Identifier: GPL-3.0-or-later
// Reeb graphs as the page draws them, layers' own and the layered one in one form:
// { layer (or null), share, loops, nodes: [{ at, type, column, layers }], arcs: [{ from, to, column, color, layer, curve }], arcOf }.
import { kArcColors } from './palette.js';
import { readRuns } from './payload.js';

/** Colours so that arcs that share a node differ where there are enough. */
function arcColors(arcs) {
  const used = new Map();
  return arcs.map(({ from, to }, i) => {
    const taken = new Set([...(used.get(from) ?? []), ...(used.get(to) ?? [])]);
    let k = i % kArcColors.length;
    for (let tries = 0; taken.has(k) && tries < kArcColors.length; ++tries) k = (k + 1) % kArcColors.length;
    for (const node of [from, to]) used.set(node, [...(used.get(node) ?? []), k]);
    return kArcColors[k];
  });
}

const moved = (p, centre) => p.map((c, k) => c - centre[k]);

function layerGraph(graph, lists, centre) {
  const colors = arcColors(graph.arcs);
  return {
    layer: graph.layer,
    share: graph.share,
    loops: graph.loops,
    nodes: graph.nodes.map(({ at, type, column }) => ({ at: moved(at, centre), type, column, layers: [graph.layer] })),
    arcs: graph.arcs.map((arc, i) => ({
      from: arc.from,
      to: arc.to,
      column: arc.column,
      layer: graph.layer,
      color: colors[i],
      curve: arc.curve.map((p) => moved(p, centre)),
    })),
    arcOf: readRuns(lists, graph.runs),
  };
}

/** Nodes one above the other; an arc has a lane for its layer, unless it leads to the next node. */
function layeredGraph(graph, colors, centre) {
  const nodes = graph.nodes.map(({ z, center, layers }) => ({
    at: moved([center[0], center[1], z], centre),
    type: 'level',
    column: 0,
    layers,
  }));
  const arcs = graph.arcs.map(({ from, to, layer }) => ({
    from,
    to,
    layer,
    column: layer + 1,
    color: colors[layer],
    curve: [nodes[from].at, nodes[to].at],
  }));
  return { layer: null, share: graph.share, loops: 0, nodes, arcs, arcOf: null };
}

/** All graphs of a page: { layered, layers: by layer (null where a layer is absent) }. */
export function readGraphs(header, lists, centre) {
  const layers = header.units.map(() => null);
  for (const graph of header.graphs.layers) layers[graph.layer] = layerGraph(graph, lists, centre);
  return { layers, layered: (colors) => layeredGraph(header.graphs.layered, colors, centre) };
}

/** What a picked word ("n3", "a12") names in a graph: { node } or { arc }, or null. */
export function pickedIn(graph, word) {
  const number = Number(word.slice(1));
  if (word.startsWith('n') && graph.nodes[number]) return { node: number };
  if (word.startsWith('a') && graph.arcs[number]) return { arc: number };
  return null;
}
