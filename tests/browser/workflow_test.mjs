// SPDX-License-Identifier: BSD-3-Clause
// From photographs to a corrected plan: edits made in the page by pointer and keys, and the file that
// it downloads applied by the program, as in colmap_ext/docs/workflows.md.

import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';

import { canvasBox, launch, lookThrough, open, rest } from './browser.mjs';

const { LIMN_PROGRAM: PROGRAM, LIMN_SAMPLE_DIR: SAMPLE } = process.env;
const DXF_READER = fileURLToPath(new URL('../scripts/readers/read_dxf.py', import.meta.url));
const NUM_IMAGES = 6;
const SHADOW = 3;
let browser;
let folder;

const inFolder = (name) => join(folder, name);

before(async () => {
  browser = await launch();
  folder = mkdtempSync(join(tmpdir(), 'limn_workflow_'));
  const names = Array.from({ length: NUM_IMAGES }, (_, view) => `view_0${view}.jpg\n`);
  writeFileSync(inFolder('list.txt'), names.join(''));
});

after(async () => {
  await browser?.close();
  if (folder) rmSync(folder, { recursive: true });
});

// What a command says on some small images; it must succeed.
function limn(command, ...more) {
  const scene = ['--workspace_path', join(SAMPLE, 'day'), '--output_path', inFolder('out')];
  const images = ['--image_list_path', inFolder('list.txt')];
  return execFileSync(PROGRAM, [command, ...scene, ...images, ...more], { encoding: 'utf8' });
}

const SMALL = ['--quality', 'low', '--max_image_size', '320'];

const readDrawing = () => JSON.parse(readFileSync(inFolder('out/drawing.json'), 'utf8'));

// Open links that a pointer finds at their middle, longest first: {link, middle, ends}; `ends` are
// the free ones that it finds.
function targets(page) {
  return page.evaluate(() => {
    const { drawing, eye, picking } = window.limnViewer;
    const placeOf = (vertex) => {
      const { x, y } = eye.screen(drawing.point(vertex)) ?? { x: -1, y: -1 };
      const isInside = x > 5 && y > 5 && x < eye.size.width - 5 && y < eye.size.height - 5;
      return isInside ? { x: Math.round(x), y: Math.round(y) } : null;
    };
    const freeEnd = (link, end) => {
      const place = placeOf(drawing.endVertex(link, end));
      const found = place && picking.end(place.x, place.y, 12);
      const isFree = drawing.degree[drawing.linkNodes[2 * link + end]] === 1;
      const position = drawing.endPosition(link, end).toArray();
      return isFree && found?.link === link && found.end === end ? [{ ...place, position }] : [];
    };
    const links = Array.from({ length: drawing.numLinks }, (_, link) => link)
      .filter((link) => drawing.isShown(link) && !drawing.isClosed(link))
      .sort((a, b) => drawing.linkLength[b] - drawing.linkLength[a]);
    return links.flatMap((link) => {
      const [begin, end] = drawing.range(link);
      const middle = placeOf(Math.floor((begin + end) / 2));
      const found = middle && picking.link(middle.x, middle.y, 8);
      if (found?.link !== link) return [];
      return [{ link, middle, ends: [0, 1].flatMap((which) => freeEnd(link, which)) }];
    });
  });
}

const distance = (a, b) => Math.hypot(...a.map((value, axis) => value - b[axis]));

// The free ends of two of the links that are nearest to each other.
function nearestEnds(links) {
  const ends = links.flatMap(({ link, ends: own }) => own.map((end) => ({ link, ...end })));
  const pairs = ends.flatMap((a) => ends.filter((b) => b.link > a.link).map((b) => [a, b]));
  const gap = ([a, b]) => distance(a.position, b.position);
  return pairs.sort((a, b) => gap(a) - gap(b))[0];
}

async function press(page, key) {
  await page.keyboard.press(key);
  await rest(page);
}

async function click(page, { x, y }, modifiers = []) {
  const box = await canvasBox(page);
  for (const key of modifiers) await page.keyboard.down(key);
  await page.mouse.click(box.x + x, box.y + y);
  for (const key of modifiers) await page.keyboard.up(key);
  await rest(page);
}

const button = (page, name) =>
  page.locator('#panel-edit').getByRole('button', { name, exact: true });

const editsOf = (page) =>
  page.evaluate(() => window.limnViewer.editor.history.edits.map(({ edit }) => edit));

// Deletes two links, splits one, sets a kind, joins two ends and writes a length.
async function edit(page) {
  await page.locator('#toolbar button', { hasText: 'Edit' }).click();
  await rest(page);
  const links = await targets(page);
  const [split, kept, from, to, ...others] = links;
  const [a, b] = others.slice(-2);
  await click(page, a.middle);
  await click(page, b.middle, ['Shift']);
  await press(page, 'Delete');
  await press(page, 'k');
  await click(page, split.middle);
  await press(page, 'Escape');
  await click(page, kept.middle);
  await press(page, String(SHADOW));
  await press(page, 'n');
  for (const end of nearestEnds(others.slice(0, -2))) await click(page, end);
  for (let i = 0; i < 3; ++i) await press(page, 'Control+z');
  assert.deepEqual(await editsOf(page), ['delete']);
  for (let i = 0; i < 3; ++i) await press(page, 'Control+Shift+z');
  await press(page, 'l');
  await click(page, from.middle);
  await click(page, to.middle);
  await click(page, { x: from.middle.x + 60, y: from.middle.y + 60 });
  await press(page, 'Escape');
  assert.deepEqual(await editsOf(page), ['delete', 'split', 'set_kind', 'join', 'dimension']);
}

async function download(page) {
  const waiting = page.waitForEvent('download');
  await button(page, 'Download').click();
  await (await waiting).saveAs(inFolder('edits.json'));
}

// The page shows the edited drawing, and says that the report is of the drawing before.
async function assertFollows(edited) {
  const { page, troubles } = await open(browser, inFolder('out/drawing.html'));
  const numLinks = await page.evaluate(() => window.limnViewer.drawing.numLinks);
  assert.equal(numLinks, edited.links.length);
  assert.match(await page.locator('#panel-report').textContent(), /has changed since this run/);
  assert.match(await page.locator('#panel-report').textContent(), /swept sketch/);
  assert.deepEqual(troubles, []);
  await page.context().close();
}

test('the file that the page downloads is applied in full, and the plan is a sound DXF file', async () => {
  limn('automatic_drawer', ...SMALL);
  limn('drawing_aligner');
  const drawn = readDrawing();
  const { page, troubles } = await open(browser, inFolder('out/drawing.html'));
  await lookThrough(page, 0);
  // drawing_aligner has made it anew: it shows the world, and edits go back to the model.
  const { zIsUp, turn } = await page.evaluate(() => {
    const { drawing } = window.limnViewer;
    return { zIsUp: drawing.zIsUp, turn: drawing.shownFromModel.translation };
  });
  assert.equal(zIsUp, true);
  assert.ok(Math.hypot(...turn) > 0.01);
  await edit(page);
  await download(page);
  assert.deepEqual(troubles, []);
  await page.context().close();

  const edits = ['--edits', inFolder('edits.json'), '--overwrite', '1'];
  const told = limn('drawing_editor', ...SMALL, ...edits);
  const refused = 'in part 0, not found 0, ambiguous 0, without sense 0';
  assert.ok(told.includes(`edits: 5; applied 5, ${refused}`), told);
  const edited = readDrawing();
  const numJoined = / are one$/m.test(told) ? 1 : 0;
  assert.equal(edited.links.length, drawn.links.length - 2 + 1 - numJoined);
  assert.equal(edited.dimensions.length, 1);
  await assertFollows(edited);
  const byHand = ({ kind, kind_confidence: confidence }) => kind === 'shadow' && confidence === 1;
  assert.ok(edited.links.some(byHand));

  limn('drawing_surfacer', ...SMALL, '--overwrite', '1');
  assert.ok(readDrawing().faces.length > 0);
  const plan = inFolder('plan.dxf');
  const input = ['--input_path', inFolder('out/drawing.json'), '--output_path', plan];
  execFileSync(PROGRAM, ['drawing_exporter', ...input, '--section', '0.9']);
  const read = JSON.parse(
    execFileSync('/usr/bin/python3', [DXF_READER, plan], { encoding: 'utf8' }),
  );
  assert.deepEqual([read.errors, read.fixes], [[], []]);
  const lengths = read.entities.filter(({ type }) => type === 'DIMENSION');
  const [{ from, to }] = edited.dimensions;
  assert.equal(lengths.length, 1);
  const [{ text }] = lengths;
  const length = distance(from, to);
  assert.ok(Math.abs(Number(text) - length) < 0.0005 * length, `${text}, not ${length}`);
  assert.ok(read.entities.some(({ type }) => type === 'LINE'));
});
