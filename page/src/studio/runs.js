// The tab Runs: all runs of the folder, what each found, its report, and two compared.
import { $, escaped, seconds, trouble } from "./words.js";
import { get } from "./server.js";
import { compareRuns } from "./compare_view.js";
import { RunView } from "./run_view.js";

let runs = [], chosen = new Set(), view, current = "", comparison;

const matches = (run, words) => {
  const text = [run.name, run.title, run.state, ...run.verdict].join(" ").toLowerCase();
  return words.every((word) => text.includes(word));
};

/** "2026-11-30 12:05" where the reader is; runs have the time of Greenwich. */
const localTime = (text) => new Date(text).toLocaleString("sv").slice(0, 16);

function draw() {
  const words = $("search").value.toLowerCase().split(/\s+/).filter(Boolean), shown = runs.filter((run) => matches(run, words));
  $("count").textContent = shown.length === runs.length ? `${runs.length} ${runs.length === 1 ? "run" : "runs"}` : `${shown.length} of ${runs.length} runs`;
  $("run-table").tBodies[0].innerHTML = shown.map((run) =>
    `<tr${run.name === current ? ' aria-current="true"' : ""}><td><input type="checkbox" data-run="${escaped(run.name)}" aria-label="compare ${escaped(run.name)}"${chosen.has(run.name) ? " checked" : ""}></td><td><a href="#runs/${encodeURIComponent(run.name)}">${escaped(run.name)}</a><small>${escaped(run.title)}</small><small>${escaped(run.verdict[0] ?? "")}</small></td><td>${escaped(run.state)}<small>${run.finished ? `${escaped(localTime(run.finished))}` : ""}${run.wall_seconds ? `, ${seconds(run.wall_seconds)}` : ""}</small></td></tr>`).join("");
  $("compare").disabled = chosen.size !== 2;
}

export async function loadRuns() {
  try {
    if (!runs.length) { // what they found takes longer to read than what they are called
      runs = (await get("/api/names")).result.map((name) => ({ name, title: "", state: "…", verdict: [], finished: "", wall_seconds: 0 }));
      draw();
    }
    runs = (await get("/api/runs")).result.runs;
    const names = new Set(runs.map((run) => run.name));
    chosen = new Set([...chosen].filter((name) => names.has(name)));
    trouble();
    draw();
  } catch (error) {
    trouble(error);
  }
}

async function compare() {
  const [one, other] = [...chosen];
  showNone();
  const own = comparison = {}; // until a run is opened, or other two are compared
  draw();
  $("run").innerHTML = "<p class=\"cap\">Comparing …</p>";
  try {
    const differences = await compareRuns(one, other);
    if (comparison !== own) return;
    $("run").innerHTML = differences;
    trouble();
  } catch (error) {
    if (comparison !== own) return;
    $("run").innerHTML = "";
    trouble(error);
  }
}

/** Shows no run. The address names none either, so that a link to the run before is a change. */
function showNone() {
  current = "";
  view.close();
  $("run").innerHTML = "<p class=\"cap\">Choose a run.</p>";
  history.replaceState(null, "", "#runs");
}

/** A run has ended, or is gone. */
function changed() {
  if (!view.name) showNone();
  loadRuns();
}

/** Opens the tab, and a run where one is named. */
export function openRuns(name) {
  loadRuns();
  if (name === current) return;
  current = name;
  comparison = null;
  if (name) view.show(name);
  else showNone();
  draw();
}

export function connectRuns() {
  view = new RunView($("run"), changed);
  $("search").addEventListener("input", draw);
  $("compare").addEventListener("click", compare);
  $("run-table").addEventListener("change", (event) => {
    const { run } = event.target.dataset;
    if (event.target.checked) chosen.add(run);
    else chosen.delete(run);
    $("compare").disabled = chosen.size !== 2;
  });
}
