// A sweep and a further stage as they are written into the text of a case.
import assert from "node:assert/strict";
import { test } from "node:test";
import { filesByName, keysOf, listToml, stageText, stagesOf, studiesOf, sweepLine, valuesOf, withStage, withSweep } from "../src/studio/case_text.js";

const text = `[contact]
law      = "linear-rolling"
friction = "37 deg"

[soil.sand]
psd   = "sand.csv"
fines = { finer_than = "0.2 mm" }

[study.main]
soil  = "sand"
sweep = {
  "contact.friction" = ["1 deg", "2 deg"], # [ and { in a comment
}
replicates = 2

[[study.main.stage]]
name = "initial"
do   = "compact"
pressure = "100 kPa"

[study."other"]
soil = "sand"
`;

test("what can be swept is what the case has", () => {
  assert.deepEqual(studiesOf(text), ["main", "other"]);
  assert.deepEqual(keysOf(text, "main"), ["particles", "fines_content", "contact.friction", "fines", "stage.initial.pressure"]);
  assert.ok(!keysOf(text, "other").some((key) => key.startsWith("stage.")));
});

test("numbers stay numbers, and everything else is a string", () => {
  assert.deepEqual(valuesOf(" 20 deg, 1e3 ;true,,"), ["20 deg", "1e3", "true"]);
  assert.deepEqual(valuesOf("0,2; 0,35 ;1"), ["0.2", "0.35", "1"]);
  assert.equal(sweepLine([{ key: "contact.friction", values: "20 deg, 30 deg" }, { key: "particles", values: "1_000, 2e3" }, { key: "", values: "1" }]),
    'sweep = { "contact.friction" = ["20 deg", "30 deg"], particles = [1_000, 2e3] }');
  assert.equal(sweepLine([{ key: "fines_content", values: " , " }]), "");
  assert.equal(sweepLine([{ key: 'a"b', values: 'c"]}\\' }]), 'sweep = { "a\\"b" = ["c\\"]}\\\\"] }');
});

test("a sweep takes the place of the one before, and nothing else changes", () => {
  const rows = [{ key: "contact.friction", values: "20 deg" }], line = 'sweep = { "contact.friction" = ["20 deg"] }';
  const changed = withSweep(text, "main", rows);
  const old = text.slice(text.indexOf("sweep = {"), text.indexOf("replicates"));
  assert.equal(changed, text.replace(old, "").replace("replicates = 2\n", `replicates = 2\n${line}\n`));
  assert.equal(withSweep(changed, "main", rows), changed);
  assert.ok(withSweep(text, "main", rows, "3").includes(`soil  = "sand"\n${line}\nreplicates = 3\n\n[[study.main.stage]]`));
  assert.ok(withSweep(text, "other", rows).endsWith(`[study."other"]\nsoil = "sand"\n${line}\n`));
  assert.throws(() => withSweep(text, "third", rows), /\[study.third\]/);
});

test("a further stage comes behind those of its study, before what follows them", () => {
  assert.deepEqual(stagesOf(text, "main"), [{ name: "initial", verb: "compact", keys: ["name", "do", "pressure"] }]);
  const stage = stageText("main", [["name", '"test"'], ["stresses", listToml("800 kPa, 50 kPa")]]);
  const added = '[[study.main.stage]]\nname = "test"\nstresses = ["800 kPa", "50 kPa"]';
  assert.equal(stage, added);
  const after = 'pressure = "100 kPa"\n', { text: changed, line } = withStage(text, "main", stage);
  assert.equal(changed, text.replace(after, `${after}\n${added}\n`));
  assert.equal(changed.split("\n")[line - 1], "[[study.main.stage]]");
  const commented = text.replace('[study."other"]', '# what follows\n[study."other"]');
  assert.ok(withStage(commented, "main", stage).text.includes(`${added}\n\n# what follows\n`));
  const nested = text.replace('[study."other"]', '[study.main.stage.prepare]\nfriction = 1\n\n[study."other"]');
  assert.ok(withStage(nested, "main", stage).text.includes(`friction = 1\n\n${added}\n\n[study."other"]`));
  assert.throws(() => withStage(text, "other", stage), /has no stage/);
});

test("files of a case have the names that it has for them", () => {
  const [dam, own, other] = ["dam.csv", "own.csv", "other.csv"].map((name) => ({ name }));
  assert.deepEqual(filesByName('psd = "curves/dam.csv"\nrows = \'own.csv\'\ntitle = "my other.csv"\n', [dam, own, other]), { "curves/dam.csv": dam, "own.csv": own, "data/other.csv": other });
});
