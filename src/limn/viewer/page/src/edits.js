// SPDX-License-Identifier: BSD-3-Clause
// Edits: {edit, links: [numbers, -1 for those that are not in this drawing], refs: [how the file names
// them], ...}. What they do: edit_state.js; as text in a file: edits_file.js.

import { LINK_KINDS } from './drawing.js';
import { footprintAt } from './footprint.js';
import { count, number } from './format.js';
import { placeOf, refOf, shiftOf } from './link_refs.js';
import { chained, cutApart, directionAtEnd, nearestOn } from './link_shapes.js';
import { runAlongEachOther } from './side_by_side.js';

// Ends continue each other that turn less than this from one to the other, over a gap that is small
// (radii of the drawing) or leads on within the second angle.
const MAX_TURN_DEG = 30;
const MAX_GAP_DEG = 45;
const SMALL_GAP = 1e-3;
// No cut nearer to an end than this, px of the photographs; as in src/limn/editing/split_edit.cc.
const MIN_PART_PX = 2;

const cosine = (degrees) => Math.cos((Math.PI / 180) * degrees);
const refsOf = (drawing, links) => links.map((link) => refOf(drawing, link));

export function deletion(drawing, links, refs = refsOf(drawing, links)) {
  return { edit: 'delete', links, refs };
}

export function firming(drawing, links, refs = refsOf(drawing, links)) {
  return { edit: 'restore', links, refs };
}

export function kindChange(drawing, links, kind, refs = refsOf(drawing, links)) {
  return { edit: 'set_kind', links, refs, kind };
}

// Null if the place is too near to an end.
export function splitting(drawing, link, position, refs = refsOf(drawing, [link])) {
  const at = placeOf(drawing, position);
  if (link < 0) return { edit: 'split', links: [link], refs, at, makes: [] };
  const nearest = nearestOn(drawing, link, position);
  const rest = Math.min(nearest.along, drawing.linkLength[link] - nearest.along);
  const isAtEnd = rest <= MIN_PART_PX * footprintAt(drawing.views, nearest.position);
  if (isAtEnd && !drawing.isClosed(link)) return null;
  const parts = cutApart(drawing, link, nearest);
  const [first, last] = drawing.linkNodes.subarray(2 * link, 2 * link + 2);
  const nodes = parts.length === 1 ? [null, null] : [first, null];
  const makes = [drawing.append({ points: parts[0], like: link, nodes })];
  if (parts.length === 2) {
    const middle = drawing.linkNodes[2 * makes[0] + 1];
    makes.push(drawing.append({ points: parts[1], like: link, nodes: [middle, last] }));
  }
  return { edit: 'split', links: [link], refs, at, makes, place: nearest.position };
}

// Whether two ends become one smooth curve, about as drawing_editor decides it (src/limn/editing).
function continueEachOther(drawing, links, ends) {
  if (links[0] === links[1]) return false;
  const nodes = links.map((link, i) => drawing.linkNodes[2 * link + ends[i]]);
  const most = nodes[0] === nodes[1] ? 2 : 1;
  if (nodes.some((node) => drawing.degree[node] > most)) return false;
  const [a, b] = links.map((link, i) => directionAtEnd(drawing, link, ends[i]));
  if (-a.dot(b) < cosine(MAX_TURN_DEG)) return false;
  const [from, to] = links.map((link, i) => drawing.endPosition(link, ends[i]));
  const gap = to.sub(from);
  const isSmall = gap.length() < SMALL_GAP * drawing.radius;
  return isSmall || Math.abs(gap.normalize().dot(a)) >= cosine(MAX_GAP_DEG);
}

// Whether there is something to join.
export function canJoin(drawing, links, ends) {
  const nodes = links.map((link, i) => drawing.linkNodes[2 * link + ends[i]]);
  return nodes[0] !== nodes[1] || continueEachOther(drawing, links, ends);
}

// `ends`: 0 or 1 per link.
export function joining(drawing, links, ends, refs = refsOf(drawing, links)) {
  const edit = { edit: 'join', links, refs, ends, makes: [] };
  if (links.includes(-1) || !continueEachOther(drawing, links, ends)) return edit;
  const nodes = links.map((link, i) => drawing.linkNodes[2 * link + 1 - ends[i]]);
  const points = chained(drawing, links, ends);
  return { ...edit, makes: [drawing.append({ points, like: links[0], nodes })] };
}

// Null if drawing_editor would not merge them.
export function merging(drawing, links, refs = refsOf(drawing, links)) {
  const [a, b] = links;
  if (!links.includes(-1) && (a === b || !runAlongEachOther(drawing, links))) return null;
  return { edit: 'merge', links, refs };
}

// `shown`: {from, to, shift} as displayed.
export function dimensioning(drawing, links, shown, refs = refsOf(drawing, links)) {
  const at = [shown.from, shown.to].map((position) => placeOf(drawing, position));
  return { edit: 'dimension', links, refs, at, shown, shift: shiftOf(drawing, shown.shift) };
}

// `stored`: number of a dimension of drawing.json, -1 if it is not there.
export function dimensionRemoval(stored, at) {
  return { edit: 'remove_dimension', links: [], refs: [], stored, at };
}

// The list without the deletion of some links.
export function undeleted(edits, links) {
  const isKept = (edit) => edit.edit !== 'delete' || edit.links.length > 0;
  return edits
    .map((edit) => {
      if (edit.edit !== 'delete' || !edit.links.some((link) => links.has(link))) return edit;
      const kept = edit.links.map((link) => !links.has(link));
      const stays = (_, i) => kept[i];
      return { ...edit, links: edit.links.filter(stays), refs: edit.refs.filter(stays) };
    })
    .filter(isKept);
}

const numbered = (links) =>
  links.length === 1 ? `link ${links[0]}` : `${count(links.length)} links`;

const VERBS = {
  delete: ({ links }) => `delete ${numbered(links)}`,
  restore: ({ links }) => `make ${numbered(links)} firm`,
  set_kind: ({ links, kind }) => `set ${numbered(links)} to ${LINK_KINDS[kind]}`,
  split: ({ links }) => `split link ${links[0]}`,
  join: ({ links }) => `join links ${links.join(' and ')}`,
  merge: ({ links }) => `merge links ${links.join(' and ')}`,
  dimension: ({ shown }) => `length ${number(shown.from.distanceTo(shown.to))}`,
  remove_dimension: () => 'remove a length',
};

// In words, with what of it is not in this drawing.
export function textOf(edit) {
  const missing = numMissing(edit);
  const text = VERBS[edit.edit]({
    ...edit,
    links: edit.links.map((link) => (link < 0 ? '?' : link)),
  });
  return missing === 0 ? text : `${text} (${missing} not in this drawing)`;
}

export function numMissing({ edit, links, stored }) {
  if (edit === 'remove_dimension') return stored < 0 ? 1 : 0;
  return links.filter((link) => link < 0).length;
}
