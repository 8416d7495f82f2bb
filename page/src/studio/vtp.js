// Grains from a picture that a stage has saved (docs/formats.md: grains.vtp, strain-0001.vtp, pass-1.vtp): XML that
// names columns of raw numbers behind it. What does not fit into the file is refused.

const kinds = { Float32: Float32Array, Float64: Float64Array, UInt8: Uint8Array, UInt32: Uint32Array, Int64: BigInt64Array };
const longestHead = 1 << 16; // [B]

/** @param buffer the file @return { id, radius [m], fine, coordination, position [m] } as typed arrays @throws Error */
export function readGrains(buffer) {
  const head = new TextDecoder("latin1").decode(buffer.slice(0, longestHead)), mark = head.match(/<AppendedData encoding="raw">\s*_/);
  if (!mark || !head.includes('byte_order="LittleEndian"') || !head.includes('header_type="UInt64"')) throw new Error("this picture is not one that suffuse has written");
  const begin = mark.index + mark[0].length, view = new DataView(buffer), columns = new Map();
  for (const [, type, name, offset] of head.slice(0, mark.index).matchAll(/<DataArray type="(\w+)" Name="(\w+)"[^>]*offset="(\d+)"/g)) {
    const at = begin + Number(offset), size = at + 8 <= buffer.byteLength ? Number(view.getBigUint64(at, true)) : Infinity, Kind = kinds[type];
    if (!Kind || at + 8 + size > buffer.byteLength || size % Kind.BYTES_PER_ELEMENT) throw new Error(`the column ${name} of this picture is cut off`);
    columns.set(name, new Kind(buffer.slice(at + 8, at + 8 + size)));
  }
  const [radius, position, fine] = ["radius", "position", "fine"].map((name) => columns.get(name)), count = radius?.length ?? 0;
  const id = columns.get("id") ?? Uint32Array.from({ length: count }, (_, k) => k);
  const coordination = Uint32Array.from(columns.get("coordination") ?? new Uint32Array(count), Number);
  if (!count || position?.length !== 3 * count || fine?.length !== count || id.length !== count || coordination.length !== count) throw new Error("this picture holds no grains");
  if (![radius, position].every((numbers) => numbers.every(Number.isFinite))) throw new Error("this picture holds numbers that are not finite");
  return { id, radius, fine, coordination, position };
}

/** The scene that the view of a report draws, in millimeters, of one state. Its cell is the box around the grains. */
export function sceneOf({ id, radius, fine, coordination, position }, label) {
  const mm = 1e3, low = [0, 1, 2].map(() => Infinity), high = [0, 1, 2].map(() => -Infinity), none = new Float32Array(0);
  for (let k = 0; k < position.length; ++k) {
    low[k % 3] = Math.min(low[k % 3], position[k]);
    high[k % 3] = Math.max(high[k % 3], position[k]);
  }
  const cell = [0, 1, 2].map((a) => [0, 1, 2].map((b) => (a === b ? mm * (high[a] - low[a]) : 0)));
  const state = {
    label, passes: 0, cell, position: Float32Array.from(position, (x, k) => mm * (x - low[k % 3])), coordination,
    present: new Uint8Array(id.length).fill(1), ends: none, period: none, force: none, meanForce: 0, speed: null, fluidForce: null, mobileGradient: null,
  };
  return { id, radius: Float32Array.from(radius, (r) => mm * r), fine, leftIn: new Uint8Array(id.length), flowDirection: [0, 0, 0], gradient: 0, states: [state], rowOf: new Map() };
}
