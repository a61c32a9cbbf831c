// SPDX-License-Identifier: GPL-3.0-or-later
// Cutting in the shader, in the model's own coordinates: layers that are pulled apart or exaggerated are cut alike.
import { Vector4 } from 'three';
import { kMostPlanes } from './cut.js';

const kBlockPlanes = 6;
const kMargin = 1e-6; // of the model's size; numbers on graphics cards have seven digits

const kVertexHead = /* glsl */ `
varying vec3 vModel;
#ifdef USE_LIFT
attribute float lift;
#endif
`;
const kVertexBody = /* glsl */ `
vModel = transformed;
#ifdef USE_LIFT
vModel.z -= lift;
#endif
`;
const kFragmentHead = /* glsl */ `
varying vec3 vModel;
uniform vec4 cutPlane[${kMostPlanes}];
uniform int cutCount;
uniform vec4 blockPlane[${kBlockPlanes}];
uniform int blockCount;
uniform float cutMargin;
bool isCutAway(vec3 p) {
  for (int i = 0; i < ${kMostPlanes}; ++i)
    if (i < cutCount && dot(cutPlane[i].xyz, p) + cutPlane[i].w < -cutMargin) return true;
  if (blockCount == 0) return false;
  for (int i = 0; i < ${kBlockPlanes}; ++i)
    if (i < blockCount && dot(blockPlane[i].xyz, p) + blockPlane[i].w < 0.0) return false;
  return true;
}
`;

/** The uniforms of one cut, shared by all materials that it cuts. While nothing is cut, they are compiled without it: cards then leave out
 *  what is hidden before they shade it. */
export class ClipUniforms {
  constructor() {
    this.materials = [];
    this.isCutting = false;
    const vectors = (n) => Array.from({ length: n }, () => new Vector4());
    this.uniforms = {
      cutPlane: { value: vectors(kMostPlanes) },
      cutCount: { value: 0 },
      blockPlane: { value: vectors(kBlockPlanes) },
      blockCount: { value: 0 },
      cutMargin: { value: 0 },
    };
  }

  /** What lies in a plane but for rounding is kept: walls along the outline, level ground. */
  setSize(size) {
    this.uniforms.cutMargin.value = kMargin * size;
  }

  /** Take over what cutOf gave. */
  set({ planes, block }) {
    const { cutPlane, cutCount, blockPlane, blockCount } = this.uniforms;
    planes.forEach(({ n, d }, i) => cutPlane.value[i].set(...n, d));
    (block ?? []).forEach(({ n, d }, i) => blockPlane.value[i].set(...n, d));
    cutCount.value = planes.length;
    blockCount.value = block ? block.length : 0;
    const isCutting = planes.length > 0 || block !== null;
    if (isCutting === this.isCutting) return;
    this.isCutting = isCutting;
    for (const material of this.materials) material.needsUpdate = true;
  }

  /** Make a material leave out what is cut away. `lifted`: vertices have an attribute that says how far they are. */
  applyTo(material, lifted = false) {
    this.materials.push(material);
    material.onBeforeCompile = (shader) => {
      // Always: three.js keeps the uniforms of what it compiled last, also for programs that it has from before.
      Object.assign(shader.uniforms, this.uniforms);
      if (!this.isCutting) return;
      const define = lifted ? '#define USE_LIFT\n' : '';
      shader.vertexShader = shader.vertexShader
        .replace('#include <common>', `#include <common>\n${define}${kVertexHead}`)
        .replace('#include <begin_vertex>', `#include <begin_vertex>\n${kVertexBody}`);
      shader.fragmentShader = shader.fragmentShader
        .replace('#include <common>', `#include <common>\n${kFragmentHead}`)
        .replace(/void main\(\) {/, 'void main() {\n  if (isCutAway(vModel)) discard;');
    };
    material.customProgramCacheKey = () => (!this.isCutting ? 'whole' : lifted ? 'cut-lifted' : 'cut');
    return material;
  }
}
