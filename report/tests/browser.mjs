// What all tests share: the browser, the sample runs that report/test.sh wrote, and an independent reading of their CSV.
import { readdirSync, readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { join } from "node:path";
import { pathToFileURL } from "node:url";

export const samples = process.env.SUFFUSE_SAMPLES;
export const fromPage = createRequire(join(process.env.SUFFUSE_PAGE, "npm", "package.json"));

/** Chromium as a container's root user runs it: without its sandbox, drawing 3D by software. */
export async function launch() {
  const { chromium } = fromPage("playwright-core");
  const executablePath = process.env.SUFFUSE_CHROMIUM;
  try {
    return await chromium.launch({
      executablePath,
      args: ["--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"],
    });
  } catch (error) {
    const { version } = fromPage("playwright-core/package.json");
    throw new Error(`playwright-core ${version} cannot drive ${executablePath}: ${error.message}`);
  }
}

/** A report opened and drawn, with all that it complained of or asked for. */
export async function open(browser, run, options = {}) {
  const context = await browser.newContext({ viewport: { width: 1280, height: 900 }, ...options });
  const page = await context.newPage();
  const heard = { requests: [], complaints: [] };
  page.on("request", (request) => heard.requests.push(request.url()));
  page.on("console", (message) => heard.complaints.push(message.text()));
  page.on("pageerror", (error) => heard.complaints.push(error.message));
  page.on("dialog", (dialog) => heard.complaints.push(dialog.message()) && dialog.dismiss());
  await page.goto(pathToFileURL(join(samples, run, "report.html")).href);
  if (options.javaScriptEnabled !== false && run !== "plain") {
    await page.waitForFunction(() => document.documentElement.dataset.drawn === "all");
  }
  return { page, context, ...heard };
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
