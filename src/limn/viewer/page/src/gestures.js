// SPDX-License-Identifier: BSD-3-Clause
// Pointers on the canvas: taps, double taps, hovering; wheel, pinch and drag over a photograph (the
// controls of three.js do it elsewhere).

export const TAP_PX = 5;
const DOUBLE_MS = 350;
const DOUBLE_PX = 24;
const WHEEL_STEP = 0.0015;

export function placeOf(event, canvas) {
  const { left, top } = canvas.getBoundingClientRect();
  return { x: event.clientX - left, y: event.clientY - top };
}

// on.tap(x, y, isTouch, withShift), on.doubleTap(the same), on.hover(x, y).
export function watchTaps(canvas, on) {
  let down = null;
  let previous = null;
  let pointers = 0;
  canvas.addEventListener('pointerdown', (event) => {
    ++pointers;
    const isFirst = pointers === 1 && event.button === 0;
    down = isFirst ? { ...placeOf(event, canvas), id: event.pointerId } : null;
  });
  canvas.addEventListener('pointercancel', () => {
    pointers = Math.max(0, pointers - 1);
    down = null;
  });
  canvas.addEventListener('pointerup', (event) => {
    pointers = Math.max(0, pointers - 1);
    const { x, y } = placeOf(event, canvas);
    const isTap = down?.id === event.pointerId && Math.hypot(x - down.x, y - down.y) < TAP_PX;
    down = null;
    if (!isTap) return;
    const isTouch = event.pointerType === 'touch';
    const isDouble =
      previous &&
      previous.withShift === event.shiftKey &&
      event.timeStamp - previous.time < DOUBLE_MS &&
      Math.hypot(x - previous.x, y - previous.y) < DOUBLE_PX;
    previous = isDouble ? null : { x, y, time: event.timeStamp, withShift: event.shiftKey };
    (isDouble ? on.doubleTap : on.tap)(x, y, isTouch, event.shiftKey);
  });
  canvas.addEventListener('pointermove', (event) => {
    if (event.pointerType === 'touch' || pointers > 0) return;
    const { x, y } = placeOf(event, canvas);
    on.hover(x, y);
  });
}

// on.zoom(factor, x, y, dx, dy), only while on.isActive().
export function watchPhotoGestures(canvas, on) {
  const pointers = new Map();
  canvas.addEventListener(
    'wheel',
    (event) => {
      if (!on.isActive()) return;
      event.preventDefault();
      const { x, y } = placeOf(event, canvas);
      on.zoom(Math.exp(-WHEEL_STEP * event.deltaY), x, y, 0, 0);
    },
    { passive: false },
  );
  const forget = (event) => pointers.delete(event.pointerId);
  canvas.addEventListener('pointerdown', (event) => {
    pointers.set(event.pointerId, placeOf(event, canvas));
  });
  canvas.addEventListener('pointerup', forget);
  canvas.addEventListener('pointercancel', forget);
  canvas.addEventListener('pointermove', (event) => {
    const before = pointers.get(event.pointerId);
    if (!before) return;
    const now = placeOf(event, canvas);
    pointers.set(event.pointerId, now);
    if (!on.isActive()) return;
    if (pointers.size === 2) {
      const [other] = [...pointers].filter(([id]) => id !== event.pointerId).map(([, p]) => p);
      const spread = (place) => Math.hypot(place.x - other.x, place.y - other.y);
      const factor = spread(before) > 0 ? spread(now) / spread(before) : 1;
      const [dx, dy] = [0.5 * (now.x - before.x), 0.5 * (now.y - before.y)];
      on.zoom(factor, 0.5 * (before.x + other.x), 0.5 * (before.y + other.y), dx, dy);
    } else if (event.buttons & 2) {
      on.zoom(1, now.x, now.y, now.x - before.x, now.y - before.y);
    }
  });
}
