// SPDX-License-Identifier: GPL-3.0-or-later
// The model of a page in the frame that is drawn: relative to the middle of its box.
import { readGraphs } from './graphs.js';
import { LayerPlan } from './layer_plan.js';
import { readSurfaces, unpack } from './payload.js';
import { PlanGrid, columnAt } from './plan_grid.js';

function shifted({ corner, x, y, horizons }, centre) {
  const minus = (values, c) => values.map((value) => value - c);
  return { corner, x: minus(x, centre[0]), y: minus(y, centre[1]), horizons: horizons.map((z) => minus(z, centre[2])) };
}

function middleOf({ x, y, horizons }) {
  const middle = (...lists) => {
    let [low, high] = [Infinity, -Infinity];
    for (const list of lists)
      for (const value of list) {
        low = Math.min(low, value);
        high = Math.max(high, value);
      }
    return (low + high) / 2;
  };
  return [middle(x), middle(y), middle(horizons[0], horizons.at(-1))];
}

export class Model {
  constructor(header, lists) {
    const surfaces = readSurfaces(lists, header.model);
    const centre = middleOf(surfaces);
    this.title = header.title;
    this.report = header.report;
    this.unit = header.length_unit;
    this.units = header.units;
    this.datum = header.origin.map((c, k) => c + centre[k]); // add it for map coordinates
    this.plan = new LayerPlan(shifted(surfaces, centre));
    const planOf = (said) => (said ? new LayerPlan(shifted(readSurfaces(lists, said), centre)) : null);
    this.others = { unrefined: planOf(header.unrefined), straight: planOf(header.straight) }; // to be shown beside it
    this.holes = header.holes.map((hole) => ({
      ...hole,
      x: hole.x - centre[0],
      y: hole.y - centre[1],
      top: hole.top === null ? null : hole.top - centre[2],
      intervals: hole.intervals.map(([layer, top, base, whole]) => [layer, top - centre[2], base - centre[2], whole]),
    }));
    this.graphs = readGraphs(header, lists, centre);
    this.grid = new PlanGrid(this.plan);
  }

  static async of(base64) {
    const { header, lists } = await unpack(base64);
    return new Model(header, lists);
  }

  /** A line about the model. */
  get facts() {
    const { low, high } = this.plan.box;
    const size = [0, 1].map((k) => grouped(high[k] - low[k], 4)).join(' × ');
    return `${this.holes.length} boreholes, ${this.units.length} layers, ${size} ${this.unit}`;
  }

  isPresent(layer) {
    return this.plan.presence[layer].includes(1);
  }

  /** Elevations (of the frame) of all horizons at a place, or null. */
  column(x, y) {
    return columnAt(this.grid, x, y);
  }

  /** Numbers as they stand on a map, with as many digits as the data's. */
  coordinate(value, axis) {
    return (value + this.datum[axis]).toFixed(axis === 2 ? 2 : 1);
  }
}

/** A number with about `digits` figures and thin spaces between thousands. */
export function grouped(value, digits = 4) {
  const rounded = Number(value.toPrecision(digits));
  const [whole, part] = (Math.abs(rounded) >= 1e15 ? rounded.toExponential(2) : String(rounded)).split('.');
  return whole.replace(/\B(?=(\d{3})+$)/g, '\u2009') + (part ? `.${part}` : '');
}
