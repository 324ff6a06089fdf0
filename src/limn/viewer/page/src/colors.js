// SPDX-License-Identifier: BSD-3-Clause
// What the drawing is colored by, and the legend of it.

import { DENSE_CLASSES, LINK_KINDS, PRIMITIVES, TEXTURE } from './drawing.js';
import { number } from './format.js';

// Middling lightness: readable on white and on black.
const RAMP = [
  [63, 127, 224],
  [31, 168, 160],
  [216, 160, 32],
  [224, 69, 58],
];
const NOT_KNOWN = [138, 143, 152];
const CATEGORIES = [
  NOT_KNOWN,
  [59, 142, 234],
  [240, 140, 46],
  [196, 95, 214],
  [47, 174, 96],
  [176, 160, 32],
  [168, 160, 148], // texture: muted
  [190, 66, 66],
];
const GOLDEN_RATIO = 0.6180339887498949;

function onRamp(share) {
  if (!Number.isFinite(share)) return NOT_KNOWN;
  const place = Math.min(Math.max(share, 0), 1) * (RAMP.length - 1);
  const low = Math.min(Math.floor(place), RAMP.length - 2);
  return RAMP[low].map((from, c) => Math.round(from + (place - low) * (RAMP[low + 1][c] - from)));
}

// Hues well apart for numbers that follow each other.
function colorOfNumber(index) {
  const hue = (0.58 + GOLDEN_RATIO * index) % 1;
  const channel = (offset) => {
    const place = (offset + 6 * hue) % 6;
    const ramp = Math.min(Math.max(Math.min(place, 4 - place), 0), 1);
    return Math.round(225 * (1 - 0.78 * ramp));
  };
  return [channel(5), channel(3), channel(1)];
}

export function css([red, green, blue]) {
  return `rgb(${red} ${green} ${blue})`;
}

function fillLinks(drawing, colorOf) {
  const colors = new Uint8Array(3 * drawing.numVertices);
  for (let link = 0; link < drawing.numLinks; ++link) {
    const [red, green, blue] = colorOf(link);
    const [begin, end] = drawing.range(link);
    for (let at = 3 * begin; at < 3 * end; at += 3) {
      colors[at] = red;
      colors[at + 1] = green;
      colors[at + 2] = blue;
    }
  }
  return colors;
}

// The ends of a scale: all but the outermost fiftieths of the values.
function limits(values) {
  const known = Float64Array.from(values.filter(Number.isFinite)).sort();
  if (known.length === 0) return [0, 1];
  const stray = Math.floor(0.02 * (known.length - 1));
  const [low, high] = [known[stray], known[known.length - 1 - stray]];
  return high > low ? [low, high] : [low, low + Math.max(Math.abs(low), 1e-12)];
}

function rampLegend([low, high], text) {
  return {
    ramp: `linear-gradient(to right, ${RAMP.map(css).join(', ')})`,
    low: text(low),
    high: text(high),
  };
}

function byLinkValue(drawing, valueOf, text) {
  const values = Array.from({ length: drawing.numLinks }, (_, link) => valueOf(link));
  const [low, high] = limits(values);
  return {
    colors: fillLinks(drawing, (link) => onRamp((values[link] - low) / (high - low))),
    legend: rampLegend([low, high], text),
  };
}

// Standard deviations of a drawing span decades.
function bySigma(drawing) {
  const logs = Float64Array.from(drawing.sigma, (sigma) => Math.log(sigma));
  const [low, high] = limits(Array.from(logs));
  const colors = new Uint8Array(3 * drawing.numVertices);
  logs.forEach((value, vertex) => colors.set(onRamp((value - low) / (high - low)), 3 * vertex));
  return { colors, legend: rampLegend([low, high], (log) => number(Math.exp(log), 3)) };
}

function byCategory(drawing, types, names) {
  const lengths = names.map(() => 0);
  types.forEach((type, link) => {
    if (drawing.isLive(link)) lengths[type] += drawing.linkLength[link];
  });
  const whole = lengths.reduce((sum, length) => sum + length, 0);
  const entries = names
    .map((name, type) => ({
      name,
      type,
      color: CATEGORIES[type],
      share: whole > 0 ? lengths[type] / whole : 0,
      shown: types.every(
        (of, link) => of !== type || !drawing.isLive(link) || drawing.visible[link] === 1,
      ),
    }))
    .filter((entry) => entry.share > 0);
  return {
    colors: fillLinks(drawing, (link) => CATEGORIES[types[link]]),
    legend: { entries, types },
  };
}

function byOwnColor(drawing) {
  return {
    colors: fillLinks(drawing, (link) =>
      drawing.linkKind[link] === TEXTURE
        ? CATEGORIES[TEXTURE]
        : drawing.linkColor.subarray(3 * link, 3 * link + 3),
    ),
    legend: { note: 'One color per curve, as in drawing.ply and the overlays.' },
  };
}

function byComponent(drawing) {
  return {
    colors: fillLinks(drawing, (link) => colorOfNumber(drawing.component[link])),
    legend: { note: `${drawing.numComponents} connected components.` },
  };
}

const SCHEMES = [
  { id: 'link', label: 'Curve', apply: byOwnColor },
  {
    id: 'support',
    label: 'Supporting views',
    apply: (drawing) => byLinkValue(drawing, (link) => drawing.numSupportingViews(link), String),
  },
  {
    id: 'residual',
    label: 'Residual, px',
    apply: (drawing) =>
      byLinkValue(
        drawing,
        (link) => drawing.linkResidual[link],
        (v) => number(v, 3),
      ),
  },
  { id: 'sigma', label: 'Sigma, model units', apply: bySigma },
  {
    id: 'primitive',
    label: 'Primitive',
    apply: (drawing) => byCategory(drawing, drawing.primitiveType, PRIMITIVES),
    available: (drawing) => drawing.hasPrimitives,
  },
  {
    id: 'class',
    label: 'Class on the dense surface',
    apply: (drawing) => byCategory(drawing, drawing.denseClass, DENSE_CLASSES),
    available: (drawing) => drawing.hasClasses,
  },
  {
    id: 'kind',
    label: 'Kind of edge',
    apply: (drawing) => byCategory(drawing, drawing.kindCategory, LINK_KINDS),
    available: (drawing) => drawing.hasKinds,
  },
  { id: 'component', label: 'Component', apply: byComponent },
];

// Those for which the drawing has the numbers.
export function schemesFor(drawing) {
  return SCHEMES.filter((scheme) => scheme.available?.(drawing) ?? true);
}

// Colors of the lines of a chart.
export function categoryColor(index) {
  return css(CATEGORIES[1 + (index % (CATEGORIES.length - 1))]);
}
