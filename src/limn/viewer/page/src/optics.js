// SPDX-License-Identifier: BSD-3-Clause
// Projections of photographs. Pixels: the center of the top-left pixel is (0, 0); three.js's cameras
// look along -z with y up, the model's along z with y down.

import { Matrix4, Quaternion, Vector3 } from 'three';

// Orientation of a three.js camera at a view.
export function orientationOf(view) {
  const r = view.camFromWorld;
  // Columns are the camera's right, up and backward directions in the world.
  const axes = new Matrix4().set(
    ...[r[0], -r[3], -r[6], 0],
    ...[r[1], -r[4], -r[7], 0],
    ...[r[2], -r[5], -r[8], 0],
    ...[0, 0, 0, 1],
  );
  return new Quaternion().setFromRotationMatrix(axes);
}

// The world point at a depth behind a pixel of a view.
export function pointAtPixel(view, x, y, depth) {
  const ray = [((x - view.cx) / view.fx) * depth, ((y - view.cy) / view.fy) * depth, depth];
  const r = view.camFromWorld;
  return new Vector3(
    ...[0, 1, 2].map(
      (axis) =>
        view.position[axis] + r[axis] * ray[0] + r[3 + axis] * ray[1] + r[6 + axis] * ray[2],
    ),
  );
}

// Projection of a point by a view: [x, y, depth].
export function project(view, x, y, z, target) {
  const r = view.camFromWorld;
  const dx = x - view.position[0];
  const dy = y - view.position[1];
  const dz = z - view.position[2];
  const depth = r[6] * dx + r[7] * dy + r[8] * dz;
  target[0] = (view.fx * (r[0] * dx + r[1] * dy + r[2] * dz)) / depth + view.cx;
  target[1] = (view.fy * (r[3] * dx + r[4] * dy + r[5] * dz)) / depth + view.cy;
  target[2] = depth;
  return target;
}

// The rectangle of the image plane that has a picture, from edge to edge.
export function pictureRectangle(view) {
  const { min, max } = view.thumbnail ?? {
    min: [-0.5, -0.5],
    max: [view.width - 0.5, view.height - 0.5],
  };
  return { left: min[0], top: min[1], right: max[0], bottom: max[1] };
}

// How a picture lies on the canvas: canvas = scale * pixel + offset, CSS px.
export function fitPicture(view, width, height) {
  const { left, top, right, bottom } = pictureRectangle(view);
  const scale = Math.min(width / (right - left), height / (bottom - top));
  return {
    scale,
    x: 0.5 * width - 0.5 * scale * (left + right),
    y: 0.5 * height - 0.5 * scale * (top + bottom),
  };
}

// The same, but the picture covers all of the canvas, with a pixel as near to the middle as can be.
export function coverPicture(view, width, height, [x, y]) {
  const { left, top, right, bottom } = pictureRectangle(view);
  const scale = Math.max(width / (right - left), height / (bottom - top));
  const offset = (middle, size, low, high) =>
    Math.min(-scale * low, Math.max(size - scale * high, 0.5 * size - scale * middle));
  return { scale, x: offset(x, width, left, right), y: offset(y, height, top, bottom) };
}

// The projection matrix that draws what a view sees where its picture lies.
export function photoProjection(view, placement, width, height, near, far) {
  const { scale, x, y } = placement;
  return new Matrix4().set(
    ...[(2 * scale * view.fx) / width, 0, 1 - (2 * (x + scale * view.cx)) / width, 0],
    ...[0, (2 * scale * view.fy) / height, (2 * (y + scale * view.cy)) / height - 1, 0],
    ...[0, 0, -(far + near) / (far - near), (-2 * far * near) / (far - near)],
    ...[0, 0, -1, 0],
  );
}

// The opening angle, degrees, of a camera that shows things as large as a placed picture does.
export function openingAngle(view, placement, height) {
  return (360 / Math.PI) * Math.atan(height / (2 * placement.scale * view.fy));
}
