// SPDX-License-Identifier: BSD-3-Clause
// Polylines that are some pixels wide, with smooth edges, in one draw call. The
// lines of three.js's examples need multisampling and one instance per segment, which takes seconds
// where GL is done in software.

import {
  BufferAttribute,
  BufferGeometry,
  Color,
  DataTexture,
  DoubleSide,
  FloatType,
  GLSL3,
  Mesh,
  RGBAFormat,
  ShaderMaterial,
  Sphere,
  UnsignedByteType,
  Vector2,
} from 'three';

// Vertices of the polylines are texels, in rows of this length.
const ROW = 1024;
const QUAD = [0, 1, 3, 0, 3, 2];

// Positions go to the screen here, since widths are measured there: the outcome has w = 1, and what
// is interpolated is straight on the screen.
const VERTEX = `
  precision highp sampler2D;
  uniform sampler2D vertices;
  uniform sampler2D colors;
  uniform vec2 size;
  uniform float width;
  uniform vec3 tint;
  out vec3 shade;
  out vec2 place;
  flat out float reach;

  vec4 behindNear(vec4 from, vec4 to, float near) {
    return from.w >= near ? from : mix(from, to, (near - from.w) / (to.w - from.w));
  }

  vec3 texelOf(sampler2D map, int vertex) {
    return texelFetch(map, ivec2(vertex % ROW, vertex / ROW), 0).xyz;
  }

  // Four corners per segment: both sides of its first vertex, then of its second.
  void main() {
    int start = gl_VertexID / 4;
    bool isLast = gl_VertexID % 4 >= 2;
    float side = gl_VertexID % 2 == 0 ? -1.0 : 1.0;
    vec4 a = projectionMatrix * modelViewMatrix * vec4(texelOf(vertices, start), 1.0);
    vec4 b = projectionMatrix * modelViewMatrix * vec4(texelOf(vertices, start + 1), 1.0);
    float near = projectionMatrix[3][2] / (projectionMatrix[2][2] - 1.0);
    if (max(a.w, b.w) <= near) {
      gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
      return;
    }
    vec4 first = behindNear(a, b, near);
    vec4 last = behindNear(b, a, near);
    vec2 from = 0.5 * size * first.xy / first.w;
    vec2 to = 0.5 * size * last.xy / last.w;
    reach = distance(from, to);
    vec2 along = reach > 1e-4 ? (to - from) / reach : vec2(1.0, 0.0);
    vec2 across = vec2(-along.y, along.x);
    float margin = 0.5 * width + 1.0;
    #ifdef IS_ROUND
      float cap = margin;
    #else
      float cap = 0.0;
    #endif
    place = vec2(isLast ? reach + cap : -cap, margin * side);
    vec4 mine = isLast ? last : first;
    gl_Position = vec4((from + along * place.x + across * place.y) / (0.5 * size), mine.z / mine.w, 1.0);
    #ifdef WITH_COLORS
      shade = texelOf(colors, isLast ? start + 1 : start);
    #else
      shade = tint;
    #endif
  }`;

const FRAGMENT = `
  uniform float width;
  in vec3 shade;
  in vec2 place;
  flat in float reach;
  out vec4 color;
  void main() {
    float beyond = place.x - clamp(place.x, 0.0, reach);
    float opacity = 0.5 * width + 0.5 - length(vec2(beyond, place.y));
    if (opacity <= 0.0) discard;
    color = vec4(shade, min(opacity, 1.0));
  }`;

function textureOf(Type, numVertices, format) {
  const rows = Math.max(1, Math.ceil(numVertices / ROW));
  return new DataTexture(new Type(4 * ROW * rows), ROW, rows, RGBAFormat, format);
}

function fillTexture(texture, triples) {
  const { data } = texture.image;
  for (let from = 0, to = 0; from < triples.length; from += 3, to += 4) {
    data[to] = triples[from];
    data[to + 1] = triples[from + 1];
    data[to + 2] = triples[from + 2];
  }
  texture.needsUpdate = true;
}

// Several polylines as one: positions, and the first vertices of its segments.
export function joined(polylines) {
  const positions = [];
  const segments = [];
  for (const points of polylines) {
    points.forEach((point, i) => {
      if (i + 1 < points.length) segments.push(positions.length / 3);
      positions.push(...point);
    });
  }
  return { positions, segments };
}

export class WideLines {
  // Round ends and joints overlap. Where segments are shorter than a pixel their smooth edges would add
  // up to a jagged band, so that long curves of many segments must do without.
  constructor(
    { width, withColors = false, isRound = true, depthTest = true, renderOrder = 0 },
    scene,
  ) {
    this.widthPx = width;
    this.material = new ShaderMaterial({
      vertexShader: VERTEX,
      fragmentShader: FRAGMENT,
      glslVersion: GLSL3,
      defines: { ROW, IS_ROUND: isRound, WITH_COLORS: withColors }, // false: not defined
      uniforms: {
        vertices: { value: null },
        colors: { value: null },
        size: { value: new Vector2() },
        width: { value: width },
        tint: { value: new Color() },
      },
      transparent: true,
      depthTest,
      depthWrite: false,
      side: DoubleSide,
    });
    this.mesh = new Mesh(new BufferGeometry(), this.material);
    this.mesh.frustumCulled = false;
    this.mesh.renderOrder = renderOrder;
    this.mesh.onBeforeRender = (renderer) => {
      renderer.getDrawingBufferSize(this.material.uniforms.size.value);
      this.material.uniforms.width.value = this.widthPx * renderer.getPixelRatio();
    };
    scene.add(this.mesh);
  }

  // `positions`: three numbers per vertex; `segments`: the first vertices of those that are drawn.
  setLines({ positions, segments }) {
    const { vertices, colors } = this.material.uniforms;
    vertices.value?.dispose();
    colors.value?.dispose();
    vertices.value = textureOf(Float32Array, positions.length / 3, FloatType);
    colors.value = textureOf(Uint8Array, positions.length / 3, UnsignedByteType);
    fillTexture(vertices.value, positions);
    this.setSegments(segments);
  }

  // The vertices of other lines; which segments, and in which color, may differ.
  shareLines(other) {
    this.material.uniforms.vertices.value = other.material.uniforms.vertices.value;
    this.material.uniforms.colors.value = other.material.uniforms.colors.value;
  }

  setSegments(segments) {
    const corners = new Uint32Array(6 * segments.length);
    for (let s = 0, to = 0; s < segments.length; ++s) {
      for (let i = 0; i < 6; ++i) corners[to++] = 4 * segments[s] + QUAD[i];
    }
    this.mesh.geometry.dispose();
    this.mesh.geometry = new BufferGeometry();
    this.mesh.geometry.setIndex(new BufferAttribute(corners, 1));
    // Sorting by depth asks for a place.
    this.mesh.geometry.boundingSphere = new Sphere();
  }

  // Switches segments of setSegments() on and off: those from number `first` on, `count` of them;
  // the first begins at `vertex`, each at the next vertex.
  switchSegments(first, count, vertex, isShown) {
    const index = this.mesh.geometry.getIndex();
    for (let s = 0, to = 6 * first; s < count; ++s) {
      for (let i = 0; i < 6; ++i) index.array[to++] = isShown ? 4 * (vertex + s) + QUAD[i] : 0;
    }
    index.addUpdateRange(6 * first, 6 * count);
    index.needsUpdate = true;
  }

  // Three bytes per vertex.
  setColors(colors) {
    fillTexture(this.material.uniforms.colors.value, colors);
  }

  setTint(color) {
    this.material.uniforms.tint.value.set(color);
  }

  get visible() {
    return this.mesh.visible;
  }

  set visible(visible) {
    this.mesh.visible = visible;
  }
}
