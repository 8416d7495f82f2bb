// The text of a case with its errors at their lines, its price, and its start: what the tabs Simulate and Sweep share.
import { $, escaped, secondsRange, trouble } from "./words.js";
import { afterChanges, post } from "./server.js";
import { planFacts } from "./run_view.js";

export class CaseEditor {
  /** @param prefix of the names of its elements @param planned what the plan shows as HTML @param changed is called with each text */
  constructor(prefix, planned, changed = () => {}) {
    this.at = (name) => $(prefix + name);
    this.planned = planned;
    this.changed = changed;
    this.files = {}; // what the case names
    this.origin = null; // what the text was written from
    this.plan = null; // of the text; none while it has errors
    this.isTyped = false; // and would be lost with the page
    this.price = afterChanges(600, (signal) => this.check(signal));
    this.at("preset").addEventListener("change", this.price);
    this.at("case").addEventListener("input", () => {
      this.isTyped = true;
      this.set(this.text);
    });
    window.addEventListener("beforeunload", (event) => this.isTyped && event.preventDefault());
    this.at("problems").addEventListener("click", (event) => event.target.dataset.line && this.goToLine(Number(event.target.dataset.line)));
  }

  get text() {
    return this.at("case").value;
  }

  /** Another text of the same case. */
  set(text) {
    if (this.text !== text) this.at("case").value = text;
    this.offerPresets();
    this.showProblems([]);
    this.changed(text);
    this.price();
  }

  /** Another case. @param origin what it was written from, as the caller understands it */
  take(text, files, name, origin = null) {
    this.files = files;
    this.origin = origin;
    this.isTyped = false;
    this.at("name").value = name;
    this.set(text);
  }

  fields() {
    const kept = (text) => ({ name: "kept", blob: new Blob([text]) }); // a form ends the lines of a mere text in another way
    return { case: kept(this.text), preset: this.at("preset").value, ...Object.fromEntries(Object.entries(this.files).map(([name, text]) => [`file:${name}`, kept(text)])) };
  }

  offerPresets() {
    const select = this.at("preset"), chosen = select.value, names = [...this.text.matchAll(/^\s*\[presets\.([\w-]+)\]/gm)].map((m) => m[1]);
    const all = [...new Set([...names, "standard"])];
    const named = this.text.match(/^\s*preset\s*=\s*"([\w-]+)"/m)?.[1] ?? "";
    select.innerHTML = `<option value="">as in the case${named ? `: ${escaped(named)}` : ""}</option>${all.map((name) => `<option>${escaped(name)}</option>`).join("")}`;
    select.value = chosen;
    if (select.selectedIndex < 0) select.value = "";
  }

  /** Numbers of the lines, those with problems marked; and the problems. */
  showProblems(problems) {
    const lines = this.text.split("\n").length, isHere = (p) => p.file === "case.toml" && p.line > 0; // not in its data
    const marked = new Map(problems.filter(isHere).map((p) => [p.line, p.kind]));
    this.at("numbers").innerHTML = Array.from({ length: lines }, (_, k) => (marked.has(k + 1) ? `<b class="${marked.get(k + 1)}">${k + 1}</b>` : `${k + 1}`)).join("\n");
    this.at("case").rows = lines + 1;
    this.at("problems").innerHTML = problems.map((p) =>
      `<li class="${p.kind === "error" ? "no" : "un"}">${isHere(p) ? `<button type="button" data-line="${p.line}">line ${p.line}</button>` : p.line > 0 ? `${escaped(p.file)}, line ${p.line}: ` : ""}${escaped(p.message)}${p.help ? `; ${escaped(p.help)}` : ""}</li>`).join("");
  }

  goToLine(number) {
    const lines = this.text.split("\n"), begin = lines.slice(0, number - 1).reduce((sum, line) => sum + line.length + 1, 0);
    const area = this.at("case"), editor = area.parentElement;
    area.focus();
    area.setSelectionRange(begin, begin + lines[number - 1].length);
    editor.scrollTop = (editor.scrollHeight * (number - 1)) / lines.length - editor.clientHeight / 2;
  }

  showPlan(plan, talk) {
    this.plan = plan;
    this.at("price").textContent = plan ? secondsRange(plan.seconds) : "–";
    this.at("price-more").textContent = plan ? `${planFacts(plan)}. Measured on this machine.` : "";
    if (!this.isStarting) this.at("start").disabled = !plan;
    this.at("stages").innerHTML = plan ? this.planned(plan) : `<p class="cap">${escaped((talk ?? []).join(" "))}</p>`;
  }

  /** Checks the case and prices it. */
  async check(signal) {
    if (!this.text.trim()) {
      this.showPlan(null);
      return;
    }
    this.at("price").textContent = "…";
    try {
      const checked = await post("/api/check", this.fields(), signal);
      this.showProblems(checked.result.problems);
      const { result } = await post("/api/plan", this.fields(), signal);
      trouble();
      this.showPlan(result.first_round ? { ...result.first_round, first: result.first_round, ...result } : result); // of a calibration: its samples are alike
    } catch (error) {
      if (error.name === "AbortError") throw error;
      if (error.status === 0) setTimeout(this.price, 5000); // a server that comes back
      this.showPlan(null, error.problems?.length ? [] : [error.message]);
      this.showProblems(error.problems?.length ? error.problems : [{ kind: "error", line: 0, message: error.message }]);
    }
  }

  /** Requests something of the case; an error is shown at its line. @return the answer; nothing after an error */
  async request(path, more, button) {
    button.disabled = true;
    try {
      const answer = await post(path, { name: this.at("name").value, ...this.fields(), ...more });
      trouble();
      return answer;
    } catch (error) {
      trouble(error);
      if (error.problems?.length) this.showProblems(error.problems);
      return null;
    } finally {
      button.disabled = false;
    }
  }

  /** Starts it as a run. @return the run's name; nothing where it could not be started */
  async start(tab, more = {}) {
    const note = this.at("start-note");
    note.textContent = "Starting …";
    this.isStarting = true; // a price that comes meanwhile starts no second run
    const answer = await this.request("/api/start", more, this.at("start"));
    this.isStarting = false;
    this.at("start").disabled = !this.plan;
    if (answer) this.isTyped = false;
    note.innerHTML = answer ? `Started: <a href="#${tab}/${encodeURIComponent(answer.run)}">${escaped(answer.run)}</a>. It goes on if this page is closed.` : escaped($("trouble").textContent.split("\n")[0]); // the top of the page is out of sight here
    return answer?.run;
  }
}
