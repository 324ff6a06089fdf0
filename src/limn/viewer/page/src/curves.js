// The curves of the drawing: thin GL lines in one draw call while moving, wide ones at rest.

import { BufferAttribute, BufferGeometry, LineBasicMaterial, LineSegments } from 'three';
import { LineMaterial } from 'three/examples/jsm/lines/LineMaterial.js';
import { LineSegments2 } from 'three/examples/jsm/lines/LineSegments2.js';
import { LineSegmentsGeometry } from 'three/examples/jsm/lines/LineSegmentsGeometry.js';

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
  return Uint32Array.from(segments);
}

// Two vertices per segment, three numbers each.
function spread(values, segments, scale = 1) {
  const pairs = new Float32Array(6 * segments.length);
  segments.forEach((vertex, s) => {
    for (let i = 0; i < 6; ++i) pairs[6 * s + i] = scale * values[3 * vertex + i];
  });
  return pairs;
}

export class Curves {
  constructor(drawing, scene) {
    this.drawing = drawing;
    this.colors = new Uint8Array(3 * drawing.numVertices);
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(drawing.points, 3));
    geometry.setAttribute('color', new BufferAttribute(this.colors, 3, true));
    this.thin = new LineSegments(geometry, new LineBasicMaterial({ vertexColors: true }));
    this.wide = new LineSegments2(
      new LineSegmentsGeometry(),
      new LineMaterial({ vertexColors: true, linewidth: WIDTH_PX }),
    );
    this.selected = new LineSegments2(
      new LineSegmentsGeometry(),
      new LineMaterial({ linewidth: SELECTED_WIDTH_PX, depthTest: false }),
    );
    this.selected.renderOrder = 2;
    this.selected.visible = false;
    for (const object of [this.thin, this.wide, this.selected]) {
      object.frustumCulled = false;
      scene.add(object);
    }
    this.shown = true;
    this.showLinks();
  }

  // To be called when drawing.visible has changed.
  showLinks() {
    this.segments = segmentsOf(this.drawing, (link) => this.drawing.visible[link]);
    const ends = new Uint32Array(2 * this.segments.length);
    this.segments.forEach((vertex, s) => {
      ends[2 * s] = vertex;
      ends[2 * s + 1] = vertex + 1;
    });
    this.thin.geometry.setIndex(new BufferAttribute(ends, 1));
    this.stale = true;
  }

  setColors(colors) {
    this.colors.set(colors);
    this.thin.geometry.attributes.color.needsUpdate = true;
    this.stale = true;
  }

  // Wide lines take six times the memory of thin ones and are made when they are needed.
  updateWide() {
    this.stale = false;
    this.wide.geometry.dispose();
    this.wide.geometry = new LineSegmentsGeometry();
    if (this.segments.length === 0) return;
    this.wide.geometry.setPositions(spread(this.drawing.points, this.segments));
    this.wide.geometry.setColors(spread(this.colors, this.segments, 1 / 255));
  }

  setFine(fine) {
    if (fine && this.shown && this.stale) this.updateWide();
    this.thin.visible = this.shown && !fine;
    this.wide.visible = this.shown && fine && this.segments.length > 0;
  }

  select(link, color) {
    this.selected.visible = link !== null;
    if (link === null) return;
    this.selected.geometry.dispose();
    this.selected.geometry = new LineSegmentsGeometry();
    const segments = segmentsOf(this.drawing, (other) => other === link);
    this.selected.geometry.setPositions(spread(this.drawing.points, segments));
    this.selected.material.color.set(color);
  }
}
