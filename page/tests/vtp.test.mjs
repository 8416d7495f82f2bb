// Grains as the studio reads them from the pictures of a stage, whole and damaged.
import assert from "node:assert/strict";
import { test } from "node:test";
import { readGrains, sceneOf } from "../src/studio/vtp.js";
import { picture } from "./vtp_for_tests.mjs";

test("a picture has its grains, and the scene is theirs in millimeters within its own box", () => {
  const grains = readGrains(picture());
  assert.deepEqual([[...grains.id], [...grains.fine], [...grains.coordination]], [[7, 9], [0, 1], [3, 0]]);
  const scene = sceneOf(grains, "a/b"), [state] = scene.states;
  const near = (found, wanted) => found.forEach((x, k) => assert.ok(Math.abs(x - wanted[k]) < 1e-6, `${found} is not ${wanted}`)); // rounding of single precision
  near([...scene.radius], [1, 0.5]);
  near([...state.position], [0, 0, 2, 3, 0, 0]);
  near(state.cell.flat(), [3, 0, 0, 0, 0, 0, 0, 0, 2]);
  assert.equal(state.label, "a/b");
});

test("a picture that is cut off, claims too much or holds no numbers is refused", () => {
  for (const damaged of [picture({ cut: 1 }), picture({ name: "radius", size: 2n ** 62n }), picture({ name: "radius", size: 7 }), picture({ name: "radius", size: 4 })]) {
    assert.throws(() => readGrains(damaged), /cut off|holds no grains/);
  }
  assert.throws(() => readGrains(picture({ position: new Float32Array([0, 0, NaN, 1, 1, 1]) })), /not finite/);
  for (const text of ["", "<VTKFile>", "{}"]) assert.throws(() => readGrains(new TextEncoder().encode(text).buffer), /not one that suffuse has written/);
});
