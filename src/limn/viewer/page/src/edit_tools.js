// SPDX-License-Identifier: BSD-3-Clause
// Tools that edit by pointing: each takes taps, says what to do next and tells which places it has and
// which one a tap would take. `on.edit(edit)` hands over what is complete; `on.say(text)` tells why
// nothing happens.

import { Vector3 } from 'three';

import { canJoin, dimensioning, joining, splitting } from './edits.js';

const NO_LINK = 'There is no curve here.';
const AT_END =
  'This is an end of the curve: it is cut only 2 px of the photographs or more from there.';

// Curves that are deleted but shown are not to be edited.
const live = (drawing, found) => (found && drawing.isLive(found.link) ? found : null);

export class SplitTool {
  constructor({ drawing, picking, on }) {
    Object.assign(this, { drawing, picking, on });
    this.places = [];
    this.hover = null;
  }

  hint() {
    return 'Split: pick the place on a curve.';
  }

  moveTo(x, y, radius) {
    this.hover = live(this.drawing, this.picking.link(x, y, radius));
  }

  tap(x, y, radius) {
    const found = live(this.drawing, this.picking.link(x, y, radius));
    if (!found) return this.on.say(NO_LINK);
    const edit = splitting(this.drawing, found.link, found.position);
    return edit ? this.on.edit(edit) : this.on.say(AT_END);
  }
}

export class JoinTool {
  constructor({ drawing, picking, on }) {
    Object.assign(this, { drawing, picking, on });
    this.places = [];
    this.hover = null;
  }

  hint() {
    if (this.places.length === 0) return 'Join: pick an end of a curve.';
    return `Join: pick the end that this end of link ${this.places[0].link} goes to.`;
  }

  find(x, y, radius) {
    return live(this.drawing, this.picking.end(x, y, radius));
  }

  moveTo(x, y, radius) {
    this.hover = this.find(x, y, radius);
  }

  tap(x, y, radius) {
    const found = this.find(x, y, radius);
    if (!found) return this.on.say('There is no end of a curve here.');
    const [first] = this.places;
    if (!first) {
      this.places = [found];
      return this.on.progress();
    }
    const places = [first, found];
    const links = places.map(({ link }) => link);
    const ends = places.map(({ end }) => end);
    if (!canJoin(this.drawing, links, ends)) return this.on.say('These two ends meet already.');
    this.places = [];
    return this.on.edit(joining(this.drawing, links, ends));
  }
}

// Two places, then where the line is to be.
export class DimensionTool {
  constructor({ drawing, picking, eye, on }) {
    Object.assign(this, { drawing, picking, eye, on });
    this.places = [];
    this.hover = null;
    this.shift = new Vector3();
  }

  hint() {
    const steps = [
      'Length: pick a place on a curve.',
      'Length: pick the other place.',
      'Length: tap where its line shall be; on the places themselves for no distance.',
    ];
    return steps[this.places.length];
  }

  find(x, y, radius) {
    return live(this.drawing, this.picking.place(x, y, radius));
  }

  moveTo(x, y, radius) {
    if (this.places.length < 2) this.hover = this.find(x, y, radius);
    else this.shift = this.shiftAt(x, y, radius);
  }

  tap(x, y, radius) {
    if (this.places.length === 2) return this.finish(this.shiftAt(x, y, radius));
    const found = this.find(x, y, radius);
    if (!found) return this.on.say(NO_LINK);
    const [first] = this.places;
    if (first && first.position.distanceTo(found.position) < 1e-7 * this.drawing.radius) {
      return this.on.say('This is the same place.');
    }
    this.places = [...this.places, found];
    this.hover = null;
    this.shift = new Vector3();
    return this.on.progress();
  }

  // The length that is being placed: {from, to, shift}, or null.
  pending() {
    if (this.places.length < 2) return null;
    const [from, to] = this.places.map(({ position }) => position);
    return { from, to, shift: this.shift };
  }

  finish(shift) {
    const links = this.places.map(({ link }) => link);
    const shown = { ...this.pending(), shift };
    this.places = [];
    this.on.edit(dimensioning(this.drawing, links, shown));
  }

  // Across the line, as far from it as the pointer is; zero near it.
  shiftAt(x, y, radius) {
    const [from, to] = this.places.map(({ position }) => position);
    const middle = from.clone().lerp(to, 0.5);
    const place = this.eye.screen(middle);
    if (!place) return new Vector3();
    const along = to.clone().sub(from).normalize();
    const shift = this.eye.pointAt(x, y, place.depth).sub(middle);
    shift.addScaledVector(along, -shift.dot(along));
    const moved = this.eye.screen(middle.clone().add(shift));
    const isNear = moved && Math.hypot(moved.x - place.x, moved.y - place.y) < radius;
    return isNear ? new Vector3() : shift;
  }
}
