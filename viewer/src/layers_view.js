// SPDX-License-Identifier: GPL-3.0-or-later
// The layers as solids: horizons' vertices are shared by the layers above and below, walls stand along the outline, and cuts have
// faces of their own.
import {
  BackSide,
  BufferAttribute,
  BufferGeometry,
  DoubleSide,
  FrontSide,
  Group,
  LineBasicMaterial,
  LineSegments,
  Mesh,
  MeshBasicMaterial,
  MeshLambertMaterial,
} from 'three';
import { coarseIndex, representatives } from './coarse_plan.js';
import { cutFaces } from './cut.js';
import { GrowingPositions, putPolygon } from './growing_buffers.js';
import { mixed } from './palette.js';
import { opacityOf } from './settings.js';

const kCoarseTriangles = 40000; // of tops and bases while a model moves too slowly
const kFewestCells = 1500;

function horizonAttributes(plan, k) {
  const position = new Float32Array(3 * plan.vertices);
  for (let v = 0; v < plan.vertices; ++v) {
    position[3 * v] = plan.x[v];
    position[3 * v + 1] = plan.y[v];
    position[3 * v + 2] = plan.horizons[k][v];
  }
  return { position: new BufferAttribute(position, 3), normal: new BufferAttribute(plan.normalsOf(k), 3, true) };
}

function sheet({ position, normal }, index) {
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', position);
  geometry.setAttribute('normal', normal);
  geometry.setIndex(index);
  return geometry;
}

function wallGeometry(walls) {
  const normal = new Float32Array(walls.length);
  for (let i = 0; i < walls.length; i += 9) {
    const u = [walls[i + 3] - walls[i], walls[i + 4] - walls[i + 1], walls[i + 5] - walls[i + 2]];
    const v = [walls[i + 6] - walls[i], walls[i + 7] - walls[i + 1], walls[i + 8] - walls[i + 2]];
    const [nx, ny] = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2]];
    const length = Math.hypot(nx, ny) || 1;
    for (let c = 0; c < 3; ++c) normal.set([nx / length, ny / length, 0], i + 3 * c);
  }
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(walls, 3));
  geometry.setAttribute('normal', new BufferAttribute(normal, 3));
  return geometry;
}

/** One layer's meshes in a group that moves up when layers are pulled apart. */
class LayerMeshes {
  constructor(plan, layer, horizons, clip) {
    this.layer = layer;
    this.group = new Group();
    this.group.name = `layer ${layer}`;
    this.index = plan.trianglesOf(layer);
    this.walls = plan.wallsOf(layer);
    const drawn = () => new BufferAttribute(new Uint32Array(this.index.length), 1);
    this.geometries = [sheet(horizons[layer], drawn()), sheet(horizons[layer + 1], drawn()), wallGeometry(this.walls)];
    // Solids are closed, cuts have faces: nobody sees the back of a triangle. Where layers are too thin to tell apart, the upper one is
    // seen from above and the lower one from below.
    const matter = (side, units) =>
      clip.applyTo(new MeshLambertMaterial({ side, polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: units }));
    this.surface = matter(FrontSide, 2 + 4 * layer);
    this.under = matter(BackSide, 2 + 4 * (plan.layers - layer));
    this.face = new MeshBasicMaterial({ side: DoubleSide, polygonOffset: true, polygonOffsetFactor: 0.5, polygonOffsetUnits: 0.5 });
    this.ink = new LineBasicMaterial();
    this.edge = clip.applyTo(new MeshBasicMaterial({ wireframe: true, transparent: true, opacity: 0.35 }));
    this.solid = this.geometries.map((geometry, i) => new Mesh(geometry, i === 1 ? this.under : this.surface));
    this.faces = new GrowingPositions();
    this.faceEdges = new GrowingPositions();
    this.faceMesh = new Mesh(this.faces.geometry, this.face);
    this.faceLines = new LineSegments(this.faceEdges.geometry, this.ink);
    for (const object of [...this.solid, this.faceMesh, this.faceLines]) {
      object.frustumCulled = false;
      this.group.add(object);
    }
    this.wires = [];
  }

  setColor(color) {
    for (const material of [this.surface, this.under, this.face]) material.color.set(color);
    this.ink.color.set(mixed(color, '#101418', 0.65));
    this.edge.color.set(mixed(color, '#101418', 0.75));
  }

  setOpacity(opacity) {
    this.group.visible = opacity > 0 && this.index.length > 0;
    for (const material of [this.surface, this.under, this.face]) {
      material.opacity = opacity;
      material.depthWrite = opacity >= 1;
      if (material.transparent !== opacity < 1) {
        material.transparent = opacity < 1;
        material.needsUpdate = true;
      }
    }
    this.ink.opacity = Math.max(opacity, 0.3);
    this.ink.transparent = opacity < 1;
    this.group.renderOrder = opacity < 1 ? 1 : 0;
  }

  /** The mesh's edges over its faces; made when first asked for. */
  setEdges(wanted) {
    if (wanted && this.wires.length === 0) {
      this.wires = this.geometries.map((geometry) => new Mesh(geometry, this.edge));
      for (const wire of this.wires) {
        wire.frustumCulled = false;
        this.group.add(wire);
      }
    }
    for (const wire of this.wires) wire.visible = wanted;
  }

  setSmooth(smooth) {
    for (const material of [this.surface, this.under]) {
      if (material.flatShading === !smooth) continue;
      material.flatShading = !smooth;
      material.needsUpdate = true;
    }
  }
}

export class LayersView {
  constructor(plan, clip) {
    this.plan = plan;
    this.root = new Group();
    const horizons = plan.horizons.map((_, k) => horizonAttributes(plan, k));
    this.layers = [];
    for (let i = 0; i < plan.layers; ++i) {
      this.layers.push(new LayerMeshes(plan, i, horizons, clip));
      this.root.add(this.layers[i].group);
    }
  }

  get triangles() {
    return this.layers.reduce((sum, { index, walls }) => sum + (2 * index.length) / 3 + walls.length / 9, 0);
  }

  setColors(colors) {
    this.layers.forEach((layer, i) => layer.setColor(colors[i]));
  }

  /** `focus`: fade all others, and this one a little, so that a graph inside is seen. */
  setOpacities(settings, focus = null) {
    const share = (i) => (focus === null ? 1 : focus === i ? 0.45 : focus === 'all' ? 0.3 : 0.06);
    const opacities = this.layers.map((_, i) => opacityOf(settings, i) * share(i));
    this.layers.forEach((layer, i) => layer.setOpacity(opacities[i]));
    const isSolid = opacities.map((opacity) => opacity >= 1 && settings.explode === 0);
    if (isSolid.join() === this.isSolid?.join()) return;
    this.isSolid = isSolid;
    this.#expose(isSolid);
  }

  setLift(lift) {
    this.layers.forEach((layer, i) => (layer.group.position.z = lift[i]));
  }

  setShading({ smooth, edges }) {
    this.edges = edges;
    for (const layer of this.layers) {
      layer.setSmooth(smooth);
      layer.setEdges(edges);
    }
  }

  /**
   * Draw only those tops and bases that may be seen: where two layers meet and both are solid, their common surface is hidden. That
   * leaves a tenth of a model of ten layers.
   */
  #expose(isSolid) {
    const { plan } = this;
    const sheets = this.layers.map(({ geometries }) => geometries.slice(0, 2).map((geometry) => ({ geometry, used: 0 })));
    const draw = (side, t) => {
      const { array } = side.geometry.index;
      for (let k = 0; k < 3; ++k) array[side.used++] = plan.corner[3 * t + k];
    };
    for (let t = 0; t < plan.triangles; ++t) {
      let above = -1; // the next layer up that is in the triangle
      for (let i = 0; i < plan.layers; ++i) {
        if (!plan.presence[i][t]) continue;
        if (above < 0 || !isSolid[above]) draw(sheets[i][0], t);
        if (above >= 0 && !isSolid[i]) draw(sheets[above][1], t);
        above = i;
      }
      if (above >= 0) draw(sheets[above][1], t);
    }
    for (const { geometry, used } of sheets.flat()) {
      geometry.setDrawRange(0, used);
      geometry.index.needsUpdate = true;
    }
    this.coarse?.forEach((geometry) => geometry.dispose());
    this.coarse = null;
  }

  /** Draw tops and bases with fewer triangles, or whole again; edges of the mesh are left out meanwhile. */
  setCoarse(wanted) {
    if (wanted) this.coarse ??= this.#coarseSheets();
    this.layers.forEach(({ solid, geometries, wires }, i) => {
      for (const k of [0, 1]) solid[k].geometry = wanted ? this.coarse[2 * i + k] : geometries[k];
      for (const wire of wires) wire.visible = !wanted && this.edges;
    });
  }

  #coarseSheets() {
    const sheets = this.layers.flatMap(({ geometries }) => geometries.slice(0, 2));
    const drawn = sheets.reduce((sum, geometry) => sum + geometry.drawRange.count / 3, 0);
    const cells = Math.max(kFewestCells, (this.plan.vertices * kCoarseTriangles) / Math.max(drawn, 1));
    const stands = representatives(this.plan, cells);
    return sheets.map((geometry) => {
      const { position, normal } = geometry.attributes;
      const index = coarseIndex(this.plan, geometry.index.array, geometry.drawRange.count, stands);
      return sheet({ position, normal }, new BufferAttribute(index, 1));
    });
  }

  /** Fill the faces of a cut. */
  setCut(cut) {
    const all = this.layers.map(({ layer }) => layer);
    for (const { faces, faceEdges } of this.layers) {
      faces.begin();
      faceEdges.begin();
    }
    cutFaces(this.plan, cut, all, (layer, polygon) => {
      putPolygon(this.layers[layer].faces, this.layers[layer].faceEdges, polygon);
    });
    for (const { faces, faceEdges } of this.layers) {
      faces.end();
      faceEdges.end();
    }
  }
}
