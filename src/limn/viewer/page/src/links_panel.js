// SPDX-License-Identifier: BSD-3-Clause
// The tab "Links": search, the list of links and all about the picked one.

import { facts, make } from './dom.js';
import { BODY_SHAPES, DENSE_CLASSES, LINK_KINDS, NODE_KINDS, PRIMITIVES, ROD } from './drawing.js';
import { count, degrees, measured, number, percent } from './format.js';
import { measureLink } from './uncertainty.js';

const PAGE = 100;

function primitiveText(drawing, link) {
  const name = PRIMITIVES[drawing.primitiveType[link]];
  if (name === 'none') return drawing.hasPrimitives ? 'none' : null;
  const radius = `radius ${number(drawing.primitiveRadius[link])}`;
  if (name === 'circle') return `circle, ${radius}`;
  if (name === 'arc') return `arc, ${radius}, ${degrees(drawing.primitiveSweep[link])}`;
  if (name === 'spline') return `spline, ${drawing.primitiveControls[link]} control points`;
  return name;
}

function primitiveFit(drawing, link) {
  if (drawing.primitiveType[link] === 0) return null;
  const rms = number(drawing.primitiveRms[link], 3);
  return `${rms} px rms, at most ${number(drawing.primitiveMax[link], 3)} px`;
}

function classText(drawing, link) {
  if (!drawing.hasClasses) return null;
  const fold = drawing.denseFold[link];
  const parts = [DENSE_CLASSES[drawing.denseClass[link]]];
  if (fold >= 0) parts.push(`folded by ${number(fold, 3)}°`);
  if (drawing.denseBehind[link]) parts.push('behind the surface');
  return parts.join(', ');
}

function kindText(drawing, link) {
  const name = LINK_KINDS[drawing.linkKind[link]];
  const confidence = drawing.kindConfidence[link];
  const parts = [confidence > 0 ? `${name} (${percent(confidence)})` : name];
  if (drawing.linkTentative[link]) parts.push('tentative');
  return parts.join(', ');
}

function existsText(drawing, link) {
  const confidence = drawing.linkConfidence[link];
  return confidence >= 0 ? percent(confidence) : null;
}

function rodText(drawing, link) {
  return drawing.linkKind[link] === ROD ? number(drawing.rodRadius[link]) : null;
}

function nodeText(drawing, node) {
  return `${node}, ${NODE_KINDS[drawing.nodeKind[node]]}`;
}

function bodyText(drawing, link) {
  const shape = drawing.bodyShape[link];
  if (shape === 0 || LINK_KINDS[drawing.linkKind[link]] !== 'contour') return null;
  const radius = number(drawing.bodyRadius[link]);
  const sigma = number(drawing.bodyRadiusSigma[link], 2);
  return `${BODY_SHAPES[shape]}, radius ${radius} ± ${sigma} ${drawing.unit}`;
}

function linkFacts(drawing, link) {
  const added = drawing.hasClasses ? percent(drawing.denseAdded[link]) : null;
  const { length, sigma } = measureLink(drawing, link);
  return facts([
    [`Length, ${drawing.unit}`, measured(length, sigma)],
    ['Primitive', primitiveText(drawing, link)],
    ['Its fit', primitiveFit(drawing, link)],
    ['Residual', `${number(drawing.linkResidual[link], 3)} px`],
    ['Sigma (median)', number(drawing.medianSigma(link), 3)],
    ['Probability that it exists', existsText(drawing, link)],
    ['Kind of edge', drawing.hasKinds ? kindText(drawing, link) : null],
    [`Radius of the rod, ${drawing.unit}`, rodText(drawing, link)],
    ['Outline of a', bodyText(drawing, link)],
    ['Class', classText(drawing, link)],
    ['No dense point near', added],
    ['Component', String(drawing.component[link])],
    ['From node', nodeText(drawing, drawing.linkNodes[2 * link])],
    ['To node', nodeText(drawing, drawing.linkNodes[2 * link + 1])],
    ['Vertices', count(drawing.range(link)[1] - drawing.range(link)[0])],
  ]);
}

export class LinksPanel {
  // on.pick(link), on.focus(link), on.view(view).
  constructor(drawing, on) {
    this.drawing = drawing;
    this.on = on;
    this.shown = PAGE;
    this.picked = null;
    this.details = make('div', { id: 'link-details', role: 'status', 'aria-live': 'polite' });
    this.search = make('input', {
      ...{ type: 'search', id: 'search', inputmode: 'numeric', placeholder: 'e.g. 12' },
      oninput: () => this.refill(),
      onkeydown: (event) => {
        if (event.key === 'Enter') this.pickFirst();
      },
    });
    this.rows = make('div', { class: 'rows', id: 'links' });
    const label = make('label', { for: 'search' }, 'Search by the number of a link');
    this.content = [
      this.details,
      make('section', {}, make('div', { class: 'field' }, label, this.search), this.rows),
    ];
    this.show(null);
    this.rank();
  }

  // Call it when the links have changed.
  rank() {
    const { drawing } = this;
    const links = Array.from({ length: drawing.numLinks }, (_, link) => link);
    this.ranked = links
      .filter((link) => drawing.isLive(link))
      .sort((a, b) => drawing.linkLength[b] - drawing.linkLength[a] || a - b);
    this.fillRows();
  }

  // The link of the number first, then those that begin with it; all without one.
  matches() {
    const text = this.search.value.trim();
    if (text === '') return this.ranked;
    const begins = this.ranked.filter((link) => String(link).startsWith(text));
    return begins.sort((a, b) => String(a).length - String(b).length || a - b);
  }

  pickFirst() {
    const [first] = this.matches();
    if (first !== undefined) this.on.focus(first);
  }

  refill() {
    this.shown = PAGE;
    this.fillRows();
  }

  fillRows() {
    const matches = this.matches();
    const rows = matches.slice(0, this.shown).map((link) => this.row(link));
    if (matches.length === 0) rows.push(make('p', { class: 'faint' }, 'No link has this number.'));
    if (matches.length > this.shown) {
      const more = () => {
        this.shown += PAGE;
        this.fillRows();
      };
      rows.push(
        make(
          'button',
          { type: 'button', onclick: more },
          'More',
          `${count(matches.length - this.shown)} links`,
        ),
      );
    }
    this.rows.replaceChildren(...rows);
  }

  row(link) {
    const { drawing } = this;
    const primitive = PRIMITIVES[drawing.primitiveType[link]];
    return make(
      'button',
      {
        ...{ type: 'button', 'data-link': link, 'aria-pressed': String(link === this.picked) },
        onclick: () => this.on.focus(link),
      },
      make('span', {}, `#${link}`),
      make('span', {}, primitive === 'none' ? '' : primitive),
      make('span', {}, number(drawing.linkLength[link], 4)),
    );
  }

  show(link) {
    this.picked = link;
    this.rows?.querySelectorAll('[data-link]').forEach((row) => {
      row.setAttribute('aria-pressed', String(Number(row.dataset.link) === link));
    });
    if (link === null) {
      const hint = 'Tap a curve to see what is known of it; tap twice to go there.';
      this.details.replaceChildren(make('p', { class: 'faint' }, hint));
      return;
    }
    this.details.replaceChildren(
      make('h2', {}, `Link ${link}`),
      ...this.edited(link),
      linkFacts(this.drawing, link),
      make(
        'div',
        { class: 'actions' },
        make('button', { type: 'button', onclick: () => this.on.focus(link) }, 'Go there'),
        make('button', { type: 'button', onclick: () => this.on.pick(null) }, 'Clear'),
      ),
      make('h2', {}, `Supporting views (${this.drawing.numSupportingViews(link)})`),
      this.viewChips(link),
    );
  }

  edited(link) {
    const { drawing } = this;
    const notes = [];
    if (link >= drawing.numStored) notes.push('Made by an edit; not fitted to photographs yet.');
    if (!drawing.isLive(link)) notes.push('Deleted.');
    return notes.map((note) => make('p', { class: 'faint' }, note));
  }

  viewChips(link) {
    const chips = Array.from(this.drawing.supportingViews(link), (view) => {
      const { name } = this.drawing.views[view];
      return make('button', { type: 'button', onclick: () => this.on.view(view) }, name);
    });
    return make('div', { class: 'chips' }, ...chips);
  }
}
