// SPDX-License-Identifier: BSD-3-Clause
// A headless Chromium for tests, and what they share. Without one a test ends here with exit code
// 77, which ctest shows as skipped.

import { existsSync, readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';

// The folder that viewer_pages has written, and the one with node_modules.
const { LIMN_PAGES: PAGES, LIMN_BROWSER_PACKAGES: PACKAGES } = process.env;
if (!PAGES || !PACKAGES) throw new Error('LIMN_PAGES and LIMN_BROWSER_PACKAGES must be set');
const PROGRAM = process.env.CHROMIUM ?? '/usr/bin/chromium';
// No connections of the browser's own; WebGL in software.
const ARGUMENTS = [
  '--no-sandbox',
  '--disable-quic',
  '--no-first-run',
  '--disable-background-networking',
  '--disable-component-update',
  '--disable-sync',
  '--use-gl=angle',
  '--use-angle=swiftshader',
  '--enable-unsafe-swiftshader',
];

const HIDE_BARS = '#toolbar, #photo-bar, #message { visibility: hidden; }';

export async function launch() {
  if (!existsSync(PROGRAM)) {
    console.log(`SKIPPED: no Chromium at ${PROGRAM} (scripts/setup.sh chromium installs it)`);
    process.exit(77);
  }
  const require = createRequire(join(PACKAGES, 'package.json'));
  const { chromium } = require('playwright-core');
  return chromium.launch({ executablePath: PROGRAM, args: ARGUMENTS });
}

export function readJson(name) {
  return JSON.parse(readFileSync(join(PAGES, name), 'utf8'));
}

export const PHONE = {
  viewport: { width: 390, height: 844 },
  deviceScaleFactor: 2,
  hasTouch: true,
  isMobile: true,
};

export function newContext(browser, options = {}) {
  return browser.newContext({
    viewport: { width: 1100, height: 700 },
    reducedMotion: 'reduce',
    colorScheme: 'light',
    ...options,
  });
}

// Opens a page, by its name there or its path, and waits until it has been drawn, as Home shows it. `troubles` collects errors, warnings and requests.
export async function open(browser, name, options = {}) {
  const opened = await openAtFirst(await newContext(browser, options), name);
  await opened.page.evaluate(() => {
    const { eye, stage } = window.limnViewer;
    eye.arrive(eye.homeState());
    stage.move();
  });
  await rest(opened.page);
  return opened;
}

// The same, as a reader sees it first. `name` may be a URL.
export async function openAtFirst(context, name) {
  const page = await context.newPage();
  const isUrl = name.startsWith('http:');
  const url = isUrl ? name : pathToFileURL(resolve(PAGES, name)).href;
  const troubles = [];
  page.on('console', (message) => {
    if (['error', 'warning'].includes(message.type())) troubles.push(message.text());
  });
  page.on('pageerror', (error) => troubles.push(error.message));
  page.on('request', (request) => {
    const ofPage = /^(data|blob):/.test(request.url());
    if (request.url() !== url && !ofPage) troubles.push(`request of ${request.url()}`);
  });
  await page.goto(url);
  await page.waitForFunction(
    () => window.limnViewer !== undefined || document.querySelector('#message.error') !== null,
  );
  await rest(page);
  return { page, troubles };
}

// Until a fine frame of the present state is on the screen. Photographs come after the first one.
export async function rest(page) {
  await page.evaluate(async () => {
    await window.limnViewer.stage.atRest();
    await Promise.all(window.limnViewer.photos.bitmaps.values());
    await window.limnViewer.stage.atRest();
    await new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve)));
    await window.limnViewer.stage.atRest();
  });
}

export async function canvasBox(page) {
  return page.locator('#canvas').boundingBox();
}

// What is on the screen where the canvas is: {width, height, data: RGBA}. Nothing of the page's own
// code takes part.
export async function canvasPixels(page) {
  const clip = await canvasBox(page);
  const png = (await page.screenshot({ clip, style: HIDE_BARS })).toString('base64');
  const { width, height, data } = await page.evaluate(async (base64) => {
    const bytes = Uint8Array.from(atob(base64), (character) => character.charCodeAt(0));
    const bitmap = await createImageBitmap(new Blob([bytes], { type: 'image/png' }));
    const canvas = new OffscreenCanvas(bitmap.width, bitmap.height);
    const context = canvas.getContext('2d');
    context.drawImage(bitmap, 0, 0);
    const image = context.getImageData(0, 0, bitmap.width, bitmap.height);
    let text = '';
    for (let at = 0; at < image.data.length; at += 30000) {
      text += String.fromCharCode(...image.data.subarray(at, at + 30000));
    }
    return { width: image.width, height: image.height, data: btoa(text) };
  }, png);
  return { width, height, data: Buffer.from(data, 'base64') };
}

// Where a pixel of a photograph is on a canvas that shows the whole of it, as large as possible.
export function onCanvas({ width, height }, box) {
  const scale = Math.min(box.width / width, box.height / height);
  return ([x, y]) => [
    0.5 * box.width + scale * (x + 0.5 - 0.5 * width),
    0.5 * box.height + scale * (y + 0.5 - 0.5 * height),
  ];
}

// All layers off but these.
export async function showOnly(page, ...layers) {
  await page.evaluate((shown) => {
    for (const { id } of window.limnViewer.layers.list) {
      window.limnViewer.setLayer(id, shown.includes(id));
    }
  }, layers);
  await rest(page);
}

export async function lookThrough(page, view) {
  await page.evaluate((index) => window.limnViewer.lookThrough(index), view);
  await rest(page);
}

export async function setOpacity(page, value) {
  await page.locator('#opacity').fill(String(value));
  await rest(page);
}
