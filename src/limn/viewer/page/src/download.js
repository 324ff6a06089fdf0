// SPDX-License-Identifier: BSD-3-Clause
// Saving a file that the page has made.

import { make } from './dom.js';

export function download(blob, name) {
  const url = URL.createObjectURL(blob);
  const link = make('a', { href: url, download: name });
  link.click();
  setTimeout(() => URL.revokeObjectURL(url), 10000);
}
