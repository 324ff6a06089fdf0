// SPDX-License-Identifier: BSD-3-Clause
// Whether drawing_editor merges two links: FindBeside and ApplyMerge of
// src/limn/editing/merge_edit.cc, with the same limits.

import { footprintAt } from './footprint.js';
import { nearestOn } from './link_shapes.js';

const MAX_APART_PX = 15;
const MAX_PARALLEL_DEG = 45;
const MIN_PARALLEL_SHARE = 0.7;
const MIN_REST_PX = 2;
const MIN_POINTS = 3;

const MIN_COSINE = Math.cos((Math.PI / 180) * MAX_PARALLEL_DEG);

// The end of an open base that a point lies beyond, by more than the tolerance; -1 if it lies beside.
function beyondEnd(drawing, base, point, nearest, tolerance) {
  if (drawing.isClosed(base)) return -1;
  const along = point.clone().sub(nearest.position).dot(nearest.direction);
  const [begin, end] = drawing.range(base);
  if (nearest.vertex === begin && nearest.share <= 0 && along < -tolerance) return 0;
  return nearest.vertex + 2 === end && nearest.share >= 1 && along > tolerance ? 1 : -1;
}

function tangentAt(drawing, link, vertex) {
  const [begin, end] = drawing.range(link);
  const next = drawing.point(Math.min(vertex + 1, end - 1));
  return next.sub(drawing.point(Math.max(vertex - 1, begin))).normalize();
}

// Per vertex of a link: {along: length up to it, beyond, distance to the base, isParallel}.
function vertexesBeside(drawing, base, link, footprint) {
  const [begin, end] = drawing.range(link);
  let along = 0;
  return Array.from({ length: end - begin }, (_, i) => {
    const point = drawing.point(begin + i);
    if (i > 0) along += point.distanceTo(drawing.point(begin + i - 1));
    const nearest = nearestOn(drawing, base, point);
    const cosine = tangentAt(drawing, link, begin + i).dot(nearest.direction);
    return {
      along,
      beyond: beyondEnd(drawing, base, point, nearest, footprint),
      distance: nearest.distance,
      isParallel: Math.abs(cosine) >= MIN_COSINE,
    };
  });
}

export function runAlongEachOther(drawing, [a, b]) {
  const [base, other] = drawing.linkLength[b] > drawing.linkLength[a] ? [b, a] : [a, b];
  const [begin, end] = drawing.range(other);
  const middle = drawing.point(begin + Math.floor((end - begin) / 2));
  const footprint = footprintAt(drawing.views, middle);
  const vertexes = vertexesBeside(drawing, base, other, footprint);
  const isBeside = ({ beyond }) => beyond < 0;
  const beside = vertexes.filter(isBeside);
  const distance = beside.reduce((sum, vertex) => sum + vertex.distance, 0);
  const numParallel = beside.filter(({ isParallel }) => isParallel).length;
  const first = vertexes.findIndex(isBeside);
  const last = vertexes.findLastIndex(isBeside);
  if (last - first + 1 < MIN_POINTS || beside.length < 2) return false;
  if (distance > MAX_APART_PX * footprint * beside.length) return false;
  if (numParallel < MIN_PARALLEL_SHARE * beside.length) return false;
  // A link that extends beyond one end of the longer link at both of its ends is not part of it.
  const least = MIN_REST_PX * footprint;
  const total = vertexes[vertexes.length - 1].along;
  const goesOn = vertexes[first].along >= least && total - vertexes[last].along >= least;
  const [start, finish] = [vertexes[0].beyond, vertexes[vertexes.length - 1].beyond];
  return !(goesOn && start >= 0 && start === finish);
}
