// SPDX-License-Identifier: BSD-3-Clause
// Round marks of a fixed size on the screen, with a rim: junctions and ends.

import { BufferAttribute, BufferGeometry, Color, Points, ShaderMaterial } from 'three';

const VERTEX = `
  uniform float size;
  void main() {
    gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
    gl_PointSize = size;
  }`;

const FRAGMENT = `
  uniform float size;
  uniform vec3 fill;
  uniform vec3 rim;
  void main() {
    float place = length(2.0 * gl_PointCoord - 1.0);
    float pixel = 2.0 / size;
    float opacity = (1.0 - place) / pixel;
    if (opacity <= 0.0) discard;
    vec3 shade = mix(fill, rim, clamp((place - 0.6) / pixel + 0.5, 0.0, 1.0));
    gl_FragColor = vec4(shade, min(opacity, 1.0));
  }`;

export class Markers {
  // `positions`: three numbers each.
  constructor(positions, { size, fill, rim }, scene) {
    this.sizePx = size;
    this.material = new ShaderMaterial({
      vertexShader: VERTEX,
      fragmentShader: FRAGMENT,
      transparent: true,
      uniforms: {
        size: { value: size },
        fill: { value: new Color(fill) },
        rim: { value: new Color(rim) },
      },
    });
    this.points = new Points(new BufferGeometry(), this.material);
    this.points.frustumCulled = false;
    this.points.renderOrder = 1;
    this.points.onBeforeRender = (renderer) => {
      this.material.uniforms.size.value = this.sizePx * renderer.getPixelRatio();
    };
    scene.add(this.points);
    this.setPositions(positions);
  }

  setPositions(positions) {
    this.points.geometry.dispose();
    this.points.geometry = new BufferGeometry();
    const places = new BufferAttribute(Float32Array.from(positions), 3);
    this.points.geometry.setAttribute('position', places);
  }
}
