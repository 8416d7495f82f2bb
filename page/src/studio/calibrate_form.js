// A calibration as a form of its case: records of tests as they were understood, which of them count, what is sought.
import { $, escaped, list, three, trouble } from "./words.js";
import { get, post } from "./server.js";
import { calibrationText, dataName, targetName } from "./calibrate_text.js";
import { soil } from "./soil_form.js";

const laws = {
  "hertz-mindlin": { fixed: [["modulus", "70 GPa"], ["poisson", "0.2"], ["rolling_stiffness", "7.5"]], modulus: ["1 GPa", "100 GPa"] },
  "linear-rolling": { fixed: [["modulus", "300 MPa"], ["shear_ratio", "0.42"], ["rolling_stiffness", "7.5"]], modulus: ["50 MPa", "2 GPa"] },
};
const sought = (law) => [["contact.modulus", ...laws[law].modulus, true], ["contact.friction", "18 deg", "45 deg", false], ["contact.rolling_friction", "0.02", "0.6", false], ["void_ratio", "0.55", "0.8", false]];
let editor, reading = Promise.resolve(), records = []; // { name, file, kind, contraction, found }
let drawn = []; // the rows of the tests: { id, key }
const unread = new Map(); // files by their names, until the form says how to read them

const isUndrained = (record) => record.found.columns.some((column) => column.role === "pore_pressure");
const allTests = () => records.flatMap((record, r) => record.found.tests.map((test, t) => ({ record, test, id: `${r}-${t}` })));

/** What a row of the form says. */
const rowOf = (id) => ({ role: $(`target-role-${id}`)?.value ?? "", kind: $(`target-test-${id}`)?.value, pressure: $(`target-pressure-${id}`)?.value.trim(), like: $(`target-like-${id}`)?.value });

/** Two digits of the stress at its start, as laboratories name it. */
function startPressure({ mean_stress: mean, radial_stress: radial, axial_stress: axial }) {
  const stress = [mean, radial, axial].find((value) => Number.isFinite(value) && value > 0);
  return stress ? `${Number((stress / 1e3).toPrecision(2))} kPa` : "";
}

function understood(record) {
  const { columns, decided, assumed, unread, tests, rows } = record.found;
  return `<p><b>${escaped(record.name)}</b>: ${escaped(record.kind)}, ${tests.length} test${tests.length === 1 ? "" : "s"}, ${rows} rows <button type="button" data-drop="${records.indexOf(record)}">Leave it out</button></p>
<details><summary>How it is read</summary><ul class="cap">${list(columns.map((c) => `${c.heading}: ${c.role.replaceAll("_", " ")}${c.effective === undefined ? "" : c.effective ? ", effective" : ", total"}`))}${list([...decided.map((text) => `found: ${text}`), ...assumed.map((text) => `assumed: ${text}`), ...unread.map((text) => `not read: ${text}`)])}</ul></details>`;
}

/** Fitted tests, those of the same density first: whose void ratio a test can share. */
function sharers(id) {
  const e = (test) => test.test.first.void_ratio, own = allTests().find((test) => test.id === id);
  const near = (test) => (Number.isFinite(e(own)) && Number.isFinite(e(test)) ? Math.abs(e(own) - e(test)) : 1);
  return allTests().filter((test) => test.id !== id && rowOf(test.id).role === "fit" && !rowOf(test.id).like).sort((a, b) => near(a) - near(b));
}

/** What of a test counts once it is chosen. */
function drawChosen(id, kept) {
  const place = $(`target-more-${id}`), { record, test } = allTests().find((one) => one.id === id), { role } = rowOf(id), isOedometer = record.kind === "oedometer";
  if (!role) {
    place.innerHTML = "";
    return;
  }
  const own = role === "fit" ? '<option value="">its own void ratio</option>' : "";
  const kinds = isOedometer ? ["oedometer"] : ["drained", "undrained"];
  place.innerHTML = `<div class="pair"><label class="in">Test <select id="target-test-${id}">${kinds.map((kind) => `<option>${kind}</option>`).join("")}</select></label>
<label class="in">Pressure at its start <input id="target-pressure-${id}" spellcheck="false" placeholder="100 kPa"></label></div>
<label class="in">Void ratio of the model <select id="target-like-${id}">${own}${sharers(id).map((one) => `<option value="${one.id}">that of ${escaped(one.test.name)}</option>`).join("")}</select></label>`;
  $(`target-test-${id}`).value = kept?.kind ?? (isOedometer ? "oedometer" : isUndrained(record) ? "undrained" : "drained");
  $(`target-pressure-${id}`).value = kept?.pressure ?? startPressure(test.first);
  if (kept?.like && [...$(`target-like-${id}`).options].some((option) => option.value === kept.like)) $(`target-like-${id}`).value = kept.like;
}

/** Which others a test can share its void ratio with has changed. */
function redrawSharers(except) {
  for (const { id } of allTests()) {
    const row = rowOf(id);
    if (row.role && id !== except) drawChosen(id, row);
  }
}

function choose(id) {
  drawChosen(id);
  const e = allTests().find((test) => test.id === id).test.first.void_ratio, [nearest] = sharers(id);
  const isLike = nearest && (rowOf(id).role === "held" || (Number.isFinite(e) && Math.abs(nearest.test.first.void_ratio - e) < 0.03));
  if (isLike) $(`target-like-${id}`).value = nearest.id;
  redrawSharers(id);
}

/** What the form says of each test, by the test: the numbers of the rows change with the records. */
const choices = () => new Map(drawn.map(({ id, key }) => [key, { ...rowOf(id), like: drawn.find((one) => one.id === rowOf(id).like)?.key }]));

function drawRecords() {
  const kept = choices(), tests = allTests();
  drawn = tests.map(({ record, test, id }) => ({ id, key: JSON.stringify([record.name, test.name]) }));
  $("calibrate-records").innerHTML = records.map(understood).join("");
  $("calibrate-tests").innerHTML = tests.map(({ test, id }) => `<div class="sought"><label class="in">${escaped(test.name)}${Number.isFinite(test.first.void_ratio) ? `, e ${three(test.first.void_ratio)}` : ""}${startPressure(test.first) ? `, ${startPressure(test.first)}` : ""} <select id="target-role-${id}"><option value="">is left out</option><option value="fit">is fitted</option><option value="held">is held out, and predicted</option></select></label><div id="target-more-${id}"></div></div>`).join("");
  const again = drawn.map(({ id, key }) => ({ id, ...kept.get(key) })).filter((row) => row.role);
  for (const { id, role } of again) $(`target-role-${id}`).value = role;
  for (const row of again.sort((a, b) => Boolean(a.like) - Boolean(b.like))) drawChosen(row.id, { ...row, like: drawn.find(({ key }) => key === row.like)?.id });
  for (const { id } of drawn) $(`target-role-${id}`).addEventListener("change", () => choose(id));
  $("calibrate-write").disabled = !records.length;
}

/** Reads a record as the kind that it can be. */
async function readRecord(file) {
  const contraction = $("calibrate-contraction").value, chosen = $("calibrate-kind").value;
  const kinds = chosen ? [chosen] : /oed|konsol|consol/i.test(file.name) ? ["oedometer", "triaxial"] : ["triaxial", "oedometer"];
  let first;
  for (const kind of kinds) {
    try {
      const { result } = await post("/api/record", { record: { name: file.name, blob: file }, kind, contraction });
      return { name: file.name, file, kind, contraction, found: result };
    } catch (error) {
      first ??= error;
    }
  }
  throw first;
}

async function readAll(files) {
  $("calibrate-reading").textContent = "Reading …";
  const failures = [];
  for (const given of files) {
    try {
      const file = new File([await given.arrayBuffer()], given.name); // browsers send no file that has changed since
      unread.set(file.name, file);
      const record = await readRecord(file), at = records.findIndex((one) => one.name === record.name);
      if (at < 0) records.push(record);
      else records[at] = record;
      unread.delete(file.name);
    } catch (error) {
      failures.push(error);
    }
  }
  trouble(failures[0]);
  $("calibrate-reading").textContent = unread.size ? `Not read: ${[...unread.keys()].join(", ")}. Choose what they are, or whether contraction is positive in them.` : "";
  drawRecords();
}

/** Reads files when those before are read: what is said of a file last counts. */
const take = (files) => { reading = reading.then(() => readAll(files())).catch(trouble); };

const lastRow = (place) => place.lastElementChild.querySelector("input");

function addUnknown(key = "", from = "", to = "", isLog = false) {
  const row = document.createElement("div"), number = $("calibrate-unknowns").children.length + 1;
  row.className = "sought";
  row.innerHTML = `<label class="in">Parameter ${number} <input class="key" list="calibrate-known-keys" spellcheck="false" placeholder="contact.friction"></label><div class="pair"><label class="in">from <input class="from" spellcheck="false"></label><label class="in">to <input class="to" spellcheck="false"></label></div><label><input class="log" type="checkbox"> all decades as likely</label>`;
  row.querySelector(".key").value = key;
  row.querySelector(".from").value = from;
  row.querySelector(".to").value = to;
  row.querySelector(".log").checked = isLog;
  $("calibrate-unknowns").append(row);
}

function addFixed(key = "", value = "") {
  const row = document.createElement("div"), number = $("calibrate-fixed").children.length + 1;
  row.className = "pair";
  row.innerHTML = `<label class="in">Fixed ${number} <input class="key" list="calibrate-contact-keys" spellcheck="false"></label><label class="in">its value <input class="value" spellcheck="false"></label>`;
  row.querySelector(".key").value = key;
  row.querySelector(".value").value = value;
  $("calibrate-fixed").append(row);
}

function offerLaw() {
  const law = $("calibrate-law").value;
  $("calibrate-unknowns").innerHTML = "";
  $("calibrate-fixed").innerHTML = "";
  for (const row of sought(law)) addUnknown(...row);
  for (const row of laws[law].fixed) addFixed(...row);
}

const valueIn = (row, name) => row.querySelector(`.${name}`).value.trim();

/** The tests that count, fitted ones first: others name them. */
function targets() {
  const chosen = allTests().map((test) => ({ ...test, ...rowOf(test.id) })).filter((test) => test.role).sort((a, b) => (a.role === "held") - (b.role === "held"));
  const names = new Map();
  for (const test of chosen) names.set(test.id, targetName(test.test.name, [...names.values()]));
  return chosen.map(({ record, test, id, role, kind, pressure, like }) => ({
    name: names.get(id), file: dataName(record.name), sample: record.found.tests.length > 1 ? test.name : "", test: kind, contraction: record.contraction, pressure,
    strain: kind === "oedometer" ? "" : $("calibrate-strain").value.trim(), void_ratio_of: like ? names.get(like) : "", held_out: role === "held",
  }));
}

function write() {
  try {
    const unknowns = [...$("calibrate-unknowns").children].map((row) => ({ key: valueIn(row, "key"), from: valueIn(row, "from"), to: valueIn(row, "to"), isLog: row.querySelector(".log").checked }));
    const fixed = [...$("calibrate-fixed").children].map((row) => [valueIn(row, "key"), valueIn(row, "value")]);
    const name = soil.curve ? soil.curve.name.replace(/\.[^.]*$/, "") : "";
    const text = calibrationText({
      title: `calibration of ${name}`, curve: soil.curve, contact: [["law", $("calibrate-law").value], ...fixed], targets: targets(), unknowns,
      particles: $("calibrate-particles").value, samples: $("calibrate-samples").value,
    });
    editor.take(text, Object.fromEntries(records.map((record) => [dataName(record.name), record.file])), `${name}-calibration`);
    trouble();
    $("made").innerHTML = ""; // what was said of the case before
    $("calibrate-note").textContent = "Written into the case. Its price follows.";
  } catch (error) {
    trouble(error);
    $("calibrate-note").textContent = error.message; // the top of the page is out of sight here
  }
}

async function learnKeys() {
  if ($("calibrate-known-keys").children.length) return;
  try {
    const { result } = await get("/api/keys"), contact = result.keys.filter((key) => key.table === "contact" && key.name !== "law").map((key) => key.name);
    const options = (names) => names.map((name) => `<option value="${escaped(name)}"></option>`).join("");
    $("calibrate-known-keys").innerHTML = options([...contact.map((name) => `contact.${name}`), "void_ratio"]);
    $("calibrate-contact-keys").innerHTML = options(contact);
  } catch (error) {
    trouble(error);
  }
}

/** Wall time after which a calibration that is started saves and stops. */
export const calibrationLimits = () => ({ "time-limit": $("calibrate-time").value.trim() });

/** @param caseEditor that the text is written into */
export function connectCalibration(caseEditor) {
  editor = caseEditor;
  offerLaw();
  $("calibration").addEventListener("toggle", () => $("calibration").open && learnKeys()); // they are needed only then
  $("calibrate-files").addEventListener("click", () => { $("calibrate-files").value = ""; }); // the same files may have changed
  $("calibrate-files").addEventListener("change", () => {
    const files = [...$("calibrate-files").files];
    take(() => files);
  });
  $("calibrate-drop").addEventListener("drop", (event) => {
    event.preventDefault();
    event.stopPropagation(); // the page takes what is dropped elsewhere as a grading
    $("drop").classList.remove("over");
    const files = [...event.dataTransfer.files];
    if (files.length) take(() => files);
  });
  for (const id of ["calibrate-kind", "calibrate-contraction"]) $(id).addEventListener("change", () => take(() => [...records.map((record) => record.file), ...unread.values()]));
  $("calibrate-records").addEventListener("click", (event) => {
    if (event.target.dataset.drop === undefined) return;
    records.splice(Number(event.target.dataset.drop), 1);
    drawRecords();
  });
  $("calibrate-law").addEventListener("change", offerLaw);
  $("calibrate-add").addEventListener("click", () => { addUnknown(); lastRow($("calibrate-unknowns")).focus(); });
  $("calibrate-fix").addEventListener("click", () => { addFixed(); lastRow($("calibrate-fixed")).focus(); });
  $("calibrate-write").addEventListener("click", write);
}
