// A small chart of numbers that come one after the other.
import { escaped, three } from "./words.js";

const box = { width: 640, height: 260, left: 64, right: 12, top: 14, bottom: 40 };

const ticks = (from, to) => {
  const rough = (to - from) / 4, power = 10 ** Math.floor(Math.log10(rough)), step = [1, 2, 5, 10].find((k) => k * power >= rough) * power;
  const all = [];
  for (let t = Math.ceil(from / step - 1e-9) * step; t <= to + 1e-9 * step; t += step) all.push(Math.abs(t) < 1e-9 * step ? 0 : t);
  return all;
};

const rangeOf = (values) => {
  const low = Math.min(...values), high = Math.max(...values), margin = (high - low || Math.abs(high) || 1) * 0.05;
  return [low - margin, high + margin];
};

/** @param points [[x, y], ...] @return svg; empty for fewer than two points */
export function lineChart(points, xName, yName) {
  if (points.length < 2) return "";
  const [x0, x1] = rangeOf(points.map((p) => p[0])), [y0, y1] = rangeOf(points.map((p) => p[1]));
  const x = (v) => box.left + ((v - x0) / (x1 - x0)) * (box.width - box.left - box.right);
  const y = (v) => box.height - box.bottom - ((v - y0) / (y1 - y0)) * (box.height - box.top - box.bottom);
  const parts = ticks(y0, y1).map((t) => `<path class="gr" d="M${box.left} ${y(t)}H${box.width - box.right}"/><text class="e" x="${box.left - 6}" y="${y(t) + 4.5}">${three(t)}</text>`);
  parts.push(...ticks(x0, x1).map((t) => `<text class="m" x="${x(t)}" y="${box.height - box.bottom + 18}">${three(t)}</text>`));
  parts.push(`<path class="ax" d="M${box.left} ${box.height - box.bottom}H${box.width - box.right}"/>`,
    `<text class="e s" x="${box.width - box.right}" y="${box.height - 6}">${escaped(xName)}</text><text class="s" x="2" y="11">${escaped(yName)}</text>`,
    `<path class="ln mine" d="${points.map((p, k) => `${k ? "L" : "M"}${x(p[0]).toFixed(1)} ${y(p[1]).toFixed(1)}`).join("")}"/>`);
  return `<svg viewBox="0 0 ${box.width} ${box.height}" role="img" aria-label="${escaped(yName)} over ${escaped(xName)}">${parts.join("")}</svg>`;
}
