// The ways of grains over the states of a migration, as straight segments between successive states.
import { point } from "./data.js";

/**
 * A grain's way up to state `last`: its length [mm], and both ends of each segment, six numbers each. A segment leads from
 * where the grain is in the cell to its next place, which may lie beyond a face; the following one begins in the cell again.
 */
export function pathOf(scene, row, last) {
  const ends = [];
  let length = 0;
  const x = 3 * row;
  for (let k = 1; k <= last; ++k) {
    const [before, after] = [scene.states[k - 1], scene.states[k]];
    if (!before.present[row] || !after.present[row]) continue;
    const [a, b, c] = [0, 1, 2].map((e) => after.inPeriod[x + e] - before.inPeriod[x + e]);
    if (!(a || b || c) && [0, 1, 2].every((e) => after.place[x + e] === before.place[x + e])) continue;
    const periods = point(after.cell, a, b, c);
    let square = 0;
    for (let e = 0; e < 3; ++e) {
      ends.push(before.position[x + e]);
      square += (after.position[x + e] + periods[e] - before.position[x + e]) ** 2;
    }
    for (let e = 0; e < 3; ++e) ends.push(after.position[x + e] + periods[e]);
    length += Math.sqrt(square);
  }
  return { row, ends, length };
}

/** Paths up to state `last` of the fines that moved more than half their diameter; of the grain `chosen` alone if there is one. */
export function pathsShown(scene, last, chosen) {
  if (chosen >= 0) return [pathOf(scene, chosen, last)].filter(({ length }) => length > 0);
  const paths = [];
  for (let row = 0; row < scene.id.length; ++row) {
    const path = scene.fine[row] ? pathOf(scene, row, last) : null;
    if (path?.length > scene.radius[row]) paths.push(path);
  }
  return paths;
}
