// SPDX-License-Identifier: BSD-3-Clause
// Whether the file of the drawing beside the page has changed since the page was made. A page that
// was opened from disk may read no other files, so that this is known only of one that is served.

const PRIME_LOW = 0x1b3; // of 2^40 + 0x1b3

// limn/cache/content_hash.h: 64-bit FNV-1a, as two halves.
export class Fingerprint {
  constructor() {
    this.high = 0xcbf29ce4;
    this.low = 0x84222325;
  }

  add(bytes) {
    let { high, low } = this;
    for (const byte of bytes) {
      low = (low ^ byte) >>> 0;
      const product = low * PRIME_LOW;
      const carry = Math.floor(product / 2 ** 32);
      high = (Math.imul(high, PRIME_LOW) + carry + (low << 8)) >>> 0;
      low = product >>> 0;
    }
    Object.assign(this, { high, low });
  }

  hex() {
    return [this.high, this.low].map((half) => half.toString(16).padStart(8, '0')).join('');
  }
}

async function fingerprintOf(stream) {
  const fingerprint = new Fingerprint();
  const reader = stream.getReader();
  for (;;) {
    const { done, value } = await reader.read();
    if (done) return fingerprint.hex();
    fingerprint.add(value);
  }
}

export async function isOlderThanFile({ name, fingerprint }) {
  const isServed = window.location.protocol.startsWith('http');
  if (!isServed || !name || !fingerprint) return false;
  try {
    const response = await fetch(encodeURIComponent(name), { cache: 'no-cache' });
    return response.ok && (await fingerprintOf(response.body)) !== fingerprint;
  } catch {
    return false;
  }
}
