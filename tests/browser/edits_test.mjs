// SPDX-License-Identifier: BSD-3-Clause
// Editing by hand: every tool with pointer, fingers and keys, what is seen of it, and the file.

import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { after, before, test } from 'node:test';

import { canvasBox, canvasPixels, launch, lookThrough, open, readJson, rest } from './browser.mjs';

const expected = readJson('edit.json');
const NUM_LINKS = expected.links.length;
const CLEAR_PX = 3;
// Of the photograph, per unit of drawing.json.
const PX_PER_UNIT = 56;
let browser;

before(async () => (browser = await launch()));
after(() => browser?.close());

async function withPage(run, options) {
  const { page, troubles } = await open(browser, 'edit.html', options);
  await lookThrough(page, 0);
  await run(page);
  assert.deepEqual(troubles, []);
  await page.context().close();
}

// The place on the screen of a point of a link.
async function placeOn(page, link, vertex) {
  const box = await canvasBox(page);
  const place = await page.evaluate(
    (point) => window.limnViewer.screenOf(point),
    expected.links[link].shown[vertex],
  );
  return { x: box.x + place.x, y: box.y + place.y };
}

async function clickLink(page, link, vertex, { shift = false, dx = 0, dy = 0 } = {}) {
  const { x, y } = await placeOn(page, link, vertex);
  if (shift) await page.keyboard.down('Shift');
  await page.mouse.click(x + dx, y + dy);
  if (shift) await page.keyboard.up('Shift');
  await rest(page);
}

async function press(page, key) {
  await page.keyboard.press(key);
  await rest(page);
}

const button = (page, name) =>
  page.locator('#panel-edit').getByRole('button', { name, exact: true });

async function openPanel(page) {
  await page.locator('#toolbar button', { hasText: 'Edit' }).click();
}

const state = (page) =>
  page.evaluate(() => {
    const { drawing, selection } = window.limnViewer;
    return {
      live: [...drawing.gone].flatMap((gone, link) => (gone === 0 ? [link] : [])),
      selected: [...selection.links].sort((a, b) => a - b),
      kinds: [...drawing.linkKind],
      tentative: [...drawing.linkTentative],
    };
  });

const selected = async (page) => (await state(page)).selected;
const live = async (page) => (await state(page)).live;
const message = (page) => page.locator('#message').textContent();

async function isDrawnAt(page, link, vertex) {
  const box = await canvasBox(page);
  const { x, y } = await placeOn(page, link, vertex);
  const { width, data } = await canvasPixels(page);
  const colorAt = (column, row) => [
    ...data.subarray(4 * (row * width + column), 4 * (row * width + column) + 3),
  ];
  const [column, row] = [Math.floor(x - box.x), Math.floor(y - box.y)];
  for (let dy = -CLEAR_PX; dy <= CLEAR_PX; ++dy) {
    if (Math.min(...colorAt(column, row + dy)) < 240) return true;
  }
  return false;
}

async function downloaded(page) {
  const waiting = page.waitForEvent('download');
  await press(page, 'w');
  const file = await waiting;
  assert.equal(file.suggestedFilename(), 'edits.json');
  return JSON.parse(await readFile(await file.path(), 'utf8'));
}

const drop = (page, text, name = 'edits.json') =>
  page
    .locator('#edits-file')
    .setInputFiles({ name, mimeType: 'application/json', buffer: Buffer.from(text) });

async function load(page, text) {
  await openPanel(page);
  await drop(page, text);
  await page.waitForFunction(() => document.querySelector('#message').textContent !== '');
  await rest(page);
}

const distance = (a, b) => Math.hypot(...a.map((value, axis) => value - b[axis]));
const lengthOf = (points) =>
  points.slice(1).reduce((sum, point, i) => sum + distance(point, points[i]), 0);

function assertPlace(place, truth) {
  assert.equal(place.length, 3);
  assert.ok(distance(place, truth) < 1e-5, `${place} is ${truth}`);
}

// A reference tells the link's number and its course, in the coordinates of drawing.json.
function assertRef(ref, link, { closed = false } = {}) {
  assert.equal(ref.id, link);
  assert.equal(ref.closed, closed);
  assert.ok(ref.points.length >= 2 && ref.points.length <= 16);
  const { model } = expected.links[link];
  assertPlace(ref.points[0], model[0]);
  assertPlace(ref.points.at(-1), model.at(-1));
  assertPointsAlong(ref.points);
  assert.ok(Math.abs(lengthOf(ref.points) / lengthOf(model) - 1) < 0.01);
}

function assertPointsAlong(points) {
  const steps = points.slice(1).map((point, i) => distance(point, points[i]));
  assert.ok(Math.max(...steps) / Math.min(...steps) < 1.02, 'evenly spaced');
}

test('a click selects, Shift adds and takes away, Escape clears', () =>
  withPage(async (page) => {
    await openPanel(page);
    await clickLink(page, 0, 4);
    assert.deepEqual(await selected(page), [0]);
    await clickLink(page, 1, 4);
    assert.deepEqual(await selected(page), [1]);
    await clickLink(page, 0, 4, { shift: true });
    await clickLink(page, 4, 4, { shift: true });
    assert.deepEqual(await selected(page), [0, 1, 4]);
    assert.match(await page.locator('#edit-selection').textContent(), /^3 links, 26\.25 m$/);
    await clickLink(page, 1, 4, { shift: true });
    assert.deepEqual(await selected(page), [0, 4]);
    assert.ok(await page.locator('#panel-edit').isVisible(), 'the tab stays');
    await press(page, 'Escape');
    assert.deepEqual(await selected(page), []);
  }));

test('a box to the right selects what is inside, to the left what it touches', () =>
  withPage(async (page) => {
    const before = await page.evaluate(() => window.limnViewer.eye.photo);
    const drag = async (from, to) => {
      await page.mouse.move(from.x, from.y);
      await page.mouse.down();
      await page.mouse.move(to.x, to.y, { steps: 4 });
      await page.mouse.up();
      await rest(page);
    };
    // Around all of link 4 (and, of the links that it meets, their ends).
    const [end, corner] = [await placeOn(page, 4, 0), await placeOn(page, 4, 8)];
    const low = { x: end.x - 12, y: end.y + 12 };
    const high = { x: corner.x + 12, y: corner.y - 12 };
    await press(page, 'o');
    await drag(low, high);
    assert.deepEqual(await selected(page), [4]);
    await drag(high, low);
    assert.deepEqual(await selected(page), [4, 5, 6]);
    await press(page, 'o');
    // A drag without the tool, with Shift; it adds.
    const [a, b] = [await placeOn(page, 0, 0), await placeOn(page, 0, 8)];
    await page.keyboard.down('Shift');
    await drag({ x: a.x - 9, y: a.y - 9 }, { x: b.x + 9, y: b.y + 9 });
    await page.keyboard.up('Shift');
    assert.deepEqual(await selected(page), [0, 4, 5, 6]);
    assert.equal(await page.evaluate(() => window.limnViewer.eye.photo), before, 'nothing turns');
    assert.ok(await page.locator('.box').isHidden());
  }));

test('a box across a link without its vertices touches it', () =>
  withPage(async (page) => {
    const [from, to] = [await placeOn(page, 2, 3), await placeOn(page, 2, 4)];
    const x = 0.5 * (from.x + to.x);
    await press(page, 'o');
    await page.mouse.move(x + 6, from.y - 6);
    await page.mouse.down();
    await page.mouse.move(x - 6, from.y + 6, { steps: 4 });
    await page.mouse.up();
    await rest(page);
    assert.deepEqual(await selected(page), [2]);
  }));

test('links are selected by kind and by length', () =>
  withPage(async (page) => {
    await openPanel(page);
    await page.locator('#pick-kind').selectOption('tentative');
    await button(page, 'Select kind').click();
    assert.deepEqual(await selected(page), [7]);
    await button(page, 'Add').click();
    await page.locator('#pick-kind').selectOption('contour');
    await button(page, 'Select kind').click();
    assert.deepEqual(await selected(page), [7, 8]);
    await button(page, 'Add').click();
    // As displayed: 2.5 times the lengths of drawing.json.
    await page.locator('#pick-length').fill('0.74');
    await page.keyboard.press('Enter');
    assert.deepEqual(await selected(page), []);
    await page.locator('#pick-length').fill('0.76');
    await button(page, 'Select shorter').click();
    assert.deepEqual(await selected(page), [10]);
    await button(page, 'Clear').click();
    assert.deepEqual(await selected(page), []);
  }));

test('the message says how many links are selected, also after deletions', () =>
  withPage(async (page) => {
    await openPanel(page);
    await page.locator('#pick-kind').selectOption('tentative');
    await button(page, 'Select kind').click();
    assert.equal(await message(page), '1 link selected.');
    await clickLink(page, 0, 4, { shift: true });
    await clickLink(page, 4, 4, { shift: true });
    assert.equal(await message(page), '3 links selected.');
    await button(page, 'Show deleted').click();
    await press(page, 'Delete');
    assert.equal(await message(page), '0 links selected.');
    assert.deepEqual(await selected(page), []);
    assert.match(await page.locator('#edit-selection').textContent(), /^Nothing is selected/);
    await clickLink(page, 4, 4);
    assert.equal(await message(page), '1 link selected.');
    await clickLink(page, 9, 10, { shift: true });
    assert.equal(await message(page), '2 links selected.');
    await press(page, 'Escape');
    assert.equal(await message(page), '0 links selected.');
  }));

test('deleted links are gone, come back by undo, and are ghosts that can be restored', () =>
  withPage(async (page) => {
    await openPanel(page);
    await clickLink(page, 0, 4);
    await clickLink(page, 4, 4, { shift: true });
    await press(page, 'Delete');
    assert.deepEqual(
      await live(page),
      Array.from({ length: NUM_LINKS }, (_, link) => link).filter(
        (link) => link !== 0 && link !== 4,
      ),
    );
    assert.deepEqual(await selected(page), []);
    assert.equal(await isDrawnAt(page, 4, 4), false);
    await clickLink(page, 4, 4);
    assert.deepEqual(await selected(page), [], 'what is gone cannot be picked');
    await press(page, 'Control+z');
    assert.equal((await live(page)).length, NUM_LINKS);
    assert.equal(await isDrawnAt(page, 4, 4), true);
    await press(page, 'Control+Shift+z');
    assert.equal((await live(page)).length, NUM_LINKS - 2);
    await button(page, 'Show deleted').click();
    await rest(page);
    assert.equal(await isDrawnAt(page, 4, 4), true);
    await clickLink(page, 4, 4);
    assert.deepEqual(await selected(page), [4]);
    assert.ok(await button(page, 'Delete').isDisabled());
    await press(page, 'r');
    assert.ok((await live(page)).includes(4));
    assert.ok(!(await live(page)).includes(0));
    const file = await downloaded(page);
    assert.equal(file.edits.length, 1);
    assert.deepEqual(
      file.edits[0].links.map(({ id }) => id),
      [0],
    );
  }));

test('the file says what drawing_editor reads, in the coordinates of drawing.json', () =>
  withPage(async (page) => {
    await clickLink(page, 4, 4);
    await clickLink(page, 9, 10, { shift: true });
    await press(page, 'Delete');
    const file = await downloaded(page);
    assert.equal(file.format, 'limn_edits');
    assert.equal(file.format_version, 1);
    assert.deepEqual(Object.keys(file.edits[0]), ['edit', 'links']);
    assert.equal(file.edits[0].edit, 'delete');
    assertRef(file.edits[0].links[0], 4);
    assertRef(file.edits[0].links[1], 9, { closed: true });
  }));

test('tentative links are made firm, and kinds are set', () =>
  withPage(async (page) => {
    await openPanel(page);
    await page.locator('#pick-kind').selectOption('tentative');
    await button(page, 'Select kind').click();
    assert.equal(await isDrawnAt(page, 7, 2), true, 'what is selected is shown');
    await button(page, 'Restore').click();
    await press(page, 'q');
    assert.equal((await state(page)).tentative[7], 0);
    assert.equal(await isDrawnAt(page, 7, 2), true);
    await clickLink(page, 7, 4);
    await page.locator('#set-kind').selectOption('paint');
    await button(page, 'Set kind').click();
    await clickLink(page, 0, 4);
    await press(page, '3');
    const { kinds } = await state(page);
    assert.deepEqual([kinds[7], kinds[0], kinds[1]], [2, 3, 1]);
    const { edits } = await downloaded(page);
    assert.deepEqual(
      edits.map(({ edit, kind }) => [edit, kind]),
      [
        ['restore', undefined],
        ['set_kind', 'paint'],
        ['set_kind', 'shadow'],
      ],
    );
    assertRef(edits[0].links[0], 7);
    assertRef(edits[2].links[0], 0);
    for (let i = 0; i < 3; ++i) await press(page, 'Control+z');
    const undone = await state(page);
    assert.deepEqual([undone.kinds[7], undone.kinds[0], undone.tentative[7]], [1, 1, 1]);
  }));

test('the legend of kinds follows', () =>
  withPage(async (page) => {
    await page.locator('#scheme').selectOption('kind');
    const legend = () => page.locator('#legend').textContent();
    assert.doesNotMatch(await legend(), /shadow/);
    await clickLink(page, 2, 4);
    await press(page, '3');
    assert.match(await legend(), /shadow/);
    await press(page, 'Control+z');
    assert.doesNotMatch(await legend(), /shadow/);
  }));

test('two free ends on one line become one link', () =>
  withPage(async (page) => {
    await press(page, 'n');
    assert.match(await message(page), /pick an end/);
    await clickLink(page, 0, 8);
    assert.match(await message(page), /link 0/);
    await clickLink(page, 1, 0);
    const links = await live(page);
    assert.ok(!links.includes(0) && !links.includes(1) && links.includes(NUM_LINKS));
    const length = await page.evaluate(
      (link) => window.limnViewer.drawing.linkLength[link],
      NUM_LINKS,
    );
    assert.ok(Math.abs(length - 8 * expected.scale) < 1e-3);
    await press(page, 'Escape');
    // The joined link is a link like others: deleting it names it by its course.
    await clickLink(page, 1, 4);
    assert.deepEqual(await selected(page), [NUM_LINKS]);
    await press(page, 'Delete');
    const { edits } = await downloaded(page);
    assert.deepEqual(
      edits[0].ends.map(({ end }) => end),
      [1, 0],
    );
    edits[0].ends.forEach(({ link }, i) => assertRef(link, i));
    const [joined] = edits[1].links;
    assert.equal(joined.id, -1);
    assertPlace(joined.points[0], expected.links[0].model[0]);
    assertPlace(joined.points.at(-1), expected.links[1].model.at(-1));
    await press(page, 'Control+z');
    await press(page, 'Control+z');
    assert.equal((await live(page)).length, NUM_LINKS);
    assert.ok(!(await live(page)).includes(NUM_LINKS));
  }));

test('other ends are connected by a dashed line, and both links stay', () =>
  withPage(async (page) => {
    await press(page, 'n');
    await clickLink(page, 10, 0);
    await clickLink(page, 5, 0);
    assert.equal((await live(page)).length, NUM_LINKS);
    assert.ok(await page.evaluate(() => window.limnViewer.editor.preview.lines.visible));
    // An end of a link that is next to nothing, and the same end twice.
    await clickLink(page, 2, 4);
    assert.match(await message(page), /no end/);
    await clickLink(page, 5, 0);
    await clickLink(page, 5, 0);
    assert.match(await message(page), /meet already/);
    const { edits } = await downloaded(page);
    assert.equal(edits.length, 1);
    assertRef(edits[0].ends[0].link, 10);
    assertRef(edits[0].ends[1].link, 5);
    assert.deepEqual(
      edits[0].ends.map(({ end }) => end),
      [0, 0],
    );
    await press(page, 'Control+z');
    assert.ok(!(await page.evaluate(() => window.limnViewer.editor.preview.lines.visible)));
  }));

test('at a junction the nearest curve tells which end is meant', () =>
  withPage(async (page) => {
    await press(page, 'n');
    await clickLink(page, 5, 8, { dy: -10 });
    assert.match(await message(page), /link 5/);
  }));

test('a link is split where it is picked, and a part of it deleted', () =>
  withPage(async (page) => {
    await press(page, 'k');
    await clickLink(page, 2, 2);
    const links = await live(page);
    assert.ok(!links.includes(2));
    assert.deepEqual(links.slice(-2), [NUM_LINKS, NUM_LINKS + 1]);
    await press(page, 'Escape');
    await clickLink(page, 2, 1);
    assert.deepEqual(await selected(page), [NUM_LINKS]);
    await press(page, 'Delete');
    assert.equal(await isDrawnAt(page, 2, 1), false);
    assert.equal(await isDrawnAt(page, 2, 6), true);
    const { edits } = await downloaded(page);
    assert.equal(edits[0].edit, 'split');
    assertRef(edits[0].link, 2);
    assert.ok(distance(edits[0].at, expected.links[2].model[2]) < 0.02);
    const [part] = edits[1].links;
    assert.equal(part.id, -1);
    assertPlace(part.points[0], expected.links[2].model[0]);
    assertPlace(part.points.at(-1), edits[0].at);
    await press(page, 'Control+z');
    await press(page, 'Control+z');
    assert.equal((await live(page)).length, NUM_LINKS);
    assert.equal(await isDrawnAt(page, 2, 1), true);
  }));

test('a circle is opened, an end is not split', () =>
  withPage(async (page) => {
    await press(page, 'k');
    await clickLink(page, 9, 12);
    const ends = await page.evaluate(
      (link) => [0, 1].map((end) => window.limnViewer.drawing.endPosition(link, end).toArray()),
      NUM_LINKS,
    );
    assert.ok(distance(...ends) < 1e-6);
    const closed = await page.evaluate(
      (link) => window.limnViewer.drawing.isClosed(link),
      NUM_LINKS,
    );
    assert.equal(closed, false);
    assert.ok(!(await live(page)).includes(9));
    await clickLink(page, 0, 0, { dx: -5 });
    assert.match(await message(page), /an end of the curve/);
    assert.equal((await downloaded(page)).edits.length, 1);
  }));

test('a link is split no nearer to its ends than drawing_editor does it', () =>
  withPage(async (page) => {
    // Of the photograph, 2 px; a pointer stands on whole pixels of the screen.
    const ends = [placeOn(page, 2, 0), placeOn(page, 2, 8)];
    const [from, to] = await Promise.all(ends);
    const pxOfScreen = (to.x - from.x) / (8 * PX_PER_UNIT);
    const numLeast = Math.round(2 * pxOfScreen);
    await press(page, 'k');
    for (const [vertex, sign] of [
      [0, 1],
      [8, -1],
    ]) {
      // prettier-ignore
      await clickLink(page, 2, vertex, { dx: sign * (numLeast - 1) });
      assert.match(await message(page), /an end of the curve/);
    }
    assert.equal((await live(page)).length, NUM_LINKS);
    await clickLink(page, 2, 0, { dx: numLeast + 1 });
    assert.equal((await live(page)).length, NUM_LINKS + 1);
    const [{ at }] = (await downloaded(page)).edits;
    const px = PX_PER_UNIT * distance(at, expected.links[2].model[0]);
    assert.ok(px > 2 && px < 4, `${px} px`);
  }));

test('of two merged links the longer one is left', () =>
  withPage(async (page) => {
    await clickLink(page, 2, 4);
    await press(page, 'u');
    assert.match(await message(page), /two links/);
    await clickLink(page, 3, 4, { shift: true });
    await press(page, 'u');
    assert.ok(!(await live(page)).includes(3));
    assert.ok((await live(page)).includes(2));
    const { edits } = await downloaded(page);
    assert.equal(edits[0].edit, 'merge');
    edits[0].links.forEach((ref, i) => assertRef(ref, 2 + i));
    await press(page, 'Control+z');
    assert.ok((await live(page)).includes(3));
  }));

test('links that do not run along each other are not merged', () =>
  withPage(async (page) => {
    // Far apart, at a corner, on one line with a gap, at a corner on one line.
    for (const [a, b] of [
      [0, 2],
      [4, 5],
      [0, 1],
      [4, 6],
    ]) {
      // prettier-ignore
      await clickLink(page, a, 4);
      await clickLink(page, b, 4, { shift: true });
      await press(page, 'u');
      assert.match(await message(page), /do not run along each other/);
      assert.equal((await live(page)).length, NUM_LINKS);
    }
    assert.equal((await downloaded(page)).edits.length, 0);
    // In a file such an edit stays, without a preview.
    const links = [2, 0].map((id) => ({ id, closed: false, points: expected.links[id].model }));
    const file = {
      format: 'limn_edits',
      format_version: 1,
      edits: [{ edit: 'merge', links }],
    };
    await load(page, JSON.stringify(file));
    assert.equal((await live(page)).length, NUM_LINKS);
    assert.deepEqual(await downloaded(page), file);
  }));

test('undo and redo have no end, and a new edit ends redoing', () =>
  withPage(async (page) => {
    await clickLink(page, 0, 4);
    for (let i = 0; i < 40; ++i) await page.keyboard.press(String(i % 4));
    for (let i = 0; i < 40; ++i) await page.keyboard.press('Control+z');
    assert.equal((await state(page)).kinds[0], 1);
    await openPanel(page);
    assert.ok(await button(page, 'Undo').isDisabled());
    for (let i = 0; i < 39; ++i) await page.keyboard.press('Control+y');
    assert.equal((await state(page)).kinds[0], 2);
    assert.equal((await downloaded(page)).edits.length, 39);
    await button(page, 'Undo').click();
    await press(page, 'Delete');
    assert.ok(await button(page, 'Redo').isDisabled());
    assert.equal((await downloaded(page)).edits.length, 39);
  }));

test('lengths are placed, told in the unit of the page, removed and undone', () =>
  withPage(async (page) => {
    await openPanel(page);
    const rows = page.locator('#edit-lengths .pair');
    assert.deepEqual(await rows.locator('span').allTextContents(), ['10 m']);
    await press(page, 'l');
    await clickLink(page, 2, 0);
    await clickLink(page, 4, 0, { dx: -4 });
    const { x, y } = await placeOn(page, 4, 0);
    const low = await placeOn(page, 2, 0);
    await page.mouse.click(x - 60, 0.5 * (y + low.y));
    await rest(page);
    assert.deepEqual(await rows.locator('span').allTextContents(), ['10 m', '5 m']);
    assert.deepEqual(await page.locator('.dimension').allTextContents(), ['10', '5']);
    const { edits } = await downloaded(page);
    const [{ edit, from, to, shift }] = edits;
    assert.equal(edit, 'dimension');
    assertRef(from.link, 2);
    assertRef(to.link, 4);
    assertPlace(from.at, expected.links[2].model[0]);
    assertPlace(to.at, expected.links[4].model[0]);
    // Across the line, to the left.
    assert.ok(shift[0] < -0.5 && Math.abs(shift[1]) < 1e-3 && Math.abs(shift[2]) < 1e-3, shift);
    await rows.nth(1).getByRole('button').click();
    assert.equal(await rows.count(), 1);
    await press(page, 'Control+z');
    assert.equal(await rows.count(), 2);
    await rows.nth(0).getByRole('button').click();
    assert.deepEqual(await rows.locator('span').allTextContents(), ['5 m']);
    const removal = (await downloaded(page)).edits[1];
    assert.equal(removal.edit, 'remove_dimension');
    assertPlace(removal.from, [0, 0, 0]);
    assertPlace(removal.to, [4, 0, 0]);
    await press(page, 'Control+z');
    assert.equal(await rows.count(), 2);
  }));

test('a length on its own places has no shift; both places may be on one link', () =>
  withPage(async (page) => {
    await press(page, 'l');
    await clickLink(page, 2, 2);
    await clickLink(page, 2, 6);
    await clickLink(page, 2, 4, { dy: 4 });
    const [{ from, to, shift }] = (await downloaded(page)).edits;
    assert.deepEqual(shift, [0, 0, 0]);
    assert.ok(Math.abs(distance(from.at, to.at) - 4) < 0.05);
    assert.deepEqual([from.link.id, to.link.id], [2, 2]);
  }));

test('a downloaded file is loaded again to go on, also what comes after splits and joins', () =>
  withPage(async (page) => {
    await clickLink(page, 4, 4);
    await press(page, 'Delete');
    await press(page, 'k');
    await clickLink(page, 2, 2);
    await press(page, 'n');
    await clickLink(page, 0, 8);
    await clickLink(page, 1, 0);
    await press(page, 'Escape');
    await clickLink(page, 2, 1);
    await press(page, '2');
    await clickLink(page, 1, 4);
    await press(page, 'Delete');
    await press(page, 'l');
    await clickLink(page, 3, 0);
    await clickLink(page, 3, 8);
    await clickLink(page, 3, 4);
    const file = await downloaded(page);
    assert.equal(file.edits.length, 6);
    const before = await state(page);
    const { page: other, troubles } = await open(browser, 'edit.html');
    await load(other, JSON.stringify(file));
    assert.match(await message(other), /^6 edits loaded\.$/);
    const now = await state(other);
    assert.deepEqual(now.live, before.live);
    assert.deepEqual(now.kinds, before.kinds);
    assert.deepEqual(await downloaded(other), file);
    await press(other, 'Control+z');
    assert.equal((await live(other)).length, NUM_LINKS);
    assert.deepEqual(troubles, []);
    await other.context().close();
  }));

test('what refers to other drawings is told and kept in the file', () =>
  withPage(async (page) => {
    const far = [
      [90, 90, 90],
      [95, 90, 90],
    ];
    const ref = { id: 3, closed: false, points: far };
    const { model } = expected.links[4];
    // Given from its other end, and with another link's number: geometry decides.
    const turned = { id: 1, closed: false, points: [model[8], model[4], model[0]] };
    const free = { id: 10, closed: false, points: expected.links[10].model };
    const file = {
      format: 'limn_edits',
      format_version: 1,
      edits: [
        { edit: 'delete', links: [ref, turned] },
        { edit: 'split', link: ref, at: far[0] },
        {
          edit: 'join',
          ends: [
            { link: free, end: 1 },
            { link: ref, end: 0 },
          ],
        },
        { edit: 'remove_dimension', from: far[0], to: far[1] },
      ],
    };
    await load(page, JSON.stringify(file));
    assert.match(await message(page), /4 edits loaded; 4 refer to what is not in this drawing/);
    assert.match(await page.locator('#edit-list').textContent(), /1 not in this drawing/);
    assert.deepEqual(
      await live(page),
      Array.from({ length: NUM_LINKS }, (_, link) => link).filter((link) => link !== 4),
    );
    assert.deepEqual(await downloaded(page), file);
  }));

test('bad files change nothing and are told with the place and the reason', () =>
  withPage(async (page) => {
    await clickLink(page, 0, 4);
    await press(page, 'Delete');
    const before = await downloaded(page);
    const ref = { id: 0, closed: false, points: [[0, 0, 0], [1, 0, 0]] }; // prettier-ignore
    const edits = (list) =>
      JSON.stringify({ format: 'limn_edits', format_version: 1, edits: list });
    const points = (list) => edits([{ edit: 'delete', links: [ref, { ...ref, points: list }] }]);
    const cases = [
      ['', /is not JSON/],
      ['{', /is not JSON/],
      ['[]', /no "format": "limn_edits"/],
      ['{"format": "limn"}', /no "format": "limn_edits"/],
      ['{"format": "limn_edits", "format_version": 2, "edits": []}', /format_version: must be 1/],
      ['{"format": "limn_edits", "format_version": 1, "edits": {}}', /edits: must be a list/],
      [edits([null]), /edits\[0\]: must be an object/],
      [edits([{ edit: 'move' }]), /edits\[0\]\.edit: must be one of delete, /],
      [edits([{ edit: 'delete', links: [] }]), /edits\[0\]\.links: must be a list/],
      [points([[0, 0, 0]]), /edits\[0\]\.links\[1\]\.points: must be a list of 2 to 16/],
      [points(Array(17).fill([0, 0, 0])), /points: must be a list of 2 to 16/],
      [points([[0, 0, 0], [0, null, 0]]), /points\[1\]: must be three numbers/], // prettier-ignore
      [edits([{ edit: 'set_kind', links: [ref], kind: 'red' }]), /kind: must be one of unknown/],
      [edits([{ edit: 'merge', links: [ref] }]), /links: must be 2 links/],
      [edits([{ edit: 'join', ends: [{ link: ref, end: 2 }] }]), /ends: must be two ends/],
      [
        edits([{ edit: 'join', ends: [{ link: ref, end: 0 }, { link: ref, end: 2 }] }]), // prettier-ignore
        /ends\[1\]\.end: must be 0 or 1/,
      ],
      [edits([{ edit: 'split', link: ref }]), /edits\[0\]\.at: must be three numbers/],
      [
        edits([{ edit: 'dimension', from: { link: ref, at: [0, 0, 0] } }]),
        /edits\[0\]\.to: must be an object/,
      ],
    ];
    for (const [text, reason] of cases) {
      await page.evaluate(() => window.limnViewer.say(''));
      await load(page, text);
      assert.match(await message(page), reason);
      assert.match(await message(page), /^edits\.json: .*Nothing was loaded/);
      assert.ok(await page.locator('#message.error').isVisible());
    }
    assert.deepEqual(await downloaded(page), before);
  }));

test('edits are copied to the clipboard', () =>
  withPage(
    async (page) => {
      await clickLink(page, 0, 4);
      await press(page, 'Delete');
      await openPanel(page);
      await button(page, 'Copy').click();
      await page.waitForFunction(() => document.querySelector('#message').textContent !== '');
      assert.match(await message(page), /in the clipboard/);
      const text = await page.evaluate(() => navigator.clipboard.readText());
      assert.deepEqual(JSON.parse(text), await downloaded(page));
    },
    { permissions: ['clipboard-read', 'clipboard-write'] },
  ));

test('leaving with edits that were not downloaded is warned of', () =>
  withPage(async (page) => {
    const asksToLeave = async () => {
      let asked = false;
      const answer = (dialog) => {
        asked = dialog.type() === 'beforeunload';
        dialog.dismiss();
      };
      page.once('dialog', answer);
      await page.evaluate(() => {
        window.wasAsked = null;
        window.location.href = 'about:blank#';
      });
      await page.waitForTimeout(300);
      page.off('dialog', answer);
      return asked;
    };
    await clickLink(page, 0, 4);
    await press(page, 'Delete');
    assert.equal(await asksToLeave(), true);
    await downloaded(page);
    const isClean = await page.evaluate(() => window.limnViewer.editor.history.isSaved);
    assert.equal(isClean, true);
    await press(page, 'Control+z');
    assert.equal(await asksToLeave(), true);
    await press(page, 'Control+y');
    assert.equal(await asksToLeave(), false);
  }));

test('fingers select, add, draw boxes, split and join by buttons', () =>
  withPage(
    async (page) => {
      const tap = async (link, vertex, dx = 0) => {
        const { x, y } = await placeOn(page, link, vertex);
        await page.touchscreen.tap(x + dx, y);
        await rest(page);
      };
      await page.locator('#toolbar button', { hasText: 'Edit' }).tap();
      await tap(4, 2);
      assert.deepEqual(await selected(page), [4]);
      await button(page, 'Add').tap();
      await tap(9, 10);
      assert.deepEqual(await selected(page), [4, 9]);
      await button(page, 'Add').tap();
      await button(page, 'Delete').tap();
      assert.ok(!(await live(page)).includes(9));
      await button(page, 'Undo').tap();
      assert.ok((await live(page)).includes(9));
      await button(page, 'Join').tap();
      await tap(0, 8, -8);
      await tap(1, 0, 8);
      assert.ok((await live(page)).includes(NUM_LINKS));
      await button(page, 'Split').tap();
      await tap(6, 3);
      assert.ok(!(await live(page)).includes(6));
      await button(page, 'Box').tap();
      const client = await page.context().newCDPSession(page);
      const touch = (type, points) =>
        client.send('Input.dispatchTouchEvent', { type, touchPoints: points });
      const [a, b] = [await placeOn(page, 0, 0), await placeOn(page, 1, 8)];
      await touch('touchStart', [{ x: a.x - 12, y: a.y - 9 }]);
      await touch('touchMove', [{ x: 0.5 * (a.x + b.x), y: a.y }]);
      await touch('touchMove', [{ x: b.x + 12, y: b.y + 9 }]);
      await touch('touchEnd', []);
      await rest(page);
      assert.deepEqual(await selected(page), [NUM_LINKS]);
      const small = await page
        .locator('#panel-edit button, #toolbar button')
        .evaluateAll((all) => all.filter((one) => one.getBoundingClientRect().height < 40).length);
      assert.equal(small, 0, 'buttons can be tapped');
    },
    { hasTouch: true, viewport: { width: 820, height: 1180 } },
  ));

test('tools exclude each other, also measuring', () =>
  withPage(async (page) => {
    const pressed = () =>
      page
        .locator('#panel-edit button[aria-pressed=true], #toolbar button[aria-pressed=true]')
        .allTextContents();
    for (const [key, name] of [
      ['n', 'Join'],
      ['m', 'Measure'],
      ['k', 'Split'],
      ['l', 'Length'],
      ['o', 'Box'],
    ]) {
      await press(page, key);
      assert.deepEqual(await pressed(), [name]);
    }
    await press(page, 'Escape');
    assert.deepEqual(await pressed(), []);
    assert.equal(await message(page), '');
  }));

test('the help tells the keys of all tools', () =>
  withPage(async (page) => {
    await press(page, '?');
    const text = await page.locator('#help').textContent();
    for (const key of ['Delete', 'Ctrl+z', 'Ctrl+Shift+z', 'join two ends', 'split a link']) {
      assert.ok(text.includes(key), key);
    }
    const twice = await page.evaluate(() => {
      const keys = window.limnViewer.commands.flatMap((command) => command.keys);
      return keys.filter((key, i) => keys.indexOf(key) !== i);
    });
    assert.deepEqual(twice, [], 'a key does one thing');
  }));
