// SPDX-License-Identifier: GPL-3.0-or-later
// Camera, light and drawing. A frame is drawn only when something asks for it.
import {
  DirectionalLight,
  Group,
  HemisphereLight,
  OrthographicCamera,
  PerspectiveCamera,
  Scene,
  Vector3,
  WebGLRenderer,
} from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { Pace } from './pace.js';

const kFieldOfView = 32; // degrees: little distortion
const kMargin = 1.06; // around the model
const kLabelRoom = 46; // pixels beside it
const kTurnsPerSecond = 1 / 24;

/** Directions from the target to the eye. */
export const kViews = {
  oblique: [-0.55, -1, 0.75],
  top: [0, -1e-4, 1],
  south: [0, -1, 0],
  east: [1, 0, 0],
  north: [0, 1, 0],
  west: [-1, 0, 0],
  below: [0, -1e-4, -1],
};

export class Stage {
  constructor(canvas) {
    this.canvas = canvas;
    this.renderer = new WebGLRenderer({ canvas, antialias: true, preserveDrawingBuffer: false });
    this.scene = new Scene();
    this.model = new Group(); // scaled in z by the exaggeration
    this.scene.add(this.model);
    this.perspective = new PerspectiveCamera(kFieldOfView, 1, 1, 10);
    this.parallel = new OrthographicCamera(-1, 1, 1, -1, 1, 10);
    this.camera = this.perspective;
    for (const camera of [this.perspective, this.parallel]) {
      camera.up.set(0, 0, 1);
      this.scene.add(camera);
    }
    this.#light();
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.zoomToCursor = true;
    this.controls.addEventListener('change', () => this.request());
    this.controls.addEventListener('start', () => {
      this.view = null;
      this.pace.begin();
    });
    this.controls.addEventListener('end', () => !this.turning && this.pace.end());
    this.onCoarse = () => {}; // told whether to draw fewer triangles
    this.pace = new Pace(
      this.renderer.getContext(),
      ({ coarse }) => this.onCoarse(coarse),
      () => this.request(),
    );
    this.view = null; // the name of the view that is shown, until the reader turns it
    this.frames = 0; // drawn so far, for tests
    this.split = false;
    this.pixels = null; // for one of the page, where a picture asks for its own
    this.beforeHalf = () => {}; // called with 0 and 1 before each half of a split picture, with 1 for a whole one
    this.afterFrame = () => {};
    this.bounds = { low: [-1, -1, -1], high: [1, 1, 1] };
    canvas.addEventListener('webglcontextrestored', () => this.request());
    new ResizeObserver(() => this.resize()).observe(canvas.parentElement);
    this.resize();
  }

  /** Sky, and a sun that comes with the eye, from its upper left. */
  #light() {
    this.sun = new DirectionalLight(0xffffff, 1.8);
    this.sun.position.set(-0.5, 0.9, 0.8);
    this.sun.target.position.set(0, 0, -1);
    this.scene.add(new HemisphereLight(0xffffff, 0xb8b4ae, 1.45));
    this.camera.add(this.sun, this.sun.target);
  }

  resize() {
    const { clientWidth, clientHeight } = this.canvas.parentElement;
    if (clientWidth === 0 || clientHeight === 0) return;
    this.renderer.setSize(clientWidth, clientHeight, false);
    this.size = [clientWidth, clientHeight];
    if (this.view) this.show(this.view);
    this.request();
  }

  /** Right before drawing, since it clears the canvas. */
  #setPixels() {
    const ratio = this.pixels ?? Math.min(window.devicePixelRatio || 1, this.pace.applied.pixels);
    if (ratio !== this.renderer.getPixelRatio()) this.renderer.setPixelRatio(ratio);
  }

  /** Width over height of what one camera sees. */
  get aspect() {
    return this.size[0] / (this.split ? 2 : 1) / this.size[1];
  }

  request() {
    if (this.pending) return;
    this.pending = requestAnimationFrame((time) => {
      this.pending = 0;
      if (this.pace.busy) return this.request();
      const begun = performance.now();
      if (this.turning) this.#turn(time);
      this.#render();
      this.pace.drawn(begun);
      if (this.turning) this.request();
    });
  }

  /** Draw now, and all that there is. */
  draw() {
    this.pace.rest();
    this.#render();
    if (this.turning) this.setTurning(true);
  }

  #render() {
    this.#setPixels();
    this.#fitCamera();
    const [width, height] = this.size;
    const { renderer } = this;
    if (this.split) {
      renderer.setScissorTest(true);
      for (const half of [0, 1]) {
        this.beforeHalf(half);
        renderer.setViewport((half * width) / 2, 0, width / 2, height);
        renderer.setScissor((half * width) / 2, 0, width / 2, height);
        renderer.render(this.scene, this.camera);
      }
      renderer.setScissorTest(false);
    } else {
      this.beforeHalf(1);
      renderer.setViewport(0, 0, width, height);
      renderer.render(this.scene, this.camera);
    }
    ++this.frames;
    this.afterFrame();
  }

  /** Near and far planes around the model, and the parallel camera's width like the other's at the target. */
  #fitCamera() {
    const { camera, controls } = this;
    const distance = camera.position.distanceTo(controls.target);
    const radius = this.radius();
    const centre = this.centre();
    const depth = camera.position.distanceTo(centre);
    if (camera === this.perspective) {
      camera.aspect = this.aspect;
      camera.near = Math.max(depth - 1.2 * radius, distance / 500, radius / 5000);
      camera.far = depth + 1.5 * radius;
    } else {
      const high = this.parallelHeight ?? 1;
      camera.top = high / 2;
      camera.bottom = -high / 2;
      camera.right = (high / 2) * this.aspect;
      camera.left = -camera.right;
      camera.near = depth - 3 * radius;
      camera.far = depth + 3 * radius;
    }
    camera.updateProjectionMatrix();
    camera.updateMatrixWorld();
  }

  centre() {
    const { low, high } = this.bounds;
    return new Vector3(...low.map((c, k) => (c + high[k]) / 2));
  }

  radius() {
    const { low, high } = this.bounds;
    return Math.hypot(...low.map((c, k) => high[k] - c)) / 2 || 1;
  }

  /** Turn the eye to a view and bring all of the model into the picture. */
  show(view = null) {
    const { camera, controls } = this;
    const direction = view ? new Vector3(...kViews[view]) : camera.position.clone().sub(controls.target);
    direction.normalize();
    this.view = view ?? this.view;
    const target = this.centre();
    controls.target.copy(target);
    camera.position.copy(target).addScaledVector(direction, this.#fittingDistance(direction));
    camera.zoom = 1;
    controls.update();
    this.#fitCamera();
    this.request();
  }

  /** The distance from which all corners of the bounds are in the picture; sets the parallel camera's height too. */
  #fittingDistance(direction) {
    const side = new Vector3(0, 0, 1).cross(direction);
    if (side.lengthSq() < 1e-12) side.set(1, 0, 0);
    side.normalize();
    const up = direction.clone().cross(side);
    const tangent = Math.tan((kFieldOfView * Math.PI) / 360);
    const { low, high } = this.bounds;
    const room = this.aspect * Math.max(0.5, 1 - kLabelRoom / (this.size[0] / (this.split ? 2 : 1) / 2));
    let distance = 0;
    let half = 0;
    for (let i = 0; i < 8; ++i) {
      const corner = new Vector3(...[0, 1, 2].map((k) => ((i >> k) & 1 ? high[k] : low[k]))).sub(this.centre());
      const [across, along, near] = [Math.abs(corner.dot(side)) / room, Math.abs(corner.dot(up)), corner.dot(direction)];
      half = Math.max(half, across, along);
      distance = Math.max(distance, Math.max(across, along) / tangent + near);
    }
    this.parallelHeight = 2 * kMargin * half;
    return kMargin * distance;
  }

  /** Look with the other kind of camera from the same place. */
  setParallel(wanted) {
    const next = wanted ? this.parallel : this.perspective;
    if (next === this.camera) return;
    const distance = this.camera.position.distanceTo(this.controls.target);
    const tangent = Math.tan((kFieldOfView * Math.PI) / 360);
    next.position.copy(this.camera.position);
    next.zoom = 1;
    if (wanted) {
      this.parallelHeight = 2 * distance * tangent;
    } else {
      const wide = this.parallelHeight / this.camera.zoom / (2 * tangent);
      next.position.sub(this.controls.target).setLength(wide).add(this.controls.target);
    }
    this.camera = next;
    next.add(this.sun, this.sun.target);
    this.controls.object = next;
    this.controls.update();
    this.#fitCamera();
    this.request();
  }

  setTurning(turning) {
    this.view = null;
    this.turning = turning;
    this.lastTurn = 0;
    if (turning) this.pace.begin();
    else this.pace.end();
    this.request();
  }

  #turn(time) {
    const seconds = this.lastTurn ? Math.min((time - this.lastTurn) / 1000, 0.1) : 0;
    this.lastTurn = time;
    const arm = this.camera.position.clone().sub(this.controls.target);
    arm.applyAxisAngle(new Vector3(0, 0, 1), 2 * Math.PI * kTurnsPerSecond * seconds);
    this.camera.position.copy(this.controls.target).add(arm);
    this.camera.lookAt(this.controls.target);
  }

  /** Position, target and zoom as numbers in the model's frame. */
  cameraState() {
    const { camera, controls } = this;
    const zoom = camera === this.parallel ? this.parallelHeight / camera.zoom : 1;
    return [...camera.position.toArray(), ...controls.target.toArray(), zoom];
  }

  setCameraState(state) {
    this.view = null;
    this.camera.position.fromArray(state, 0);
    this.controls.target.fromArray(state, 3);
    if (this.camera === this.parallel) {
      this.parallelHeight = state[6] > 0 ? state[6] : 1;
      this.camera.zoom = 1;
    }
    this.controls.update();
    this.#fitCamera();
    this.request();
  }

  /** Which half a place on the canvas (CSS pixels) is in, and its coordinates there from -1 to 1. */
  normalized(px, py) {
    const [width, height] = this.size;
    const part = this.split ? width / 2 : width;
    const half = this.split ? Math.min(1, Math.max(0, Math.floor(px / part))) : 1;
    return { half, x: (2 * (px - (this.split ? half * part : 0))) / part - 1, y: 1 - (2 * py) / height };
  }

  /** A ray through a place on the canvas, in the model's coordinates: { origin, direction, half }. */
  ray(px, py) {
    const { x, y, half } = this.normalized(px, py);
    const near = new Vector3(x, y, -1).unproject(this.camera);
    const far = new Vector3(x, y, 1).unproject(this.camera);
    const scale = this.model.scale.z;
    const direction = far.sub(near).normalize();
    return { half, origin: [near.x, near.y, near.z / scale], direction: [direction.x, direction.y, direction.z / scale] };
  }

  /** Where a place of the model stands on the canvas, in CSS pixels: [x, y, whether in front]. `half`: of a split picture. */
  project([x, y, z], half = 1) {
    const p = new Vector3(x, y, z * this.model.scale.z).project(this.camera);
    const [width, height] = this.size;
    const part = this.split ? width / 2 : width;
    return [((p.x + 1) / 2) * part + (this.split ? half * part : 0), ((1 - p.y) / 2) * height, p.z < 1 && p.z > -1];
  }
}
