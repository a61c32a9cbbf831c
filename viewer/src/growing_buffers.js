// SPDX-License-Identifier: GPL-3.0-or-later
// Geometry that is filled anew again and again, in buffers that grow but are not made anew.
import { BufferAttribute, BufferGeometry, DynamicDrawUsage } from 'three';

const kFirstCapacity = 3 * 512;

/** Positions of a geometry, filled by begin(), put()… and end(). */
export class GrowingPositions {
  constructor() {
    this.geometry = new BufferGeometry();
    this.#reserve(kFirstCapacity);
    this.begin();
    this.end();
  }

  #reserve(floats) {
    const attribute = new BufferAttribute(new Float32Array(floats), 3);
    attribute.setUsage(DynamicDrawUsage);
    if (this.array) attribute.array.set(this.array);
    this.geometry.dispose(); // frees the old buffer on the graphics card
    this.geometry.setAttribute('position', attribute);
    this.array = attribute.array;
  }

  begin() {
    this.used = 0;
  }

  put(x, y, z) {
    if (this.used + 3 > this.array.length) this.#reserve(2 * this.array.length);
    this.array[this.used++] = x;
    this.array[this.used++] = y;
    this.array[this.used++] = z;
  }

  end() {
    const attribute = this.geometry.getAttribute('position');
    attribute.clearUpdateRanges();
    if (this.used > 0) attribute.addUpdateRange(0, this.used);
    attribute.needsUpdate = true;
    this.geometry.setDrawRange(0, this.used / 3);
  }

  get vertices() {
    return this.used / 3;
  }

  dispose() {
    this.geometry.dispose();
  }
}

/** A convex polygon of x, y, z, mark as triangles, and its edges marked 1 as lines. */
export function putPolygon(triangles, lines, polygon) {
  const n = polygon.length / 4;
  const corner = (buffer, i) => buffer.put(polygon[4 * i], polygon[4 * i + 1], polygon[4 * i + 2]);
  for (let i = 1; i + 1 < n; ++i) {
    corner(triangles, 0);
    corner(triangles, i);
    corner(triangles, i + 1);
  }
  for (let i = 0; i < n; ++i) {
    if (polygon[4 * i + 3] !== 1) continue;
    corner(lines, i);
    corner(lines, (i + 1) % n);
  }
}
