// SPDX-License-Identifier: BSD-3-Clause
// Which tool of editing the pointer has, and its marks on the picture.

import { make } from './dom.js';
import { DimensionTool, JoinTool, SplitTool } from './edit_tools.js';

const TOOLS = { split: SplitTool, join: JoinTool, dimension: DimensionTool };
const BOX_HINT = 'Box: drag to the right for links inside, to the left for those touched.';

export class Pointing {
  // on.edit(edit), on.say(text), on.begin() before a tool is chosen, on.change() when another tool has
  // been, on.progress() when what it has so far is to be drawn anew.
  constructor({ drawing, picking, eye, canvas, marks, on }) {
    Object.assign(this, { drawing, picking, eye, canvas, on });
    this.name = null; // of the tool: box, split, join or dimension
    this.tool = null; // takes taps; the box does not
    this.marks = make('div');
    marks.append(this.marks);
  }

  toggle(name) {
    if (this.name !== name) this.on.begin();
    this.start(this.name === name ? null : name);
  }

  start(name) {
    const { drawing, picking, eye } = this;
    const Tool = TOOLS[name];
    this.name = name;
    this.tool = Tool ? new Tool({ drawing, picking, eye, on: this.listener() }) : null;
    this.canvas.classList.toggle('pointing', name !== null);
    this.on.change();
    this.showProgress();
  }

  listener() {
    return {
      edit: (edit) => {
        this.on.edit(edit);
        this.showProgress();
      },
      progress: () => this.showProgress(),
      say: (text) => this.on.say(text),
    };
  }

  showProgress() {
    this.on.say(this.name === 'box' ? BOX_HINT : (this.tool?.hint() ?? ''));
    this.on.progress();
  }

  // Whether a tool has taken the tap.
  tap(x, y, radius) {
    if (!this.tool) return false;
    this.tool.tap(x, y, radius);
    return true;
  }

  moveTo(x, y, radius) {
    if (!this.tool) return;
    this.tool.moveTo(x, y, radius);
    if (this.pending()) this.on.progress();
    this.update();
  }

  // The length that is being placed: {from, to, shift}, or null.
  pending() {
    return this.tool?.pending?.() ?? null;
  }

  // Before every frame: the marks on the screen.
  update() {
    const { places = [], hover = null } = this.tool ?? {};
    const marks = (hover ? [...places, hover] : places).map((found) => this.mark(found));
    this.marks.replaceChildren(...marks.filter((mark) => mark !== null));
  }

  mark({ position, end }) {
    const place = this.eye.screen(position);
    if (!place) return null;
    const mark = make('div', { class: end === undefined ? 'snap free' : 'snap' });
    mark.style.left = `${place.x}px`;
    mark.style.top = `${place.y}px`;
    return mark;
  }
}
