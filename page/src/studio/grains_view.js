// The grains of a run in 3D, from the pictures that its stages save: the newest one, or one that is chosen.
import { SceneView } from "../scene/view.js";
import { addKeys } from "../scene/index.js";
import { colorModes } from "../scene/colors.js";
import { escaped } from "./words.js";
import { get, runPath } from "./server.js";
import { readGrains, sceneOf } from "./vtp.js";

const interval = 4000; // [ms]

const nameOf = (file) => file.replace(/^studies\//, "").replace(/\.vtp$/, "");

export class GrainsView {
  /** @param place is filled with a part that opens on request */
  constructor(place, run) {
    this.run = run;
    this.place = place;
    this.isAtWork = true; // what has ended saves nothing more
    place.innerHTML = `<details><summary>Grains in 3D</summary><label class="in">State <select><option value="">the newest</option></select></label><p class="cap" role="status"></p><div class="picture" tabindex="0" role="img" aria-label="Grains in 3D; turned by the arrow keys, + and - zoom" hidden></div></details>`;
    this.details = place.querySelector("details");
    this.select = place.querySelector("select");
    this.details.addEventListener("toggle", () => this.follow());
    this.select.addEventListener("change", () => this.look());
  }

  close() {
    clearTimeout(this.timer);
    this.view?.renderer.dispose();
    this.view?.renderer.forceContextLoss(); // browsers keep only so many
    this.view = null;
    this.run = "";
  }

  async follow() {
    clearTimeout(this.timer);
    if (!this.details.open || !this.run || this.place.hidden) return;
    await this.look();
    if (this.isAtWork && this.run) this.timer = setTimeout(() => this.follow(), document.hidden ? 5 * interval : interval);
  }

  async look() {
    const { run } = this, turn = this.turn = {}, say = (text) => { this.place.querySelector("p").textContent = text; };
    try {
      const pictures = (await get(`${runPath(run)}/pictures`)).result;
      this.offer(pictures.map((picture) => picture.file));
      const wanted = pictures.find((picture) => picture.file === this.select.value) ?? pictures[0];
      if (!wanted) return say('No grains are saved yet. Stages save them at their end where formats under [output] has "vtp", and while they strain with snapshots = { every = "1 %" }.');
      const key = `${wanted.file} ${wanted.at}`;
      if (key === this.shown) return undefined;
      const response = await fetch(`/runs/${encodeURIComponent(run)}/${wanted.file.split("/").map(encodeURIComponent).join("/")}`);
      if (!response.ok) throw new Error("the picture is gone");
      const grains = readGrains(await response.arrayBuffer());
      if (run !== this.run || turn !== this.turn) return undefined; // another state was chosen meanwhile
      this.show(sceneOf(grains, nameOf(wanted.file)));
      this.shown = key;
      const fines = grains.fine.reduce((sum, one) => sum + one, 0);
      return say(`${nameOf(wanted.file)}: ${grains.id.length.toLocaleString("en")} grains${fines ? `, ${fines.toLocaleString("en")} of them fines, in red` : ""}.`);
    } catch (error) {
      return turn === this.turn && say(`No picture: ${error.message}`);
    }
  }

  offer(files) {
    const key = files.join();
    if (this.offered === key) return;
    this.offered = key;
    const chosen = this.select.value;
    this.select.innerHTML = `<option value="">the newest</option>${files.map((file) => `<option value="${escaped(file)}">${escaped(nameOf(file))}</option>`).join("")}`;
    this.select.value = files.includes(chosen) ? chosen : "";
  }

  /** Draws a scene, seen from where the reader has turned the one before. */
  show(scene) {
    const place = this.place.querySelector(".picture");
    place.hidden = false;
    if (this.view?.scene.id.length === scene.id.length) {
      Object.assign(this.view.scene, scene);
      this.view.modes = colorModes(this.view.scene);
      this.view.update();
      return;
    }
    const { camera } = this.view ?? {};
    this.view?.renderer.dispose();
    this.view?.renderer.forceContextLoss();
    place.replaceChildren();
    this.view = new SceneView(scene, place);
    this.view.choose({ cell: false });
    if (camera) {
      this.view.camera.position.copy(camera.position);
      this.view.zoom(camera.zoom);
    }
    if (!this.hasKeys) addKeys({ turn: (...angles) => this.view.turn(...angles), zoom: (factor) => this.view.zoom(factor), home: () => this.view.home(), choose: () => {}, pick: () => -1 }, place);
    this.hasKeys = true;
  }
}
