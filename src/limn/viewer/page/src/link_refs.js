// SPDX-License-Identifier: BSD-3-Clause
// How edits name links: by number and by geometry, in the coordinates of drawing.json.

import { Box3, Vector3 } from 'three';

import { nearestOn, samplesOf } from './link_shapes.js';

const NUM_POINTS = 16;
// Digits beyond this part of the drawing's size are left out.
const STEP = 1e-8;
// How far off a link may be to be the one that is meant, radii of the drawing, and how much its
// length may differ.
const TOLERANCE = 0.005;
const LENGTH_RATIO = 1.1;

function digitsOf(drawing) {
  const step = (STEP * drawing.radius) / drawing.shownFromModel.scale;
  return Math.min(15, Math.max(0, Math.ceil(-Math.log10(step))));
}

// A position as three numbers in an edit.
export function placeOf(drawing, position) {
  const digits = digitsOf(drawing);
  return drawing.inModel(position).map((value) => Number(value.toFixed(digits)));
}

// {id, closed, points}
export function refOf(drawing, link) {
  return {
    id: link < drawing.numStored ? link : -1,
    closed: drawing.isClosed(link),
    points: samplesOf(drawing, link, NUM_POINTS).map((point) => placeOf(drawing, point)),
  };
}

// A difference of positions in an edit, and back.
export function shiftOf(drawing, { x, y, z }) {
  const { scale, rotation: r } = drawing.shownFromModel;
  const digits = digitsOf(drawing);
  return [0, 1, 2].map((axis) =>
    Number(((r[axis] * x + r[3 + axis] * y + r[6 + axis] * z) / scale).toFixed(digits)),
  );
}

export function shiftShown(drawing, [x, y, z]) {
  const { scale, rotation: r } = drawing.shownFromModel;
  const row = (first) => scale * (r[first] * x + r[first + 1] * y + r[first + 2] * z);
  return new Vector3(row(0), row(3), row(6));
}

// How far the points of a reference are from a link, Infinity if it cannot be meant.
function distanceTo(drawing, link, points, length, tolerance) {
  const ratio = drawing.linkLength[link] / length;
  if (ratio > LENGTH_RATIO || ratio < 1 / LENGTH_RATIO) return Infinity;
  let farthest = 0;
  for (const point of points) {
    farthest = Math.max(farthest, nearestOn(drawing, link, point).distance);
    if (farthest > tolerance) return Infinity;
  }
  return farthest;
}

// Finds links, of those that there are, by references.
export class LinkFinder {
  constructor(drawing) {
    this.drawing = drawing;
    this.tolerance = TOLERANCE * drawing.radius;
    this.boxes = [];
  }

  box(link) {
    this.boxes[link] ??= this.drawing.linkBox(link).expandByScalar(this.tolerance);
    return this.boxes[link];
  }

  // The link, or -1: geometry decides, the number only between equals.
  find({ id, points }) {
    const { drawing, tolerance } = this;
    const places = points.map((point) => drawing.fromModel(point));
    const length = places.slice(1).reduce((sum, at, i) => sum + at.distanceTo(places[i]), 0);
    const extent = new Box3().setFromPoints(places);
    let best = { link: -1, distance: Infinity };
    for (let link = 0; link < drawing.numLinks; ++link) {
      if (!drawing.isLive(link) || !this.box(link).containsBox(extent)) continue;
      const distance = distanceTo(drawing, link, places, length, tolerance);
      const isSame = Math.abs(distance - best.distance) < 0.01 * tolerance;
      if (isSame ? link === id : distance < best.distance) best = { link, distance };
    }
    return best.link;
  }

  // Which end of the link is meant by an end of a reference.
  endOf(link, { points }, end) {
    const place = this.drawing.fromModel(end === 0 ? points[0] : points[points.length - 1]);
    const distances = [0, 1].map((at) => this.drawing.endPosition(link, at).distanceTo(place));
    return distances[0] <= distances[1] ? 0 : 1;
  }
}
