// SPDX-License-Identifier: BSD-3-Clause
// How well places and lengths of a drawing are known; as in drawing_span.cc. A place has `position`
// and, where it is known, `node`, or `link` and the `vertex` before it.

import { ARC, CIRCLE, CONTOUR, LINE } from './drawing.js';

// A node is meant by a place this near to it, as a share of the size of the drawing.
const SAME_PLACE = 1e-6;

// The index of the nearest of `points`, three numbers each, and the square of its distance.
function nearest(points, { x, y, z }, isEligible) {
  let best = { index: -1, square: Infinity };
  for (let i = 0, at = 0; at < points.length; ++i, at += 3) {
    const [dx, dy, dz] = [points[at] - x, points[at + 1] - y, points[at + 2] - z];
    const square = dx * dx + dy * dy + dz * dz;
    if (square < best.square && isEligible(i)) best = { index: i, square };
  }
  return best;
}

function linkOf(drawing, vertex) {
  let [low, high] = [0, drawing.numLinks];
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (drawing.linkStart[middle] <= vertex) low = middle;
    else high = middle;
  }
  return low;
}

// What of the drawing is at a place, of which only the position is known. Linear in its points.
function placeAt(drawing, position) {
  const node = nearest(drawing.nodePositions, position, () => true);
  if (node.square <= (SAME_PLACE * drawing.radius) ** 2) return { position, node: node.index };
  const { index } = nearest(drawing.points, position, (vertex) =>
    Number.isFinite(drawing.sigma[vertex]),
  );
  return { position, vertex: index, link: index < 0 ? -1 : linkOf(drawing, index) };
}

// c: nine numbers.
function varianceOf(c, { x, y, z }) {
  return (
    x * (c[0] * x + c[1] * y + c[2] * z) +
    y * (c[3] * x + c[4] * y + c[5] * z) +
    z * (c[6] * x + c[7] * y + c[8] * z)
  );
}

// Along a unit vector; NaN if unknown.
function varianceAt(drawing, { node, link, vertex }, direction) {
  if (node === undefined) {
    const sigma = drawing.linkKind[link] === CONTOUR ? NaN : drawing.sigma[vertex];
    return Number.isFinite(sigma) ? sigma ** 2 : NaN;
  }
  const covariance = drawing.nodeCovariances.subarray(9 * node, 9 * node + 9);
  return covariance.some((value) => value !== 0) ? varianceOf(covariance, direction) : NaN;
}

// NaN for a length in a unit of the world if that of its scale is unknown.
function withScale(drawing, variance, length) {
  if (drawing.isMetric && !(drawing.scaleSigma > 0)) return NaN;
  return Math.sqrt(Math.max(variance, 0) + (drawing.scaleSigma * length) ** 2);
}

// Standard deviation of the distance between two places; NaN if unknown.
export function sigmaBetween(drawing, from, to) {
  const way = to.position.clone().sub(from.position);
  const length = way.length();
  if (!(length > 0)) return NaN;
  way.divideScalar(length);
  const variance = varianceAt(drawing, from, way) + varianceAt(drawing, to, way);
  return withScale(drawing, variance, length);
}

const sigmas = new WeakMap();

// Of a dimension {from, to}, which is found once.
export function sigmaOfDimension(drawing, dimension) {
  if (!sigmas.has(dimension)) {
    const [from, to] = [dimension.from, dimension.to].map((place) => placeAt(drawing, place));
    sigmas.set(dimension, sigmaBetween(drawing, from, to));
  }
  return sigmas.get(dimension);
}

// {length, sigma} of a link: of its primitive if that is a line or an arc, which do not follow the
// noise of its points.
export function measureLink(drawing, link) {
  const kind = drawing.primitiveType[link];
  const turn = drawing.primitiveSweep[link];
  const [from, to] = [0, 1].map((end) => ({
    position: drawing.endPosition(link, end),
    node: drawing.linkNodes[2 * link + end],
  }));
  let length = drawing.linkLength[link];
  if (kind === LINE) length = from.position.distanceTo(to.position);
  if (kind === ARC || kind === CIRCLE) length = turn * drawing.primitiveRadius[link];
  const ofRadius = drawing.linkKind[link] === CONTOUR ? NaN : drawing.medianSigma(link);
  if (drawing.isClosed(link)) {
    const variance = (2 * Math.PI * ofRadius) ** 2;
    return {
      length,
      sigma: Number.isFinite(variance) ? withScale(drawing, variance, length) : NaN,
    };
  }
  const ofEnds = sigmaBetween(drawing, from, to);
  return { length, sigma: kind === ARC ? Math.hypot(ofEnds, turn * ofRadius) : ofEnds };
}
