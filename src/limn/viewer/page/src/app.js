// SPDX-License-Identifier: BSD-3-Clause
// The page: puts the parts together and carries what the reader does from one to the others.

import { Vector3 } from 'three';

import { Backdrop } from './backdrop.js';
import { schemesFor } from './colors.js';
import { commandsOf } from './commands.js';
import { make } from './dom.js';
import { download } from './download.js';
import { Drawing } from './drawing.js';
import { DrawingPanel } from './drawing_panel.js';
import { Editor } from './editor.js';
import { Eye } from './eye.js';
import { isOlderThanFile } from './freshness.js';
import { watchPhotoGestures, watchTaps } from './gestures.js';
import { Help } from './help.js';
import { watchKeys } from './keyboard.js';
import { Layers } from './layers.js';
import { LinksPanel } from './links_panel.js';
import { Measuring } from './measuring.js';
import { Notices } from './notices.js';
import { overlayGrid } from './overlays.js';
import { PhotoBar } from './photo_bar.js';
import { Photos } from './photos.js';
import { Picking } from './picking.js';
import { reportPanel } from './report.js';
import { Selection } from './selection.js';
import { Sidebar } from './sidebar.js';
import { Stage } from './stage.js';
import { Theme } from './theme.js';

const PICK_PX = 8;
const SNAP_PX = 12;
// A finger is less exact than a mouse.
const TOUCH_FACTOR = 2.5;

const element = (id) => document.getElementById(id);

export class App {
  constructor({ header, arrays }) {
    this.drawing = new Drawing(header, arrays);
    this.selection = new Selection();
    this.scheme = null;
    this.schemes = schemesFor(this.drawing);
    document.title = `${header.title} - Limn`;
    this.makePicture();
    this.makeEditor();
    this.makePanels(header.report);
    this.commands = commandsOf(this);
    this.makeTools();
    this.watch();
    this.setScheme(this.schemes[0].id);
    this.applyTheme();
    this.eye.arrive(this.eye.firstState());
    this.stage.move();
    this.editor.offerKept();
    this.whenChecked = this.checkFreshness(); // for scripts
  }

  async checkFreshness() {
    const { stamp } = this.drawing;
    if (!(await isOlderThanFile(stamp))) return;
    const text = `This page is older than ${stamp.name}: limn drawing_viewer makes it anew.`;
    this.notices.add(text, [{ label: 'Close', run: () => {} }]);
  }

  makePicture() {
    const { drawing } = this;
    const canvas = element('canvas');
    this.eye = new Eye(canvas, drawing);
    this.stage = new Stage(canvas, this.eye);
    this.photos = new Photos(drawing);
    this.layers = new Layers(drawing, this.stage, this.photos);
    this.backdrop = new Backdrop(this.photos, this.stage.backdrop, () => this.stage.change());
    this.picking = new Picking(drawing, this.eye);
    this.picking.depthAt = (x, y) => this.layers.faces.hidingDepth(x, y, this.eye);
    this.measuring = new Measuring({
      ...{ drawing, canvas, eye: this.eye, picking: this.picking },
      ...{ scene: this.stage.near, marks: element('marks') },
    });
    this.stage.beforeFrame.push(
      (fine) => this.layers.frusta.update(this.eye, fine),
      () => this.backdrop.update(this.eye),
      () => this.measuring.update(),
    );
  }

  makeEditor() {
    const { drawing, eye, picking, stage, layers, selection } = this;
    this.notices = new Notices(element('notices'));
    this.editor = new Editor({
      ...{ drawing, eye, picking, stage, layers, selection },
      ...{ canvas: element('canvas'), marks: element('edit-marks') },
      on: {
        change: (hasNewLinks) => this.afterEdits(hasNewLinks),
        say: (text, isError) => this.say(text, isError),
        tool: () => this.measuring.active && this.toggleMeasuring(),
        offer: (text, answers) => this.notices.add(text, answers),
      },
    });
    this.selection.onChange = () => this.showSelection();
    this.stage.beforeFrame.push(() => this.editor.update());
  }

  makePanels(report) {
    const { drawing } = this;
    const look = (view) => this.lookThrough(view);
    this.drawingPanel = new DrawingPanel(drawing, this.schemes, this.layers.list, {
      scheme: (id) => this.setScheme(id),
      detail: (detail) => this.setDetail(detail),
      layer: (id, shown) => this.setLayer(id, shown),
      category: (type, shown) => this.setCategory(type, shown),
    });
    this.linksPanel = new LinksPanel(drawing, {
      pick: (link) => this.pick(link),
      focus: (link) => this.focusLink(link),
      view: look,
    });
    const tabs = [
      { id: 'drawing', label: 'Drawing', content: this.drawingPanel.content },
      { id: 'links', label: 'Links', content: this.linksPanel.content },
      { id: 'edit', label: 'Edit', content: this.editor.panel.content },
    ];
    const hasViews = drawing.views.length > 0;
    if (hasViews) {
      const content = [overlayGrid(drawing, this.photos, look)];
      tabs.push({ id: 'views', label: 'Views', content });
    }
    if (report) {
      const overlays = hasViews ? overlayGrid(drawing, this.photos, look) : null;
      const content = reportPanel(report, drawing.stamp, overlays);
      tabs.push({ id: 'report', label: 'Report', content, isWide: true });
    }
    this.sidebar = new Sidebar(element('sidebar'), tabs);
    this.photoBar = new PhotoBar(element('photo-bar'), this.backdrop.opacity, {
      step: (step) => this.stepPhoto(step),
      opacity: (value) => this.setOpacity(value),
      leave: () => this.eye.home(),
    });
  }

  makeTools() {
    const tools = this.commands.filter(({ tool }) => tool);
    this.tools = new Map(
      tools.map(({ tool, label, keys, run }) => [
        tool,
        make('button', { type: 'button', title: `${label} (${keys[0]})`, onclick: run }, tool),
      ]),
    );
    this.tools.get('Measure').setAttribute('aria-pressed', 'false');
    element('toolbar').append(...this.tools.values());
    this.help = new Help(element('help'), this.commands, this.drawing.unit);
    this.theme = new Theme();
  }

  watch() {
    this.theme.onChange = () => this.applyTheme();
    this.eye.onMove = () => this.stage.move();
    this.eye.onPhoto(() => this.photoBar.show(this.eye.photo === null ? null : this.eye.view()));
    this.measuring.onChange = () => this.showMeasurement();
    watchTaps(element('canvas'), {
      tap: (x, y, isTouch, adds) => this.tap(x, y, isTouch ? TOUCH_FACTOR : 1, adds),
      doubleTap: (x, y, isTouch) => this.doubleTap(x, y, isTouch ? TOUCH_FACTOR : 1),
      hover: (x, y) => this.hover(x, y),
    });
    watchPhotoGestures(element('canvas'), {
      isActive: () => this.eye.photo !== null && !this.eye.flight,
      zoom: (...change) => this.eye.zoomPhoto(...change),
    });
    watchKeys(this.commands, () => element('help').open);
  }

  tap(x, y, factor, withShift) {
    if (this.measuring.active) {
      this.measuring.click(x, y, factor * SNAP_PX);
      return;
    }
    if (this.editor.pointing.tap(x, y, factor * SNAP_PX)) return;
    const adds = withShift || this.editor.adding;
    const link = this.layers.isShown('drawing') ? this.picking.link(x, y, factor * PICK_PX) : null;
    const camera = this.layers.frusta.pick(x, y, this.eye);
    if (adds) this.addPick(link?.link ?? null);
    else if (camera && !(link && link.depth < camera.depth)) this.lookThrough(camera.view);
    else this.pick(link?.link ?? null);
  }

  doubleTap(x, y, factor) {
    if (this.editor.pointing.tap(x, y, factor * SNAP_PX)) return;
    const found = this.measuring.active ? null : this.picking.link(x, y, factor * PICK_PX);
    if (found) this.focusLink(found.link);
  }

  hover(x, y) {
    this.editor.pointing.moveTo(x, y, SNAP_PX);
    if (!this.measuring.active) return;
    this.measuring.moveTo(x, y, SNAP_PX);
    this.measuring.update();
  }

  // The link that is selected, if it is one.
  get picked() {
    return this.selection.only;
  }

  pick(link) {
    this.selection.set(link === null ? [] : [link]);
    if (link !== null && !this.sidebar.isShown('edit')) this.sidebar.show('links');
  }

  // One more link, or one less.
  addPick(link) {
    if (link !== null) this.selection.toggle(link);
  }

  showSelection() {
    this.layers.curves.select(this.selection.links, this.theme.color('select'));
    this.linksPanel.show(this.picked);
    this.editor.showSelection();
    this.stage.change();
  }

  say(text, isError = false) {
    element('message').classList.toggle('error', isError);
    element('message').textContent = text;
  }

  focusLink(link) {
    if (link === null) return;
    this.pick(link);
    const box = this.drawing.linkBox(link);
    this.eye.focus(box.getCenter(new Vector3()), 0.75 * box.getSize(new Vector3()).length());
  }

  focusSearch() {
    this.sidebar.show('links');
    this.linksPanel.search.focus();
  }

  lookThrough(view) {
    this.eye.lookThrough(view);
  }

  stepPhoto(step) {
    const { length } = this.drawing.views;
    if (length === 0) return;
    const from = this.eye.photo ?? (step > 0 ? -1 : 0);
    this.lookThrough((from + step + length) % length);
  }

  setOpacity(opacity) {
    this.backdrop.opacity = opacity;
    this.stage.change();
  }

  setScheme(id) {
    this.scheme = this.schemes.find((scheme) => scheme.id === id);
    this.drawing.visible.set(this.drawing.shownAtFirst());
    this.showLinks();
    this.recolor();
  }

  setDetail(detail) {
    this.drawing.detail = detail;
    this.setScheme(this.scheme.id);
  }

  // When others are visible.
  showLinks() {
    this.layers.curves.showLinks();
    this.layers.showNodes();
    this.stage.change();
  }

  // Kinds change colors, and all edits the shares in a legend.
  afterEdits(hasNewLinks) {
    if (!this.scheme) return; // at the start
    if (hasNewLinks || this.legend.entries) this.recolor();
    this.linksPanel.rank();
  }

  recolor() {
    const { colors, legend } = this.scheme.apply(this.drawing);
    this.legend = legend;
    this.layers.curves.setColors(colors);
    this.drawingPanel.showScheme(this.scheme.id, legend);
  }

  stepScheme() {
    const next = (this.schemes.indexOf(this.scheme) + 1) % this.schemes.length;
    this.setScheme(this.schemes[next].id);
  }

  // Links of one entry of the legend.
  setCategory(type, shown) {
    this.legend.types.forEach((of, link) => {
      if (of === type) this.drawing.visible[link] = shown ? 1 : 0;
    });
    this.showLinks();
  }

  setLayer(id, shown) {
    this.layers.set(id, shown);
    this.drawingPanel.showLayer(id, shown);
    this.stage.change();
  }

  toggleMeasuring() {
    if (!this.measuring.active) this.editor.pointing.start(null);
    this.measuring.setActive(!this.measuring.active);
    this.tools.get('Measure').setAttribute('aria-pressed', String(this.measuring.active));
    if (this.measuring.active) this.sidebar.show('drawing');
  }

  showMeasurement() {
    this.drawingPanel.showMeasurement(this.measuring.active, this.measuring.result());
    this.stage.change();
  }

  async savePicture() {
    const name = this.drawing.title.replace(/[^\w.-]+/g, '_');
    download(await this.stage.picture(), `${name}.png`);
  }

  escape() {
    if (this.measuring.active) this.toggleMeasuring();
    else if (this.editor.pointing.name) this.editor.pointing.start(null);
    else if (this.selection.size > 0) this.pick(null);
    else if (this.eye.photo !== null) this.eye.home();
  }

  applyTheme() {
    this.stage.setBackground(this.theme.color('stage'));
    this.layers.frusta.setColor(this.theme.color('faint'));
    this.measuring.setColor(this.theme.color('select'));
    this.layers.curves.select(this.selection.links, this.theme.color('select'));
    this.editor.setColors(...['select', 'ghost', 'accent'].map((name) => this.theme.color(name)));
    this.stage.change();
  }

  // For scripts: the place on the canvas, CSS px, of a point as coordinates are displayed.
  screenOf(point) {
    return this.eye.screen(this.drawing.fromDisplayed(point));
  }
}
