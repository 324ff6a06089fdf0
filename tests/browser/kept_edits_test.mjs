// SPDX-License-Identifier: BSD-3-Clause
// Edits that were never downloaded outlive the page.

import assert from 'node:assert/strict';
import { copyFileSync, mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { after, before, test } from 'node:test';

import { launch, newContext, openAtFirst, rest } from './browser.mjs';

const { LIMN_PAGES: PAGES } = process.env;
let browser;
let folder;

before(async () => {
  browser = await launch();
  folder = mkdtempSync(join(tmpdir(), 'limn_kept_'));
});
after(async () => {
  await browser?.close();
  if (folder) rmSync(folder, { recursive: true });
});

// The page of the folder is that of a drawing (kept) or of what became of it (renewed).
function place(name, of = folder) {
  copyFileSync(resolve(PAGES, name, 'drawing.html'), join(of, 'drawing.html'));
  return join(of, 'drawing.html');
}

async function withContext(run, script) {
  const context = await newContext(browser);
  if (script) await context.addInitScript(script);
  await run(context);
  await context.close();
}

const notice = (page) => page.locator('#notices .notice');
const answer = (page, name) => notice(page).getByRole('button', { name, exact: true });
const gone = (page) =>
  page.evaluate(() =>
    [...window.limnViewer.drawing.gone].flatMap((is, link) => (is ? [link] : [])),
  );
const editsOf = (page) =>
  page.evaluate(() => window.limnViewer.editor.history.edits.map(({ edit }) => edit));
const numKept = (page) => page.evaluate(() => window.localStorage.length);

async function deleteLinks(page, ...links) {
  await page.evaluate((numbers) => {
    window.limnViewer.selection.set(numbers);
    window.limnViewer.editor.remove();
  }, links);
}

async function openPage(context, name = 'kept') {
  const { page, troubles } = await openAtFirst(context, place(name));
  assert.deepEqual(troubles, []);
  return page;
}

test('edits are offered again when the page is opened again, and taken up', () =>
  withContext(async (context) => {
    const page = await openPage(context);
    assert.equal(await notice(page).count(), 0);
    await deleteLinks(page, 4);
    await deleteLinks(page, 9, 0);
    await page.waitForFunction(() => window.localStorage.length === 1);
    await page.close({ runBeforeUnload: false });

    const next = await openPage(context);
    assert.match(await notice(next).textContent(), /^Never downloaded: 2 edits of .*\.Take up/);
    assert.deepEqual(await editsOf(next), []);
    await answer(next, 'Take up').click();
    await rest(next);
    assert.deepEqual(await editsOf(next), ['delete', 'delete']);
    assert.deepEqual(await gone(next), [0, 4, 9]);
    assert.equal(await notice(next).count(), 0);
    assert.equal(await next.locator('#message').textContent(), '2 edits loaded.');
    assert.equal(await numKept(next), 1, 'they are kept on');
    await next.close({ runBeforeUnload: false });

    const last = await openPage(context);
    await answer(last, 'Discard').click();
    assert.equal(await notice(last).count(), 0);
    assert.equal(await numKept(last), 0);
  }));

test('what is downloaded or undone is not kept', () =>
  withContext(async (context) => {
    const page = await openPage(context);
    await deleteLinks(page, 4);
    await page.waitForFunction(() => window.localStorage.length === 1);
    await page.keyboard.press('Control+z');
    assert.equal(await numKept(page), 0);
    await page.keyboard.press('Control+Shift+z');
    await page.waitForFunction(() => window.localStorage.length === 1);
    const waiting = page.waitForEvent('download');
    await page.keyboard.press('w');
    await waiting;
    assert.equal(await numKept(page), 0);
  }));

test('edits that are left at once are kept, and another page does not write over them', () =>
  withContext(async (context) => {
    const page = await openPage(context);
    await deleteLinks(page, 4);
    await page.evaluate(() => window.dispatchEvent(new Event('pagehide')));
    assert.equal(await numKept(page), 1);
    await page.close({ runBeforeUnload: false });
    const next = await openPage(context);
    await deleteLinks(next, 9);
    await next.waitForFunction(() => window.localStorage.length === 2);
    await answer(next, 'Take up').click();
    assert.deepEqual(await gone(next), [4]);
    assert.equal(await numKept(next), 1);
    await next.keyboard.press('Control+z');
    assert.deepEqual(await gone(next), [9], 'undone in one step');
  }));

test('a page of the changed drawing offers them and says so; one of another folder does not', () =>
  withContext(async (context) => {
    const page = await openPage(context);
    await deleteLinks(page, 4);
    await page.waitForFunction(() => window.localStorage.length === 1);
    await page.close({ runBeforeUnload: false });
    const renewed = await openPage(context, 'renewed');
    assert.match(await notice(renewed).textContent(), /The drawing has changed since\./);
    await answer(renewed, 'Take up').click();
    assert.match(
      await renewed.locator('#message').textContent(),
      /^1 edits loaded, made of another state of the drawing\.$/,
    );
    await renewed.close({ runBeforeUnload: false });
    const elsewhere = mkdtempSync(join(folder, 'other_'));
    const { page: other } = await openAtFirst(context, place('kept', elsewhere));
    assert.equal(await notice(other).count(), 0);
  }));

test('damaged entries of the storage are left alone', () =>
  withContext(
    async (context) => {
      const page = await openPage(context);
      assert.equal(await notice(page).count(), 1);
      await answer(page, 'Take up').click();
      assert.match(await page.locator('#message').textContent(), /^The kept edits: .*Nothing was/);
      assert.equal(await numKept(page), 4);
    },
    () => {
      const key = `limn-edits ${JSON.stringify(['to edit', 'kept', 1, 1])}`;
      const entry = { path: '/', time: 1, count: 1, text: '{"format": "limn_edits"}' };
      window.localStorage.setItem(key, JSON.stringify(entry));
      window.localStorage.setItem('limn-edits [', JSON.stringify(entry));
      window.localStorage.setItem('limn-edits ["edit", "kept"]', 'null');
      window.localStorage.setItem('others', '1');
    },
  ));

for (const [what, script] of [
  [
    'denied',
    () =>
      Object.defineProperty(window, 'localStorage', {
        get() {
          throw new DOMException('denied', 'SecurityError');
        },
      }),
  ],
  [
    'full',
    () => {
      Storage.prototype.setItem = () => {
        throw new DOMException('full', 'QuotaExceededError');
      };
    },
  ],
]) {
  test(`where the storage is ${what} the page says so once, and works`, () =>
    withContext(async (context) => {
      const page = await openPage(context);
      await deleteLinks(page, 4);
      await page.waitForFunction(() => document.querySelector('#message.error') !== null);
      const message = await page.locator('#message').textContent();
      assert.match(message, /^The browser does not keep the edits \(.*\): download them\.$/);
      await page.evaluate(() => window.limnViewer.say(''));
      await deleteLinks(page, 9);
      await page.waitForTimeout(700);
      assert.equal(await page.locator('#message').textContent(), '');
      assert.deepEqual(await editsOf(page), ['delete', 'delete']);
    }, script));
}

test('the downloaded file names the drawing of the page', () =>
  withContext(async (context) => {
    const page = await openPage(context);
    const text = await page.evaluate(() => window.limnViewer.editor.storage.text());
    assert.deepEqual(JSON.parse(text).drawing, { name: 'drawing.json', fingerprint: 'kept' });
    await page.evaluate(() => {
      const { editor } = window.limnViewer;
      editor.storage.replaceBy(editor.storage.text().replace('"kept"', '"old"'));
    });
    assert.match(await page.locator('#message').textContent(), /made of another state/);
    const bad = await page.evaluate(() => {
      try {
        const { storage } = window.limnViewer.editor;
        storage.replaceBy(storage.text().replace('"kept"', '7'));
        return '';
      } catch (error) {
        return error.message;
      }
    });
    assert.equal(bad, 'drawing.fingerprint: must be a text');
  }));
