// The tab Simulate in a browser: the case is that of the form, or a note says that it is not.
import assert from "node:assert/strict";
import { readFileSync, readdirSync } from "node:fs";
import { basename, join } from "node:path";
import { after, before, test } from "node:test";
import { StudioInBrowser, gap, nameless, priced } from "./studio_in_browser.mjs";

const studio = new StudioInBrowser(), open = (...words) => studio.open(...words);
const twice = "d [mm],passing [%]\n0.5,0\n0.6,10\n0.72,18\n0.80,20\n1.8,21\n2.2,45\n2.6,75\n3,100\n"; // the gap-graded soil, twice as coarse
const base = "d [mm],passing [%]\n0.2,0\n0.25,50\n0.3,100\n", filters = "sample,d [mm],passing [%]\nA,0.9,0\nA,1.2,100\nB,1.4,0\nB,1.8,100\n";

before(() => studio.begin());
after(() => studio.end());

const says = (page, id, words) => page.waitForFunction(([i, w]) => document.getElementById(i).textContent.includes(w), [id, words]);
const caseSays = (page, words) => page.waitForFunction((w) => document.getElementById("case").value.includes(w), words);
const give = async (page, content, name, input = "#file") => {
  await page.evaluate(() => { location.hash = "#soil"; });
  await page.setInputFiles(input, { name, mimeType: "text/csv", buffer: Buffer.from(content) });
  await says(page, input === "#file" ? "reading" : "filter-name", `${name}: sizes`);
  await says(page, "verdict", "criteria say");
};
const simulate = (page) => page.click("text=Simulate this soil");

test("another soil or gradient has a case of its own, unless the text was changed by hand: then a note says whose it is", async () => {
  const { page, context, complaints } = await open();
  await give(page, gap, "gap.csv");
  await simulate(page);
  await caseSays(page, 'title  = "Suffusion of gap"');
  await priced(page);
  await give(page, twice, "twice.csv");
  await simulate(page);
  await caseSays(page, 'title  = "Suffusion of twice"');
  await page.waitForFunction(() => document.getElementById("name").value === "twice" && document.getElementById("stale").hidden);
  await page.locator("#case").fill((await page.inputValue("#case")).replace("Suffusion of twice", "my words"));
  await give(page, gap, "gap.csv");
  await simulate(page);
  await says(page, "stale", "This case was written from twice; the form or the soil has changed since.");
  assert.match(await page.inputValue("#case"), /my words/);
  await page.click("#make");
  await caseSays(page, 'title  = "Suffusion of gap"');
  await page.waitForFunction(() => document.getElementById("stale").hidden);
  assert.deepEqual(complaints, []);
  await context.close();
});

test("each field that the case does not have yet is noticed, and one that no case has is named", async () => {
  const { page, context } = await open();
  await give(page, gap, "gap.csv");
  await page.locator("#porosity").fill("0.35");
  await simulate(page);
  await caseSays(page, "100 kPa");
  await says(page, "conditions", "Only the criteria use what is given there for: porosity.");
  await page.locator("#pressure").fill("2,5");
  await says(page, "stale", "This case was written from gap");
  await page.click("#make");
  await caseSays(page, '"2.5 kPa"');
  await page.locator("#particles").fill("5000");
  await says(page, "stale", "This case was written from gap");
  await page.locator("#particles").fill("");
  await page.waitForFunction(() => document.getElementById("stale").hidden);
  await page.selectOption("#from", "replay");
  await says(page, "stale", "This case was written from gap");
  await page.click("#make");
  await caseSays(page, "Replay of an imported packing");
  await context.close();
});

test("a part without its sizes is no whole soil, and the sizes that fit are proposed", async () => {
  const { page, context } = await open();
  await give(page, "d [mm],passing [%]\n0.063,0\n0.125,9\n0.25,17\n0.5,20\n1,21\n2,44\n4,100\n", "wide.csv");
  await page.evaluate(() => { location.hash = "#simulate"; });
  await says(page, "made", "a part of it, from 0.");
  assert.equal(await page.inputValue("#case"), "");
  await page.selectOption("#way", "part");
  const from = await page.inputValue("#size-from");
  await page.locator("#size-from").fill("");
  await page.click("#make");
  await says(page, "made", "Give both sizes of the part, from and to.");
  await page.locator("#size-from").fill(from.replace(".", ","));
  await page.click("#make");
  await caseSays(page, `${from} mm`);
  await context.close();
});

test("a soil on one soil of its filter's sheet becomes a case", async () => {
  const { page, context } = await open();
  await give(page, base, "base.csv");
  await simulate(page);
  await page.selectOption("#way", "filter");
  await page.click("#make");
  await says(page, "made", "Give the filter in the first tab.");
  await give(page, filters, "filters.csv", "#filter-file");
  await page.selectOption("#filter-sample", "B");
  await simulate(page);
  assert.equal(await page.isVisible("#particles"), false);
  await caseSays(page, 'title  = "base on B"');
  await priced(page);
  assert.deepEqual(await nameless(page), []);
  await context.close();
});

/** Drops files onto the page, as a file manager does. */
const drop = (page, files, onto = "body") => page.evaluate(([all, place]) => {
  const transfer = new DataTransfer();
  for (const [name, text] of all) transfer.items.add(new File([text], name));
  document.querySelector(place).dispatchEvent(new DragEvent("drop", { dataTransfer: transfer, bubbles: true, cancelable: true }));
}, [files, onto]);

test("the user's case is opened with its data, checked, and started once however often the button is pressed", async () => {
  studio.suffuse("new", "own", "--from", "replay");
  const read = (name) => readFileSync(join(studio.folder, "own", name), "utf8"), text = read("case.toml");
  const data = readdirSync(join(studio.folder, "own"), { recursive: true }).filter((name) => /\.\w+$/.test(name) && name !== "case.toml").map((name) => [basename(name), read(name)]);
  const { page, context, complaints } = await open();
  await drop(page, [["case.toml", text]]);
  await says(page, "problems", data[0][0]); // which is missing
  assert.equal(await page.isVisible("#simulate"), true);
  await drop(page, data, "#case-drop");
  await priced(page);
  await page.locator("#name").fill("<b>own</b>");
  await page.evaluate(() => { for (let k = 0; k < 3; ++k) document.getElementById("start").click(); });
  await says(page, "start-note", "b-own-b-0001");
  await page.waitForSelector("#live iframe");
  assert.deepEqual(await page.evaluate(() => fetch("/api/names").then((answer) => answer.json()).then(({ result }) => result)), ["b-own-b-0001"]);
  await drop(page, [["a.csv", gap], ["b.csv", gap]]);
  await says(page, "trouble", "Drop one grading at a time.");
  assert.deepEqual(complaints.filter((one) => !one.includes("422")), []);
  await context.close();
});

test("a text that was typed is not lost by a reload without a question", async () => {
  const { page, context } = await open("#simulate");
  let questions = 0;
  page.on("dialog", (dialog) => { ++questions; dialog.accept(); });
  await page.selectOption("#from", "replay");
  await page.click("#make");
  await priced(page);
  await page.reload();
  assert.equal(questions, 0);
  await page.selectOption("#from", "replay");
  await page.click("#make");
  await priced(page);
  await page.locator("#case").press("Control+End");
  await page.locator("#case").type("# mine");
  await page.reload();
  assert.equal(questions, 1);
  await context.close();
});
