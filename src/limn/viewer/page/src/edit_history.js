// SPDX-License-Identifier: BSD-3-Clause
// The list of edits, with undo and redo. Lists are never changed, only replaced.

export class EditHistory {
  constructor() {
    this.edits = [];
    this.saved = this.edits;
    this.past = [];
    this.future = [];
  }

  get isSaved() {
    return this.edits === this.saved || (this.edits.length === 0 && this.saved.length === 0);
  }

  set(edits) {
    this.past.push(this.edits);
    this.future = [];
    this.edits = edits;
  }

  undo() {
    if (this.past.length === 0) return false;
    this.future.push(this.edits);
    this.edits = this.past.pop();
    return true;
  }

  redo() {
    if (this.future.length === 0) return false;
    this.past.push(this.edits);
    this.edits = this.future.pop();
    return true;
  }

  markSaved() {
    this.saved = this.edits;
  }
}
