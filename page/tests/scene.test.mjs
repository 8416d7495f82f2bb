// The section "In 3D": what the view draws and shows, and what stands in for it.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { drawnAfter, launch, open, pixels, samples, settled } from "./browser.mjs";
import { colorModes } from "../src/scene/colors.js";
import { readScene } from "../src/scene/data.js";
import { grainAt } from "../src/scene/pick.js";
import { roundLength } from "../src/scene/overlay.js";
import { pathOf, pathsShown } from "../src/scene/paths.js";
import { isSoftware, softwareLimit, thinned } from "../src/scene/thin.js";

let browser, page, complaints;
const choose = (change, where = page) => where.evaluate((wanted) => document.querySelector("[data-scene]").view.choose(wanted), change);
const fresh = { state: 0, mode: "class", coarse: true, fines: true, chains: false, cell: true, size: 1, cut: "none", chosen: -1 };

before(async () => {
  browser = await launch();
  ({ page, complaints } = await open(browser, "sample"));
});

after(() => browser?.close());

test("the view draws with WebGL 2, fills a fair part of its frame, and complains of nothing", async () => {
  await choose(fresh);
  const seen = await pixels(page);
  assert.ok(seen.share > 0.2 && seen.share < 0.8, `${seen.share} of the pixels are drawn`);
  assert.ok(seen.colors > 20, `${seen.colors} colors`);
  assert.ok(await page.evaluate(() => document.querySelector("[data-scene]").view.renderer.getContext() instanceof WebGL2RenderingContext));
  assert.equal(await page.locator(".still").first().isVisible(), false, "stills make way for the view");
  assert.equal(await page.locator("[data-no-view]").isVisible(), false);
  assert.deepEqual(complaints, []);
});

test("nothing is drawn while nobody touches it", async () => {
  await settled(page);
  const frames = () => page.getAttribute(".picture", "data-frames");
  const before = await frames();
  // As many frames of the browser as a view that draws without need would have used.
  await page.evaluate(async () => {
    for (let k = 0; k < 10; ++k) await new Promise((next) => requestAnimationFrame(next));
  });
  assert.equal(await frames(), before);
});

test("each color mode tells at least two groups apart, and its legend counts all grains", async () => {
  const modes = await page.evaluate(() => Object.keys(document.querySelector("[data-scene]").view.modes));
  assert.deepEqual(modes, ["class", "activity", "coordination", "speed", "force", "pass"]);
  for (const mode of modes) {
    await choose({ ...fresh, mode });
    const { tints, counted, scale } = await page.evaluate(() => {
      const { view } = document.querySelector("[data-scene]");
      const { array } = view.spheres.tint;
      const tints = new Set(view.rows.map((_, k) => array.slice(3 * k, 3 * k + 3).join()));
      return { tints: tints.size, counted: view.legend.swatches.reduce((sum, each) => sum + each.count, 0), scale: view.legend.range };
    });
    assert.ok(tints >= 2, `${mode}: ${tints} colors`);
    if (!scale) assert.equal(counted, 512, mode);
  }
});

test("the slider over passes takes away exactly the grains that left, and the picture changes", async () => {
  await choose(fresh);
  const before = await pixels(page);
  const slider = page.locator('[data-control="state"]');
  await slider.focus();
  await drawnAfter(page, () => page.keyboard.press("ArrowRight"));
  const { shown, left } = await page.evaluate(() => {
    const { view } = document.querySelector("[data-scene]");
    return { shown: view.rows.length, left: view.scene.leftIn.filter((pass) => pass === 1).length };
  });
  assert.ok(left > 0);
  assert.equal(shown, 512 - left);
  assert.notEqual((await pixels(page)).print, before.print);
  assert.equal(await slider.getAttribute("aria-valuetext"), "after pass 1");
});

test("a click on a grain shows its card, and a neighbor on the card can be chosen instead", async () => {
  await choose(fresh);
  const target = await page.evaluate(() => {
    const { view } = document.querySelector("[data-scene]");
    view.place.scrollIntoView({ block: "center", behavior: "instant" });
    // A grain whose middle nobody hides.
    const row = view.rows.find((each) => {
      const { x, y } = view.seenAt(each);
      return view.pick(x, y) === each && view.scene.fine[each] && view.scene.leftIn[each] === 0 && view.state.coordination[each] > 0;
    });
    const box = view.canvas.getBoundingClientRect();
    const { x, y } = view.seenAt(row);
    return { x: box.left + x, y: box.top + y, id: view.scene.id[row] };
  });
  await drawnAfter(page, () => page.mouse.click(target.x, target.y));
  const card = page.locator(".card");
  assert.match(await card.textContent(), new RegExp(`Grain ${target.id}, fine`));
  assert.match(await card.textContent(), /diameter d0\.2 mm/);
  assert.match(await card.textContent(), /fluid force, i = 0\.05/);
  assert.match(await card.textContent(), /it stays/);
  const neighbor = card.locator("button").first();
  const id = await neighbor.textContent();
  await neighbor.evaluate((button) => button.click());
  assert.match(await card.textContent(), new RegExp(`Grain ${id},`));
  assert.equal(await page.inputValue('[data-control="grain"]'), id);
});

test("a grain is found by its number, also one that has left; an unknown number is reported", async () => {
  await choose({ ...fresh, state: 1 });
  const gone = await page.evaluate(() => {
    const { scene } = document.querySelector("[data-scene]").view;
    return scene.id[scene.leftIn.findIndex((pass) => pass === 1)];
  });
  const field = page.locator('[data-control="grain"]');
  await field.fill(String(gone));
  await field.press("Enter");
  assert.match(await page.textContent(".card"), /left in pass 1/);
  await field.fill("7");
  await field.press("Enter");
  assert.match(await page.textContent(".stage [role=status]"), /no grain 7/);
});

test("force chains, cut and a drag each change the picture", async () => {
  await choose(fresh);
  const plain = await pixels(page);
  await choose({ ...fresh, chains: true, size: 0.3, least: 1 });
  const chains = await pixels(page);
  assert.notEqual(chains.print, plain.print);
  const shown = await page.evaluate(() => {
    const { view } = document.querySelector("[data-scene]");
    return { drawn: view.chainsShown, strong: view.state.force.filter((f) => f >= view.state.meanForce).length };
  });
  assert.equal(shown.drawn, shown.strong);
  await choose({ ...fresh, cut: "y", at: 0.5, flip: true });
  const cut = await pixels(page);
  assert.ok(cut.share < plain.share, `${cut.share} after the cut, ${plain.share} before`);
  await choose(fresh);
  const picture = page.locator(".picture");
  await picture.scrollIntoViewIfNeeded(); // the mouse reaches only what the window shows
  const box = await picture.boundingBox();
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  const hit = await page.evaluate(([px, py]) => document.elementFromPoint(px, py)?.tagName, [x, y]);
  assert.equal(hit, "CANVAS", "the mouse is over the view");
  await drawnAfter(page, async () => {
    await page.mouse.move(x, y);
    await page.mouse.down();
    await page.mouse.move(x + 120, y + 30, { steps: 3 });
    await page.mouse.up();
  });
  assert.notEqual((await pixels(page)).print, plain.print);
});

test("the keyboard turns, zooms, chooses and goes home", async () => {
  await choose(fresh);
  await page.locator(".picture").focus();
  await page.keyboard.press("Home");
  const home = await pixels(page);
  await drawnAfter(page, () => page.keyboard.press("ArrowLeft"));
  assert.notEqual((await pixels(page)).print, home.print);
  await page.keyboard.press("Home");
  await page.keyboard.press("+");
  assert.ok((await pixels(page)).share > home.share);
  await page.keyboard.press("Enter");
  assert.match(await page.textContent(".card h3"), /^Grain \d+/);
  await page.keyboard.press("Escape");
  assert.match(await page.textContent(".card h3"), /No grain/);
  await page.keyboard.press("Home");
  assert.equal((await pixels(page)).print, home.print);
});

test("the view can be saved as PNG, on white", async () => {
  await choose(fresh);
  const [download] = await Promise.all([
    page.waitForEvent("download"),
    page.locator(".panel button", { hasText: "PNG" }).evaluate((button) => button.click()),
  ]);
  assert.equal(download.suggestedFilename(), "synthetic-0001-grains.png");
  const png = readFileSync(await download.path());
  assert.equal(png.subarray(1, 4).toString(), "PNG");
  const width = await page.evaluate(() => document.querySelector(".picture").clientWidth);
  assert.equal(png.readUInt32BE(16), 2 * width);
});

test("a dark screen gets a dark frame", async () => {
  const dark = await open(browser, "sample", { colorScheme: "dark" });
  const seen = await pixels(dark.page);
  assert.ok(seen.share > 0.2 && seen.share < 0.8);
  const corner = await dark.page.evaluate(() => document.querySelector("[data-scene]").view.uniforms.paper.value.x);
  assert.ok(corner < 0.25, `paper ${corner}`);
  await dark.page.locator(".view3d").screenshot({ path: join(samples, "scene-dark.png") });
  await dark.context.close();
});

test("without WebGL a sentence says so, and the still pictures stand in", async () => {
  const blind = await launch(["--disable-gpu", "--disable-3d-apis"]);
  try {
    const { page, complaints } = await open(blind, "sample");
    assert.ok(await page.getByText("The view in 3D needs WebGL 2").isVisible());
    assert.equal(await page.locator(".view3d").isVisible(), false);
    assert.equal(await page.locator(".still img").count(), 2);
    for (const still of await page.locator(".still img").all()) {
      assert.ok(await still.isVisible());
      assert.ok(await still.evaluate((image) => image.complete && image.naturalWidth === 640 && image.alt.length > 20));
    }
    assert.ok(await page.locator("table.scene-counts").isVisible());
    assert.deepEqual(complaints, []);
    await page.locator("#in-3d").screenshot({ path: join(samples, "no-webgl.png") });
  } finally {
    await blind.close();
  }
});

test("plain and without JavaScript, the still pictures and the numbers of each state are there", async () => {
  for (const [run, options] of [["plain", {}], ["sample", { javaScriptEnabled: false }]]) {
    const { page, context } = await open(browser, run, options);
    assert.ok(await page.locator(".still img").first().isVisible(), run);
    assert.equal(await page.locator("table.scene-counts tbody tr").count(), 2);
    await context.close();
  }
});

test("in print the still pictures take the place of the view", async () => {
  const { page, context } = await open(browser, "sample");
  await page.emulateMedia({ media: "print" });
  assert.equal(await page.locator(".view3d").isVisible(), false);
  assert.ok(await page.locator(".still img").first().isVisible());
  await context.close();
});

test("a logarithmic scale over one value only still has colors", () => {
  const state = { present: [1, 1], coordination: [2, 3], speed: [1e-6, 1e-6] };
  const { speed } = colorModes({ id: [0, 1], fine: [1, 1], leftIn: [0, 0], states: [state], gradient: 0.05 });
  assert.ok(speed.color(state, 0).every(Number.isFinite));
  assert.deepEqual(speed.legend(state, [0, 1]).range, ["1·10⁻⁶", "1·10⁻⁶", "1·10⁻⁶"]);
});

test("a slow renderer is given at most its share: all coarse grains, an even part of the fines", () => {
  const rows = Array.from({ length: 50_000 }, (_, k) => k);
  const isFine = rows.map((row) => (row % 10 === 0 ? 0 : 1));
  const drawn = thinned(rows, isFine, softwareLimit);
  assert.equal(drawn.length, softwareLimit);
  assert.equal(drawn.filter((row) => !isFine[row]).length, 5000);
  assert.equal(new Set(drawn).size, softwareLimit);
  const lower = drawn.filter((row) => isFine[row] && row < 25_000).length;
  assert.ok(Math.abs(lower - 12_500) < 20, `${lower} of the fines from the first half`);
  assert.equal(thinned(rows, isFine, 60_000), rows);
  const mostlyCoarse = thinned(rows, rows.map((row) => (row % 5 === 0 ? 1 : 0)), softwareLimit);
  assert.equal(mostlyCoarse.filter((row) => row % 5 === 0).length, 10_000, "fines keep a third of the room");
  assert.equal(mostlyCoarse.length, softwareLimit);
  assert.ok(isSoftware("ANGLE (Google, Vulkan 1.3.0 (SwiftShader Device), SwiftShader driver)") && isSoftware("llvmpipe (LLVM 15)"));
  assert.ok(!isSoftware("NVIDIA GeForce RTX 3060/PCIe/SSE2"));
});

test("picking meets the closed form: the nearest sphere, and the flat face of a cut one", () => {
  const identity = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
  const position = [0, 0, 0, 0.5, 0, -3];
  const pickAt = (x, y, clip = [0, 0, 1, 1e9]) => grainAt(x, y, [0, 1], position, [1, 2], 1, identity, clip);
  assert.equal(pickAt(0.9, 0), 0); // its top is at sqrt(0.19), the other's below zero
  assert.equal(pickAt(1.1, 0), 1);
  assert.equal(pickAt(3, 0), -1);
  assert.equal(pickAt(0, 0, [0, 0, 1, -1.5]), 1); // all of the first is cut away, the second at its face
  assert.equal(pickAt(0, 0, [0, 0, -1, -2]), -1); // a plane that faces away keeps nothing under the eye that was cut
});

test("scale bars are 1, 2 or 5 times a power of ten", () => {
  assert.deepEqual([0.7, 1, 1.99, 4.9, 12, 0.034].map(roundLength), [0.5, 1, 1, 2, 10, 0.02]);
});

const packed = (type, Values, list) => ({ type, data: Buffer.from(new Values(list).buffer).toString("base64") });

/** Four fines of diameter 2 mm in a leaning cell 10 mm wide, by how far along the first cell vector they are in each state: beyond 1 in a further period. */
function migration(fractions, more = {}) {
  const grains = fractions[0].length;
  const all = (type, Values, value) => packed(type, Values, Array(grains).fill(value));
  return readScene({
    id: packed("u32", Uint32Array, fractions[0].map((_, k) => k)), radius: all("f32", Float32Array, 1e-3), fine: all("u8", Uint8Array, 1), left_in: all("u16", Uint16Array, 0),
    states: fractions.map((row, k) => ({
      label: `i = 0.${k + 1}, ${k} s`, passes: k, time: k, gradient: (k + 1) / 10, cell: [[0.01, 0, 0], [0.002, 0.01, 0], [0, 0, 0.01]],
      place: packed("u16", Uint16Array, row.flatMap((a) => [Math.round(65535 * (a - Math.floor(a))), 32768, 32768])), period: packed("i16", Int16Array, row.flatMap((a) => [Math.floor(a), 0, 0])), coordination: all("u8", Uint8Array, 0),
      contacts: { ends: packed("u32", Uint32Array, []), period: packed("u8", Uint8Array, []), normal_force: packed("f32", Float32Array, []) },
    })),
    ...more,
  });
}

test("in a migration, grains are there from the state in which they came until they leave", () => {
  const scene = migration(Array(4).fill([0, 0, 0, 0]), { left_in: packed("u16", Uint16Array, [0, 2, 0, 3]), entered_in: packed("u16", Uint16Array, [0, 0, 1, 2]) });
  assert.deepEqual(scene.states.map(({ present }) => [...present]), [[1, 1, 0, 0], [1, 1, 1, 0], [1, 0, 1, 1], [1, 0, 1, 0]]);
  assert.ok(scene.isMigration);
  assert.equal(scene.states[3].gradient, 0.4);
});

test("in a migration, grains are colored by fate, and classes without grains are left out", () => {
  const fates = ["coarse", "stayed", "lodged elsewhere", "moving at the end", "left", "held: carries the skeleton"];
  const scene = migration([[0, 0, 0, 0], [0, 0, 0, 0]], { left_in: packed("u16", Uint16Array, [0, 1, 1, 0]), fate: packed("u8", Uint8Array, [1, 4, 4, 3]), fates });
  const modes = colorModes(scene);
  assert.equal(modes.pass, undefined, "a migration has no passes");
  assert.equal(modes.fate.label, "where it ends");
  const { swatches } = modes.fate.legend(scene.states[0], [0, 1, 2, 3]);
  assert.deepEqual(swatches.map(({ name, count }) => [name, count]), [["stayed", 1], ["moving at the end", 1], ["left", 2]]);
  const all = migration([Array(6).fill(0)], { fate: packed("u8", Uint8Array, [0, 1, 2, 3, 4, 5]), fates });
  assert.equal(new Set([...all.id].map((row) => colorModes(all).fate.color(all.states[0], row).join())).size, 6);
});

test("paths cross periodic faces as the grain did, and leave out grains that moved too little", () => {
  const scene = migration(
    [[0.8, 0.5, 0.5, 0.5], [1.1, 0.55, 0.5, 0.7], [1.4, 0.5, 0.55, 0.9]],
    { left_in: packed("u16", Uint16Array, [0, 0, 0, 2]) },
  );
  const near = (found, expected) => found.forEach((value, k) => assert.ok(Math.abs(value - expected[k]) < 1e-3, `${found}, not ${expected}`)); // steps of the columns
  // The first segment ends outside the cell, 3 mm on; the second begins inside.
  near(pathOf(scene, 0, 2).ends, [9, 5, 5, 12, 5, 5, 2, 5, 5, 5, 5, 5]);
  near([0, 1, 2, 3].map((row) => pathOf(scene, row, 2).length), [6, 1, 0.5, 2]); // the last is gone in state 2
  const far = migration([[0.8, 0.2, 0.5, 0.5], [2.5, -0.9, 1.5, 0.5]]); // more than half a cell between two states
  near([0, 1, 2, 3].map((row) => pathOf(far, row, 1).length), [17, 11, 10, 0]);
  assert.deepEqual(pathOf(scene, 2, 1), { row: 2, ends: [], length: 0 }, "it did not move");
  assert.deepEqual(pathsShown(scene, 2, -1).map(({ row }) => row), [0, 3]);
  assert.deepEqual(pathsShown(scene, 0, -1), []);
  assert.deepEqual(pathsShown(scene, 2, 2).map(({ row, ends }) => [row, ends.length]), [[2, 6]], "the chosen grain alone");
});

test("a migration is played, shows its paths, and says on the card where a grain went", async () => {
  const { page, context, complaints } = await open(browser, "migration");
  await page.waitForFunction(() => document.querySelector("[data-scene]").view);
  const look = (read) => page.evaluate(`(({ view }) => ${read})(document.querySelector("[data-scene]"))`);
  assert.deepEqual(await look("Object.keys(view.modes)"), ["class", "activity", "coordination", "fate"]);
  assert.match(await page.textContent(".overlay .water >> nth=-1"), /water, i = 0.2$/);
  const play = page.locator('[data-control="play"]');
  await play.focus();
  await page.keyboard.press("Enter");
  assert.equal(await play.getAttribute("aria-label"), "Pause");
  await page.waitForFunction(() => document.querySelector('[data-control="play"]').textContent === "Play");
  assert.equal(await look("view.choice.state"), 3, "it stops at the last state");
  assert.equal(await page.getAttribute('[data-control="state"]', "aria-valuetext"), "i = 0.4, 1.5 s");
  await settled(page);
  assert.match(await page.textContent(".overlay .water >> nth=-1"), /water, i = 0.4$/);
  await page.keyboard.press("Enter");
  await page.keyboard.press("Enter");
  assert.equal(await play.textContent(), "Play");
  const paused = await look("view.choice.state"); // 0, or 1 on a slow machine
  await page.waitForTimeout(1000);
  assert.equal(await look("view.choice.state"), paused, "nothing moves while paused");
  await choose({ state: 3 }, page);
  await choose({ mode: "fate" }, page);
  const without = await pixels(page);
  await drawnAfter(page, () => page.locator('[data-control="paths"]').check());
  // Two channels lodge elsewhere, two move to the end, two fines leave and two come in: all by more than a radius.
  assert.match(await page.textContent(".stage [role=status]"), /^20 paths shown, of fines/);
  assert.notEqual((await pixels(page)).print, without.print);
  await page.locator(".view3d").screenshot({ path: join(samples, "scene-migration.png") });
  const [left, entered] = await look("[view.scene.leftIn.findIndex((k) => k > 0), view.scene.enteredIn.findIndex((k) => k > 0)]");
  await choose({ chosen: left }, page);
  assert.match(await page.textContent(".card"), /leavesleft before i = 0\.4, 1 s/);
  assert.match(await page.textContent(".card"), /fateleftway so far3\.75 diameters/); // 0.75 mm of 0.2 mm
  assert.match(await page.textContent(".stage [role=status]"), /^1 path shown, of the chosen grain/);
  await choose({ chosen: entered }, page);
  assert.match(await page.textContent(".card"), /entersbefore i = 0\.4, 1 s/);
  await choose({ chosen: 0 }, page);
  assert.match(await page.textContent(".card"), /leavesno, it staysfatecoarse/);
  assert.deepEqual(complaints, []);
  await context.close();
});

test("states before the one that was probed show ahead which gradient moves each grain", () => {
  const contacts = { ends: packed("u32", Uint32Array, []), period: packed("u8", Uint8Array, []), normal_force: packed("f32", Float32Array, []) };
  const state = (label, more) => ({
    label, passes: 0, cell: [[1, 0, 0], [0, 1, 0], [0, 0, 1]], contacts, ...more,
    place: packed("u16", Uint16Array, [0, 0, 0, 9, 9, 9]), coordination: packed("u8", Uint8Array, [0, 0]),
  });
  const scene = readScene({
    id: packed("u32", Uint32Array, [1, 2]), radius: packed("f32", Float32Array, [1, 1]), fine: packed("u8", Uint8Array, [1, 1]), left_in: packed("u8", Uint8Array, [0, 0]),
    states: [state("loose"), state("probed", { mobile_gradient: packed("f32", Float32Array, [0.25, NaN]) }), state("after")],
  });
  assert.deepEqual(scene.states.map((each) => each.mobileGradient && [...each.mobileGradient]), [[0.25, NaN], [0.25, NaN], null]);
});
