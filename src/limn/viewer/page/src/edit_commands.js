// SPDX-License-Identifier: BSD-3-Clause
// What keys and the buttons of the tab "Edit" do: {keys, label, button, run}.

import { KINDS_TO_SET, LINK_KINDS } from './drawing.js';

export function editCommands(editor) {
  const tool = (keys, id, button, label) => ({
    ...{ keys, button, label },
    run: () => editor.pointing.toggle(id),
  });
  const kinds = KINDS_TO_SET.map((name) => ({
    keys: [String(LINK_KINDS.indexOf(name))],
    label: `set the kind: ${name}`,
    run: () => editor.setKind(LINK_KINDS.indexOf(name)),
  }));
  return [
    tool(['o'], 'box', 'Box', 'select with a box; dragged to the left, all it touches'),
    { keys: ['y'], button: 'Add', label: 'taps add links', run: () => editor.toggleAdding() },
    { keys: ['q'], button: 'Clear', label: 'select nothing', run: () => editor.selection.set([]) },
    { keys: ['Delete'], button: 'Delete', label: 'delete links', run: () => editor.remove() },
    {
      ...{ keys: ['r'], button: 'Restore', run: () => editor.restore() },
      label: 'restore deleted links, make tentative ones firm',
    },
    { keys: ['u'], button: 'Merge', label: 'merge two links', run: () => editor.merge() },
    tool(['n'], 'join', 'Join', 'join two ends'),
    tool(['k'], 'split', 'Split', 'split a link'),
    tool(['l'], 'dimension', 'Length', 'write a length'),
    {
      ...{ keys: ['g'], button: 'Show deleted', run: () => editor.toggleGhosts() },
      label: 'deleted links, faintly',
    },
    { keys: ['Ctrl+z'], button: 'Undo', label: 'undo', run: () => editor.undo() },
    {
      ...{ keys: ['Ctrl+Shift+z', 'Ctrl+y'], button: 'Redo', label: 'redo' },
      run: () => editor.redo(),
    },
    {
      keys: ['w'],
      button: 'Download',
      label: 'download edits.json',
      run: () => editor.storage.save(),
    },
    { keys: [], button: 'Copy', label: 'copy the edits', run: () => editor.storage.copy() },
    { keys: [], button: 'Load', label: 'load edits.json', run: () => editor.panel.file.click() },
    ...kinds,
  ];
}
