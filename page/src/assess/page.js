// The page of `suffuse assess --page`: a curve that can be dragged, typed or pasted, sliders, and verdicts that follow.
"use strict";

const pageData = JSON.parse(document.getElementById("data").textContent);
const state = { which: 0, soils: pageData.soils.map((s) => ({ name: s.name, d: [...s.d], f: [...s.f] })), ...pageData.seepage };
const $ = (id) => document.getElementById(id);
const { three, rangeText, factor, escaped } = CurveChart;
const isVertical = state.flow === "upward", lifts = isVertical || state.flow === "rising";
const here = () => state.soils[state.which];
const sign = {
  stable: ["ok", "✓ stable"], unstable: ["no", "✗ unstable"], "cannot say": ["un", "? cannot say"],
  holds: ["ok", "✓ holds"], fails: ["no", "✗ fails"],
};

/** Against a limit of vertical flow. Below it, flow that rises at an angle has none; other flow has none at all. */
const factorOf = (limit) => (state.gradient > 0 && lifts && (isVertical || state.gradient >= limit) ? limit / state.gradient : undefined);

const limitText = (c) =>
  c.limit === undefined ? "" : c.upper !== undefined ? `${three(c.limit)} to ${three(c.upper)}`
    : `${c.sense === "at-most" ? (c.strict ? "<" : "≤") : c.strict ? ">" : "≥"} ${three(c.limit)}`;

const numberText = (c) =>
  c.range ? `${three(c.range[0])} to ${three(c.range[1])}` : c.measured !== undefined ? `(${three(c.measured)})`
    : c.value !== undefined ? three(c.value) : "–";

/** A curve that was pasted or dragged is another soil than the file's. */
const shownName = (soil) => soil.name + (soil.isEdited ? " (edited)" : "");

const chart = CurveChart.attach($("chart"), { soils: () => state.soils, which: () => state.which, changed: () => draw() });

function drawChart() {
  chart.draw();
  const others = state.soils.map((soil, k) => ({ soil, k })).filter(({ k }) => k !== state.which), colors = CurveChart.colorsOf(others);
  $("legend").innerHTML = colors.length ? [`<b class="mine">— ${escaped(shownName(here()))}</b>`,
    ...others.map(({ soil, k }, row) => `<a href="#soil" class="${colors[row]}" data-soil="${k}">— ${escaped(soil.name)}</a>`)].join(" ") : "";
  const soil = here();
  const ends = [soil.f[0] > 0 ? `${three(100 * soil.f[0])} % is finer than the last size` : "", soil.f[soil.f.length - 1] < 1 ? `${three(100 * (1 - soil.f[soil.f.length - 1]))} % is coarser than the first` : ""].filter(Boolean);
  $("chart-note").textContent = `Grey band: sand, 0.063 to 2 mm (ISO 14688).${ends.length ? ` The curve is open: ${ends.join(", ")}.` : ""}`;
  $("printed-points").textContent = `Passing: ${soil.d.map((d, k) => `${Number((1e3 * d).toPrecision(6))} mm ${Number((100 * soil.f[k]).toPrecision(4))} %`).join(", ")}.`;
}

/** Whose gradient it is: the user's of the command line, or the reader's who moved the slider. */
const sourceOf = (i) => (i === pageData.seepage.gradient ? "specified" : "set here");

/** The gradient on one line with those that lift the fines and the soil. */
function drawGradients(found) {
  $("gradients").toggleAttribute("hidden", !lifts);
  const width = 330, height = 62, left = 14, right = 12, line = 34, i = state.gradient;
  const most = Math.max(found.heave, i, found.fines ?? 0) * 1.12, x = (g) => left + (g / most) * (width - left - right);
  const parts = [`<rect class="fail" x="${x(found.heave)}" y="${line - 5}" width="${width - right - x(found.heave)}" height="10"/>`,
    `<path class="ax" d="M${left} ${line}H${width - right}"/>`];
  const step = most > 2 ? 1 : most > 1 ? 0.5 : 0.2;
  for (let g = 0; g <= most; g += step) parts.push(`<path class="ax" d="M${x(g)} ${line}v5"/><text class="m s" x="${x(g)}" y="${line + 19}">${g.toFixed(1)}</text>`);
  const mark = (g, kind, text, row) => {
    const isRight = x(g) > width * 0.6;
    parts.push(`<path class="${kind}" stroke-width="2.5" d="M${x(g)} ${line - 9}v18"/><text class="${kind}${isRight ? " e" : ""}" x="${x(g) + (isRight ? 3 : -3)}" y="${row}">${text}</text>`);
  };
  mark(found.heave, "heave", `heave ${found.heave.toFixed(2)}`, 22);
  if (i > 0) mark(i, "asked", `${sourceOf(i)} ${i.toFixed(2)}`, Math.abs(x(i) - x(found.heave)) < 170 && x(i) > width * 0.35 ? 10 : 22);
  if (found.fines !== undefined) parts.push(`<path class="ax" stroke-dasharray="3 2" d="M${x(found.fines)} ${line - 9}v18"/>`);
  $("gradients").setAttribute("viewBox", `0 0 ${width} ${height}`);
  $("gradients").innerHTML = parts.join("");
}

/** What the atlas says of the curve as given: when this flow moves 1 % of its fines, over all densities. */
function atlasWords() {
  const { place } = pageData.soils[state.which];
  if (!place || place.moves.length === 0 || here().isEdited) return [];
  const gradients = place.moves.map((node) => node.i1_over_ic * Criteria.heaveAt(state.density, node.porosity));
  const hasMost = place.moves.some((node) => node.at_most), hasLeast = place.moves.some((node) => node.at_least);
  const range = (numbers, text) => rangeText(numbers, hasMost, hasLeast, text), i = state.gradient;
  return [`1 % of the fines move at <i>i</i> = ${range(gradients, (x) => x.toFixed(2))} (atlas${isVertical ? "" : `, ${state.flow} flow`})${isVertical && i > 0 ? `: factor of safety ${range(gradients.map((g) => g / i), factor)}` : ""}.`];
}

function words(criteria, found) {
  const { counted, unstable } = Criteria.tally(criteria), fs = factorOf(found.heave);
  const lines = [counted === 0 ? "No criterion can say of this curve alone."
    : unstable === 0 ? `None of ${counted} criteria says unstable.` : `${unstable} of ${counted} criteria say unstable.`, ...atlasWords()];
  if (fs !== undefined) lines.push(`Factor of safety ${factor(fs)} against heave of the whole soil.`);
  return lines;
}

function drawSafety(found) {
  const i = state.gradient, text = [];
  const safety = (limit, kind) => (factorOf(limit) === undefined ? "" : `: <b${kind}>factor of safety ${factor(factorOf(limit))}</b>`);
  if (!lifts) {
    text.push(`Only upward flow lifts grains: heave and α<i>i</i><sub>c</sub> are no limits of ${state.flow} flow.`);
  } else {
    text.push(`Heave at <i>i</i> = ${found.heave.toFixed(2)}${safety(found.heave, "")}.`);
    text.push(found.fines !== undefined
      ? `Fines leave at α<i>i</i><sub>c</sub> = ${found.fines.toFixed(2)} (α ${three(found.share)})${safety(found.fines, ` class="${found.fines < i ? "no" : "ok"}"`)}.`
      : `α of the fines is not known${i > 0 ? `: they stay in place only where it is at least ${three(found.needed)}` : ""}.`);
    if (!isVertical) text.push(`Both are limits of vertical flow: ${state.flow} flow moves grains at lower gradients, too.`);
  }
  $("safety").innerHTML = text.map((t) => `<p>${t}</p>`).join("");
}

const rowsOf = (criteria) => criteria.map((c) =>
  `<tr><td>${c.name}${c.verified ? "" : " <small>unverified</small>"}${c.why ? `<small>${escaped(c.why)}</small>` : ""}</td><td>${c.measure}</td><td class="n">${numberText(c)}${limitText(c) ? `<small class="lim-small">${limitText(c)}</small>` : ""}</td><td class="n lim">${limitText(c)}</td><td class="${sign[c.verdict][0]}">${sign[c.verdict][1]}</td></tr>`).join("");

/** What the program said of the filter. It holds for the curve as given alone, so it goes when that is changed. */
function drawFilter() {
  const given = pageData.soils[state.which], filter = given.filter;
  $("filter").hidden = !filter;
  if (!filter) return;
  const isGiven = here().d.every((d, k) => d === given.d[k]) && here().f.every((f, k) => f === given.f[k]) && here().d.length === given.d.length;
  const known = (value) => (value === null ? undefined : value);
  $("filter-rules").hidden = !isGiven;
  $("filter-note").textContent = isGiven ? `The filter ${filter.filter} ${filter.summary}. ${filter.simulated.summary}`
    : "The curve was changed. What is known of the filter is of the curve as given: suffuse assess --filter judges another.";
  $("rules").innerHTML = rowsOf(filter.criteria.map((c) => ({
    ...c, why: c.remark, value: known(c.value), measured: known(c.measured), limit: known(c.limit), upper: known(c.upper) })));
}

/** Where the program found the curve as given. */
function drawAtlas() {
  const { place } = pageData.soils[state.which];
  $("atlas-maps").innerHTML = AtlasMap.draw(pageData.atlas, place);
  $("atlas-note").textContent = "Each cell is a simulated soil: the gradient of upward flow that moves 1 % of its fines, over that of heave. " +
    (place ? `The ring is ${here().isEdited ? "the curve as given" : "this soil"}: D50/d50 ${three(place.ratio)}, ${three(100 * place.fines)} % of fines${place.inside ? "" : ", outside the atlas"}.`
      : "This soil has no place among them: no unstable split of the measured curve was found, or its flow is downward.");
}

function drawMatrix() {
  $("all").hidden = state.soils.length < 2;
  if (state.soils.length < 2) return;
  const rows = state.soils.map((soil, k) => ({ soil, k, criteria: Criteria.assess(soil) }));
  rows.sort((a, b) => Criteria.tally(b.criteria).unstable - Criteria.tally(a.criteria).unstable);
  $("matrix-head").innerHTML = `<th>sample</th>${rows[0].criteria.map((c) => `<th>${c.name}</th>`).join("")}<th class="n">unstable by ▼</th>`;
  $("matrix").innerHTML = rows.map(({ soil, k, criteria }) => {
    const { counted, unstable } = Criteria.tally(criteria);
    return `<tr class="${k === state.which ? "hi" : ""}"><th scope="row"><a href="#soil" data-soil="${k}">${escaped(soil.name)}</a></th>${criteria.map((c) =>
      `<td class="${sign[c.verdict][0]}">${sign[c.verdict][1][0]} ${numberText(c)}</td>`).join("")}<td class="n"><b>${unstable} of ${counted}</b></td></tr>`;
  }).join("");
}

function draw(keepText) {
  const criteria = Criteria.assess(here());
  const found = Criteria.gradients(state, criteria);
  $("verdict").innerHTML = words(criteria, found).map((w) => `<span>${w}</span>`).join("");
  $("name").textContent = shownName(here());
  document.title = `Internal stability of ${shownName(here())}`;
  drawChart();
  $("criteria").innerHTML = rowsOf(criteria);
  drawFilter();
  drawAtlas();
  drawSafety(found);
  drawGradients(found);
  drawMatrix();
  if (!keepText) $("points").value = here().d.map((d, k) => `${Number((1e3 * d).toPrecision(6))}\t${Number((100 * here().f[k]).toPrecision(6))}`).join("\n");
  for (const name of ["alpha", "porosity", "density", "gradient"]) {
    const value = state[name];
    $(`${name}-text`).textContent = value === null || value === undefined ? (name === "gradient" ? "not given" : "not known") : name === "density" || name === "alpha" ? three(value) : value.toFixed(2);
    if (value !== null && value !== undefined) $(name).value = value;
  }
  const isKnown = state.alpha !== null && state.alpha !== undefined; // a slider stands somewhere all the same
  $("alpha-row").classList.toggle("unset", !isKnown);
  $("alpha-note").textContent = isKnown ? "given" : "drag to set";
  $("unknown").hidden = !isKnown;
  $("gradient-row").classList.toggle("unset", state.gradient === null);
  $("gradient-name").innerHTML = isVertical ? "Upward gradient <i>i</i>" : `Gradient <i>i</i> of ${state.flow} flow`;
  $("gradient-note").textContent = state.gradient === null ? "drag to set" : sourceOf(state.gradient);
}

/** A pasted or typed table: two numbers a line, the size in mm, percent passing; headings and comments are no lines. */
function readPoints(text) {
  const points = [];
  for (const line of text.split(/\r?\n/)) {
    const tidy = /[;\t]/.test(line) || !/\d,\d+[,\s]/.test(`${line} `) ? line.replace(/(\d),(\d)/g, "$1.$2") : line;
    const numbers = tidy.split(/[\s;,]+/).filter(Boolean).map(Number);
    if (!line.trim() || line.trim().startsWith("#")) continue;
    if (numbers.length !== 2 || numbers.some(Number.isNaN)) {
      if (points.length === 0) continue; // a heading
      throw new Error(`"${line}": two numbers are wanted, the size in mm and percent passing`);
    }
    points.push({ d: numbers[0] / 1e3, f: numbers[1] / 100 });
  }
  points.sort((a, b) => a.d - b.d);
  if (points.length < 2) throw new Error("two lines at least: size in mm, percent passing");
  points.forEach((p, k) => {
    if (!(p.d > 0) || p.f < 0 || p.f > 1) throw new Error(`${1e3 * p.d} mm, ${100 * p.f} %: sizes are above 0, percents from 0 to 100`);
    if (k && p.f < points[k - 1].f) throw new Error(`percent passing falls at ${1e3 * p.d} mm: is it what is retained?`);
    if (k && p.d === points[k - 1].d) throw new Error(`${1e3 * p.d} mm occurs twice`);
  });
  if (points[0].f === points[points.length - 1].f) throw new Error("there is nothing between the sizes");
  return points;
}

function takeText() {
  try {
    const points = readPoints($("points").value);
    here().d = points.map((p) => p.d);
    here().f = points.map((p) => p.f);
    here().isEdited = true;
    $("complaint").textContent = "";
    draw(true);
  } catch (error) {
    $("complaint").textContent = error.message;
  }
}

function connect() {
  $("points").addEventListener("input", takeText);
  for (const name of ["alpha", "porosity", "density", "gradient"]) {
    $(name).addEventListener("input", () => { state[name] = Number($(name).value); draw(true); });
  }
  $("unknown").addEventListener("click", () => { state.alpha = null; draw(true); });
  $("which").innerHTML = state.soils.map((s, k) => `<option value="${k}">${escaped(s.name)}</option>`).join("");
  $("which").parentElement.hidden = state.soils.length < 2;
  $("which").addEventListener("change", () => { state.which = Number($("which").value); draw(); });
  $("back").addEventListener("click", () => {
    const given = pageData.soils[state.which];
    here().d = [...given.d];
    here().f = [...given.f];
    here().isEdited = false;
    $("complaint").textContent = "";
    draw();
  });
  for (const place of ["matrix", "legend"]) {
    $(place).addEventListener("click", (event) => {
      const soil = event.target.dataset?.soil;
      if (soil !== undefined) { state.which = Number(soil); $("which").value = soil; draw(); }
    });
  }
  window.addEventListener("resize", drawChart);
}

connect();
draw();
if (location.hash === "#numbers") { // for page/check_assess.py: all numbers of all curves
  const numbers = document.createElement("pre");
  numbers.id = "numbers";
  numbers.textContent = JSON.stringify(state.soils.map((soil) => {
    const criteria = Criteria.assess(soil);
    return { soil: soil.name, criteria, gradients: Criteria.gradients(state, criteria) };
  }));
  document.body.append(numbers);
}
document.documentElement.dataset.drawn = "all";
