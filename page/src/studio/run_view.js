// One run: live while it works, with what its stages measure; its report when it has ended.
import { bytes, escaped, seconds, secondsRange, three, trouble } from "./words.js";
import { get, post, runPath } from "./server.js";
import { fitSoFar, outcomeOf, readAnswer, roundsTable } from "./calibration_view.js";
import { GrainsView } from "./grains_view.js";
import { curveSoFar } from "./curve_so_far.js";
import { lineChart, seriesChart } from "./line_chart.js";

const names = {
  void_ratio: "void ratio", mean_stress: "mean stress [kPa]", deviator_stress: "deviator stress [kPa]", unbalanced_force: "unbalanced force", axial_strain: "axial strain",
};
const mobilityAxes = ["gradient i", "mass of the fines that moves [%]"];
const pointOf = (row) => [row.gradient, 100 * row.mobile_mass_share];
const nameOf = (key) => names[key] ?? key.replaceAll("_", " ");

/** Reads the numbers of finished stages that are not among those measured, a few at a time. */
export async function measure(run, measured) {
  const fresh = run.done.filter((stage) => !measured.has(stage)), atOnce = 6;
  for (let k = 0; k < fresh.length; k += atOnce) {
    await Promise.all(fresh.slice(k, k + atOnce).map(async (stage) => {
      const path = `/runs/${encodeURIComponent(run.name)}/studies/${stage.split("/").map(encodeURIComponent).join("/")}/stage.json`;
      measured.set(stage, await fetch(path).then((r) => (r.ok ? r.json() : null)).catch(() => null));
    }));
  }
}

export class RunView {
  /** @param place the element it fills @param changed is called when the run has ended or gone */
  constructor(place, changed = () => {}) {
    this.place = place;
    this.changed = changed;
    this.name = "";
    this.parts = ["charts", "grains", "stages tw"]; // of the run, one below the other
  }

  /** Shows a run, and follows it while it works. */
  show(name) {
    clearTimeout(this.timer);
    this.name = name;
    this.seen = new Map(); // stage -> states that were polled
    this.measured = new Map(); // stage -> numbers of its stage.json
    this.answer = null; // of a calibration
    this.answered = null; // when that was written
    this.isReportShown = false;
    this.hasWorked = false;
    this.place.innerHTML = `<div class="live"><h2 tabindex="-1">${escaped(name)}</h2><div class="state"></div><p class="hidden heard" role="status"></p><p class="buttons"></p><p class="cap printed" role="status"></p>${this.parts.map((part) => `<div class="${part}"></div>`).join("")}</div><div class="report"></div>`;
    this.grains?.close();
    this.grains = new GrainsView(this.find(".grains"), name);
    return this.poll();
  }

  close() {
    clearTimeout(this.timer);
    this.grains?.close();
    this.name = "";
    this.place.innerHTML = "";
  }

  async poll() {
    clearTimeout(this.timer);
    const { name } = this;
    if (!name) return;
    try {
      const run = await get(runPath(name));
      if (this.name !== name) return;
      await this.learn(run);
      if (this.name !== name) return;
      this.draw(run);
      if (this.hasWorked && !run.at_work) this.changed();
      this.hasWorked = run.at_work;
      if (run.at_work) this.timer = setTimeout(() => this.poll(), document.hidden ? 5000 : 1000);
    } catch (error) {
      if (this.name !== name) return;
      trouble(error);
      if (error.status === 404) this.place.innerHTML = `<p class="cap">${escaped(`There is no run ${name} in this folder (any more).`)}</p>`;
      if (!error.status) this.timer = setTimeout(() => this.poll(), 5000); // a server that comes back
    }
  }

  async learn(run) {
    for (const one of run.progress?.running ?? []) {
      if (!one.state) continue;
      const key = `${one.study}/${one.stage}`, states = this.seen.get(key) ?? [];
      if (states.at(-1)?.steps !== one.steps) states.push({ steps: one.steps, ...one.state, verb: one.verb });
      this.seen.set(key, states);
    }
    await measure(run, this.measured);
    if (run.calibration && run.calibration.answered !== this.answered) {
      this.answer = await readAnswer(run.name);
      this.answered = run.calibration.answered;
    }
  }

  draw(run) {
    const { progress, events } = run, last = events.at(-1);
    const begun = events.findLastIndex((e) => e.event === "run begins");
    const done = new Map(events.filter((e) => e.event === "stage done").map((e) => [e.stage, e.wall_seconds]));
    const failed = new Map(events.slice(begun + 1).filter((e) => e.event === "stage fails").map((e) => [e.stage, e.what ?? ""]));
    const running = new Set((progress?.running ?? []).map((p) => `${p.study}/${p.stage}`));
    const outcome = run.calibration ? (run.at_work ? "" : outcomeOf(this.answer, last)) : last?.event === "run ends" ? last.outcome : "";
    const round = run.calibration?.rounds.at(-1)?.name;
    const latest = progress?.latest;
    const share = latest?.stages ? latest.stages_done / latest.stages : 0;
    this.find(".state").innerHTML = run.at_work
      ? `<progress value="${share}" aria-label="stages done"></progress><div class="facts">${round ? `<span>round <b>${escaped(round)}</b></span>` : ""}<span>stages <b>${latest?.stages_done ?? 0} of ${latest?.stages ?? "?"}</b></span><span>left <b>${progress ? secondsRange(progress.seconds_left) : "–"}</b></span><span>at work for <b>${seconds(latest?.run_seconds ?? 0)}</b></span></div><p class="cap">${escaped([latest?.stage, latest?.part].filter(Boolean).join(": "))}</p>`
      : `<p class="cap">${outcome ? `Ended: ${escaped(outcome)}${run.calibration ? "" : `, after ${seconds(last.wall_seconds)}`}.` : run.tasks && !last ? "Its samples are tasks of a cluster. Gather what they have left." : "Nobody works on this run and it has not ended: it was killed, or an error ended it. Resume it."}</p>${run.last_words && ["", "failed in part"].includes(outcome) ? `<details open><summary>The last that it printed</summary><pre class="talk" tabindex="0" aria-label="The last that it printed">${escaped(run.last_words)}</pre></details>` : ""}`;
    const heard = run.at_work ? ["At work", round, latest?.stage].filter(Boolean).join(": ") : this.find(".state .cap").textContent;
    if (this.find(".heard").textContent !== heard) this.find(".heard").textContent = heard; // is read aloud: not each second
    this.grains.isAtWork = run.at_work;
    this.buttons(run, outcome);
    this.body(run, { done, failed, running });
  }

  /** What is below the buttons: the stages and what they measure; the report in their place when it is there. */
  body(run, { done, failed, running }) {
    const isOver = !run.at_work, isReported = isOver && run.report;
    this.find(".grains").hidden = isReported; // the report has its own view
    const stages = run.plan?.stages ?? [];
    const state = (key) => (failed.has(key) ? ["no", "✗ failed"] : done.has(key) ? ["ok", `✓ ${seconds(done.get(key))}`] : running.has(key) && run.at_work ? ["", "at work"] : ["un", "waits"]);
    if (!isReported && run.calibration) {
      this.find(".stages").innerHTML = roundsTable(run);
      this.find(".charts").innerHTML = fitSoFar(this.answer, this.place.clientWidth);
    } else if (!isReported) {
      this.find(".stages").innerHTML = `<table><thead><tr><th>stage</th><th>does</th><th class="n">planned</th><th>state</th></tr></thead><tbody>${stages.map((s) => {
        const key = `${s.study}/${s.stage}`, [kind, text] = state(key);
        return `<tr><td>${escaped(key)}<small>${escaped(failed.get(key) ?? "")}</small></td><td>${escaped(s.verb)}</td><td class="n">${secondsRange(s.seconds)}</td><td class="${kind}">${text}</td></tr>`;
      }).join("")}</tbody></table>`;
      this.charts(running);
    }
    if (isReported && !this.isReportShown) {
      this.isReportShown = true;
      this.find(".stages").innerHTML = "";
      this.find(".charts").innerHTML = "";
      const frame = document.createElement("iframe");
      frame.setAttribute("sandbox", "allow-scripts allow-downloads");
      frame.title = `Report of ${run.name}`;
      frame.src = `/runs/${encodeURIComponent(run.name)}/report.html`;
      this.find(".report").replaceChildren(frame);
    } else if (!isOver && this.isReportShown) {
      this.isReportShown = false;
      this.find(".report").replaceChildren();
    }
  }

  /** What the stages at work measure, and the mobility that one has found. */
  charts(running) {
    const parts = [], width = this.place.clientWidth;
    for (const [key, states] of this.seen) {
      if (!running.has(key)) continue;
      const latest = states.at(-1);
      if (Array.isArray(latest.mobility) && latest.held) {
        const held = pointOf(latest.held), points = latest.mobility.map(pointOf);
        parts.push(`<h3>${escaped(key)}: i = ${three(held[0])} is held</h3>`, seriesChart([{ points, dots: [...points, held] }], ...mobilityAxes, { width, least: 1 }));
        continue;
      }
      const { x, y, points } = curveSoFar(states), chart = lineChart(points, nameOf(x), nameOf(y), { width });
      if (chart) parts.push(`<h3>${escaped(key)}</h3>`, chart);
    }
    for (const [key, numbers] of this.measured) {
      const rows = numbers?.mobility;
      if (!Array.isArray(rows) || rows.length < 2 || numbers.verb !== "detach") continue;
      const at = numbers.critical_gradient?.["1 %"];
      parts.push(`<h3>${escaped(key)}: ${at ? `1 % of the fines move at i = ${three(at)}` : "less than 1 % of the fines move"}</h3>`,
        lineChart(rows.map(pointOf), ...mobilityAxes, { width, least: 1 }));
    }
    this.find(".charts").innerHTML = parts.join("");
  }

  moreButtons() {
    return [];
  }

  buttons(run, outcome) {
    const isResumable = !run.at_work && ["", "stopped", "time limit reached", "failed in part"].includes(outcome);
    const wanted = [
      run.can_stop && ["stop", "Stop and save"], run.tasks && !run.at_work && ["collect", "Gather the tasks"], isResumable && ["resume", "Resume"], !run.at_work && run.report && outcome && ["pdf", "PDF of the report"],
      ...this.moreButtons(run), !run.at_work && run.report && ["open", "Open the report alone"], run.can_delete && ["delete", "Delete …"],
    ].filter(Boolean);
    const key = JSON.stringify(wanted);
    if (this.find(".buttons").dataset.shown === key) return; // so that focus stays
    this.find(".buttons").dataset.shown = key;
    this.find(".buttons").innerHTML = wanted.map(([what, text]) => `<button type="button" data-do="${what}">${text}</button>`).join("");
    for (const button of this.place.querySelectorAll("[data-do]")) button.addEventListener("click", () => this.act(button.dataset.do, button));
  }

  async act(what, button) {
    const { name } = this, report = `/runs/${encodeURIComponent(name)}/report`;
    if (what === "open") {
      window.open(`${report}.html`, "_blank", "noopener");
      return;
    }
    if (what === "delete" && !window.confirm(`Delete the run ${name} with all its results? This cannot be undone. Its case stays in cases/${name}.`)) return;
    button.disabled = true;
    const printed = this.find(".printed");
    printed.textContent = what === "pdf" ? "Printing …" : "";
    try {
      await post(`${runPath(name)}/${what}`);
      trouble();
      if (what === "pdf") printed.innerHTML = `Printed: <a href="${report}.pdf" target="_blank" rel="noopener">report.pdf</a>`; // browsers block a window that opens by itself so late
      if (what === "delete") {
        this.close();
        this.changed();
      } else if (what === "resume" || what === "collect") {
        await this.show(name);
        this.changed();
      }
      button.disabled = what === "stop"; // a run that saves itself takes its time
    } catch (error) {
      trouble(error);
      printed.textContent = "";
      button.disabled = false;
      if (this.name === name && error.status) await this.poll(); // another tab or program has changed it
    }
  }

  find(what) {
    return this.place.querySelector(what);
  }
}

export const planFacts = (plan) => `${bytes(plan.memory)} of memory, ${bytes(plan.disk)} on disk, ${plan.stages.length} stages`;
