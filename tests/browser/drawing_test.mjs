// SPDX-License-Identifier: BSD-3-Clause
// The picture: curves where the views see them, picking, measuring, layers, themes.

import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';

import {
  canvasBox,
  canvasPixels,
  launch,
  lookThrough,
  onCanvas,
  open,
  readJson,
  rest,
  setOpacity,
  showOnly,
} from './browser.mjs';

const expected = readJson('wires.json');
const EXACT_PX = 1.5;
const LINE_PX = 1.8;
let browser;

before(async () => (browser = await launch()));
after(() => browser?.close());

async function withPage(run, options) {
  const { page, troubles } = await open(browser, 'wires.html', options);
  await run(page);
  assert.deepEqual(troubles, []);
  await page.context().close();
}

// 1 where a pixel differs from the background, the color of the corner.
function drawnPixels({ width, height, data }) {
  const drawn = new Uint8Array(width * height);
  for (let i = 0; i < drawn.length; ++i) {
    const difference = [0, 1, 2].map((c) => Math.abs(data[4 * i + c] - data[c]));
    drawn[i] = Math.max(...difference) > 12 ? 1 : 0;
  }
  return drawn;
}

// Distance of every pixel's center to the nearest place, at most `reach`.
function distancesTo(places, width, height, reach) {
  const distances = new Float64Array(width * height).fill(Infinity);
  for (const [x, y] of places) {
    const [column, row] = [Math.floor(x), Math.floor(y)];
    for (let j = row - reach; j <= row + reach; ++j) {
      for (let i = column - reach; i <= column + reach; ++i) {
        if (i < 0 || j < 0 || i >= width || j >= height) continue;
        const distance = Math.hypot(i + 0.5 - x, j + 0.5 - y);
        distances[j * width + i] = Math.min(distances[j * width + i], distance);
      }
    }
  }
  return distances;
}

// Places of all links on the canvas when looking through a view.
async function linksOnCanvas(page, view) {
  const map = onCanvas(view, await canvasBox(page));
  return view.links.map((samples) => samples.map(map));
}

// The place on a link that is farthest from all other links.
function clearestPlace(links, link) {
  const others = links
    .filter((_, other) => other !== link)
    .flatMap((samples) => samples.filter((_, i) => i % 8 === 0));
  let best = null;
  for (const place of links[link].filter((_, i) => i % 20 === 0)) {
    const gap = Math.min(...others.map(([x, y]) => Math.hypot(x - place[0], y - place[1])));
    if (!best || gap > best.gap) best = { place, gap };
  }
  assert.ok(best.gap > 12, `link ${link} is alone somewhere`);
  return best.place;
}

async function clickAt(page, [x, y]) {
  const box = await canvasBox(page);
  await page.mouse.click(box.x + x, box.y + y);
  await rest(page);
}

async function factsOf(page, selector) {
  return page
    .locator(`${selector} tr`)
    .evaluateAll((rows) =>
      Object.fromEntries(
        rows.map((row) => [
          row.querySelector('th').textContent,
          row.querySelector('td').textContent,
        ]),
      ),
    );
}

for (const index of [0, 3, 5]) {
  test(`through view ${index} curves are where View::Project says, and nothing else is`, () =>
    withPage(async (page) => {
      await showOnly(page, 'drawing');
      await lookThrough(page, index);
      await setOpacity(page, 0);
      const places = (await linksOnCanvas(page, expected.views[index])).flat();
      const image = await canvasPixels(page);
      const drawn = drawnPixels(image);
      const distances = distancesTo(places, image.width, image.height, 8);
      const stray = drawn.filter((is, i) => is && distances[i] > 0.5 * LINE_PX + EXACT_PX).length;
      assert.equal(stray, 0, 'pixels away from all curves');
      const near = [];
      drawn.forEach(
        (is, i) => is && near.push([(i % image.width) + 0.5, Math.floor(i / image.width) + 0.5]),
      );
      const toDrawn = distancesTo(near, image.width, image.height, 3);
      const missed = places.filter(([x, y]) => {
        const i = Math.floor(y) * image.width + Math.floor(x);
        return !(toDrawn[i] <= EXACT_PX);
      });
      assert.equal(missed.length, 0, 'curves that are not drawn');
      assert.ok(near.length > 1000);
    }));

  test(`through view ${index} nodes are on the canvas within a hundredth of a pixel`, () =>
    withPage(async (page) => {
      await lookThrough(page, index);
      const map = onCanvas(expected.views[index], await canvasBox(page));
      const places = await page.evaluate(
        (nodes) => nodes.map((node) => window.limnViewer.screenOf(node)),
        expected.nodes,
      );
      places.forEach((place, node) => {
        const [x, y] = map(expected.views[index].nodes[node]);
        assert.ok(Math.hypot(place.x - x, place.y - y) < 0.01, `node ${node}`);
      });
    }));
}

test('wide and thin lines are at the same places', () =>
  withPage(async (page) => {
    await showOnly(page, 'drawing');
    const drawCoarse = () => window.limnViewer.stage.draw(false);
    const fine = drawnPixels(await canvasPixels(page));
    await page.evaluate(() => (window.limnViewer.stage.frame = () => {}));
    await page.evaluate(drawCoarse);
    const image = await canvasPixels(page);
    const coarse = drawnPixels(image);
    const centers = [];
    fine.forEach(
      (is, i) => is && centers.push([(i % image.width) + 0.5, Math.floor(i / image.width) + 0.5]),
    );
    const distances = distancesTo(centers, image.width, image.height, 3);
    const count = coarse.reduce((sum, is) => sum + is, 0);
    assert.ok(count > 500);
    assert.equal(coarse.filter((is, i) => is && distances[i] > 1.5).length, 0);
  }));

test('picking a link tells its figures, and its views lead there', () =>
  withPage(async (page) => {
    const links = async (view) => linksOnCanvas(page, expected.views[view]);
    for (const link of [0, 7, 12]) {
      await lookThrough(page, 3);
      await clickAt(page, clearestPlace(await links(3), link));
      assert.equal(await page.locator('#link-details h2').first().textContent(), `Link ${link}`);
      const facts = await factsOf(page, '#link-details');
      const { length, residual, sigma, views } = expected.links[link];
      const [value, of] = facts['Length, model units'].split(' ± ').map(Number);
      assert.ok(Math.abs(value - length) < 1e-3 * length);
      // The circle, 12, by its radius.
      if (link === 12) {
        const variance = (2 * Math.PI * sigma) ** 2 + (expected.scaleSigma * length) ** 2;
        assert.ok(Math.abs(of - Math.sqrt(variance)) < 0.02 * of);
      }
      assert.equal(facts.Residual, `${Number(residual.toPrecision(3))} px`);
      assert.ok(Math.abs(Number(facts['Sigma (median)']) - sigma) < 1e-3 * sigma);
      assert.equal(facts.Class, expected.links[link].class);
      assert.equal(facts.Primitive, link === 12 ? 'circle, radius 0.55' : 'line');
      const chips = page.locator('#link-details .chips button');
      assert.deepEqual(
        await chips.allTextContents(),
        views.map((view) => expected.views[view].name),
      );
      await chips.first().click();
      await rest(page);
      assert.equal(await page.locator('#photo-name').textContent(), expected.views[views[0]].name);
    }
  }));

test('the picked link is highlighted, and Escape clears it', () =>
  withPage(async (page) => {
    await showOnly(page, 'drawing');
    await lookThrough(page, 0);
    await setOpacity(page, 0);
    const links = await linksOnCanvas(page, expected.views[0]);
    const place = clearestPlace(links, 12);
    await clickAt(page, place);
    const colorAt = async () => {
      const { width, data } = await canvasPixels(page);
      const i = Math.floor(place[1]) * width + Math.floor(place[0]);
      return [...data.subarray(4 * i, 4 * i + 3)];
    };
    assert.deepEqual(await colorAt(), [0xd6, 0x00, 0x6c]);
    await page.keyboard.press('Escape');
    await rest(page);
    assert.notDeepEqual(await colorAt(), [0xd6, 0x00, 0x6c]);
    assert.equal(await page.locator('#link-details h2').count(), 0);
  }));

test('a tap of a finger picks, too', () =>
  withPage(
    async (page) => {
      await lookThrough(page, 3);
      const box = await canvasBox(page);
      const [x, y] = clearestPlace(await linksOnCanvas(page, expected.views[3]), 12);
      await page.touchscreen.tap(box.x + x + 10, box.y + y);
      await rest(page);
      assert.equal(await page.locator('#link-details h2').first().textContent(), 'Link 12');
    },
    { hasTouch: true, viewport: { width: 820, height: 1180 } },
  ));

test('measuring between two junctions snaps to them and tells the true distance', () =>
  withPage(async (page) => {
    await lookThrough(page, 3);
    const map = onCanvas(expected.views[3], await canvasBox(page));
    await page.keyboard.press('m');
    for (const [from, to] of [
      [0, 7],
      [1, 2],
    ]) {
      for (const node of [from, to]) {
        const [x, y] = map(expected.views[3].nodes[node]);
        await clickAt(page, [x + 4, y - 3]);
      }
      const facts = await factsOf(page, '#measured');
      const delta = expected.nodes[to].map((value, axis) => value - expected.nodes[from][axis]);
      const length = Math.hypot(...delta);
      const [distance, sigma] = facts.Distance.split(' ± ').map(Number);
      assert.ok(Math.abs(distance - length) < 1e-4);
      const variances = delta.map((d, axis) => 2 * ((d / length) * expected.nodeSigmas[axis]) ** 2);
      const ofNodes = variances.reduce((sum, variance) => sum + variance, 0);
      assert.ok(
        Math.abs(sigma - Math.hypot(Math.sqrt(ofNodes), expected.scaleSigma * length)) < 1e-4,
      );
      ['dx', 'dy', 'dz'].forEach((name, axis) =>
        assert.ok(Math.abs(Number(facts[name]) - delta[axis]) < 1e-5, name),
      );
      const told = facts.From.match(/-?\d+\.\d+/g).map(Number);
      told.forEach((value, axis) => assert.ok(Math.abs(value - expected.nodes[from][axis]) < 1e-4));
      assert.match(facts.From, new RegExp(`node ${from}\\)`));
    }
  }));

test('measuring snaps to points of curves', () =>
  withPage(async (page) => {
    await lookThrough(page, 3);
    const links = await linksOnCanvas(page, expected.views[3]);
    const place = clearestPlace(links, 12);
    await page.locator('#toolbar button', { hasText: 'Measure' }).click();
    await clickAt(page, [place[0] + 3, place[1] + 3]);
    await clickAt(
      page,
      onCanvas(expected.views[3], await canvasBox(page))(expected.views[3].nodes[4]),
    );
    const facts = await factsOf(page, '#measured');
    assert.match(facts.From, /link 12\)/);
    // The corner of the cube and the circle are in the same plane.
    assert.ok(Math.abs(Number(facts.dz)) < 1e-4);
    const [distance, sigma] = facts.Distance.split(' ± ').map(Number);
    assert.ok(sigma > 0.01); // of the circle
    assert.ok(distance > Math.SQRT2 - 0.56 && distance < Math.SQRT2 + 0.56);
  }));

test('every layer shows something and can be switched off', () =>
  withPage(async (page) => {
    const numDrawn = async () =>
      drawnPixels(await canvasPixels(page)).reduce((sum, is) => sum + is, 0);
    // From Home the cameras are behind the reader.
    await page.mouse.move(300, 300);
    await page.mouse.wheel(0, 1500);
    for (const layer of ['drawing', 'junctions', 'ends', 'cloud', 'cameras']) {
      await showOnly(page, layer);
      assert.ok((await numDrawn()) > 8, layer);
      await page.locator('#tab-drawing').click();
      await page.locator(`#layer-${layer}`).uncheck();
      await rest(page);
      assert.equal(await numDrawn(), 0, layer);
    }
    await page.locator('#canvas').focus();
    await page.keyboard.press('d');
    await rest(page);
    assert.ok((await numDrawn()) > 500);
    assert.ok(await page.locator('#layer-drawing').isChecked());
  }));

test('the theme follows the system and the switch', () =>
  withPage(async (page) => {
    const corner = async () => {
      const { data } = await canvasPixels(page);
      return [...data.subarray(0, 3)];
    };
    await showOnly(page);
    assert.deepEqual(await corner(), [255, 255, 255]);
    await page.emulateMedia({ colorScheme: 'dark' });
    await rest(page);
    assert.deepEqual(await corner(), [0x14, 0x17, 0x1b]);
    await page.locator('#toolbar button', { hasText: 'Theme' }).click();
    await rest(page);
    assert.deepEqual(await corner(), [255, 255, 255]);
  }));
