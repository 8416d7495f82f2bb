// The tab Simulate: a case made from the soil or from an example, its text, its price, and its run.
import { $, escaped, list, numberIn, secondsRange, trouble } from "./words.js";
import { get, post } from "./server.js";
import { CaseEditor } from "./case_editor.js";
import { RunView } from "./run_view.js";
import { calibrationLimits, connectCalibration } from "./calibrate_form.js";
import { calibrates } from "./calibrate_text.js";
import { filesByName } from "./case_text.js";
import { connectTests, offerTests } from "./test_form.js";
import { showSizes } from "./soil.js";
import { conditionFields, curveFields, filterFields, soil, withUnit } from "./soil_form.js";

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

/** What the form requests as a case. @throws for a field that is wrong or missing */
function wantedFields() {
  const example = $("from").value, way = $("way").value;
  if (example) return { from: example };
  if (!soil.curve) throw new Error("Give a soil in the first tab, or start from an example.");
  if (way === "part" && !(numberIn("size-from") && numberIn("size-to"))) throw new Error("Give both sizes of the part, from and to.");
  if (way === "filter" && !soil.filter) throw new Error("Give the filter in the first tab.");
  const { fines, ...water } = conditionFields(), isAlone = way !== "filter"; // a stack is as wide as its grains need
  return {
    ...curveFields(), ...water, pressure: withUnit("pressure", "kPa"), surrogate: way === "surrogate" ? "yes" : "",
    ...(isAlone ? { fines, particles: $("particles").value } : filterFields()),
    sizes: way === "part" ? `${numberIn("size-from")}mm,${numberIn("size-to")}mm` : "",
  };
}

/** The same as a text that can be compared; for a form that is wrong, what is wrong. */
function wantedNow() {
  try {
    const { curve, filter, ...words } = wantedFields();
    return JSON.stringify([words, curve && [curve.name, soil.text, soil.curve.d, soil.curve.f], filter?.name, filter && soil.filter.samples]);
  } catch (error) {
    return error.message;
  }
}

/** Says where the case is not that of the form. */
function showStale() {
  const { origin, text } = editor, isStale = text && origin && origin.wanted !== wantedNow();
  $("stale").hidden = !isStale;
  $("stale").textContent = isStale ? `This case was written from ${origin.name}; the form or the soil has changed since. “Write the case” writes it anew.` : "";
}

/** Whether the text is another than the form has written. */
const isOwnText = () => editor.text !== (editor.origin?.text ?? "");

/** What to choose on this page where a case cannot be written; the sizes that the program proposes are filled in. */
function adviceOn(error) {
  const { sizes, surrogate } = error.instead ?? {}, ways = [];
  if (sizes) {
    const [from, to] = sizes.map((size) => Number((1e3 * size).toPrecision(4)));
    $("size-from").value = from;
    $("size-to").value = to;
    ways.push(`a part of it, from ${from} to ${to} mm`);
  }
  if (surrogate) ways.push("a surrogate of two fractions");
  return ways.length ? [`This soil is too wide to simulate whole. Choose under Model it: ${ways.join(", or ")}.`] : [];
}

/** @param overwrites also a text that was changed by hand */
async function make(overwrites) {
  $("make").disabled = true;
  try {
    const wanted = wantedNow(), name = $("from").value || soil.curve?.name.replace(/\.[^.]*$/, ""), { result, talk } = await post("/api/new", wantedFields());
    if (!overwrites && editor.text && isOwnText()) return; // typed while the case was on its way
    trouble();
    $("made").innerHTML = list(talk);
    editor.take(result.case, result.files, name, { name, wanted, text: result.case });
  } catch (error) {
    trouble(error);
    $("made").innerHTML = list([error.message.split("\n")[0], ...adviceOn(error)]); // stays, whatever succeeds next
  } finally {
    $("make").disabled = false;
    showStale();
  }
}

/** The user's case with its data; data alone are those of the case that is here. */
export async function openCase(files) {
  try {
    const copies = await Promise.all(files.map(async (file) => ({ name: file.name, blob: new Blob([await file.arrayBuffer()]) })));
    const [own, ...others] = copies.filter((file) => file.name.endsWith(".toml")), data = copies.filter((file) => !file.name.endsWith(".toml"));
    if (others.length) throw new Error("Open one case at a time.");
    if (!own && !editor.text) throw new Error("Open the case, a file such as case.toml, and its data with it.");
    const text = own ? await own.blob.text() : editor.text, named = Object.entries(filesByName(text, data)).map(([name, file]) => [name, file.blob]);
    const name = own ? own.name.replace(/\.toml$/, "") : $("name").value;
    editor.take(text, { ...(own ? {} : editor.files), ...Object.fromEntries(named) }, name);
    trouble();
    $("made").innerHTML = list([`Opened: ${copies.map((file) => file.name).join(", ")}`]);
  } catch (error) {
    trouble(error);
    $("made").innerHTML = list([error.message]);
  }
  showStale();
}

async function start() {
  const run = await editor.start("runs", calibrates(editor.text) ? calibrationLimits() : {});
  if (!run) return;
  await view.show(run);
  $("live").scrollIntoView({ block: "start" });
}

function showConditions() {
  try {
    const { gradient, flow } = conditionFields(), apart = [["density", "density"], ["porosity", "porosity"], ["grain-density", "density of the grains"], ["alpha", "α"]].filter(([id]) => $(id).value.trim());
    const more = apart.length ? ` Only the criteria use what is given there for: ${apart.map(([, name]) => name).join(", ")}.` : "";
    $("conditions").textContent = soil.curve
      ? `${soil.curve.name}${soil.curve.isEdited ? " (edited)" : ""}; ${gradient ? `i = ${gradient}, flow ${flow}` : "no gradient given"}. Change these in the tab Soil.${more}` : "No soil is given yet.";
  } catch (error) {
    $("conditions").textContent = error.message;
  }
}

const showWay = () => {
  const way = $("way").value, isPart = way === "part", of = (id) => Number($(id).value.replace(",", ".")) / 1e3;
  $("own").hidden = $("from").value !== "";
  $("sizes-row").hidden = !isPart;
  $("particles-row").hidden = way === "filter";
  showSizes(isPart && of("size-from") > 0 && of("size-to") > 0 ? [of("size-from"), of("size-to")] : null);
  showStale();
};

/** When the tab is opened: the case of the soil is written at once, unless a text that was typed is there. */
export function openSimulate() {
  showConditions();
  showStale();
  const isWritten = editor.text && (isOwnText() || editor.origin.wanted === wantedNow());
  if (soil.curve && !$("from").value && !isWritten) make(false);
}

export function connectSimulate() {
  view = new RunView($("live"));
  editor = new CaseEditor("", planned, offerTests);
  connectTests(editor);
  connectCalibration(editor);
  get("/api/examples").then(({ result }) => {
    $("from").innerHTML += result.map((name) => `<option value="${escaped(name)}">${escaped(name)}${titles[name] ? `: ${titles[name]}` : ""}</option>`).join("");
  }, trouble);
  for (const id of ["from", "way", "size-from", "size-to", "particles", "pressure"]) $(id).addEventListener("input", showWay);
  $("make").addEventListener("click", () => make(true));
  $("start").addEventListener("click", start);
  $("case-files").addEventListener("click", () => { $("case-files").value = ""; }); // the same file may have changed
  $("case-files").addEventListener("change", () => openCase([...$("case-files").files]));
  $("case-drop").addEventListener("drop", (event) => {
    event.preventDefault();
    event.stopPropagation(); // the page takes what is dropped elsewhere as a grading
    $("drop").classList.remove("over");
    if (event.dataTransfer.files.length) openCase([...event.dataTransfer.files]);
  });
}
