// SPDX-License-Identifier: BSD-3-Clause
// The tab "Report": how the drawing came about. All members of the report are optional.

import { histogram, precisionRecall } from './charts.js';
import { facts, make } from './dom.js';
import { count, number, percent } from './format.js';

const isList = (value) => Array.isArray(value) && value.length > 0;

function counts(values) {
  const entries = Object.entries(values ?? {});
  return entries.map(([name, value]) => `${name} ${count(value)}`).join(', ');
}

function grid(heads, rows) {
  const isNumber = (value) => typeof value === 'number';
  const cell = (value) =>
    make(
      'td',
      { class: isNumber(value) ? 'number' : null },
      isNumber(value) ? number(value, 4) : value,
    );
  return make(
    'div',
    { class: 'scroll' },
    make(
      'table',
      { class: 'grid' },
      make('thead', {}, make('tr', {}, ...heads.map((head) => make('th', { scope: 'col' }, head)))),
      make('tbody', {}, ...rows.map((row) => make('tr', {}, ...row.map(cell)))),
    ),
  );
}

function stages(list) {
  const rows = list.map((stage) => [
    stage.stage ?? '',
    stage.seconds ?? '',
    stage.peak_mb ?? '',
    counts(stage.in),
    counts(stage.kept),
    counts(stage.dropped),
  ]);
  return grid(['Stage', 's', 'Peak MB', 'In', 'Kept', 'Dropped'], rows);
}

function evaluation(list) {
  const rows = list.map(({ tau, unit, precision, recall, f }) => [
    `${tau} ${unit ?? ''}`,
    percent(precision),
    percent(recall),
    percent(f),
  ]);
  return grid(['Within', 'Precision', 'Recall', 'F'], rows);
}

function trust({ images, explained, agree_less: less, many_views: many, apart, ...shares }) {
  const names = isList(less)
    ? `${less.length} of ${images}: ` +
      less.map(({ name, share }) => `${name} (${percent(share)})`).join(', ')
    : 'none';
  const isKnown = (value) => typeof value === 'number';
  return facts([
    ['Edges of an image that it explains', isKnown(explained) ? percent(explained) : null],
    ['Images that agree much less', isKnown(explained) ? names : null],
    [
      'Images whose cameras do not fit the others',
      isList(apart)
        ? `${apart.length} of ${images}, with ${percent(shares.shared_if_apart)} of the curves in common that they should have: ${apart.join(', ')}`
        : null,
    ],
    [
      'Edges drawn that fit several depths',
      isKnown(shares.at_other_depths) ? percent(shares.at_other_depths) : null,
    ],
    [
      `Length seen by ${many} or more images`,
      isKnown(shares.well_seen) ? percent(shares.well_seen) : null,
    ],
    [
      `Expected error, ${shares.has_share_of_cameras ? 'refined cameras included' : 'if the cameras are right'}`,
      isKnown(shares.error_px)
        ? `${number(shares.error_px, 3)} px (median), ${number(shares.error_90_px, 3)} px (90 %)`
        : null,
    ],
    [
      'Length found that is expected to be right',
      isKnown(shares.right) ? percent(shares.right) : null,
    ],
    [
      'Length found that is doubtful, hence tentative',
      isKnown(shares.tentative) ? percent(shares.tentative) : null,
    ],
    [
      'Length found whose depth was not measured',
      isKnown(shares.unmeasured) ? percent(shares.unmeasured) : null,
    ],
    ['Edges that stand still in the images', isKnown(shares.still) ? percent(shares.still) : null],
  ]);
}

function section(title, isThere, content) {
  return isThere ? [make('h2', {}, title), content()] : [];
}

function isOfAnotherState(report, stamp) {
  return Boolean(report.drawing && stamp.fingerprint) && report.drawing !== stamp.fingerprint;
}

// `stamp`: of the drawing that the page shows.
export function reportPanel(report, stamp, overlays) {
  const changed = Object.entries(report.options_changed ?? {});
  return [
    make('h1', {}, report.title ?? 'Report'),
    ...(report.workspace ? [make('p', { class: 'faint' }, report.workspace)] : []),
    ...section('Since then', isOfAnotherState(report, stamp), () =>
      make('p', {}, 'The drawing has changed since this run: its numbers are of before.'),
    ),
    ...section('Warnings', isList(report.warnings), () =>
      make('ul', { class: 'warnings' }, ...report.warnings.map((text) => make('li', {}, text))),
    ),
    ...section('How far to trust it', report.trust, () => trust(report.trust)),
    ...section('Stages', isList(report.stages), () => stages(report.stages)),
    ...section('Options that are not the defaults', changed.length > 0, () =>
      facts(changed.map(([name, value]) => [name, String(value)])),
    ),
    ...section('Links by number of supporting views', isList(report.support_histogram), () =>
      histogram(
        'Links by number of supporting views',
        'supporting views',
        report.support_histogram,
      ),
    ),
    ...section('Against the truth', isList(report.evaluation), () => evaluation(report.evaluation)),
    ...section('Precision and recall', isList(report.pr_curves), () =>
      precisionRecall(report.pr_curves),
    ),
    ...section('The drawing over the photographs', overlays !== null, () => overlays),
  ];
}
