// What the criteria and the atlas say of a soil, as words, tables and marks on its curve. All numbers are the server's.
import { escaped, factor, mm, rangeText, three } from "./words.js";

const sign = { stable: ["ok", "✓ stable"], unstable: ["no", "✗ unstable"], "cannot say": ["un", "? cannot say"], transition: ["un", "~ transition"], holds: ["ok", "✓ holds"], fails: ["no", "✗ fails"] };

const limitText = (c) => c.stable_if.replace(">=", "≥").replace("<=", "≤");
const numberText = (c) => (c.value !== null ? three(c.value) : c.measured !== null ? `(${three(c.measured)})` : "–");
const row = (c) => `<tr><td>${escaped(c.name)}${c.verified ? "" : " <small>unverified, not counted</small>"}<small>${escaped(c.remark ?? "")}</small></td><td class="n">${numberText(c)}<small>${escaped(limitText(c))}</small></td><td class="${sign[c.verdict]?.[0] ?? "un"}">${sign[c.verdict]?.[1] ?? escaped(c.verdict)}</td></tr>`;
const table = (title, head, rows, numbers = [1]) => `<h2>${title}</h2><div class="tw"><table><thead><tr>${head.map((h, k) => `<th${numbers.includes(k) ? ' class="n"' : ""}>${h}</th>`).join("")}</tr></thead><tbody>${rows.join("")}</tbody></table></div>`;

function atlasTable(entries) {
  if (!entries?.length) return "";
  const number = (value, atMost, least) => (Number.isFinite(value) ? `${atMost ? "≤ " : ""}${three(value)}` : Number.isFinite(least) ? `≥ ${three(least)}` : "–");
  const rows = entries.map((e) => `<tr><td>${escaped(e.density)}, flow ${escaped(e.flow)}<small>${e.inside ? `porosity ${three(e.porosity)}` : "outside the atlas"}</small></td><td class="n">${number(e.i1, e.i1_at_most, e.lower_bounds.i1)}</td><td class="n">${number(e.i10, e.i10_at_most, e.lower_bounds.i10)}</td></tr>`);
  const { size_ratio: ratio, fines_content: content } = entries[0];
  return `${table("Simulated soils like it", ["density", "1 % move at <i>i</i>", "10 % move"], rows, [1, 2])}<p class="cap">From the atlas: D50/d50 ${three(ratio)}, ${three(100 * content)} % of fines.</p>`;
}

/** The answer in a few sentences. */
export function verdictLines(found, filterName) {
  const { stable, transition, unstable } = found.tally, counted = stable + transition + unstable, i = found.seepage?.gradient;
  const lines = [counted === 0 ? "No criterion can say of this curve alone." : unstable === 0 ? `None of ${counted} criteria says unstable.` : `${unstable} of ${counted} criteria say unstable.`];
  const moves = (found.atlas ?? []).filter((e) => e.inside && !e.wide_fines && e.flow === found.seepage?.flow && Number.isFinite(e.i1 ?? e.lower_bounds.i1));
  if (moves.length && i > 0) {
    const all = moves.map((e) => e.i1 ?? e.lower_bounds.i1);
    const hasMost = moves.some((e) => e.i1_at_most), hasLeast = moves.some((e) => e.i1 === null);
    const range = (numbers, text) => rangeText(numbers, hasMost, hasLeast, text);
    lines.push(`1 % of the fines move at i = ${range(all, (x) => x.toFixed(2))} (atlas): factor of safety ${range(all.map((g) => g / i), factor)}.`);
  }
  const heave = (found.gradients ?? []).find((c) => c.id === "terzaghi");
  if (heave && i > 0) lines.push(`Factor of safety ${factor(heave.limit / heave.value)} against heave of the whole soil.`);
  if (found.filter) lines.push(`The filter ${filterName} ${found.filter.summary}.`, found.filter.simulated.summary);
  return lines;
}

/** Every number of the answer, as HTML. */
export function answerTables(found, filterName) {
  const parts = [table("Criteria", ["criterion", "number", "verdict"], found.criteria.map(row))];
  if (found.gradients?.length) parts.push(table("Seepage", ["criterion", "number", "verdict"], found.gradients.map(row)));
  parts.push(atlasTable(found.atlas));
  if (found.filter) parts.push(table(`The filter ${escaped(filterName)}`, ["rule", "number", "verdict"], found.filter.criteria.map(row)));
  const sizes = found.sizes;
  parts.push(`<p class="cap">${["d10", "d50", "d60"].map((size) => `${size} ${sizes[size] === null ? "?" : mm(sizes[size])}`).join(", ")} mm; Cu ${found.uniformity === null ? "?" : three(found.uniformity)}.</p>`);
  return parts.join("");
}

/** What the curve shows of the answer, as svg. @param sizes that a case models [m], or null */
export function curveMarks(found, sizes, s, plot) {
  const parts = [], bottom = plot.height - plot.bottom;
  const band = (a, b, kind) => {
    const from = Math.max(s.x(a), plot.left), to = Math.min(s.x(b), plot.width - plot.right);
    if (to > from) parts.push(`<rect class="${kind}" x="${from}" y="${plot.top}" width="${to - from}" height="${bottom - plot.top}"/>`);
  };
  if (sizes) {
    band(1e-12, sizes[0], "cut");
    band(sizes[1], 1e3, "cut");
  }
  if (!found) return parts.join("");
  if (found.gap) band(found.gap.from, found.gap.to, "gap");
  parts.push(`<path class="limit" d="M${plot.left} ${s.y(found.finer_limit)}H${plot.width - plot.right}"><title>The criteria look for fines up to here</title></path>`);
  if (found.fine_fraction) {
    const { finer_than: size, content } = found.fine_fraction, x = s.x(size), isRight = x > plot.width * 0.6;
    parts.push(`<path class="mark" d="M${x} ${plot.top}V${bottom}"/><text class="why${isRight ? " e" : ""}" x="${x + (isRight ? -6 : 6)}" y="${plot.top + 14}">fines: ${three(100 * content)} % below ${mm(size)} mm</text>`);
  }
  return parts.join("");
}

/** What the marks mean, and where the curve is open. */
export function curveNotes({ f, isEdited }, found, sizes) {
  const notes = isEdited ? ["The curve was edited here."] : [];
  if (found?.gap) notes.push(`Shaded: the gap, ${mm(found.gap.from)} to ${mm(found.gap.to)} mm.`);
  if (sizes) notes.push("Grey: what the modeled part leaves out.");
  if (f[0] > 0) notes.push(`${three(100 * f[0])} % is finer than the last size.`);
  if (f[f.length - 1] < 1) notes.push(`${three(100 * (1 - f[f.length - 1]))} % is coarser than the first.`);
  return notes.join(" ");
}

/** Its points, for paper. */
export const pointsText = ({ name, d, f, isEdited }) =>
  `${name}${isEdited ? " (edited)" : ""}. Passing: ${d.map((x, k) => `${Number((1e3 * x).toPrecision(6))} mm ${Number((100 * f[k]).toPrecision(4))} %`).join(", ")}.`;
