// A specification fitted to the width at hand: panels in a row are dropped before they get too narrow, legends get
// fewer columns.

const axisRoom = 74; // for the vertical axis with its title
const panelGap = 24;

/** Columns, at most `most`, that leave no gap in the last row where there is such a number. */
function fullRows(panels, most) {
  for (let columns = most; 2 * columns > most; --columns) if (panels % columns === 0) return columns;
  return most;
}

/** Legends whose names would not stand in the requested rows get fewer columns; three that do not fit a row, one: the
    third alone in a second row looks like an accident. */
function fitLegends(part, width) {
  if (Array.isArray(part)) part.forEach((each) => fitLegends(each, width));
  else if (part && typeof part === "object") {
    const names = part.scale?.domain;
    if (part.legend && Array.isArray(names) && names.every((name) => typeof name === "string")) {
      const symbol = 26 + Math.sqrt(part.legend.symbolSize ?? 100);
      const most = Math.max(1, Math.floor(width / (6.2 * Math.max(...names.map((name) => name.length)) + symbol)));
      if (names.length > most) part.legend.columns = names.length === 3 ? 1 : most;
      else delete part.legend.columns;
    }
    Object.values(part).forEach((each) => fitLegends(each, width));
  }
}

/** The specification with widths that fill `width` pixels. */
export function fitted(chart, width) {
  const copy = structuredClone(chart);
  fitLegends(copy, width - axisRoom);
  if (copy.facet) {
    const least = Math.min(copy.spec.width, 260);
    const fitting = Math.min(copy.columns, Math.floor((width - axisRoom) / (least + panelGap)));
    const columns = fullRows(copy.facet.sort.length, Math.max(1, fitting));
    copy.columns = columns;
    const room = (width - axisRoom - (columns - 1) * panelGap) / columns - 8;
    copy.spec.width = Math.floor(Math.min(copy.spec.width * 1.8, Math.max(120, room)));
  } else if (copy.vconcat?.some((row) => row.hconcat)) { // panels in rows and columns: square, as wide as the longest row lets them
    const most = Math.max(...copy.vconcat.map((row) => row.hconcat.length));
    const side = Math.floor(Math.max(40, Math.min(150, (width - axisRoom) / most - (copy.spacing ?? panelGap))));
    for (const panel of copy.vconcat.flatMap((row) => row.hconcat)) panel.width = panel.height = side;
  } else {
    for (const part of copy.vconcat ?? [copy]) {
      part.width = Math.floor(Math.max(160, Math.min(part.width * 1.4, width - axisRoom - 12)));
    }
  }
  return copy;
}
