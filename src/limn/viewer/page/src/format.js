// SPDX-License-Identifier: BSD-3-Clause
// Numbers as text.

// Six significant digits: what a float holds.
export function number(value, digits = 6) {
  if (!Number.isFinite(value)) return 'unknown';
  if (value === 0) return '0';
  const size = Math.abs(value);
  if (size >= 1e7 || size < 1e-4) return value.toExponential(digits - 1);
  return String(Number(value.toPrecision(digits)));
}

// A number and its standard deviation, to two digits of this: "2.4034 ± 0.0021".
export function measured(value, sigma) {
  if (!(sigma > 0) || !Number.isFinite(sigma)) return number(value);
  const decimals = Math.ceil(1 - Math.log10(sigma));
  if (decimals < 0 || decimals > 12) return `${number(value)} ± ${number(sigma, 2)}`;
  return `${value.toFixed(decimals)} ± ${sigma.toFixed(decimals)}`;
}

export function count(value) {
  return value.toLocaleString('en');
}

export function percent(share) {
  return `${number(100 * share, 3)} %`;
}

export function degrees(radians) {
  return `${number((180 / Math.PI) * radians, 4)}°`;
}

// Of milliseconds.
export function moment(time) {
  return new Date(time).toLocaleString('en', { dateStyle: 'medium', timeStyle: 'short' });
}

// Coordinates of a model may have large common parts, of which all digits count.
export function coordinates(point, step) {
  const digits = Math.min(12, Math.max(0, Math.ceil(-Math.log10(step))));
  return Array.from(point, (value) => value.toFixed(digits)).join(', ');
}
