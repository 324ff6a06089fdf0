// SPDX-License-Identifier: BSD-3-Clause
// The picture: what is drawn, and when. Nothing is drawn while nothing changes. While something
// moves frames are coarse (thin lines, fewer points); a moment after it stops one fine frame follows.

import { Color, ColorManagement, LinearSRGBColorSpace, Scene, WebGLRenderer } from 'three';

const REST_MS = 140;
// Coarse frames that take longer should show less; those that take less may show more.
const SLOW_MS = 45;
const FAST_MS = 25;
const MAX_FRAME_MS = 1000;
// More pixels than this per CSS pixel cost much and show little.
const MAX_PIXEL_RATIO = 2;

ColorManagement.enabled = false;

export class Stage {
  // `eye` gives the camera (eye.js). Layers add objects to the scenes: `far` lies behind `near`
  // whatever its depth.
  constructor(canvas, eye) {
    this.canvas = canvas;
    this.eye = eye;
    this.renderer = new WebGLRenderer({ canvas, antialias: false, alpha: false });
    this.renderer.outputColorSpace = LinearSRGBColorSpace;
    this.renderer.autoClear = false;
    this.backdrop = new Scene();
    this.far = new Scene();
    this.near = new Scene();
    this.layers = [];
    this.beforeFrame = [];
    this.previousStart = -Infinity;
    this.fine = false;
    this.frameRequest = 0;
    this.lastChange = -Infinity;
    this.resting = [];
    new ResizeObserver(() => this.resize()).observe(canvas);
    this.resize();
  }

  // A layer may have setFine(bool, eye) and adapt(pace), which gets -1 if coarse frames are slow
  // and 1 if they are fast.
  addLayer(layer) {
    this.layers.push(layer);
  }

  setBackground(color) {
    this.renderer.setClearColor(new Color(color), 1);
    this.change();
  }

  resize() {
    const { clientWidth: width, clientHeight: height } = this.canvas;
    if (width === 0 || height === 0) return;
    this.renderer.setPixelRatio(Math.min(window.devicePixelRatio, MAX_PIXEL_RATIO));
    this.renderer.setSize(width, height, false);
    this.eye.resize(width, height);
    this.move();
  }

  // Something else is to be seen, from the same place: one fine frame.
  change() {
    this.request();
  }

  // The place moves: coarse frames until it rests.
  move() {
    this.lastChange = performance.now();
    this.request();
  }

  request() {
    this.fine = false;
    if (this.frameRequest === 0) {
      this.frameRequest = requestAnimationFrame((time) => this.frame(time));
    }
  }

  frame(time) {
    this.frameRequest = 0;
    if (this.eye.advance(time)) this.lastChange = performance.now();
    const moving = performance.now() - this.lastChange < REST_MS;
    const start = performance.now();
    this.draw(!moving);
    if (moving) {
      this.adapt(start);
      this.frameRequest = requestAnimationFrame((next) => this.frame(next));
    } else {
      this.fine = true;
      this.resting.splice(0).forEach((resolve) => resolve());
    }
  }

  // Time between frames says more than that of a call, since GL works behind our back.
  adapt(start) {
    const ms = start - this.previousStart;
    this.previousStart = start;
    if (ms > MAX_FRAME_MS) return; // there was a rest
    const pace = ms > SLOW_MS ? -1 : ms < FAST_MS ? 1 : 0;
    for (const layer of this.layers) layer.adapt?.(pace);
  }

  draw(fine) {
    for (const layer of this.layers) layer.setFine?.(fine, this.eye);
    for (const update of this.beforeFrame) update(fine);
    const { renderer, eye } = this;
    renderer.clear();
    renderer.render(this.backdrop, eye.camera);
    renderer.clearDepth();
    renderer.render(this.far, eye.camera);
    renderer.clearDepth();
    renderer.render(this.near, eye.camera);
  }

  // Resolves when a fine frame of the present state has been drawn.
  atRest() {
    if (this.fine) return Promise.resolve();
    this.request();
    return new Promise((resolve) => this.resting.push(resolve));
  }

  // The fine picture as a PNG file.
  picture() {
    this.draw(true);
    return new Promise((resolve, reject) => {
      this.canvas.toBlob(
        (blob) => (blob ? resolve(blob) : reject(new Error('the picture cannot be made'))),
        'image/png',
      );
    });
  }
}
