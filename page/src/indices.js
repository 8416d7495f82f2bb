// Symbols with an index, e_min or FC_active, as typeset in a drawing: the index small and low. Only those of the charts'
// own words, so that a name which a user gave stays as it was given.
const indexed = /\b(e|FC|i)_(min|g|eq|active|threshold|c)\b([^<]*)/g;
// Programs that draw the file drop the space at the start of a span unless specified otherwise.
const low = (_, symbol, index, rest) =>
  `${symbol}<tspan dy="0.25em" font-size="0.75em">${index}</tspan>` +
  (rest ? `<tspan dy="-0.19em" xml:space="preserve">${rest.replace(indexed, low)}</tspan>` : "");

/** Escaped text of one element. */
export const lowerIndices = (text) => text.replace(indexed, low);

/** The same for all texts of an SVG file; attributes stay as they are. */
export const lowerIndicesOf = (svg) => svg.replace(/(<text\b[^>]*>)([^<]+)(?=<\/text>)/g, (_, tag, text) => tag + lowerIndices(text));
