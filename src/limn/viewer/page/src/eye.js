// SPDX-License-Identifier: BSD-3-Clause
// Where the picture is taken from: free, turning about a target, or exactly at a photograph.

import { Matrix4, PerspectiveCamera, Quaternion, Vector3 } from 'three';
import { OrbitControls } from 'three/examples/jsm/controls/OrbitControls.js';

import {
  coverPicture,
  fitPicture,
  openingAngle,
  orientationOf,
  photoProjection,
  project,
} from './optics.js';

const OPENING_DEG = 45;
const FLIGHT_MS = 550;
const MAX_HISTORY = 100;
const SAME_TURN_MS = 500;
// A pointer that moves less, px, has been tapped.
const TAP_PX = 5;

function upOf({ views, zIsUp }) {
  if (zIsUp) return new Vector3(0, 0, 1);
  const up = new Vector3();
  for (const { camFromWorld: r } of views) up.sub(new Vector3(r[3], r[4], r[5]));
  const known = up.length() > 1e-3 * views.length;
  return known ? up.normalize() : new Vector3(0, 0, 1);
}

// The view that supports the greatest length of what is shown; null if none does any.
function viewOfMost(drawing) {
  const lengths = new Float64Array(drawing.views.length);
  for (let link = 0; link < drawing.numLinks; ++link) {
    if (!drawing.isShown(link)) continue;
    for (const view of drawing.supportingViews(link)) lengths[view] += drawing.linkLength[link];
  }
  const most = lengths.reduce((longest, length) => Math.max(longest, length), 0);
  return most > 0 ? lengths.indexOf(most) : null;
}

function smooth(share) {
  return share * share * (3 - 2 * share);
}

// Small movements of a pointer that is down are kept from the controls: a tap picks, turns nothing.
function holdTaps(canvas) {
  let start = null;
  canvas.addEventListener('pointerdown', (event) => (start = [event.clientX, event.clientY]), true);
  window.addEventListener('pointerup', () => (start = null), true);
  window.addEventListener(
    'pointermove',
    (event) => {
      if (!start) return;
      const distance = Math.hypot(event.clientX - start[0], event.clientY - start[1]);
      if (distance < TAP_PX) event.stopImmediatePropagation();
      else start = null;
    },
    true,
  );
}

export class Eye {
  constructor(canvas, drawing) {
    this.drawing = drawing;
    this.size = { width: 1, height: 1 };
    this.photo = null; // index of the view that is looked through
    this.placement = null; // of its picture on the canvas (optics.js)
    this.fills = false; // whether the picture covers the canvas, or is seen as a whole
    this.flight = null;
    this.history = [];
    this.atStart = null; // where the controls began to move
    this.lastTurn = -Infinity;
    this.listeners = [];
    this.camera = new PerspectiveCamera(OPENING_DEG, 1);
    this.camera.up.copy(upOf(drawing));
    this.setDepthRange();
    holdTaps(canvas);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.zoomToCursor = true;
    this.controls.listenToKeyEvents(canvas);
    this.controls.addEventListener('start', () => (this.atStart = this.state()));
    this.controls.addEventListener('change', () => this.turned());
    this.onMove = () => {};
  }

  // Called with no arguments whenever another photograph, or none, is looked through.
  onPhoto(listener) {
    this.listeners.push(listener);
  }

  setDepthRange() {
    const reach = this.drawing.views.reduce(
      (most, view) => Math.max(most, Math.hypot(...view.position)),
      this.drawing.radius,
    );
    this.camera.near = 1e-3 * this.drawing.radius;
    this.camera.far = 100 * reach;
  }

  resize(width, height) {
    this.size = { width, height };
    this.camera.aspect = width / height;
    this.placement = this.placePicture();
    this.project();
  }

  placePicture() {
    if (this.photo === null) return null;
    const { width, height } = this.size;
    if (!this.fills) return fitPicture(this.view(), width, height);
    const center = this.drawing.box.getCenter(new Vector3());
    return coverPicture(this.view(), width, height, project(this.view(), ...center, []));
  }

  view() {
    return this.drawing.views[this.photo];
  }

  project() {
    const { width, height } = this.size;
    if (this.photo === null) {
      this.camera.updateProjectionMatrix();
      return;
    }
    const { near, far } = this.camera;
    this.setProjection(photoProjection(this.view(), this.placement, width, height, near, far));
  }

  setProjection(matrix) {
    this.camera.projectionMatrix.copy(matrix);
    this.camera.projectionMatrixInverse.copy(matrix).invert();
  }

  // The controls have moved the camera by hand. Turns of the wheel that follow each other are one
  // movement.
  turned() {
    const now = performance.now();
    if (this.atStart && now - this.lastTurn > SAME_TURN_MS) this.remember(this.atStart);
    this.atStart = null;
    this.lastTurn = now;
    this.flight = null;
    if (this.photo !== null) {
      this.camera.fov = openingAngle(this.view(), this.placement, this.size.height);
      this.setPhoto(null);
      this.project();
    }
    this.onMove();
  }

  setPhoto(photo, fills = false) {
    this.photo = photo;
    this.fills = fills;
    this.placement = this.placePicture();
    this.controls.enableZoom = this.controls.enablePan = photo === null;
    for (const listener of this.listeners) listener();
  }

  // Moves and enlarges the photograph with what is drawn over it; (x, y) stays where it is.
  zoomPhoto(factor, x, y, dx = 0, dy = 0) {
    const smallest = fitPicture(this.view(), this.size.width, this.size.height).scale;
    const scale = Math.min(Math.max(factor * this.placement.scale, smallest), 50 * smallest);
    const change = scale / this.placement.scale;
    this.placement = {
      scale,
      x: x + change * (this.placement.x - x) + dx,
      y: y + change * (this.placement.y - y) + dy,
    };
    this.project();
    this.onMove();
  }

  state() {
    return {
      position: this.camera.position.clone(),
      orientation: this.camera.quaternion.clone(),
      target: this.controls.target.clone(),
      opening: this.camera.fov,
      photo: this.photo,
      fills: this.fills,
    };
  }

  remember(state = this.state()) {
    this.history.push(state);
    if (this.history.length > MAX_HISTORY) this.history.shift();
  }

  back() {
    const state = this.history.pop();
    if (state) this.fly(state);
  }

  home() {
    this.remember();
    this.fly(this.homeState());
  }

  homeState() {
    const { drawing, camera } = this;
    const center = drawing.box.getCenter(new Vector3());
    const mean = new Vector3();
    for (const view of drawing.views) mean.add(new Vector3(...view.position).sub(center));
    // From where the cameras were, a little above.
    mean.addScaledVector(camera.up, -mean.dot(camera.up));
    if (!(mean.length() > 1e-6 * drawing.radius)) {
      mean.crossVectors(camera.up, new Vector3(0.3, 0.9, 0.2));
    }
    const direction = mean.normalize().addScaledVector(camera.up, 0.6).normalize();
    return this.stateFrom(center, direction, drawing.radius);
  }

  // At something of this radius, from the present direction.
  focus(center, radius) {
    const direction = this.camera.position.clone().sub(this.controls.target).normalize();
    this.remember();
    this.fly(this.stateFrom(center, direction, Math.max(radius, 0.02 * this.drawing.radius)));
  }

  // The state from which a ball is seen as a whole.
  stateFrom(center, direction, radius) {
    const opening = (Math.PI / 180) * OPENING_DEG;
    const narrow = 2 * Math.atan(Math.tan(opening / 2) * Math.min(1, this.camera.aspect));
    const position = center
      .clone()
      .addScaledVector(direction, (1.05 * radius) / Math.sin(narrow / 2));
    const orientation = new Quaternion().setFromRotationMatrix(
      new Matrix4().lookAt(position, center, this.camera.up),
    );
    return { position, orientation, target: center.clone(), opening: OPENING_DEG, photo: null };
  }

  // Through the photograph that sees most of the drawing, as large as the canvas.
  firstState() {
    const view = viewOfMost(this.drawing);
    return view === null ? this.homeState() : { ...this.stateThrough(view), fills: true };
  }

  lookThrough(photo) {
    this.remember();
    this.fly(this.stateThrough(photo));
  }

  stateThrough(photo) {
    const view = this.drawing.views[photo];
    const position = new Vector3(...view.position);
    const orientation = orientationOf(view);
    const ahead = new Vector3(0, 0, -1).applyQuaternion(orientation);
    const depth = this.drawing.box.getCenter(new Vector3()).sub(position).dot(ahead);
    const target = position
      .clone()
      .addScaledVector(ahead, Math.max(depth, 0.1 * this.drawing.radius));
    return { position, orientation, target, opening: OPENING_DEG, photo };
  }

  fly(to) {
    const from = this.state();
    const projection = this.camera.projectionMatrix.clone();
    this.arrive(to);
    const still = window.matchMedia('(prefers-reduced-motion: reduce)').matches;
    if (!still) {
      const end = { ...to, projection: this.camera.projectionMatrix.clone() };
      this.flight = { from: { ...from, projection }, end, start: performance.now() };
    }
    this.onMove();
  }

  arrive(to) {
    this.flight = null;
    this.camera.position.copy(to.position);
    this.camera.quaternion.copy(to.orientation);
    this.controls.target.copy(to.target);
    this.camera.fov = to.opening;
    this.setPhoto(to.photo, to.fills);
    this.project();
    this.camera.updateMatrixWorld();
  }

  // Whether the camera is still on its way.
  advance(time) {
    if (!this.flight) return false;
    const { from, end, start } = this.flight;
    const share = Math.max(0, (time - start) / FLIGHT_MS);
    if (share >= 1) {
      this.arrive(end);
      return true;
    }
    const done = smooth(share);
    this.camera.position.lerpVectors(from.position, end.position, done);
    this.camera.quaternion.slerpQuaternions(from.orientation, end.orientation, done);
    const elements = from.projection.elements.map(
      (value, i) => value + done * (end.projection.elements[i] - value),
    );
    this.setProjection(new Matrix4().fromArray(elements));
    this.camera.updateMatrixWorld();
    return true;
  }

  // Place on the canvas, CSS px, and depth of a point; nothing behind the camera.
  screen(point) {
    const { width, height } = this.size;
    const inCamera = point.clone().applyMatrix4(this.camera.matrixWorldInverse);
    if (inCamera.z >= -this.camera.near) return null;
    const place = inCamera.clone().applyMatrix4(this.camera.projectionMatrix);
    return {
      x: 0.5 * width * (1 + place.x),
      y: 0.5 * height * (1 - place.y),
      depth: -inCamera.z,
    };
  }

  // The point at a place on the canvas, CSS px, and a depth.
  pointAt(x, y, depth) {
    const { width, height } = this.size;
    const place = new Vector3((2 * x) / width - 1, 1 - (2 * y) / height, 0.5);
    const ray = place.applyMatrix4(this.camera.projectionMatrixInverse);
    return ray.multiplyScalar(-depth / ray.z).applyMatrix4(this.camera.matrixWorld);
  }

  // Size of a pixel at distance 1.
  pixelAngle() {
    return 2 / (this.size.height * this.camera.projectionMatrix.elements[5]);
  }
}
