// A laboratory test as a form of its case: its keys are those of `suffuse schema`, and what is filled in becomes a stage.
import { $, escaped, trouble } from "./words.js";
import { get } from "./server.js";
import { asToml, listToml, stageText, stagesOf, studiesOf, withStage } from "./case_text.js";

const verbs = ["triaxial", "plane-strain", "oedometer", "isotropic", "shear", "cyclic"];
const ofComputation = new Set(["axis", "axes", "inertial_number", "inertia", "time_step", "rows"]);
let keys = [], editor;

const usual = (key) => key.default.replaceAll('"', "");

function inputOf(key) {
  const id = `test-key-${key.name}`, choices = key.choices.length && !key.is_list ? key.choices : null, about = `${id}-about`, rest = `id="${id}" data-key="${escaped(key.name)}" aria-describedby="${about}"`;
  const input = choices
    ? `<select ${rest}><option value="">${key.default ? `as usual: ${escaped(usual(key))}` : "not given"}</option>${choices.map((choice) => `<option>${escaped(choice)}</option>`).join("")}</select>`
    : `<input ${rest} spellcheck="false" placeholder="${escaped(usual(key))}"${key.required ? " required" : ""}>`;
  const form = choices ? "" : key.is_list ? " Several, with commas between them." : "";
  return `<div class="in"><label for="${id}">${escaped(key.name.replaceAll("_", " "))}${key.required ? ", needed" : ""}</label>${input}<p id="${about}" class="cap">${escaped(key.text)} ${choices ? "" : `${escaped(key.value[0].toUpperCase() + key.value.slice(1))}.`}${form}</p></div>`;
}

const keysOfTest = () => keys.filter((key) => key.table === `stage.${$("test-verb").value}` && !key.is_table);

/** The keys of the test that is chosen. */
function showKeys() {
  const own = keysOfTest(), html = (some) => some.map(inputOf).join("");
  $("test-keys").innerHTML = `${html(own.filter((key) => !ofComputation.has(key.name)))}<details><summary>Axes, speed and rows</summary>${html(own.filter((key) => ofComputation.has(key.name)))}</details>`;
  nameIt();
}

/** A name that no stage of the case has. */
function nameIt() {
  const taken = new Set(stagesOf(editor.text, $("test-study").value).map((stage) => stage.name)), verb = $("test-verb").value;
  let name = verb;
  for (let k = 2; taken.has(name); ++k) name = `${verb}-${k}`;
  $("test-name").value = name;
}

/** The studies and stages of the text: a test starts from a compacted or eroded sample. */
export function offerTests(text) {
  const study = $("test-study"), chosen = study.value, from = $("test-from"), kept = from.value;
  study.innerHTML = studiesOf(text).map((name) => `<option${name === chosen ? " selected" : ""}>${escaped(name)}</option>`).join("");
  const stages = stagesOf(text, study.value).filter((stage) => stage.verb !== "pack");
  from.innerHTML = stages.map((stage) => `<option value="${escaped(stage.name)}">${escaped(stage.name)}: ${escaped(stage.verb)}</option>`).join("");
  const usualStage = stages.findLast((stage) => ["compact", "erode", "remove", "settle", "import"].includes(stage.verb)) ?? stages.at(-1);
  from.value = stages.some((stage) => stage.name === kept) ? kept : usualStage?.name ?? "";
  $("test-add").disabled = !stages.length;
  nameIt();
}

function add() {
  try {
    const entries = [["name", JSON.stringify($("test-name").value)], ["from", JSON.stringify($("test-from").value)], ["do", JSON.stringify($("test-verb").value)]];
    for (const key of keysOfTest()) {
      const value = $(`test-key-${key.name}`).value.trim();
      if (key.required && !value) throw new Error(`The test needs its ${key.name}.`);
      if (value) entries.push([key.name, key.is_list ? listToml(value) : asToml(value)]);
    }
    const { text, line } = withStage(editor.text, $("test-study").value, stageText($("test-study").value, entries));
    editor.set(text);
    editor.goToLine(line);
    trouble();
    $("test-note").textContent = `Added to the case, at line ${line}.`;
  } catch (error) {
    trouble(error);
  }
}

/** @param caseEditor of the case that tests are added to */
export async function connectTests(caseEditor) {
  editor = caseEditor;
  $("test-verb").innerHTML = verbs.map((verb) => `<option>${verb}</option>`).join("");
  $("test-verb").addEventListener("change", showKeys);
  $("test-study").addEventListener("change", () => offerTests(editor.text));
  $("test-add").addEventListener("click", add);
  $("tests").addEventListener("toggle", async () => { // the keys are needed only then
    if (keys.length || !$("tests").open) return;
    try {
      keys = (await get("/api/keys")).result.keys;
      showKeys();
    } catch (error) {
      trouble(error);
    }
  });
}
