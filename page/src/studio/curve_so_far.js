// What a stage at work has measured so far, as the points of a chart.

const tests = new Set(["triaxial", "plane-strain", "oedometer", "cyclic", "stress-probe"]);

/**
 * @param states polled, oldest first: { verb, steps, void_ratio, axial_strain [-], deviator_stress [Pa], ... }
 * @return names of x and y, and [[x, y], ...] of the states that carry both: a test without a row yet has no strain
 */
export function curveSoFar(states) {
  const isTest = tests.has(states.at(-1).verb), x = isTest ? "axial_strain" : "steps", y = isTest ? "deviator_stress" : "void_ratio";
  return { x, y, points: states.map((s) => [s[x], s[y] * (isTest ? 1e-3 : 1)]).filter((point) => point.every(Number.isFinite)) };
}
