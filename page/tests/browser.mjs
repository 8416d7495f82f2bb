// What all tests share: the browser, the sample runs that page/test.sh wrote, and an independent reading of their CSV.
import { readdirSync, readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { join } from "node:path";
import { pathToFileURL } from "node:url";

// Only against a test that would never end: how long a machine takes is no matter of the page.
export const patience = 300_000; // [ms]

export const samples = process.env.SUFFUSE_SAMPLES;
export const fromPage = createRequire(join(process.env.SUFFUSE_PAGE, "npm", "package.json"));

/** Chromium as a container's root user runs it: without its sandbox, drawing 3D by software. */
export async function launch(more = []) {
  const { chromium } = fromPage("playwright-core");
  const executablePath = process.env.SUFFUSE_CHROMIUM;
  try {
    return await chromium.launch({
      executablePath,
      timeout: patience,
      args: ["--no-sandbox", ...(more.length ? more : ["--use-angle=swiftshader", "--enable-unsafe-swiftshader"])],
    });
  } catch (error) {
    const { version } = fromPage("playwright-core/package.json");
    throw new Error(`playwright-core ${version} cannot drive ${executablePath}: ${error.message}`);
  }
}

/** A report opened and drawn, with all that it complained of or requested. */
export async function open(browser, run, options = {}) {
  // Scrolling at once: a place that is read while the page still glides is no place to click at.
  const context = await browser.newContext({ viewport: { width: 1280, height: 900 }, reducedMotion: "reduce", ...options });
  context.setDefaultTimeout(patience);
  context.setDefaultNavigationTimeout(patience);
  const page = await context.newPage();
  const seen = { requests: [], complaints: [] };
  page.on("request", (request) => seen.requests.push(request.url()));
  page.on("console", (message) => seen.complaints.push(message.text()));
  page.on("pageerror", (error) => seen.complaints.push(error.message));
  page.on("dialog", (dialog) => seen.complaints.push(dialog.message()) && dialog.dismiss());
  await page.goto(pathToFileURL(join(samples, run, "report.html")).href);
  if (options.javaScriptEnabled !== false && run !== "plain") {
    await page.waitForFunction(() => document.documentElement.dataset.drawn === "all");
  }
  return { page, context, ...seen };
}

export const files = (run, ending) => readdirSync(join(samples, run, "figures")).filter((name) => name.endsWith(ending));

const fieldsOf = (line) =>
  [...line.matchAll(/(?:^|,)(?:"((?:[^"]|"")*)"|([^,]*))/g)].map(([, quoted, plain]) => quoted?.replaceAll('""', '"') ?? plain);

/** Header and rows as text. */
export function csv(run, id) {
  const lines = readFileSync(join(samples, run, "figures", `${id}.csv`), "utf8").trim().split("\n");
  const [header, ...rows] = lines.filter((line) => !line.startsWith("#")).map(fieldsOf);
  return { header, rows };
}

/** Waits until the view in 3D has drawn what was specified of it last. */
export async function settled(page) {
  await page.waitForFunction(() => !document.querySelector("[data-scene]").view.waiting);
}

/** Does `act`, whose input must make the view draw, and waits for a frame drawn after it. */
export async function drawnAfter(page, act) {
  const frames = () => page.evaluate(() => Number(document.querySelector(".picture").dataset.frames));
  await settled(page);
  const before = await frames();
  await act();
  await page.waitForFunction((count) => Number(document.querySelector(".picture").dataset.frames) > count, before);
  await settled(page);
}

/** Share of the view's pixels that are not its paper, and the number of colors among a sample of them. */
export async function pixels(page) {
  await settled(page);
  return page.evaluate(() => {
    const { view } = document.querySelector("[data-scene]");
    view.draw(); // what WebGL has drawn can be read until the browser shows it
    const copy = document.createElement("canvas");
    [copy.width, copy.height] = [view.canvas.width, view.canvas.height];
    const paint = copy.getContext("2d");
    paint.drawImage(view.canvas, 0, 0);
    const { data } = paint.getImageData(0, 0, copy.width, copy.height);
    let drawn = 0;
    let sum = 0;
    const colors = new Set();
    for (let k = 0; k < data.length; k += 4) {
      const away = [0, 1, 2].some((c) => Math.abs(data[k + c] - data[c]) > 6);
      if (!away) continue;
      ++drawn;
      sum = (sum * 31 + data[k] * 65536 + data[k + 1] * 256 + data[k + 2]) % 4294967296;
      if (drawn % 37 === 0) colors.add((data[k] >> 4) * 256 + (data[k + 1] >> 4) * 16 + (data[k + 2] >> 4));
    }
    return { share: drawn / (data.length / 4), print: sum, colors: colors.size };
  });
}
