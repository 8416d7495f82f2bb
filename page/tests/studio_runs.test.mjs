// The tab Runs in a browser: runs that failed, that are gone, and that others change.
import assert from "node:assert/strict";
import { mkdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { StudioInBrowser } from "./studio_in_browser.mjs";

const studio = new StudioInBrowser(), open = (...words) => studio.open(...words);
const says = (page, id, words) => page.waitForFunction(([i, w]) => document.getElementById(i).textContent.includes(w), [id, words]);
const buttons = (page) => page.locator("#run .buttons button").allTextContents();

before(async () => {
  await studio.begin();
  studio.suffuse("new", "replay", "--from", "replay");
  for (const seed of [1, 2]) studio.suffuse("run", "replay/case.toml", "-q", "--set", `seed=${seed}`);
});

after(() => studio.end());

test("a run that an error or the time limit ended can be resumed, and shows what it printed last", async () => {
  const run = join(studio.folder, "runs", "replay-0001"), log = join(studio.folder, "runs", "cases", "replay-0001", "log.txt");
  const events = readFileSync(join(run, "events.jsonl"), "utf8").trim().split("\n");
  mkdirSync(join(log, ".."), { recursive: true });
  writeFileSync(log, "error: <b>no space left on device</b>\n");
  const { page, context, complaints } = await open();
  for (const outcome of ["", "failed in part", "time limit reached"]) {
    const last = outcome ? [JSON.stringify({ ...JSON.parse(events.at(-1)), outcome })] : [];
    writeFileSync(join(run, "events.jsonl"), `${[...events.slice(0, -1), ...last].join("\n")}\n`);
    await page.evaluate(() => { location.hash = "#runs"; });
    await says(page, "run", "Choose a run.");
    await page.evaluate(() => { location.hash = "#runs/replay-0001"; });
    await says(page, "run", outcome ? `Ended: ${outcome}` : "it was killed, or an error ended it. Resume it.");
    const printed = await page.locator("#run pre").allTextContents();
    assert.deepEqual(printed, outcome === "time limit reached" ? [] : ["error: <b>no space left on device</b>\n"], outcome);
    assert.ok((await buttons(page)).includes("Resume"), outcome);
  }
  writeFileSync(join(run, "events.jsonl"), `${events.join("\n")}\n`);
  await page.reload();
  await says(page, "run", "Ended: done");
  assert.ok(!(await buttons(page)).includes("Resume"));
  assert.deepEqual(complaints, []);
  await context.close();
});

test("a run has the time of the reader's clock, and its printed report is a link", async () => {
  const { finished } = JSON.parse(studio.suffuse("runs", "runs", "--json")).runs.find((run) => run.name === "replay-0001");
  const { page, context, complaints } = await open("#runs/replay-0001", { timezoneId: "Asia/Tokyo" }); // 9 h ahead, all year
  const there = new Date(Date.parse(finished) + 9 * 3600e3).toISOString().slice(0, 16).replace("T", " ");
  await page.waitForFunction((time) => [...document.querySelectorAll("#run-table tr")].some((row) => row.textContent.includes("replay-0001") && row.textContent.includes(time)), there);
  await page.click("text=PDF of the report");
  await says(page, "run", "Printed: report.pdf");
  assert.equal(await page.getAttribute("#run .printed a", "href"), "/runs/replay-0001/report.pdf");
  assert.deepEqual(complaints, []);
  await context.close();
});

test("a run that is gone is said to be gone, and any address opens the page", async () => {
  const { page, context, complaints } = await open("#runs/no%20such<i>");
  await says(page, "run", "There is no run no such<i> in this folder (any more).");
  await page.evaluate(() => { location.hash = "#runs/%E0%A4%A"; });
  await says(page, "run", "There is no run %E0%A4%A");
  await page.reload();
  await page.waitForFunction(() => document.documentElement.dataset.ready === "yes");
  assert.deepEqual(complaints.filter((one) => !one.includes("404")), []);
  await context.close();
});

test("after a comparison or a deletion the address names no run, so that each link opens its run", async () => {
  const { page, context } = await open("#runs/replay-0001");
  await says(page, "run", "Ended: done");
  for (const name of ["replay-0001", "replay-0002"]) await page.check(`[data-run="${name}"]`);
  await page.click("#compare");
  await says(page, "run", "No number differs");
  await page.click("#run-table >> text=replay-0001");
  await says(page, "run", "Ended: done");
  page.on("dialog", (dialog) => dialog.accept());
  await page.click("text=Delete …");
  await says(page, "run", "Choose a run.");
  assert.equal(await page.evaluate(() => location.hash), "#runs");
  await says(page, "count", "1 run");
  await page.click("#run-table >> text=replay-0002");
  await says(page, "run", "Ended: done");
  rmSync(join(studio.folder, "runs", "replay-0002"), { recursive: true }); // by another program
  await page.click("text=Delete …");
  await says(page, "run", "There is no run replay-0002 in this folder (any more).");
  await says(page, "trouble", "there is no such file in the studio's folder");
  await context.close();
});
