// The editor of grading curves: a chart whose points are dragged or moved by keys. On the page of `suffuse assess --page` and
// in the studio.
"use strict";

globalThis.CurveChart = (() => {
  const three = (x) => (x === undefined ? "" : x >= 1000 ? Math.round(x).toLocaleString("en") : String(Number(x.toPrecision(3))));
  const mm = (x) => three(1e3 * x);
  /** "0.24 to at least 0.68": a range of numbers some of which may be bounds, or one number where its ends look alike. */
  const rangeText = (numbers, hasMost, hasLeast, text) => {
    const [low, high] = [Math.min(...numbers), Math.max(...numbers)].map(text);
    const most = hasMost ? "at most " : "", least = hasLeast ? "at least " : "";
    return low !== high ? `${most}${low} to ${least}${high}` : most && least ? `about ${low}` : `${most}${least}${low}`;
  };
  /** A factor of safety: never rounded to 1 from below. */
  const factor = (x) => (x < 1 ? Math.min(x, 0.99).toFixed(2) : x.toFixed(1));
  const escaped = (text) => text.replace(/[&<>"]/g, (c) => ({ "&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;" })[c]);

  /** Drawn for a desk or for a phone. */
  const shapes = {
    wide: { width: 720, height: 398, left: 52, right: 12, top: 44, bottom: 44 },
    narrow: { width: 358, height: 330, left: 48, right: 8, top: 44, bottom: 44 },
  };

  /** Where the chart has a size [m] and a share. */
  const scalesOf = (plot, soils) => {
    let low = Infinity, high = 0;
    for (const s of soils) { low = Math.min(low, s.d[0]); high = Math.max(high, s.d[s.d.length - 1]); }
    const from = Math.log10(low / 1.4), to = Math.log10(high * 1.4);
    const { width, height, left, right, top, bottom } = plot;
    return {
      from, to,
      x: (d) => left + ((Math.log10(d) - from) / (to - from)) * (width - left - right),
      y: (f) => top + (1 - f) * (height - top - bottom),
      d: (x) => 10 ** (from + ((x - left) / (width - left - right)) * (to - from)),
      f: (y) => 1 - (y - top) / (height - top - bottom),
    };
  };

  const frame = (s, plot) => {
    const parts = [], { width, height, left, right, top, bottom } = plot;
    for (const [name, from, to] of [["clay", 0, 2e-6], ["silt", 2e-6, 63e-6], ["sand", 63e-6, 2e-3], ["gravel", 2e-3, 63e-3], ["cobbles", 63e-3, 1e3]]) {
      const a = Math.max(s.x(Math.max(from, 1e-9)), left), b = Math.min(s.x(to), width - right);
      if (b - a < 8) continue;
      if (name === "sand" || name === "clay") parts.push(`<rect class="band" x="${a}" y="${top}" width="${b - a}" height="${height - top - bottom}"/>`);
      if (b - a > 40) parts.push(`<text class="m s" x="${(a + b) / 2}" y="${top - 8}">${name}</text>`);
    }
    for (let f = 0; f <= 1.001; f += 0.2) {
      parts.push(`<path class="gr" d="M${left} ${s.y(f)}H${width - right}"/><text class="e" x="${left - 8}" y="${s.y(f) + 4.5}">${Math.round(100 * f)} %</text>`);
    }
    const steps = plot === shapes.narrow && s.to - s.from > 2 ? [1] : [1, 2, 5];
    for (let e = Math.floor(s.from); e <= s.to; ++e) {
      for (const step of steps) {
        const d = step * 10 ** e;
        if (Math.log10(d) < s.from || Math.log10(d) > s.to) continue;
        parts.push(`<path class="ax" d="M${s.x(d)} ${height - bottom}v5"/><text class="m" x="${s.x(d)}" y="${height - bottom + 20}">${Number((1e3 * d).toPrecision(1))}</text>`);
      }
    }
    parts.push(`<text class="s" x="2" y="12">finer than, by mass</text>`);
    parts.push(`<path class="ax" d="M${left} ${height - bottom}H${width - right}"/><text class="e s" x="${width - right}" y="${height - 6}">grain diameter in mm</text>`);
    return parts;
  };

  const line = (s, soil, kind, title = "") =>
    `<path class="ln ${kind}" d="${soil.d.map((d, j) => `${j ? "L" : "M"}${s.x(d)} ${s.y(soil.f[j])}`).join("")}">${title ? `<title>${escaped(title)}</title>` : ""}</path>`;

  /** Colors of the curves that are shown and not edited: one each, or none where there are many. */
  const colorsOf = (others) => (others.length <= 5 ? ["k1", "k2", "k3", "k4", "k5"].slice(0, others.length) : []);

  /**
   * Makes an svg element the chart of curves, one of which is edited.
   * @param soils gives all curves { name, d [m], f }, and `which` the number of the edited one
   * @param marks gives more svg, for a scale and the plot's box @param changed is called when a point was moved
   */
  const attach = (svg, { soils, which, changed, marks = () => "" }) => {
    let plot, held = null;
    const here = () => soils()[which()];
    const scales = () => scalesOf(plot, soils());

    const draw = () => {
      plot = window.innerWidth < 641 ? shapes.narrow : shapes.wide;
      const s = scales(), soil = here(), others = soils().filter((each) => each !== soil), colors = colorsOf(others);
      svg.setAttribute("viewBox", `0 0 ${plot.width} ${plot.height}`);
      const knobs = soil.d.map((d, j) =>
        `<circle class="knob" data-point="${j}" tabindex="0" role="slider" aria-label="${mm(d)} mm" aria-valuenow="${three(100 * soil.f[j])}" cx="${s.x(d)}" cy="${s.y(soil.f[j])}" r="6"/>`);
      svg.innerHTML = [...frame(s, plot), marks(s, plot), ...others.map((each, k) => line(s, each, `other ${colors[k] ?? ""}`, each.name)),
        line(s, soil, "mine"), ...knobs].join("");
    };

    const move = (point, x, y) => {
      const soil = here(), s = scales(), n = soil.d.length;
      soil.isEdited = true;
      const low = point > 0 ? soil.f[point - 1] : 0, high = point + 1 < n ? soil.f[point + 1] : 1;
      soil.f[point] = Math.min(high, Math.max(low, Math.round(1000 * s.f(y)) / 1000));
      const least = point > 0 ? soil.d[point - 1] * 1.01 : 0, most = point + 1 < n ? soil.d[point + 1] / 1.01 : Infinity;
      if (x !== null) soil.d[point] = Math.min(most, Math.max(least, Number(s.d(x).toPrecision(3))));
      changed();
    };

    svg.addEventListener("pointerdown", (event) => {
      const point = event.target.dataset?.point;
      if (point === undefined) return;
      held = Number(point);
      svg.setPointerCapture(event.pointerId);
      event.preventDefault();
    });
    svg.addEventListener("pointermove", (event) => {
      if (held === null) return;
      const box = svg.getBoundingClientRect();
      const x = ((event.clientX - box.left) / box.width) * plot.width, y = ((event.clientY - box.top) / box.height) * plot.height;
      move(held, event.shiftKey ? x : null, y);
    });
    svg.addEventListener("lostpointercapture", () => { held = null; }); // let go, or taken by the browser
    svg.addEventListener("keydown", (event) => {
      const point = Number(event.target.dataset?.point), step = { ArrowUp: 0.01, ArrowDown: -0.01 }[event.key];
      if (step === undefined || Number.isNaN(point)) return;
      event.preventDefault();
      move(point, null, scales().y(here().f[point] + step));
      svg.querySelector(`[data-point="${point}"]`).focus();
    });
    return { draw };
  };

  return { attach, colorsOf, three, mm, rangeText, factor, escaped };
})();
