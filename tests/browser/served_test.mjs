// SPDX-License-Identifier: BSD-3-Clause
// A page that is served says when drawing.json beside it is newer. From disk it asks for nothing
// (every test of other files).

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { createServer } from 'node:http';
import { resolve } from 'node:path';
import { after, before, test } from 'node:test';

import { launch, newContext, openAtFirst } from './browser.mjs';

const { LIMN_PAGES: PAGES } = process.env;
const read = (name) => readFileSync(resolve(PAGES, 'day', name));
let browser;

before(async () => (browser = await launch()));
after(() => browser?.close());

// Notices of the page that is served with these files beside it.
async function noticesOf(files) {
  const asked = [];
  const server = createServer((request, response) => {
    asked.push(request.url);
    const bytes = files[request.url];
    response.writeHead(bytes ? 200 : 404);
    response.end(bytes);
  });
  await new Promise((listening) => server.listen(0, '127.0.0.1', listening));
  const context = await newContext(browser);
  const url = `http://127.0.0.1:${server.address().port}/drawing.html`;
  const { page } = await openAtFirst(context, url);
  await page.evaluate(() => window.limnViewer.whenChecked);
  const notices = await page.locator('#notices .notice span').allTextContents();
  await context.close();
  assert.deepEqual(asked, ['/drawing.html', '/drawing.json']);
  await new Promise((closed) => server.close(closed));
  return notices;
}

test('the page of this drawing.json says nothing', async () => {
  const files = { '/drawing.html': read('drawing.html'), '/drawing.json': read('drawing.json') };
  assert.deepEqual(await noticesOf(files), []);
});

test('the page of another state of drawing.json says that it is older', async () => {
  const drawing = read('drawing.json');
  drawing[drawing.length - 2] += 1;
  const files = { '/drawing.html': read('drawing.html'), '/drawing.json': drawing };
  const text = 'This page is older than drawing.json: limn drawing_viewer makes it anew.';
  assert.deepEqual(await noticesOf(files), [text]);
});

test('a page that is served alone says nothing', async () => {
  assert.deepEqual(await noticesOf({ '/drawing.html': read('drawing.html') }), []);
});
