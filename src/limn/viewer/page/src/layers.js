// SPDX-License-Identifier: BSD-3-Clause
// What can be switched on and off.

import { Cloud } from './cloud.js';
import { Curves } from './curves.js';
import { Faces } from './faces.js';
import { Frusta } from './frusta.js';
import { Markers } from './markers.js';

const JUNCTION_LOOK = { size: 7, fill: '#ffffff', rim: '#20242a' };
const END_LOOK = { size: 6, fill: '#ffd23c', rim: '#20242a' };

const HIDDEN_AT_FIRST = ['ends', 'hiding'];

const isJunction = (degree) => degree >= 3;
const isEnd = (degree) => degree > 0 && !isJunction(degree);

function positionsOf(drawing, degrees, passes) {
  const positions = [];
  degrees.forEach((degree, node) => {
    if (passes(degree)) positions.push(...drawing.node(node).toArray());
  });
  return positions;
}

export class Layers {
  constructor(drawing, stage, photos) {
    this.drawing = drawing;
    this.faces = new Faces(drawing, stage.near);
    this.curves = new Curves(drawing, stage.near);
    this.junctions = new Markers([], JUNCTION_LOOK, stage.near);
    this.ends = new Markers([], END_LOOK, stage.near);
    this.showNodes();
    this.cloud = new Cloud(drawing, stage.far);
    this.frusta = new Frusta(drawing, photos, stage.near, () => stage.change());
    stage.addLayer(this.curves);
    stage.addLayer(this.cloud);
    this.list = [
      { id: 'drawing', label: 'Drawing', key: 'd', show: (on) => (this.curves.shown = on) },
      {
        ...{ id: 'junctions', label: 'Junctions', key: 'j' },
        show: (on) => (this.junctions.points.visible = on),
      },
      { id: 'ends', label: 'Ends', key: 'e', show: (on) => (this.ends.points.visible = on) },
      { id: 'cloud', label: 'Points', key: 'p', show: (on) => (this.cloud.points.visible = on) },
      { id: 'cameras', label: 'Cameras', key: 'c', show: (on) => (this.frusta.shown = on) },
      ...this.layersOfFaces(),
    ];
    for (const layer of this.list) {
      layer.shown = !HIDDEN_AT_FIRST.includes(layer.id);
      layer.show(layer.shown);
    }
  }

  layersOfFaces() {
    const { faces } = this;
    faces.shades.visible = faces.mask.visible = false;
    if (this.drawing.numFaces === 0) return [];
    return [
      { id: 'faces', label: 'Faces', key: 'a', show: (on) => (faces.shades.visible = on) },
      {
        ...{ id: 'hiding', label: 'Hide lines behind faces', key: 'h' },
        show: (on) => (faces.mask.visible = on),
      },
    ];
  }

  // Nodes of what is shown. Call it when they have other links, or when others are shown.
  showNodes() {
    const degrees = this.drawing.shownDegrees();
    this.junctions.setPositions(positionsOf(this.drawing, degrees, isJunction));
    this.ends.setPositions(positionsOf(this.drawing, degrees, isEnd));
  }

  set(id, shown) {
    const layer = this.list.find((other) => other.id === id);
    layer.shown = shown;
    layer.show(shown);
  }

  isShown(id) {
    return this.list.find((layer) => layer.id === id).shown;
  }
}
