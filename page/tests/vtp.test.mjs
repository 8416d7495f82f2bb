// Grains as the studio reads them from the pictures of a stage, whole and damaged.
import assert from "node:assert/strict";
import { test } from "node:test";
import { readGrains, sceneOf } from "../src/studio/vtp.js";

/** A picture of two grains, as suffuse writes it. */
function picture(change = {}) {
  const columns = [["Float32", "radius", new Float32Array([1e-3, 5e-4])], ["UInt32", "id", new Uint32Array([7, 9])], ["UInt8", "fine", new Uint8Array([0, 1])],
    ["Int64", "coordination", new BigInt64Array([3n, 0n])], ["Float32", "position", change.position ?? new Float32Array([0.001, 0.002, 0.003, 0.004, 0.002, 0.001])]];
  let at = 0;
  const blocks = [], head = columns.map(([type, name, numbers]) => {
    const size = Buffer.alloc(8);
    size.writeBigUInt64LE(BigInt(name === change.name ? change.size : numbers.byteLength));
    blocks.push(size, Buffer.from(numbers.buffer));
    const line = `<DataArray type="${type}" Name="${name}" NumberOfComponents="1" format="appended" offset="${at}"/>`;
    at += 8 + numbers.byteLength;
    return line;
  });
  const whole = Buffer.concat([Buffer.from(`<?xml version="1.0"?>\n<VTKFile type="PolyData" byte_order="LittleEndian" header_type="UInt64">\n${head.join("\n")}\n<AppendedData encoding="raw">\n_`), ...blocks]);
  return new Uint8Array(whole).buffer.slice(0, whole.length - (change.cut ?? 0));
}

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
