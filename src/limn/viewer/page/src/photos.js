// SPDX-License-Identifier: BSD-3-Clause
// The pictures of the views, decoded when they are first needed: many small ones, and the last few in
// full, which take much memory.

import { LinearFilter, Texture } from 'three';

import { pictureRectangle } from './optics.js';

const SMALL_PX = 320;
const MOST_FULL = 3;

function textureOf(bitmap) {
  const texture = new Texture(bitmap);
  texture.flipY = false;
  texture.generateMipmaps = false;
  texture.minFilter = LinearFilter;
  texture.needsUpdate = true;
  return texture;
}

export class Photos {
  constructor(drawing) {
    this.drawing = drawing;
    this.bitmaps = new Map(); // promises: small ones by view, full ones by `full ${view}`
    this.textures = new Map(); // by the same
  }

  // A promise of the picture, or nothing if the view has none.
  decoded(view, options = {}) {
    const { thumbnail } = this.drawing.views[view];
    if (!thumbnail) return null;
    const { offset, length } = thumbnail;
    const bytes = this.drawing.thumbnails.subarray(offset, offset + length);
    return createImageBitmap(new Blob([bytes], { type: 'image/jpeg' }), options);
  }

  // The same, small.
  bitmap(view) {
    if (!this.bitmaps.has(view)) {
      const { left, top, right, bottom } = pictureRectangle(this.drawing.views[view]);
      const scale = SMALL_PX / Math.max(right - left, bottom - top);
      const pixels = (extent) => Math.max(1, Math.round(scale * extent));
      const size = { resizeWidth: pixels(right - left), resizeHeight: pixels(bottom - top) };
      this.bitmaps.set(view, this.decoded(view, { ...size, resizeQuality: 'medium' }));
    }
    return this.bitmaps.get(view);
  }

  // The small texture, top row first, or nothing yet; `loaded` is called once when it is there.
  texture(view, loaded) {
    return this.load(view, () => this.bitmap(view), loaded);
  }

  // That of the whole picture.
  fullTexture(view, loaded) {
    const key = `full ${view}`;
    return this.load(key, () => this.fullBitmap(key, view), loaded);
  }

  fullBitmap(key, view) {
    const full = [...this.bitmaps.keys()].filter((other) => typeof other === 'string');
    for (const old of full.slice(0, 1 - MOST_FULL)) this.free(old);
    this.bitmaps.set(key, this.decoded(view));
    return this.bitmaps.get(key);
  }

  free(key) {
    this.textures.get(key)?.dispose();
    this.textures.delete(key);
    this.bitmaps.get(key)?.then(
      (bitmap) => bitmap.close(),
      () => {},
    );
    this.bitmaps.delete(key);
  }

  load(key, bitmapOf, loaded) {
    const known = this.textures.get(key);
    if (known !== undefined) return known;
    this.textures.set(key, null);
    const decoded = bitmapOf();
    const show = (bitmap) => {
      if (this.bitmaps.get(key) !== decoded) return; // freed since
      this.textures.set(key, textureOf(bitmap));
      loaded();
    };
    decoded?.then(show, () => {}); // a damaged picture is none
    return null;
  }
}
