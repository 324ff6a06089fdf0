// SPDX-License-Identifier: BSD-3-Clause
// What edits add to the picture, until drawing_editor has fitted them: connections of joined ends,
// straight and dashed, and places of cuts.

import { Markers } from './markers.js';
import { joined, WideLines } from './wide_lines.js';

const WIDTH_PX = 2;
const NUM_DASHES = 7;
const CUT_LOOK = { size: 9, fill: '#ffffff', rim: '#0b63ce' };

function dashes(from, to) {
  const parts = 2 * NUM_DASHES - 1;
  return Array.from({ length: NUM_DASHES }, (_, i) =>
    [2 * i, 2 * i + 1].map((part) =>
      from
        .clone()
        .lerp(to, part / parts)
        .toArray(),
    ),
  );
}

export class EditPreview {
  constructor(scene) {
    this.lines = new WideLines({ width: WIDTH_PX, depthTest: false, renderOrder: 2 }, scene);
    this.lines.visible = false;
    this.cuts = new Markers([], CUT_LOOK, scene);
  }

  setColor(color) {
    this.lines.setTint(color);
  }

  show({ connections, cuts }) {
    this.lines.visible = connections.length > 0;
    if (connections.length > 0) {
      this.lines.setLines(joined(connections.flatMap(([from, to]) => dashes(from, to))));
    }
    this.cuts.setPositions(cuts.flatMap((place) => place.toArray()));
    this.cuts.points.visible = cuts.length > 0;
  }
}
