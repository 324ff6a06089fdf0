// SPDX-License-Identifier: BSD-3-Clause
// The help, and what the keys do.

import { make } from './dom.js';

const POINTER = [
  ['Drag', 'turn; with the right button, or two fingers, move'],
  ['Wheel, pinch', 'nearer and farther; over a photograph, enlarge it'],
  ['Tap a curve', 'what is known of it'],
  ['Tap a camera', 'look through it'],
  ['Tap twice', 'go there'],
  ['Shift and tap', 'select more links, or fewer'],
  ['Shift and drag', 'select with a box'],
];

export class Help {
  // `commands`: [{keys, label}].
  constructor(element, commands, unit) {
    this.element = element;
    const keyRows = (list) =>
      rows(
        list
          .filter(({ keys }) => keys.length > 0)
          .map(({ keys, label }) => [keys.join(' '), label]),
      );
    const rows = (list) =>
      list.map(([key, text]) =>
        make('tr', {}, make('th', { scope: 'row' }, make('kbd', {}, key)), make('td', {}, text)),
      );
    const close = () => element.close();
    element.append(
      make('button', { type: 'button', autofocus: true, onclick: close }, 'Close'),
      make(
        'div',
        { class: 'help' },
        make('section', {}, make('h2', {}, 'Pointer'), make('table', {}, ...rows(POINTER))),
        make('section', {}, make('h2', {}, 'Keys'), make('table', {}, ...keyRows(commands))),
      ),
      make('p', { class: 'faint' }, `Lengths and coordinates are in ${unit}.`),
      make(
        'p',
        { class: 'faint' },
        'Drawn with three.js; its license is in the source of this page.',
      ),
    );
  }

  toggle() {
    if (this.element.open) this.element.close();
    else this.element.showModal();
  }
}
