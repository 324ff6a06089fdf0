// SPDX-License-Identifier: BSD-3-Clause
// A rectangle drawn with the pointer, by the tool or with Shift. The controls that turn the picture
// must not see such a drag.

import { placeOf, TAP_PX } from './gestures.js';
import { make } from './dom.js';

// on.isActive(event): whether a pointer that goes down draws a box; on.hold(bool): keep the picture
// still; on.box({left, top, right, bottom}, toLeft, withShift).
export function watchBoxes(canvas, marks, on) {
  const outline = make('div', { class: 'box', hidden: true });
  marks.append(outline);
  let start = null;

  const rectangle = (x, y) => ({
    left: Math.min(x, start.x),
    top: Math.min(y, start.y),
    right: Math.max(x, start.x),
    bottom: Math.max(y, start.y),
  });
  const stop = () => {
    start = null;
    outline.hidden = true;
    on.hold(false);
  };
  canvas.addEventListener(
    'pointerdown',
    (event) => {
      if (start) return stop(); // a second finger
      if (!event.isPrimary || event.button !== 0 || !on.isActive(event)) return;
      start = { ...placeOf(event, canvas), id: event.pointerId };
      canvas.setPointerCapture(event.pointerId);
      on.hold(true);
    },
    true,
  );
  canvas.addEventListener('pointermove', (event) => {
    if (event.pointerId !== start?.id) return;
    const { x, y } = placeOf(event, canvas);
    const { left, top, right, bottom } = rectangle(x, y);
    outline.hidden = Math.hypot(x - start.x, y - start.y) < TAP_PX;
    outline.classList.toggle('touching', x < start.x);
    const [width, height] = [right - left, bottom - top];
    Object.assign(outline.style, {
      ...{ left: `${left}px`, top: `${top}px` },
      ...{ width: `${width}px`, height: `${height}px` },
    });
  });
  canvas.addEventListener('pointerup', (event) => {
    if (event.pointerId !== start?.id) return;
    const { x, y } = placeOf(event, canvas);
    const isDrag = Math.hypot(x - start.x, y - start.y) >= TAP_PX;
    const [drawn, toLeft] = [rectangle(x, y), x < start.x];
    stop();
    if (isDrag) on.box(drawn, toLeft, event.shiftKey);
  });
  canvas.addEventListener('pointercancel', () => {
    if (start) stop();
  });
}
