// SPDX-License-Identifier: BSD-3-Clause
// The tabs beside the picture.

import { make } from './dom.js';

export class Sidebar {
  // `tabs`: [{id, label, content: [elements], isWide}].
  constructor(element, tabs) {
    this.element = element;
    this.tabs = tabs.map((tab, index) => ({
      ...tab,
      button: make(
        'button',
        {
          ...{
            type: 'button',
            role: 'tab',
            id: `tab-${tab.id}`,
            'aria-controls': `panel-${tab.id}`,
          },
          onclick: () => this.show(tab.id),
          onkeydown: (event) => this.step(event, index),
        },
        tab.label,
      ),
      panel: make(
        'div',
        {
          ...{ class: 'panel', role: 'tabpanel', id: `panel-${tab.id}` },
          'aria-labelledby': `tab-${tab.id}`,
        },
        ...tab.content,
      ),
    }));
    element.append(
      make(
        'div',
        { class: 'tabs', role: 'tablist', 'aria-label': 'Panels' },
        ...this.tabs.map(({ button }) => button),
      ),
      ...this.tabs.map(({ panel }) => panel),
    );
    this.show(this.tabs[0].id);
  }

  show(id) {
    this.current = id;
    for (const tab of this.tabs) {
      const isShown = tab.id === id;
      tab.button.setAttribute('aria-selected', isShown);
      tab.button.tabIndex = isShown ? 0 : -1;
      tab.panel.hidden = !isShown;
      if (isShown) this.element.classList.toggle('wide', tab.isWide ?? false);
    }
    this.element.hidden = false;
  }

  // Arrow keys go from tab to tab, as screen readers expect.
  step(event, index) {
    const step = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
    if (!step) return;
    const next = this.tabs[(index + step + this.tabs.length) % this.tabs.length];
    this.show(next.id);
    next.button.focus();
  }

  isShown(id) {
    return !this.element.hidden && this.current === id;
  }

  toggle() {
    this.element.hidden = !this.element.hidden;
  }
}
