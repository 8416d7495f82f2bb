// The tab Sweep: values of keys written into a case, its price, its samples as they come in, and tasks for a cluster.
import { $, escaped, list, secondsRange, trouble } from "./words.js";
import { get, post, runPath } from "./server.js";
import { CaseEditor } from "./case_editor.js";
import { compareRuns } from "./compare_view.js";
import { SweepView } from "./sweep_view.js";
import { caseNow, titles } from "./simulate.js";
import { keysOf, studiesOf, sweepLine, valuesOf, withSweep } from "./case_text.js";

let view, editor, current = "";

const rows = () => [...$("sweep-keys").children].map((row) => ({ key: row.querySelector(".key").value.trim(), values: row.querySelector(".values").value }));

function addRow(key = "", values = "") {
  const row = document.createElement("div"), number = $("sweep-keys").children.length + 1;
  row.className = "swept";
  row.innerHTML = `<label class="in">Key ${number} <input class="key" list="sweep-known-keys" spellcheck="false" placeholder="contact.friction"></label><label class="in">its values <input class="values" spellcheck="false" placeholder="20 deg, 30 deg, 37 deg"></label>`;
  row.querySelector(".key").value = key;
  row.querySelector(".values").value = values;
  $("sweep-keys").append(row);
}

const planned = (plan) => `<table><caption>${plan.samples.length === 1 ? "One sample: this case sweeps nothing." : `${plan.samples.length} samples, ${plan.samples_at_once} at a time`}</caption><thead><tr><th>sample</th><th class="n">grains</th><th class="n">time</th></tr></thead><tbody>${plan.samples.map((s) =>
  `<tr><td>${escaped(s.sample)}<small>seed ${escaped(String(s.seed))}</small></td><td class="n">${s.grains.toLocaleString("en")}</td><td class="n">${s.cached === s.stages ? "in the cache" : secondsRange(s.seconds)}</td></tr>`).join("")}</tbody></table><ul class="cap">${list(plan.warnings ?? [])}</ul>`;

/** The studies and keys of the text. */
function offer(text) {
  const studies = studiesOf(text), chosen = $("sweep-study").value;
  $("sweep-study").innerHTML = studies.map((name) => `<option${name === chosen ? " selected" : ""}>${escaped(name)}</option>`).join("");
  $("sweep-known-keys").innerHTML = keysOf(text, $("sweep-study").value).map((key) => `<option value="${escaped(key)}"></option>`).join("");
}

async function takeCase() {
  const example = $("sweep-from").value;
  $("sweep-take").disabled = true;
  try {
    const { text, files, name } = example ? await post("/api/new", { from: example }).then(({ result }) => ({ text: result.case, files: result.files, name: example })) : caseNow();
    if (!text.trim()) throw new Error("The tab Simulate has no case yet. Write one there, or start from an example.");
    trouble();
    editor.take(text, files, `${name}-sweep`, { text, isOfSimulate: !example });
    $("sweep-written").textContent = "";
  } catch (error) {
    trouble(error);
  }
  $("sweep-take").disabled = false;
}

function write() {
  try {
    if (!sweepLine(rows())) throw new Error("Name a key and its values, with commas between them.");
    const replicates = $("sweep-replicates").value, wanted = rows().filter((row) => row.key && valuesOf(row.values).length).reduce((n, row) => n * valuesOf(row.values).length, Number(replicates) || 1);
    editor.set(withSweep(editor.text, $("sweep-study").value, rows(), replicates));
    $("sweep-written").textContent = `Written into the case: ${wanted} samples.${replicates && /^\s*\[presets\.[\w-]+\]\s*\n\s*replicates/m.test(editor.text) ? " A preset of this case sets replicates itself; choose another preset, or change it in the text." : ""}`;
    trouble();
  } catch (error) {
    trouble(error);
  }
}

function showScript({ run, script, command }) {
  $("script-part").hidden = false;
  $("script-run").textContent = `Tasks of ${run}. Submit them in the studio's folder: ${command}`;
  $("script").textContent = script;
  $("copied").textContent = "";
}

const taskFields = () => ({ threads: $("task-threads").value, "time-limit": $("task-time").value });

async function emitCase() {
  const answer = await editor.request("/api/slurm", taskFields(), $("emit"));
  if (!answer) return;
  choose(answer.run); // the address, which opens it, changes later
  location.hash = `#sweep/${encodeURIComponent(answer.run)}`;
  showScript(answer);
}

async function emitRest() {
  $("emit-rest").disabled = true;
  try {
    showScript(await post(`${runPath(current)}/slurm`, taskFields()));
    trouble();
  } catch (error) {
    trouble(error);
  }
  $("emit-rest").disabled = false;
}

async function copy() {
  try {
    await navigator.clipboard.writeText($("script").textContent);
    $("copied").textContent = "Copied.";
  } catch {
    getSelection().selectAllChildren($("script"));
    $("copied").textContent = "Selected: copy it by Ctrl-C.";
  }
}

async function start() {
  const run = await editor.start("sweep");
  if (!run) return;
  location.hash = `#sweep/${encodeURIComponent(run)}`;
}

function offerRuns(names, samples = new Map()) {
  const sweeps = names.filter((name) => samples.get(name) !== 1), text = (name) => `${name}${samples.get(name) > 1 ? `, ${samples.get(name)} samples` : ""}`;
  const fill = (id, none, offered) => {
    const kept = id === "sweep-shown" ? current : $(id).value;
    $(id).innerHTML = `<option value="">${none}</option>${offered.map((name) => `<option value="${escaped(name)}">${escaped(text(name))}</option>`).join("")}`;
    $(id).value = offered.includes(kept) ? kept : "";
  };
  fill("sweep-shown", "none", current && !sweeps.includes(current) ? [current, ...sweeps] : sweeps);
  fill("sweep-other", "nothing", names.filter((name) => name !== current));
}

/** Names at once; what has how many samples takes longer to find. */
async function loadNames() {
  try {
    const names = (await get("/api/names")).result;
    offerRuns(names);
    get("/api/runs").then(({ result }) => offerRuns(names, new Map(result.runs.map((run) => [run.name, run.kind === "calibration" ? 1 : run.samples.total]))), trouble);
  } catch (error) {
    trouble(error);
  }
}

async function compare() {
  const other = $("sweep-other").value;
  $("sweep-differences").innerHTML = "";
  try {
    await view.compareWith(other);
    if ($("sweep-other").value !== other) return;
    trouble();
    if (other) $("sweep-differences").innerHTML = `<details><summary>Every number that differs</summary></details>`;
  } catch (error) {
    trouble(error);
  }
  $("sweep-differences").querySelector("details")?.addEventListener("toggle", async (event) => {
    if (event.target.children.length > 1) return;
    const place = document.createElement("div");
    place.textContent = "Comparing …";
    event.target.append(place);
    try {
      place.innerHTML = await compareRuns(current, other);
    } catch (error) {
      place.textContent = error.message;
    }
  });
}

/** Shows a sweep; none for "". */
function choose(name) {
  if (name === current) return;
  current = name;
  $("sweep-other").value = "";
  $("sweep-differences").innerHTML = "";
  $("script-part").hidden = true;
  $("sweep-shown-row").hidden = !name;
  if (name) view.show(name);
  else view.close();
}

/** Opens the tab, and a sweep where one is named. */
export async function openSweep(name) {
  choose(name);
  const { text } = caseNow(), isOlder = editor.origin?.isOfSimulate && editor.origin.text !== text;
  if (text.trim() && (!editor.text || (isOlder && editor.text === editor.origin.text))) takeCase();
  else if (isOlder) $("sweep-written").textContent = "The case of the tab Simulate has changed since this one was taken.";
  await loadNames();
}

export function connectSweep() {
  view = new SweepView($("sweep-live"), () => (view.name ? loadNames() : (location.hash = "#sweep")));
  editor = new CaseEditor("sweep-", planned, offer);
  addRow("contact.friction", "20 deg, 30 deg, 37 deg");
  get("/api/examples").then(({ result }) => {
    $("sweep-from").innerHTML += result.map((name) => `<option value="${escaped(name)}">${escaped(name)}${titles[name] ? `: ${titles[name]}` : ""}</option>`).join("");
  }, trouble);
  $("sweep-take").addEventListener("click", takeCase);
  $("sweep-study").addEventListener("change", () => offer(editor.text));
  $("sweep-add").addEventListener("click", () => { addRow(); $("sweep-keys").lastElementChild.querySelector("input").focus(); });
  $("sweep-write").addEventListener("click", write);
  $("sweep-start").addEventListener("click", start);
  $("sweep-shown").addEventListener("change", () => { location.hash = $("sweep-shown").value ? `#sweep/${encodeURIComponent($("sweep-shown").value)}` : "#sweep"; });
  $("sweep-other").addEventListener("change", compare);
  $("emit").addEventListener("click", emitCase);
  $("emit-rest").addEventListener("click", emitRest);
  $("copy").addEventListener("click", copy);
}
