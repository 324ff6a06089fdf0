// SPDX-License-Identifier: BSD-3-Clause
// The tab "Edit".

import { make } from './dom.js';
import { lengthText } from './dimensions.js';
import { KINDS_TO_SET, LINK_KINDS } from './drawing.js';
import { textOf } from './edits.js';
import { count, number } from './format.js';

const LATEST = 12;

function selectOfKinds(id, names) {
  const options = names.map((name) => make('option', { value: LINK_KINDS.indexOf(name) }, name));
  return make('select', { id }, ...options);
}

const row = (...children) => make('div', { class: 'actions' }, ...children);

export class EditsPanel {
  // `on`: the editor; `commands`: by the names of their buttons here.
  constructor(drawing, on, commands) {
    this.drawing = drawing;
    this.on = on;
    this.buttons = new Map();
    for (const { button, label, keys, run } of commands) {
      const title = keys.length > 0 ? `${label} (${keys[0]})` : label;
      this.buttons.set(button, make('button', { type: 'button', title, onclick: run }, button));
    }
    this.status = make('p', { id: 'edit-selection', role: 'status', 'aria-live': 'polite' });
    this.state = make('p', { id: 'edit-state', class: 'faint' });
    this.latest = make('ol', { id: 'edit-list', class: 'edits', reversed: true });
    this.lengths = make('div', { id: 'edit-lengths' });
    this.content = [
      make(
        'section',
        {},
        row(this.button('Undo'), this.button('Redo'), this.button('Delete')),
        ...this.selecting(),
        ...this.changing(),
      ),
      make('section', {}, ...this.listing(), ...this.filing()),
    ];
  }

  button(name) {
    return this.buttons.get(name);
  }

  selecting() {
    this.kindToPick = selectOfKinds('pick-kind', LINK_KINDS);
    this.kindToPick.setAttribute('aria-label', 'Kind of the links to select');
    const ofKind = () => this.on.selectKind(Number(this.kindToPick.value));
    this.length = make('input', {
      ...{ type: 'number', id: 'pick-length', min: '0', step: 'any', inputmode: 'decimal' },
      onkeydown: (event) => {
        if (event.key === 'Enter') this.selectShorter();
      },
    });
    const shorter = make('label', { for: 'pick-length' }, `Shorter than, ${this.drawing.unit}`);
    const act = (text, id, onclick) => make('button', { type: 'button', id, onclick }, text);
    return [
      make('h2', {}, 'Select'),
      this.status,
      row(this.button('Box'), this.button('Add'), this.button('Clear')),
      make('div', { class: 'pair' }, this.kindToPick, act('Select kind', 'select-kind', ofKind)),
      shorter,
      make(
        'div',
        { class: 'pair' },
        this.length,
        act('Select shorter', 'select-shorter', () => this.selectShorter()),
      ),
    ];
  }

  selectShorter() {
    const length = Number(this.length.value);
    if (length > 0) this.on.selectShorter(length);
    else this.on.say('Give a length above zero.', true);
  }

  changing() {
    this.kindToSet = selectOfKinds('set-kind', KINDS_TO_SET);
    this.kindToSet.setAttribute('aria-label', 'Kind to set');
    this.setKind = make(
      'button',
      {
        type: 'button',
        id: 'apply-kind',
        onclick: () => this.on.setKind(Number(this.kindToSet.value)),
      },
      'Set kind',
    );
    return [
      make('h2', {}, 'Change'),
      row(this.button('Restore'), this.button('Merge')),
      make('div', { class: 'pair' }, this.kindToSet, this.setKind),
      row(this.button('Join'), this.button('Split'), this.button('Length')),
      row(this.button('Show deleted')),
    ];
  }

  listing() {
    return [make('h2', {}, 'Edits'), this.state, this.latest, this.lengths];
  }

  filing() {
    this.file = make('input', {
      ...{ type: 'file', id: 'edits-file', accept: '.json,application/json', class: 'hidden-file' },
      ...{ 'aria-label': 'File of edits', tabindex: -1 },
      onchange: () => {
        const [file] = this.file.files;
        if (file) this.on.storage.load(file);
        this.file.value = ''; // so that the same file can be chosen again
      },
    });
    return [
      make('h2', {}, 'File'),
      row(this.button('Download'), this.button('Copy'), this.button('Load'), this.file),
      make(
        'p',
        { class: 'faint' },
        'What is drawn is a preview: joins are straight, and of two merged links the longer one is left. ',
        make('code', {}, 'limn drawing_editor --edits edits.json'),
        ' applies the edits to drawing.json and fits what they touch to the photographs.',
      ),
    ];
  }

  showSelection({ selection, canDelete, canRestore, canMerge }) {
    const { size } = selection;
    const length = [...selection.links].reduce(
      (sum, link) => sum + this.drawing.linkLength[link],
      0,
    );
    this.status.textContent =
      size === 0
        ? 'Nothing is selected. Tap a curve; with Shift, or Add, tap or draw a box to add more.'
        : `${count(size)} ${size === 1 ? 'link' : 'links'}, ${number(length)} ${this.drawing.unit}`;
    this.button('Clear').disabled = size === 0;
    this.button('Delete').disabled = !canDelete;
    this.setKind.disabled = !canDelete;
    this.button('Restore').disabled = !canRestore;
    this.button('Merge').disabled = !canMerge;
  }

  // `pressed`: by the names of buttons.
  showTools(pressed) {
    for (const [name, isOn] of Object.entries(pressed)) {
      this.button(name).setAttribute('aria-pressed', String(isOn));
    }
  }

  showHistory(history) {
    const { edits, past, future } = history;
    this.button('Undo').disabled = past.length === 0;
    this.button('Redo').disabled = future.length === 0;
    const name = edits.length === 1 ? 'edit' : 'edits';
    const saved = history.isSaved ? '' : ', not downloaded yet';
    this.state.textContent =
      edits.length === 0 ? 'None yet.' : `${count(edits.length)} ${name}${saved}`;
    const latest = edits.slice(-LATEST).reverse();
    this.latest.start = edits.length;
    this.latest.replaceChildren(...latest.map((edit) => make('li', {}, textOf(edit))));
  }

  // [{from, to, onRemove}]
  showLengths(lengths) {
    const rows = lengths.map((length) => {
      const text = `${lengthText(this.drawing, length)} ${this.drawing.unit}`;
      const remove = make(
        'button',
        { type: 'button', 'aria-label': `Remove the length ${text}`, onclick: length.onRemove },
        'Remove',
      );
      return make('div', { class: 'pair' }, make('span', {}, text), remove);
    });
    const heading = rows.length > 0 ? [make('h2', {}, 'Lengths')] : [];
    this.lengths.replaceChildren(...heading, ...rows);
  }
}
