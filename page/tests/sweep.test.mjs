// The third walk through the studio: a sweep of friction, watched as it comes in, stopped, resumed, and compared.
import assert from "node:assert/strict";
import { writeFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { StudioInBrowser, nameless, picture } from "./studio_in_browser.mjs";

const studio = new StudioInBrowser(), open = (...words) => studio.open(...words);

before(() => studio.begin());
after(() => studio.end());

/** The example of laboratory tests, cut to the first of them, on few grains: what a user would do in the text. */
const cut = (text, grains) => text.replace(/\[\[study\.sand\.stage\]\]\nname {6}= "extension"[^]*?(?=\[output\])/, "").replace(/void_ratio.*\n/g, "").replace("2_000", grains);

async function fillIn(page, key, values, grains) {
  await page.selectOption("#sweep-from", "laboratory");
  await page.click("#sweep-take");
  await page.waitForFunction(() => document.getElementById("sweep-case").value.includes("extension"));
  const text = cut(await page.inputValue("#sweep-case"), grains);
  await page.locator("#sweep-case").fill(text);
  await page.locator(".swept .key").fill(key);
  await page.locator(".swept .values").fill(values);
  await page.click("#sweep-write");
}

const priced = (page, samples) => page.waitForFunction((n) => !document.getElementById("sweep-start").disabled && document.querySelectorAll("#sweep-stages tbody tr").length === n, samples);
const rowsDone = (page) => page.locator("#sweep-live .stages td.ok").count();

test("a sweep of friction: priced, an error at its line, watched, stopped, resumed, compared with another", async () => {
  const { page, context, complaints } = await open("#sweep");
  await fillIn(page, "contact.friction", "20 deg, 30 dg, 40 deg", "1_500");
  const line = (await page.inputValue("#sweep-case")).split("\n").findIndex((one) => one.startsWith("sweep =")) + 1;
  await page.waitForSelector(`#sweep-problems button[data-line="${line}"]`);
  assert.equal(await page.isDisabled("#sweep-start"), true);
  await page.locator(".swept .values").fill("20 deg, 30 deg, 40 deg");
  await page.click("#sweep-write");
  await priced(page, 3);
  assert.match(await page.textContent("#sweep-stages"), /3 samples.*friction=20deg/);
  assert.ok((await page.locator("#sweep-known-keys option").evaluateAll((all) => all.map((one) => one.value))).includes("stage.compression.strain"));
  await page.locator("#sweep-name").fill("friction");
  await page.click("#sweep-start");
  await page.waitForFunction(() => location.hash === "#sweep/friction-0001" && document.querySelectorAll("#sweep-live .stages tbody tr").length === 3);
  await page.waitForFunction(() => document.querySelectorAll("#sweep-live .stages td.ok").length > 0);
  await picture(page, "sweep-live");
  if ((await rowsDone(page)) < 3) {
    await page.click("#sweep-live >> text=Stop and save");
    await page.waitForSelector("#sweep-live [data-do=resume], #sweep-live [data-do=read]");
    if (await page.locator("#sweep-live [data-do=resume]").count()) await page.click("#sweep-live [data-do=resume]");
  }
  await page.waitForFunction(() => document.querySelectorAll("#sweep-live .stages td.ok").length === 3 && document.querySelector("#sweep-live [data-do=read]"));
  const cells = await page.locator("#sweep-live .stages tbody tr").allTextContents();
  assert.deepEqual(cells.map((text) => text.slice(0, 5)), ["20deg", "30deg", "40deg"]);
  const numbers = await page.evaluate(() => Promise.all(["20deg", "30deg", "40deg"].map((at) => fetch(`/runs/friction-0001/studies/sand/friction=${at}/compression/stage.json`).then((r) => r.json()).then((s) => s.response.friction_angle * 180 / Math.PI))));
  for (const [k, text] of cells.entries()) assert.ok(text.includes(String(Number(numbers[k].toPrecision(3)))), `${text} has ${numbers[k]}`);

  await fillIn(page, "contact.friction", "20 deg, 30 deg, 40 deg", "500");
  await page.locator("#sweep-name").fill("smaller");
  await priced(page, 3);
  await page.click("#sweep-start");
  await page.waitForFunction(() => location.hash === "#sweep/smaller-0001" && document.querySelectorAll("#sweep-live .stages td.ok").length === 3 && document.querySelector("#sweep-live [data-do=read]"));
  await page.waitForSelector('#sweep-other option[value="friction-0001"]', { state: "attached" });
  await page.selectOption("#sweep-other", "friction-0001");
  await page.waitForFunction(() => document.querySelector("#sweep-live .legend")?.textContent.includes("friction-0001"));
  assert.equal(await page.locator("#sweep-live .multiples figure").first().locator(".ln.more1").count(), 2, "a line and its place in the legend");
  await page.evaluate(() => window.scrollTo(0, 0));
  await picture(page, "sweep");
  await page.click("text=Every number that differs");
  await page.waitForSelector("#sweep-differences tbody tr");
  assert.match(await page.textContent("#sweep-differences"), /study.sand.particles = 500/);
  assert.deepEqual(complaints.filter((one) => !one.includes("422")), []);
  await context.close();
});

test("another number and another stage are chosen by the keyboard, and stay chosen", async () => {
  const { page, context, complaints } = await open("#sweep/friction-0001");
  await page.waitForSelector("#sweep-live .multiples svg");
  await page.locator("#sweep-live .report summary").focus();
  await page.keyboard.press("Enter");
  await page.locator('#sweep-live .choices input[value="coordination"]').focus();
  await page.keyboard.press("Space");
  await page.waitForFunction(() => document.querySelector("#sweep-live thead").textContent.includes("coordination"));
  assert.equal(await page.evaluate(() => document.activeElement.value), "coordination");
  await page.selectOption("#sweep-live [data-choice]", "initial");
  await page.waitForFunction(() => document.querySelector("#sweep-live thead").textContent.includes("void ratio") && !document.querySelector("#sweep-live thead").textContent.includes("friction angle"));
  assert.deepEqual(await nameless(page), []);
  assert.deepEqual(complaints, []);
  await context.close();
});

test("a sweep is compared with a single run, whose number is a level", async () => {
  const { page, context, complaints } = await open("#sweep/friction-0001");
  await page.waitForSelector("#sweep-live .multiples svg");
  const text = await page.evaluate(() => fetch("/runs/smaller-0001/case.toml").then((r) => r.text()));
  assert.ok(!text.includes("\r"), "the case is kept as it was written");
  writeFileSync(join(studio.folder, "single.toml"), text.replace(/^sweep = .*\n/m, ""));
  studio.suffuse("run", "single.toml", "-q", "-o", "runs/single");
  await page.reload();
  await page.waitForSelector('#sweep-other option[value="single"]', { state: "attached" });
  await page.waitForSelector("#sweep-live .multiples svg");
  await page.selectOption("#sweep-other", "single");
  await page.waitForFunction(() => document.querySelector("#sweep-live .legend")?.textContent.includes("single"));
  assert.match(await page.textContent("#sweep-live caption"), /single has no sample with these values/);
  assert.match(await page.locator("#sweep-live .multiples .more1").first().getAttribute("d"), /^M56 [\d.]+H\d+$/);
  assert.deepEqual(complaints, []);
  await context.close();
});

test("tasks for a cluster: the script to copy, and its samples gathered", async () => {
  const { page, context, complaints } = await open("#sweep", { permissions: ["clipboard-read", "clipboard-write"] });
  await fillIn(page, "contact.friction", "20 deg, 40 deg", "500");
  await priced(page, 2);
  await page.locator("#sweep-name").fill("cluster");
  await page.click("text=Run it on a cluster");
  await page.locator("#task-time").fill("1h");
  await page.click("#emit");
  await page.waitForFunction(() => document.getElementById("script").textContent.includes("#SBATCH --array=1-2"));
  assert.match(await page.textContent("#script-run"), /^Tasks of cluster-0001\. Submit them in the studio's folder: s\S+ \S*cluster-0001/);
  await page.click("#copy");
  await page.waitForFunction(() => document.getElementById("copied").textContent);
  assert.equal(await page.evaluate(() => navigator.clipboard.readText()), await page.textContent("#script"));
  await page.waitForFunction(() => /tasks of a cluster/.test(document.querySelector("#sweep-live .state")?.textContent));
  studio.suffuse("resume", "runs/cluster-0001", "--sample", "sand/friction=20deg");
  await page.click("#sweep-live [data-do=collect]");
  await page.waitForFunction(() => document.querySelectorAll("#sweep-live .stages td.ok").length === 1);
  await page.click("#emit-rest");
  await page.waitForFunction(() => document.getElementById("script").textContent.includes("#SBATCH --array=1-1"));
  assert.deepEqual(complaints, []);
  await context.close();
});

test("on a phone and in the dark nothing of a sweep is cut off", async () => {
  const { page, context } = await open("#sweep/friction-0001", { viewport: { width: 390, height: 844 }, colorScheme: "dark" });
  await page.waitForSelector("#sweep-live .multiples svg");
  await page.locator("#sweep-live .report summary").click();
  const width = await page.evaluate(() => document.documentElement.scrollWidth);
  assert.ok(width <= 390, `${width} wide`);
  await page.locator("#sweep-live").scrollIntoViewIfNeeded();
  await picture(page, "phone-sweep-table");
  await context.close();
});
