// SPDX-License-Identifier: BSD-3-Clause
// A grid of the photographs with the drawing over them: what a view supports strong, the rest faint.

import { css } from './colors.js';
import { make } from './dom.js';
import { pictureRectangle, project } from './optics.js';

const WIDTH_PX = 320;

function drawLink(context, drawing, view, link, toPicture) {
  const [begin, end] = drawing.range(link);
  const pixel = [0, 0, 0];
  let isDown = false;
  context.beginPath();
  for (let vertex = begin; vertex < end; ++vertex) {
    const at = 3 * vertex;
    project(view, drawing.points[at], drawing.points[at + 1], drawing.points[at + 2], pixel);
    if (pixel[2] <= 0) {
      isDown = false;
      continue;
    }
    const [x, y] = toPicture(pixel);
    if (isDown) context.lineTo(x, y);
    else context.moveTo(x, y);
    isDown = true;
  }
  context.stroke();
}

async function drawOverlay(canvas, drawing, photos, index) {
  const view = drawing.views[index];
  const { left, top, right, bottom } = pictureRectangle(view);
  const context = canvas.getContext('2d');
  const scale = canvas.width / (right - left);
  const bitmap = await photos.bitmap(index);
  if (bitmap) {
    context.globalAlpha = 0.6;
    context.drawImage(bitmap, 0, 0, canvas.width, scale * (bottom - top));
  }
  const toPicture = ([x, y]) => [scale * (x - left), scale * (y - top)];
  const supported = new Uint8Array(drawing.numLinks);
  for (let link = 0; link < drawing.numLinks; ++link) {
    supported[link] = drawing.supportingViews(link).includes(index) ? 1 : 0;
  }
  for (const strong of [0, 1]) {
    context.globalAlpha = strong ? 1 : 0.3;
    context.lineWidth = strong ? 1.6 : 0.8;
    for (let link = 0; link < drawing.numLinks; ++link) {
      if (supported[link] !== strong || !drawing.isLive(link)) continue;
      context.strokeStyle = css(drawing.linkColor.subarray(3 * link, 3 * link + 3));
      drawLink(context, drawing, view, link, toPicture);
    }
  }
}

// onPick(view). Pictures are drawn when they come into sight.
export function overlayGrid(drawing, photos, onPick) {
  const observer = new IntersectionObserver((entries) => {
    for (const { isIntersecting, target } of entries) {
      if (!isIntersecting) continue;
      observer.unobserve(target);
      drawOverlay(target, drawing, photos, Number(target.dataset.view));
    }
  });
  const buttons = drawing.views.map((view, index) => {
    const { left, top, right, bottom } = pictureRectangle(view);
    const height = Math.max(1, Math.round((WIDTH_PX * (bottom - top)) / (right - left)));
    const canvas = make('canvas', { width: WIDTH_PX, height, 'data-view': index });
    observer.observe(canvas);
    return make(
      'button',
      { type: 'button', onclick: () => onPick(index), 'aria-label': `Look through ${view.name}` },
      canvas,
      make('span', {}, view.name),
    );
  });
  return make('div', { class: 'overlays' }, ...buttons);
}
