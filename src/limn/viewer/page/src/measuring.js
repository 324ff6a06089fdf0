// SPDX-License-Identifier: BSD-3-Clause
// The two-point measuring tool.

import { Vector3 } from 'three';

import { make } from './dom.js';
import { measured } from './format.js';
import { sigmaBetween } from './uncertainty.js';
import { joined, WideLines } from './wide_lines.js';

const WIDTH_PX = 2.5;

export class Measuring {
  constructor({ drawing, eye, picking, scene, marks, canvas }) {
    Object.assign(this, { drawing, eye, picking, marks, canvas });
    this.active = false;
    this.points = [];
    this.hover = null;
    this.onChange = () => {};
    this.line = new WideLines({ width: WIDTH_PX, depthTest: false, renderOrder: 3 }, scene);
    this.line.visible = false;
  }

  setColor(color) {
    this.line.setTint(color);
  }

  setActive(active) {
    this.active = active;
    this.canvas.classList.toggle('measuring', active);
    this.hover = null;
    this.setPoints([]);
  }

  // Takes the first point, then the second, then begins again.
  click(x, y, radius) {
    const found = this.picking.snap(x, y, radius);
    if (!found) return false;
    this.setPoints(this.points.length === 2 ? [found] : [...this.points, found]);
    return true;
  }

  moveTo(x, y, radius) {
    this.hover = this.picking.snap(x, y, radius);
  }

  setPoints(points) {
    this.points = points;
    this.line.visible = points.length === 2;
    if (points.length === 2) {
      this.sigma = sigmaBetween(this.drawing, points[0], points[1]);
      this.line.setLines(joined([points.map(({ position }) => position.toArray())]));
    }
    this.onChange();
  }

  // {from, to, delta, distance, sigma} in the model's units, or null.
  result() {
    if (this.points.length < 2) return null;
    const [from, to] = this.points;
    const delta = new Vector3().subVectors(to.position, from.position);
    return { from, to, delta, distance: delta.length(), sigma: this.sigma };
  }

  // Before every frame: the marks on the screen.
  update() {
    const all = this.hover ? [...this.points, this.hover] : this.points;
    const marks = all.map(({ position, node }) => this.mark(position, node !== undefined));
    const result = this.result();
    if (result) marks.push(this.label(result));
    this.marks.replaceChildren(...marks.filter((mark) => mark !== null));
  }

  mark(position, isNode) {
    const place = this.eye.screen(position);
    if (!place) return null;
    const mark = make('div', { class: isNode ? 'snap' : 'snap free' });
    mark.style.left = `${place.x}px`;
    mark.style.top = `${place.y}px`;
    return mark;
  }

  label({ from, to, distance, sigma }) {
    const place = this.eye.screen(from.position.clone().lerp(to.position, 0.5));
    if (!place) return null;
    const label = make('div', { class: 'distance' }, measured(distance, sigma));
    label.style.left = `${place.x}px`;
    label.style.top = `${place.y}px`;
    return label;
  }
}
