// SPDX-License-Identifier: GPL-3.0-or-later
// Boreholes as columns: a prism for each interval, in its layer's colour, and a dark head above the ground. All prisms are one mesh.
import {
  BufferAttribute,
  BufferGeometry,
  Color,
  DoubleSide,
  Group,
  LineBasicMaterial,
  LineSegments,
  Mesh,
  MeshLambertMaterial,
} from 'three';

const kSides = [ // of a prism, where there are no more prisms than that
  { sides: 12, most: 1000 },
  { sides: 6, most: 4000 },
  { sides: 3, most: Infinity },
];
const kHeadColor = '#2b3138';
const kHeadWidth = 0.6; // of a column's

/** One entry for each interval: { hole, interval, layer, x, y, top, base, whole }. */
export function columnsOf(holes) {
  return holes.flatMap((hole, h) =>
    hole.intervals.map(([layer, top, base, whole], interval) => ({ hole: h, interval, layer, x: hole.x, y: hole.y, top, base, whole })),
  );
}

/** A radius at which neighbouring holes stay apart and a lonely one is seen. */
export function suitableRadius(holes, { low, high }) {
  const area = (high[0] - low[0]) * (high[1] - low[1]);
  const size = Math.max(high[0] - low[0], high[1] - low[1]);
  return Math.min(0.05 * Math.sqrt(area / Math.max(holes.length, 1)), 0.006 * size);
}

/** Vertices of a unit prism [x, y, z, normal…] and its triangles: a side ring, then top and base rings. */
function prism(sides) {
  const vertices = [];
  const index = [];
  const ring = (z, normal) => {
    for (let i = 0; i < sides; ++i) {
      const a = (2 * Math.PI * i) / sides;
      vertices.push([Math.cos(a), Math.sin(a), z, ...(normal ?? [Math.cos(a), Math.sin(a), 0])]);
    }
  };
  ring(0, null);
  ring(1, null);
  ring(1, [0, 0, 1]);
  ring(0, [0, 0, -1]);
  for (let i = 0; i < sides; ++i) {
    const j = (i + 1) % sides;
    index.push(i, j, sides + j, i, sides + j, sides + i);
  }
  for (let i = 1; i + 1 < sides; ++i) index.push(2 * sides, 2 * sides + i, 2 * sides + i + 1, 3 * sides, 3 * sides + i + 1, 3 * sides + i);
  return { vertices, index };
}

export class HolesView {
  constructor(holes, clip) {
    this.columns = columnsOf(holes);
    this.heads = holes.filter(({ top }) => top !== null);
    const count = this.columns.length + this.heads.length;
    this.prism = prism(kSides.find(({ most }) => count <= most).sides);
    this.geometry = this.#makeGeometry(count);
    this.whole = new MeshLambertMaterial({ vertexColors: true });
    this.cut = clip.applyTo(new MeshLambertMaterial({ vertexColors: true, side: DoubleSide }), true);
    this.mesh = new Mesh(this.geometry, this.cut);
    this.mesh.frustumCulled = false;
    this.mesh.renderOrder = 0.5; // after the solids, which hide most of it
    this.clip = clip;
    this.root = new Group();
    this.lines = this.#makeLines(count);
    this.root.add(this.mesh, this.lines);
  }

  /** A line along each prism, for the time that a large model moves. */
  #makeLines(count) {
    const geometry = new BufferGeometry();
    for (const [name, size] of [['position', 3], ['color', 3], ['lift', 1]])
      geometry.setAttribute(name, new BufferAttribute(new Float32Array(2 * size * count), size));
    const lines = new LineSegments(geometry, this.clip.applyTo(new LineBasicMaterial({ vertexColors: true }), true));
    lines.frustumCulled = false;
    lines.renderOrder = this.mesh.renderOrder;
    lines.visible = false;
    return lines;
  }

  setCoarse(wanted) {
    this.lines.visible = wanted;
    this.mesh.visible = !wanted;
  }

  #makeGeometry(count) {
    const { vertices, index } = this.prism;
    const n = vertices.length;
    const geometry = new BufferGeometry();
    const add = (name, array, size, isNormalized = false) => geometry.setAttribute(name, new BufferAttribute(array, size, isNormalized));
    const normal = new Float32Array(3 * n * count);
    const triangles = new Uint32Array(index.length * count);
    const normals = vertices.flatMap((v) => v.slice(3));
    for (let i = 0; i < count; ++i) {
      normal.set(normals, 3 * n * i);
      for (let k = 0; k < index.length; ++k) triangles[index.length * i + k] = n * i + index[k];
    }
    add('normal', normal, 3);
    add('position', new Float32Array(3 * n * count), 3);
    add('color', new Float32Array(3 * n * count), 3);
    add('lift', new Float32Array(n * count), 1);
    geometry.setIndex(new BufferAttribute(triangles, 1));
    return geometry;
  }

  setColors(colors) {
    const n = this.prism.vertices.length;
    const attribute = this.geometry.getAttribute('color');
    const lines = this.lines.geometry.getAttribute('color');
    const paint = (i, color) => {
      for (let k = 0; k < n; ++k) color.toArray(attribute.array, 3 * (n * i + k));
      for (const k of [0, 1]) color.toArray(lines.array, 3 * (2 * i + k));
    };
    const of = colors.map((color) => new Color(color));
    this.columns.forEach(({ layer }, i) => paint(i, of[layer]));
    this.heads.forEach((_, i) => paint(this.columns.length + i, new Color(kHeadColor)));
    attribute.needsUpdate = true;
    lines.needsUpdate = true;
  }

  /** Columns of this radius, lifted with their layers; heads are two radii high as they are seen. */
  place(radius, lift, exaggeration) {
    const position = this.geometry.getAttribute('position');
    const lifts = this.geometry.getAttribute('lift');
    const { vertices } = this.prism;
    const n = vertices.length;
    const line = this.lines.geometry.attributes;
    const put = (i, { x, y }, top, base, width, up) => {
      line.position.array.set([x, y, base + up, x, y, top + up], 6 * i);
      line.lift.array.fill(up, 2 * i, 2 * i + 2);
      for (let k = 0, at = 3 * n * i; k < n; ++k, at += 3) {
        position.array[at] = x + width * vertices[k][0];
        position.array[at + 1] = y + width * vertices[k][1];
        position.array[at + 2] = base + (top - base) * vertices[k][2] + up;
      }
      lifts.array.fill(up, n * i, n * (i + 1));
    };
    this.columns.forEach((column, i) => put(i, column, column.top, column.base, radius, lift[column.layer]));
    const high = (2 * radius) / exaggeration;
    this.heads.forEach((hole, i) => put(this.columns.length + i, hole, hole.top + high, hole.top, kHeadWidth * radius, lift[0]));
    for (const attribute of [position, lifts, line.position, line.lift]) attribute.needsUpdate = true;
  }

  setShown(shown, isCut) {
    this.root.visible = shown;
    this.mesh.material = isCut && this.clip.isCutting ? this.cut : this.whole;
  }
}
