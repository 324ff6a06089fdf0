// SPDX-License-Identifier: BSD-3-Clause
// The faces between the curves: a translucent layer, and a mask of depths that hides what is behind.

import { BufferAttribute, BufferGeometry, DoubleSide, GLSL3, Mesh } from 'three';
import { Raycaster, ShaderMaterial, Vector2 } from 'three';

const OPACITY = 0.32;
// So far behind themselves faces hide, radii of the drawing: curves on them are to be seen.
const MARGIN = 0.004;
// Where a pointer is beside what it means, faces that slope hide less.
const PICK_SLACK = 1.02;

// Places move along their rays only.
const VERTEX = `
  uniform float margin;
  out vec3 place;
  void main() {
    place = (modelViewMatrix * vec4(position, 1.0)).xyz;
    place += margin * normalize(place);
    gl_Position = projectionMatrix * vec4(place, 1.0);
  }`;

// The side that is seen in photographs is blue, the other one brown.
const FRAGMENT = `
  uniform float opacity;
  in vec3 place;
  out vec4 color;
  void main() {
    vec3 normal = normalize(cross(dFdx(place), dFdy(place)));
    float light = 0.4 + 0.6 * abs(dot(normal, normalize(place)));
    vec3 tint = gl_FrontFacing ? vec3(0.45, 0.62, 0.86) : vec3(0.80, 0.60, 0.42);
    color = vec4(light * tint, opacity);
  }`;

function materialOf(margin, options) {
  return new ShaderMaterial({
    vertexShader: VERTEX,
    fragmentShader: FRAGMENT,
    glslVersion: GLSL3,
    uniforms: { margin: { value: margin }, opacity: { value: OPACITY } },
    side: DoubleSide,
    ...options,
  });
}

export class Faces {
  constructor(drawing, scene) {
    this.margin = MARGIN * drawing.radius;
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(drawing.faceVertices, 3));
    geometry.setIndex(new BufferAttribute(drawing.faceTriangles, 1));
    this.shades = new Mesh(geometry, materialOf(0, { transparent: true, depthWrite: false }));
    this.mask = new Mesh(geometry, materialOf(this.margin, { colorWrite: false }));
    [this.mask, this.shades].forEach((mesh, order) => {
      mesh.renderOrder = order - 2;
      mesh.frustumCulled = false;
      scene.add(mesh);
    });
  }

  // Depth of what hides curves at a place on the screen, CSS px.
  hidingDepth(x, y, eye) {
    if (!this.mask.visible) return Infinity;
    const { width, height } = eye.size;
    const caster = new Raycaster();
    const place = new Vector2((2 * x) / width - 1, 1 - (2 * y) / height);
    caster.setFromCamera(place, eye.camera);
    const [hit] = caster.intersectObject(this.mask);
    const depth = hit && eye.screen(hit.point)?.depth;
    return depth === undefined ? Infinity : PICK_SLACK * depth + this.margin;
  }
}
