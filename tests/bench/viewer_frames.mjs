// SPDX-License-Identifier: BSD-3-Clause
// How fluid the page of drawing_viewer is: the median time of a frame while a drawing of 100,000
// segments and 200,000 points turns, at 800x600, in headless Chromium's software renderer.
//
//   cmake --build --preset release --target viewer_pages browser_packages
//   build/release/tests/browser/viewer_pages /tmp/pages
//   LIMN_PAGES=/tmp/pages LIMN_BROWSER_PACKAGES=$PWD/build/release/tests/browser/packages
//       node tests/bench/viewer_frames.mjs [large.html]

import { launch, open } from '../browser/browser.mjs';

const SECONDS = 8;

const browser = await launch();
const { page, troubles } = await open(browser, process.argv[2] ?? 'large.html', {
  viewport: { width: 800, height: 600 },
});
await page.evaluate(() => window.limnViewer.sidebar.toggle());
const result = await page.evaluate(async (seconds) => {
  const { eye, stage, drawing, layers } = window.limnViewer;
  await stage.atRest();
  // The pointer turns the drawing a little before every frame; what GL has not finished counts.
  const canvas = stage.canvas;
  const point = (type, x) =>
    canvas.dispatchEvent(
      new PointerEvent(type, {
        ...{ pointerId: 1, clientX: x, clientY: 300, bubbles: true, isPrimary: true },
        ...{ button: 0, buttons: 1, pointerType: 'mouse' },
      }),
    );
  canvas.setPointerCapture = canvas.releasePointerCapture = () => {};
  const gl = stage.renderer.getContext();
  const pixel = new Uint8Array(4);
  const times = [];
  let x = 300;
  point('pointerdown', x);
  const end = performance.now() + 1000 * seconds;
  let previous = null;
  while (performance.now() < end) {
    x += 3;
    point('pointermove', x);
    await new Promise((resolve) => requestAnimationFrame(resolve));
    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
    const now = performance.now();
    if (previous !== null) times.push(now - previous);
    previous = now;
  }
  point('pointerup', x);
  const settled = times.slice(Math.floor(times.length / 4)).sort((a, b) => a - b);
  const start = performance.now();
  stage.draw(true);
  gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
  const fine = performance.now() - start;
  const picks = Array.from({ length: 200 }, (_, i) => {
    const from = performance.now();
    window.limnViewer.picking.link(4 * i, 3 * i, 8);
    return performance.now() - from;
  }).sort((a, b) => a - b);
  return {
    size: `${canvas.clientWidth}x${canvas.clientHeight}`,
    segments: drawing.numSegments,
    linesWhileMoving: layers.curves.thin.geometry.index.count / 2,
    points: layers.cloud.size,
    pointsWhileMoving: layers.cloud.whileMoving,
    frames: times.length,
    medianMs: settled[Math.floor(settled.length / 2)],
    slowestTenthMs: settled[Math.floor(0.9 * settled.length)],
    fineFrameMs: fine,
    pickMs: picks[100],
    turnedFrom: eye.photo,
  };
}, SECONDS);
console.log(result, `${(1000 / result.medianMs).toFixed(1)} frames a second`);
if (troubles.length > 0) console.log(troubles);
await browser.close();
