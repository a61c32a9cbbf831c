// SPDX-License-Identifier: GPL-3.0-or-later
// Boreholes as columns: a cylinder for each interval, in its layer's colour, and a dark head above the ground.
import {
  Color,
  CylinderGeometry,
  DoubleSide,
  Group,
  InstancedBufferAttribute,
  InstancedMesh,
  Matrix4,
  MeshLambertMaterial,
} from 'three';

const kSides = 12;
const kFewSides = 5; // beyond so many intervals
const kMany = 20000;
const kHeadColor = '#2b3138';

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

export class HolesView {
  constructor(holes, clip) {
    this.columns = columnsOf(holes);
    this.heads = holes.filter(({ top }) => top !== null);
    this.root = new Group();
    const count = this.columns.length + this.heads.length;
    const geometry = new CylinderGeometry(1, 1, 1, count > kMany ? kFewSides : kSides);
    geometry.rotateX(Math.PI / 2);
    this.lift = new InstancedBufferAttribute(new Float32Array(Math.max(count, 1)), 1);
    geometry.setAttribute('lift', this.lift);
    this.whole = new MeshLambertMaterial();
    this.cut = clip.applyTo(new MeshLambertMaterial({ side: DoubleSide }), true);
    this.mesh = new InstancedMesh(geometry, this.cut, Math.max(count, 1));
    this.mesh.count = count;
    this.mesh.frustumCulled = false;
    this.root.add(this.mesh);
  }

  setColors(colors) {
    const color = new Color();
    this.columns.forEach(({ layer }, i) => this.mesh.setColorAt(i, color.set(colors[layer])));
    color.set(kHeadColor);
    this.heads.forEach((_, i) => this.mesh.setColorAt(this.columns.length + i, color));
    if (this.mesh.instanceColor) this.mesh.instanceColor.needsUpdate = true;
  }

  /** Columns of this radius, lifted with their layers; heads are two radii high as they are seen. */
  place(radius, lift, exaggeration) {
    const matrix = new Matrix4();
    const put = (i, { x, y }, top, base, width, up) => {
      matrix.makeScale(width, width, top - base).setPosition(x, y, (top + base) / 2 + up);
      this.mesh.setMatrixAt(i, matrix);
      this.lift.array[i] = up;
    };
    this.columns.forEach((column, i) => put(i, column, column.top, column.base, radius, lift[column.layer]));
    const high = (2 * radius) / exaggeration;
    this.heads.forEach((hole, i) => put(this.columns.length + i, hole, hole.top + high, hole.top, 0.6 * radius, lift[0]));
    this.mesh.instanceMatrix.needsUpdate = true;
    this.lift.needsUpdate = true;
  }

  setShown(shown, isCut) {
    this.root.visible = shown;
    this.mesh.material = isCut ? this.cut : this.whole;
  }
}
