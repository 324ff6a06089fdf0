// SPDX-License-Identifier: BSD-3-Clause
// What a reader sees first, on a desk and on a phone.

import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';

import { launch, newContext, openAtFirst, PHONE, rest } from './browser.mjs';

const PAGES = ['wires.html', 'day/drawing.html', 'edit.html'];
const TABS = ['drawing', 'links', 'edit', 'views', 'report'];
let browser;

before(async () => (browser = await launch()));
after(() => browser?.close());

async function withPage(name, options, run) {
  const context = await newContext(browser, options);
  const { page, troubles } = await openAtFirst(context, name);
  await run(page);
  assert.deepEqual(troubles, []);
  await context.close();
}

for (const [device, options] of [
  ['a desk', {}],
  ['a phone', PHONE],
]) {
  test(`on ${device} the first view is the photograph that sees most, over all of the canvas`, () =>
    withPage('day/drawing.html', options, async (page) => {
      const { photo, placement, rectangle, size, center, most } = await page.evaluate(() => {
        const { drawing, eye } = window.limnViewer;
        const { min, max } = drawing.views[eye.photo].thumbnail;
        const lengths = drawing.views.map(() => 0);
        drawing.linkLength.forEach((length, link) => {
          if (!drawing.isShown(link)) return;
          for (const view of drawing.supportingViews(link)) lengths[view] += length;
        });
        return {
          photo: eye.photo,
          placement: eye.placement,
          rectangle: [...min, ...max],
          size: eye.size,
          center: eye.screen(drawing.box.getCenter(eye.camera.position.clone())),
          most: lengths.indexOf(Math.max(...lengths)),
        };
      });
      assert.equal(photo, most);
      const [left, top, right, bottom] = rectangle.map(
        (pixel, i) => placement.scale * pixel + (i % 2 === 0 ? placement.x : placement.y),
      );
      assert.ok(left <= 0.01 && top <= 0.01, `${left}, ${top}`);
      assert.ok(right >= size.width - 0.01 && bottom >= size.height - 0.01, `${right}, ${bottom}`);
      // As large as it must be, and no larger.
      const slack = Math.min(right - left - size.width, bottom - top - size.height);
      assert.ok(Math.abs(slack) < 0.01, `${slack}`);
      assert.ok(center.x > 0 && center.x < size.width && center.y > 0 && center.y < size.height);
      assert.ok(await page.locator('#photo-bar').isVisible());
      await page.keyboard.press('Home');
      await rest(page);
      assert.equal(await page.evaluate(() => window.limnViewer.eye.photo), null);
      await page.keyboard.press('Backspace');
      await rest(page);
      const again = await page.evaluate(() => window.limnViewer.eye.placement);
      assert.deepEqual(again, placement);
    }));
}

test('without supporting views everything is seen first', () =>
  withPage('edit.html', {}, async (page) => {
    const places = await page.evaluate(() => {
      const { drawing, eye } = window.limnViewer;
      drawing.linkViewStart.fill(0);
      return [eye.firstState(), eye.homeState()].map(({ position, photo }) => [
        ...position.toArray(),
        photo,
      ]);
    });
    assert.deepEqual(places[0], places[1]);
  }));

// Words that go on in another line, of what can be seen.
function brokenWords(page) {
  return page.evaluate(() => {
    const broken = [];
    const range = document.createRange();
    const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
    while (walker.nextNode()) {
      const { currentNode: node } = walker;
      if (!node.parentElement.checkVisibility()) continue;
      for (const { 0: word, index } of node.data.matchAll(/\p{L}+/gu)) {
        range.setStart(node, index);
        range.setEnd(node, index + word.length);
        const lines = new Set([...range.getClientRects()].map(({ top }) => Math.round(top)));
        if (lines.size > 1) broken.push(word);
      }
    }
    return broken;
  });
}

for (const name of PAGES) {
  test(`on a phone ${name} breaks no words and goes over no border`, () =>
    withPage(name, PHONE, async (page) => {
      const toolbar = page.locator('#toolbar button');
      const rows = await toolbar.evaluateAll((all) => all.map((one) => one.offsetTop));
      assert.equal(new Set(rows).size, 1, 'one row of tools');
      await page.locator('#toolbar button', { hasText: 'Help' }).scrollIntoViewIfNeeded();
      for (const tab of TABS) {
        const button = page.locator(`#tab-${tab}`);
        if ((await button.count()) === 0) continue;
        await button.tap();
        if (tab === 'links') await page.evaluate(() => window.limnViewer.pick(0));
        await rest(page);
        assert.deepEqual(await brokenWords(page), [], tab);
        const over = await page.evaluate(() => {
          const all = [
            document.documentElement,
            ...document.querySelectorAll('.panel, .tabs, #photo-bar'),
          ];
          const isOver = (element) => element.scrollWidth > element.clientWidth + 1;
          return all.filter(isOver).map(({ tagName, id, className }) => [tagName, id, className]);
        });
        assert.deepEqual(over, [], tab);
      }
    }));
}
