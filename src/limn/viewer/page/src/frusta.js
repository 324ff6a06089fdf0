// SPDX-License-Identifier: BSD-3-Clause
// The cameras as pyramids with their photographs on them.

import { BufferAttribute, BufferGeometry, DoubleSide, Mesh, MeshBasicMaterial } from 'three';

import { pictureRectangle, pointAtPixel } from './optics.js';
import { joined, WideLines } from './wide_lines.js';

const WIDTH_PX = 1.2;
const SIZE_IN_RADII = 0.1;
// Photographs are shown on pyramids at least this wide, px, and on at most this many.
const LEAST_WIDTH_PX = 12;
const MOST_PICTURES = 300;
const UV = new Float32Array([0, 0, 1, 0, 1, 1, 0, 1]);

function cornersOf(view, length) {
  const { left, top, right, bottom } = pictureRectangle(view);
  const focal = 0.5 * (view.fx + view.fy);
  const depth = Math.min(length, (length * focal) / (right - left));
  return [
    [left, top],
    [right, top],
    [right, bottom],
    [left, bottom],
  ].map(([x, y]) => pointAtPixel(view, x, y, depth));
}

function isInside(polygon, x, y) {
  let inside = false;
  for (let i = 0, j = polygon.length - 1; i < polygon.length; j = i++) {
    const [a, b] = [polygon[i], polygon[j]];
    if (a.y > y !== b.y > y && x < ((b.x - a.x) * (y - a.y)) / (b.y - a.y) + a.x) inside = !inside;
  }
  return inside;
}

export class Frusta {
  constructor(drawing, photos, scene, onLoaded) {
    this.drawing = drawing;
    this.photos = photos;
    this.scene = scene;
    this.onLoaded = onLoaded;
    this.corners = drawing.views.map((view) => cornersOf(view, SIZE_IN_RADII * drawing.radius));
    this.meshes = new Map();
    this.lines = this.makeLines();
    this.shown = true;
  }

  makeLines() {
    const strokes = this.drawing.views.flatMap((view, v) => {
      const [a, b, c, d] = this.corners[v].map((corner) => corner.toArray());
      const tip = view.position;
      return [
        [tip, a, b, c, d, a],
        [b, tip, c],
        [d, tip],
      ];
    });
    const lines = new WideLines({ width: WIDTH_PX }, this.scene);
    lines.setLines(joined(strokes));
    return lines;
  }

  setColor(color) {
    this.lines.setTint(color);
  }

  addPicture(view, texture) {
    const geometry = new BufferGeometry();
    const corners = this.corners[view].flatMap((corner) => corner.toArray());
    geometry.setAttribute('position', new BufferAttribute(new Float32Array(corners), 3));
    geometry.setAttribute('uv', new BufferAttribute(UV, 2));
    geometry.setIndex([0, 1, 2, 0, 2, 3]);
    const mesh = new Mesh(geometry, new MeshBasicMaterial({ map: texture, side: DoubleSide }));
    this.meshes.set(view, mesh);
    this.scene.add(mesh);
  }

  // Before every frame. Looking through a photograph, its pyramid and all others would be in the way.
  update(eye, fine) {
    const visible = this.shown && eye.photo === null;
    this.lines.visible = visible;
    for (const mesh of this.meshes.values()) mesh.visible = visible;
    if (visible && fine) this.loadPictures(eye);
  }

  loadPictures(eye) {
    for (let view = 0; view < this.corners.length; ++view) {
      if (this.meshes.size >= MOST_PICTURES) return;
      if (this.meshes.has(view) || this.widthOnScreen(view, eye) < LEAST_WIDTH_PX) continue;
      const texture = this.photos.texture(view, this.onLoaded);
      if (texture) this.addPicture(view, texture);
    }
  }

  outline(view, eye) {
    const outline = this.corners[view].map((corner) => eye.screen(corner));
    return outline.includes(null) ? null : outline;
  }

  widthOnScreen(view, eye) {
    const outline = this.outline(view, eye);
    if (!outline) return 0;
    const { width, height } = eye.size;
    const isOff = outline.every(({ x, y }) => x < 0 || y < 0 || x > width || y > height);
    return isOff ? 0 : Math.hypot(outline[1].x - outline[0].x, outline[1].y - outline[0].y);
  }

  // The nearest camera whose picture is at a place: {view, depth}, or nothing.
  pick(x, y, eye) {
    if (!this.lines.visible) return null;
    let best = null;
    for (let view = 0; view < this.corners.length; ++view) {
      const outline = this.outline(view, eye);
      if (!outline || !isInside(outline, x, y)) continue;
      const depth = Math.min(...outline.map((corner) => corner.depth));
      if (!best || depth < best.depth) best = { view, depth };
    }
    return best;
  }
}
