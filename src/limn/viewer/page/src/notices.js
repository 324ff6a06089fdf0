// SPDX-License-Identifier: BSD-3-Clause
// Lines over the picture that stay until they are answered.

import { make } from './dom.js';

export class Notices {
  constructor(element) {
    this.element = element;
  }

  // `answers`: {label, run}; each also takes the line away.
  add(text, answers) {
    const line = make('div', { class: 'notice' }, make('span', {}, text));
    const buttons = answers.map(({ label, run }) => {
      const onclick = () => {
        line.remove();
        run();
      };
      return make('button', { type: 'button', onclick }, label);
    });
    line.append(...buttons);
    this.element.append(line);
  }
}
