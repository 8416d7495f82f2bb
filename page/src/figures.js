// node figures.js OUT_DIR FILE.vl.json...: draws each specification as OUT_DIR/FILE.svg, without a browser. Its numbers
// and its look are in the specification; title and caption go inside the SVG, for readers that cannot see it.
import { readFileSync, writeFileSync } from "node:fs";
import { basename, join } from "node:path";
import { parse, View, Warn } from "vega";
import { compile } from "vega-lite";
import { lowerIndicesOf } from "./indices.js";

const escaped = (text) => text.replace(/&/g, "&amp;").replace(/</g, "&lt;").replace(/>/g, "&gt;");

// A specification holds its data. One that a stranger wrote could name a file of this machine, or an address: nothing is loaded.
const refuse = async (place) => {
  throw new Error(`found data to be loaded from ${place}, expected all of it in the file`);
};
const loader = { load: refuse, sanitize: refuse, http: refuse, file: refuse };

async function draw(file, folder) {
  const specification = JSON.parse(readFileSync(file, "utf8"));
  const view = new View(parse(compile(specification).spec), { renderer: "none", logLevel: Warn, loader });
  const svg = lowerIndicesOf(await view.toSVG());
  view.finalize();
  const described = svg.replace(/^<svg[^>]*>/, (opening) => `${opening}<desc>${escaped(specification.description ?? "")}</desc>`);
  writeFileSync(join(folder, basename(file).replace(/\.vl\.json$/, ".svg")), described + "\n");
}

const [folder, ...files] = process.argv.slice(2);
for (const file of files) {
  try {
    await draw(file, folder);
  } catch (error) {
    console.error(`${file}: ${error.message}`);
    process.exitCode = 1;
  }
}
