// SPDX-License-Identifier: BSD-3-Clause
// Real photographs behind the drawing: the truth of the sample scene lies on the edges that they
// show, also where a lens had to be undone.

import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';

import { canvasPixels, launch, lookThrough, open, setOpacity, showOnly } from './browser.mjs';

const SHIFT_PX = 3;
let browser;

before(async () => (browser = await launch()));
after(() => browser?.close());

// Steepest change of brightness within a pixel.
function steepness({ width, height, data }, x, y) {
  const gray = (i, j) => {
    const at = 4 * (j * width + i);
    return 0.3 * data[at] + 0.6 * data[at + 1] + 0.1 * data[at + 2];
  };
  const [column, row] = [Math.floor(x), Math.floor(y)];
  if (column < 3 || row < 3 || column >= width - 3 || row >= height - 3) return null;
  let steepest = 0;
  for (let j = row - 1; j <= row + 1; ++j) {
    for (let i = column - 1; i <= column + 1; ++i) {
      const slope = Math.hypot(gray(i + 1, j) - gray(i - 1, j), gray(i, j + 1) - gray(i, j - 1));
      steepest = Math.max(steepest, slope);
    }
  }
  return steepest;
}

function mean(values) {
  return values.reduce((sum, value) => sum + value, 0) / values.length;
}

for (const name of ['day', 'distorted']) {
  test(`${name}: the drawing lies on the edges of the photograph`, async () => {
    const { page, troubles } = await open(browser, `${name}/drawing.html`);
    await showOnly(page);
    await lookThrough(page, 7);
    await setOpacity(page, 1);
    const image = await canvasPixels(page);
    const vertices = await page.evaluate(() => {
      const { drawing, eye } = window.limnViewer;
      return Array.from({ length: drawing.numVertices }, (_, v) => eye.screen(drawing.point(v)));
    });
    const slopeAt = (dx, dy) => {
      const places = vertices.filter((vertex) => vertex !== null);
      const slopes = places.map(({ x, y }) => steepness(image, x + dx, y + dy));
      return mean(slopes.filter((slope) => slope !== null));
    };
    const here = slopeAt(0, 0);
    const shifted = Array.from({ length: 8 }, (_, k) => {
      const angle = (k * Math.PI) / 4;
      return slopeAt(SHIFT_PX * Math.cos(angle), SHIFT_PX * Math.sin(angle));
    });
    console.log(
      `${name}: slope ${here.toFixed(1)}, shifted by ${SHIFT_PX} px ${shifted.map((s) => s.toFixed(1))}`,
    );
    assert.ok(here > 20);
    assert.ok(shifted.every((slope) => slope < 0.9 * here));
    assert.deepEqual(troubles, []);
  });
}
