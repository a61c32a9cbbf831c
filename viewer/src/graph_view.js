// SPDX-License-Identifier: GPL-3.0-or-later
// A Reeb graph drawn in the model, and what is picked of it: its part of the surface and its contours.
import { BufferAttribute, BufferGeometry, CanvasTexture, Color, DoubleSide, Group, LineSegments, LineBasicMaterial, Mesh, MeshLambertMaterial, Points, PointsMaterial } from 'three';
import { LineMaterial } from 'three/addons/lines/LineMaterial.js';
import { LineSegments2 } from 'three/addons/lines/LineSegments2.js';
import { LineSegmentsGeometry } from 'three/addons/lines/LineSegmentsGeometry.js';
import { GrowingPositions } from './growing_buffers.js';
import { kNodeColors } from './palette.js';
import { clipped } from './polygon.js';
import { contoursOfArcs, solidContours } from './solid_contours.js';

const kContoursOfArc = 7;
const kOnTop = 10; // drawn after everything else

function drawn(paint) {
  const canvas = document.createElement('canvas');
  canvas.width = canvas.height = 64;
  paint(canvas.getContext('2d'));
  return new CanvasTexture(canvas);
}

const disc = () => drawn((pen) => {
  pen.beginPath();
  pen.arc(32, 32, 26, 0, 2 * Math.PI);
  pen.fillStyle = '#fff';
  pen.fill();
  pen.lineWidth = 6;
  pen.strokeStyle = '#222';
  pen.stroke();
});

const ring = () => drawn((pen) => {
  pen.beginPath();
  pen.arc(32, 32, 25, 0, 2 * Math.PI);
  pen.lineWidth = 9;
  pen.strokeStyle = '#fff';
  pen.stroke();
});

/** Triangles of a layer's solid by their numbers: nine coordinates each. */
function solidSoup({ plan }, layer, wanted) {
  const index = plan.solidIndex(layer);
  const soup = [];
  for (let t = 0; t < index.length / 3; ++t) {
    if (!wanted(t)) continue;
    for (let c = 0; c < 3; ++c) soup.push(...plan.solidPoint(layer, index[3 * t + c]));
  }
  return soup;
}

/** The part of triangles between two elevations. */
function between(soup, low, high) {
  const part = [];
  for (let i = 0; i < soup.length; i += 9) {
    let polygon = [];
    for (let k = 0; k < 9; k += 3) polygon.push(soup[i + k], soup[i + k + 1], soup[i + k + 2], 0);
    polygon = clipped(polygon, (x, y, z) => z - low, 0);
    polygon = clipped(polygon, (x, y, z) => high - z, 0);
    for (let k = 4; k + 4 < polygon.length; k += 4)
      for (const c of [0, k, k + 4]) part.push(polygon[c], polygon[c + 1], polygon[c + 2]);
  }
  return part;
}

export class GraphView {
  constructor(layersView, clip) {
    this.view = layersView;
    this.root = new Group();
    this.disc = disc();
    this.part = new GrowingPositions();
    this.partMaterial = clip.applyTo(
      new MeshLambertMaterial({ side: DoubleSide, flatShading: true, polygonOffset: true, polygonOffsetFactor: -1, polygonOffsetUnits: -1 }),
    );
    this.partMesh = new Mesh(this.part.geometry, this.partMaterial);
    this.contours = new GrowingPositions();
    this.contourMaterial = new LineBasicMaterial({ depthTest: false, transparent: true });
    this.contourLines = new LineSegments(this.contours.geometry, this.contourMaterial);
    this.contourLines.renderOrder = kOnTop;
    for (const object of [this.partMesh, this.contourLines]) {
      object.frustumCulled = false;
      this.root.add(object);
    }
    this.mark = new GrowingPositions(); // a ring around the picked node
    this.markPoints = new Points(
      this.mark.geometry,
      new PointsMaterial({ size: 26, sizeAttenuation: false, map: ring(), color: '#e0218a', depthTest: false, transparent: true }),
    );
    this.wideMaterial = new LineMaterial({ linewidth: 8, color: '#e0218a', depthTest: false, transparent: true, opacity: 0.8 });
    this.wide = new LineSegments2(new LineSegmentsGeometry(), this.wideMaterial); // beneath the picked arc
    for (const object of [this.markPoints, this.wide]) {
      object.frustumCulled = false;
      object.renderOrder = kOnTop;
      this.root.add(object);
    }
    this.wide.visible = false;
    this.lineMaterial = new LineMaterial({ linewidth: 3, vertexColors: true, depthTest: false, transparent: true });
    this.pointMaterial = new PointsMaterial({ size: 13, sizeAttenuation: false, map: this.disc, vertexColors: true, depthTest: false, transparent: true, alphaTest: 0.3 });
  }

  /** Draw a graph; null for none. `lift` of each layer. */
  show(graph, lift) {
    for (const object of [this.lines, this.points]) {
      if (!object) continue;
      this.root.remove(object);
      object.geometry.dispose();
    }
    this.lines = this.points = null;
    this.graph = graph;
    if (!graph || graph.nodes.length === 0) return;
    const up = graph.layer === null ? 0 : lift[graph.layer];
    this.#drawArcs(up);
    this.#drawNodes(up);
  }

  #drawArcs(up) {
    const positions = [];
    const colors = [];
    for (const { curve, color } of this.graph.arcs) {
      const rgb = new Color(color).toArray();
      for (let i = 1; i < curve.length; ++i) {
        for (const p of [curve[i - 1], curve[i]]) positions.push(p[0], p[1], p[2] + up);
        colors.push(...rgb, ...rgb);
      }
    }
    if (positions.length === 0) return;
    const geometry = new LineSegmentsGeometry();
    geometry.setPositions(positions);
    geometry.setColors(colors);
    this.lines = new LineSegments2(geometry, this.lineMaterial);
    this.lines.renderOrder = kOnTop + 1;
    this.lines.frustumCulled = false;
    this.root.add(this.lines);
  }

  #drawNodes(up) {
    const geometry = new BufferGeometry();
    const at = this.graph.nodes.flatMap(({ at: p }) => [p[0], p[1], p[2] + up]);
    const colors = this.graph.nodes.flatMap(({ type }) => new Color(kNodeColors[type] ?? '#ffffff').toArray());
    geometry.setAttribute('position', new BufferAttribute(new Float32Array(at), 3));
    geometry.setAttribute('color', new BufferAttribute(new Float32Array(colors), 3));
    this.points = new Points(geometry, this.pointMaterial);
    this.points.renderOrder = kOnTop + 2;
    this.points.frustumCulled = false;
    this.root.add(this.points);
  }

  /** Show what belongs to a picked node or arc ({ node }, { arc } or null). */
  pick(picked, lift, ink) {
    this.part.begin();
    this.contours.begin();
    this.mark.begin();
    this.wide.visible = false;
    if (this.graph && picked) {
      this.contourMaterial.color.set(ink);
      if (picked.arc !== undefined) this.#pickArc(this.graph.arcs[picked.arc], picked.arc, lift);
      else this.#pickNode(this.graph.nodes[picked.node], picked.node, lift);
    }
    this.part.end();
    this.contours.end();
    this.mark.end();
  }

  #putPart(soup, up, color) {
    this.partMaterial.color.set(color);
    this.partMesh.position.z = up; // so that it is cut where its layer is
    for (let i = 0; i < soup.length; i += 3) this.part.put(soup[i], soup[i + 1], soup[i + 2]);
  }

  #pickArc(arc, number, lift) {
    const { nodes, arcOf } = this.graph;
    this.#markArc(arc, this.graph.layer === null ? 0 : lift[arc.layer]);
    const [low, high] = [nodes[arc.from].at[2], nodes[arc.to].at[2]];
    const own = arcOf
      ? solidSoup(this.view, arc.layer, (t) => arcOf[t] === number)
      : between(solidSoup(this.view, arc.layer, () => true), low, high);
    this.#putPart(own, lift[arc.layer], arc.color);
    for (let i = 1; i <= kContoursOfArc; ++i) {
      const level = low + (i / (kContoursOfArc + 1)) * (high - low);
      this.#putContours(arc.layer, level, arcOf ? new Set([number]) : null, lift);
    }
  }

  /** Contours of a layer at a level; of these arcs only, if any are named. */
  #putContours(layer, level, arcs, lift) {
    const pieces = solidContours(this.view.plan, layer, level);
    for (const { segments } of arcs ? contoursOfArcs(pieces, this.graph.arcOf, arcs) : pieces)
      for (let i = 0; i < segments.length; i += 3) this.contours.put(segments[i], segments[i + 1], segments[i + 2] + lift[layer]);
  }

  #markArc({ curve }, up) {
    this.wide.geometry.dispose();
    this.wide.geometry = new LineSegmentsGeometry();
    const positions = [];
    for (let i = 1; i < curve.length; ++i) for (const p of [curve[i - 1], curve[i]]) positions.push(p[0], p[1], p[2] + up);
    this.wide.geometry.setPositions(positions);
    this.wide.visible = true;
  }

  #pickNode(node, number, lift) {
    const { arcs, arcOf } = this.graph;
    this.mark.put(node.at[0], node.at[1], node.at[2] + (arcOf ? lift[this.graph.layer] : 0));
    const near = new Set(arcs.flatMap(({ from, to }, i) => (from === number || to === number ? [i] : [])));
    for (const layer of node.layers) this.#putContours(layer, node.at[2], arcOf ? near : null, lift);
  }

  /** The node or arc drawn near a place on the canvas: { node }, { arc } or null. */
  near(px, py, project, lift, reach = 9) {
    if (!this.graph) return null;
    const up = this.graph.layer === null ? 0 : lift[this.graph.layer];
    const seen = (p) => project([p[0], p[1], p[2] + up]);
    const nodes = this.graph.nodes.map(({ at }) => seen(at));
    const node = nearestOf(nodes.map(([x, y]) => Math.hypot(x - px, y - py)));
    if (node.distance <= reach) return { node: node.index };
    const arc = nearestOf(this.graph.arcs.map(({ curve }) => toCurve(curve.map(seen), px, py)));
    return arc.distance <= reach ? { arc: arc.index } : null;
  }
}

function nearestOf(distances) {
  let index = -1;
  let distance = Infinity;
  distances.forEach((d, i) => {
    if (d < distance) [index, distance] = [i, d];
  });
  return { index, distance };
}

function toCurve(points, px, py) {
  let least = Infinity;
  for (let i = 1; i < points.length; ++i) {
    const [ax, ay] = points[i - 1];
    const [ux, uy] = [points[i][0] - ax, points[i][1] - ay];
    const t = Math.min(1, Math.max(0, ((px - ax) * ux + (py - ay) * uy) / (ux * ux + uy * uy || 1)));
    least = Math.min(least, Math.hypot(ax + t * ux - px, ay + t * uy - py));
  }
  return least;
}
