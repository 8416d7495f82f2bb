// A calibration under way: its rounds, the parameters after each, how near its samples came, and its curves.
import { escaped, three } from "./words.js";
import { seriesChart } from "./line_chart.js";

const keyName = (key) => key.replace(/^contact\./, "").replaceAll("_", " ").replace(/^void ratio\./, "void ratio of ");
const quantities = { stress_ratio: ["q/p₀", 1], volumetric_strain: ["volumetric strain [%]", 100], mean_stress_ratio: ["p′/p₀", 1], axial_strain: ["axial strain [%]", 100] };

/** A value in the unit of the case. */
const shown = (parameter, value) => `${three(value / parameter.unit_size)}${parameter.unit === "deg" ? "°" : parameter.unit ? ` ${parameter.unit}` : ""}`;
const interval = (parameter, { low, high }) => `${three(low / parameter.unit_size)} to ${shown(parameter, high)}`;

/** The answer as far as the folder holds it; nothing before the first round has ended. */
export async function readAnswer(name) {
  const response = await fetch(`/runs/${encodeURIComponent(name)}/calibration.json`);
  return response.ok ? response.json() : null;
}

/** How it ended: "" while nobody knows. @param last event of its last round */
export function outcomeOf(answer, last) {
  if (answer?.complete) return "done";
  if (last?.event !== "run ends") return "";
  return last.outcome === "time limit reached" ? last.outcome : "stopped"; // between two rounds, too
}

export function roundsTable(run) {
  const { rounds } = run.calibration;
  return `<table><caption>Rounds of samples; the intervals decide whether another one follows.</caption><thead><tr><th>round</th><th class="n">stages</th><th>state</th></tr></thead><tbody>${rounds.map((round, k) => {
    const isLast = k + 1 === rounds.length, state = !isLast ? ["ok", "✓ done"] : run.at_work ? ["", "at work"] : ["un", round.done === round.stages ? "done" : "stopped"];
    return `<tr><td>${escaped(round.name)}</td><td class="n">${round.done} of ${round.stages}</td><td class="${state[0]}">${state[1]}</td></tr>`;
  }).join("")}</tbody></table>`;
}

function parametersTable({ parameters, rounds }) {
  return `<table><caption>The fit so far: 90 % intervals after each round. Their validation: docs/how-to/calibrate.md.</caption><thead><tr><th>parameter</th><th class="n">likeliest</th>${rounds.map((_, k) => `<th class="n">round ${k + 1}</th>`).join("")}<th>verdict</th></tr></thead><tbody>${Object.entries(parameters).map(([key, p]) => {
    const bound = p.bound ? `, at its ${p.bound === "low" ? "lower" : "upper"} bound` : "";
    return `<tr><td>${escaped(keyName(key))}</td><td class="n">${escaped(shown(p, p.best))}</td>${rounds.map((round) => `<td class="n">${round.parameters?.[key] ? escaped(interval(p, round.parameters[key])) : ""}</td>`).join("")}<td class="${p.identified && !bound ? "ok" : "un"}">${p.identified ? "identified" : "not identified"}${bound}</td></tr>`;
  }).join("")}</tbody></table>`;
}

/** Samples of each test in the order of their design, and how far they are from it [%]. */
function misfitChart({ samples }, width) {
  const tests = new Map();
  for (const sample of samples) {
    if (sample.round === "held-out") continue;
    const all = tests.get(sample.target) ?? tests.set(sample.target, []).get(sample.target);
    all.push(sample.misfit);
  }
  const series = [...tests].map(([name, all]) => ({ name, dots: all.map((misfit, k) => [k + 1, 100 * misfit]).filter(([, y]) => Number.isFinite(y)) }));
  const failed = samples.filter((sample) => sample.failure !== undefined).length;
  return `<h3>Misfits of the samples</h3>${seriesChart(series, "sample of the test", "misfit [%]", { width, least: 1 })}${failed ? `<p class="cap">${failed} of ${samples.length} samples failed: that counts against their parameters.</p>` : ""}`;
}

/** The tests with the model at the likeliest parameters; those held out with their prediction. */
function fitCharts(answer) {
  return [...answer.fit, ...answer.held_out].flatMap((fit) => fit.curves.map((curve) => {
    const isOedometer = fit.axial_stress !== undefined, grid = isOedometer ? fit.axial_stress.map((v) => v / 1e3) : fit.axial_strain.map((v) => 100 * v);
    const [name, size] = quantities[curve.quantity] ?? [curve.quantity, 1], points = (values) => values.map((value, k) => [grid[k], size * value]);
    const title = `${fit.target}: misfit ${three(100 * curve.relative_misfit)} %`;
    const chart = seriesChart([{ name: "model", points: points(curve.model) }, { name: "laboratory", dots: points(curve.measured) }], isOedometer ? "axial stress [kPa]" : "axial strain [%]", name, { width: 300 });
    return `<figure><h3>${escaped(title)}</h3>${chart}</figure>`;
  })).join("");
}

/** What is known so far as HTML; empty before the first round has ended. */
export function fitSoFar(answer, width) {
  if (!answer) return "";
  return `<div class="tw">${parametersTable(answer)}</div>${answer.samples?.length ? misfitChart(answer, width) : ""}<div class="multiples">${fitCharts(answer)}</div>`;
}
