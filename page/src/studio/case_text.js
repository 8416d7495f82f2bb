// The text of a case: its studies and stages, what a study can sweep, the line that sweeps it, and a further stage.

const header = (line) => line.match(/^\s*\[study\.(?:"([^"]+)"|([\w-]+))\]/)?.slice(1).find(Boolean);
const stageHeader = (line) => line.match(/^\s*\[\[study\.(?:"([^"]+)"|([\w-]+))\.stage\]\]/)?.slice(1).find(Boolean);
const valueOf = (line, key) => line.match(new RegExp(`^\\s*${key}\\s*=\\s*"([^"]*)"`))?.[1];
const keyOf = (line) => line.match(/^\s*([\w-]+)\s*=/)?.[1];
const isTable = (line) => /^\s*\[/.test(line);

export const studiesOf = (text) => [...new Set(text.split("\n").map(header).filter(Boolean))];

/** Lines of a table: from its heading to the next one. */
function blockOf(lines, isHeading) {
  const begin = lines.findIndex(isHeading), rest = begin < 0 ? [] : lines.slice(begin + 1), length = rest.findIndex(isTable);
  return begin < 0 ? null : { begin, end: begin + 1 + (length < 0 ? rest.length : length) };
}

/** The stages of a study, each with its name, verb and keys. */
export function stagesOf(text, study) {
  const lines = text.split("\n"), stages = [];
  for (let k = 0; k < lines.length; ++k) {
    if (stageHeader(lines[k]) !== study) continue;
    const length = lines.slice(k + 1).findIndex(isTable), block = lines.slice(k + 1, length < 0 ? undefined : k + 1 + length);
    const of = (key) => block.map((line) => valueOf(line, key)).find(Boolean);
    if (of("name")) stages.push({ name: of("name"), verb: of("do") ?? "", keys: block.map(keyOf).filter(Boolean) });
  }
  return stages;
}

/** Keys that a study can sweep, of those that the case has: of its contacts, its soil, its stages. */
export function keysOf(text, study) {
  const lines = text.split("\n"), keys = ["particles", "fines_content"];
  const of = (isHeading) => {
    const block = blockOf(lines, isHeading);
    return block ? lines.slice(block.begin + 1, block.end) : [];
  };
  const own = of((line) => header(line) === study), soil = own.map((line) => valueOf(line, "soil")).find(Boolean);
  keys.push(...of((line) => /^\s*\[contact\]/.test(line)).map(keyOf).filter((key) => key && key !== "law").map((key) => `contact.${key}`));
  if (soil) keys.push(...of((line) => line.includes(`[soil.${soil}]`) || line.includes(`[soil."${soil}"]`)).map(keyOf).filter((key) => key && !["psd", "surrogate"].includes(key)));
  for (const stage of stagesOf(text, study)) keys.push(...stage.keys.filter((key) => !["name", "do", "from"].includes(key)).map((key) => `stage.${stage.name}.${key}`));
  return [...new Set(keys)];
}

/** How many of these lines an entry takes: to the end of its brackets, which strings and comments do not count for. */
function entryLength(lines) {
  let depth = 0;
  for (let k = 0; k < lines.length; ++k) {
    const bare = lines[k].replace(/"(?:[^"\\]|\\.)*"|'[^']*'/g, "").replace(/#.*/, "");
    depth += (bare.match(/[[{]/g) ?? []).length - (bare.match(/[\]}]/g) ?? []).length;
    if (depth <= 0) return k + 1;
  }
  return lines.length;
}

/** A value as TOML has it: numbers stay numbers, everything else is a string. */
export const asToml = (value) => (/^([+-]?\d[\d_]*(\.\d+)?([eE][+-]?\d+)?|true|false)$/.test(value) ? value : JSON.stringify(value));

/** "20 deg, 35 deg" -> ["20 deg", "35 deg"]. Between semicolons a comma is a decimal one: "0,2; 0,35" -> ["0.2", "0.35"] */
export function valuesOf(text) {
  const hasCommas = text.includes(";") && /\d,\d/.test(text), parts = hasCommas ? text.split(";").map((part) => part.replace(/(\d),(\d)/, "$1.$2")) : text.split(/[,;]/);
  return parts.map((value) => value.trim()).filter(Boolean);
}

/** Files by the names that a case has for them: "dam.csv" -> "data/dam.csv". What it does not name is put into data/. */
export function filesByName(text, files) {
  const named = [...text.matchAll(/"([^"\n]+)"|'([^'\n]+)'/g)].map((m) => m[1] ?? m[2]);
  return Object.fromEntries(files.map((file) => [named.find((name) => name === file.name || name.endsWith(`/${file.name}`)) ?? `data/${file.name}`, file]));
}

/** "400 kPa, 100 kPa" -> '["400 kPa", "100 kPa"]' */
export const listToml = (text) => `[${valuesOf(text).map(asToml).join(", ")}]`;

/** @param rows [{ key, values: "20 deg, 35 deg" }, ...]; those without a key or values are left out */
export function sweepLine(rows) {
  const entries = rows.filter((row) => row.key && valuesOf(row.values).length)
    .map(({ key, values }) => `${/^[\w-]+$/.test(key) ? key : JSON.stringify(key)} = ${listToml(values)}`);
  return entries.length ? `sweep = { ${entries.join(", ")} }` : "";
}

/** The case with this sweep of a study in place of its own, and with so many replicates where they are given. */
export function withSweep(text, study, rows, replicates = "") {
  const lines = text.split("\n"), block = blockOf(lines, (line) => header(line) === study), line = sweepLine(rows);
  if (!block) throw new Error(`The case has no table [study.${study}].`);
  const kept = [], replaced = new Set(replicates ? ["sweep", "replicates"] : ["sweep"]);
  for (let k = block.begin + 1; k < block.end;) {
    const length = replaced.has(keyOf(lines[k])) ? entryLength(lines.slice(k, block.end)) : 0;
    if (!length) kept.push(lines[k]);
    k += length || 1;
  }
  let last = kept.length;
  while (last > 0 && !kept[last - 1].trim()) --last;
  kept.splice(last, 0, ...[line, replicates && `replicates = ${replicates}`].filter(Boolean));
  return [...lines.slice(0, block.begin + 1), ...kept, ...lines.slice(block.end)].join("\n");
}

const studyName = (study) => (/^[\w-]+$/.test(study) ? study : JSON.stringify(study));

/** @param entries [["name", '"test"'], ...], the values as TOML */
export const stageText = (study, entries) => [`[[study.${studyName(study)}.stage]]`, ...entries.map(([key, value]) => `${key} = ${value}`)].join("\n");

/** The case with a further stage behind those of its study. @return the text, and the line of the stage's heading, from 1 */
export function withStage(text, study, stage) {
  const lines = text.split("\n"), begin = lines.findLastIndex((line) => stageHeader(line) === study);
  if (begin < 0) throw new Error(`The study ${study} has no stage that a test could start from.`);
  const isOwn = (line) => /^\s*\[study\./.test(line) && line.includes(".stage"); // a table of the last stage
  const length = lines.slice(begin + 1).findIndex((line) => isTable(line) && !isOwn(line));
  let end = length < 0 ? lines.length : begin + 1 + length;
  while (/^\s*(#.*)?$/.test(lines[end - 1])) --end; // comments above the next table are its own
  return { text: [...lines.slice(0, end), "", ...stage.split("\n"), ...(lines[end]?.trim() ? [""] : []), ...lines.slice(end)].join("\n"), line: end + 2 };
}
