// SPDX-License-Identifier: BSD-3-Clause
// edits.json to and from the disk and the clipboard.

import { download } from './download.js';
import { numMissing } from './edits.js';
import { parseEdits, resolveEdits, textOfEdits } from './edits_file.js';
import { count } from './format.js';

const FILE_NAME = 'edits.json';
const MOST_BYTES = 1 << 28;

export class EditsStorage {
  constructor(editor) {
    this.editor = editor;
  }

  text() {
    return textOfEdits(this.editor.history.edits, this.editor.drawing.stamp);
  }

  save() {
    download(new Blob([this.text()], { type: 'application/json' }), FILE_NAME);
    this.editor.markSaved();
  }

  async copy() {
    const { editor } = this;
    try {
      await navigator.clipboard.writeText(this.text());
      editor.markSaved();
      editor.say('The edits are in the clipboard: paste them into a file edits.json.');
    } catch (error) {
      editor.say(
        `The browser does not let the page copy (${error.message}): download instead.`,
        true,
      );
    }
  }

  async load(file) {
    const { editor } = this;
    try {
      if (file.size > MOST_BYTES) throw new Error('is too large');
      this.replaceBy(await file.text());
      editor.markSaved();
    } catch (error) {
      this.sayFailure(file.name, error);
    }
  }

  // Those that the browser has kept, instead of those that there are. Returns whether it went well.
  takeUp(text) {
    try {
      this.replaceBy(text);
      return true;
    } catch (error) {
      this.sayFailure('The kept edits', error);
      return false;
    }
  }

  sayFailure(name, error) {
    this.editor.show();
    this.editor.say(`${name}: ${error.message}. Nothing was loaded.`, true);
  }

  // The edits of a file instead of those that there are; undone in one step. Throws an Error.
  replaceBy(text) {
    const { editor } = this;
    const { edits, stamp } = parseEdits(text);
    const list = resolveEdits(editor.drawing, edits, (before) => editor.state.show(before));
    editor.pointing.start(null);
    editor.selection.set([]);
    editor.setEdits(list);
    const missing = list.filter((edit) => numMissing(edit) > 0).length;
    const told = missing > 0 ? `; ${count(missing)} refer to what is not in this drawing` : '';
    const { fingerprint } = editor.drawing.stamp;
    const isOther = stamp && fingerprint && stamp.fingerprint !== fingerprint;
    const other = isOther ? ', made of another state of the drawing' : '';
    editor.say(`${count(list.length)} edits loaded${other}${told}.`, missing > 0);
  }
}
