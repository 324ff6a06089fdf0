// SPDX-License-Identifier: BSD-3-Clause
// Faces: a translucent layer, and hidden lines.

import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';

import { canvasPixels, launch, lookThrough, open, readJson, rest, showOnly } from './browser.mjs';

const expected = readJson('edit.json');
const [BEHIND, BORDER] = [11, 12];
let browser;

before(async () => (browser = await launch()));
after(() => browser?.close());

async function withPage(run) {
  const { page, troubles } = await open(browser, 'edit.html');
  await lookThrough(page, 0);
  await run(page);
  assert.deepEqual(troubles, []);
  await page.context().close();
}

const placeOf = (page, point) => page.evaluate((p) => window.limnViewer.screenOf(p), point);

// The darkest of the colors within 3 px.
async function darkestAt(page, point) {
  const place = await placeOf(page, point);
  const { width, data } = await canvasPixels(page);
  let darkest = [255, 255, 255];
  for (let y = Math.floor(place.y) - 3; y <= Math.floor(place.y) + 3; ++y) {
    const i = 4 * (y * width + Math.floor(place.x));
    const color = [...data.subarray(i, i + 3)];
    if (Math.min(...color) < Math.min(...darkest)) darkest = color;
  }
  return darkest;
}

const isLine = (color) => Math.min(...color) < 190;

test('faces are a layer, and their number and area are told', () =>
  withPage(async (page) => {
    const facts = await page.locator('#panel-drawing .facts').first().textContent();
    assert.match(facts, /Faces1/);
    assert.match(facts, /Area of the faces, m²25/);
    const [a, , c] = expected.faces;
    const middle = a.map((value, axis) => value + 0.3 * (c[axis] - value));
    await showOnly(page, 'faces');
    const [red, green, blue] = await darkestAt(page, middle);
    assert.ok(blue > red && blue > green && red < 250, 'blue where it is seen from');
    await page.locator('#tab-drawing').click();
    await page.locator('#layer-faces').uncheck();
    await rest(page);
    assert.deepEqual(await darkestAt(page, middle), [255, 255, 255]);
  }));

test('hidden lines: what is behind a face is not drawn, its border is', () =>
  withPage(async (page) => {
    await showOnly(page, 'drawing');
    const [behind, border] = [BEHIND, BORDER].map((link) => expected.links[link].shown[3]);
    assert.ok(isLine(await darkestAt(page, behind)));
    assert.ok(isLine(await darkestAt(page, border)));
    await page.locator('#canvas').focus();
    await page.keyboard.press('h');
    await rest(page);
    assert.deepEqual(await darkestAt(page, behind), [255, 255, 255], 'no trace of the face itself');
    assert.ok(isLine(await darkestAt(page, border)));
    assert.ok(isLine(await darkestAt(page, expected.links[2].shown[3])));
    // Thin lines, while the picture moves, too.
    await page.evaluate(() => (window.limnViewer.stage.frame = () => {}));
    await page.evaluate(() => window.limnViewer.stage.draw(false));
    assert.deepEqual(await darkestAt(page, behind), [255, 255, 255]);
    assert.ok(isLine(await darkestAt(page, border)));
  }));

test('what is hidden cannot be picked', () =>
  withPage(async (page) => {
    const pick = async (link) => {
      const { x, y } = await placeOf(page, expected.links[link].shown[3]);
      await page.mouse.click(x, y);
      await rest(page);
      return page.evaluate(() => window.limnViewer.picked);
    };
    await page.keyboard.press('h');
    await rest(page);
    assert.equal(await pick(BEHIND), null);
    assert.equal(await pick(BORDER), BORDER);
    await page.keyboard.press('h');
    await rest(page);
    assert.equal(await pick(BEHIND), BEHIND);
  }));
