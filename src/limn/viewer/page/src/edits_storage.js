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
    return textOfEdits(this.editor.history.edits);
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
      this.replaceBy(parseEdits(await file.text()));
    } catch (error) {
      editor.show();
      editor.say(`${file.name}: ${error.message}. Nothing was loaded.`, true);
    }
  }

  // The loaded edits instead of those that there are; undone in one step.
  replaceBy(stored) {
    const { editor } = this;
    const list = resolveEdits(editor.drawing, stored, (before) => editor.state.show(before));
    editor.pointing.start(null);
    editor.selection.set([]);
    editor.setEdits(list);
    editor.markSaved();
    const missing = list.filter((edit) => numMissing(edit) > 0).length;
    const told = missing > 0 ? `; ${count(missing)} refer to what is not in this drawing` : '';
    editor.say(`${count(list.length)} edits loaded${told}.`, missing > 0);
  }
}
