// SPDX-License-Identifier: BSD-3-Clause
// Lengths written into the picture: those of drawing.json and those that edits add.

import { make } from './dom.js';
import { measured } from './format.js';
import { sigmaOfDimension } from './uncertainty.js';
import { joined, WideLines } from './wide_lines.js';

const WIDTH_PX = 1.6;

// Its length, with its standard deviation.
export function lengthText(drawing, dimension) {
  const { from, to } = dimension;
  return measured(from.distanceTo(to), sigmaOfDimension(drawing, dimension));
}

// {from, to, shift} of each dimension of the payload.
export function storedDimensions(values, vectorAt) {
  return Array.from({ length: values.length / 9 }, (_, i) => ({
    from: vectorAt(values, 9 * i),
    to: vectorAt(values, 9 * i + 3),
    shift: vectorAt(values, 9 * i + 6),
  }));
}

// The line itself and what leads to it from the places.
function polylines({ from, to, shift }) {
  const [start, end] = [from.clone().add(shift), to.clone().add(shift)];
  const lines = [[start, end]];
  if (shift.lengthSq() > 0) lines.push([from, start], [to, end]);
  return lines.map((line) => line.map((point) => point.toArray()));
}

export class Dimensions {
  constructor(drawing, eye, scene, marks) {
    Object.assign(this, { drawing, eye, marks });
    this.lines = new WideLines({ width: WIDTH_PX, depthTest: false, renderOrder: 3 }, scene);
    this.lines.visible = false;
    this.list = [];
    this.labels = [];
  }

  setColor(color) {
    this.lines.setTint(color);
  }

  show(list) {
    this.list = list;
    this.lines.visible = list.length > 0;
    if (list.length > 0) this.lines.setLines(joined(list.flatMap(polylines)));
    this.labels.forEach((label) => label.remove());
    this.labels = list.map((dimension) =>
      make('div', { class: 'dimension' }, lengthText(this.drawing, dimension)),
    );
    this.marks.append(...this.labels);
  }

  // Before every frame.
  update() {
    this.list.forEach(({ from, to, shift }, i) => {
      const place = this.eye.screen(from.clone().lerp(to, 0.5).add(shift));
      this.labels[i].hidden = place === null;
      if (!place) return;
      this.labels[i].style.left = `${place.x}px`;
      this.labels[i].style.top = `${place.y}px`;
    });
  }
}
