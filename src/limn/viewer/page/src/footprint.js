// SPDX-License-Identifier: BSD-3-Clause
// The size of a pixel at a place, the unit of the limits of edits: PixelFootprint of
// src/limn/model/footprint.h, except for what masks and lenses exclude inside photographs.

import { project } from './optics.js';

// As Median of src/limn/util/median.h.
function median(values) {
  return values.sort((a, b) => a - b)[Math.floor(values.length / 2)];
}

const isWithin = ({ min, max }, pixel) =>
  pixel.every((value, axis) => value >= min[axis] && value <= max[axis]);

// 0 without views.
export function footprintAt(views, { x, y, z }) {
  const containing = [];
  const facing = [];
  const behind = [];
  for (const view of views) {
    const focal = 0.5 * (view.fx + view.fy);
    const [column, row, depth] = project(view, x, y, z, []);
    if (depth > 0) facing.push(depth / focal);
    else behind.push(Math.hypot(...view.position.map((at, axis) => [x, y, z][axis] - at)) / focal);
    const isInside = depth > 0 && isWithin(view.region, [column, row]);
    if (isInside) containing.push(depth / focal);
  }
  if (containing.length > 0) return median(containing);
  if (facing.length > 0) return median(facing);
  return behind.length > 0 ? Math.min(...behind) : 0;
}
