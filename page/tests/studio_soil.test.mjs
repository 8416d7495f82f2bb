// The tab Soil in a browser: what is typed, pasted or dropped counts, or the page says why not; no answer outlives its soil.
import assert from "node:assert/strict";
import { writeFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { StudioInBrowser, gap, nameless } from "./studio_in_browser.mjs";

const studio = new StudioInBrowser(), open = (...words) => studio.open(...words);

before(() => studio.begin());
after(() => studio.end());

const text = (page, id) => page.textContent(`#${id}`);
const says = (page, id, words) => page.waitForFunction(([i, w]) => document.getElementById(i).textContent.includes(w), [id, words]);
const give = (page, content, name = "gap.csv", input = "#file") => page.setInputFiles(input, { name, mimeType: "text/csv", buffer: Buffer.from(content) });

/** Gives a soil and waits for what is said of it. */
async function answered(page, content, name) {
  await give(page, content, name);
  await says(page, "verdict", "criteria say");
}

test("a curve that ends above its d10, with decimal commas, is judged: what is not known is a question mark", async () => {
  const { page, context, complaints } = await open();
  await answered(page, gap);
  await page.locator("#table").fill("Sieb [mm];Durchgang [%]\n8;100\n4;78\n2;44,5\n1;21\n0,5;20,1\n0,25;17,5\n");
  await says(page, "soil-results", "d10 ?, d50 2.24, d60 2.76 mm; Cu ?");
  assert.match(await text(page, "verdict"), /4 of 4 criteria say unstable/);
  assert.match(await text(page, "soil-results"), /depending on the 17.5 % below 0.25 mm/);
  assert.deepEqual(complaints, []);
  await context.close();
});

test("limits are those of the terminal: what is stable at the limit itself, and what is not", async () => {
  const { page, context } = await open();
  await answered(page, gap);
  writeFileSync(join(studio.folder, "gap.csv"), gap);
  const lines = String(studio.suffuse("assess", "gap.csv", "-i", "0.3")).split("\n"), shown = await page.evaluate(() =>
    [...document.querySelectorAll("#soil-results tr")].flatMap((row) => {
      const limit = row.querySelector("td.n small")?.textContent;
      return limit ? [[row.cells[0].firstChild.textContent.trim(), limit.replace("≥", ">=").replace("≤", "<=")]] : [];
    }));
  assert.equal(shown.length, 12);
  for (const [name, limit] of shown) assert.ok(lines.some((line) => line.trim().startsWith(name) && line.includes(` ${limit} `)), `${name}: ${limit}`);
  assert.deepEqual(shown.find(([name]) => name === "Chang and Zhang 2013"), ["Chang and Zhang 2013", "< 3"]);
  await context.close();
});

test("what cannot be read has no answer, and no case", async () => {
  const { page, context } = await open();
  await answered(page, gap);
  await page.locator("#table").fill("d [mm],passing [%]\n1,50\n2,oops\n");
  await says(page, "trouble", '"oops" is not a number');
  assert.match(await text(page, "trouble"), /--> gap.csv:3:3/);
  assert.equal(await text(page, "soil-results"), "");
  assert.equal(await text(page, "verdict"), "This cannot be read as a grading.");
  assert.equal(await page.isVisible("#curve"), false);
  await page.evaluate(() => { location.hash = "#simulate"; });
  await says(page, "conditions", "No soil is given yet.");
  assert.equal(await page.inputValue("#case"), "");
  await page.evaluate(() => { location.hash = "#soil"; });
  await page.locator("#table").fill("");
  await says(page, "verdict", "Drop a grading, or paste one.");
  await page.locator("#table").evaluate((table, given) => { // pasted over all that is there, it is another soil
    table.select();
    table.dispatchEvent(new ClipboardEvent("paste", { bubbles: true }));
    table.value = given;
    table.dispatchEvent(new InputEvent("input", { bubbles: true }));
  }, gap);
  await says(page, "reading", "pasted.csv: sizes");
  assert.equal(await page.isVisible("#trouble"), false);
  await context.close();
});

test("numbers may have a decimal comma; what is no number, out of range or could be two is refused by the name of its field", async () => {
  const { page, context, complaints } = await open();
  await answered(page, gap);
  await page.locator("#porosity").fill("0,35");
  await says(page, "verdict", "Factor of safety 3.6 against heave");
  for (const [id, typed, why] of [["porosity", "35", "Porosity, 0 to 1: 35 is out of range; give a number from 0.05 to 0.95."], ["fines", "much", "Fines are finer than [mm]: much is not a number."],
    ["grain-density", "2,650", "Density of the grains [kg/m³]: 2,650 could be 2.65 or 2650; write it without the comma."]]) {
    const kept = await page.inputValue(`#${id}`);
    await page.locator(`#${id}`).fill(typed);
    await says(page, "trouble", why);
    assert.equal(await text(page, "soil-results"), "", id);
    await page.locator(`#${id}`).fill(kept);
    await says(page, "verdict", "criteria say");
  }
  await page.locator("#fines").fill("0,36");
  await says(page, "curve", "below 0.36 mm");
  assert.deepEqual(complaints, []);
  await context.close();
});

test("a gradient beyond the slider is typed; without a gradient the page says which fields count for nothing", async () => {
  const { page, context } = await open();
  await answered(page, gap);
  await page.locator("#gradient-number").fill("1,98");
  await says(page, "verdict", "Factor of safety 0.50 against heave"); // 0.99/1.98
  assert.equal(await page.inputValue("#gradient"), "1.5");
  await page.locator("#gradient").fill("0.9");
  assert.equal(await page.inputValue("#gradient-number"), "0.9");
  await page.locator("#alpha").fill("0.4");
  await page.locator("#gradient-number").fill("0");
  await says(page, "ignored", "Counts only with a gradient: α.");
  await context.close();
});

test("a unit or a kind alone is that of the columns as they were found", async () => {
  const { page, context } = await open();
  await answered(page, gap);
  await page.click("#correct summary");
  await page.selectOption("#size-unit", "cm");
  await says(page, "reading", "in cm");
  await says(page, "curve-note", "Shaded: the gap, 4 to 9 mm.");
  await page.selectOption("#amount-kind", "retained"); // which falls with the size: refused, not ignored
  await says(page, "trouble", "percent passing falls throughout");
  await page.click("#as-found");
  await says(page, "curve-note", "Shaded: the gap, 0.4 to 0.9 mm.");
  assert.equal(await page.inputValue("#amount-kind"), "");
  await give(page, "sieve [mm],retained on sieve [g]\n4,0\n2,100\n1,100\n0.5,100\n0,20\n", "masses.csv");
  await says(page, "reading", "masses.csv");
  const before = await text(page, "reading");
  await page.selectOption("#size-unit", "cm");
  await says(page, "reading", "in cm");
  assert.equal(await text(page, "reading"), before.replace("in mm", "in cm"));
  await context.close();
});

test("the curve as given brings back the table as given, and a Windows-1252 sheet can be edited", async () => {
  const { page, context } = await open();
  await answered(page, gap);
  await page.locator('#curve [data-point="4"]').focus();
  await page.keyboard.press("ArrowUp");
  await page.waitForFunction(() => document.getElementById("table").value.includes("0.9,22"));
  await page.click("#back");
  assert.equal(await page.inputValue("#table"), gap);
  await give(page, Buffer.from("Korngr\xf6\xdfe [\xb5m];Durchgang [%]\n250;0\n500;20\n1000;21\n2000;100\n", "latin1"), "old.csv");
  await says(page, "reading", "old.csv: sizes: Korngröße [µm], in um");
  await page.locator("#table").fill((await page.inputValue("#table")).replace("250;0", "125;0"));
  await says(page, "printed-points", "0.125 mm 0 %");
  await context.close();
});

test("the Unicode text of a spreadsheet is read as by the terminal, shown decoded, and edited", async () => {
  const { page, context, complaints } = await open();
  const table = "Siebgröße [mm]\tDurchgang [%]\r\n8,0\t100,0\r\n2,0\t44,5\r\n1,0\t21,0\r\n0,25\t17,5\r\n0,063\t0\r\n";
  const little = Buffer.from(`\ufeff${table}`, "utf16le"), big = Buffer.from(little).swap16();
  for (const bytes of [little, big]) {
    await give(page, bytes, "unicode.txt");
    await says(page, "reading", "unicode.txt: sizes: Siebgröße [mm], in mm");
    assert.equal(await page.inputValue("#table"), table.replaceAll("\r", ""));
    writeFileSync(join(studio.folder, "unicode.txt"), bytes);
    assert.match(String(studio.suffuse("assess", "unicode.txt", "--show-reading")), /0\.25 mm +17\.5 %/);
    await page.locator("#table").fill((await page.inputValue("#table")).replace("17,5", "18"));
    await says(page, "printed-points", "0.25 mm 18 %");
  }
  assert.deepEqual(complaints, []);
  await context.close();
});

test("a file that changes on disk keeps its answer until it is chosen again", async () => {
  const { page, context, complaints } = await open();
  const file = join(studio.folder, "changing.csv"), browser = await context.newCDPSession(page); // Playwright itself sends copies
  writeFileSync(file, gap);
  const choose = async () => {
    const { root } = await browser.send("DOM.getDocument"), { nodeId } = await browser.send("DOM.querySelector", { nodeId: root.nodeId, selector: "#file" });
    await browser.send("DOM.setFileInputFiles", { nodeId, files: [file] });
  };
  await choose();
  await says(page, "verdict", "Factor of safety 3.3 against heave");
  writeFileSync(file, `${gap}2,100\n3,100\n`);
  await page.locator("#gradient-number").fill("0.9");
  await says(page, "verdict", "Factor of safety 1.1 against heave");
  await page.evaluate(() => { document.getElementById("file").addEventListener("click", (event) => event.preventDefault()); document.getElementById("file").click(); }); // no dialog
  await choose();
  await page.waitForFunction(() => document.getElementById("table").value.endsWith("3,100\n"));
  assert.deepEqual(complaints, []);
  await context.close();
});

test("one soil of a filter's sheet is chosen; a filter that cannot be read is named, and the soil keeps its answer", async () => {
  const { page, context } = await open();
  await answered(page, gap);
  await give(page, "sample,d [mm],passing [%]\nA,0.5,0\nA,4,100\nB<i>,1,0\nB<i>,8,100\n", "filters.csv", "#filter-file");
  await says(page, "verdict", "The filter filters.csv, A");
  await page.selectOption("#filter-sample", "B<i>");
  await says(page, "verdict", "The filter filters.csv, B<i>");
  await says(page, "soil-results", "The filter filters.csv, B<i>");
  assert.deepEqual(await nameless(page), []);
  await give(page, "x", "bad.csv", "#filter-file");
  await says(page, "filter-name", "bad.csv cannot be read, so there is no filter");
  await page.waitForFunction(() => !document.getElementById("verdict").textContent.includes("filter"));
  assert.equal(await page.isVisible("#filter-sample"), false);
  await context.close();
});

test("what was remarked on a file is shown while the curve is its own, and a case is announced without commands to type", async () => {
  const { page, context, complaints } = await open();
  await give(page, Buffer.from("Korngr\xf6\xdfe [mm];Durchgang [%]\n0.25;0\n0.4;20\n0.9;21\n1.5;100\n", "latin1"), "W5.csv");
  await says(page, "remarks", "W5.csv: read as Windows-1252");
  await says(page, "verdict", "criteria say");
  await page.locator('#curve [data-point="2"]').focus();
  await page.keyboard.press("ArrowUp");
  await page.waitForFunction(() => !document.getElementById("remarks").textContent);
  await page.click("#back");
  await says(page, "remarks", "read as Windows-1252");
  await page.click("text=Simulate this soil");
  await says(page, "made", "grains in the preset quick");
  assert.doesNotMatch(await text(page, "made"), /next:|suffuse run/);
  assert.deepEqual(complaints, []);
  await context.close();
});

test("a reload keeps the soil, how it is read, its conditions, its filter and an edited curve", async () => {
  const { page, context, complaints } = await open();
  await give(page, Buffer.from("Korngr\xf6\xdfe [cm];A;B\r\n0.25;0;0\r\n0.4;20;30\r\n0.9;21;31\r\n1.5;100;100\r\n", "latin1"), "two.csv");
  await says(page, "verdict", "criteria say");
  await page.selectOption("#sample", "1");
  await page.click("#correct summary");
  await page.locator("#rows").fill("1-5");
  await page.locator("#rows").blur();
  await page.locator("#gradient-number").fill("0.9");
  await page.selectOption("#flow", "level");
  await give(page, "sample,d [mm],passing [%]\nA,5,0\nA,40,100\nB,10,0\nB,80,100\n", "filters.csv", "#filter-file");
  await says(page, "verdict", "The filter filters.csv, A");
  await page.selectOption("#filter-sample", "B");
  await says(page, "verdict", "The filter filters.csv, B");
  const shown = async () => Object.fromEntries(await Promise.all(["verdict", "soil-results", "reading", "remarks", "curve-note", "printed-points", "filter-name"].map(async (id) => [id, await text(page, id)])));
  const again = async (words) => {
    await page.reload();
    await says(page, "verdict", words);
  };
  const before = await shown(), table = await page.inputValue("#table");
  await again("The filter filters.csv, B");
  assert.deepEqual(await shown(), before);
  assert.equal(await page.inputValue("#table"), table);
  assert.equal(await page.inputValue("#rows"), "1-5");
  assert.deepEqual([await page.inputValue("#gradient-number"), await page.inputValue("#flow")], ["0.9", "level"]);
  await page.locator('#curve [data-point="2"]').focus();
  await page.keyboard.press("ArrowUp");
  await says(page, "curve-note", "The curve was edited here.");
  await page.waitForFunction(() => document.getElementById("table").value.includes("9,32"));
  await again("The filter filters.csv, B");
  assert.match(await page.inputValue("#table"), /9,32/);
  await page.click("#back");
  await page.waitForFunction((given) => document.getElementById("table").value === given, table);
  await page.evaluate(() => { location.hash = "#simulate"; });
  await page.reload();
  await says(page, "conditions", "B; i = 0.9, flow level");
  assert.deepEqual(complaints, []);
  await page.evaluate(() => { location.hash = "#soil"; });
  await page.locator("#table").fill("");
  await page.click("#no-filter");
  await says(page, "verdict", "Drop a grading");
  await page.reload();
  await page.waitForFunction(() => document.documentElement.dataset.ready === "yes");
  assert.equal(await text(page, "filter-name"), "");
  assert.equal(await text(page, "verdict"), "Drop a grading, or paste one.");
  await context.close();
});

test("the scale of sizes has several numbers, also on a phone and below the first decade", async () => {
  for (const viewport of [{ width: 1440, height: 900 }, { width: 390, height: 844 }]) {
    const { page, context } = await open("", { viewport });
    await answered(page, gap);
    const sizes = await page.evaluate(() => [...document.querySelectorAll("#curve text.m:not(.s)")].map((label) => label.textContent));
    assert.deepEqual(sizes, ["0.2", "0.5", "1", "2"]);
    await context.close();
  }
});
