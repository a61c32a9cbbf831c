// SPDX-License-Identifier: GPL-3.0-or-later
// The page at work: settings in, drawing out.
import { ClipUniforms } from './clip.js';
import { ContoursView } from './contours_view.js';
import { cutOf } from './cut.js';
import { CutHandle } from './cut_handle.js';
import { FrameView } from './frame_view.js';
import { graphDiagram } from './graph_diagram.js';
import { GraphView } from './graph_view.js';
import { pickedIn } from './graphs.js';
import { HolesView, suitableRadius } from './holes_view.js';
import { LayersView } from './layers_view.js';
import { grouped } from './model.js';
import { layerColors } from './palette.js';
import { download, pictureOf } from './picture.js';
import { PlanGrid } from './plan_grid.js';
import { Pointer } from './pointer.js';
import { opacityOf, toFragment } from './settings.js';
import { h } from './ui.js';
import { graphText, kOthers } from './words.js';

const kSliding = ['cutAt', 'slab', 'azimuth', 'dip', 'blockShares', 'exaggeration']; // settings that change what is drawn, not of what

const kThemes = {
  light: { background: '#f3f5f7', ink: '#20262c' },
  dark: { background: '#171b20', ink: '#dfe4ea' },
};

export class App {
  #graphListeners = [];

  constructor(model, settings, stage, overlay) {
    Object.assign(this, { model, settings, stage, overlay });
    this.units = model.units;
    this.holes = model.holes;
    this.box = model.plan.box;
    this.datum = model.datum;
    this.lengthUnit = model.unit;
    this.report = model.report;
    this.comparable = Object.keys(model.others).filter((key) => model.others[key] !== null);
    this.colors = layerColors(model.units, settings.values.palette);
    this.#makeViews();
    this.tell = () => {};
    this.update(settings.values, new Set(Object.keys(settings.values)));
    settings.onChange((values, changed) => this.update(values, changed));
    matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => this.update(settings.values, new Set(['theme'])));
  }

  #makeViews() {
    const { model, stage } = this;
    this.clip = new ClipUniforms();
    this.clip.setSize(Math.hypot(...this.box.low.map((c, k) => this.box.high[k] - c)));
    this.layersView = new LayersView(model.plan, this.clip);
    this.holesView = new HolesView(model.holes, this.clip);
    this.contoursView = new ContoursView(this.layersView, this.clip);
    this.graphView = new GraphView(this.layersView, this.clip);
    this.frameView = new FrameView(this.overlay.ticks);
    this.handle = new CutHandle(this, this.overlay.knobs);
    this.holeTag = h('span', { class: 'hole-tag', hidden: true });
    this.overlay.labels.append(this.holeTag);
    this.pointer = new Pointer(this, stage, this.overlay.labels);
    this.halves = [null, { view: this.layersView, grid: model.grid }];
    this.others = {}; // by key of kOthers
    const views = [this.layersView, this.holesView, this.contoursView, this.graphView, this.frameView, this.handle, this.pointer];
    stage.model.add(...views.map(({ root }) => root));
    stage.beforeHalf = (half) => {
      this.layersView.root.visible = half === 1;
      this.contoursView.root.visible = half === 1;
      this.graphView.root.visible = half === 1;
      if (this.halves[0]) this.halves[0].view.root.visible = half === 0;
    };
    stage.afterFrame = () => this.#follow();
    stage.onCoarse = (coarse) => {
      this.#each((view) => view.setCoarse(coarse));
      this.holesView.setCoarse(coarse);
    };
    this.sizeText = `${grouped(this.layersView.triangles, 7)} triangles, ${grouped(model.plan.vertices, 7)} plan vertices`;
  }

  isPresent(layer) {
    return this.model.isPresent(layer);
  }

  shownLayers() {
    return this.units.map((_, i) => i).filter((i) => opacityOf(this.settings.values, i) > 0);
  }

  isSeeThrough(layer) {
    return opacityOf(this.settings.values, layer) < 1 || this.settings.values.reeb !== 'off';
  }

  holeRadius() {
    return suitableRadius(this.holes, this.box) * this.settings.values.holeSize;
  }

  project(p) {
    return this.stage.project(p);
  }

  get theme() {
    const { theme } = this.settings.values;
    if (theme !== 'auto') return theme;
    return matchMedia('(prefers-color-scheme: dark)').matches ? 'dark' : 'light';
  }

  /** Bring everything in line with settings of which some changed. */
  update(values, changed) {
    const has = (...keys) => keys.some((key) => changed.has(key));
    if ([...changed].some((key) => !kSliding.includes(key))) this.#showAll();
    if (has('theme')) this.#updateTheme();
    if (has('palette')) this.#updateColors(values);
    if (has('explode', 'exaggeration')) this.#updatePlaces(values);
    if (has('explode') && this.stage.view) this.stage.show(this.stage.view); // all stays in the picture until the reader turns it
    if (has('compare')) this.#updateCompare(values);
    if (has('hidden', 'opacity', 'faint', 'reeb', 'compare', 'explode')) this.#each((view) => view.setOpacities(values, this.#focus(values)));
    if (has('smooth', 'edges', 'compare')) this.#each((view) => view.setShading(values));
    if (has('cut', 'cutAt', 'cutFlip', 'azimuth', 'dip', 'block', 'blockShares', 'slab', 'slabs', 'compare')) this.#updateCut(values);
    if (has('holes', 'holesCut', 'holeSize', 'explode', 'exaggeration')) this.#updateHoles(values);
    if (has('contours', 'interval', 'level')) this.contoursView.set(values, this.datum[2]);
    if (has('contours', 'interval', 'level', 'explode', 'hidden', 'opacity', 'faint')) this.#placeContours(values);
    if (has('reeb', 'explode', 'palette')) this.#updateGraph(values);
    if (has('reeb', 'picked', 'explode', 'palette', 'theme')) this.#updatePicked(values);
    if (has('orthographic')) this.stage.setParallel(values.orthographic);
    if (has('frame', 'explode', 'theme')) this.#updateFrame(values);
    this.#keepPace(has(...kSliding));
    this.stage.request();
  }

  /** What is shown changes: draw all of it, as fast as it goes. */
  #showAll() {
    this.stage.pace.rest();
    this.stage.pace.forget();
  }

  #keepPace(isSliding) {
    if (this.stage.turning) this.stage.pace.begin();
    else if (isSliding) this.stage.pace.nudge();
  }

  #each(act) {
    for (const { view } of [this.halves[1], ...Object.values(this.others)]) act(view);
  }

  #focus({ reeb }) {
    if (reeb === 'off') return null;
    return reeb === 'layered' ? 'all' : Number(reeb);
  }

  #updateTheme() {
    const { background, ink } = kThemes[this.theme];
    document.documentElement.dataset.theme = this.theme;
    this.stage.renderer.setClearColor(background, 1);
    for (const view of [this.frameView, this.handle, this.contoursView]) view.setInk(ink);
    this.contoursView.setInk('#15191d');
  }

  #updateColors({ palette }) {
    this.colors = layerColors(this.units, palette);
    this.#each((view) => view.setColors(this.colors));
    this.holesView.setColors(this.colors);
  }

  #updatePlaces({ explode, exaggeration }) {
    const gap = explode * (this.box.high[2] - this.box.low[2]);
    this.lift = this.units.map((_, i) => gap * (this.units.length - 1 - i));
    this.#each((view) => view.setLift(this.lift));
    this.stage.model.scale.z = exaggeration;
    const { low, high } = this.box;
    this.stage.bounds = {
      low: [low[0], low[1], low[2] * exaggeration],
      high: [high[0], high[1], (high[2] + (this.lift[0] ?? 0)) * exaggeration],
    };
  }

  #updateCompare({ compare }) {
    const wanted = this.comparable.includes(compare);
    if (wanted) this.halves[0] = this.#other(compare);
    for (const { view } of Object.values(this.others)) view.root.visible = false;
    this.stage.split = wanted;
    this.overlay.halves.hidden = !wanted;
    if (wanted) this.overlay.left.textContent = kOthers[compare].title;
  }

  /** What is shown on the left; made when it is first asked for. */
  #other(key) {
    if (!this.others[key]) {
      const plan = this.model.others[key];
      const view = new LayersView(plan, this.clip);
      view.setColors(this.colors);
      view.setLift(this.lift);
      this.others[key] = { view, grid: new PlanGrid(plan) };
      this.stage.model.add(view.root);
    }
    return this.others[key];
  }

  #updateCut(values) {
    this.cut = cutOf(values, this.box);
    this.clip.set(this.cut);
    this.layersView.setCut(this.cut);
    if (this.stage.split) this.halves[0].view.setCut(this.cut);
    this.holesView.setShown(values.holes, values.holesCut);
    this.handle.set(values);
  }

  #updateHoles(values) {
    this.holesView.place(this.holeRadius(), this.lift, values.exaggeration);
    this.holesView.setShown(values.holes, values.holesCut);
  }

  #placeContours(values) {
    this.contoursView.place(values, this.lift, (i) => opacityOf(values, i) > 0);
  }

  #updateGraph({ reeb }) {
    const number = Number(reeb);
    if (reeb === 'off') this.graph = null;
    else this.graph = reeb === 'layered' ? this.model.graphs.layered(this.colors) : (this.model.graphs.layers[number] ?? null);
    this.graphView.show(this.graph, this.lift);
  }

  #updatePicked({ picked }) {
    this.graphView.pick(this.graph ? pickedIn(this.graph, picked) : null, this.lift, kThemes[this.theme].ink);
    this.#tellGraph();
  }

  #updateFrame(values) {
    this.frameView.root.visible = values.frame;
    const { low, high } = this.box;
    this.frameView.set({ low, high: [high[0], high[1], high[2]] }, this.datum);
  }

  /** Labels keep up with the camera. */
  #follow() {
    const project = (p, half) => this.stage.project(p, half);
    this.handle.follow(project);
    this.pointer.follow(project);
    this.frameView.label(project, this.settings.values.frame && !this.stage.split);
    this.#followHole(project);
    this.afterFrame?.();
  }

  /** A tag at the head of the borehole whose log is shown. */
  #followHole(project) {
    const hole = this.holes[this.settings.values.hole];
    this.holeTag.hidden = !hole || hole.top === null;
    if (this.holeTag.hidden) return;
    const [x, y, inFront] = project([hole.x, hole.y, hole.top + this.lift[0]], 1);
    this.holeTag.hidden = !inFront;
    this.holeTag.textContent = hole.id;
    this.holeTag.style.transform = `translate(${x.toFixed(1)}px,${y.toFixed(1)}px) translate(-50%,-165%)`;
  }

  onGraph(listener) {
    this.#graphListeners.push(listener);
    this.#tellGraph();
  }

  #tellGraph() {
    const { graph } = this;
    const { picked } = this.settings.values;
    const diagram = graph && graph.nodes.length > 0
      ? graphDiagram(graph, {
          datum: this.datum[2],
          names: this.units.map(({ name }) => name),
          colors: this.colors,
          unit: this.lengthUnit,
          picked,
          onPick: (word) => this.settings.set({ picked: picked === word ? '' : word }),
        })
      : null;
    for (const listener of this.#graphListeners) listener(diagram, graph ? graphText(this, graph, picked) : '');
  }

  fragment() {
    const { base, values } = this.settings;
    const camera = this.stage.view === 'oblique' ? base.camera : this.stage.cameraState();
    return toFragment({ ...values, camera }, base);
  }

  async copyLink() {
    const address = `${location.href.split('#')[0]}#${this.fragment()}`;
    history.replaceState(null, '', `#${this.fragment()}`);
    try {
      await navigator.clipboard.writeText(address);
      return 'The address is in the clipboard.';
    } catch {
      return 'The address bar has the link; copy it from there.';
    }
  }

  async savePicture() {
    const blob = await this.picture();
    download(blob, `${this.model.title || 'model'}.png`);
  }

  picture() {
    const { values } = this.settings;
    const shown = this.shownLayers().filter((i) => this.isPresent(i));
    const labels = values.frame ? this.frameView.texts(this.stage.canvas) : [];
    return pictureOf(this.stage, {
      title: this.model.title,
      caption: `heights × ${+values.exaggeration.toFixed(2)}, lengths in ${this.lengthUnit}`,
      entries: shown.map((i) => ({ name: this.units[i].name, color: this.colors[i] })),
      dark: this.theme === 'dark',
      background: kThemes[this.theme].background,
      labels,
    });
  }
}
