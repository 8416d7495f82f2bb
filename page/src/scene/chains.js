// Force chains: a rod a contact, from center to center, thicker and with more ink the larger its normal force.
import { CylinderGeometry, DynamicDrawUsage, InstancedBufferAttribute, InstancedBufferGeometry, Mesh, ShaderMaterial } from "three";
import { contactEnds } from "./data.js";

const vertexShader = /* glsl */ `
  in vec3 from; in vec3 to; in float thickness; in vec3 tint;
  out vec3 hit; out vec3 normalOut; flat out vec3 ink;
  void main() {
    vec3 along = normalize(to - from);
    vec3 side = normalize(cross(along, abs(along.z) < 0.9 ? vec3(0, 0, 1) : vec3(1, 0, 0)));
    vec3 other = cross(side, along); // right-handed, so that the outside stays outside
    vec3 away = position.x * side + position.z * other;
    vec3 x = mix(from, to, position.y + 0.5) + thickness * away;
    vec4 seen = modelViewMatrix * vec4(x, 1.0);
    hit = seen.xyz; ink = tint;
    normalOut = mat3(modelViewMatrix) * (normal.x * side + normal.z * other);
    gl_Position = projectionMatrix * seen;
  }`;

const fragmentShader = /* glsl */ `
  in vec3 hit; in vec3 normalOut; flat in vec3 ink;
  uniform vec4 clip; uniform vec3 paper; uniform vec4 depthRange;
  out vec4 color;
  void main() {
    if (dot(clip.xyz, hit) > clip.w) discard;
    float lit = max(0.0, dot(normalize(normalOut), normalize(vec3(-0.45, 0.6, 0.75))));
    float far = clamp((depthRange.y - hit.z) / (depthRange.y - depthRange.x), 0.0, 1.0);
    color = vec4(mix(ink * (0.5 + 0.6 * lit), paper, 0.35 * far), 1.0);
  }`;

// From weak to strong: more ink, whatever the paper.
const onWhite = [[176, 186, 198], [20, 33, 61]];
const onBlack = [[84, 94, 106], [255, 233, 176]];

export const strongest = 5; // times the mean force: where color and thickness end

export class Chains {
  constructor(capacity, shared) {
    const rod = new CylinderGeometry(1, 1, 1, 8, 1, true);
    this.geometry = new InstancedBufferGeometry();
    this.geometry.index = rod.index;
    this.geometry.setAttribute("position", rod.getAttribute("position"));
    this.geometry.setAttribute("normal", rod.getAttribute("normal"));
    const add = (name, array, size, normalized = false) => {
      const attribute = new InstancedBufferAttribute(array, size, normalized).setUsage(DynamicDrawUsage);
      this.geometry.setAttribute(name, attribute);
      return attribute;
    };
    this.from = add("from", new Float32Array(3 * capacity), 3);
    this.to = add("to", new Float32Array(3 * capacity), 3);
    this.thickness = add("thickness", new Float32Array(capacity), 1);
    this.tint = add("tint", new Uint8Array(3 * capacity), 3, true);
    const material = new ShaderMaterial({ glslVersion: "300 es", vertexShader, fragmentShader, uniforms: shared });
    this.mesh = new Mesh(this.geometry, material);
    this.mesh.frustumCulled = false;
  }

  /** Contacts whose force is at least `least` times the mean; `unit` is the thickness at the mean force [mm]. */
  set(state, least, unit, isDark) {
    const [weak, strong] = isDark ? onBlack : onWhite;
    let count = 0;
    for (let c = 0; c < state.force.length; ++c) {
      const relative = state.force[c] / state.meanForce;
      if (!(relative >= least)) continue;
      const { from, to } = contactEnds(state, c);
      this.from.array.set(from, 3 * count);
      this.to.array.set(to, 3 * count);
      this.thickness.array[count] = unit * Math.min(relative, strongest);
      const share = Math.min(relative / strongest, 1);
      this.tint.array.set(weak.map((w, k) => w + share * (strong[k] - w)), 3 * count);
      ++count;
    }
    for (const attribute of [this.from, this.to, this.thickness, this.tint]) attribute.needsUpdate = true;
    this.geometry.instanceCount = count;
    return count;
  }
}
