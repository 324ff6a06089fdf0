// SPDX-License-Identifier: BSD-3-Clause
// Dark or light: as the system says until the user says otherwise.

export class Theme {
  constructor() {
    this.system = window.matchMedia('(prefers-color-scheme: dark)');
    this.chosen = null;
    this.onChange = () => {};
    this.system.addEventListener('change', () => this.apply());
    this.apply();
  }

  get isDark() {
    return this.chosen ?? this.system.matches;
  }

  toggle() {
    this.chosen = !this.isDark;
    this.apply();
  }

  apply() {
    document.documentElement.dataset.theme = this.isDark ? 'dark' : 'light';
    this.onChange();
  }

  // The value of a variable of style.css.
  color(name) {
    return getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim();
  }
}
