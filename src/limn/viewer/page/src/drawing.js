// The drawing as the page works on it: flat arrays, positions relative to `center`.

import { Box3, Vector3 } from 'three';

export const PRIMITIVES = ['none', 'line', 'arc', 'spline', 'circle'];
export const DENSE_CLASSES = ['unknown', 'surface', 'boundary', 'free'];
// Of edges, as LinkKind; tentative links are a category of their own in legends.
export const LINK_KINDS = ['unknown', 'edge', 'paint', 'shadow', 'contour', 'tentative'];
const CONTOUR = 4;
const TENTATIVE = 5;
export const NODE_KINDS = ['end', 'junction', 'loop anchor'];
export const JUNCTION = 1;

// Parts of the points that do not decide how large the drawing is, per side of an axis.
const STRAY_SHARE = 0.03;

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
    this.views = header.views;
    this.numLinks = arrays.linkLength.length;
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
    this.kindCategory = arrays.linkKind.map((kind, link) =>
      arrays.linkTentative[link] ? TENTATIVE : kind,
    );
    this.hasKinds = this.kindCategory.some((kind) => kind !== 0);
    this.visible = this.shownAtFirst();
    this.box = robustBox(arrays.points);
    this.radius = Math.max(0.5 * this.box.getSize(new Vector3()).length(), 1e-12);
  }

  // All links but outlines of smooth bodies and tentative ones, as in exports.
  shownAtFirst() {
    return this.kindCategory.map((kind) => (kind < CONTOUR ? 1 : 0));
  }

  // First vertex of a link, and the first that is no longer its own.
  range(link) {
    return [this.linkStart[link], this.linkStart[link + 1]];
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

  // In the model's coordinates, in double precision.
  inModel(position) {
    return [this.center[0] + position.x, this.center[1] + position.y, this.center[2] + position.z];
  }

  fromModel([x, y, z]) {
    return new Vector3(x - this.center[0], y - this.center[1], z - this.center[2]);
  }
}
