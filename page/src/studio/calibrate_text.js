// The text of a case that calibrates: its soil, its contact, the tests of the laboratory and what is sought.
import { asToml } from "./case_text.js";

const quoted = (text) => JSON.stringify(text);
const keyText = (key) => (/^[\w-]+$/.test(key) ? key : quoted(key));
const digits = (value) => Number(value.toPrecision(6));
const listOf = (values, unit) => `[${values.map((value) => `"${digits(value)} ${unit}"`).join(", ")}]`;

/** A curve as a case has it. @param curve { d [m], f [-] }, sizes rising */
export const psdText = ({ d, f }) => `{ d = ${listOf(d.map((v) => 1e3 * v), "mm")}, passing = ${listOf(f.map((v) => 100 * v), "%")} }`;

/** A name of a test as targets have it, and none of those taken. */
export function targetName(test, taken) {
  const plain = test.replace(/[^A-Za-z0-9_-]+/g, "-").replace(/^-+|-+$/g, "").slice(0, 40) || "test";
  let name = plain;
  for (let k = 2; taken.includes(name); ++k) name = `${plain}-${k}`;
  return name;
}

/** A file of the case: in data/, with letters that the studio takes. */
export const dataName = (file) => `data/${file.replace(/[^A-Za-z0-9._-]+/g, "-").replace(/^[.-]+/, "").slice(-60) || "record.csv"}`;

/** @param row { key, from, to, isLog } @return "key = [from, to]"; nothing where something is missing */
export const unknownLine = ({ key, from, to, isLog }) => (key && from && to ? `${keyText(key)} = [${[asToml(from), asToml(to), ...(isLog ? ['"log"'] : [])].join(", ")}]` : "");

/** @param target { name, file, ... } @return its table; entries without a value are left out */
const targetText = (target) => ["[[calibrate.targets]]", ...Object.entries(target).filter(([, value]) => value !== "" && value !== undefined && value !== false)
  .map(([key, value]) => `${key} = ${value === true ? "true" : asToml(String(value))}`)].join("\n");

/**
 * @param what { title, curve, contact: [[key, value], ...], targets, unknowns: rows of `unknownLine`, particles, samples }
 * @throws Error that says what is missing
 */
export function calibrationText({ title, curve, contact, targets, unknowns, particles, samples }) {
  const lines = unknowns.map(unknownLine).filter(Boolean);
  if (!curve) throw new Error("Give the grading of the sand in the first tab: samples are drawn from it.");
  if (!targets.some((target) => !target.held_out)) throw new Error("Choose a test to fit.");
  if (!lines.length) throw new Error("Name a parameter that is sought, with its range.");
  const open = targets.find((target) => !target.pressure);
  if (open) throw new Error(`Give the pressure at the start of ${open.name}.`);
  return `schema = 1
title = ${quoted(title)}
seed = 1

[grain]
density = "2650 kg/m^3"

[contact]
${contact.filter(([key, value]) => key && value).map(([key, value]) => `${keyText(key)} = ${asToml(value)}`).join("\n")}

[soil.sand]
psd = ${psdText(curve)}

[calibrate]
soil = "sand"
particles = ${particles || 1000} # of each sample
samples = ${samples || 64} # of each test, at most

${targets.map(targetText).join("\n\n")}

[calibrate.unknowns]
${lines.join("\n")}
`;
}

/** Whether a text calibrates. */
export const calibrates = (text) => /^\s*\[calibrate\]/m.test(text) && !/^\s*\[study\./m.test(text);
