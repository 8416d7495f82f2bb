// A calibration as its form writes it.
import assert from "node:assert/strict";
import { test } from "node:test";
import { calibrates, calibrationText, dataName, psdText, targetName, unknownLine } from "../src/studio/calibrate_text.js";

const curve = { d: [1e-4, 1.4e-4, 2e-4], f: [0, 0.5, 1] };
const what = {
  title: 'sand "A"', curve, contact: [["law", "hertz-mindlin"], ["modulus", "70 GPa"], ["", "1"], ["poisson", "0.2"]],
  targets: [{ name: "low", file: "data/t.csv", sample: "", test: "drained", contraction: "", pressure: "100 kPa", strain: "5 %", void_ratio_of: "", held_out: false },
    { name: "mid", file: "data/t.csv", sample: "T2", test: "drained", contraction: "positive", pressure: "200 kPa", strain: "", void_ratio_of: "low", held_out: true }],
  unknowns: [{ key: "contact.friction", from: "18 deg", to: "45 deg", isLog: false }, { key: "", from: "1", to: "2", isLog: false }], particles: "", samples: "16",
};

test("a curve is written in millimeters and percent, without digits of rounding", () => {
  assert.equal(psdText(curve), '{ d = ["0.1 mm", "0.14 mm", "0.2 mm"], passing = ["0 %", "50 %", "100 %"] }');
});

test("the case has its targets and unknowns a line each, and nothing that is empty", () => {
  const text = calibrationText(what);
  assert.ok(text.includes('title = "sand \\"A\\""'));
  assert.ok(text.includes('[contact]\nlaw = "hertz-mindlin"\nmodulus = "70 GPa"\npoisson = 0.2\n'));
  assert.ok(text.includes('[[calibrate.targets]]\nname = "low"\nfile = "data/t.csv"\ntest = "drained"\npressure = "100 kPa"\nstrain = "5 %"\n\n'));
  assert.ok(text.includes('contraction = "positive"\npressure = "200 kPa"\nvoid_ratio_of = "low"\nheld_out = true\n'));
  assert.ok(text.endsWith('[calibrate.unknowns]\n"contact.friction" = ["18 deg", "45 deg"]\n'));
  assert.ok(text.includes("particles = 1000 ") && text.includes("samples = 16 "));
});

test("what is missing is named", () => {
  assert.throws(() => calibrationText({ ...what, curve: null }), /grading of the sand/);
  assert.throws(() => calibrationText({ ...what, targets: [what.targets[1]] }), /test to fit/);
  assert.throws(() => calibrationText({ ...what, unknowns: [] }), /parameter that is sought/);
  assert.throws(() => calibrationText({ ...what, targets: [{ ...what.targets[0], pressure: "" }] }), /pressure at the start of low/);
});

test("ranges of all decades say so, and numbers stay numbers", () => {
  assert.equal(unknownLine({ key: "contact.modulus", from: "1 GPa", to: "100 GPa", isLog: true }), '"contact.modulus" = ["1 GPa", "100 GPa", "log"]');
  assert.equal(unknownLine({ key: "void_ratio", from: "0.55", to: "0.8" }), "void_ratio = [0.55, 0.8]");
});

test("names of tests and files are those that a case and the studio take", () => {
  assert.equal(targetName("TMD 22/b", []), "TMD-22-b");
  assert.equal(targetName("TMD1", ["TMD1", "TMD1-2"]), "TMD1-3");
  assert.equal(targetName("§", []), "test");
  assert.equal(dataName("../Versuch 1 (alt).csv"), "data/Versuch-1-alt-.csv");
  assert.equal(dataName("..."), "data/record.csv");
});

test("a case with a study does not calibrate", () => {
  assert.ok(calibrates(calibrationText(what)));
  assert.ok(!calibrates(`${calibrationText(what)}\n[study.s]\nsoil = "sand"\n`));
});
