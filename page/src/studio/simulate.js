// The tab Simulate: a case made from the soil or from an example, its text, its price, and its run.
import { $, escaped, list, secondsRange, trouble } from "./words.js";
import { afterChanges, get, post } from "./server.js";
import { RunView, planFacts } from "./run_view.js";
import { conditionFields, curveFields, showSizes, soil } from "./soil.js";

/** What is known of an example beyond its name. */
const titles = {
  "fontainebleau-2016": "erosion of Fontainebleau sand", "critical-gradient": "the gradient that moves the fines", replay: "a small packing, seconds",
  laboratory: "laboratory tests", "silty-sand-2016": "strength over the fines content", "million-grains": "a million grains, hours",
};
const held = { files: {} }; // what the case names
let view;

const caseFields = () => ({ case: $("case").value, preset: $("preset").value, ...Object.fromEntries(Object.entries(held.files).map(([name, text]) => [`file:${name}`, text])) });

function offerPresets(text) {
  const chosen = $("preset").value, names = [...text.matchAll(/^\s*\[presets\.([\w-]+)\]/gm)].map((m) => m[1]);
  const all = [...new Set([...names, "standard"])];
  const named = text.match(/^\s*preset\s*=\s*"([\w-]+)"/m)?.[1] ?? "";
  $("preset").innerHTML = `<option value="">as in the case${named ? `: ${escaped(named)}` : ""}</option>${all.map((name) => `<option>${escaped(name)}</option>`).join("")}`;
  $("preset").value = chosen;
  if ($("preset").selectedIndex < 0) $("preset").value = "";
}

/** Numbers of the lines, those with problems marked. */
function numberLines(problems = []) {
  const lines = $("case").value.split("\n").length, marked = new Map(problems.map((p) => [p.line, p.kind]));
  $("numbers").innerHTML = Array.from({ length: lines }, (_, k) => (marked.has(k + 1) ? `<b class="${marked.get(k + 1)}">${k + 1}</b>` : `${k + 1}`)).join("\n");
  $("case").rows = lines + 1;
}

function showProblems(problems) {
  numberLines(problems);
  $("problems").innerHTML = problems.map((p) =>
    `<li class="${p.kind === "error" ? "no" : "un"}">${p.line > 0 ? `<button type="button" data-line="${p.line}">line ${p.line}</button>` : ""}${escaped(p.message)}${p.help ? `; ${escaped(p.help)}` : ""}</li>`).join("");
}

function goToLine(number) {
  const lines = $("case").value.split("\n"), begin = lines.slice(0, number - 1).reduce((sum, line) => sum + line.length + 1, 0);
  $("case").focus();
  $("case").setSelectionRange(begin, begin + lines[number - 1].length);
  const editor = $("case").parentElement;
  editor.scrollTop = (editor.scrollHeight * (number - 1)) / lines.length - editor.clientHeight / 2;
}

function showPlan(plan, talk) {
  $("price").textContent = plan ? secondsRange(plan.seconds) : "–";
  $("price-more").textContent = plan ? `${planFacts(plan)}. Measured on this machine.` : "";
  $("start").disabled = !plan;
  $("stages").innerHTML = plan
    ? `<table><thead><tr><th>stage</th><th class="n">grains</th><th class="n">time</th></tr></thead><tbody>${plan.stages.map((s) =>
      `<tr><td>${escaped(`${s.study}/${s.stage}`)}<small>${escaped(s.verb)}</small></td><td class="n">${s.grains.toLocaleString("en")}</td><td class="n">${s.cached ? "in the cache" : secondsRange(s.seconds)}</td></tr>`).join("")}</tbody></table><ul class="cap">${list(plan.warnings ?? [])}</ul>`
    : `<p class="cap">${escaped((talk ?? []).join(" "))}</p>`;
}

/** Checks the case and prices it, when it has not changed for a while. */
const price = afterChanges(600, async (signal) => {
  if (!$("case").value.trim()) return;
  $("price").textContent = "…";
  try {
    const checked = await post("/api/check", caseFields(), signal);
    showProblems(checked.result.problems);
    const { result } = await post("/api/plan", caseFields(), signal);
    trouble();
    showPlan(result);
  } catch (error) {
    if (error.name === "AbortError") throw error;
    showPlan(null, error.problems.length ? [] : [error.message]);
    showProblems(error.problems.length ? error.problems : [{ kind: "error", line: 0, message: error.message }]);
  }
});

function take(text, files, name) {
  $("case").value = text;
  held.files = files;
  $("name").value = name;
  offerPresets(text);
  showProblems([]);
  price();
}

async function make() {
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
    trouble();
    $("made").innerHTML = list(talk.filter((line) => !line.startsWith("next:")));
    take(result.case, result.files, example || soil.curve.name.replace(/\.[^.]*$/, ""));
  } catch (error) {
    trouble(error);
    const isWhole = !example && soil.curve && way === "";
    $("made").innerHTML = isWhole ? list(["A soil that is too wide to simulate whole can be modeled in part, or by a surrogate: choose under Model it."]) : "";
  }
  $("make").disabled = false;
}

async function start() {
  $("start").disabled = true;
  $("start-note").textContent = "Starting …";
  try {
    const { run } = await post("/api/start", { name: $("name").value, ...caseFields() });
    trouble();
    $("start-note").innerHTML = `Started: <a href="#runs/${encodeURIComponent(run)}">${escaped(run)}</a>. It goes on if this page is closed.`;
    await view.show(run);
    $("live").scrollIntoView({ block: "start" });
  } catch (error) {
    trouble(error);
    $("start-note").textContent = "";
    if (error.problems?.length) showProblems(error.problems);
  }
  $("start").disabled = false;
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
  if (soil.curve && !$("case").value && !$("from").value) make();
}

export function connectSimulate() {
  view = new RunView($("live"));
  get("/api/examples").then(({ result }) => {
    $("from").innerHTML += result.map((name) => `<option value="${escaped(name)}">${escaped(name)}${titles[name] ? `: ${titles[name]}` : ""}</option>`).join("");
  }, trouble);
  for (const id of ["from", "way", "size-from", "size-to"]) $(id).addEventListener("input", showWay);
  $("make").addEventListener("click", make);
  $("start").addEventListener("click", start);
  $("preset").addEventListener("change", price);
  $("case").addEventListener("input", () => { numberLines(); offerPresets($("case").value); price(); });
  $("problems").addEventListener("click", (event) => event.target.dataset.line && goToLine(Number(event.target.dataset.line)));
}
