// The curves of the drawing: thin GL lines in one draw call while moving, wide ones at rest.

import { BufferAttribute, BufferGeometry, LineBasicMaterial, LineSegments } from 'three';

import { joined, WideLines } from './wide_lines.js';

const WIDTH_PX = 1.8;
const SELECTED_WIDTH_PX = 4.5;

// First vertices of the segments of the links that pass.
function segmentsOf(drawing, passes) {
  const segments = [];
  for (let link = 0; link < drawing.numLinks; ++link) {
    if (!passes(link)) continue;
    const [begin, end] = drawing.range(link);
    for (let vertex = begin; vertex + 1 < end; ++vertex) segments.push(vertex);
  }
  return segments;
}

export class Curves {
  constructor(drawing, scene) {
    this.drawing = drawing;
    this.colors = new Uint8Array(3 * drawing.numVertices);
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(drawing.points, 3));
    geometry.setAttribute('color', new BufferAttribute(this.colors, 3, true));
    this.thin = new LineSegments(geometry, new LineBasicMaterial({ vertexColors: true }));
    this.thin.frustumCulled = false;
    scene.add(this.thin);
    this.wide = new WideLines({ width: WIDTH_PX, withColors: true }, scene);
    this.wide.setLines({ positions: drawing.points, segments: [] });
    this.selected = new WideLines(
      { width: SELECTED_WIDTH_PX, depthTest: false, renderOrder: 2 },
      scene,
    );
    this.selected.visible = false;
    this.shown = true;
    this.showLinks();
  }

  // To be called when drawing.visible has changed.
  showLinks() {
    const segments = segmentsOf(this.drawing, (link) => this.drawing.visible[link]);
    const ends = new Uint32Array(2 * segments.length);
    segments.forEach((vertex, s) => {
      ends[2 * s] = vertex;
      ends[2 * s + 1] = vertex + 1;
    });
    this.thin.geometry.setIndex(new BufferAttribute(ends, 1));
    this.wide.setSegments(segments);
  }

  setColors(colors) {
    this.colors.set(colors);
    this.thin.geometry.attributes.color.needsUpdate = true;
    this.wide.setColors(colors);
  }

  setFine(fine) {
    this.thin.visible = this.shown && !fine;
    this.wide.visible = this.shown && fine;
  }

  select(link, color) {
    this.selected.visible = link !== null;
    if (link === null) return;
    const [begin, end] = this.drawing.range(link);
    const points = Array.from({ length: end - begin }, (_, i) =>
      this.drawing.point(begin + i).toArray(),
    );
    this.selected.setLines(joined([points]));
    this.selected.setTint(color);
  }
}
