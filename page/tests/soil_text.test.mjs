// Tables of gradings as text, and the answer on a soil in words: without a browser.
import assert from "node:assert/strict";
import { test } from "node:test";
import { answerTables, curveNotes, verdictLines } from "../src/studio/soil_answer.js";
import { columnsOf, tableOf, textOf } from "../src/studio/table_text.js";

const criterion = { name: "K & L", remark: "at <d>", verified: true, value: 4, measured: null, limit: 1.3, stable_if: ">= 1.3", verdict: "stable" };
const found = {
  tally: { stable: 1, transition: 0, unstable: 1 }, criteria: [criterion, { ...criterion, value: null, limit: null, stable_if: "", verdict: "cannot say" }], gradients: [{ ...criterion, id: "terzaghi", value: 0.3, limit: 0.99 }],
  seepage: { gradient: 0.3, flow: "up" }, sizes: { d10: null, d50: 1e-3, d60: 2e-3 }, uniformity: null, filter: null,
  atlas: [{ density: "loose", flow: "up", inside: true, wide_fines: false, porosity: 0.4, i1: 0.33, i10: null, i1_at_most: false, i10_at_most: false, lower_bounds: { i1: null, i10: 0.9 }, size_ratio: 4, fines_content: 0.2 }],
};

test("bytes are decoded as the program does: UTF-16 by its mark, UTF-8, else Windows-1252; what is no text is empty", () => {
  assert.equal(textOf(new TextEncoder().encode("d [µm]")), "d [µm]");
  assert.equal(textOf(Uint8Array.of(0xb5, 0xe9)), "µé");
  assert.equal(textOf(Uint8Array.of(0xff, 0xfe, 100, 0, 0xb5, 0)), "dµ");
  assert.equal(textOf(Uint8Array.of(0xfe, 0xff, 0, 100, 0, 0xb5)), "dµ");
  assert.equal(textOf(Uint8Array.of(0xff, 0xfe, 100)), ""); // cut off
  assert.equal(textOf(Uint8Array.of(100, 0, 1)), "");
  assert.equal(textOf(new Uint8Array(200_001).fill(100)), "");
});

test("columns are those between the mark that cuts most, each with its heading", () => {
  assert.deepEqual(columnsOf('"d, [mm]";passing\n0,2;100\n'), [{ number: 1, heading: "d, [mm]" }, { number: 2, heading: "passing" }]);
  assert.deepEqual(columnsOf("1 2 3").map((column) => column.heading), ["", "", ""]);
  assert.equal(tableOf({ d: [2e-4, 1e-3], f: [0, 1] }, 6), "d [mm],passing [%]\n0.2,0\n1,100\n");
});

test("the answer in words and tables, with what is not known, and names escaped", () => {
  assert.deepEqual(verdictLines(found, ""), ["1 of 2 criteria say unstable.", "1 % of the fines move at i = 0.33 (atlas): factor of safety 1.1.", "Factor of safety 3.3 against heave of the whole soil."]);
  const html = answerTables({ ...found, filter: { criteria: [] } }, "<b>");
  assert.match(html, /K &amp; L<small>at &lt;d&gt;/);
  assert.match(html, /The filter &lt;b&gt;/);
  assert.match(html, /0\.33<\/td><td class="n">≥ 0\.9/);
  const dense = { ...found.atlas[0], i1: null, lower_bounds: { i1: 0.66, i10: null } };
  assert.equal(verdictLines({ ...found, atlas: [...found.atlas, dense] }, "")[1], "1 % of the fines move at i = 0.33 to at least 0.66 (atlas): factor of safety 1.1 to at least 2.2.");
  const heaves = { ...found.gradients[0], value: found.gradients[0].limit / 0.996 };
  assert.match(verdictLines({ ...found, gradients: [heaves] }, "")[2], /Factor of safety 0\.99 against/);
  assert.match(answerTables({ ...found, atlas: [dense] }, ""), /≥ 0\.66<\/td><td class="n">–/);
  assert.match(html, /d10 \?, d50 1, d60 2 mm; Cu \?/);
  assert.equal(curveNotes({ f: [0.1, 1], isEdited: true }, { gap: { from: 4e-4, to: 9e-4 } }, null), "The curve was edited here. Shaded: the gap, 0.4 to 0.9 mm. 10 % is finer than the last size.");
});
