// SPDX-License-Identifier: BSD-3-Clause
// The links that are picked, and ways to pick many of them.

export class Selection {
  constructor() {
    this.links = new Set();
    this.onChange = () => {};
  }

  get size() {
    return this.links.size;
  }

  // The link, if it is one.
  get only() {
    return this.size === 1 ? [...this.links][0] : null;
  }

  set(links) {
    this.links = new Set(links);
    this.onChange();
  }

  add(links) {
    this.set([...this.links, ...links]);
  }

  toggle(link) {
    const links = new Set(this.links);
    if (!links.delete(link)) links.add(link);
    this.set(links);
  }

  keep(passes) {
    const kept = [...this.links].filter(passes);
    if (kept.length < this.size) this.set(kept);
  }
}

function linksThat(drawing, passes) {
  const links = [];
  for (let link = 0; link < drawing.numLinks; ++link) if (passes(link)) links.push(link);
  return links;
}

// `category`: an index of LINK_KINDS; links that are not shown, too.
export function linksOfKind(drawing, category) {
  return linksThat(
    drawing,
    (link) => drawing.isLive(link) && drawing.kindCategory[link] === category,
  );
}

export function linksShorterThan(drawing, length) {
  return linksThat(drawing, (link) => drawing.isShown(link) && drawing.linkLength[link] < length);
}

// How many of a link's vertices are in a rectangle on the screen, and whether the link touches it.
function inRectangle(drawing, link, m, { width, height }, { left, top, right, bottom }) {
  const [begin, end] = drawing.range(link);
  const p = drawing.points;
  let inside = 0;
  let touches = false;
  let before = null;
  for (let vertex = begin; vertex < end; ++vertex) {
    const [x, y, z] = [p[3 * vertex], p[3 * vertex + 1], p[3 * vertex + 2]];
    const w = m[3] * x + m[7] * y + m[11] * z + m[15];
    if (w <= 0) {
      before = null;
      continue;
    }
    const sx = 0.5 * width * (1 + (m[0] * x + m[4] * y + m[8] * z + m[12]) / w);
    const sy = 0.5 * height * (1 - (m[1] * x + m[5] * y + m[9] * z + m[13]) / w);
    if (sx >= left && sx <= right && sy >= top && sy <= bottom) ++inside;
    if (!touches && before) {
      touches = crosses(before, [sx, sy], { left, top, right, bottom });
    }
    before = [sx, sy];
  }
  return { isWhole: inside === end - begin, touches: touches || inside > 0 };
}

// Whether a segment has a point in a rectangle (Liang and Barsky).
function crosses([x0, y0], [x1, y1], { left, top, right, bottom }) {
  let from = 0;
  let to = 1;
  for (const [start, step, low, high] of [
    [x0, x1 - x0, left, right],
    [y0, y1 - y0, top, bottom],
  ]) {
    if (step === 0) {
      if (start < low || start > high) return false;
      continue;
    }
    const ends = [(low - start) / step, (high - start) / step].sort((a, b) => a - b);
    from = Math.max(from, ends[0]);
    to = Math.min(to, ends[1]);
  }
  return from <= to;
}

// Links that are wholly in a rectangle on the screen, or, if they need only touch it, those that do.
// `matrix`: from the drawing to clip space, column by column.
export function linksInRectangle(drawing, matrix, size, rectangle, mayTouch) {
  return linksThat(drawing, (link) => {
    if (!drawing.isPickable(link)) return false;
    const { isWhole, touches } = inRectangle(drawing, link, matrix, size, rectangle);
    return mayTouch ? touches : isWhole;
  });
}
