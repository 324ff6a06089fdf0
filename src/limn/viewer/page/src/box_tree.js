// SPDX-License-Identifier: BSD-3-Clause
// A tree of boxes over things in space, to be asked for what is near a place on the screen. Built in
// O(n log^2 n); a question looks only into boxes whose outline on the screen is near the place.

const LEAF = 4;

export class BoxTree {
  // `boxes`: six numbers per thing, lower then upper corner.
  constructor(boxes) {
    this.boxes = boxes;
    const things = Uint32Array.from({ length: boxes.length / 6 }, (_, i) => i);
    this.root = things.length === 0 ? null : this.build(things);
  }

  bounds(things) {
    const bounds = [Infinity, Infinity, Infinity, -Infinity, -Infinity, -Infinity];
    for (const thing of things) {
      for (let axis = 0; axis < 3; ++axis) {
        bounds[axis] = Math.min(bounds[axis], this.boxes[6 * thing + axis]);
        bounds[3 + axis] = Math.max(bounds[3 + axis], this.boxes[6 * thing + 3 + axis]);
      }
    }
    return bounds;
  }

  build(things) {
    const bounds = this.bounds(things);
    if (things.length <= LEAF) return { bounds, things };
    const extent = [0, 1, 2].map((axis) => bounds[3 + axis] - bounds[axis]);
    const axis = extent.indexOf(Math.max(...extent));
    const middle = (thing) => this.boxes[6 * thing + axis] + this.boxes[6 * thing + 3 + axis];
    things.sort((a, b) => middle(a) - middle(b));
    const half = things.length >> 1;
    return {
      bounds,
      children: [this.build(things.slice(0, half)), this.build(things.slice(half))],
    };
  }

  // Calls visit(thing) for all things whose box may be within `reach()` px of (x, y); the reach may
  // shrink on the way. `matrix`: column-major, from things to clip space.
  visit(matrix, size, x, y, reach, visit) {
    const stack = this.root ? [this.root] : [];
    while (stack.length > 0) {
      const node = stack.pop();
      if (!isNear(node.bounds, matrix, size, x, y, reach())) continue;
      if (node.things) node.things.forEach(visit);
      else stack.push(...node.children);
    }
  }
}

function isNear(bounds, m, { width, height }, x, y, reach) {
  let left = Infinity;
  let top = Infinity;
  let right = -Infinity;
  let bottom = -Infinity;
  let numBehind = 0;
  for (let corner = 0; corner < 8; ++corner) {
    const px = bounds[corner & 1 ? 3 : 0];
    const py = bounds[corner & 2 ? 4 : 1];
    const pz = bounds[corner & 4 ? 5 : 2];
    const w = m[3] * px + m[7] * py + m[11] * pz + m[15];
    if (w <= 0) {
      ++numBehind;
      continue;
    }
    const sx = 0.5 * width * (1 + (m[0] * px + m[4] * py + m[8] * pz + m[12]) / w);
    const sy = 0.5 * height * (1 - (m[1] * px + m[5] * py + m[9] * pz + m[13]) / w);
    left = Math.min(left, sx);
    right = Math.max(right, sx);
    top = Math.min(top, sy);
    bottom = Math.max(bottom, sy);
  }
  if (numBehind > 0) return numBehind < 8;
  return x >= left - reach && x <= right + reach && y >= top - reach && y <= bottom + reach;
}
