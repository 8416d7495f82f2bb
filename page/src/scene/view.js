// The picture: grains, force chains, paths and the outline of the cell in one state, seen from where the reader turns it.
// Drawn on demand only: a page that nobody touches costs nothing.
import { BufferAttribute, BufferGeometry, Color, Float32BufferAttribute, LineBasicMaterial, LineSegments, OrthographicCamera, Plane, SRGBColorSpace, Scene, Vector3, WebGLRenderer } from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import { Chains } from "./chains.js";
import { colorModes } from "./colors.js";
import { point } from "./data.js";
import { Overlay } from "./overlay.js";
import { pathsShown } from "./paths.js";
import { grainAt } from "./pick.js";
import { Spheres, sharedUniforms } from "./spheres.js";
import { isSoftware, softwareLimit, thinned } from "./thin.js";

const start = new Vector3(1, -1.6, 0.9).normalize(); // from above a corner, z upward: as the still pictures

function rendererName(gl) {
  const info = gl.getExtension("WEBGL_debug_renderer_info");
  return String(info ? gl.getParameter(info.UNMASKED_RENDERER_WEBGL) : gl.getParameter(gl.RENDERER));
}

export class SceneView {
  /** @throws Error where the browser has no WebGL 2. */
  constructor(scene, place) {
    this.scene = scene;
    this.place = place;
    this.modes = colorModes(scene);
    this.choice = { state: 0, mode: "class", coarse: true, fines: true, chains: false, least: 1, paths: false, cell: true, size: 1, cut: "none", at: 0.5, flip: false, chosen: -1 };
    const canvas = document.createElement("canvas");
    const context = canvas.getContext("webgl2", { antialias: true, alpha: false });
    if (!context) throw new Error("the browser has no WebGL 2");
    this.renderer = new WebGLRenderer({ canvas, context });
    this.software = isSoftware(rendererName(context));
    this.limit = this.software ? softwareLimit : Infinity;
    this.renderer.setPixelRatio(this.software ? 1 : Math.min(2, Math.max(devicePixelRatio, 1.5)));
    this.canvas = canvas;
    this.overlay = new Overlay(scene);
    place.append(canvas, this.overlay.node);

    const shared = sharedUniforms();
    this.uniforms = shared;
    this.spheres = new Spheres(Math.min(this.limit, scene.id.length), shared);
    this.chains = new Chains(Math.max(1, ...scene.states.map((state) => state.force.length)), shared);
    this.outline = new LineSegments(new BufferGeometry(), new LineBasicMaterial({ transparent: true, opacity: 0.9 }));
    this.outline.frustumCulled = false;
    this.world = new Scene();
    this.cutPlane = new Plane();
    this.renderer.localClippingEnabled = true;
    this.paths = new LineSegments(new BufferGeometry(), new LineBasicMaterial({ vertexColors: true, clippingPlanes: [this.cutPlane] }));
    this.paths.frustumCulled = false;
    this.world.add(this.spheres.mesh, this.chains.mesh, this.outline, this.paths);

    const corners = scene.states.flatMap(({ cell }) => [0, 1].flatMap((a) => [0, 1].flatMap((b) => [0, 1].map((c) => point(cell, a, b, c)))));
    this.center = new Vector3(...point(scene.states[0].cell, 0.5, 0.5, 0.5));
    const widest = scene.radius.reduce((most, r) => Math.max(most, r), 0);
    this.reach = Math.max(...corners.map((corner) => this.center.distanceTo(new Vector3(...corner)))) + widest;
    this.low = [0, 1, 2].map((k) => Math.min(...corners.map((corner) => corner[k])) - widest);
    this.high = [0, 1, 2].map((k) => Math.max(...corners.map((corner) => corner[k])) + widest);
    this.camera = new OrthographicCamera(-1, 1, 1, -1, 0.01, 8 * this.reach);
    this.camera.up.set(0, 0, 1);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.enableDamping = false;
    this.controls.minZoom = 0.4;
    this.controls.maxZoom = 40;
    this.controls.addEventListener("change", () => this.request());
    canvas.addEventListener("webglcontextrestored", () => this.update());
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => this.update());
    new ResizeObserver(() => this.resize()).observe(place);
    this.home();
    this.resize();
    this.update();
  }

  get state() {
    return this.scene.states[this.choice.state];
  }

  home() {
    this.controls.target.copy(this.center);
    this.camera.position.copy(this.center).addScaledVector(start, 4 * this.reach);
    this.camera.zoom = 1;
    this.camera.updateProjectionMatrix();
    this.controls.update();
    this.request();
  }

  /** Turns the sample by angles around the vertical and toward the eye [rad]. */
  turn(around, over) {
    const from = this.camera.position.clone().sub(this.controls.target);
    const distance = from.length();
    const polar = Math.min(Math.max(Math.acos(from.z / distance) + over, 0.02), Math.PI - 0.02);
    const azimuth = Math.atan2(from.y, from.x) + around;
    from.set(Math.sin(polar) * Math.cos(azimuth), Math.sin(polar) * Math.sin(azimuth), Math.cos(polar)).multiplyScalar(distance);
    this.camera.position.copy(this.controls.target).add(from);
    this.controls.update();
    this.request();
  }

  zoom(factor) {
    this.camera.zoom = Math.min(Math.max(this.camera.zoom * factor, this.controls.minZoom), this.controls.maxZoom);
    this.camera.updateProjectionMatrix();
    this.request();
  }

  resize() {
    const { clientWidth: width, clientHeight: height } = this.place;
    if (width === 0 || height === 0) return;
    this.renderer.setSize(width, height, false);
    // The largest sphere around the sample fits, whichever way it is turned; a little of its corners may not matter.
    const half = 0.86 * this.reach / Math.min(1, width / height);
    Object.assign(this.camera, { top: half, bottom: -half, left: (-half * width) / height, right: (half * width) / height });
    this.camera.updateProjectionMatrix();
    this.request();
  }

  /** Changes what is shown. */
  choose(change) {
    Object.assign(this.choice, change);
    this.update();
  }

  rowsShown() {
    const { coarse, fines } = this.choice;
    const rows = [];
    for (let row = 0; row < this.scene.id.length; ++row) {
      if (this.state.present[row] && (this.scene.fine[row] ? fines : coarse)) rows.push(row);
    }
    return rows;
  }

  update() {
    const { choice, state, scene } = this;
    const shown = this.rowsShown();
    this.rows = thinned(shown, scene.fine, this.limit);
    this.leftOut = shown.length - this.rows.length;
    const coarseOf = (some) => some.reduce((sum, row) => sum + !scene.fine[row], 0);
    this.leavesOutCoarse = coarseOf(this.rows) < coarseOf(shown);
    const mode = this.modes[choice.mode];
    this.legend = mode.legend(state, shown);
    this.spheres.set(this.rows, state, scene.radius, (row) => mode.color(state, row), choice.chosen);
    this.spheres.uniforms.size.value = choice.size;
    this.chains.mesh.visible = choice.chains;
    const typical = scene.radius.reduce((sum, r) => sum + r, 0) / Math.max(1, scene.radius.length);
    const style = getComputedStyle(this.place);
    const paper = style.backgroundColor.match(/\d+/g).slice(0, 3).map((c) => c / 255);
    this.uniforms.paper.value.set(...paper);
    this.chainsShown = choice.chains ? this.chains.set(state, choice.least, 0.09 * typical, paper[1] < 0.5) : 0;
    this.drawPaths(mode);
    const edges = [];
    for (let corner = 0; corner < 8; ++corner) {
      for (let a = 0; a < 3; ++a) {
        if (corner & (1 << a)) continue;
        for (const end of [corner, corner | (1 << a)]) edges.push(...point(state.cell, end & 1, (end >> 1) & 1, end >> 2));
      }
    }
    this.outline.geometry.setAttribute("position", new Float32BufferAttribute(edges, 3));
    this.outline.visible = choice.cell;
    this.outline.material.color.setStyle(style.color);
    this.request();
    this.onupdate?.();
  }

  /** Lines along the ways of the grains up to the state shown, in the colors of the grains. */
  drawPaths(mode) {
    const { choice, state, scene } = this;
    const shown = choice.paths ? pathsShown(scene, choice.state, choice.chosen) : [];
    this.pathsShown = shown.length;
    const size = shown.reduce((sum, { ends }) => sum + ends.length, 0);
    const [places, tints] = [new Float32Array(size), new Float32Array(size)];
    const tint = new Color();
    let at = 0;
    for (const { row, ends } of shown) {
      places.set(ends, at);
      tint.setRGB(...mode.color(state, row).map((c) => c / 255), SRGBColorSpace);
      for (const stop = at + ends.length; at < stop; at += 3) tint.toArray(tints, at);
    }
    this.paths.geometry.dispose(); // what the graphics card holds of the lines before
    this.paths.geometry.setAttribute("position", new BufferAttribute(places, 3));
    this.paths.geometry.setAttribute("color", new BufferAttribute(tints, 3));
    this.paths.visible = size > 0;
  }

  request() {
    if (this.waiting) return;
    this.waiting = true;
    requestAnimationFrame(() => {
      this.waiting = false;
      this.draw();
    });
  }

  /** The cutting plane in the camera's space: kept where plane[0..2] . point <= plane[3]. */
  plane() {
    const { cut, at, flip } = this.choice;
    const axis = "xyz".indexOf(cut);
    if (axis < 0) return [0, 0, 1, 1e9];
    const sign = flip ? -1 : 1;
    const m = this.camera.matrixWorldInverse.elements;
    const normal = [0, 1, 2].map((k) => sign * m[4 * axis + k]);
    const place = sign * (this.low[axis] + at * (this.high[axis] - this.low[axis]));
    return [...normal, place + normal[0] * m[12] + normal[1] * m[13] + normal[2] * m[14]];
  }

  /** Whether cutting across an axis must keep its far end, so that the cut faces the eye. */
  facesAway(axis) {
    const k = "xyz".indexOf(axis);
    return k >= 0 && this.camera.position.getComponent(k) < this.controls.target.getComponent(k);
  }

  draw() {
    this.camera.updateMatrixWorld();
    this.renderer.setClearColor(new Color().setRGB(...this.uniforms.paper.value, SRGBColorSpace), 1);
    const [a, b, c, most] = this.plane();
    this.uniforms.clip.value.set(a, b, c, most);
    this.cutPlane.setComponents(-a, -b, -c, most).applyMatrix4(this.camera.matrixWorld);
    const middle = this.center.clone().applyMatrix4(this.camera.matrixWorldInverse).z;
    this.uniforms.depthRange.value.set(middle - this.reach, middle + this.reach, 0, 0);
    this.renderer.render(this.world, this.camera);
    const m = this.camera.matrixWorld.elements;
    const { clientWidth: width, clientHeight: height } = this.place;
    const perMillimeter = (this.camera.zoom * height) / (this.camera.top - this.camera.bottom);
    this.overlay.draw(width, height, m.slice(0, 3), m.slice(4, 7), perMillimeter, this.state.gradient ?? this.scene.gradient);
    const chosen = this.choice.chosen;
    if (chosen >= 0 && this.state.present[chosen]) {
      this.overlay.ring(this.seenAt(chosen), perMillimeter * this.scene.radius[chosen] * this.choice.size);
    }
    this.place.dataset.frames = Number(this.place.dataset.frames ?? 0) + 1;
  }

  /** Row of the grain seen at a point of the canvas [CSS pixels], or -1. */
  pick(px, py) {
    const { clientWidth: width, clientHeight: height } = this.place;
    const x = (this.camera.right * (2 * px - width)) / width / this.camera.zoom;
    const y = (this.camera.top * (height - 2 * py)) / height / this.camera.zoom;
    this.camera.updateMatrixWorld();
    return grainAt(x, y, this.rows, this.state.position, this.scene.radius, this.choice.size, this.camera.matrixWorldInverse.elements, this.plane());
  }

  /** Where the middle of a grain is seen [CSS pixels]. */
  seenAt(row) {
    const [x, y, z] = this.state.position.subarray(3 * row, 3 * row + 3);
    const seen = new Vector3(x, y, z).project(this.camera);
    return { x: ((seen.x + 1) / 2) * this.place.clientWidth, y: ((1 - seen.y) / 2) * this.place.clientHeight };
  }

  /** The picture as it goes to a manuscript: on white, twice as sharp, with axes and scale. */
  async picture() {
    const { clientWidth: width, clientHeight: height } = this.place;
    const factor = 2;
    const before = this.renderer.getPixelRatio();
    const paper = this.uniforms.paper.value.clone();
    this.uniforms.paper.value.set(1, 1, 1);
    this.renderer.setPixelRatio(factor);
    this.renderer.setSize(width, height, false);
    this.outline.material.color.set("#444444");
    this.draw();
    const canvas = document.createElement("canvas");
    [canvas.width, canvas.height] = [width * factor, height * factor];
    const paint = canvas.getContext("2d");
    paint.drawImage(this.canvas, 0, 0, canvas.width, canvas.height);
    const marks = this.overlay.node.cloneNode(true);
    marks.setAttribute("width", width);
    marks.setAttribute("height", height);
    const look = document.createElementNS("http://www.w3.org/2000/svg", "style");
    look.textContent = "text{font:13px Helvetica,Arial,sans-serif;fill:#222}line,path{stroke:#222;stroke-width:1.5;fill:none}polygon{fill:#222}circle{fill:none;stroke:#222;stroke-width:2}";
    marks.prepend(look);
    const image = new Image();
    image.src = "data:image/svg+xml," + encodeURIComponent(new XMLSerializer().serializeToString(marks));
    await image.decode();
    paint.drawImage(image, 0, 0, canvas.width, canvas.height);
    this.renderer.setPixelRatio(before);
    this.uniforms.paper.value.copy(paper);
    this.resize();
    this.update();
    return canvas;
  }
}
