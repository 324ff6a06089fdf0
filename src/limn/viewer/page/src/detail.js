// SPDX-License-Identifier: BSD-3-Clause
// Levels of detail of polylines (Douglas and Peucker): how far off a polyline would be without a
// vertex.

// Distance of vertex `at` to the chord between two others.
function distanceToChord(points, at, from, to) {
  let dot = 0;
  let square = 0;
  for (let axis = 0; axis < 3; ++axis) {
    const chord = points[3 * to + axis] - points[3 * from + axis];
    dot += chord * (points[3 * at + axis] - points[3 * from + axis]);
    square += chord * chord;
  }
  const share = square > 0 ? Math.min(Math.max(dot / square, 0), 1) : 0;
  let distance = 0;
  for (let axis = 0; axis < 3; ++axis) {
    const chord = points[3 * to + axis] - points[3 * from + axis];
    distance += (points[3 * at + axis] - points[3 * from + axis] - share * chord) ** 2;
  }
  return Math.sqrt(distance);
}

// Per vertex of [begin, end) into `importance`: keeping those above a tolerance keeps the polyline
// within it. The ends are kept always.
function rate(points, begin, end, importance) {
  importance[begin] = importance[end - 1] = Infinity;
  const stack = [[begin, end - 1, Infinity]];
  while (stack.length > 0) {
    const [from, to, bound] = stack.pop();
    let farthest = -1;
    let most = -1;
    for (let at = from + 1; at < to; ++at) {
      const distance = distanceToChord(points, at, from, to);
      if (distance > most) [farthest, most] = [at, distance];
    }
    if (farthest < 0) continue;
    importance[farthest] = Math.min(most, bound);
    stack.push([from, farthest, importance[farthest]], [farthest, to, importance[farthest]]);
  }
}

// `known`: of the first links.
export function importanceOf(drawing, known = []) {
  const importance = new Float32Array(drawing.numVertices);
  importance.set(known);
  for (let link = 0; link < drawing.numLinks; ++link) {
    if (drawing.range(link)[0] < known.length) continue;
    rate(drawing.points, ...drawing.range(link), importance);
  }
  return importance;
}
