// SPDX-License-Identifier: BSD-3-Clause
// page_pictures.mjs OUT: screenshots of drawing.html in the folder LIMN_PAGES.

import { join } from 'node:path';

import { launch, newContext, open, openAtFirst, rest } from '../../tests/browser/browser.mjs';

const [out] = process.argv.slice(2);
const browser = await launch();

async function take(name, prepare, opens = open) {
  const opened =
    opens === open
      ? await open(browser, 'drawing.html')
      : await openAtFirst(await newContext(browser), 'drawing.html');
  const { page } = opened;
  await prepare(page);
  await rest(page);
  await page.screenshot({ path: join(out, `${name}.png`) });
  await page.context().close();
}

const layer = (page, id, shown) =>
  page.evaluate(([which, on]) => window.limnViewer.setLayer(which, on), [id, shown]);
const tab = (page, name) => page.getByRole('tab', { name }).click();

await take('02-model', async (page) => {
  await layer(page, 'drawing', false);
  await layer(page, 'cloud', true);
  await layer(page, 'cameras', true);
});
await take('04-page', async () => {}, openAtFirst);
await take('05-report', async (page) => {
  await layer(page, 'cameras', false);
  await tab(page, 'Report');
});
await take('06-edit', async (page) => {
  await layer(page, 'cameras', false);
  await page.locator('#toolbar button', { hasText: 'Edit' }).click();
  await page.locator('#pick-kind').selectOption('paint');
  await page.getByRole('button', { name: 'Select kind', exact: true }).click();
});
await take('07-measure', async (page) => {
  await page.evaluate(() => window.limnViewer.lookThrough(0));
  await rest(page);
  await page.locator('#toolbar button', { hasText: 'Measure' }).click();
  // Both ends of the longest straight link that is seen.
  const ends = await page.evaluate(() => {
    const { drawing, eye } = window.limnViewer;
    const { width, height } = eye.size;
    const seen = (link) => {
      const places = [0, 1].map((end) => eye.screen(drawing.endPosition(link, end)));
      const isInside = ({ x, y }) => x > 40 && y > 60 && x < width - 40 && y < height - 60;
      return places.every((place) => place && isInside(place)) ? places : null;
    };
    const links = Array.from({ length: drawing.numLinks }, (_, link) => link)
      .filter((link) => drawing.isShown(link) && drawing.primitiveType[link] === 1 && seen(link))
      .sort((a, b) => drawing.linkLength[b] - drawing.linkLength[a]);
    return seen(links[0]);
  });
  const box = await page.locator('canvas').first().boundingBox();
  for (const { x, y } of ends) {
    await page.mouse.click(box.x + x, box.y + y);
    await rest(page);
  }
});
await take('10-cloud', async (page) => {
  await layer(page, 'cloud', true);
  await layer(page, 'cameras', false);
});
await browser.close();
