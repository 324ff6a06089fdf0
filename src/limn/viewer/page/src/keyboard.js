// SPDX-License-Identifier: BSD-3-Clause
// Keys to commands, unless a field is being filled in or the help is open (which closes by Escape).

// Keys with Ctrl (on a Mac, Command) are named so: "Ctrl+z", "Ctrl+Shift+z".
function nameOf({ key, ctrlKey, metaKey, shiftKey }) {
  if (!ctrlKey && !metaKey) return key;
  return `Ctrl+${shiftKey ? 'Shift+' : ''}${key.toLowerCase()}`;
}

// `commands`: [{keys, run}].
export function watchKeys(commands, isModal) {
  const byKey = new Map(commands.flatMap(({ keys, run }) => keys.map((key) => [key, run])));
  window.addEventListener('keydown', (event) => {
    if (event.altKey) return;
    const isField = event.target.matches('select, input:not([type=checkbox]):not([type=range])');
    if (isModal() && event.key !== '?') return;
    if (isField && event.key !== 'Escape') return;
    const run = byKey.get(nameOf(event));
    if (!run) return;
    event.preventDefault();
    run();
  });
}
