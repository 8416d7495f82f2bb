// Everything around the picture: controls, legend, notes, the card. Each control is a plain form element, so that the
// keyboard and screen readers know it.
import { save } from "../downloads.js";
import { showCard } from "./card.js";
import { scaleGradient } from "./colors.js";
import { strongest } from "./chains.js";

let ids = 0;

function make(tag, properties = {}, ...children) {
  const node = Object.assign(document.createElement(tag), properties);
  node.append(...children);
  return node;
}

function labeled(text, control, ...more) {
  control.id = `scene-${++ids}`;
  return make("div", { className: "control" }, make("label", { htmlFor: control.id, textContent: text }), control, ...more);
}

function slider(text, { min, max, step, value, say }, changed) {
  const input = make("input", { type: "range", min, max, step, value });
  const output = make("output");
  const show = () => {
    output.textContent = say(Number(input.value));
    input.setAttribute("aria-valuetext", output.textContent);
  };
  input.addEventListener("input", () => {
    show();
    changed(Number(input.value));
  });
  const node = labeled(text, input, output);
  show();
  return { node, input, show };
}

function checkbox(text, checked, changed) {
  const input = make("input", { type: "checkbox", checked });
  input.addEventListener("change", () => changed(input.checked));
  return { node: make("label", { className: "check" }, input, ` ${text}`), input };
}

function select(text, options, changed) {
  const input = make("select", {}, ...options.map(([value, name]) => make("option", { value, textContent: name })));
  input.addEventListener("change", () => changed(input.value));
  return labeled(text, input);
}

function group(title, ...nodes) {
  return make("fieldset", {}, make("legend", { textContent: title }), ...nodes);
}

function showLegend(place, { swatches = [], range, unit }) {
  place.replaceChildren();
  if (range) {
    const bar = make("div", { className: "scale-bar" });
    bar.style.background = scaleGradient;
    place.append(bar, make("div", { className: "scale-ends" }, ...range.map((value) => make("span", { textContent: value }))), make("div", { className: "quiet", textContent: unit }));
  }
  for (const { name, count, color } of swatches) {
    const swatch = make("i");
    swatch.style.background = color;
    place.append(make("div", { className: "swatch" }, swatch, `${name}: ${count.toLocaleString("en")}`));
  }
}

const stepTime = 600; // [ms] a state, long enough to see what moved

/** A button that shows one state after the other, from the first again where it is pressed at the last. */
function playButton(view, last) {
  const node = make("button", { type: "button" });
  let timer = null;
  const show = () => {
    node.textContent = timer === null ? "Play" : "Pause";
    node.setAttribute("aria-label", timer === null ? "Play the states up to the last" : "Pause");
  };
  const pause = () => {
    clearTimeout(timer);
    timer = null;
    show();
  };
  const step = () => {
    view.choose({ state: view.choice.state + 1 });
    if (view.choice.state >= last) pause();
    else timer = setTimeout(step, stepTime);
  };
  node.dataset.control = "play";
  node.addEventListener("click", () => {
    if (timer !== null) return pause();
    if (view.choice.state === last) view.choose({ state: 0 });
    timer = setTimeout(step, stepTime);
    show();
  });
  show();
  return { node, pause };
}

/** Builds the controls of `view` into `place`; `run` names the files that are saved. */
export function addPanel(view, place, stage, run) {
  const { scene } = view;
  const legend = make("div", { className: "legend" });
  const note = make("p", { className: "quiet" });
  note.setAttribute("role", "status");
  const card = make("div", { className: "card" });
  card.setAttribute("aria-live", "polite");
  const chooseGrain = (row) => view.choose({ chosen: row });

  const nodes = [];
  let showState = () => {};
  if (scene.states.length > 1) {
    const last = scene.states.length - 1;
    const states = slider("State", { min: 0, max: last, step: 1, value: 0, say: (k) => scene.states[k].label }, (state) => {
      play?.pause();
      view.choose({ state });
    });
    const play = scene.isMigration ? playButton(view, last) : null;
    if (play) states.node.append(play.node);
    showState = () => {
      states.input.value = view.choice.state;
      states.show();
    };
    states.input.dataset.control = "state";
    nodes.push(group("When", states.node));
  }
  const modes = select("Color by", Object.entries(view.modes).map(([key, { label }]) => [key, label]), (mode) => view.choose({ mode }));
  modes.querySelector("select").dataset.control = "mode";

  const size = slider("Grain size", { min: 10, max: 100, step: 5, value: 100, say: (v) => `${v} %` }, (v) => view.choose({ size: v / 100 }));
  const least = slider("Forces above", { min: 0, max: strongest, step: 0.25, value: 1, say: (v) => `${v} × mean` }, (v) => view.choose({ least: v }));
  // Whole grains would hide what is between them.
  const showBetween = (change) => {
    const { chains: hasChains, paths: hasPaths } = { ...view.choice, ...change };
    const [from, to] = hasChains || hasPaths ? [100, 30] : [30, 100];
    if (Number(size.input.value) === from) {
      size.input.value = to;
      size.show();
    }
    view.choose({ ...change, size: Number(size.input.value) / 100 });
  };
  const chains = checkbox("force chains", false, (on) => {
    least.node.hidden = !on;
    showBetween({ chains: on });
  });
  chains.input.dataset.control = "chains";
  const paths = checkbox("paths", false, (on) => showBetween({ paths: on }));
  paths.input.dataset.control = "paths";
  least.node.hidden = true;
  const coarse = checkbox("coarse", true, (on) => view.choose({ coarse: on }));
  const fines = checkbox("fines", true, (on) => view.choose({ fines: on }));
  fines.input.dataset.control = "fines";
  const cell = checkbox("cell", true, (on) => view.choose({ cell: on }));
  nodes.push(
    group("Grains", modes, legend),
    group("Show", make("div", { className: "checks" }, coarse.node, fines.node, chains.node, ...(scene.isMigration ? [paths.node] : []), cell.node), size.node, least.node),
  );

  const at = slider("Position", { min: 0, max: 100, step: 1, value: 50, say: (v) => `${v} %` }, (v) => view.choose({ at: v / 100 }));
  const flip = checkbox("keep the other side", false, (on) => view.choose({ flip: on }));
  const cut = select("Plane across", [["none", "none"], ["x", "x"], ["y", "y"], ["z", "z"]], (axis) => {
    at.node.hidden = flip.node.hidden = axis === "none";
    flip.input.checked = view.facesAway(axis);
    view.choose({ cut: axis, flip: flip.input.checked });
  });
  cut.querySelector("select").dataset.control = "cut";
  at.node.hidden = flip.node.hidden = true;
  nodes.push(group("Cut", cut, at.node, flip.node));

  const wanted = make("input", { type: "number", min: 0, step: 1, inputMode: "numeric" });
  wanted.dataset.control = "grain";
  wanted.addEventListener("change", () => {
    const row = scene.rowOf.get(Number(wanted.value));
    if (wanted.value !== "" && row === undefined) {
      note.textContent = `There is no grain ${wanted.value}.`;
    } else {
      chooseGrain(wanted.value === "" ? -1 : row);
    }
  });
  nodes.push(group("One grain", labeled("Number", wanted), card));

  const buttons = make("div", { className: "tools" });
  const button = (text, label, act) => {
    const node = make("button", { type: "button", textContent: text });
    node.setAttribute("aria-label", label);
    node.addEventListener("click", act);
    buttons.append(node);
  };
  button("Reset view", "Reset the view", () => view.home());
  button("PNG", "Save the view as PNG", async () => {
    const canvas = await view.picture();
    canvas.toBlob((blob) => save(`${run}-grains.png`, blob), "image/png");
  });
  place.replaceChildren(...nodes, buttons);

  view.onupdate = () => {
    showLegend(legend, view.legend);
    const words = [];
    if (view.leftOut > 0) {
      const what = view.leavesOutCoarse ? "even shares of the coarse grains and of the fines" : "an even share of the fines";
      words.push(`Drawn by software: ${view.rows.length.toLocaleString("en")} of ${(view.rows.length + view.leftOut).toLocaleString("en")} grains are shown, ${what} left out.`);
    }
    if (view.choice.chains) {
      words.push(`${view.chainsShown.toLocaleString("en")} of ${view.state.force.length.toLocaleString("en")} contacts${scene.isMigration ? " of free fines" : ""} shown; thickness and ink grow with the normal force up to ${strongest} times its mean.`);
    }
    if (view.choice.paths) {
      const whose = view.choice.chosen < 0 ? "of fines that moved more than half their diameter" : "of the chosen grain";
      words.push(`${view.pathsShown.toLocaleString("en")} ${view.pathsShown === 1 ? "path" : "paths"} shown, ${whose}.`);
    }
    note.textContent = words.join(" ");
    showState();
    modes.querySelector("select").value = view.choice.mode;
    wanted.value = view.choice.chosen < 0 ? "" : scene.id[view.choice.chosen];
    showCard(card, scene, view.state, view.choice.chosen, chooseGrain);
  };
  stage.append(note);
  view.onupdate();
}
