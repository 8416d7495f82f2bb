// Answers that come late, or not at all: what was chosen last counts, and nothing stays dead. Requests are held back here.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { StudioInBrowser, gap, priced } from "./studio_in_browser.mjs";
import { picture } from "./vtp_for_tests.mjs";

const studio = new StudioInBrowser(), open = (...words) => studio.open(...words);

before(async () => {
  await studio.begin();
  studio.suffuse("new", "replay", "--from", "replay");
  for (const seed of [1, 2]) studio.suffuse("run", "replay/case.toml", "-q", "--set", `seed=${seed}`);
});

after(() => studio.end());

const text = (page, id) => page.textContent(`#${id}`);
const says = (page, id, words) => page.waitForFunction(([i, w]) => document.getElementById(i).textContent.includes(w), [id, words]);
const give = (page, content, name, input = "#file") => page.setInputFiles(input, { name, mimeType: "text/csv", buffer: Buffer.from(content) });
const json = (body, status = 200) => ({ status, contentType: "application/json", body: JSON.stringify(body) });

/** Holds the next request to `path`. @return answers it, and waits until the page has heard */
async function hold(page, path) {
  let release;
  const released = new Promise((resolve) => { release = resolve; });
  const seen = new Promise((resolve) => {
    page.route(path, async (route) => {
      await released;
      await route.fallback().catch(() => {}); // the page may have given it up
      resolve();
    }, { times: 1 });
  });
  return async (heard = 1500) => {
    release();
    await seen;
    await page.waitForTimeout(heard); // [ms]
  };
}

/** The run as the studio knows it, with other facts. */
const pretend = (page, name, facts) => {
  const answer = async (route) => {
    const response = await route.fetch();
    await route.fulfill({ response, json: { ...await response.json(), ...facts } });
  };
  return page.route(`**/api/runs/${name}`, (route) => answer(route).catch(() => {})); // the page may have been closed
};

test("a filter that was taken back while it was read is none", async () => {
  const { page, context } = await open();
  await give(page, gap, "gap.csv");
  await says(page, "verdict", "criteria say");
  const answer = await hold(page, "**/api/reading");
  await give(page, "d [mm],passing [%]\n1,0\n4,100\n", "filter.csv", "#filter-file");
  await page.click("#no-filter");
  await answer();
  assert.equal(await text(page, "filter-name"), "");
  assert.doesNotMatch(await text(page, "verdict"), /filter/);
  await context.close();
});

test("a comparison that comes late does not cover the run that was opened meanwhile", async () => {
  const { page, context, complaints } = await open("#runs");
  const boxes = page.locator("#run-table input");
  await page.waitForFunction(() => document.querySelectorAll("#run-table input").length === 2);
  await page.waitForFunction(() => !document.getElementById("run-table").textContent.includes("…"));
  await boxes.nth(0).check();
  await boxes.nth(1).check();
  const answer = await hold(page, "**/api/compare/**");
  await page.click("#compare");
  await page.click("#run-table >> text=replay-0001");
  await page.waitForSelector("#run iframe");
  await answer();
  assert.equal(await page.textContent("#run h2"), "replay-0001");
  assert.equal(await page.isVisible("#trouble"), false);
  assert.deepEqual(complaints.filter((one) => !/GPU stall|WebGL/.test(one)), []);
  await context.close();
});

test("a sweep is compared with the run that was chosen last", async () => {
  const { page, context } = await open("#sweep/replay-0001");
  await page.waitForSelector("#sweep-live caption");
  await page.waitForFunction(() => document.getElementById("sweep-other").options.length > 1);
  const answer = await hold(page, "**/api/runs/replay-0002");
  await page.selectOption("#sweep-other", "replay-0002");
  await page.selectOption("#sweep-other", "");
  await answer();
  assert.doesNotMatch(await page.textContent("#sweep-live"), /replay-0002/);
  assert.equal(await text(page, "sweep-differences"), "");
  await context.close();
});

test("of two states in 3D the one that was chosen last is shown", async () => {
  const { page, context } = await open();
  await pretend(page, "replay-0001", { at_work: true });
  await page.route("**/api/runs/replay-0001/pictures", (route) => route.fulfill(json({ result: ["a", "b"].map((name, at) => ({ file: `studies/${name}.vtp`, at })), talk: [] })));
  await page.route("**/studies/*.vtp", (route) => route.fulfill({ body: Buffer.from(picture()) }));
  await page.evaluate(() => { location.hash = "#runs/replay-0001"; });
  await page.click("#run .grains summary");
  const state = (words) => page.waitForFunction((w) => document.querySelector("#run .grains p").textContent.startsWith(w), words);
  await state("a: 2 grains");
  const answer = await hold(page, "**/studies/b.vtp");
  const requested = page.waitForRequest("**/studies/b.vtp");
  await page.selectOption("#run .grains select", "studies/b.vtp");
  await requested;
  await page.selectOption("#run .grains select", "studies/a.vtp");
  await answer(300); // before the next look
  assert.match(await page.textContent("#run .grains p"), /^a: 2 grains/);
  await context.close();
});

test("a run that could not be stopped can be stopped again, and one is followed on where an answer was lost", async () => {
  const { page, context } = await open();
  let lost = 0;
  await pretend(page, "replay-0001", { at_work: true, can_stop: true, report: false, calibration: { answered: 1, rounds: [] } });
  await page.route("**/runs/replay-0001/calibration.json", (route) => (lost++ ? route.fulfill(json({ parameters: {}, rounds: [], samples: [], fit: [], held_out: [] })) : route.abort()));
  await page.route("**/api/runs/replay-0001/stop", (route) => route.fulfill(json({ error: { message: "this run is not at work" } }, 409)));
  await page.evaluate(() => { location.hash = "#runs/replay-0001"; });
  await page.click("#run [data-do=stop]", { timeout: 20_000 }); // 5 s after the first answer was lost
  await says(page, "trouble", "not at work");
  await page.waitForFunction(() => !document.querySelector("#run [data-do=stop]").disabled);
  await context.close();
});

test("what is wrong in the data of a case is no line of the case, and a case that was emptied cannot be started", async () => {
  const { page, context } = await open();
  await give(page, gap, "gap.csv");
  await says(page, "verdict", "criteria say");
  await page.click("text=Simulate this soil");
  await priced(page);
  const own = await page.inputValue("#case");
  await page.setInputFiles("#case-files", [{ name: "case.toml", mimeType: "text/plain", buffer: Buffer.from(own) }, { name: "gap.csv", mimeType: "text/csv", buffer: Buffer.from("d [mm],passing [%]\n1,50\n2,oops\n") }]);
  await says(page, "problems", 'data/gap.csv, line 3: "oops" is not a number');
  assert.equal(await page.locator("#numbers b, #problems button").count(), 0);
  assert.equal(await page.isDisabled("#start"), true);
  await page.click("#make");
  await priced(page);
  await page.locator("#case").fill("");
  await page.waitForFunction(() => document.getElementById("start").disabled && document.getElementById("price").textContent === "–");
  await context.close();
});

test("a case has the name of what it was written from, whatever is chosen meanwhile", async () => {
  const { page, context } = await open("#simulate");
  await page.waitForFunction(() => document.getElementById("from").options.length > 2);
  await page.selectOption("#from", "replay");
  const answer = await hold(page, "**/api/new");
  await page.click("#make");
  await page.selectOption("#from", "laboratory");
  await answer();
  assert.equal(await page.inputValue("#name"), "replay");
  await context.close();
});

test("a record is what was chosen last", async () => {
  const { page, context } = await open("#simulate");
  await page.click("#calibration summary");
  await give(page, "axial strain [%],deviator stress [kPa],void ratio\n0,0,0.7\n1,50,0.69\n2,90,0.68\n", "test.csv", "#calibrate-files");
  await says(page, "calibrate-records", "test.csv: triaxial");
  const answer = await hold(page, "**/api/record");
  const requested = page.waitForRequest("**/api/record");
  await page.selectOption("#calibrate-kind", "oedometer");
  await requested;
  await page.selectOption("#calibrate-kind", "triaxial");
  await page.waitForTimeout(1000); // in which it would be read, if it did not wait
  await answer();
  await page.waitForFunction(() => !document.getElementById("calibrate-reading").textContent);
  assert.match(await text(page, "calibrate-records"), /test\.csv: triaxial/);
  assert.equal(await page.isVisible("#trouble"), false); // what was said of it as an oedometer test is over
  await context.close();
});

test("text is dragged as elsewhere, files are dropped, and a case that was dropped leaves no mark", async () => {
  const { page, context } = await open();
  const drag = (name, id, isFile) => page.evaluate(([type, place, file]) => {
    const dataTransfer = new DataTransfer();
    if (file) dataTransfer.items.add(new File(["x = 1"], "case.toml"));
    else dataTransfer.setData("text/plain", "x");
    return !document.getElementById(place).dispatchEvent(new DragEvent(type, { bubbles: true, cancelable: true, dataTransfer }));
  }, [name, id, isFile]);
  assert.deepEqual([await drag("dragover", "table", false), await drag("drop", "table", false)], [false, false]);
  assert.equal(await drag("dragover", "case-drop", true), true);
  assert.equal(await page.locator("#drop.over").count(), 1);
  assert.equal(await drag("drop", "case-drop", true), true);
  assert.equal(await page.locator("#drop.over").count(), 0);
  await context.close();
});

test("a point of the curve is let go where the browser takes the pointer", async () => {
  const { page, context } = await open("", { hasTouch: true });
  await give(page, gap, "gap.csv");
  await says(page, "verdict", "criteria say");
  assert.equal(await page.locator(".knob").first().evaluate((knob) => getComputedStyle(knob).touchAction), "none");
  const box = await page.locator('[data-point="4"]').boundingBox(), [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x, y - 5);
  await says(page, "curve-note", "The curve was edited here.");
  await page.evaluate(() => { const svg = document.getElementById("curve"); svg.addEventListener("pointermove", (event) => svg.releasePointerCapture(event.pointerId), { once: true }); });
  await page.mouse.move(x, y - 6);
  await page.mouse.move(x, y - 7);
  const table = await page.inputValue("#table");
  await page.mouse.move(x, y - 40);
  assert.equal(await page.inputValue("#table"), table);
  await context.close();
});

test("a sweep that was deleted is no longer shown, and keys without values count for nothing", async () => {
  const { page, context } = await open("#sweep");
  await page.waitForFunction(() => document.getElementById("sweep-from").options.length > 2);
  await page.selectOption("#sweep-from", "laboratory");
  await page.click("#sweep-take");
  await page.waitForFunction(() => document.getElementById("sweep-case").value);
  await page.click("#sweep-add");
  await page.locator("#sweep-keys .key").last().fill("contact.rolling_friction");
  await page.click("#sweep-write");
  await says(page, "sweep-written", "Written into the case: 3 samples.");
  await page.evaluate(() => { location.hash = "#sweep/replay-0002"; });
  page.on("dialog", (dialog) => dialog.accept());
  await page.click("#sweep-live [data-do=delete]");
  await page.waitForFunction(() => location.hash === "#sweep" && document.getElementById("sweep-shown-row").hidden);
  await page.waitForFunction(() => !document.getElementById("sweep-shown").textContent.includes("replay-0002"));
  await context.close();
});
