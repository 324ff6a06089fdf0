// SPDX-License-Identifier: BSD-3-Clause
// The bar under a photograph that is looked through.

import { make } from './dom.js';

export class PhotoBar {
  // on.step(-1 or 1), on.opacity(0 to 1), on.leave().
  constructor(element, opacity, on) {
    this.element = element;
    this.name = make('strong', { id: 'photo-name' });
    const slider = make('input', {
      ...{ type: 'range', id: 'opacity', min: '0', max: '1', step: '0.01' },
      oninput: (event) => on.opacity(Number(event.target.value)),
    });
    slider.value = String(opacity);
    const button = (label, text, onclick) =>
      make('button', { type: 'button', 'aria-label': label, title: label, onclick }, text);
    element.append(
      button('Previous photograph', '‹', () => on.step(-1)),
      this.name,
      button('Next photograph', '›', () => on.step(1)),
      make('label', {}, 'Photograph', slider),
      button('Leave the photograph', 'Leave', on.leave),
    );
  }

  show(view) {
    this.element.hidden = view === null;
    this.name.textContent = view?.name ?? '';
    this.name.title = view?.name ?? '';
  }
}
