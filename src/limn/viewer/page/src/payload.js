// SPDX-License-Identifier: BSD-3-Clause
// The bytes of src/limn/viewer/payload.h.

const TYPES = {
  f32: Float32Array,
  f64: Float64Array,
  u32: Uint32Array,
  i32: Int32Array,
  u8: Uint8Array,
};

function bytesOfBase64(text) {
  const characters = atob(text);
  const bytes = new Uint8Array(characters.length);
  for (let i = 0; i < characters.length; ++i) bytes[i] = characters.charCodeAt(i);
  return bytes;
}

async function unzipped(bytes) {
  if (typeof DecompressionStream === 'undefined') {
    throw new Error('this browser is too old: it has no DecompressionStream');
  }
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('gzip'));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

// Numbers are stored in planes of their first, second ... bytes.
function readArray(bytes, { type, offset, length }) {
  const Type = TYPES[type];
  const width = Type.BYTES_PER_ELEMENT;
  if (width === 1) return bytes.subarray(offset, offset + length);
  const values = new Uint8Array(width * length);
  for (let plane = 0; plane < width; ++plane) {
    const from = offset + plane * length;
    for (let i = 0, to = plane; i < length; ++i, to += width) values[to] = bytes[from + i];
  }
  return new Type(values.buffer);
}

// The header and the arrays that it names.
export async function readPayload(text) {
  const bytes = await unzipped(bytesOfBase64(text.trim()));
  const size = new DataView(bytes.buffer).getUint32(0, true);
  const header = JSON.parse(new TextDecoder().decode(bytes.subarray(4, 4 + size)));
  const data = bytes.subarray(4 + size);
  const arrays = {};
  for (const [name, entry] of Object.entries(header.arrays)) arrays[name] = readArray(data, entry);
  return { header, arrays };
}
