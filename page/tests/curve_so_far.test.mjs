// The curve of a stage at work, from the states that were polled.
import assert from "node:assert/strict";
import { test } from "node:test";
import { curveSoFar } from "../src/studio/curve_so_far.js";
import { lineChart } from "../src/studio/line_chart.js";

test("a test's curve begins with its first row: states before it are no points", () => {
  const waits = { verb: "triaxial", steps: 100, void_ratio: 0.7 };
  const row = (strain, q) => ({ ...waits, axial_strain: strain, deviator_stress: q });
  assert.deepEqual(curveSoFar([waits]).points, []);
  assert.equal(lineChart(curveSoFar([waits, row(0.01, 3000)]).points, "x", "y"), "");
  const { x, y, points } = curveSoFar([waits, row(0.01, 3000), row(0.02, 5000)]);
  assert.deepEqual([x, y, points], ["axial_strain", "deviator_stress", [[0.01, 3], [0.02, 5]]]);
  assert.doesNotMatch(lineChart(points, x, y), /NaN/);
});

test("any other stage's curve is its void ratio over its steps", () => {
  const states = [10, 20].map((steps) => ({ verb: "compact", steps, void_ratio: 1 / steps }));
  assert.deepEqual(curveSoFar(states).points, [[10, 0.1], [20, 0.05]]);
});
