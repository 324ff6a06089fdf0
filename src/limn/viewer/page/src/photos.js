// The pictures of the views, decoded when they are first needed.

import { LinearFilter, Texture } from 'three';

export class Photos {
  constructor(drawing) {
    this.drawing = drawing;
    this.bitmaps = new Map();
    this.textures = new Map();
  }

  // A promise of the picture, or nothing if the view has none.
  bitmap(view) {
    const { thumbnail } = this.drawing.views[view];
    if (!thumbnail) return null;
    if (!this.bitmaps.has(view)) {
      const { offset, length } = thumbnail;
      const bytes = this.drawing.thumbnails.subarray(offset, offset + length);
      this.bitmaps.set(view, createImageBitmap(new Blob([bytes], { type: 'image/jpeg' })));
    }
    return this.bitmaps.get(view);
  }

  // The texture, top row first, or nothing yet; `loaded` is called once when it is there.
  texture(view, loaded) {
    const known = this.textures.get(view);
    if (known !== undefined) return known;
    this.textures.set(view, null);
    this.bitmap(view)?.then((bitmap) => {
      const texture = new Texture(bitmap);
      texture.flipY = false;
      texture.generateMipmaps = false;
      texture.minFilter = LinearFilter;
      texture.needsUpdate = true;
      this.textures.set(view, texture);
      loaded();
    });
    return null;
  }
}
