// SPDX-License-Identifier: BSD-3-Clause
// Editing: the list of edits, the tools that add to it, and what is shown of them.

import { watchBoxes } from './box_tool.js';
import { Dimensions } from './dimensions.js';
import { make } from './dom.js';
import { editCommands } from './edit_commands.js';
import { EditHistory } from './edit_history.js';
import { EditPreview } from './edit_preview.js';
import { EditState } from './edit_state.js';
import * as edits from './edits.js';
import { EditsPanel } from './edits_panel.js';
import { EditsStorage } from './edits_storage.js';
import { count, moment } from './format.js';
import { KeptEdits } from './kept_edits.js';
import { placeOf } from './link_refs.js';
import { Pointing } from './pointing.js';
import { linksInRectangle, linksOfKind, linksShorterThan } from './selection.js';

export class Editor {
  // on.change(whether there are new links), on.say(text, isError), on.tool() before one of ours begins,
  // on.offer(text, answers).
  constructor({ drawing, eye, picking, stage, layers, selection, canvas, marks, on }) {
    Object.assign(this, { drawing, eye, picking, stage, layers, selection, canvas, marks, on });
    this.history = new EditHistory();
    this.state = new EditState(drawing);
    this.preview = new EditPreview(stage.near);
    this.adding = false;
    this.storage = new EditsStorage(this);
    this.kept = new KeptEdits(drawing, { trouble: (text) => this.say(text, true) });
    this.tellsSelection = false; // whether the message says how many links are selected
    this.pointing = this.makePointing();
    const labels = make('div');
    marks.append(labels);
    this.dimensions = new Dimensions(drawing, eye, stage.near, labels);
    this.commands = editCommands(this);
    this.panel = new EditsPanel(
      drawing,
      this,
      this.commands.filter(({ button }) => button),
    );
    this.watch();
    this.showTools();
    this.show();
  }

  makePointing() {
    const { drawing, picking, eye, canvas, marks, on } = this;
    return new Pointing({
      ...{ drawing, picking, eye, canvas, marks },
      on: {
        edit: (edit) => this.perform(edit),
        say: (text) => this.say(text),
        begin: () => on.tool(),
        change: () => this.showTools(),
        progress: () => {
          this.drawLengths();
          this.stage.change();
        },
      },
    });
  }

  watch() {
    watchBoxes(this.canvas, this.marks, {
      isActive: (event) => this.pointing.name === 'box' || event.shiftKey,
      hold: (still) => (this.eye.controls.enabled = !still),
      box: (...drawn) => this.selectBox(...drawn),
    });
    window.addEventListener('beforeunload', (event) => {
      if (this.history.isSaved) return;
      event.preventDefault();
      event.returnValue = true; // older browsers
    });
  }

  say(text, isError = false) {
    this.tellsSelection = false;
    this.on.say(text, isError);
  }

  // Edits that were left in the browser when a page was closed.
  offerKept() {
    const [left] = this.kept.left();
    if (!left) return;
    const name = left.count === 1 ? 'edit' : 'edits';
    const changed =
      left.fingerprint === this.kept.fingerprint ? '' : ' The drawing has changed since.';
    this.on.offer(
      `Never downloaded: ${count(left.count)} ${name} of ${moment(left.time)}.${changed}`,
      [
        { label: 'Take up', run: () => this.takeUp(left) },
        { label: 'Discard', run: () => this.discard(left) },
      ],
    );
  }

  takeUp(left) {
    if (this.storage.takeUp(left.text) && this.kept.flush()) this.kept.forget(left);
  }

  discard(left) {
    this.kept.forget(left);
    this.offerKept();
  }

  setColors(color, ghost, accent) {
    this.preview.setColor(color);
    this.dimensions.setColor(accent);
    this.layers.curves.ghosts.setTint(ghost);
  }

  // The list of edits.

  perform(edit) {
    this.setEdits([...this.history.edits, edit]);
  }

  setEdits(list) {
    this.history.set(list);
    this.show();
  }

  undo() {
    if (this.history.undo()) this.afterTravel();
  }

  redo() {
    if (this.history.redo()) this.afterTravel();
  }

  // A tool must not continue with links that no longer exist.
  afterTravel() {
    this.pointing.start(this.pointing.name);
    this.show();
  }

  markSaved() {
    this.history.markSaved();
    this.keep();
    this.panel.showHistory(this.history);
  }

  // Of edits that are in a file none need be kept by the browser.
  keep() {
    const { isSaved, edits: list } = this.history;
    if (isSaved) this.kept.drop();
    else this.kept.keep(list.length, () => this.storage.text());
  }

  // Makes the picture what the edits make of the drawing.
  show() {
    this.keep();
    const { drawing, layers } = this;
    const preview = this.state.show(this.history.edits);
    const isLarger = layers.curves.numLoaded < drawing.numLinks;
    if (isLarger) layers.curves.load();
    else layers.curves.showLinks();
    layers.showNodes();
    this.preview.show(preview);
    this.showLengths(preview);
    this.selection.keep((link) => drawing.isLive(link) || drawing.isGhost(link));
    this.panel.showHistory(this.history);
    this.showSelection();
    this.on.change(isLarger);
    this.stage.change();
  }

  showLengths({ dimensions, removed }) {
    const ofFile = this.drawing.storedDimensions
      .map((dimension, stored) => ({
        ...dimension,
        stored,
        onRemove: () => this.removeStored(stored, dimension),
      }))
      .filter(({ stored }) => !removed.has(stored));
    const ofEdits = dimensions.map((dimension) => ({
      ...dimension,
      onRemove: () => this.setEdits(this.history.edits.filter((edit) => edit !== dimension.edit)),
    }));
    this.lengths = [...ofFile, ...ofEdits];
    this.panel.showLengths(this.lengths);
    this.drawLengths();
  }

  drawLengths() {
    const pending = this.pointing.pending();
    this.dimensions.show(pending ? [...this.lengths, pending] : this.lengths);
  }

  removeStored(stored, { from, to }) {
    const at = [from, to].map((place) => placeOf(this.drawing, place));
    this.perform(edits.dimensionRemoval(stored, at));
  }

  // What is done with the selection.

  selected(passes) {
    return [...this.selection.links].filter(passes).sort((a, b) => a - b);
  }

  liveSelected() {
    return this.selected((link) => this.drawing.isLive(link));
  }

  // Does something with the selected links; says why not.
  withLinks(links, why, makeEdit) {
    if (links.length === 0) this.say(why);
    else this.perform(makeEdit(links));
  }

  remove() {
    const live = this.liveSelected();
    this.withLinks(live, 'Select the links to delete first.', (links) =>
      edits.deletion(this.drawing, links),
    );
    if (live.length > 0) this.selection.keep((link) => this.drawing.isLive(link));
  }

  setKind(kind) {
    this.withLinks(this.liveSelected(), 'Select the links whose kind to set first.', (links) =>
      edits.kindChange(this.drawing, links, kind),
    );
  }

  restorable() {
    const { drawing } = this;
    return {
      deleted: this.selected((link) => drawing.isGhost(link)),
      tentative: this.selected((link) => drawing.isLive(link) && drawing.linkTentative[link] === 1),
    };
  }

  restore() {
    const { deleted, tentative } = this.restorable();
    if (deleted.length + tentative.length === 0) {
      this.say('Select deleted links (Show deleted) or tentative ones first.');
      return;
    }
    const list = edits.undeleted(this.history.edits, new Set(deleted));
    if (tentative.length > 0) list.push(edits.firming(this.drawing, tentative));
    this.setEdits(list);
  }

  merge() {
    const links = this.liveSelected();
    if (links.length !== 2) return this.say('Select the two links to merge first.');
    const edit = edits.merging(this.drawing, links);
    return edit ? this.perform(edit) : this.say('These two links do not run along each other.');
  }

  showSelection() {
    const numLive = this.liveSelected().length;
    const { deleted, tentative } = this.restorable();
    this.panel.showSelection({
      selection: this.selection,
      canDelete: numLive > 0,
      canRestore: deleted.length + tentative.length > 0,
      canMerge: numLive === 2,
    });
    if (this.tellsSelection) this.tellSelection();
  }

  tellSelection() {
    const { size } = this.selection;
    this.say(`${count(size)} ${size === 1 ? 'link' : 'links'} selected.`);
    this.tellsSelection = true;
  }

  // Ways to select.

  select(links, adds = this.adding) {
    if (adds) this.selection.add(links);
    else this.selection.set(links);
    this.tellSelection();
  }

  selectKind(category) {
    this.select(linksOfKind(this.drawing, category));
  }

  selectShorter(length) {
    this.select(linksShorterThan(this.drawing, length));
  }

  selectBox(rectangle, toLeft, withShift) {
    const matrix = this.picking.matrix().elements;
    const links = linksInRectangle(this.drawing, matrix, this.eye.size, rectangle, toLeft);
    this.select(links, this.adding || withShift);
  }

  toggleAdding() {
    this.adding = !this.adding;
    this.showTools();
  }

  toggleGhosts() {
    this.drawing.withGhosts = !this.drawing.withGhosts;
    this.layers.curves.showLinks();
    this.selection.keep((link) => this.drawing.isLive(link) || this.drawing.isGhost(link));
    this.showSelection();
    this.showTools();
    this.stage.change();
  }

  showTools() {
    const { name } = this.pointing;
    this.panel.showTools({
      ...{ Box: name === 'box', Join: name === 'join', Split: name === 'split' },
      ...{ Length: name === 'dimension', Add: this.adding },
      'Show deleted': this.drawing.withGhosts,
    });
  }

  // Before every frame.
  update() {
    this.dimensions.update();
    this.pointing.update();
  }
}
