// SPDX-License-Identifier: BSD-3-Clause
// Charts of the report as inline SVG.

import { categoryColor } from './colors.js';
import { make, makeSvg } from './dom.js';
import { number } from './format.js';

const WIDTH = 440;
const HEIGHT = 240;
const MARGIN = { left: 44, right: 12, top: 12, bottom: 34 };

function frame(label, xLabel, children) {
  const bottom = HEIGHT - MARGIN.bottom;
  return makeSvg(
    'svg',
    { class: 'chart', viewBox: `0 0 ${WIDTH} ${HEIGHT}`, role: 'img', 'aria-label': label },
    makeSvg('line', {
      ...{ class: 'axis', x1: MARGIN.left, x2: WIDTH - MARGIN.right },
      ...{ y1: bottom, y2: bottom },
    }),
    makeSvg('line', {
      ...{ class: 'axis', x1: MARGIN.left, x2: MARGIN.left },
      ...{ y1: MARGIN.top, y2: bottom },
    }),
    makeSvg('text', { x: 0.5 * WIDTH, y: HEIGHT - 4, 'text-anchor': 'middle' }, xLabel),
    ...children,
  );
}

function place(x, y) {
  return [
    MARGIN.left + x * (WIDTH - MARGIN.left - MARGIN.right),
    HEIGHT - MARGIN.bottom - y * (HEIGHT - MARGIN.top - MARGIN.bottom),
  ];
}

function ticks(values, text, isVertical) {
  return values.map((value) => {
    const [x, y] = isVertical ? place(0, value.at) : place(value.at, 0);
    const attributes = isVertical
      ? { x: x - 6, y: y + 4, 'text-anchor': 'end' }
      : { x, y: y + 14, 'text-anchor': 'middle' };
    return makeSvg('text', attributes, text(value.value));
  });
}

// Counts of 0, 1, 2 ... of something.
export function histogram(label, xLabel, counts) {
  const most = Math.max(1, ...counts);
  const step = Math.max(1, Math.ceil(counts.length / 12));
  const bars = counts.map((count, index) => {
    const [x, y] = place((index + 0.1) / counts.length, count / most);
    const [right, bottom] = place((index + 0.9) / counts.length, 0);
    return makeSvg(
      'rect',
      { class: 'bar', x, y, width: right - x, height: bottom - y },
      makeSvg('title', {}, `${index}: ${count}`),
    );
  });
  const below = counts
    .map((_, index) => ({ value: index, at: (index + 0.5) / counts.length }))
    .filter(({ value }) => value % step === 0);
  const beside = [0, 0.5, 1].map((at) => ({ value: at * most, at }));
  return frame(label, xLabel, [
    ...bars,
    ...ticks(below, String, false),
    ...ticks(beside, (value) => number(value, 3), true),
  ]);
}

// Curves of [recall, precision], both from 0 to 1.
export function precisionRecall(curves) {
  const lines = curves.map(({ name, points }, index) => {
    const at = points.map(([recall, precision]) => place(recall, precision).join(','));
    return makeSvg(
      'polyline',
      { class: 'curve', points: at.join(' '), stroke: categoryColor(index) },
      makeSvg('title', {}, name),
    );
  });
  const marks = [0, 0.25, 0.5, 0.75, 1].map((value) => ({ value, at: value }));
  const chart = frame('Precision against recall', 'recall (precision upwards)', [
    ...ticks(marks, String, false),
    ...ticks(marks, String, true),
    ...lines,
  ]);
  const legend = curves.map(({ name }, index) => {
    const swatch = make('span', { class: 'swatch' });
    swatch.style.background = categoryColor(index);
    return make('div', { class: 'check' }, swatch, name);
  });
  return make('div', {}, chart, ...legend);
}
