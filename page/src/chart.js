// One chart: numbers from CSV, specification fitted to the width at hand, drawn as SVG. Vega's interpreter evaluates its
// expressions, so that the page's content policy can forbid scripts made from text.
import { csvParseRows } from "d3-dsv";
import { parse, View, Warn } from "vega";
import { expressionInterpreter } from "vega-interpreter";
import { compile } from "vega-lite";
import { Handler } from "vega-tooltip";
import { fitted } from "./fit.js";
import { lowerIndices } from "./indices.js";

const tooltip = new Handler({ disableDefaultStyle: true });

/** Rows as objects under the column's name without its unit; what reads as a number is one, what is empty is null. */
export function readTable(csv) {
  const lines = csvParseRows(csv.replace(/^#.*\n/gm, ""));
  const names = lines[0].map((heading) => heading.replace(/ \[[^\]]*\]$/, ""));
  const numeric = names.map((_, c) => lines.slice(1).every((line) => line[c] === "" || !Number.isNaN(Number(line[c]))));
  return lines.slice(1).map((line) =>
    Object.fromEntries(names.map((name, c) => [name, line[c] === "" ? null : numeric[c] ? Number(line[c]) : line[c]])),
  );
}

const narrow = 480; // below it, legends stand one under the other

export class Chart {
  constructor(figure, look, place) {
    place.chart = this; // for tests that ask the page for its numbers, and for the curious in the console
    this.figure = figure;
    this.look = look;
    this.place = place;
    this.rows = readTable(figure.csv);
  }

  /** Vega's view of the chart; without a container it can be turned into a file. */
  view(chart, config, options) {
    const specification = { ...chart, config, data: { values: this.rows }, description: this.figure.title };
    const vega = compile(specification).spec;
    return new View(parse(vega, null, { ast: true }), { expr: expressionInterpreter, logLevel: Warn, ...options });
  }

  async draw() {
    const width = this.place.clientWidth;
    if (width === 0 || Math.abs(width - (this.width ?? 0)) < 4) return;
    this.width = width;
    this.shown?.finalize();
    try {
      const stacked = width < narrow ? { columns: 2, layout: { top: { direction: "vertical", anchor: "start" } } } : {};
      const config = { ...this.look, background: null, aria: false, legend: { ...this.look.legend, ...stacked } };
      this.place.replaceChildren(); // what was drawn once, for pages without a script
      this.shown = this.view(fitted(this.figure.chart, width), config, {
        renderer: "svg",
        container: this.place,
        hover: true,
        tooltip: tooltip.call,
      });
      await this.shown.runAsync();
      const drawing = this.place.querySelector("svg");
      for (const text of drawing.querySelectorAll("text")) {
        if (text.textContent.includes("_")) text.innerHTML = lowerIndices(text.innerHTML);
      }
      drawing.setAttribute("role", "img");
      drawing.setAttribute("aria-labelledby", `${this.figure.id}-title`);
      drawing.setAttribute("aria-describedby", `${this.figure.id}-caption`);
      this.place.dataset.rows = this.rows.length;
    } catch (error) {
      this.place.textContent = `This chart could not be drawn (${error.message}). Its numbers are below.`;
      console.error(this.figure.id, error);
    }
  }

  /** The chart as it goes to print: its own size, dark ink on white. */
  async printed() {
    const view = this.view(this.figure.chart, this.look, { renderer: "none" });
    await view.runAsync();
    return view;
  }
}
