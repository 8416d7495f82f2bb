// Tables of gradings as text: the bytes of a file decoded, the columns of a table, a curve as a table.

/** The text of a file as the program decodes it: UTF-16 by its mark, else UTF-8, else Windows-1252. Empty where it is none, or too long to edit. */
export function textOf(bytes) {
  const most = 200_000;
  if (bytes.byteLength > most) return "";
  const [first, second] = new Uint8Array(bytes), marked = { 0xfffe: "utf-16le", 0xfeff: "utf-16be" }[256 * first + second];
  for (const encoding of marked ? [marked] : ["utf-8", "windows-1252"]) {
    try {
      const text = new TextDecoder(encoding, { fatal: true }).decode(bytes);
      return text.includes("\0") ? "" : text;
    } catch { // another encoding
    }
  }
  return "";
}

/** Columns of a table, for the choice: the number of each, and its heading. */
export function columnsOf(text) {
  const lines = text.split(/\r?\n/).slice(0, 60).filter((line) => line.trim());
  const best = [";", "\t", "|", ","].map((mark) => ({ mark, most: Math.max(0, ...lines.map((line) => line.split(mark).length)) }))
    .reduce((a, b) => (b.most > a.most ? b : a));
  const split = (line) => (best.most > 1 ? line.split(best.mark) : line.trim().split(/\s+/)).map((cell) => cell.trim().replace(/^"|"$/g, ""));
  const rows = lines.map(split), count = Math.max(0, ...rows.map((row) => row.length));
  const heading = (k) => rows.map((row) => row[k] ?? "").find((cell) => /\p{L}/u.test(cell)) ?? "";
  return Array.from({ length: count }, (_, k) => ({ number: k + 1, heading: heading(k).slice(0, 40) }));
}

/** A curve as a table that the program reads. */
export const tableOf = ({ d, f }, digits) =>
  `d [mm],passing [%]\n${d.map((size, k) => `${Number((1e3 * size).toPrecision(digits))},${Number((100 * f[k]).toPrecision(digits))}\n`).join("")}`;
