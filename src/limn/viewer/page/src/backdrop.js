// SPDX-License-Identifier: BSD-3-Clause
// The photograph behind the drawing while it is looked through.

import { BufferAttribute, BufferGeometry, DoubleSide, GLSL3, Mesh, RawShaderMaterial } from 'three';

import { pictureRectangle } from './optics.js';

const CORNERS = new Float32Array([0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0]);

const VERTEX = `
  in vec3 position;
  uniform vec4 rectangle;
  out vec2 place;
  void main() {
    place = position.xy;
    gl_Position = vec4(mix(rectangle.xy, rectangle.zw, place), 0.0, 1.0);
  }`;

const FRAGMENT = `
  precision mediump float;
  uniform sampler2D map;
  uniform float opacity;
  in vec2 place;
  out vec4 color;
  void main() {
    color = vec4(texture(map, place).rgb, opacity);
  }`;

export class Backdrop {
  constructor(photos, scene, onLoaded) {
    this.photos = photos;
    this.onLoaded = onLoaded;
    this.opacity = 0.6;
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(CORNERS, 3));
    geometry.setIndex([0, 1, 2, 0, 2, 3]);
    this.material = new RawShaderMaterial({
      glslVersion: GLSL3,
      vertexShader: VERTEX,
      fragmentShader: FRAGMENT,
      uniforms: {
        map: { value: null },
        opacity: { value: 0 },
        rectangle: { value: [0, 0, 0, 0] },
      },
      transparent: true,
      depthTest: false,
      depthWrite: false,
      side: DoubleSide,
    });
    this.mesh = new Mesh(geometry, this.material);
    this.mesh.frustumCulled = false;
    scene.add(this.mesh);
  }

  // Before every frame.
  update(eye) {
    const texture =
      eye.photo === null || eye.flight ? null : this.photos.fullTexture(eye.photo, this.onLoaded);
    this.mesh.visible = texture !== null && this.opacity > 0;
    if (!this.mesh.visible) return;
    const { left, top, right, bottom } = pictureRectangle(eye.view());
    const { scale, x, y } = eye.placement;
    const { width, height } = eye.size;
    const { map, opacity, rectangle } = this.material.uniforms;
    map.value = texture;
    opacity.value = this.opacity;
    rectangle.value = [
      (2 * (scale * left + x)) / width - 1,
      1 - (2 * (scale * top + y)) / height,
      (2 * (scale * right + x)) / width - 1,
      1 - (2 * (scale * bottom + y)) / height,
    ];
  }
}
