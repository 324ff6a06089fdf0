// SPDX-License-Identifier: BSD-3-Clause
// edits.json: what `limn drawing_editor --edits` reads.

import { KINDS_TO_SET, LINK_KINDS } from './drawing.js';
import * as make from './edits.js';
import { LinkFinder, shiftShown } from './link_refs.js';

const FORMAT = 'limn_edits';
const VERSION = 1;
const MOST_POINTS = 16;

const endsOf = ({ refs, ends }) => refs.map((link, i) => ({ link, end: ends[i] }));
const pinsOf = ({ refs, at }) => refs.map((link, i) => ({ link, at: at[i] }));

const MEMBERS = {
  delete: ({ refs }) => ({ links: refs }),
  restore: ({ refs }) => ({ links: refs }),
  set_kind: ({ refs, kind }) => ({ links: refs, kind: LINK_KINDS[kind] }),
  split: ({ refs, at }) => ({ link: refs[0], at }),
  join: (edit) => ({ ends: endsOf(edit) }),
  merge: ({ refs }) => ({ links: refs }),
  dimension: (edit) => ({ from: pinsOf(edit)[0], to: pinsOf(edit)[1], shift: edit.shift }),
  remove_dimension: ({ at }) => ({ from: at[0], to: at[1] }),
};

// An edit per line. `stamp`: of the drawing that they are of.
export function textOfEdits(edits, stamp) {
  const lines = edits.map((edit) =>
    JSON.stringify({ edit: edit.edit, ...MEMBERS[edit.edit](edit) }),
  );
  const drawing = stamp.fingerprint ? `\n "drawing": ${JSON.stringify(stamp)},` : '';
  const head = `{"format": "${FORMAT}", "format_version": ${VERSION},${drawing}\n "edits": [`;
  return `${head}${lines.length > 0 ? `\n  ${lines.join(',\n  ')}\n ` : ''}]}\n`;
}

// Checks of what a file holds: they name the place in the file.
function check(passes, place, message) {
  if (!passes) throw new Error(`${place}: ${message}`);
}

function checkObject(value, place) {
  check(
    typeof value === 'object' && value !== null && !Array.isArray(value),
    place,
    'must be an object',
  );
}

function checkPlace(value, place) {
  const isPlace = Array.isArray(value) && value.length === 3 && value.every(Number.isFinite);
  check(isPlace, place, 'must be three numbers');
}

function checkRef(ref, place) {
  checkObject(ref, place);
  check(Number.isInteger(ref.id) && ref.id >= -1, `${place}.id`, 'must be a whole number from -1');
  check(typeof ref.closed === 'boolean', `${place}.closed`, 'must be true or false');
  const { points } = ref;
  const isList = Array.isArray(points) && points.length >= 2 && points.length <= MOST_POINTS;
  check(isList, `${place}.points`, `must be a list of 2 to ${MOST_POINTS} points`);
  points.forEach((point, i) => checkPlace(point, `${place}.points[${i}]`));
}

function checkLinks(links, place, needed = null) {
  const isList = Array.isArray(links) && links.length >= 1;
  check(isList, place, 'must be a list of links');
  check(needed === null || links.length === needed, place, `must be ${needed} links`);
  links.forEach((ref, i) => checkRef(ref, `${place}[${i}]`));
}

function checkEnds(ends, place) {
  check(Array.isArray(ends) && ends.length === 2, place, 'must be two ends');
  ends.forEach((end, i) => {
    checkObject(end, `${place}[${i}]`);
    checkRef(end.link, `${place}[${i}].link`);
    check(end.end === 0 || end.end === 1, `${place}[${i}].end`, 'must be 0 or 1');
  });
}

function checkPin(pin, place) {
  checkObject(pin, place);
  checkRef(pin.link, `${place}.link`);
  checkPlace(pin.at, `${place}.at`);
}

const CHECKS = {
  delete: (json, place) => checkLinks(json.links, `${place}.links`),
  restore: (json, place) => checkLinks(json.links, `${place}.links`),
  set_kind(json, place) {
    checkLinks(json.links, `${place}.links`);
    const isKind = KINDS_TO_SET.includes(json.kind);
    check(isKind, `${place}.kind`, `must be one of ${KINDS_TO_SET.join(', ')}`);
  },
  split(json, place) {
    checkRef(json.link, `${place}.link`);
    checkPlace(json.at, `${place}.at`);
  },
  join: (json, place) => checkEnds(json.ends, `${place}.ends`),
  merge: (json, place) => checkLinks(json.links, `${place}.links`, 2),
  dimension(json, place) {
    checkPin(json.from, `${place}.from`);
    checkPin(json.to, `${place}.to`);
    checkPlace(json.shift, `${place}.shift`);
  },
  remove_dimension(json, place) {
    checkPlace(json.from, `${place}.from`);
    checkPlace(json.to, `${place}.to`);
  },
};

function checkStamp(stamp) {
  checkObject(stamp, 'drawing');
  check(typeof stamp.name === 'string', 'drawing.name', 'must be a text');
  check(typeof stamp.fingerprint === 'string', 'drawing.fingerprint', 'must be a text');
}

// The edits of a file as it holds them, and the stamp of the drawing that they were made of, if it
// has one: {edits, stamp}. Throws an Error with the place and the reason.
export function parseEdits(text) {
  let json;
  try {
    json = JSON.parse(text);
  } catch (error) {
    throw new Error(`is not JSON: ${error.message}`);
  }
  const isOurs = typeof json === 'object' && json !== null && json.format === FORMAT;
  if (!isOurs) throw new Error(`is not a file of edits: it has no "format": "${FORMAT}"`);
  check(json.format_version === VERSION, 'format_version', `must be ${VERSION}`);
  if (json.drawing !== undefined) checkStamp(json.drawing);
  check(Array.isArray(json.edits), 'edits', 'must be a list');
  json.edits.forEach((edit, i) => {
    const place = `edits[${i}]`;
    checkObject(edit, place);
    const known = Object.keys(CHECKS);
    check(known.includes(edit.edit), `${place}.edit`, `must be one of ${known.join(', ')}`);
    CHECKS[edit.edit](edit, place);
  });
  return { edits: json.edits, stamp: json.drawing ?? null };
}

function numberOfDimension(drawing, at) {
  const places = at.map((place) => drawing.fromModel(place));
  const tolerance = 1e-4 * drawing.radius;
  return drawing.storedDimensions.findIndex(({ from, to }) =>
    [from, to].every((place, i) => place.distanceTo(places[i]) < tolerance),
  );
}

// Edits on the links of this drawing as they are now.
const RESOLVE = {
  delete: (drawing, find, { links }) => make.deletion(drawing, links.map(find), links),
  restore: (drawing, find, { links }) => make.firming(drawing, links.map(find), links),
  set_kind: (drawing, find, { links, kind }) =>
    make.kindChange(drawing, links.map(find), LINK_KINDS.indexOf(kind), links),
  split(drawing, find, { link, at }) {
    const refs = [link];
    const edit = make.splitting(drawing, find(link), drawing.fromModel(at), refs);
    return edit ? { ...edit, at } : make.splitting(drawing, -1, drawing.fromModel(at), refs);
  },
  join(drawing, find, { ends }, finder) {
    const refs = ends.map(({ link }) => link);
    const links = refs.map(find);
    const at = links.map((link, i) =>
      link < 0 ? ends[i].end : finder.endOf(link, refs[i], ends[i].end),
    );
    const edit = make.joining(drawing, links, at, refs);
    // The file goes on to say what it said, also of links that run the other way here.
    return { ...edit, refs: refs.map((ref, i) => turned(ref, at[i] !== ends[i].end)) };
  },
  merge(drawing, find, { links }) {
    const edit = make.merging(drawing, links.map(find), links);
    return edit ?? make.merging(drawing, [-1, -1], links);
  },
  dimension(drawing, find, { from, to, shift }) {
    const refs = [from.link, to.link];
    const [start, end] = [from.at, to.at].map((place) => drawing.fromModel(place));
    const shown = { from: start, to: end, shift: shiftShown(drawing, shift) };
    const edit = make.dimensioning(drawing, refs.map(find), shown, refs);
    return { ...edit, at: [from.at, to.at], shift };
  },
  remove_dimension(drawing, find, { from, to }) {
    return make.dimensionRemoval(numberOfDimension(drawing, [from, to]), [from, to]);
  },
};

function turned(ref, isTurned) {
  return isTurned ? { ...ref, points: [...ref.points].reverse() } : ref;
}

// Edits of a file on this drawing. `show(edits)` must make the drawing what the edits so far make
// of it, since each refers to links as those before it have left them.
export function resolveEdits(drawing, stored, show) {
  const edits = [];
  const finder = new LinkFinder(drawing);
  for (const json of stored) {
    show(edits);
    edits.push(RESOLVE[json.edit](drawing, (ref) => finder.find(ref), json, finder));
  }
  return edits;
}
