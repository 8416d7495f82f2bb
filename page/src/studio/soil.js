// The tab Soil: a curve, how it was read, and what the criteria and the atlas say of it. All numbers are the server's.
import { $, escaped, list, mm, numberIn, three, trouble } from "./words.js";
import { afterChanges, plain, post } from "./server.js";

const { attach } = globalThis.CurveChart;

/** The soil as given, and as edited: what the other tabs start from. */
export const soil = { name: "", blob: null, text: "", samples: [], which: 0, curve: null, found: null, filter: null, sizes: null };

const sign = { stable: ["ok", "✓ stable"], unstable: ["no", "✗ unstable"], "cannot say": ["un", "? cannot say"], transition: ["un", "~ transition"], holds: ["ok", "✓ holds"], fails: ["no", "✗ fails"] };
const known = (value) => (value === null ? undefined : value);

/** The words of the form that say how the file is read. The program wants to know both columns or none: what is left open is as it was found. */
function readingFields() {
  const [column, unit, amount, kind] = ["size-column", "size-unit", "amount-column", "amount-kind"].map((id) => $(id).value), fields = {};
  if (column || unit || amount || kind) {
    const found = soil.samples[soil.which]?.reading ?? {};
    fields.size = (column || found.size || "1") + (unit ? `:${unit}` : "");
    fields[kind || found.flag || "passing"] = amount || found.share || "2";
  }
  return { ...fields, by: $("by").value, sheet: $("sheet").value, rows: $("rows").value };
}

/** The curve and how it is read, for the server: the file as given, or the points where they were edited. */
export function curveFields() {
  if (soil.curve.isEdited) {
    const rows = soil.curve.d.map((d, k) => `${Number((1e3 * d).toPrecision(12))},${Number((100 * soil.curve.f[k]).toPrecision(12))}`);
    const name = `${soil.name.replace(/\.[^.]*$/, "")}-edited.csv`;
    return { curve: { name, blob: new Blob([`d [mm],passing [%]\n${rows.join("\n")}\n`]) } };
  }
  const sample = soil.samples.length > 1 ? soil.samples[soil.which].soil : "";
  return { curve: { name: soil.name, blob: soil.blob }, ...readingFields(), sample };
}

const seeps = () => Number(numberIn("gradient-number")) > 0;
export const withUnit = (id, unit) => (numberIn(id) ? numberIn(id) + unit : "");

/** Its filter, for the server: of a table with several soils one of them. */
export const filterFields = () => (soil.filter ? { filter: soil.filter, "filter-sample": soil.filter.samples.length > 1 ? $("filter-sample").value : "" } : {});

/** What the soil is under, as `assess` and `new` call it. @throws for a field that is no number */
export const conditionFields = () => ({
  gradient: seeps() ? numberIn("gradient-number") : "", flow: seeps() ? $("flow").value : "", fines: withUnit("fines", "mm"),
});

/** What only counts where water seeps. */
const seepageFields = () => (seeps() ? { alpha: numberIn("alpha"), porosity: numberIn("porosity"), density: withUnit("grain-density", "kg/m^3") } : {});

/** Fields that are given and count for nothing without a gradient. */
function showIgnored() {
  const given = [["porosity", "porosity"], ["grain-density", "density of the grains"], ["alpha", "α"]].filter(([id]) => $(id).value.trim()).map(([, name]) => name);
  $("ignored").textContent = given.length && !Number($("gradient-number").value.replace(",", ".")) ? `Counts only with a gradient: ${given.join(", ")}.` : "";
}

/** Columns of a table, for the choice: the number of each, and its heading. */
function columnsOf(text) {
  const lines = text.split(/\r?\n/).slice(0, 60).filter((line) => line.trim());
  const best = [";", "\t", "|", ","].map((mark) => ({ mark, most: Math.max(0, ...lines.map((line) => line.split(mark).length)) }))
    .reduce((a, b) => (b.most > a.most ? b : a));
  const split = (line) => (best.most > 1 ? line.split(best.mark) : line.trim().split(/\s+/)).map((cell) => cell.trim().replace(/^"|"$/g, ""));
  const rows = lines.map(split), count = Math.max(0, ...rows.map((row) => row.length));
  const heading = (k) => rows.map((row) => row[k] ?? "").find((cell) => /\p{L}/u.test(cell)) ?? "";
  return Array.from({ length: count }, (_, k) => ({ number: k + 1, heading: heading(k).slice(0, 40) }));
}

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
  for (const id of ["size-column", "size-unit", "amount-column", "amount-kind", "by", "sheet", "rows"]) $(id).value = "";
}

/** The text of a file as the program decodes it: what is not UTF-8 is Windows-1252. Empty where it is none, or too long to edit. */
function textOf(bytes) {
  const most = 200_000;
  if (bytes.byteLength > most) return "";
  const decoded = (encoding) => new TextDecoder(encoding, { fatal: encoding === "utf-8" }).decode(bytes);
  let text;
  try {
    text = decoded("utf-8");
  } catch {
    text = decoded("windows-1252");
  }
  return text.includes("\0") ? "" : text;
}

/** A file that was dropped or chosen. Its bytes are read at once: browsers send no file that has changed since. */
export async function takeSoil(file) {
  try {
    const bytes = await file.arrayBuffer();
    Object.assign(soil, { name: file.name, blob: new Blob([bytes]), text: textOf(bytes), samples: [], which: 0 });
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
  $("table").value = soil.text; // where the curve was edited, the table was as well
  soil.found = null;
  soil.curve = { name: given.soil || soil.name, d: [...given.diameter], f: [...given.passing], isEdited: false };
  $("sample-row").hidden = soil.samples.length < 2;
  $("sample").innerHTML = soil.samples.map((s, k) => `<option value="${k}">${escaped(s.soil)}</option>`).join("");
  $("sample").value = String(which);
  const { size, unit, share, kind, share_unit: shareUnit } = given.reading;
  $("reading").textContent = `${soil.name}: sizes: ${size || "no heading"}, in ${unit}; shares: ${share || "no heading"}, read as ${kind}, in ${shareUnit}`;
  draw();
  assess();
}

const marks = (s, plot) => {
  const { found } = soil, parts = [], bottom = plot.height - plot.bottom;
  const band = (a, b, kind) => {
    const from = Math.max(s.x(a), plot.left), to = Math.min(s.x(b), plot.width - plot.right);
    if (to > from) parts.push(`<rect class="${kind}" x="${from}" y="${plot.top}" width="${to - from}" height="${bottom - plot.top}"/>`);
  };
  if (soil.sizes) {
    band(1e-12, soil.sizes[0], "cut");
    band(soil.sizes[1], 1e3, "cut");
  }
  if (!found) return parts.join("");
  if (found.gap) band(found.gap.from, found.gap.to, "gap");
  parts.push(`<path class="limit" d="M${plot.left} ${s.y(found.finer_limit)}H${plot.width - plot.right}"><title>The criteria look for fines up to here</title></path>`);
  if (found.fine_fraction) {
    const { finer_than: size, content } = found.fine_fraction, x = s.x(size), isRight = x > plot.width * 0.6;
    parts.push(`<path class="mark" d="M${x} ${plot.top}V${bottom}"/><text class="why${isRight ? " e" : ""}" x="${x + (isRight ? -6 : 6)}" y="${plot.top + 14}">fines: ${three(100 * content)} % below ${mm(size)} mm</text>`);
  }
  return parts.join("");
};

const chart = attach($("curve"), { soils: () => [soil.curve], which: () => 0, marks, changed: () => edited() });

function draw() {
  $("curve").removeAttribute("hidden");
  $("soil-confidence").hidden = false;
  $("soil-buttons").hidden = false;
  $("back").hidden = !soil.curve.isEdited;
  chart.draw();
  const { d, f, isEdited } = soil.curve, notes = isEdited ? ["The curve was edited here."] : [];
  $("curve-hint").hidden = false;
  if (soil.found?.gap) notes.push(`Shaded: the gap, ${mm(soil.found.gap.from)} to ${mm(soil.found.gap.to)} mm.`);
  if (soil.sizes) notes.push("Grey: what the modeled part leaves out.");
  if (f[0] > 0) notes.push(`${three(100 * f[0])} % is finer than the last size.`);
  if (f[f.length - 1] < 1) notes.push(`${three(100 * (1 - f[f.length - 1]))} % is coarser than the first.`);
  $("curve-note").textContent = notes.join(" ");
  $("printed-points").textContent = `${soil.curve.name}${isEdited ? " (edited)" : ""}. Passing: ${d.map((x, k) => `${Number((1e3 * x).toPrecision(6))} mm ${Number((100 * f[k]).toPrecision(4))} %`).join(", ")}.`;
}

function edited() {
  $("table").value = `d [mm],passing [%]\n${soil.curve.d.map((d, k) => `${Number((1e3 * d).toPrecision(6))},${Number((100 * soil.curve.f[k]).toPrecision(6))}`).join("\n")}\n`;
  draw();
  assess();
}

const limitText = (c) => (c.limit === null ? "" : c.upper !== null ? `${three(c.limit)} to ${three(c.upper)}` : `${c.sense === "at-most" ? "≤" : "≥"} ${three(c.limit)}`);
const numberText = (c) => (c.value !== null ? three(c.value) : c.measured !== null ? `(${three(c.measured)})` : "–");
const row = (c) => `<tr><td>${escaped(c.name)}${c.verified ? "" : " <small>unverified, not counted</small>"}<small>${escaped(c.remark ?? "")}</small></td><td class="n">${numberText(c)}<small>${limitText(c)}</small></td><td class="${sign[c.verdict]?.[0] ?? "un"}">${sign[c.verdict]?.[1] ?? escaped(c.verdict)}</td></tr>`;
const table = (title, head, rows) => `<h2>${title}</h2><div class="tw"><table><thead><tr>${head.map((h, k) => `<th${k === 1 ? ' class="n"' : ""}>${h}</th>`).join("")}</tr></thead><tbody>${rows.join("")}</tbody></table></div>`;

function atlasTable(entries) {
  if (!entries?.length) return "";
  const number = (value, atMost) => (value === null ? "–" : `${atMost ? "≤ " : ""}${three(value)}`);
  const rows = entries.map((e) => `<tr><td>${escaped(e.density)}, flow ${escaped(e.flow)}<small>${e.inside ? `porosity ${three(e.porosity)}` : "outside the atlas"}</small></td><td class="n">${number(known(e.i1) ?? null, e.i1_at_most)}</td><td class="n">${number(known(e.i10) ?? null, e.i10_at_most)}</td></tr>`);
  const { size_ratio: ratio, fines_content: content } = entries[0];
  return `${table("Simulated soils like it", ["density", "1 % move at <i>i</i>", "10 % move"], rows)}<p class="cap">From the atlas: D50/d50 ${three(ratio)}, ${three(100 * content)} % of fines.</p>`;
}

const filterName = () => [soil.filter?.name, filterFields()["filter-sample"]].filter(Boolean).join(", ");

function words(found) {
  const { stable, transition, unstable } = found.tally, counted = stable + transition + unstable, i = found.seepage?.gradient;
  const lines = [counted === 0 ? "No criterion can say of this curve alone." : unstable === 0 ? `None of ${counted} criteria says unstable.` : `${unstable} of ${counted} criteria say unstable.`];
  const moves = (found.atlas ?? []).filter((e) => e.inside && !e.wide_fines && e.flow === found.seepage?.flow && known(e.i1) !== undefined);
  if (moves.length && i > 0) {
    const all = moves.map((e) => e.i1), range = [...new Set([Math.min(...all), Math.max(...all)].map((x) => x.toFixed(2)))].join(" to ");
    const most = moves.some((e) => e.i1_at_most) ? "at most " : "", safety = [...new Set([Math.min(...all) / i, Math.max(...all) / i].map((x) => x.toFixed(1)))].join(" to ");
    lines.push(`1 % of the fines move at i = ${most}${range} (atlas): factor of safety ${most}${safety}.`);
  }
  const heave = (found.gradients ?? []).find((c) => c.id === "terzaghi");
  if (heave && i > 0) lines.push(`Factor of safety ${(heave.limit / heave.value).toFixed(1)} against heave of the whole soil.`);
  if (found.filter) lines.push(`The filter ${filterName()} ${found.filter.summary}.`, found.filter.simulated.summary);
  return lines;
}

function show(found) {
  soil.found = found;
  $("verdict").innerHTML = words(found).map((line) => `<span>${escaped(line)}</span>`).join("");
  const parts = [table("Criteria", ["criterion", "number", "verdict"], found.criteria.map(row))];
  if (found.gradients?.length) parts.push(table("Seepage", ["criterion", "number", "verdict"], found.gradients.map(row)));
  parts.push(atlasTable(found.atlas));
  if (found.filter) parts.push(table(`The filter ${escaped(filterName())}`, ["rule", "number", "verdict"], found.filter.criteria.map(row)));
  const sizes = found.sizes;
  parts.push(`<p class="cap">${["d10", "d50", "d60"].map((size) => `${size} ${sizes[size] === null ? "?" : mm(sizes[size])}`).join(", ")} mm; Cu ${found.uniformity === null ? "?" : three(found.uniformity)}.</p>`);
  $("soil-results").innerHTML = parts.join("");
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
  soil.filter = null;
  $("no-filter").hidden = !file;
  $("filter-sample-row").hidden = true;
  $("filter-name").textContent = file ? "Reading …" : "";
  try {
    if (file) {
      const blob = new Blob([await file.arrayBuffer()]), { result } = await post("/api/reading", { curve: { name: file.name, blob } });
      soil.filter = { name: file.name, blob, samples: result.soils };
      const { size, unit, share, kind } = result.soils[0].reading;
      $("filter-name").textContent = `${file.name}: sizes: ${size || "no heading"}, in ${unit}; shares: ${share || "no heading"}, read as ${kind}`;
      $("filter-sample").innerHTML = result.soils.map((s) => `<option value="${escaped(s.soil)}">${escaped(s.soil)}</option>`).join("");
      $("filter-sample-row").hidden = result.soils.length < 2;
    }
  } catch (error) {
    $("filter-name").textContent = `${file.name} cannot be read, so there is no filter: ${error.problems?.[0]?.message ?? error.message}`;
  }
  assess();
}

/** Redraws the curve with what a case would leave out. */
export function showSizes(sizes) {
  soil.sizes = sizes;
  if (soil.curve) draw();
}

export function connectSoil() {
  for (const id of ["file", "filter-file"]) $(id).addEventListener("click", () => { $(id).value = ""; }); // the same file may have changed
  $("file").addEventListener("change", () => { const file = $("file").files[0]; if (file) takeSoil(file); });
  $("table").addEventListener("paste", ({ target: { selectionStart, selectionEnd, value } }) => {
    if (selectionStart === 0 && selectionEnd === value.length) soil.name = ""; // another soil, not that file edited
  });
  $("table").addEventListener("input", () => {
    soil.name ||= "pasted.csv";
    soil.text = $("table").value;
    soil.blob = new Blob([soil.text]);
    offerColumns(soil.text);
    read();
  });
  for (const id of ["size-column", "size-unit", "amount-column", "amount-kind", "by", "sheet", "rows"]) $(id).addEventListener("change", () => soil.blob && read());
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
  for (const form of document.forms) form.addEventListener("submit", (event) => event.preventDefault());
}
