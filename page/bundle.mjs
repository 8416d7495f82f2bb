// bundle.mjs OUT_DIR: the page's script as one file, its hash for the page's content policy, the notices that the
// licenses of the bundled packages ask for, the page of the studio, and the program that draws figures in Node. The packages stand in OUT_DIR/npm, so that the source tree stays clean.
import { createHash } from "node:crypto";
import { copyFileSync, existsSync, readdirSync, readFileSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { dirname, join, relative, resolve, sep } from "node:path";
import { fileURLToPath } from "node:url";

const out = resolve(process.argv[2]);
const modules = join(out, "npm", "node_modules");
const { buildSync } = createRequire(join(out, "npm", "package.json"))("esbuild");

const sources = join(dirname(fileURLToPath(import.meta.url)), "src");
const common = {
  bundle: true,
  minify: true,
  charset: "ascii",
  legalComments: "none",
  nodePaths: [modules],
  absWorkingDir: modules,
  write: false,
};
const result = buildSync({
  ...common,
  entryPoints: [join(sources, "main.js")],
  format: "iife",
  target: ["es2022"],
  metafile: true,
});
const inNode = buildSync({
  ...common,
  entryPoints: [join(sources, "figures.js")],
  platform: "node",
  format: "esm",
  target: ["node18"],
  external: ["canvas"], // Vega draws pixels with it where it is there; SVG needs none
});
writeFileSync(join(out, "figures.mjs"), inNode.outputFiles[0].text);

// The page of `suffuse studio`: one script, one style sheet.
for (const [from, to] of [["main.js", "studio.js"], ["page.css", "studio.css"]]) {
  const studio = buildSync({ ...common, entryPoints: [join(sources, "studio", from)], format: "iife", target: ["es2022"] });
  writeFileSync(join(out, to), studio.outputFiles[0].text);
}
copyFileSync(join(sources, "studio", "page.html"), join(out, "studio.html"));

const code = result.outputFiles[0].text;
if (code.includes("</script") || code.includes("\r")) {
  throw new Error("the bundle holds text that cannot stand in a script element");
}
writeFileSync(join(out, "page.js"), code);
writeFileSync(join(out, "page.js.sha256"), createHash("sha256").update(code).digest("base64") + "\n");
writeFileSync(join(out, "notices.txt"), notices(result.metafile.outputs));
console.log(`page.js: ${Math.round(code.length / 1024)} KiB`);

/** Name, version and license text of each package that has bytes in the bundle. */
function notices(outputs) {
  const packages = new Map();
  for (const output of Object.values(outputs)) {
    for (const [file, { bytesInOutput }] of Object.entries(output.inputs)) {
      const path = resolve(modules, file);
      if (bytesInOutput === 0 || !path.startsWith(modules + sep)) continue;
      const name = relative(modules, path).split(sep);
      const folder = join(modules, ...name.slice(0, name[0].startsWith("@") ? 2 : 1));
      packages.set(folder, JSON.parse(readFileSync(join(folder, "package.json"), "utf8")));
    }
  }
  const texts = [...packages].map(([folder, { name, version, license }]) => {
    const file = readdirSync(folder).find((each) => /^licen[cs]e/i.test(each));
    const text = file && existsSync(join(folder, file)) ? readFileSync(join(folder, file), "utf8").trim() : "";
    return { title: `${name} ${version} (${license})`, text };
  });
  // Many packages of one family share one text: say it once.
  const byText = new Map();
  for (const { title, text } of texts) byText.set(text, [...(byText.get(text) ?? []), title]);
  return [...byText].map(([text, titles]) => `${titles.join(", ")}\n\n${text}\n`).join(`\n${"-".repeat(72)}\n\n`);
}
