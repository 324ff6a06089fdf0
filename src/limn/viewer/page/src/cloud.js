// SPDX-License-Identifier: BSD-3-Clause
// The point cloud. While the picture moves, only as many points are drawn as keep it fluid.

import { BufferAttribute, BufferGeometry, Points, PointsMaterial } from 'three';

const SIZE_PX = 1.6;
const FEWEST = 10000;

// A fixed order in which every beginning is spread over the whole.
function shuffledOrder(size) {
  const order = Uint32Array.from({ length: size }, (_, i) => i);
  let state = 1;
  for (let i = size - 1; i > 0; --i) {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    const other = Math.floor((state / 2 ** 32) * (i + 1));
    [order[i], order[other]] = [order[other], order[i]];
  }
  return order;
}

function inOrder(values, order) {
  const result = new values.constructor(values.length);
  order.forEach((from, to) => {
    for (let c = 0; c < 3; ++c) result[3 * to + c] = values[3 * from + c];
  });
  return result;
}

export class Cloud {
  constructor(drawing, scene) {
    this.size = drawing.cloudPositions.length / 3;
    this.whileMoving = this.size;
    const order = shuffledOrder(this.size);
    const geometry = new BufferGeometry();
    geometry.setAttribute(
      'position',
      new BufferAttribute(inOrder(drawing.cloudPositions, order), 3),
    );
    geometry.setAttribute(
      'color',
      new BufferAttribute(inOrder(drawing.cloudColors, order), 3, true),
    );
    const material = new PointsMaterial({
      vertexColors: true,
      sizeAttenuation: false,
      size: SIZE_PX,
    });
    this.points = new Points(geometry, material);
    this.points.frustumCulled = false;
    this.points.onBeforeRender = (renderer) => {
      material.size = SIZE_PX * renderer.getPixelRatio();
    };
    scene.add(this.points);
  }

  setFine(fine) {
    this.points.geometry.setDrawRange(0, fine ? this.size : this.whileMoving);
  }

  adapt(pace) {
    if (pace < 0) this.whileMoving = Math.max(Math.floor(0.7 * this.whileMoving), FEWEST);
    if (pace > 0) this.whileMoving = Math.ceil(1.1 * this.whileMoving);
    this.whileMoving = Math.min(this.whileMoving, this.size);
  }
}
