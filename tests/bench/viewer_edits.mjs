// SPDX-License-Identifier: BSD-3-Clause
// How long edits of 4,000 links of 100 segments take in the page of drawing_viewer, until a fine frame
// shows them, in headless Chromium's software renderer: medians. Started as viewer_frames.mjs is.

import { launch, open } from '../browser/browser.mjs';

const REPEATS = 7;

const browser = await launch();
const { page, troubles } = await open(browser, 'many.html', {
  viewport: { width: 800, height: 600 },
});
const result = await page.evaluate(async (repeats) => {
  const { editor, eye, selection, stage, drawing, picking } = window.limnViewer;
  const all = Array.from({ length: drawing.numLinks }, (_, link) => link);
  const gl = stage.renderer.getContext();
  const pixel = new Uint8Array(4);
  const drawn = () => gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
  const whole = { left: 0, top: 0, right: eye.size.width, bottom: eye.size.height };
  const median = (times) => times.sort((a, b) => a - b)[times.length >> 1];
  const times = {};
  const measure = async (name, act, before = () => {}) => {
    const [acts, frames] = [[], []];
    for (let i = 0; i < repeats; ++i) {
      before(i);
      await stage.atRest();
      drawn();
      const start = performance.now();
      act(i);
      acts.push(performance.now() - start);
      stage.draw(true);
      drawn();
      frames.push(performance.now() - start);
    }
    times[name] = `${median(acts).toFixed(1)} ms, with its frame ${median(frames).toFixed(1)} ms`;
  };
  await measure('a frame alone', () => {});
  await measure('select one', (i) => selection.set([100 * i]));
  await measure('box around all', () => editor.selectBox(whole, true, false));
  await measure(
    'delete one',
    () => editor.remove(),
    (i) => selection.set([100 * i]),
  );
  await measure('undo', () => editor.undo());
  await measure('redo', () => editor.redo());
  await measure(
    'delete 2,000',
    () => editor.remove(),
    (i) => {
      if (i > 0) editor.undo();
      selection.set(all.slice(2000));
    },
  );
  await measure(
    'split one',
    (i) => {
      const edit = window.limnViewer.editor;
      edit.pointing.start('split');
      const link = 1000 + i;
      const { x, y } = eye.screen(drawing.point(drawing.linkStart[link] + 50));
      edit.pointing.tap(x, y, 12);
    },
    () => editor.pointing.start(null),
  );
  await measure('point at the drawing', (i) => picking.place(100 * i, 80 * i, 12));
  return {
    links: drawing.numStored,
    segments: drawing.numSegments,
    edits: editor.history.edits.length,
    ...times,
  };
}, REPEATS);
console.log(result);
if (troubles.length > 0) console.log(troubles);
await browser.close();
