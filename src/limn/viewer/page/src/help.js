// The help, and what the keys do.

import { make } from './dom.js';

const POINTER = [
  ['Drag', 'turn; with the right button, or two fingers, move'],
  ['Wheel, pinch', 'nearer and farther; over a photograph, enlarge it'],
  ['Tap a curve', 'what is known of it'],
  ['Tap a camera', 'look through it'],
  ['Tap twice', 'go there'],
];

export class Help {
  // `commands`: [{keys, label}].
  constructor(element, commands) {
    this.element = element;
    const rows = (list) =>
      list.map(([key, text]) =>
        make('tr', {}, make('th', { scope: 'row' }, make('kbd', {}, key)), make('td', {}, text)),
      );
    element.append(
      make('h2', {}, 'Pointer'),
      make('table', {}, ...rows(POINTER)),
      make('h2', {}, 'Keys'),
      make('table', {}, ...rows(commands.map(({ keys, label }) => [keys.join(' '), label]))),
      make('p', { class: 'faint' }, 'Lengths and coordinates are in the units of the model.'),
      make(
        'p',
        { class: 'faint' },
        'Drawn with three.js, whose licence is in the source of this page.',
      ),
      make('button', { type: 'button', onclick: () => element.close() }, 'Close'),
    );
  }

  toggle() {
    if (this.element.open) this.element.close();
    else this.element.showModal();
  }
}
