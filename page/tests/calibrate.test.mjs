// A calibration in the studio: records of tests, what is sought, the case, its run, and its report. The program is the real one.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { StudioInBrowser, nameless, picture, priced } from "./studio_in_browser.mjs";

const sand = "d [mm],passing [%]\n0.13,0\n0.14,50\n0.15,100\n", studio = new StudioInBrowser(), open = (...words) => studio.open(...words);

/** Three drained tests: the loose one dilates less; `T3` is between the others. */
const drained = `test,eps1 [%],epsv [%],void ratio,q [kPa],p [kPa]\n${[["T1", 100, 0.7], ["T2", 400, 0.71], ["T3", 200, 0.7], ["T4", 100, 0.9]].flatMap(([name, p, e]) =>
  Array.from({ length: 21 }, (_, k) => {
    const q = 1.6 * p * (1 - Math.exp(-0.4 * k)), epsv = 0.02 * k - 0.002 * k * k;
    return `${name},${0.05 * k},${epsv.toFixed(4)},${(e - ((1 + e) * epsv) / 100).toFixed(5)},${q.toFixed(2)},${(p + q / 3).toFixed(2)}`;
  })).join("\n")}\n`;
const oedometer = `sigma1 [kPa],eps1 [%]\n${[10, 25, 50, 100, 200, 400].map((s) => `${s},${(0.4 * Math.log10(s / 10)).toFixed(3)}`).join("\n")}\n`;

const idOf = (page, name) => page.evaluate((test) => [...document.querySelectorAll("#calibrate-tests .sought")].find((row) => row.textContent.trim().startsWith(test)).querySelector("select").id.replace("target-role-", ""), name);

before(() => studio.begin());
after(() => studio.end());

async function fill(page) {
  await page.setInputFiles("#file", { name: "sand.csv", mimeType: "text/csv", buffer: Buffer.from(sand) });
  await page.waitForFunction(() => document.querySelectorAll("#soil-results tr").length > 5);
  await page.evaluate(() => { location.hash = "#simulate"; });
  await page.click("text=Calibrate a sand");
  await page.setInputFiles("#calibrate-files", [{ name: "drained.csv", mimeType: "text/csv", buffer: Buffer.from(drained) }, { name: "oed 1.csv", mimeType: "text/csv", buffer: Buffer.from(oedometer) }]);
  await page.waitForFunction(() => document.querySelectorAll("#calibrate-tests .sought").length === 5);
}

test("a record whose signs are open is read once they are chosen, and what was chosen of the others stays", async () => {
  const { page, context, complaints } = await open("#simulate");
  await page.click("text=Calibrate a sand");
  const give = (name, text) => page.setInputFiles("#calibrate-files", { name, mimeType: "text/csv", buffer: Buffer.from(text) });
  await give("drained.csv", drained);
  await page.waitForFunction(() => document.querySelectorAll("#calibrate-tests .sought").length === 4);
  const [one, two] = await Promise.all(["T1", "T2"].map((name) => idOf(page, name)));
  for (const id of [one, two]) await page.selectOption(`#target-role-${id}`, "fit");
  await page.locator(`#target-pressure-${two}`).fill("410 kPa");
  await give("open.csv", "axial strain [%],deviator stress [kPa],cell pressure [kPa],volumetric strain [%]\n0,0,100,0\n1,100,100,0.1\n5,200,100,-0.5\n10,210,100,-2\n");
  await page.waitForFunction(() => document.getElementById("calibrate-reading").textContent.includes("Not read: open.csv. Choose what they are"));
  const kept = () => Promise.all([page.inputValue(`#target-role-${one}`), page.inputValue(`#target-pressure-${two}`), page.inputValue(`#target-like-${two}`)]);
  assert.deepEqual(await kept(), ["fit", "410 kPa", one]);
  await page.selectOption("#calibrate-contraction", "positive");
  await page.waitForFunction(() => document.querySelectorAll("#calibrate-tests .sought").length === 5 && document.getElementById("calibrate-reading").textContent === "");
  assert.deepEqual(await kept(), ["fit", "410 kPa", one]);
  await page.click('#calibrate-records [data-drop="0"]');
  await page.waitForFunction(() => document.querySelectorAll("#calibrate-tests .sought").length === 1);
  assert.equal(await page.locator("#calibrate-tests select").first().inputValue(), "", "of another test than the one at its place before");
  assert.deepEqual(complaints.filter((text) => !text.includes("422")), []);
  await context.close();
});

test("records are read and shown as understood, and become a case that is priced", async () => {
  const { page, context, complaints } = await open();
  await fill(page);
  assert.match(await page.textContent("#calibrate-records"), /drained.csv: triaxial, 4 tests, 84 rows[^]*oed 1.csv: oedometer, 1 test, 6 rows/);
  assert.match(await page.textContent("#calibrate-records"), /eps1 \[%\]: axial strain[^]*found: "epsv \[%\]" is positive in contraction/);
  const [one, two, three, four] = await Promise.all(["T1", "T2", "T3", "T4"].map((name) => idOf(page, name)));
  await page.selectOption(`#target-role-${one}`, "fit");
  await page.selectOption(`#target-role-${two}`, "fit");
  assert.equal(await page.inputValue(`#target-pressure-${two}`), "400 kPa");
  assert.equal(await page.inputValue(`#target-like-${two}`), one, "tests of one density share their void ratio");
  await page.selectOption(`#target-role-${three}`, "held");
  assert.equal(await page.inputValue(`#target-like-${three}`), one);
  await page.selectOption(`#target-role-${four}`, "fit");
  assert.equal(await page.inputValue(`#target-like-${four}`), "", "a loose sample has its own");
  await page.selectOption(`#target-role-${four}`, "");
  await page.fill("#calibrate-strain", "1 %");
  await page.fill("#calibrate-particles", "200");
  await page.fill("#calibrate-samples", "8");
  assert.deepEqual(await nameless(page), []);
  await page.locator("#calibrate-tests").scrollIntoViewIfNeeded();
  await picture(page, "calibrate-form", { clip: { x: 0, y: 0, width: 340, height: 900 } });
  await page.click("#calibrate-write");
  await priced(page, "First round");
  const text = await page.inputValue("#case");
  assert.ok(text.includes('[[calibrate.targets]]\nname = "T3"\nfile = "data/drained.csv"\nsample = "T3"\ntest = "drained"\npressure = "200 kPa"\nstrain = "1 %"\nvoid_ratio_of = "T1"\nheld_out = true\n'), text);
  assert.match(await page.textContent("#stages"), /First round: \d+ samples/);

  await page.fill("#case", text.replace('"contact.friction" =', '"contact.frictoin" ='));
  const line = text.split("\n").findIndex((one) => one.startsWith('"contact.friction"')) + 1;
  await page.waitForSelector(`#problems button[data-line="${line}"]`);
  await page.fill("#case", text.replace("poisson = 0.2", "poison = 0.2"));
  await page.waitForSelector(`#problems button[data-line="${text.split("\n").findIndex((one) => one.startsWith("poisson")) + 1}"]`);
  assert.deepEqual(complaints.filter((one) => !one.includes("422")), []);
  await context.close();
});

test("a file that is no record, and a form that lacks something, say so", async () => {
  const { page, context } = await open("#simulate");
  await page.click("text=Calibrate a sand");
  await page.setInputFiles("#calibrate-files", { name: "note.csv", mimeType: "text/csv", buffer: Buffer.from("a,b\n1,2\n") });
  await page.waitForFunction(() => document.getElementById("trouble").textContent.includes("found no heading with two of"));
  assert.equal(await page.isDisabled("#calibrate-write"), true);
  await page.setInputFiles("#calibrate-files", { name: "drained.csv", mimeType: "text/csv", buffer: Buffer.from(drained) });
  await page.waitForFunction(() => !document.getElementById("calibrate-write").disabled);
  await page.click("#calibrate-write");
  await page.waitForFunction(() => document.getElementById("trouble").textContent.includes("grading of the sand"));
  await context.close();
});

test("a calibration that is written while the soil's own case is on its way stays", async () => {
  const { page, context } = await open();
  let release;
  const held = new Promise((resolve) => { release = resolve; });
  await page.route("**/api/new", async (route) => { await held; await route.continue(); });
  await fill(page);
  await page.selectOption(`#target-role-${await idOf(page, "T1")}`, "fit");
  await page.click("#calibrate-write");
  assert.equal(await page.isDisabled("#make"), true, "the soil's own case is on its way");
  release();
  await page.waitForFunction(() => !document.getElementById("make").disabled);
  await priced(page, "First round");
  assert.match(await page.inputValue("#case"), /^\[calibrate\]$/m);
  await context.close();
});

test("a calibration is started, watched, stopped, resumed, and reported", async () => {
  const { page, context, complaints } = await open();
  await fill(page);
  for (const [name, role] of [["T1", "fit"], ["T2", "fit"], ["T3", "held"]]) await page.selectOption(`#target-role-${await idOf(page, name)}`, role);
  await page.fill("#calibrate-strain", "1 %");
  await page.fill("#calibrate-particles", "200");
  await page.fill("#calibrate-samples", "12");
  await page.click("#calibrate-write");
  await page.fill("#case", (await page.inputValue("#case")).replace(/^(strain = .*)$/gm, "$1\nvoid_ratio_tolerance = 0.03"));
  await priced(page, "First round");
  await page.fill("#name", "Sand fit");
  await page.click("#start");
  await page.waitForSelector("#live .stages caption, #live iframe", { state: "attached" });
  await page.waitForFunction(() => document.querySelector("#live .charts h3")?.textContent === "Misfits of the samples" || document.querySelector("#live iframe"));
  if (await page.locator("#live iframe").count() === 0) {
    await page.locator("#live .charts").scrollIntoViewIfNeeded();
    await picture(page, "calibrate-live");
  }
  if (await page.locator("#live [data-do=stop]").count()) {
    await page.click("#live [data-do=stop]");
    await page.waitForSelector("#live [data-do=resume], #live [data-do=pdf]");
    if (await page.locator("#live [data-do=resume]").count()) {
      assert.match(await page.textContent("#live .state"), /Ended: stopped/);
      await page.click("#live [data-do=resume]");
    }
  }
  await page.waitForFunction(() => document.querySelector("#live .state").textContent.includes("Ended: done"));
  const frame = await (await page.waitForSelector("#live iframe")).contentFrame();
  await frame.waitForFunction(() => document.documentElement.dataset.drawn === "all");
  const numbers = await page.evaluate(() => fetch("/runs/sand-fit-0001/calibration.json").then((r) => r.json()));
  assert.equal(numbers.complete, true);
  assert.deepEqual(numbers.held_out.map((fit) => fit.target), ["T3"]);
  assert.ok((await frame.textContent(".verdict")).includes(numbers.verdict[0].slice(0, 30)));
  assert.equal(await frame.locator("figure.figure svg").count() >= 5, true);
  assert.deepEqual(complaints, []);

  await page.evaluate(() => { location.hash = "#runs"; });
  await page.fill("#search", "tests");
  await page.waitForFunction(() => document.querySelector("#run-table tbody")?.textContent.includes("sand-fit-0001"));
  assert.match(await page.textContent("#run-table tbody"), /done/);
  await page.click("#run-table >> text=sand-fit-0001");
  const listed = await (await page.waitForSelector("#run iframe")).contentFrame();
  await listed.waitForFunction(() => document.documentElement.dataset.drawn === "all");
  await picture(page, "calibrate-run");
  page.once("dialog", (dialog) => dialog.accept());
  await page.click("#run [data-do=delete]");
  await page.waitForSelector('[data-run="sand-fit-0001"]', { state: "detached" });
  await context.close();
});

test("on a phone and in the dark the form is not cut off", async () => {
  const { page, context } = await open("", { viewport: { width: 390, height: 844 }, colorScheme: "dark" });
  await fill(page);
  await page.selectOption(`#target-role-${await idOf(page, "T1")}`, "fit");
  assert.ok(await page.evaluate(() => document.documentElement.scrollWidth) <= 390);
  await page.locator("#calibrate-tests").scrollIntoViewIfNeeded();
  await picture(page, "phone-calibrate");
  await context.close();
});
