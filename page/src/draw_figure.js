// Draws a Vega-Lite specification as SVG, without a browser. Its numbers and its look are in the specification; title and
// caption go inside the SVG, for readers that cannot see it.
import { readFileSync, writeFileSync } from "node:fs";
import { basename, join } from "node:path";
import { parse, textMetrics, View, Warn } from "vega";
import { compile } from "vega-lite";
import { fitted } from "./fit.js";
import { lowerIndicesOf } from "./indices.js";
import { textWidth } from "./text_width.js";

textMetrics.width = textWidth;

const pageWidth = 640; // of a figure in its column
const escaped = (text) => text.replace(/&/g, "&amp;").replace(/</g, "&lt;").replace(/>/g, "&gt;");

// A specification holds its data. One that someone else wrote could name a file of this machine, or an address: nothing is loaded.
const refuse = async (place) => {
  throw new Error(`found data to be loaded from ${place}, expected all of it in the file`);
};
const loader = { load: refuse, sanitize: refuse, http: refuse, file: refuse };

/** Coordinates, which stand within tags, to a tenth of a pixel: what the eye cannot see need not be carried. */
const shortened = (svg) => svg.replace(/<[^>]*>/g, (tag) => tag.replace(/(\.\d)\d+/g, "$1"));

/** Draws `file`.vl.json into `folder`, as the command specifies. */
export async function draw(file, folder, options) {
  const whole = JSON.parse(readFileSync(file, "utf8"));
  const width = options.width ? Number(options.width) : options["in-page"] ? pageWidth : undefined;
  const specification = width ? fitted(whole, width) : whole;
  const config = { ...specification.config };
  if (options.font) config.font = options.font;
  if (options["in-page"]) Object.assign(config, { background: null, aria: false });
  const view = new View(parse(compile({ ...specification, config }).spec), { renderer: "none", logLevel: Warn, loader });
  let svg = lowerIndicesOf(await view.toSVG());
  view.finalize();
  if (options["in-page"]) {
    svg = shortened(svg);
  } else {
    svg = svg.replace(/^<svg[^>]*>/, (opening) => `${opening}<desc>${escaped(specification.description ?? "")}</desc>`);
  }
  if (options.width) {
    // To the specified width, whatever labels and titles took: the drawing is scaled as a whole.
    const [, drawn, height] = /viewBox="0 0 ([\d.]+) ([\d.]+)"/.exec(svg).map(Number);
    svg = svg.replace(/^<svg[^>]*>/, (opening) =>
      opening.replace(/ width="[^"]*"/, ` width="${width}"`).replace(/ height="[^"]*"/, ` height="${(height * width) / drawn}"`),
    );
  }
  writeFileSync(join(folder, basename(file).replace(/\.vl\.json$/, ".svg")), svg + "\n");
}
