// SPDX-License-Identifier: BSD-3-Clause
// Edits that are in no file yet, kept by the browser: closing the page loses none. Every opening of a
// page has an entry of its own, so that none is written over.

const PREFIX = 'limn-edits ';
const DELAY_MS = 500;
const MOST_CHARACTERS = 1 << 21;

// Null where the browser grants none.
function storage() {
  try {
    return window.localStorage;
  } catch {
    return null;
  }
}

function parsed(key, text) {
  try {
    const [title, fingerprint] = JSON.parse(key.slice(PREFIX.length));
    const { path, time, count, text: edits } = JSON.parse(text);
    const isWhole = typeof edits === 'string' && Number.isFinite(time) && Number.isInteger(count);
    return isWhole ? { key, title, fingerprint, path, time, count, text: edits } : null;
  } catch {
    return null;
  }
}

export class KeptEdits {
  // on.trouble(text), once.
  constructor({ title, stamp }, on) {
    Object.assign(this, { title, fingerprint: stamp.fingerprint, on });
    this.key = PREFIX + JSON.stringify([title, stamp.fingerprint, Date.now(), Math.random()]);
    this.pending = null; // {count, text()} to be written
    this.timer = 0;
    window.addEventListener('pagehide', () => this.flush());
  }

  // What other openings of this page have left, or of an earlier page of this place: latest first,
  // those of the same drawing before all others.
  left() {
    try {
      return this.found(storage());
    } catch {
      return []; // a damaged storage
    }
  }

  found(store) {
    const keys = Array.from({ length: store?.length ?? 0 }, (_, i) => store.key(i));
    const isSame = (entry) => entry.fingerprint === this.fingerprint;
    return keys
      .filter((key) => key.startsWith(PREFIX) && key !== this.key)
      .map((key) => parsed(key, store.getItem(key)))
      .filter((entry) => entry?.title === this.title)
      .filter((entry) => isSame(entry) || entry.path === window.location.pathname)
      .sort((a, b) => isSame(b) - isSame(a) || b.time - a.time);
  }

  forget({ key }) {
    try {
      storage()?.removeItem(key);
    } catch {
      // a damaged storage: what it keeps is offered again, if it can be read
    }
  }

  // Soon; `text()` gives the file.
  keep(count, text) {
    this.pending = { count, text };
    clearTimeout(this.timer);
    this.timer = setTimeout(() => this.flush(), DELAY_MS);
  }

  drop() {
    this.pending = null;
    clearTimeout(this.timer);
    this.forget(this);
  }

  // Whether all is kept.
  flush() {
    clearTimeout(this.timer);
    if (!this.pending) return true;
    const { count, text } = this.pending;
    this.pending = null;
    try {
      this.write(count, text());
      return true;
    } catch (error) {
      this.on.trouble(`The browser does not keep the edits (${error.message}): download them.`);
      this.on.trouble = () => {};
      return false;
    }
  }

  write(count, text) {
    const store = storage();
    if (!store) throw new Error('it grants no storage');
    if (text.length > MOST_CHARACTERS) throw new Error('they are too many');
    const path = window.location.pathname;
    store.setItem(this.key, JSON.stringify({ path, time: Date.now(), count, text }));
  }
}
