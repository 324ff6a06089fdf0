// How well places and lengths of a drawing are known; as in drawing_span.cc, and of any place.

// A node is meant by a place this near to it, as a share of the size of the drawing.
const SAME_PLACE = 1e-6;

function nodeAt(drawing, position) {
  const most = SAME_PLACE * drawing.radius;
  for (let node = 0; node < drawing.numNodes; ++node) {
    if (drawing.node(node).distanceTo(position) <= most) return node;
  }
  return -1;
}

function nearestVertex(drawing, { x, y, z }) {
  const { points } = drawing;
  let best = -1;
  let least = Infinity;
  for (let vertex = 0; vertex < drawing.numVertices; ++vertex) {
    const square =
      (points[3 * vertex] - x) ** 2 +
      (points[3 * vertex + 1] - y) ** 2 +
      (points[3 * vertex + 2] - z) ** 2;
    if (!(square < least)) continue;
    least = square;
    best = vertex;
  }
  return best;
}

// c: nine numbers.
function varianceOf(c, { x, y, z }) {
  return (
    x * (c[0] * x + c[1] * y + c[2] * z) +
    y * (c[3] * x + c[4] * y + c[5] * z) +
    z * (c[6] * x + c[7] * y + c[8] * z)
  );
}

// Of a node, or else of the nearest point of a curve, along a unit vector; NaN if unknown.
function varianceAt(drawing, position, direction) {
  const node = nodeAt(drawing, position);
  if (node < 0) {
    const sigma = drawing.sigma[nearestVertex(drawing, position)];
    return Number.isFinite(sigma) ? sigma ** 2 : NaN;
  }
  const covariance = drawing.nodeCovariances.subarray(9 * node, 9 * node + 9);
  return covariance.some((value) => value !== 0) ? varianceOf(covariance, direction) : NaN;
}

function withScale(drawing, variance, length) {
  return Math.sqrt(Math.max(variance, 0) + (drawing.scaleSigma * length) ** 2);
}

// Standard deviation of the distance between two places of the drawing; NaN if unknown.
export function sigmaBetween(drawing, from, to) {
  const way = to.clone().sub(from);
  const length = way.length();
  if (!(length > 0)) return NaN;
  way.divideScalar(length);
  const variance = varianceAt(drawing, from, way) + varianceAt(drawing, to, way);
  return withScale(drawing, variance, length);
}

// Of the length of a link: that of its ends, and of a closed one of its radius; NaN if unknown.
export function sigmaOfLink(drawing, link) {
  if (!drawing.isClosed(link)) {
    return sigmaBetween(drawing, drawing.endPosition(link, 0), drawing.endPosition(link, 1));
  }
  const sigma = 2 * Math.PI * drawing.medianSigma(link);
  return Number.isFinite(sigma) ? withScale(drawing, sigma ** 2, drawing.linkLength[link]) : NaN;
}
