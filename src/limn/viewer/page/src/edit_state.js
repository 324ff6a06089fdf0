// SPDX-License-Identifier: BSD-3-Clause
// What a list of edits makes of the drawing, as a preview: which links there are, their kinds, what
// is drawn beside them. All of it is made anew from the list, so that undoing is forgetting.

import { DELETED, GONE, LIVE } from './drawing.js';

// Links that an edit names but that are not in this drawing are -1.
const known = (links) => links.filter((link) => link >= 0);

function replace(drawing, { links, makes }) {
  for (const link of links) drawing.gone[link] = GONE;
  for (const made of makes) {
    drawing.gone[made] = LIVE;
    for (const name of ['linkKind', 'kindConfidence', 'linkTentative']) {
      drawing[name][made] = drawing[name][links[0]];
    }
  }
}

const APPLY = {
  delete(drawing, { links }) {
    for (const link of known(links)) drawing.gone[link] = DELETED;
  },
  restore(drawing, { links }) {
    for (const link of known(links)) drawing.linkTentative[link] = 0;
  },
  set_kind(drawing, { links, kind }) {
    for (const link of known(links)) {
      drawing.linkKind[link] = kind;
      drawing.kindConfidence[link] = 1;
    }
  },
  split(drawing, edit, preview) {
    if (edit.makes.length === 0) return;
    replace(drawing, edit);
    preview.cuts.push(edit.place);
  },
  join(drawing, edit, preview) {
    const { links, ends } = edit;
    if (links.includes(-1)) return;
    preview.connections.push(links.map((link, i) => drawing.endPosition(link, ends[i])));
    if (edit.makes.length > 0) replace(drawing, edit);
    else preview.sameNodes.push(links.map((link, i) => drawing.linkNodes[2 * link + ends[i]]));
  },
  merge(drawing, { links }) {
    if (links.includes(-1)) return;
    const [a, b] = links;
    drawing.gone[drawing.linkLength[a] < drawing.linkLength[b] ? a : b] = GONE;
  },
  dimension(drawing, edit, preview) {
    preview.dimensions.push({ ...edit.shown, edit });
  },
  remove_dimension(drawing, { stored }, preview) {
    preview.removed.add(stored);
  },
};

export class EditState {
  constructor(drawing) {
    this.drawing = drawing;
    this.stored = ['linkKind', 'kindConfidence', 'linkTentative'].map((name) => [
      name,
      drawing[name].slice(),
    ]);
  }

  // {connections: [[from, to]], cuts: [place], dimensions: [{from, to, shift, edit}], removed: set of
  // numbers of dimensions of the file}.
  show(edits) {
    const { drawing } = this;
    drawing.gone.fill(LIVE, 0, drawing.numStored).fill(GONE, drawing.numStored);
    const wasTentative = drawing.linkTentative.slice();
    for (const [name, values] of this.stored) drawing[name].set(values);
    const preview = { connections: [], cuts: [], dimensions: [], removed: new Set() };
    preview.sameNodes = [];
    for (const edit of edits) APPLY[edit.edit](drawing, edit, preview);
    drawing.sortKinds();
    this.countDegrees(preview.sameNodes);
    // What has been made firm is looked at.
    wasTentative.forEach((was, link) => {
      if (was && !drawing.linkTentative[link]) drawing.visible[link] = 1;
    });
    return preview;
  }

  countDegrees(sameNodes) {
    const { drawing } = this;
    drawing.countDegrees();
    for (const [a, b] of sameNodes) {
      if (a === b) continue;
      drawing.degree[a] += drawing.degree[b];
      drawing.degree[b] = drawing.degree[a];
    }
  }
}
