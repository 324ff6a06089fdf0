// SPDX-License-Identifier: BSD-3-Clause
// The curves of the drawing: thin GL lines in one draw call while moving, wide ones at rest. Thin
// lines leave out vertices that nobody would miss from where the reader is.

import { BufferAttribute, BufferGeometry, LineBasicMaterial, LineSegments } from 'three';

import { importanceOf } from './detail.js';
import { WideLines } from './wide_lines.js';

const WIDTH_PX = 1.8;
const SELECTED_WIDTH_PX = 4.5;
const GHOST_WIDTH_PX = 1;
// How far off thin lines may be, px, and where frames are slow.
const COARSE_PX = 0.6;
const COARSEST_PX = 2.4;
// The finest level of detail below all vertices, radii of the drawing; every further level is twice
// as coarse.
const FINEST_LEVEL = 1 / 16384;

// First vertices of the segments of the links that pass.
function segmentsOf(drawing, passes) {
  const segments = new Uint32Array(drawing.numSegments);
  let size = 0;
  for (let link = 0; link < drawing.numLinks; ++link) {
    if (!passes(link)) continue;
    const last = drawing.linkStart[link + 1] - 1;
    for (let vertex = drawing.linkStart[link]; vertex < last; ++vertex) segments[size++] = vertex;
  }
  return segments.subarray(0, size);
}

export class Curves {
  constructor(drawing, scene) {
    this.drawing = drawing;
    const material = new LineBasicMaterial({ vertexColors: true });
    this.thin = new LineSegments(new BufferGeometry(), material);
    this.thin.frustumCulled = false;
    scene.add(this.thin);
    this.wide = new WideLines({ width: WIDTH_PX, withColors: true, isRound: false }, scene);
    this.selected = new WideLines(
      { width: SELECTED_WIDTH_PX, depthTest: false, renderOrder: 2 },
      scene,
    );
    this.selected.visible = false;
    this.ghosts = new WideLines({ width: GHOST_WIDTH_PX, isRound: false }, scene);
    this.coarsePx = COARSE_PX;
    this.shown = true;
    this.load();
  }

  // Call it when the drawing has other links.
  load() {
    const { drawing } = this;
    this.numLoaded = drawing.numLinks;
    this.importance = importanceOf(drawing, this.importance);
    this.colors = new Uint8Array(3 * drawing.numVertices);
    this.thin.geometry.dispose();
    this.thin.geometry = new BufferGeometry();
    this.thin.geometry.setAttribute('position', new BufferAttribute(drawing.points, 3));
    this.thin.geometry.setAttribute('color', new BufferAttribute(this.colors, 3, true));
    const segments = segmentsOf(drawing, () => true);
    this.wide.setLines({ positions: drawing.points, segments });
    this.isOn = new Uint8Array(drawing.numLinks).fill(1);
    this.selected.shareLines(this.wide);
    this.ghosts.shareLines(this.wide);
    this.showLinks();
  }

  // Call it when the set of shown links has changed.
  showLinks() {
    const { drawing } = this;
    this.levels = new Map();
    for (let link = 0; link < drawing.numLinks; ++link) {
      const isOn = drawing.isShown(link) ? 1 : 0;
      if (isOn !== this.isOn[link]) this.switchLink(link, isOn);
    }
    this.ghosts.visible = this.shown && drawing.withGhosts;
    if (drawing.withGhosts) {
      this.ghosts.setSegments(segmentsOf(drawing, (link) => drawing.isGhost(link)));
    }
  }

  switchLink(link, isOn) {
    const [begin, end] = this.drawing.range(link);
    this.wide.switchSegments(begin - link, end - begin - 1, begin, isOn);
    this.isOn[link] = isOn;
  }

  // Pairs of vertices without those that a polyline within the level's tolerance does without.
  endsAt(level) {
    const { drawing, importance } = this;
    const tolerance = level < 0 ? -1 : FINEST_LEVEL * drawing.radius * 2 ** level;
    const ends = new Uint32Array(2 * drawing.numSegments);
    let size = 0;
    for (let link = 0; link < drawing.numLinks; ++link) {
      if (!drawing.isShown(link)) continue;
      const [begin, end] = drawing.range(link);
      for (let vertex = begin + 1, previous = begin; vertex < end; ++vertex) {
        if (!(importance[vertex] > tolerance)) continue;
        ends[size++] = previous;
        ends[size++] = vertex;
        previous = vertex;
      }
    }
    return new BufferAttribute(ends.slice(0, size), 1);
  }

  // The coarsest level that is good enough for what is nearest; -1: all vertices.
  levelFor(eye) {
    const near = this.drawing.box.distanceToPoint(eye.camera.position);
    const tolerance = this.coarsePx * near * eye.pixelAngle();
    const level = Math.floor(Math.log2(tolerance / (FINEST_LEVEL * this.drawing.radius)));
    return Math.max(level, -1);
  }

  setLevel(level) {
    if (!this.levels.has(level)) this.levels.set(level, this.endsAt(level));
    this.thin.geometry.setIndex(this.levels.get(level));
  }

  setColors(colors) {
    this.colors.set(colors);
    this.thin.geometry.attributes.color.needsUpdate = true;
    this.wide.setColors(colors);
  }

  adapt(pace) {
    if (pace < 0) this.coarsePx = Math.min(1.2 * this.coarsePx, COARSEST_PX);
    if (pace > 0) this.coarsePx = Math.max(this.coarsePx / 1.1, COARSE_PX);
  }

  setFine(fine, eye) {
    if (!fine) this.setLevel(this.levelFor(eye));
    this.thin.visible = this.shown && !fine;
    this.wide.visible = this.shown && fine;
    this.ghosts.visible = this.shown && this.drawing.withGhosts;
  }

  // `links`: a set.
  select(links, color) {
    this.selected.visible = links.size > 0;
    if (links.size === 0) return;
    this.selected.setSegments(segmentsOf(this.drawing, (link) => links.has(link)));
    this.selected.setTint(color);
  }
}
