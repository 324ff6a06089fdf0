// SPDX-License-Identifier: BSD-3-Clause
// The tab "Drawing": what there is, colors with their legend, layers, the measurement.

import { css } from './colors.js';
import { facts, make } from './dom.js';
import { DETAILS, JUNCTION } from './drawing.js';
import { coordinates, count, measured, number, percent } from './format.js';

const DETAIL_TEXTS = {
  coarse: 'long curves only',
  normal: 'all but texture',
  all: 'texture, too',
};

const squareOf = (unit) => (unit === 'm' ? 'm²' : `square ${unit}`);

function summary(drawing) {
  const area = drawing.faceAreas.reduce((sum, value) => sum + value, 0);
  const length = drawing.linkLength.reduce((sum, value) => sum + value, 0);
  const junctions = drawing.nodeKind.filter((kind) => kind === JUNCTION).length;
  return facts([
    ['Links', count(drawing.numStored)],
    ['Junctions', count(junctions)],
    ['Components', count(drawing.numComponents)],
    ['Coordinates', drawing.zIsUp ? `the world's, z up, ${drawing.unit}` : "the model's"],
    [`Length, ${drawing.unit}`, number(length)],
    ['Faces', drawing.numFaces > 0 ? count(drawing.numFaces) : null],
    [`Area of the faces, ${squareOf(drawing.unit)}`, drawing.numFaces > 0 ? number(area) : null],
    ['Views', count(drawing.views.length)],
    ['Points of the cloud', count(drawing.cloudPositions.length / 3)],
  ]);
}

function rampLegend(legend) {
  const ramp = make('div', { class: 'ramp' });
  ramp.style.background = legend.ramp;
  const ends = make('div', { class: 'ramp-ends' }, make('span', {}, legend.low));
  ends.append(make('span', {}, legend.high));
  return [ramp, ends];
}

// Entries can be switched off.
function categoryLegend({ entries }, onToggle) {
  return entries.map(({ name, type, color, share, shown }) => {
    const swatch = make('span', { class: 'swatch' });
    swatch.style.background = css(color);
    const box = make('input', {
      type: 'checkbox',
      onchange: (event) => onToggle(type, event.target.checked),
    });
    box.checked = shown;
    return make(
      'label',
      { class: 'check' },
      box,
      swatch,
      `${name}, ${percent(share)} of the length`,
    );
  });
}

function measurement(drawing, result) {
  if (!result) return [];
  const { from, to, delta, distance, sigma } = result;
  const step = 1e-5 * drawing.radius;
  const at = ({ position, node, link }) => {
    const what = node !== undefined ? `node ${node}` : `link ${link}`;
    return `${coordinates(drawing.displayed(position), step)} (${what})`;
  };
  return [
    make('h2', {}, `Measured, ${drawing.unit}`),
    facts([
      ['Distance', measured(distance, sigma)],
      ['dx', number(delta.x)],
      ['dy', number(delta.y)],
      ['dz', number(delta.z)],
      ['From', at(from)],
      ['To', at(to)],
    ]),
  ];
}

export class DrawingPanel {
  // on.scheme(id), on.detail(detail), on.layer(id, shown), on.category(type, shown).
  constructor(drawing, schemes, layers, on) {
    this.drawing = drawing;
    this.on = on;
    this.select = make(
      'select',
      { id: 'scheme', onchange: (event) => on.scheme(event.target.value) },
      ...schemes.map(({ id, label }) => make('option', { value: id }, label)),
    );
    this.legend = make('div', { id: 'legend' });
    this.measured = make('div', { id: 'measured', role: 'status', 'aria-live': 'polite' });
    this.boxes = new Map(layers.map((layer) => [layer.id, this.layerBox(layer)]));
    const boxes = layers.map(({ id, label }) =>
      make('label', { class: 'check' }, this.boxes.get(id), label),
    );
    this.content = [
      make('section', {}, make('h1', {}, drawing.title), this.measured, summary(drawing)),
      make(
        'section',
        {},
        make('h2', {}, make('label', { for: 'scheme' }, 'Color by')),
        make('div', { class: 'field' }, this.select, this.legend),
        make('h2', {}, make('label', { for: 'detail' }, 'Detail')),
        ...this.detailSlider(),
        make('h2', {}, 'Layers'),
        make('div', { role: 'group', 'aria-label': 'Layers' }, ...boxes),
      ),
    ];
  }

  detailSlider() {
    const slider = make('input', {
      ...{ type: 'range', id: 'detail', min: '0', max: String(DETAILS.length - 1), step: '1' },
      oninput: () => {
        show();
        this.on.detail(DETAILS[slider.value]);
      },
    });
    const name = make('span', { class: 'faint', id: 'detail-name' });
    const show = () => {
      const detail = DETAILS[slider.value];
      name.textContent = `${detail}: ${DETAIL_TEXTS[detail]}`;
      slider.setAttribute('aria-valuetext', detail);
    };
    slider.value = String(DETAILS.indexOf(this.drawing.detail));
    show();
    return [make('div', { class: 'field' }, slider, name)];
  }

  layerBox({ id, shown }) {
    const box = make('input', {
      ...{ type: 'checkbox', id: `layer-${id}` },
      onchange: (event) => this.on.layer(id, event.target.checked),
    });
    box.checked = shown;
    return box;
  }

  showScheme(id, legend) {
    this.select.value = id;
    if (legend.ramp) this.legend.replaceChildren(...rampLegend(legend));
    else if (legend.note) this.legend.replaceChildren(make('div', { class: 'faint' }, legend.note));
    else this.legend.replaceChildren(...categoryLegend(legend, this.on.category));
  }

  showLayer(id, shown) {
    this.boxes.get(id).checked = shown;
  }

  showMeasurement(isActive, result) {
    const hint = 'Pick two points: junctions, ends and curves catch the pointer.';
    const waiting = isActive && !result ? [make('p', { class: 'faint' }, hint)] : [];
    this.measured.replaceChildren(...waiting, ...measurement(this.drawing, result));
  }
}
