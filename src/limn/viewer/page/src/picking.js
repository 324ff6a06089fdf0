// SPDX-License-Identifier: BSD-3-Clause
// What of the drawing is at a place on the screen.

import { Matrix4, Vector3 } from 'three';

import { BoxTree } from './box_tree.js';

// Segments that follow each other in a link share a box.
const RUN = 8;
// Among things within this many px of the nearest one to the pointer, the one in front is picked.
const SAME_PX = 1.5;
const NEAR_CLIP = 1e-6;

// Runs of segments: first vertex, one past the last segment's first vertex, and link.
function runsOf(drawing) {
  const runs = [];
  for (let link = 0; link < drawing.numLinks; ++link) {
    const [begin, end] = drawing.range(link);
    for (let first = begin; first < end - 1; first += RUN) {
      runs.push({ link, first, last: Math.min(first + RUN, end - 1) });
    }
  }
  return runs;
}

function boxesOfRuns(drawing, runs) {
  const boxes = new Float32Array(6 * runs.length);
  runs.forEach(({ first, last }, r) => {
    for (let axis = 0; axis < 3; ++axis) {
      let low = Infinity;
      let high = -Infinity;
      for (let vertex = first; vertex <= last; ++vertex) {
        low = Math.min(low, drawing.points[3 * vertex + axis]);
        high = Math.max(high, drawing.points[3 * vertex + axis]);
      }
      boxes[6 * r + axis] = low;
      boxes[6 * r + 3 + axis] = high;
    }
  });
  return boxes;
}

function boxesOfPoints(positions) {
  const boxes = new Float32Array(2 * positions.length);
  for (let i = 0; i < positions.length / 3; ++i) {
    for (let axis = 0; axis < 3; ++axis) {
      boxes[6 * i + axis] = boxes[6 * i + 3 + axis] = positions[3 * i + axis];
    }
  }
  return boxes;
}

// Keeps the best of what it is offered: nearest to the pointer, in front among equals.
class Nearest {
  constructor(radius) {
    this.radius = radius;
    this.best = null;
  }

  reach() {
    return this.best ? Math.min(this.radius, this.best.distance + SAME_PX) : this.radius;
  }

  offer(found) {
    if (found.distance > this.reach()) return;
    const { best } = this;
    const isSame = best && Math.abs(found.distance - best.distance) <= SAME_PX;
    if (!best || (isSame ? found.depth < best.depth : found.distance < best.distance)) {
      this.best = found;
    }
  }
}

export class Picking {
  constructor(drawing, eye) {
    this.drawing = drawing;
    this.eye = eye;
    this.runs = runsOf(drawing);
    this.runTree = new BoxTree(boxesOfRuns(drawing, this.runs));
    // Depth of what hides curves at a place on the screen.
    this.depthAt = () => Infinity;
    this.nodeTree = new BoxTree(boxesOfPoints(drawing.nodePositions));
  }

  matrix() {
    const { camera } = this.eye;
    camera.updateMatrixWorld();
    return new Matrix4().multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse);
  }

  // The link within `radius` px of (x, y): {link, vertex, position, distance, depth}, or null;
  // `vertex` begins the segment.
  link(x, y, radius) {
    const matrix = this.matrix().elements;
    const nearest = new Nearest(radius);
    const deepest = this.depthAt(x, y);
    this.runTree.visit(
      matrix,
      this.eye.size,
      x,
      y,
      () => nearest.reach(),
      (run) => {
        const { link, first, last } = this.runs[run];
        this.offerRun(link, first, last, nearest, { matrix, x, y, deepest });
      },
    );
    // Few; they are in no tree.
    for (let link = this.drawing.numStored; link < this.drawing.numLinks; ++link) {
      const [begin, end] = this.drawing.range(link);
      this.offerRun(link, begin, end - 1, nearest, { matrix, x, y, deepest });
    }
    return nearest.best;
  }

  offerRun(link, first, last, nearest, { matrix, x, y, deepest }) {
    if (!this.drawing.isPickable(link)) return;
    for (let vertex = first; vertex < last; ++vertex) {
      const found = this.onSegment(vertex, matrix, x, y);
      if (found && found.depth <= deepest) nearest.offer({ link, vertex, ...found });
    }
  }

  // The end of a link that is meant: {link, end, position, distance}, or null. Where several links
  // meet it is the one whose curve is nearest.
  end(x, y, radius) {
    const near = this.link(x, y, radius);
    const own = near ? this.endOf(near.link, x, y, 2 * radius) : null;
    if (own) return own;
    let best = null;
    for (let link = 0; link < this.drawing.numLinks; ++link) {
      if (!this.drawing.isPickable(link)) continue;
      const found = this.endOf(link, x, y, best?.distance ?? radius);
      if (found && !(found.distance >= best?.distance)) best = found;
    }
    return best;
  }

  // The nearer end of a link, if it is within `radius` px.
  endOf(link, x, y, radius) {
    if (this.drawing.isClosed(link)) return null;
    let best = null;
    for (const end of [0, 1]) {
      const position = this.drawing.endPosition(link, end);
      const place = this.eye.screen(position);
      if (!place) continue;
      const distance = Math.hypot(place.x - x, place.y - y);
      if (distance <= (best?.distance ?? radius)) best = { link, end, position, distance };
    }
    return best;
  }

  // A place on a link: its end, if that is near: {link, position, end or vertex, distance}, or null.
  place(x, y, radius) {
    const near = this.link(x, y, radius);
    return near && (this.endOf(near.link, x, y, radius) ?? near);
  }

  // A node that links end at: {node, position, distance, depth}, or null.
  node(x, y, radius) {
    const matrix = this.matrix().elements;
    const nearest = new Nearest(radius);
    this.nodeTree.visit(
      matrix,
      this.eye.size,
      x,
      y,
      () => nearest.reach(),
      (node) => {
        if (this.drawing.degree[node] === 0) return;
        const position = this.drawing.node(node);
        const place = this.eye.screen(position);
        if (!place) return;
        const distance = Math.hypot(place.x - x, place.y - y);
        nearest.offer({ node, position, distance, depth: place.depth });
      },
    );
    return nearest.best;
  }

  // The point of a segment that is nearest to (x, y) on the screen.
  onSegment(vertex, m, x, y) {
    const { width, height } = this.eye.size;
    const p = this.drawing.points;
    const ends = [vertex, vertex + 1].map((v) => {
      const [px, py, pz] = [p[3 * v], p[3 * v + 1], p[3 * v + 2]];
      return [0, 1, 3].map((row) => m[row] * px + m[4 + row] * py + m[8 + row] * pz + m[12 + row]);
    });
    // What is behind the camera is cut off.
    const range = [0, 1];
    const [w0, w1] = [ends[0][2], ends[1][2]];
    if (w0 <= NEAR_CLIP && w1 <= NEAR_CLIP) return null;
    if (w0 <= NEAR_CLIP) range[0] = (NEAR_CLIP - w0) / (w1 - w0);
    if (w1 <= NEAR_CLIP) range[1] = (NEAR_CLIP - w0) / (w1 - w0);
    const [a, b] = range.map((t) => {
      const [cx, cy, w] = [0, 1, 2].map((i) => ends[0][i] + t * (ends[1][i] - ends[0][i]));
      return { x: 0.5 * width * (1 + cx / w), y: 0.5 * height * (1 - cy / w), w };
    });
    const [dx, dy] = [b.x - a.x, b.y - a.y];
    const square = dx * dx + dy * dy;
    const share =
      square > 0 ? Math.min(Math.max(((x - a.x) * dx + (y - a.y) * dy) / square, 0), 1) : 0;
    const distance = Math.hypot(a.x + share * dx - x, a.y + share * dy - y);
    // Lengths on the screen are foreshortened: by the depths at both ends.
    const within = (share * a.w) / (share * a.w + (1 - share) * b.w);
    const t = range[0] + within * (range[1] - range[0]);
    const position = new Vector3().lerpVectors(
      this.drawing.point(vertex),
      this.drawing.point(vertex + 1),
      t,
    );
    return { position, distance, depth: a.w + within * (b.w - a.w) };
  }

  // Where a measurement may begin or end: a junction or end if one is near, else a point of a curve.
  snap(x, y, radius) {
    return this.node(x, y, radius) ?? this.link(x, y, radius);
  }
}
