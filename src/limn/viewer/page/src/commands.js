// SPDX-License-Identifier: BSD-3-Clause
// What keys and the buttons of the toolbar do: {keys, label, tool: text of the button, run}.

export function commandsOf(app) {
  const layers = app.layers.list.map(({ id, label, key }) => ({
    keys: [key],
    label: `${label} on and off`,
    run: () => app.setLayer(id, !app.layers.isShown(id)),
  }));
  return [
    { keys: ['Home'], label: 'see everything', tool: 'Home', run: () => app.eye.home() },
    {
      keys: ['Backspace'],
      label: 'back to the place before',
      tool: 'Back',
      run: () => app.eye.back(),
    },
    { keys: ['i'], label: 'edit', tool: 'Edit', run: () => app.sidebar.show('edit') },
    { keys: ['m'], label: 'measure', tool: 'Measure', run: () => app.toggleMeasuring() },
    {
      keys: ['s'],
      label: 'save the picture (PNG)',
      tool: 'Picture',
      run: () => app.savePicture(),
    },
    { keys: ['t'], label: 'dark or light', tool: 'Theme', run: () => app.theme.toggle() },
    { keys: ['b'], label: 'panels on and off', tool: 'Panels', run: () => app.sidebar.toggle() },
    { keys: ['?'], label: 'this help', tool: 'Help', run: () => app.help.toggle() },
    { keys: ['/'], label: 'search a link', run: () => app.focusSearch() },
    { keys: ['f'], label: 'go to the picked link', run: () => app.focusLink(app.picked) },
    { keys: ['x'], label: 'next way to color', run: () => app.stepScheme() },
    { keys: ['['], label: 'previous photograph', run: () => app.stepPhoto(-1) },
    { keys: [']'], label: 'next photograph', run: () => app.stepPhoto(1) },
    {
      keys: ['Escape'],
      label: 'stop a tool, unpick, leave the photograph',
      run: () => app.escape(),
    },
    ...layers,
    ...app.editor.commands,
  ];
}
