// The section "In 3D": the view where the browser can, a sentence where it cannot; the still pictures stay for print.
import { readScene } from "./data.js";
import { addPanel } from "./panel.js";
import { SceneView } from "./view.js";

const turnStep = 0.12; // [rad] a key

/** Keys for a view, on the element `picture` that has the focus. */
export function addKeys(view, picture) {
  const keys = {
    ArrowLeft: () => view.turn(-turnStep, 0),
    ArrowRight: () => view.turn(turnStep, 0),
    ArrowUp: () => view.turn(0, -turnStep),
    ArrowDown: () => view.turn(0, turnStep),
    "+": () => view.zoom(1.15),
    "=": () => view.zoom(1.15),
    "-": () => view.zoom(1 / 1.15),
    Home: () => view.home(),
    Enter: () => view.choose({ chosen: view.pick(picture.clientWidth / 2, picture.clientHeight / 2) }),
    Escape: () => view.choose({ chosen: -1 }),
  };
  picture.addEventListener("keydown", (event) => {
    if (!keys[event.key] || event.ctrlKey || event.altKey || event.metaKey) return;
    event.preventDefault();
    keys[event.key]();
  });
}

/** A click that did not turn into a drag chooses the grain below it. */
function addClicks(view, canvas) {
  let down = null;
  canvas.addEventListener("pointerdown", (event) => (down = [event.clientX, event.clientY]));
  canvas.addEventListener("pointerup", (event) => {
    if (!down || Math.hypot(event.clientX - down[0], event.clientY - down[1]) > 4) return;
    const box = canvas.getBoundingClientRect();
    view.choose({ chosen: view.pick(event.clientX - box.left, event.clientY - box.top) });
  });
}

export function showScene(run, data) {
  const place = document.querySelector("[data-scene]");
  if (!data || !place) return;
  const stage = place.querySelector(".stage");
  place.hidden = false;
  try {
    const view = new SceneView(readScene(data), stage.querySelector(".picture"));
    place.view = view; // for tests that ask the page for its numbers, and for the curious in the console
    addPanel(view, place.querySelector(".panel"), stage, run);
    addKeys(view, stage.querySelector(".picture"));
    addClicks(view, view.canvas);
    place.parentElement.classList.add("has-view");
  } catch (error) {
    place.hidden = true;
    const sentence = place.parentElement.querySelector("[data-no-view]");
    sentence.hidden = false;
    sentence.querySelector("span").textContent = error.message;
  }
}
