// The studio in a browser, as a user walks through it: a soil, its simulation, its report. The program is the real one.
import assert from "node:assert/strict";
import { cpSync, mkdirSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { StudioInBrowser, gap, nameless, picture } from "./studio_in_browser.mjs";

const gravel = "d [mm],passing [%]\n0.1,0\n0.2,15\n0.4,22\n2,24\n4,50\n8,80\n16,100\n";
const studio = new StudioInBrowser(), open = (...words) => studio.open(...words);

before(async () => {
  await studio.begin();
  writeFileSync(join(studio.folder, "filter.csv"), "d [mm],passing [%]\n0.5,0\n1,20\n2,60\n4,100\n");
  studio.suffuse("new", "replay", "--from", "replay");
  for (const seed of [1, 2]) studio.suffuse("run", "replay/case.toml", "-q", "--set", `seed=${seed}`);
});

after(() => studio.end());

const giveSoil = async (page, text = gap, name = "gap.csv") => {
  const before = await page.textContent("#soil-results");
  await page.setInputFiles("#file", { name, mimeType: "text/csv", buffer: Buffer.from(text) });
  await page.waitForFunction((old) => document.querySelectorAll("#soil-results tr").length > 5 && document.getElementById("soil-results").textContent !== old, before);
};

test("a soil: its verdict, its gap, an edited curve, a filter, and a PDF", async () => {
  const { page, context, complaints } = await open();
  await giveSoil(page);
  assert.match(await page.textContent("#verdict"), /1 of 6 criteria say unstable/);
  assert.match(await page.textContent("#curve"), /fines: 20 % below 0.4 mm/);
  assert.equal(await page.locator("#curve .gap").count(), 1);
  await picture(page, "soil");
  await page.locator("#gradient").fill("0.9");
  await page.waitForFunction(() => document.getElementById("verdict").textContent.includes("Factor of safety 1.1 against heave"));
  const knob = page.locator('#curve [data-point="4"]');
  await knob.focus();
  await page.keyboard.press("ArrowUp");
  await page.waitForFunction(() => document.getElementById("table").value.includes("0.9,22"));
  await page.waitForFunction(() => document.activeElement?.dataset.point === "4"); // drawn anew, it has the focus still
  await page.click("#back");
  await page.waitForFunction(() => document.getElementById("back").hidden);
  await page.setInputFiles("#filter-file", join(studio.folder, "filter.csv"));
  await page.waitForFunction(() => document.getElementById("soil-results").textContent.includes("Terzaghi and Peck"));
  const pdf = await page.pdf({ format: "A4" });
  assert.ok(pdf.length > 10_000 && pdf.subarray(0, 4).toString() === "%PDF");
  assert.deepEqual(complaints, []);
  await context.close();
});

test("a sheet that is read wrong is corrected by choosing its columns", async () => {
  const { page, context, complaints } = await open();
  await page.locator("#table").fill("a;b;c\n4;9;100\n2;9;60\n1;9;20\n0.5;9;0\n");
  await page.waitForFunction(() => !document.getElementById("trouble").hidden);
  await page.selectOption("#size-column", "1");
  await page.selectOption("#size-unit", "mm");
  await page.selectOption("#amount-column", "3");
  await page.waitForFunction(() => document.querySelectorAll("#soil-results tr").length > 5);
  assert.match(await page.textContent("#reading"), /c.*percent passing/);
  assert.equal(complaints.filter((text) => !text.includes("422")).length, 0);
  await context.close();
});

test("a simulation: price first, an error at its line, started, followed, stopped, resumed", async () => {
  const { page, context, complaints } = await open();
  await giveSoil(page);
  await page.click("text=Simulate this soil");
  await page.waitForFunction(() => /\d/.test(document.getElementById("price").textContent));
  const text = await page.inputValue("#case");
  await page.locator("#case").fill(text.replace("friction          =", "frictoin          ="));
  const line = text.split("\n").findIndex((one) => one.startsWith("friction  ")) + 1;
  await page.waitForSelector(`#problems button[data-line="${line}"]`);
  assert.equal(await page.isDisabled("#start"), true);
  await page.click(`#problems button[data-line="${line}"]`);
  assert.match(await page.evaluate(() => { const c = document.getElementById("case"); return c.value.slice(c.selectionStart, c.selectionEnd); }), /^frictoin/);
  await picture(page, "error");
  await page.locator("#case").fill(text);
  await page.waitForFunction(() => !document.getElementById("start").disabled);
  await page.locator("#particles").fill("8000");
  await page.click("#make");
  await page.waitForFunction(() => document.getElementById("case").value.includes("= 8000 ") && !document.getElementById("start").disabled);
  await page.locator("#name").fill("walk");
  await page.click("#start");
  await page.waitForSelector("#live progress");
  await page.waitForFunction(() => { // a line of its rest, or, where that was short, the dots of its levels
    const lines = [...document.querySelectorAll("#live .charts path.mine")].map((path) => path.getAttribute("d").split("L").length);
    return Math.max(...lines, document.querySelectorAll("#live .charts circle.mine").length) > 6;
  });
  await picture(page, "live");
  await page.click("#live >> text=Stop and save");
  await page.waitForSelector("#live >> text=Resume");
  assert.match(await page.textContent("#live .state"), /Ended: stopped/);
  await page.click("#live >> text=Resume");
  await page.waitForSelector("#live progress");
  studio.kill(); // the run goes on
  await studio.start();
  assert.deepEqual(complaints.filter((one) => !/422|ERR_CONNECTION/.test(one)), []);
  await context.close();
  const again = await open("#runs/walk-0001");
  await again.page.waitForSelector("#run progress");
  await again.page.click("#run >> text=Stop and save");
  await again.page.waitForSelector("#run >> text=Resume");
  await again.context.close();
});

test("the curve of mobility grows while its stage is at work", async () => {
  const { page, context, complaints } = await open();
  await giveSoil(page);
  await page.click("text=Simulate this soil");
  await page.selectOption("#way", "surrogate");
  await page.click("#make");
  await page.waitForFunction(() => document.getElementById("case").value.includes("surrogate") && !document.getElementById("start").disabled);
  await page.locator("#name").fill("mobility");
  await page.click("#start");
  const dots = () => page.locator("#live .charts .dot").count();
  await page.waitForFunction(() => document.querySelectorAll("#live .charts .dot").length > 14 && document.querySelector("#live h3").textContent.includes("is held"));
  await picture(page, "mobility");
  const before = await dots();
  await page.waitForFunction((n) => document.querySelectorAll("#live .charts .dot").length > n, before);
  await page.click("#live >> text=Stop and save");
  await page.waitForSelector("#live >> text=Resume");
  assert.deepEqual(complaints, []);
  await context.close();
});

test("grains in 3D while a run is at work: the newest state, turned by the keyboard, kept as it was turned", async () => {
  const { page, context, complaints } = await open("#simulate");
  await page.selectOption("#from", "laboratory");
  await page.click("#make");
  await page.waitForFunction(() => document.getElementById("case").value.includes("formats = []"));
  await page.locator("#case").fill((await page.inputValue("#case")).replace("formats = []", 'formats = ["vtp"]\nsnapshots = { every = "1 %" }').replace(/void_ratio.*\n/g, ""));
  await page.waitForFunction(() => !document.getElementById("start").disabled);
  await page.locator("#name").fill("grains");
  await page.click("#start");
  await page.waitForSelector("#live .grains summary");
  await page.locator("#live .grains summary").focus();
  await page.keyboard.press("Enter");
  await page.waitForFunction(() => Number(document.querySelector("#live .picture").dataset.frames) > 0);
  const state = () => page.textContent("#live .grains p"), first = await state();
  assert.match(first, /: 2,000 grains\.$/);
  await page.locator("#live .picture").focus();
  const frames = await page.evaluate(() => Number(document.querySelector("#live .picture").dataset.frames));
  await page.keyboard.press("ArrowLeft");
  await page.waitForFunction((n) => Number(document.querySelector("#live .picture").dataset.frames) > n, frames);
  await page.waitForFunction((text) => document.querySelector("#live .grains p").textContent !== text, first);
  assert.equal(await page.locator("#live .picture canvas").count(), 1);
  await page.locator("#live .grains").scrollIntoViewIfNeeded();
  await picture(page, "grains");
  await page.locator("#live .grains select").selectOption({ index: 1 });
  assert.deepEqual(await nameless(page), []);
  await page.setViewportSize({ width: 390, height: 844 });
  assert.ok(await page.evaluate(() => document.documentElement.scrollWidth) <= 390);
  await page.click("#live >> text=Stop and save");
  await page.waitForSelector("#live >> text=Resume");
  assert.deepEqual(complaints.filter((one) => !/GPU stall|WebGL/.test(one)), []);
  await context.close();
});

test("a laboratory test is a form of its keys, and becomes a stage of the case", async () => {
  const { page, context, complaints } = await open("#simulate");
  await page.selectOption("#from", "laboratory");
  await page.click("#make");
  await page.waitForFunction(() => document.getElementById("case").value.includes("formats = []") && !document.getElementById("start").disabled);
  const before = await page.locator("#stages tbody tr").count();
  await page.click("text=Add a laboratory test");
  await page.waitForSelector("#test-key-path", { state: "attached" });
  const verbs = ["triaxial", "plane-strain", "oedometer", "isotropic", "shear", "cyclic"];
  for (const verb of verbs) {
    await page.selectOption("#test-verb", verb);
    assert.deepEqual(await nameless(page), [], verb);
    const needed = await page.locator("#test-keys [required]").count();
    assert.equal(needed, verb === "oedometer" || verb === "isotropic" ? 1 : 0, verb);
    if (needed) {
      await page.click("#test-add");
      await page.waitForFunction(() => document.getElementById("trouble").textContent.includes("needs its stresses"));
      await page.locator("#test-key-stresses").fill("200 kPa, 100 kPa");
    }
    if (verb === "cyclic") {
      await page.locator("#test-key-csr").fill("0.3");
      await page.selectOption("#test-key-drainage", "undrained");
      await page.evaluate(() => window.scrollTo(0, document.getElementById("tests").offsetTop));
      await picture(page, "test-form");
    }
    await page.click("#test-add");
    await page.waitForFunction((name) => document.getElementById("case").value.includes(`name = "${name}-`) || document.getElementById("case").value.includes(`name = "${name}"`), verb);
  }
  const text = await page.inputValue("#case");
  assert.ok(text.includes('[[study.sand.stage]]\nname = "cyclic-2"\nfrom = "initial"\ndo = "cyclic"\ndrainage = "undrained"\ncsr = 0.3\n'), text);
  assert.ok(text.includes('do = "oedometer"\nstresses = ["200 kPa", "100 kPa"]\n'));
  await page.waitForFunction((all) => document.querySelectorAll("#stages tbody tr").length === all && !document.getElementById("start").disabled, before + verbs.length);
  await page.locator("#test-key-csr").fill("much");
  await page.click("#test-add");
  const line = (await page.inputValue("#case")).split("\n").findIndex((one) => one === 'csr = "much"') + 1;
  await page.waitForSelector(`#problems button[data-line="${line}"]`);
  await page.setViewportSize({ width: 390, height: 844 });
  assert.ok(await page.evaluate(() => document.documentElement.scrollWidth) <= 390);
  assert.deepEqual(complaints.filter((one) => !one.includes("422")), []);
  await context.close();
});

test("runs: searched, their report in a frame without rights, two compared, one deleted after a question", async () => {
  const { page, context, complaints } = await open("#runs");
  await page.waitForSelector("#run-table tbody tr");
  await page.fill("#search", "replay-0001");
  assert.equal(await page.locator("#run-table tbody tr").count(), 1);
  await page.click("#run-table >> text=replay-0001");
  const frame = await (await page.waitForSelector("iframe")).contentFrame();
  await frame.waitForFunction(() => document.documentElement.dataset.drawn === "all");
  assert.equal(await frame.evaluate(() => self.origin), "null");
  assert.equal(await frame.evaluate(() => fetch("/api/runs").then(() => "read", () => "refused")), "refused");
  await picture(page, "runs");
  complaints.length = 0; // the browser's, of what was just refused
  const printed = await page.evaluate(async () => {
    const form = new FormData();
    form.append("from-page", "studio");
    await fetch("/api/runs/replay-0001/pdf", { method: "POST", body: form });
    const answer = await fetch("/runs/replay-0001/report.pdf");
    return [answer.headers.get("content-type"), (await answer.text()).slice(0, 4)];
  });
  assert.deepEqual(printed, ["application/pdf", "%PDF"]);
  await page.fill("#search", "");
  for (const name of ["replay-0001", "replay-0002"]) await page.check(`[data-run="${name}"]`);
  await page.click("#compare");
  await page.waitForFunction(() => document.getElementById("run").textContent.includes("No number differs"));
  assert.match(await page.textContent("#run"), /seed: 1 and 2/);
  await page.click("#run-table >> text=replay-0002");
  await page.waitForSelector("#run iframe");
  page.once("dialog", (dialog) => dialog.dismiss());
  await page.click("text=Delete …");
  await page.waitForTimeout(300);
  assert.equal(await page.locator('[data-run="replay-0002"]').count(), 1);
  page.once("dialog", (dialog) => dialog.accept());
  await page.click("text=Delete …");
  await page.waitForSelector('[data-run="replay-0002"]', { state: "detached" });
  assert.deepEqual(complaints, []);
  await context.close();
});

test("the report opened alone has no rights either", async () => {
  const { page, context } = await open("#runs/replay-0001");
  const [alone] = await Promise.all([context.waitForEvent("page"), page.click("text=Open the report alone")]);
  await alone.waitForFunction(() => document.documentElement.dataset.drawn === "all");
  assert.equal(await alone.evaluate(() => self.origin), "null");
  await context.close();
});

test("everything can be reached and named by the keyboard alone", async () => {
  const { page, context } = await open();
  await giveSoil(page);
  const seen = new Set();
  for (let k = 0; k < 60; ++k) {
    await page.keyboard.press("Tab");
    const id = await page.evaluate(() => document.activeElement.id || document.activeElement.textContent.trim() || document.activeElement.dataset.point);
    seen.add(id);
  }
  for (const wanted of ["Skip to the content", "Soil", "Simulate", "Runs", "Sweep", "file", "table", "gradient", "flow", "filter-file", "print", "0"]) assert.ok(seen.has(wanted), wanted);
  for (const hash of ["#soil", "#simulate", "#runs", "#sweep"]) {
    await page.evaluate((h) => { location.hash = h; }, hash);
    await page.waitForTimeout(200);
    assert.deepEqual(await nameless(page), [], hash);
  }
  await context.close();
});

test("on a phone and in the dark nothing is cut off, and words stand out from their paper", async () => {
  const { page, context } = await open("", { viewport: { width: 390, height: 844 }, colorScheme: "dark" });
  await giveSoil(page);
  for (const hash of ["#soil", "#simulate", "#runs/replay-0001", "#sweep/replay-0001"]) {
    await page.evaluate((h) => { location.hash = h; }, hash);
    await page.waitForTimeout(1500);
    const width = await page.evaluate(() => document.documentElement.scrollWidth);
    assert.ok(width <= 390, `${hash} is ${width} wide`);
    await picture(page, `phone-${hash.slice(1).split("/")[0]}`);
  }
  for (const colorScheme of ["dark", "light"]) {
    await page.emulateMedia({ colorScheme });
    const contrasts = await page.evaluate(() => {
      const style = getComputedStyle(document.documentElement), of = (name) => style.getPropertyValue(name).trim();
      const light = (hex) => {
        const full = hex.length === 4 ? `#${[...hex.slice(1)].map((c) => c + c).join("")}` : hex;
        const [r, g, b] = [1, 3, 5].map((k) => parseInt(full.slice(k, k + 2), 16) / 255).map((v) => (v <= 0.04045 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4));
        return 0.2126 * r + 0.7152 * g + 0.0722 * b;
      };
      return ["--ink", "--soft", "--water", "--ok", "--no"].flatMap((ink) => ["--paper", "--panel"].map((paper) => {
        const [a, b] = [light(of(ink)), light(of(paper))].sort((x, y) => y - x);
        return [`${ink} on ${paper}`, (a + 0.05) / (b + 0.05)];
      }));
    });
    for (const [what, ratio] of contrasts) assert.ok(ratio >= 4.5, `${what} in ${colorScheme}: ${ratio.toFixed(2)}`);
  }
  await context.close();
});

test("a thousand runs are listed by name, whatever the time that what they found takes", async () => {
  const from = join(studio.folder, "runs", "replay-0001");
  for (let k = 3; k <= 1000; ++k) {
    const to = join(studio.folder, "runs", `many-${String(k).padStart(4, "0")}`);
    mkdirSync(to);
    for (const file of ["case.resolved.toml", "run_options.json", "summary.json", "provenance.json"]) cpSync(join(from, file), join(to, file));
  }
  const { page, context } = await open("#runs");
  await page.waitForFunction(() => document.querySelectorAll("#run-table tbody tr").length > 900);
  await context.close();
});

test("a soil too wide to simulate whole is offered as a surrogate", async () => {
  const { page, context } = await open();
  await giveSoil(page, gravel, "gravel.csv");
  await page.click("text=Simulate this soil");
  await page.waitForFunction(() => document.getElementById("case").value || !document.getElementById("trouble").hidden);
  await page.selectOption("#way", "surrogate");
  await page.click("#make");
  await page.waitForFunction(() => document.getElementById("made").textContent.includes("a surrogate leaves out"));
  await page.waitForFunction(() => /\d/.test(document.getElementById("price").textContent));
  await context.close();
});
