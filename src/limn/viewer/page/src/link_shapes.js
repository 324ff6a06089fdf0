// SPDX-License-Identifier: BSD-3-Clause
// Links as polylines: places along them, parts of them, their directions.

import { Vector3 } from 'three';

// Evenly spaced by arc length, ends included.
export function samplesOf(drawing, link, count) {
  const [begin, end] = drawing.range(link);
  const samples = [drawing.point(begin)];
  const step = drawing.linkLength[link] / (count - 1);
  let done = 0;
  for (let vertex = begin; vertex + 1 < end && samples.length < count - 1; ++vertex) {
    const [from, to] = [drawing.point(vertex), drawing.point(vertex + 1)];
    const length = from.distanceTo(to);
    while (samples.length < count - 1 && done + length >= samples.length * step) {
      samples.push(from.clone().lerp(to, (samples.length * step - done) / length));
    }
    done += length;
  }
  while (samples.length < count - 1) samples.push(drawing.point(end - 1));
  return [...samples, drawing.point(end - 1)];
}

// The point of a link that is nearest to a place: {position, vertex, share, direction, distance,
// along}; `vertex` begins its segment, which runs in `direction` and of which it has a share behind
// it; `along` is the length up to it.
export function nearestOn(drawing, link, place) {
  const [begin, end] = drawing.range(link);
  let best = { distance: Infinity };
  let done = 0;
  const from = new Vector3();
  const chord = new Vector3();
  const position = new Vector3();
  for (let vertex = begin; vertex + 1 < end; ++vertex) {
    drawing.point(vertex, from);
    drawing.point(vertex + 1, chord).sub(from);
    const square = chord.lengthSq();
    const share = square > 0 ? position.subVectors(place, from).dot(chord) / square : 0;
    const within = Math.min(Math.max(share, 0), 1);
    position.copy(from).addScaledVector(chord, within);
    const distance = position.distanceTo(place);
    const length = Math.sqrt(square);
    if (distance < best.distance) {
      best = { position: position.clone(), vertex, share: within, distance };
      best.along = done + within * length;
    }
    done += length;
  }
  best.direction = drawing
    .point(best.vertex + 1)
    .sub(drawing.point(best.vertex))
    .normalize();
  return best;
}

// Out of the link, over the last tenth of it.
export function directionAtEnd(drawing, link, end) {
  const at = drawing.endPosition(link, end);
  const inside = samplesOf(drawing, link, 11)[end === 0 ? 1 : 9];
  return at.sub(inside).normalize();
}

// Both parts of a link that is cut at {vertex, position}; of a closed link one part, which begins
// and ends there.
export function cutApart(drawing, link, { vertex, position }) {
  const [begin, end] = drawing.range(link);
  const place = position.toArray();
  const before = [...drawing.points.subarray(3 * begin, 3 * vertex + 3), ...place];
  const after = [...place, ...drawing.points.subarray(3 * vertex + 3, 3 * end)];
  const parts = drawing.isClosed(link) ? [[...after, ...before.slice(3)]] : [before, after];
  return parts.map((part) => withoutRepeats(Float32Array.from(part)));
}

// One polyline out of two links, from end to end.
export function chained(drawing, [a, b], [endA, endB]) {
  const first = pointsOf(drawing, a, endA === 0);
  const second = pointsOf(drawing, b, endB === 1);
  return withoutRepeats(Float32Array.from([...first, ...second]));
}

function pointsOf(drawing, link, isReversed) {
  const [begin, end] = drawing.range(link);
  const points = [];
  for (let vertex = begin; vertex < end; ++vertex) points.push(drawing.point(vertex).toArray());
  return (isReversed ? points.reverse() : points).flat();
}

// A point that equals the one before it says nothing.
function withoutRepeats(points) {
  const kept = [...points.subarray(0, 3)];
  for (let i = 3; i < points.length; i += 3) {
    const isNew = [0, 1, 2].some((axis) => points[i + axis] !== points[i + axis - 3]);
    if (isNew) kept.push(...points.subarray(i, i + 3));
  }
  return Float32Array.from(kept);
}
