// The map of the atlas on the page of `suffuse assess --page`: simulated soils over size ratio and fines content, a grid for
// each density, and where the soil is.
"use strict";

const AtlasMap = (() => {
  const cell = { width: 56, height: 30 }, left = 46, top = 26, bottom = 42;
  const unique = (values) => [...new Set(values)].sort((a, b) => a - b);

  /** Place of a value among the lines of the grid, in cells: at most half a cell outside. @param same relative: on a line */
  const along = (lines, value, same) => {
    const on = lines.findIndex((line) => Math.abs(Math.log(value / line)) <= same);
    if (on >= 0) return on;
    const next = lines.findIndex((line) => line > value);
    if (next < 0) return lines.length - 0.5;
    return next === 0 ? -0.5 : next - 1 + Math.log(value / lines[next - 1]) / Math.log(lines[next] / lines[next - 1]);
  };

  const grid = (nodes, density, ratios, contents, place) => {
    const x = (k) => left + (k + 0.5) * cell.width, y = (k) => top + (ratios.length - 0.5 - k) * cell.height;
    const width = left + contents.length * cell.width + 8, height = top + ratios.length * cell.height + bottom;
    const parts = [`<text x="${left}" y="14">${density}</text>`];
    for (const node of nodes.filter((n) => n.density === density)) {
      const column = contents.indexOf(node.fines), row = ratios.indexOf(node.ratio), value = node.i1;
      const shade = value === null ? 0.03 : 0.06 + 0.4 * Math.min(value, 1);
      parts.push(`<rect class="cell" fill-opacity="${shade.toFixed(3)}" x="${x(column) - cell.width / 2}" y="${y(row) - cell.height / 2}" width="${cell.width}" height="${cell.height}"/>`,
        `<text class="m" x="${x(column)}" y="${y(row) + 4.5}">${value === null ? "–" : `${node.at_most ? "≤ " : node.at_least ? "≥ " : ""}${value.toFixed(2)}`}</text>`);
    }
    ratios.forEach((ratio, k) => parts.push(`<text class="e" x="${left - 8}" y="${y(k) + 4.5}">${ratio}</text>`));
    contents.forEach((content, k) => parts.push(`<text class="m" x="${x(k)}" y="${height - bottom + 17}">${Number((100 * content).toPrecision(3))} %</text>`));
    parts.push(`<text class="e s" x="${width - 8}" y="${height - 6}">fines</text><text class="s" x="0" y="${height - bottom + 17}">ratio</text>`);
    if (place) parts.push(`<circle class="place" cx="${x(along(contents, place.fines, 1e-6))}" cy="${y(along(ratios, place.ratio, 0.03))}" r="7"/>`);
    return `<svg role="img" aria-label="Atlas, ${density}" viewBox="0 0 ${width} ${height}" style="max-width:${width}px">${parts.join("")}</svg>`;
  };

  /** Grids for all densities. @param place ratio and fines of the soil; null where its curve has no two parts */
  const draw = (nodes, place) => {
    const ratios = unique(nodes.map((n) => n.ratio)), contents = unique(nodes.map((n) => n.fines));
    const densities = ["loose", "medium", "dense"].filter((density) => nodes.some((n) => n.density === density));
    return densities.map((density) => grid(nodes, density, ratios, contents, place)).join("");
  };

  return { draw };
})();
