// The tab Soil: a file or a table becomes a curve, which is drawn and assessed anew whenever it or the form changes.
import { $, escaped, list, numberIn, trouble } from "./words.js";
import { afterChanges, plain, post } from "./server.js";
import { answerTables, curveMarks, curveNotes, pointsText, verdictLines } from "./soil_answer.js";
import { conditionFields, curveFields, filterFields, filterName, readingFields, readingIds, seepageFields, showIgnored, soil } from "./soil_form.js";
import { keepFile, keepForm, keptFile, restoreForm } from "./kept_soil.js";
import { columnsOf, tableOf, textOf } from "./table_text.js";

const { attach } = globalThis.CurveChart;
let chosen = () => {}; // is called with each new curve
let filterWanted; // the last one that was chosen

function offerColumns(text) {
  const options = columnsOf(text).map((c) => `<option value="${c.number}">${c.number}${c.heading ? `: ${escaped(c.heading)}` : ""}</option>`).join("");
  for (const id of ["size-column", "amount-column"]) {
    const chosen = $(id).value;
    $(id).innerHTML = `<option value="">as found</option>${options}`;
    $(id).value = chosen;
    if ($(id).selectedIndex < 0) $(id).value = "";
  }
}

function readAsFound() {
  for (const id of readingIds) $(id).value = "";
}

/** A file that was dropped or chosen. Its bytes are read at once: browsers send no file that has changed since. */
export async function takeSoil(file) {
  try {
    const bytes = await file.arrayBuffer();
    Object.assign(soil, { name: file.name, blob: new Blob([bytes]), text: textOf(bytes), samples: [], which: 0, edits: null });
  } catch {
    forget();
    trouble(new Error(`${file.name} cannot be read. If it was changed or moved, choose it again.`));
    return;
  }
  readAsFound();
  $("table").value = soil.text;
  offerColumns(soil.text);
  read();
}

/** Takes away what was said of a soil that is no longer the one in the form. */
function forgetAnswer(words) {
  soil.found = null;
  $("verdict").textContent = words;
  $("soil-results").innerHTML = "";
}

function forget() {
  soil.curve = null;
  $("curve").setAttribute("hidden", "");
  for (const id of ["soil-confidence", "soil-buttons", "curve-hint", "sample-row"]) $(id).hidden = true;
  for (const id of ["reading", "remarks", "curve-note", "printed-points"]) $(id).textContent = "";
  forgetAnswer(soil.blob?.size ? "This cannot be read as a grading." : "Drop a grading, or paste one.");
}

/** Reads the file anew: its samples and their points. */
const read = afterChanges(60, async (signal) => {
  keepFile("soil", soil);
  try {
    const { result } = await post("/api/reading", { curve: { name: soil.name, blob: soil.blob }, ...readingFields() }, signal);
    soil.samples = result.soils;
    soil.which = Math.min(soil.which, soil.samples.length - 1);
    $("remarks").innerHTML = list(result.remarks.map(plain));
    trouble();
    choose(soil.which);
  } catch (error) {
    if (error.name === "AbortError") throw error;
    forget();
    trouble(soil.blob.size ? error : undefined);
    $("correct").open = soil.blob.size > 0;
  }
});

/** One of the samples, as it was read. */
function choose(which) {
  soil.which = which;
  const given = soil.samples[which];
  soil.found = null;
  soil.curve = { name: given.soil || soil.name, d: [...given.diameter], f: [...given.passing], isEdited: false, ...soil.edits };
  soil.edits = null;
  $("table").value = soil.curve.isEdited ? tableOf(soil.curve, 6) : soil.text; // where the curve was edited, the table was as well
  $("sample-row").hidden = soil.samples.length < 2;
  $("sample").innerHTML = soil.samples.map((s, k) => `<option value="${k}">${escaped(s.soil)}</option>`).join("");
  $("sample").value = String(which);
  const { size, unit, share, kind, share_unit: shareUnit } = given.reading;
  $("reading").textContent = `${soil.name}: sizes: ${size || "no heading"}, in ${unit}; shares: ${share || "no heading"}, read as ${kind}, in ${shareUnit}`;
  draw();
  assess();
  chosen();
}

const chart = attach($("curve"), {
  soils: () => [soil.curve], which: () => 0, marks: (s, plot) => curveMarks(soil.found, soil.sizes, s, plot), changed: () => edited(),
});

function draw() {
  $("curve").removeAttribute("hidden");
  $("soil-confidence").hidden = false;
  $("soil-buttons").hidden = false;
  $("back").hidden = !soil.curve.isEdited;
  chart.draw();
  $("curve-hint").hidden = false;
  $("curve-note").textContent = curveNotes(soil.curve, soil.found, soil.sizes);
  $("printed-points").textContent = pointsText(soil.curve);
}

function edited() {
  $("table").value = tableOf(soil.curve, 6);
  draw();
  assess();
}

function show(found) {
  soil.found = found;
  $("verdict").innerHTML = verdictLines(found, filterName()).map((line) => `<span>${escaped(line)}</span>`).join("");
  $("soil-results").innerHTML = answerTables(found, filterName());
  draw();
}

const assess = afterChanges(40, async (signal) => {
  const { curve } = soil;
  if (!curve) return;
  try {
    const { result } = await post("/api/assess", {
      ...curveFields(), ...conditionFields(), ...seepageFields(), "relative-density": numberIn("density"), ...filterFields(),
    }, signal);
    if (soil.curve !== curve) return; // of the soil before
    trouble();
    $("remarks").innerHTML = list(result.remarks.map(plain));
    show(result.soils[0]);
  } catch (error) {
    if (error.name === "AbortError") throw error;
    if (soil.curve !== curve) return;
    forgetAnswer("No answer: see above.");
    draw();
    trouble(error);
  }
});

/** The other soil, which is to hold this one. Null: none. */
async function takeFilter(file) {
  const own = filterWanted = {};
  soil.filter = null;
  keepFile("filter", {});
  $("no-filter").hidden = !file;
  $("filter-sample-row").hidden = true;
  $("filter-name").textContent = file ? "Reading …" : "";
  try {
    if (file) {
      const blob = new Blob([await file.arrayBuffer()]), { result } = await post("/api/reading", { curve: { name: file.name, blob } });
      if (own !== filterWanted) return;
      soil.filter = { name: file.name, blob, samples: result.soils };
      keepFile("filter", soil.filter);
      const { size, unit, share, kind } = result.soils[0].reading;
      $("filter-name").textContent = `${file.name}: sizes: ${size || "no heading"}, in ${unit}; shares: ${share || "no heading"}, read as ${kind}`;
      $("filter-sample").innerHTML = result.soils.map((s) => `<option value="${escaped(s.soil)}">${escaped(s.soil)}</option>`).join("");
      $("filter-sample-row").hidden = result.soils.length < 2;
    }
  } catch (error) {
    if (own !== filterWanted) return;
    $("filter-name").textContent = `${file.name} cannot be read, so there is no filter: ${error.problems?.[0]?.message ?? error.message}`;
  }
  assess();
}

/** Redraws the curve with what a case would leave out. */
export function showSizes(sizes) {
  soil.sizes = sizes;
  if (soil.curve) draw();
}

/** What was here before the page was loaded again. */
async function restore() {
  const file = keptFile("soil"), filter = keptFile("filter");
  if (file) await takeSoil(file); // and reads it after the fields are filled in
  const { which = 0, edits = null, filterSample } = restoreForm();
  Object.assign(soil, { which, edits });
  showIgnored();
  if (!filter) return;
  await takeFilter(filter);
  $("filter-sample").value = filterSample;
}

/** @param changed is called with each new curve */
export function connectSoil(changed) {
  chosen = changed;
  for (const id of ["file", "filter-file"]) $(id).addEventListener("click", () => { $(id).value = ""; }); // the same file may have changed
  $("file").addEventListener("change", () => { const file = $("file").files[0]; if (file) takeSoil(file); });
  $("table").addEventListener("paste", ({ target: { selectionStart, selectionEnd, value } }) => {
    if (selectionStart === 0 && selectionEnd === value.length) soil.name = ""; // another soil, not that file edited
  });
  $("table").addEventListener("input", () => {
    soil.name ||= "pasted.csv";
    soil.text = $("table").value;
    soil.blob = new Blob([soil.text]);
    soil.edits = null;
    offerColumns(soil.text);
    read();
  });
  for (const id of readingIds) $(id).addEventListener("change", () => soil.blob && read());
  $("as-found").addEventListener("click", () => { readAsFound(); if (soil.blob) read(); });
  $("sample").addEventListener("change", () => choose(Number($("sample").value)));
  $("back").addEventListener("click", () => choose(soil.which));
  $("print").addEventListener("click", () => window.print());
  $("gradient").addEventListener("input", () => { $("gradient-number").value = $("gradient").value; });
  $("gradient-number").addEventListener("input", () => { $("gradient").value = $("gradient-number").value.replace(",", ".") || "0"; });
  for (const id of ["gradient", "gradient-number", "flow", "density", "alpha", "porosity", "grain-density", "fines"]) $(id).addEventListener("input", () => { showIgnored(); assess(); });
  $("filter-file").addEventListener("change", () => { const file = $("filter-file").files[0]; if (file) takeFilter(file); });
  $("filter-sample").addEventListener("change", assess);
  $("no-filter").addEventListener("click", () => { $("filter-file").value = ""; takeFilter(null); });
  window.addEventListener("resize", () => soil.curve && draw());
  window.addEventListener("pagehide", () => {
    const { which, curve } = soil;
    keepForm({ which, edits: curve?.isEdited ? curve : null, filterSample: $("filter-sample").value });
  });
  restore();
  for (const form of document.forms) form.addEventListener("submit", (event) => event.preventDefault());
}
