// A specification fitted to the width at hand.
import assert from "node:assert/strict";
import { test } from "node:test";
import { fitted } from "../src/fit.js";

const corner = (count) => ({ spacing: 8, vconcat: Array.from({ length: count }, (_, row) => ({ hconcat: Array.from({ length: row + 1 }, () => ({ width: 90, height: 90 })) })) });
const panels = (chart) => chart.vconcat.flatMap((row) => row.hconcat);

test("panels in rows and columns are squares of one size, and the longest row fits", () => {
  for (const [count, width] of [[2, 640], [4, 640], [6, 640], [4, 358]]) {
    const all = panels(fitted(corner(count), width)), [{ width: side }] = all;
    assert.ok(all.every((panel) => panel.width === side && panel.height === side));
    assert.ok(count * (side + 8) + 46 <= width, `${count} panels of ${side} in ${width}`);
  }
});

test("what is given is not changed", () => {
  const chart = corner(3);
  fitted(chart, 640);
  assert.deepEqual(chart, corner(3));
});
