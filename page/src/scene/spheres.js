// Grains as impostors: a square a grain, on which each pixel finds its own point of the sphere. Parallel projection, so
// that this is exact. What lies beyond the cutting plane is left away; a grain that the plane cuts shows its flat face.
import { DynamicDrawUsage, InstancedBufferAttribute, InstancedBufferGeometry, Mesh, PlaneGeometry, ShaderMaterial, Vector3, Vector4 } from "three";

/** Uniforms that all parts of the view share. */
export const sharedUniforms = () => ({
  clip: { value: new Vector4(0, 0, 1, 1e9) }, // in the camera's space: kept where dot(xyz, point) <= w
  paper: { value: new Vector3(1, 1, 1) },
  depthRange: { value: new Vector4(-1, 1, 0, 0) }, // nearest and farthest of the cell, in the camera's space
});

const vertexShader = /* glsl */ `
  in vec3 center; in float radius; in vec3 tint; in float chosen;
  uniform float size;
  out vec3 middle; out vec2 at; flat out float r; flat out vec3 ink; flat out float isChosen;
  void main() {
    middle = (modelViewMatrix * vec4(center, 1.0)).xyz;
    r = radius * (chosen > 0.5 ? max(size, 0.6) : size);
    at = middle.xy + 1.1 * r * position.xy;
    ink = tint; isChosen = chosen;
    gl_Position = projectionMatrix * vec4(at, middle.z, 1.0);
  }`;

const fragmentShader = /* glsl */ `
  in vec3 middle; in vec2 at; flat in float r; flat in vec3 ink; flat in float isChosen;
  uniform vec4 clip; uniform vec3 paper; uniform vec4 depthRange; uniform mat4 projectionMatrix;
  out vec4 color;
  void main() {
    vec2 d = (at - middle.xy) / r;
    float across = length(d), soft = fwidth(across);
    float cover = 1.0 - smoothstep(1.0 - soft, 1.0 + soft, across);
    if (cover <= 0.0) discard;
    float z = sqrt(max(0.0, 1.0 - across * across));
    vec3 hit = vec3(at, middle.z + r * z);
    vec3 normal = vec3(d, z);
    float flatness = 0.0;
    if (dot(clip.xyz, hit) > clip.w) {
      if (clip.z < 1e-4) discard;
      hit.z = (clip.w - dot(clip.xy, at)) / clip.z;
      if (abs(hit.z - middle.z) > r * z) discard;
      normal = clip.xyz;
      flatness = 1.0;
    }
    float lit = max(0.0, dot(normal, normalize(vec3(-0.45, 0.6, 0.75))));
    float rim = mix(clamp(z / 0.4, 0.45, 1.0), across > 0.93 ? 0.55 : 1.0, flatness);
    vec3 shade = ink * (0.36 + 0.68 * lit) * rim + (1.0 - flatness) * 0.16 * pow(lit, 14.0);
    shade = mix(shade, ink * rim * 0.92, flatness * 0.7);
    if (isChosen > 0.5 && across > 0.72) shade = across > 0.86 ? vec3(0.0) : vec3(1.0);
    float far = clamp((depthRange.y - hit.z) / (depthRange.y - depthRange.x), 0.0, 1.0);
    color = vec4(mix(shade, paper, 0.28 * far), cover);
    gl_FragDepth = 0.5 + 0.5 * (projectionMatrix[2][2] * hit.z + projectionMatrix[3][2]);
  }`;

export class Spheres {
  constructor(capacity, shared) {
    const square = new PlaneGeometry(2, 2);
    this.geometry = new InstancedBufferGeometry();
    this.geometry.index = square.index;
    this.geometry.setAttribute("position", square.getAttribute("position"));
    const add = (name, array, size, normalized = false) => {
      const attribute = new InstancedBufferAttribute(array, size, normalized).setUsage(DynamicDrawUsage);
      this.geometry.setAttribute(name, attribute);
      return attribute;
    };
    this.center = add("center", new Float32Array(3 * capacity), 3);
    this.radius = add("radius", new Float32Array(capacity), 1);
    this.tint = add("tint", new Uint8Array(3 * capacity), 3, true);
    this.chosen = add("chosen", new Float32Array(capacity), 1);
    this.uniforms = { ...shared, size: { value: 1 } };
    const material = new ShaderMaterial({ glslVersion: "300 es", vertexShader, fragmentShader, uniforms: this.uniforms, alphaToCoverage: true });
    this.mesh = new Mesh(this.geometry, material);
    this.mesh.frustumCulled = false;
  }

  /** Draws the grains `rows` of a state; `colorOf(row)` is red, green, blue up to 255. */
  set(rows, state, radius, colorOf, chosenRow) {
    rows.forEach((row, k) => {
      for (let a = 0; a < 3; ++a) this.center.array[3 * k + a] = state.position[3 * row + a];
      this.radius.array[k] = radius[row];
      const color = colorOf(row);
      for (let a = 0; a < 3; ++a) this.tint.array[3 * k + a] = color[a];
      this.chosen.array[k] = row === chosenRow ? 1 : 0;
    });
    for (const attribute of [this.center, this.radius, this.tint, this.chosen]) attribute.needsUpdate = true;
    this.geometry.instanceCount = rows.length;
  }
}
