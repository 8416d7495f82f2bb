// The samples of a sweep as a table and as small charts, from what has come in. Names and numbers are the run's.
import { escaped, three } from "./words.js";
import { seriesChart } from "./line_chart.js";

/** What a reader looks for first, the most telling number first. */
const headlines = [
  "critical_gradient.1 %", "critical_gradient.10 %", "response.friction_angle", "response.peak_deviator", "eroded_mass_percent_of_initial", "eroded_mass_share",
  "peak_stress_ratio", "compression_index", "k0", "cycles_to_liquefaction", "permeability_along", "permeability", "void_ratio", "coordination",
];
const hidden = new Set(["checksums", "steps", "time_step", "wall_seconds", "particle_steps_per_second", "inertial_number_max"]);
const most = { columns: 3, numbers: 200 };

/** A sample by its folder: STUDY[/KEY=VALUE][/rep=N], as docs/formats.md has it. */
export function sampleOf(folder) {
  const [study, ...rest] = folder.split("/"), pairs = rest.map((part) => [part.slice(0, part.indexOf("=")), part.slice(part.indexOf("=") + 1)]);
  return { folder, study, values: pairs.filter(([key]) => key !== "rep"), replicate: pairs.find(([key]) => key === "rep")?.[1] ?? "1" };
}

const split = (path) => [path.slice(0, path.lastIndexOf("/")), path.slice(path.lastIndexOf("/") + 1)];

/** The samples of a run, those planned and those that were added, each with its stages and which of them are done. */
export function samplesOf(run) {
  const all = new Map(), of = (folder) => all.get(folder) ?? all.set(folder, { ...sampleOf(folder), stages: [], done: new Set() }).get(folder);
  for (const stage of run.plan?.stages ?? []) of(stage.study).stages.push(stage.stage);
  for (const path of run.done ?? []) {
    const [folder, stage] = split(path), sample = of(folder);
    if (!sample.stages.includes(stage)) sample.stages.push(stage);
    sample.done.add(stage);
  }
  return [...all.values()];
}

export const isSweep = (samples) => samples.length > 1;

/** The numbers of a stage by their paths, as in "critical_gradient.1 %". */
export function numbersOf(stage, path = "", found = new Map()) {
  for (const [key, value] of Object.entries(stage ?? {})) {
    const name = path + key;
    if (found.size >= most.numbers || hidden.has(name)) continue;
    if (typeof value === "number") found.set(name, value);
    else if (value && typeof value === "object" && !Array.isArray(value) && path.split(".").length < 4) numbersOf(value, `${name}.`, found);
  }
  return found;
}

/** Those shown unless others were chosen. */
export const firstNumbers = (names) => headlines.filter((name) => names.includes(name)).slice(0, most.columns);

/** A number in the unit in which it is read, and that unit. */
export function inUnit(value, unit) {
  const [factor, name] = { rad: [180 / Math.PI, "°"], Pa: [1e-3, "kPa"] }[unit] ?? [1, unit === "-" ? "" : unit ?? ""];
  return [value * factor, name];
}

export const numberName = (name) => name.replace(/^response\./, "").replaceAll("_", " ").replace(/\./g, ", ");
const title = (name, units) => { const [, unit] = inUnit(1, units(name)); return numberName(name) + (unit ? ` [${unit}]` : ""); };
const keyName = (key) => (key === "fc" ? "fines content [%]" : key.replaceAll("_", " "));
const leading = (text) => text.match(/^[+-]?\d+(\.\d+)?(e[+-]?\d+)?/i)?.[0];
const keyOf = (sample, without = -1) => sample.values.filter((_, k) => k !== without).map(([key, value]) => `${key} ${value}`).join(", ");

/** Lines of one number over the first key: one for each set of the other values, its dots each sample. */
function linesOf(samples, measure, names) {
  const lines = new Map();
  for (const sample of samples) {
    const y = measure(sample), text = sample.values[0]?.[1];
    const x = names ? names.indexOf(text) : Number(leading(text ?? ""));
    if (!Number.isFinite(y) || !Number.isFinite(x) || x < 0) continue;
    const name = keyOf(sample, 0), line = lines.get(name) ?? lines.set(name, { name, dots: [] }).get(name);
    line.dots.push([x, y]);
  }
  for (const line of lines.values()) {
    const at = Map.groupBy ? Map.groupBy(line.dots, (dot) => dot[0]) : line.dots.reduce((map, dot) => map.set(dot[0], [...(map.get(dot[0]) ?? []), dot]), new Map());
    line.points = [...at].map(([x, dots]) => [x, dots.reduce((sum, dot) => sum + dot[1], 0) / dots.length]).sort((a, b) => a[0] - b[0]);
  }
  return [...lines.values()];
}

/**
 * A chart of each number over the first swept key.
 * @param runs [{ name, samples, measure(sample, number) }, ...]: the sweep, and the run it is compared with
 */
export function charts(runs, numbers, units) {
  const swept = runs.flatMap((run) => run.samples).filter((sample) => sample.values.length), key = swept[0]?.values[0][0];
  if (!key) return "";
  const texts = [...new Set(swept.map((sample) => sample.values[0][1]))], isNumber = texts.every((text) => leading(text) !== undefined);
  const unit = isNumber ? texts[0].slice(leading(texts[0]).length) : "";
  return numbers.map((number) => {
    const scale = (sample, run) => inUnit(run.measure(sample, number), units(number))[0];
    const series = runs.flatMap((run) => {
      const level = run.samples.length === 1 && !run.samples[0].values.length ? scale(run.samples[0], run) : undefined;
      if (level !== undefined) return [{ name: run.name, level }];
      return linesOf(run.samples, (sample) => scale(sample, run), isNumber ? null : texts)
        .map((line) => ({ ...line, name: [runs.length > 1 && run.name, line.name].filter(Boolean).join(": ") || run.name }));
    });
    const chart = seriesChart(series, keyName(key) + (unit ? ` [${unit}]` : ""), title(number, units), { names: isNumber ? [] : texts, width: 300 });
    return chart && `<figure>${chart}</figure>`;
  }).join("");
}

/** @param state(sample) -> [class, text] @param other nothing, or a run like those of `charts` */
export function table(run, numbers, units, state, other = null) {
  const keys = [...new Set(run.samples.flatMap((sample) => sample.values.map(([key]) => key)))], hasSeeds = run.samples.some((sample) => sample.replicate !== "1");
  const studies = new Set(run.samples.map((sample) => sample.study)).size > 1;
  const twins = new Map((other?.samples ?? []).map((sample) => [`${keyOf(sample)} ${sample.replicate}`, sample]));
  const hasTwins = run.samples.some((sample) => twins.has(`${keyOf(sample)} ${sample.replicate}`));
  const about = !other ? "" : hasTwins ? ` Small numbers: ${other.name}, at the same values.` : ` ${other.name} has no sample with these values; the charts show it.`;
  const shown = (value, number) => (Number.isFinite(value) ? three(inUnit(value, units(number))[0]) : "–");
  const cell = (sample, number) => {
    const twin = twins.get(`${keyOf(sample)} ${sample.replicate}`);
    return `<td class="n">${shown(run.measure(sample, number), number)}${twin ? `<small>${shown(other.measure(twin, number), number)}</small>` : ""}</td>`;
  };
  const heads = [...(studies ? ["study"] : []), ...keys.map(keyName), ...(hasSeeds ? ["replicate"] : [])];
  return `<table><caption>${run.samples.filter((sample) => Number.isFinite(numbers.length ? run.measure(sample, numbers[0]) : NaN)).length} of ${run.samples.length} samples have come in.${escaped(about)}</caption><thead><tr>${heads.map((head) => `<th scope="col">${escaped(head)}</th>`).join("")}${numbers.map((number) => `<th scope="col" class="n">${escaped(title(number, units))}</th>`).join("")}<th scope="col">state</th></tr></thead><tbody>${run.samples.map((sample) => {
    const [kind, text] = state(sample), values = new Map(sample.values);
    const cells = [...(studies ? [sample.study] : []), ...keys.map((key) => values.get(key) ?? ""), ...(hasSeeds ? [sample.replicate] : [])];
    return `<tr>${cells.map((value) => `<td>${escaped(value)}</td>`).join("")}${numbers.map((number) => cell(sample, number)).join("")}<td class="${kind}">${escaped(text)}</td></tr>`;
  }).join("")}</tbody></table>`;
}
