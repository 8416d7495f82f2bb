// A small chart of numbers over numbers, or over names.
import { escaped, three } from "./words.js";

const margins = { left: 56, right: 12, top: 26, bottom: 40 };
const kinds = 6; // of lines, by their color and their dashes: page.css

const ticks = (from, to, count = 4) => {
  const rough = (to - from) / count, power = 10 ** Math.floor(Math.log10(rough)), step = [1, 2, 5, 10].find((k) => k * power >= rough) * power;
  const all = [];
  for (let t = Math.ceil(from / step - 1e-9) * step; t <= to + 1e-9 * step; t += step) all.push(Math.abs(t) < 1e-9 * step ? 0 : t);
  return all;
};

const rangeOf = (values) => {
  const low = Math.min(...values), high = Math.max(...values), margin = (high - low || Math.abs(high) || 1) * 0.05;
  return [low - margin, high + margin];
};

const kindOf = (k) => (k === 0 ? "mine" : `more more${((k - 1) % (kinds - 1)) + 1}`);

/**
 * @param series [{ name, points: [[x, y], ...], dots: [[x, y], ...], level: y }, ...]; a level is a line over the whole width
 * @param names of x = 0, 1, 2, ... where x is no number @param width on the screen [px]: letters keep their size
 * @param least height of a scale that begins at 0; 0: the scale fits the numbers
 * @return svg with a legend where there are several; empty for less than two points
 */
export function seriesChart(series, xName, yName, { names = [], width = 640, least = 0 } = {}) {
  const box = { ...margins, width: Math.round(Math.max(260, Math.min(640, width))), height: width < 420 ? 200 : 260 };
  const shown = series.filter((s) => s.points?.length || s.dots?.length || Number.isFinite(s.level));
  const points = shown.flatMap((s) => [...(s.points ?? []), ...(s.dots ?? [])]), levels = shown.map((s) => s.level).filter(Number.isFinite);
  if (new Set(points.map(String)).size < 2) return "";
  const [x0, x1] = rangeOf(points.map((p) => p[0])), [low, high] = rangeOf([...points.map((p) => p[1]), ...levels]);
  const [y0, y1] = least ? [0, Math.max(least, high)] : [low, high];
  const x = (v) => box.left + ((v - x0) / (x1 - x0)) * (box.width - box.left - box.right);
  const y = (v) => box.height - box.bottom - ((v - y0) / (y1 - y0)) * (box.height - box.top - box.bottom);
  const parts = ticks(y0, y1).map((t) => `<path class="gr" d="M${box.left} ${y(t)}H${box.width - box.right}"/><text class="e" x="${box.left - 6}" y="${y(t) + 4.5}">${three(t)}</text>`);
  const below = names.length ? names.map((text, k) => [k, text.slice(0, 18)]) : ticks(x0, x1, box.width < 420 ? 3 : 4).map((t) => [t, three(t)]);
  parts.push(...below.map(([t, text]) => `<text class="m" x="${x(t)}" y="${box.height - box.bottom + 18}">${escaped(text)}</text>`));
  parts.push(`<path class="ax" d="M${box.left} ${box.height - box.bottom}H${box.width - box.right}"/>`,
    `<text class="e s" x="${box.width - box.right}" y="${box.height - 6}">${escaped(xName)}</text><text class="s" x="2" y="11">${escaped(yName)}</text>`);
  const path = (list) => list.map((p, k) => `${k ? "L" : "M"}${x(p[0]).toFixed(1)} ${y(p[1]).toFixed(1)}`).join("");
  shown.forEach((s, k) => {
    if (s.points?.length > 1) parts.push(`<path class="ln ${kindOf(k)}" d="${path(s.points)}"/>`);
    if (Number.isFinite(s.level)) parts.push(`<path class="ln ${kindOf(k)}" d="M${box.left} ${y(s.level).toFixed(1)}H${box.width - box.right}"/>`);
    parts.push(...(s.dots ?? []).map((p) => `<circle class="dot ${kindOf(k)}" cx="${x(p[0]).toFixed(1)}" cy="${y(p[1]).toFixed(1)}" r="4.5"/>`));
  });
  const legend = shown.length < 2 ? "" : `<ul class="legend">${shown.map((s, k) =>
    `<li><svg viewBox="0 0 34 10" aria-hidden="true"><path class="ln ${kindOf(k)}" d="M1 5H33"/></svg>${escaped(s.name)}</li>`).join("")}</ul>`;
  return `<svg viewBox="0 0 ${box.width} ${box.height}" role="img" aria-label="${escaped(yName)} over ${escaped(xName)}">${parts.join("")}</svg>${legend}`;
}

/** @param points [[x, y], ...] @param options those of `seriesChart` @return svg; empty for fewer than two points */
export const lineChart = (points, xName, yName, options) => seriesChart([{ points }], xName, yName, options);
