// The studio as the tests of its page have it: the real program in a folder of its own, and a browser.
import { execFileSync, spawn } from "node:child_process";
import { mkdirSync, mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { launch, patience } from "./browser.mjs";

export const gap = "d [mm],passing [%]\n0.25,0\n0.3,10\n0.36,18\n0.40,20\n0.9,21\n1.1,45\n1.3,75\n1.5,100\n";

const program = process.env.SUFFUSE_PROGRAM, pictures = process.env.SUFFUSE_PICTURES;

export class StudioInBrowser {
  async begin() {
    this.folder = mkdtempSync(join(tmpdir(), "suffuse-studio-test-"));
    mkdirSync(join(this.folder, "temporary")); // a studio that is killed leaves its files there
    await this.start();
    this.browser = await launch();
  }

  async end() {
    await this.browser?.close();
    this.kill();
    rmSync(this.folder, { recursive: true, force: true, maxRetries: 10 });
  }

  start() {
    return new Promise((resolve) => {
      this.process = spawn(program, ["studio", "--no-browser"], { cwd: this.folder, env: { ...process.env, TMPDIR: join(this.folder, "temporary") } });
      this.process.stdout.once("data", (text) => { this.address = String(text).trim(); resolve(); });
    });
  }

  kill() {
    this.process?.kill("SIGKILL");
  }

  suffuse(...words) {
    return execFileSync(program, words, { cwd: this.folder });
  }

  /** A page of its own, with all that it complains of or requests elsewhere. */
  async open(hash = "", options = {}) {
    const context = await this.browser.newContext({ viewport: { width: 1440, height: 900 }, reducedMotion: "reduce", ...options });
    context.setDefaultTimeout(patience);
    const page = await context.newPage(), complaints = [], { origin } = new URL(this.address);
    page.on("console", (message) => message.type() === "error" && complaints.push(message.text()));
    page.on("pageerror", (error) => complaints.push(error.message));
    page.on("request", (request) => request.url().startsWith(origin) || /^(data|blob):/.test(request.url()) || complaints.push(request.url()));
    await page.goto(this.address);
    if (hash) await page.evaluate((h) => { location.hash = h; }, hash);
    await page.waitForFunction(() => document.documentElement.dataset.ready === "yes");
    return { page, context, complaints };
  }
}

/** Waits for the price of the case in the tab Simulate, whose stages have this text; otherwise says what the page says. */
export async function priced(page, text = "") {
  try {
    await page.waitForFunction((t) => document.getElementById("stages").textContent.includes(t) && !document.getElementById("start").disabled, text);
  } catch (error) {
    const shown = await page.evaluate(() => ["problems", "trouble", "price", "stages"].map((id) => document.getElementById(id).textContent).join(" | "));
    throw new Error(`no price: ${shown}`, { cause: error });
  }
}

/** A picture of the tutorial, where they are to be made. */
export async function picture(page, name, options = {}) {
  if (!pictures) return;
  mkdirSync(pictures, { recursive: true });
  await page.screenshot({ path: join(pictures, `studio-${name}.png`), ...options });
}

/** What in view has no name for screen readers. */
export const nameless = (page) => page.evaluate(() => [...document.querySelectorAll("input,select,textarea,button,a,iframe,svg")].filter((e) =>
  e.checkVisibility?.() && !e.closest("[aria-hidden]") && !(e.labels?.length || e.getAttribute("aria-label") || e.title || e.textContent.trim())).map((e) => e.outerHTML.slice(0, 80)));
