// A picture of grains for tests, whole or damaged.

/** A picture of two grains, as suffuse writes it. */
export function picture(change = {}) {
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
