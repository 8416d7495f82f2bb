// One sweep: its samples as they come in, as a table and as small charts, next to those of another run.
import { escaped, seconds } from "./words.js";
import { get, runPath } from "./server.js";
import { RunView, measure } from "./run_view.js";
import { charts, firstNumbers, numberName, numbersOf, samplesOf, table } from "./sweep_table.js";

let units; // of all results, as `suffuse schema --results` lists them

async function learnUnits() {
  units ??= get("/api/results").then(({ result }) => new Map(result.results.map((fact) => [fact.key, fact.unit])));
  return units;
}

/** The unit of a number by its path: of the whole of it, of its end, of its beginning. */
const unitIn = (known) => (path) => {
  const parts = path.split(".");
  for (let k = 0; k < parts.length; ++k) {
    const unit = known.get(parts.slice(k).join("."));
    if (unit !== undefined) return unit;
  }
  return known.get(parts[0]) ?? "";
};

export class SweepView extends RunView {
  constructor(place, changed) {
    super(place, changed);
    this.parts = ["stages tw", "charts", "grains"];
  }

  show(name) {
    if (name !== this.name) {
      this.stage = "";
      this.numbers = null;
      this.other = null;
      this.compared = "";
    }
    this.latest = null;
    this.drawn = "";
    return super.show(name);
  }

  close() {
    this.latest = null;
    super.close();
  }

  /** Compares it with another run; with none for "". */
  async compareWith(name) {
    this.other = null;
    this.compared = name;
    if (name) {
      const run = await get(runPath(name)), measured = new Map();
      await measure(run, measured);
      if (this.compared !== name) return; // another one was chosen meanwhile
      this.other = { name, samples: samplesOf(run), measured };
    }
    if (this.latest) this.body(this.latest.run, this.latest.facts);
  }

  async learn(run) {
    this.unit = unitIn(await learnUnits());
    await super.learn(run);
  }

  body(run, facts) {
    this.latest = { run, facts };
    const samples = samplesOf(run), stages = [...new Set(samples.flatMap((sample) => sample.stages))];
    if (!stages.includes(this.stage)) this.stage = stages.at(-1) ?? "";
    const measureIn = (measured) => (sample, number) => numbersOf(measured.get(`${sample.folder}/${this.stage}`)).get(number) ?? NaN;
    const mine = { name: run.name, samples, measure: measureIn(this.measured) };
    const other = this.other && { ...this.other, measure: measureIn(this.other.measured) };
    const all = [...new Set(samples.flatMap((sample) => [...numbersOf(this.measured.get(`${sample.folder}/${this.stage}`)).keys()]))];
    const numbers = (this.numbers ?? firstNumbers(all)).filter((name) => all.includes(name));
    this.find(".charts").innerHTML = `<div class="multiples">${charts([mine, ...(other ? [other] : [])], numbers, this.unit)}</div>`;
    this.find(".stages").innerHTML = table(mine, numbers, this.unit, (sample) => this.stateOf(sample, run, facts), other);
    this.choices(stages, all, numbers);
  }

  stateOf(sample, run, { failed }) {
    const failure = sample.stages.map((stage) => failed.get(`${sample.folder}/${stage}`)).find((what) => what !== undefined);
    if (failure !== undefined) return ["no", `✗ failed: ${failure}`];
    if (sample.stages.length && sample.stages.every((stage) => sample.done.has(stage))) return ["ok", "✓ done"];
    const now = run.at_work && run.progress?.running.find((one) => one.study === sample.folder);
    if (now) return ["", `${now.stage}${now.part ? `, ${now.part}` : ""}, ${seconds(now.stage_seconds)}`];
    return ["un", sample.done.size ? `${sample.done.size} of ${sample.stages.length} stages` : "waits"];
  }

  /** The stage and its numbers to choose from; drawn anew only where they change, so that focus stays. */
  choices(stages, all, numbers) {
    const key = JSON.stringify([stages, this.stage, all]);
    if (this.drawn === key) return;
    this.drawn = key;
    this.find(".report").innerHTML = `<div class="pair"><label class="in">Numbers of the stage <select data-choice="stage">${stages.map((stage) => `<option${stage === this.stage ? " selected" : ""}>${escaped(stage)}</option>`).join("")}</select></label></div>
<details${this.isOpen ? " open" : ""}><summary>Choose the numbers that are shown</summary><div class="choices">${all.map((name) => `<label><input type="checkbox" value="${escaped(name)}"${numbers.includes(name) ? " checked" : ""}> ${escaped(numberName(name))}</label>`).join("")}</div></details>`;
    this.find(".report details").addEventListener("toggle", () => { this.isOpen = this.find(".report details").open; });
    this.find("[data-choice]").addEventListener("change", (event) => {
      this.stage = event.target.value;
      this.numbers = null;
      this.body(this.latest.run, this.latest.facts);
      this.find("[data-choice]").focus();
    });
    for (const box of this.place.querySelectorAll(".choices input")) {
      box.addEventListener("change", () => {
        this.numbers = [...this.place.querySelectorAll(".choices input:checked")].map((one) => one.value);
        this.body(this.latest.run, this.latest.facts);
      });
    }
  }

  moreButtons(run) {
    return [!run.at_work && run.report && ["read", "Read the report"]];
  }

  async act(what, button) {
    if (what !== "read") return super.act(what, button);
    location.hash = `#runs/${encodeURIComponent(this.name)}`;
    return undefined;
  }
}
