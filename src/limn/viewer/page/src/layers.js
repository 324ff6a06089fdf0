// What can be switched on and off.

import { Cloud } from './cloud.js';
import { Curves } from './curves.js';
import { JUNCTION } from './drawing.js';
import { Frusta } from './frusta.js';
import { Markers } from './markers.js';

const JUNCTION_LOOK = { size: 7, fill: '#ffffff', rim: '#20242a' };
const END_LOOK = { size: 6, fill: '#ffd23c', rim: '#20242a' };

function positionsOf(drawing, passes) {
  const positions = [];
  for (let node = 0; node < drawing.numNodes; ++node) {
    if (passes(drawing.nodeKind[node])) positions.push(...drawing.node(node).toArray());
  }
  return positions;
}

export class Layers {
  constructor(drawing, stage, photos) {
    this.curves = new Curves(drawing, stage.near);
    const isJunction = (kind) => kind === JUNCTION;
    const junctions = positionsOf(drawing, isJunction);
    const ends = positionsOf(drawing, (kind) => !isJunction(kind));
    this.junctions = new Markers(junctions, JUNCTION_LOOK, stage.near);
    this.ends = new Markers(ends, END_LOOK, stage.near);
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
    ];
    for (const layer of this.list) {
      layer.shown = layer.id !== 'ends';
      layer.show(layer.shown);
    }
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
