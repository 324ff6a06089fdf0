// SPDX-License-Identifier: BSD-3-Clause
// What stands beside the picture: search, colors, report, help, places, saving.

import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { after, before, test } from 'node:test';

import { canvasPixels, launch, open, readJson, rest, showOnly } from './browser.mjs';

const expected = readJson('wires.json');
let browser;

before(async () => (browser = await launch()));
after(() => browser?.close());

async function withPage(run, options) {
  const { page, troubles } = await open(browser, 'wires.html', options);
  await run(page);
  assert.deepEqual(troubles, []);
  await page.context().close();
}

const place = (page) =>
  page.evaluate(() => {
    const { eye } = window.limnViewer;
    return [...eye.camera.position.toArray(), eye.photo];
  });

test('search finds a link by its number', () =>
  withPage(async (page) => {
    await page.keyboard.press('/');
    await page.keyboard.type('1');
    const found = page.locator('#links button[data-link]');
    assert.deepEqual(await found.locator('span:first-child').allTextContents(), [
      '#1',
      '#10',
      '#11',
      '#12',
    ]);
    await page.keyboard.type('2');
    await page.keyboard.press('Enter');
    await rest(page);
    assert.equal(await page.locator('#link-details h2').first().textContent(), 'Link 12');
    const middle = await page.evaluate(() => {
      const { eye } = window.limnViewer;
      return [
        ...eye.controls.target
          .toArray()
          .map((value, axis) => value + window.limnViewer.drawing.center[axis]),
      ];
    });
    const top = expected.nodes[0][2] + 2;
    assert.ok(Math.abs(middle[2] - top) < 1e-3, 'the circle is looked at');
    await page.locator('#search').fill('77');
    assert.match(await page.locator('#links').textContent(), /No link/);
  }));

test('every way to color has a legend and other colors', () =>
  withPage(async (page) => {
    await showOnly(page, 'drawing');
    const pictures = new Set();
    const schemes = await page
      .locator('#scheme option')
      .evaluateAll((all) => all.map(({ value }) => value));
    assert.deepEqual(schemes, [
      'link',
      'support',
      'residual',
      'sigma',
      'primitive',
      'class',
      'kind',
      'component',
    ]);
    for (const scheme of schemes) {
      await page.locator('#scheme').selectOption(scheme);
      await rest(page);
      assert.notEqual((await page.locator('#legend').textContent()).trim(), '');
      pictures.add((await canvasPixels(page)).data.toString('base64'));
    }
    assert.equal(pictures.size, schemes.length);
  }));

test('an entry of the legend hides its links, also from picking', () =>
  withPage(async (page) => {
    await page.locator('#scheme').selectOption('primitive');
    const legend = page.locator('#legend label');
    assert.equal(await legend.count(), 2);
    await legend.filter({ hasText: 'line' }).locator('input').uncheck();
    await rest(page);
    const visible = await page.evaluate(() => [...window.limnViewer.drawing.visible]);
    assert.deepEqual(visible, [...Array(12).fill(0), 1]);
    const corner = await page.evaluate((node) => {
      const { x, y } = window.limnViewer.screenOf(node);
      return window.limnViewer.picking.link(x, y, 3);
    }, expected.nodes[0]);
    assert.equal(corner, null);
  }));

test('outlines of smooth bodies and tentative links are hidden until they are asked for', () =>
  withPage(async (page) => {
    const visible = () => page.evaluate(() => [...window.limnViewer.drawing.visible]);
    // As a drawing with such links would begin.
    await page.evaluate(() => {
      window.limnViewer.drawing.kindCategory[0] = 4;
      window.limnViewer.drawing.kindCategory[1] = 7;
      window.limnViewer.drawing.kindCategory[2] = 5;
    });
    await page.locator('#scheme').selectOption('kind');
    assert.deepEqual(await visible(), [0, 0, ...Array(11).fill(1)]);
    const legend = page.locator('#legend label');
    for (const [link, name] of ['contour', 'tentative'].entries()) {
      const box = legend.filter({ hasText: name }).locator('input');
      assert.equal(await box.isChecked(), false);
      await box.check();
      assert.equal((await visible())[link], 1);
    }
    assert.equal(await legend.filter({ hasText: 'rod' }).locator('input').isChecked(), true);
    await legend.filter({ hasText: 'shadow' }).locator('input').uncheck();
    assert.deepEqual(await visible(), [...Array(12).fill(1), 0]);
  }));

test('the slider of the detail brings texture, and leaves short curves out', () =>
  withPage(async (page) => {
    const visible = () => page.evaluate(() => [...window.limnViewer.drawing.visible]);
    await page.evaluate(() => {
      const { drawing } = window.limnViewer;
      drawing.linkKind[0] = 6;
      drawing.linkCurvePx.fill(79);
      drawing.linkCurvePx[1] = 80;
      drawing.linkCurvePx[2] = 0; // unknown
      drawing.sortKinds();
    });
    const slider = page.locator('#detail');
    assert.equal(await slider.inputValue(), '1');
    await slider.fill('2');
    assert.deepEqual(await visible(), Array(13).fill(1));
    await slider.fill('1');
    assert.deepEqual(await visible(), [0, ...Array(12).fill(1)]);
    assert.match(await page.locator('#detail-name').textContent(), /^normal/);
    await slider.fill('0');
    assert.deepEqual(await visible(), [0, 1, 1, ...Array(10).fill(0)]);
  }));

test('rods tell their radius', () =>
  withPage(async (page) => {
    const radiusOf = async (link) => {
      await page.evaluate((id) => window.limnViewer.pick(id), link);
      const row = page.locator('#link-details tr').filter({ hasText: 'Radius of the rod' });
      return (await row.count()) === 0 ? null : row.locator('td').textContent();
    };
    await page.evaluate(() => {
      window.limnViewer.drawing.linkKind[0] = 5;
      window.limnViewer.drawing.rodRadius[0] = 0.125;
    });
    assert.equal(await radiusOf(0), '0.125');
    assert.equal(await radiusOf(1), null);
  }));

test('contours tell the body whose outline they are', () =>
  withPage(async (page) => {
    const bodyOf = async (link) => {
      await page.evaluate((id) => window.limnViewer.pick(id), link);
      const row = page.locator('#link-details tr').filter({ hasText: 'Outline of a' });
      return (await row.count()) === 0 ? null : row.locator('td').textContent();
    };
    await page.evaluate(() => {
      const { drawing } = window.limnViewer;
      drawing.linkKind[0] = 4;
      drawing.bodyShape[0] = 1;
      drawing.bodyRadius[0] = 0.125;
      drawing.bodyRadiusSigma[0] = 0.01;
    });
    assert.equal(await bodyOf(0), 'cylinder, radius 0.125 ± 0.01 model units');
    assert.equal(await bodyOf(1), null);
    await page.evaluate(() => {
      window.limnViewer.drawing.linkKind[0] = 1;
    });
    assert.equal(await bodyOf(0), null);
  }));

test('the report is shown, texts as texts', () =>
  withPage(async (page) => {
    await page.locator('#tab-report').click();
    const panel = page.locator('#panel-report');
    assert.match(await panel.textContent(), /edgels 12,345/);
    assert.match(await panel.textContent(), /<img src=x onerror=alert\(1\)> is a text/);
    assert.equal(await panel.locator('img').count(), 0);
    assert.equal(await panel.locator('svg rect.bar').count(), 6);
    assert.equal(await panel.locator('svg polyline').count(), 1);
    assert.match(await panel.textContent(), /80 %/);
    assert.match(await panel.textContent(), /explains21 %.*1 of 6: <b>\.jpg \(1\.3 %\)/);
    assert.match(await panel.textContent(), /5 or more images75 %.*0\.123 px \(median\), 0\.5 px/);
    assert.match(await panel.textContent(), /tentative12\.5 %/);
    assert.equal(await panel.locator('.overlays button').count(), 6);
  }));

test('the views are a grid with the drawing over them; a click looks through one', () =>
  withPage(async (page) => {
    await page.locator('#tab-views').click();
    const buttons = page.locator('#panel-views .overlays button');
    assert.equal(await buttons.count(), 6);
    await page.waitForFunction(() => {
      const canvas = document.querySelector('#panel-views canvas');
      // Of a copy: Chromium warns of canvases that are read again and again.
      const copy = new OffscreenCanvas(canvas.width, canvas.height).getContext('2d');
      copy.drawImage(canvas, 0, 0);
      const { data } = copy.getImageData(0, 0, canvas.width, canvas.height);
      const colors = new Set();
      for (let i = 0; i < data.length; i += 4)
        colors.add(`${data[i]},${data[i + 1]},${data[i + 2]}`);
      return colors.size > 50;
    });
    await buttons.nth(4).click();
    await rest(page);
    assert.equal((await place(page))[3], 4);
    assert.equal(await page.locator('#photo-name').textContent(), expected.views[4].name);
  }));

test('Home and Backspace', () =>
  withPage(async (page) => {
    const home = await place(page);
    await page.keyboard.press(']');
    await rest(page);
    assert.equal((await place(page))[3], 0);
    await page.keyboard.press(']');
    await rest(page);
    await page.keyboard.press('Backspace');
    await rest(page);
    assert.equal((await place(page))[3], 0);
    await page.keyboard.press('Home');
    await rest(page);
    assert.deepEqual(await place(page), home);
  }));

test('dragging turns and leaves a photograph, the wheel enlarges it', () =>
  withPage(async (page) => {
    await page.keyboard.press(']');
    await rest(page);
    const box = await page.locator('#canvas').boundingBox();
    const [x, y] = [box.x + 0.5 * box.width, box.y + 0.5 * box.height];
    await page.mouse.move(x, y);
    const before = await place(page);
    const scale = () => page.evaluate(() => window.limnViewer.eye.placement.scale);
    const small = await scale();
    await page.mouse.wheel(0, -400);
    await rest(page);
    assert.ok((await scale()) > 1.3 * small);
    assert.deepEqual(await place(page), before);
    await page.mouse.down();
    await page.mouse.move(x + 60, y + 20, { steps: 5 });
    await page.mouse.up();
    await rest(page);
    const turned = await place(page);
    assert.equal(turned[3], null);
    assert.notDeepEqual(turned.slice(0, 3), before.slice(0, 3));
    assert.ok(await page.locator('#photo-bar').isHidden());
  }));

test('the picture is saved as PNG', () =>
  withPage(async (page) => {
    const waiting = page.waitForEvent('download');
    await page.locator('#toolbar button', { hasText: 'Picture' }).click();
    const file = await waiting;
    assert.equal(file.suggestedFilename(), 'wires.png');
    const bytes = await readFile(await file.path());
    assert.equal(bytes.subarray(1, 4).toString(), 'PNG');
    assert.ok(bytes.length > 5000);
  }));

test('the help opens by ? and closes by Escape', () =>
  withPage(async (page) => {
    await page.keyboard.press('?');
    assert.ok(await page.locator('#help').isVisible());
    assert.match(await page.locator('#help').textContent(), /measure/);
    await page.keyboard.press('Escape');
    assert.ok(await page.locator('#help').isHidden());
  }));

test('all controls have names', () =>
  withPage(async (page) => {
    const nameless = await page.evaluate(() => {
      const named = (control) =>
        control.textContent.trim() ||
        control.getAttribute('aria-label') ||
        control.labels?.length > 0;
      const controls = document.querySelectorAll('button, input, select, canvas#canvas');
      return [...controls].filter((control) => !named(control)).map(({ outerHTML }) => outerHTML);
    });
    assert.deepEqual(nameless, []);
  }));
