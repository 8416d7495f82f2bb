// The tab Simulate: a case made from the soil or from an example, its text, its price, and its run.
import { $, escaped, list, secondsRange, trouble } from "./words.js";
import { get, post } from "./server.js";
import { CaseEditor } from "./case_editor.js";
import { RunView } from "./run_view.js";
import { calibrationLimits, connectCalibration } from "./calibrate_form.js";
import { calibrates } from "./calibrate_text.js";
import { connectTests, offerTests } from "./test_form.js";
import { conditionFields, curveFields, showSizes, soil } from "./soil.js";

/** What is known of an example beyond its name. */
export const titles = {
  "fontainebleau-2016": "erosion of Fontainebleau sand", "critical-gradient": "the gradient that moves the fines", replay: "a small packing, seconds",
  laboratory: "laboratory tests", "silty-sand-2016": "strength over the fines content", "million-grains": "a million grains, hours",
};
let view, editor;

const plannedSamples = (plan) => `<p class="cap">First round: ${plan.first.studies} samples, ${secondsRange(plan.first.seconds)}. All rounds: at most ${plan.samples} samples, and those of the tests held out.</p>`;

const planned = (plan) => plan.first ? plannedSamples(plan) : `<table><thead><tr><th>stage</th><th class="n">grains</th><th class="n">time</th></tr></thead><tbody>${plan.stages.map((s) =>
  `<tr><td>${escaped(`${s.study}/${s.stage}`)}<small>${escaped(s.verb)}</small></td><td class="n">${s.grains.toLocaleString("en")}</td><td class="n">${s.cached ? "in the cache" : secondsRange(s.seconds)}</td></tr>`).join("")}</tbody></table><ul class="cap">${list(plan.warnings ?? [])}</ul>`;

/** The case as it is now, which a sweep can start from. */
export const caseNow = () => ({ text: editor.text, files: editor.files, name: $("name").value });

/** @param overwrites a text that came while the case was on its way */
async function make(overwrites) {
  const example = $("from").value, way = $("way").value;
  $("make").disabled = true;
  try {
    if (!example && !soil.curve) throw new Error("Give a soil in the first tab, or start from an example.");
    const sizes = way === "part" && $("size-from").value && $("size-to").value;
    const { result, talk } = await post("/api/new", example ? { from: example } : {
      ...curveFields(), ...conditionFields(), surrogate: way === "surrogate" ? "yes" : "",
      sizes: sizes ? `${$("size-from").value}mm,${$("size-to").value}mm` : "",
      particles: $("particles").value, pressure: $("pressure").value ? `${$("pressure").value}kPa` : "",
    });
    if (!overwrites && editor.text) return;
    trouble();
    $("made").innerHTML = list(talk.filter((line) => !line.startsWith("next:")));
    editor.take(result.case, result.files, example || soil.curve.name.replace(/\.[^.]*$/, ""));
  } catch (error) {
    trouble(error);
    const isWhole = !example && soil.curve && way === "";
    $("made").innerHTML = isWhole ? list(["A soil that is too wide to simulate whole can be modeled in part, or by a surrogate: choose under Model it."]) : "";
  } finally {
    $("make").disabled = false;
  }
}

async function start() {
  const run = await editor.start("runs", calibrates(editor.text) ? calibrationLimits() : {});
  if (!run) return;
  await view.show(run);
  $("live").scrollIntoView({ block: "start" });
}

const showConditions = () => {
  const { gradient, flow } = conditionFields();
  $("conditions").textContent = soil.curve
    ? `${soil.curve.name}${soil.curve.isEdited ? " (edited)" : ""}; ${gradient ? `i = ${gradient}, flow ${flow}` : "no gradient given"}. Change these in the tab Soil.` : "No soil is given yet.";
};

const showWay = () => {
  $("own").hidden = $("from").value !== "";
  $("sizes-row").hidden = $("way").value !== "part";
  const sizes = $("way").value === "part" && $("size-from").value && $("size-to").value;
  showSizes(sizes ? [Number($("size-from").value) / 1e3, Number($("size-to").value) / 1e3] : null);
};

/** When the tab is opened: with the first soil, its case is written at once. */
export function openSimulate() {
  showConditions();
  if (soil.curve && !$("case").value && !$("from").value) make(false);
}

export function connectSimulate() {
  view = new RunView($("live"));
  editor = new CaseEditor("", planned, offerTests);
  connectTests(editor);
  connectCalibration(editor);
  get("/api/examples").then(({ result }) => {
    $("from").innerHTML += result.map((name) => `<option value="${escaped(name)}">${escaped(name)}${titles[name] ? `: ${titles[name]}` : ""}</option>`).join("");
  }, trouble);
  for (const id of ["from", "way", "size-from", "size-to"]) $(id).addEventListener("input", showWay);
  $("make").addEventListener("click", () => make(true));
  $("start").addEventListener("click", start);
}
