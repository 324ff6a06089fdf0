// Keys to commands, unless a field is being filled in or the help is open (which closes by Escape).

// `commands`: [{keys, run}].
export function watchKeys(commands, isModal) {
  const byKey = new Map(commands.flatMap(({ keys, run }) => keys.map((key) => [key, run])));
  window.addEventListener('keydown', (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const isField = event.target.matches('select, input:not([type=checkbox]):not([type=range])');
    if (isModal() && event.key !== '?') return;
    if (isField && event.key !== 'Escape') return;
    const run = byKey.get(event.key);
    if (!run) return;
    event.preventDefault();
    run();
  });
}
