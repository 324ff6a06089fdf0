// SPDX-License-Identifier: BSD-3-Clause
// The drawing as the page works on it: flat arrays, positions relative to `center`.

import { Box3, Vector3 } from 'three';

import { storedDimensions } from './dimensions.js';

export const PRIMITIVES = ['none', 'line', 'arc', 'spline', 'circle'];
export const LINE = 1;
export const ARC = 2;
export const CIRCLE = 4;
export const BODY_SHAPES = ['none', 'cylinder', 'cone', 'sphere'];
export const DENSE_CLASSES = ['unknown', 'surface', 'boundary', 'free'];
// Of edges, as LinkKind; tentative links are a category of their own in legends.
export const LINK_KINDS = [
  ...['unknown', 'edge', 'paint', 'shadow', 'contour', 'rod', 'texture'],
  'tentative',
];
export const CONTOUR = 4;
export const ROD = 5;
export const TEXTURE = 6;
const TENTATIVE = 7;
// Those that a user can set.
export const KINDS_TO_SET = LINK_KINDS.filter((_, kind) => kind !== ROD && kind !== TENTATIVE);
// How much is shown: long curves only, all but texture, all.
export const DETAILS = ['coarse', 'normal', 'all'];
const COARSE_CURVE_PX = 80; // as in link_selection.cc
export const NODE_KINDS = ['end', 'junction', 'loop anchor'];
export const JUNCTION = 1;

// Parts of the points that do not decide how large the drawing is, per side of an axis.
const STRAY_SHARE = 0.03;

// What edits have done to a link (edit_state.js): `DELETED` can be restored one by one.
export const LIVE = 0;
export const GONE = 1;
export const DELETED = 2;

function rootOf(parents, node) {
  while (parents[node] !== node) {
    parents[node] = parents[parents[node]];
    node = parents[node];
  }
  return node;
}

// Number of a link's component; the longest component is 0.
function componentsOf(numLinks, numNodes, nodes, lengths) {
  const parents = Uint32Array.from({ length: numNodes }, (_, node) => node);
  for (let link = 0; link < numLinks; ++link) {
    parents[rootOf(parents, nodes[2 * link])] = rootOf(parents, nodes[2 * link + 1]);
  }
  const lengthOf = new Map();
  for (let link = 0; link < numLinks; ++link) {
    const root = rootOf(parents, nodes[2 * link]);
    lengthOf.set(root, (lengthOf.get(root) ?? 0) + lengths[link]);
  }
  const ranked = [...lengthOf.keys()].sort((a, b) => lengthOf.get(b) - lengthOf.get(a) || a - b);
  const rank = new Map(ranked.map((root, index) => [root, index]));
  return Uint32Array.from({ length: numLinks }, (_, link) =>
    rank.get(rootOf(parents, nodes[2 * link])),
  );
}

function grown(values, more) {
  const result = new values.constructor(values.length + more.length);
  result.set(values);
  result.set(more, values.length);
  return result;
}

export function lengthOf(points) {
  let length = 0;
  for (let i = 3; i < points.length; i += 3) {
    length += Math.hypot(
      points[i] - points[i - 3],
      points[i + 1] - points[i - 2],
      points[i + 2] - points[i - 1],
    );
  }
  return length;
}

function robustBox(points) {
  const box = new Box3();
  if (points.length === 0) return box.set(new Vector3(-1, -1, -1), new Vector3(1, 1, 1));
  const low = [];
  const high = [];
  for (let axis = 0; axis < 3; ++axis) {
    const values = new Float32Array(points.length / 3);
    for (let i = 0; i < values.length; ++i) values[i] = points[3 * i + axis];
    values.sort();
    const stray = Math.floor(STRAY_SHARE * (values.length - 1));
    low.push(values[stray]);
    high.push(values[values.length - 1 - stray]);
  }
  return box.set(new Vector3(...low), new Vector3(...high));
}

export class Drawing {
  constructor(header, arrays) {
    Object.assign(this, arrays);
    this.title = header.title;
    this.center = header.center;
    this.unit = header.unit;
    this.isMetric = header.unit !== 'model units';
    this.scaleSigma = header.scaleSigma; // relative; 0: unknown
    this.zIsUp = header.zIsUp;
    this.stamp = header.drawing; // {name, fingerprint} of the file, texts that may be empty
    this.shownFromModel = header.shownFromModel;
    this.views = header.views;
    this.numLinks = arrays.linkLength.length;
    this.numStored = this.numLinks; // those of drawing.json; the others are made by edits
    this.numNodes = arrays.nodeKind.length;
    this.numVertices = arrays.points.length / 3;
    this.numSegments = this.numVertices - this.numLinks;
    this.component = componentsOf(
      this.numLinks,
      this.numNodes,
      arrays.linkNodes,
      arrays.linkLength,
    );
    this.numComponents = this.component.reduce((most, rank) => Math.max(most, rank + 1), 0);
    this.hasPrimitives = arrays.primitiveType.some((type) => type !== 0);
    this.hasClasses = arrays.denseClass !== undefined;
    this.numFaces = arrays.faceAreas.length;
    this.storedDimensions = storedDimensions(arrays.dimensions, (values, at) =>
      new Vector3().fromArray(values, at),
    );
    this.gone = new Uint8Array(this.numLinks);
    this.withGhosts = false; // whether deleted links are shown, too
    this.sortKinds();
    this.countDegrees();
    this.hasKinds = this.kindCategory.some((kind) => kind !== 0);
    this.detail = header.detail;
    this.visible = this.shownAtFirst();
    this.box = robustBox(arrays.points);
    this.radius = Math.max(0.5 * this.box.getSize(new Vector3()).length(), 1e-12);
  }

  // Call it when kinds of links have changed.
  sortKinds() {
    this.kindCategory = this.linkKind.map((kind, link) =>
      this.linkTentative[link] ? TENTATIVE : kind,
    );
  }

  // Numbers of ends of existing links at nodes. Call it when `gone` has changed.
  countDegrees() {
    this.degree = new Uint32Array(this.numNodes);
    this.linkNodes.forEach((node, end) => {
      if (this.gone[end >> 1] === LIVE) ++this.degree[node];
    });
  }

  isLive(link) {
    return this.gone[link] === LIVE;
  }

  isShown(link) {
    return this.visible[link] === 1 && this.gone[link] === LIVE;
  }

  isGhost(link) {
    return this.withGhosts && this.gone[link] === DELETED;
  }

  isPickable(link) {
    return this.isShown(link) || this.isGhost(link);
  }

  // All links but outlines of smooth bodies and tentative ones, as in exports, at this detail.
  shownAtFirst() {
    return this.kindCategory.map((kind, link) =>
      kind === CONTOUR || kind === TENTATIVE || !this.isOfDetail(link) ? 0 : 1,
    );
  }

  // Curves of unknown length count as long.
  isOfDetail(link) {
    if (this.detail === 'all') return true;
    if (this.linkKind[link] === TEXTURE) return false;
    const length = this.linkCurvePx[link];
    return this.detail !== 'coarse' || length === 0 || length >= COARSE_CURVE_PX;
  }

  // Numbers of ends of links that are shown, at nodes.
  shownDegrees() {
    const degrees = new Uint32Array(this.numNodes);
    this.linkNodes.forEach((node, end) => {
      if (this.isShown(end >> 1)) ++degrees[node];
    });
    return degrees;
  }

  // First vertex of a link, and the first that is no longer its own.
  range(link) {
    return [this.linkStart[link], this.linkStart[link + 1]];
  }

  isClosed(link) {
    return this.linkNodes[2 * link] === this.linkNodes[2 * link + 1];
  }

  // The first (0) or last (1) vertex of a link.
  endVertex(link, end) {
    return end === 0 ? this.linkStart[link] : this.linkStart[link + 1] - 1;
  }

  endPosition(link, end) {
    return this.point(this.endVertex(link, end));
  }

  point(vertex, target = new Vector3()) {
    return target.fromArray(this.points, 3 * vertex);
  }

  node(node, target = new Vector3()) {
    return target.fromArray(this.nodePositions, 3 * node);
  }

  supportingViews(link) {
    return this.linkViews.subarray(this.linkViewStart[link], this.linkViewStart[link + 1]);
  }

  numSupportingViews(link) {
    return this.linkViewStart[link + 1] - this.linkViewStart[link];
  }

  linkBox(link) {
    const [begin, end] = this.range(link);
    const box = new Box3();
    for (let vertex = begin; vertex < end; ++vertex) box.expandByPoint(this.point(vertex));
    return box;
  }

  medianSigma(link) {
    const sigmas = this.sigma.slice(...this.range(link)).sort();
    return sigmas[Math.floor(sigmas.length / 2)];
  }

  // As coordinates are displayed, in double precision.
  displayed(position) {
    return [this.center[0] + position.x, this.center[1] + position.y, this.center[2] + position.z];
  }

  fromDisplayed([x, y, z]) {
    return new Vector3(x - this.center[0], y - this.center[1], z - this.center[2]);
  }

  // In the coordinates of drawing.json, and back.
  inModel(position) {
    const { scale, rotation: r, translation } = this.shownFromModel;
    const shown = this.displayed(position);
    const [x, y, z] = shown.map((value, axis) => (value - translation[axis]) / scale);
    return [0, 1, 2].map((axis) => r[axis] * x + r[3 + axis] * y + r[6 + axis] * z);
  }

  fromModel([x, y, z]) {
    const { scale, rotation: r, translation } = this.shownFromModel;
    return this.fromDisplayed(
      [0, 1, 2].map(
        (row) =>
          scale * (r[3 * row] * x + r[3 * row + 1] * y + r[3 * row + 2] * z) + translation[row],
      ),
    );
  }

  // Adds a link that an edit makes: `points`, three numbers each; `like`: the link whose figures it
  // shares; `nodes`: where it begins and ends, null for a new node. Returns its number.
  append({ points, like, nodes }) {
    const link = this.numLinks;
    const count = points.length / 3;
    const ends = nodes.map((node, end) =>
      node === null ? this.appendNode(points.subarray(end === 0 ? 0 : 3 * (count - 1))) : node,
    );
    const more = {
      points,
      sigma: new Float32Array(count).fill(this.medianSigma(like)),
      linkStart: [this.numVertices + count],
      linkLength: [lengthOf(points)],
      linkNodes: ends,
      linkViews: this.supportingViews(like).slice(),
      linkViewStart: [this.linkViews.length + this.numSupportingViews(like)],
      linkColor: this.linkColor.slice(3 * like, 3 * like + 3),
      component: [this.component[like]],
      visible: [1],
      gone: [LIVE],
    };
    for (const name of [
      'linkResidual',
      'linkKind',
      'kindConfidence',
      'linkConfidence',
      'linkCurvePx',
      'linkTentative',
      'rodRadius',
      'bodyShape',
      'bodyRadius',
      'bodyRadiusSigma',
    ]) {
      more[name] = [this[name][like]];
    }
    for (const name of ['Type', 'Radius', 'Sweep', 'Controls', 'Rms', 'Max']) {
      more[`primitive${name}`] = [0];
    }
    if (this.hasClasses) {
      for (const name of ['Class', 'Behind', 'Added', 'Fold']) {
        more[`dense${name}`] = [this[`dense${name}`][like]];
      }
    }
    for (const [name, values] of Object.entries(more)) this[name] = grown(this[name], values);
    this.numLinks += 1;
    this.numVertices += count;
    this.numSegments += count - 1;
    return link;
  }

  appendNode(position) {
    this.nodePositions = grown(this.nodePositions, position.slice(0, 3));
    this.nodeCovariances = grown(this.nodeCovariances, new Float32Array(9));
    this.nodeKind = grown(this.nodeKind, [0]);
    return this.numNodes++;
  }
}
