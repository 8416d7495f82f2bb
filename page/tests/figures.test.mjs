// Foreign figures: specifications of the sample run, changed as a fixed seed chooses. Whatever they hold, the program
// that draws figures ends by itself, and each is drawn or complained of by its name; none is followed to a file or an address.
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { mkdirSync, mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { files, patience, samples } from "./browser.mjs";

let folder;

before(() => (folder = mkdtempSync(join(tmpdir(), "suffuse-figures-"))));
after(() => rmSync(folder, { recursive: true }));

/** Draws texts as figures NAME.vl.json with further words: what was drawn, by name, and what was said. */
function draw(name, texts, ...words) {
  const place = join(folder, name), out = join(place, "out");
  mkdirSync(out, { recursive: true });
  const specifications = Object.entries(texts).map(([id, text]) => {
    writeFileSync(join(place, `${id}.vl.json`), text);
    return join(place, `${id}.vl.json`);
  });
  const end = spawnSync("node", [join(process.env.SUFFUSE_PAGE, "figures.mjs"), ...words, out, ...specifications], {
    encoding: "utf8",
    timeout: patience,
    maxBuffer: 1 << 26,
  });
  const drawn = Object.fromEntries(readdirSync(out).map((file) => [file.replace(".svg", ""), readFileSync(join(out, file), "utf8")]));
  return { ...end, drawn };
}

/** Whole numbers below `most`, the same in every run (mulberry32). */
function numbers(seed) {
  return (most) => {
    seed = (seed + 0x6d2b79f5) | 0;
    let t = Math.imul(seed ^ (seed >>> 15), seed | 1);
    t ^= t + Math.imul(t ^ (t >>> 7), t | 61);
    return ((t ^ (t >>> 14)) >>> 0) % most;
  };
}

const secret = "a line that is in no figure";
const strange = (place) => [
  null, true, -1, 0, 1e308, "", "x".repeat(300), "</text><script>1</script>", [], {}, [[]], "datum.x.constructor",
  { url: place }, { url: "http://127.0.0.1:9/rows.json" }, { field: "nowhere", type: "quantitative" }, { signal: "width" },
];

/** One value somewhere in the document replaced, removed or doubled. */
function changed(document, next, place) {
  const values = strange(place);
  let parent = document, key;
  for (;;) {
    const keys = Object.keys(parent);
    key = keys[next(keys.length)];
    const child = parent[key];
    if (!child || typeof child !== "object" || !Object.keys(child).length || next(6) === 0) break;
    parent = child;
  }
  const what = next(8);
  if (what === 0 && Array.isArray(parent)) parent.splice(key, 1);
  else if (what === 0) delete parent[key];
  else if (what === 1 && Array.isArray(parent)) parent.push(structuredClone(parent[key]));
  else parent[key] = values[next(values.length)];
  return document;
}

test("a figure changed at random is drawn, or complained of by its name", () => {
  const next = numbers(1), place = join(folder, "rows.json"), texts = {};
  writeFileSync(place, JSON.stringify([{ x: secret }]));
  const originals = files("sample", ".vl.json").map((name) => readFileSync(join(samples, "sample", "figures", name), "utf8"));
  for (let number = 0; number < 300; ++number) {
    let document = JSON.parse(originals[next(originals.length)]);
    for (let left = next(3); left >= 0; --left) document = changed(document, next, place);
    texts[`f${number}`] = JSON.stringify(document);
  }
  for (let number = 300; number < 330; ++number) { // bytes, too
    const text = originals[next(originals.length)], at = next(text.length);
    texts[`f${number}`] = text.slice(0, at) + strange(place)[next(8)] + text.slice(at + next(9));
  }
  const { signal, status, stderr, drawn } = draw("random", texts);
  assert.equal(signal, null);
  assert.ok(status === 0 || status === 1, `ends with ${status}`);
  const complaints = stderr.split("\n").filter((line) => / *\S+\.vl\.json: /.test(line));
  for (const id of Object.keys(texts)) {
    const isReported = complaints.some((line) => line.includes(`/${id}.vl.json: `));
    assert.ok(isReported || id in drawn, `${id} is neither drawn nor complained of`);
  }
  assert.ok(Object.keys(drawn).length > 50, "most changes leave a figure");
  for (const [id, svg] of Object.entries(drawn)) {
    assert.ok(!svg.includes(secret), `${id} shows what a file holds`);
    assert.doesNotMatch(svg, /<script|href="(http|file)/, `${id} holds more than a drawing`);
  }
});

test("a figure that computes is drawn without the reach of a script", () => {
  const steps = ["process.exit(7)", "datum.constructor.constructor('return process')().exit(7)", "toString.constructor('return 1')()"];
  const texts = Object.fromEntries(steps.map((calculate, number) => [`g${number}`, JSON.stringify({
    data: { values: [{ x: 1 }] },
    transform: [{ calculate, as: "y" }],
    mark: "text",
    encoding: { text: { field: "y" } },
  })]));
  const { signal, status } = draw("scripts", texts);
  assert.equal(signal, null);
  assert.notEqual(status, 7);
});

/** Of as many rows as the sequence has numbers. */
const rows = (stop) => JSON.stringify({
  data: { sequence: { start: 0, stop, as: "x" } },
  mark: "point",
  encoding: { x: { field: "x", type: "quantitative" } },
});

test("a figure that asks for endless rows is ended by its memory, and others are drawn", () => {
  const { signal, status, stderr, drawn } = draw("rows", { a: rows(10), b: rows(1e8), c: rows(10) }, "--megabytes=500");
  assert.equal(signal, null);
  assert.equal(status, 1);
  assert.match(stderr, /^\S+\/b\.vl\.json: needs more than 500 MB to be drawn; reduce the rows of its data\n$/);
  assert.deepEqual(Object.keys(drawn), ["a", "c"]);
});

test("a figure that takes too long is ended by its time, and others are drawn", () => {
  const { signal, status, stderr, drawn } = draw("time", { a: rows(1e8), b: rows(10) }, "--seconds=2", "--megabytes=1e6");
  assert.equal(signal, null);
  assert.equal(status, 1);
  assert.match(stderr, /\/a\.vl\.json: takes more than 2 s to be drawn/);
  assert.ok("b" in drawn || /\/b\.vl\.json: takes more than 2 s/.test(stderr), "on a machine so slow that b is endless, too");
});
