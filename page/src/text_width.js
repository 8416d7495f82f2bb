// How wide a text is where nothing can measure it: Vega's own guess without a canvas, 0.8 em a character, is half again as
// wide as the text, so that figures get empty margins and legends too few columns.

// Widths of Helvetica, and of what stands in for it, in thousandths of the font's size.
const classes = {
  222: "ijl'",
  278: " .,:;/!|ftI[]",
  340: '()r-"',
  500: "cksvxyzJ",
  556: "abdeghnopqu0123456789L_?$#",
  611: "FTZ",
  667: "ABEKPSVXY&",
  722: "CDHNRUw",
  778: "GOQ",
  833: "Mm",
  889: "%",
  944: "W",
};
const widthOf = new Map(Object.entries(classes).flatMap(([width, letters]) => [...letters].map((letter) => [letter, width / 1000])));
const others = 0.6; // Greek, signs, accented letters
const wideFonts = 1.19; // DejaVu Sans and its kin, where neither Helvetica nor Arial is at hand

/** In pixels, of an item of Vega's scene with this text. */
export function textWidth(item, text) {
  const size = item.fontSize ?? 11;
  const letters = text === undefined ? item.text : text;
  let width = 0;
  for (const letter of String(letters ?? "").trim()) width += widthOf.get(letter) ?? others;
  width *= size * (/^["']?DejaVu/.test(item.font ?? "") ? wideFonts : 1.04); // a little room for bold and other fonts
  return item.limit > 0 ? Math.min(width, item.limit) : width;
}
