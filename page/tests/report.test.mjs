import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { copyFileSync, mkdirSync, readFileSync, renameSync, rmSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { csv, files, fromPage, launch, open, patience, samples } from "./browser.mjs";

let browser, sample;

before(async () => {
  browser = await launch();
  sample = await open(browser, "sample");
  console.log(`Chromium ${browser.version()}, playwright-core ${fromPage("playwright-core/package.json").version}`);
});

after(() => browser?.close());

test("opens from file: with no other request and no complaint", async () => {
  assert.equal(sample.requests.length, 1);
  assert.match(sample.requests[0], /^file:/);
  assert.deepEqual(sample.complaints, []);
  assert.equal(await sample.page.locator("#no-script").count(), 0);
});

test("its content policy forbids what it does not bring along", async () => {
  const policy = await sample.page.getAttribute("meta[http-equiv=Content-Security-Policy]", "content");
  assert.match(policy, /default-src 'none'/);
  assert.doesNotMatch(policy, /unsafe-eval|https?:|\*/);
  // The policy is at work: a script that the page does not carry is refused.
  const ran = await sample.page.evaluate(() => {
    const script = document.createElement("script");
    script.textContent = "window.intruder = 1";
    document.body.append(script);
    return window.intruder === 1;
  });
  assert.equal(ran, false);
});

test("each figure is drawn, with titled axes and marks", async () => {
  const charts = files("sample", ".vl.json").map((name) => name.replace(".vl.json", ""));
  const drawings = files("sample", ".svg").map((name) => name.replace(".svg", ""));
  for (let number = 1; number <= 14; ++number) {
    const id = `fig${String(number).padStart(2, "0")}`;
    assert.ok(charts.includes(id) || drawings.includes(id), `${id} is there`);
  }
  assert.ok(charts.filter((id) => id.startsWith("own-")).length >= 5);
  for (const id of charts) {
    const seen = await sample.page.$eval(`[data-chart="${id}"]`, (place) => ({
      axes: [...place.querySelectorAll(".role-axis-title text")].map((text) => text.textContent),
      marks: place.querySelectorAll(".role-mark path[d], .role-mark line").length,
      label: place.querySelector("svg").getAttribute("aria-labelledby"),
      box: place.querySelector("svg").getBoundingClientRect().toJSON(),
    }));
    assert.ok(seen.axes.length >= 2, `${id} has ${seen.axes.length} titled axes`);
    for (const title of seen.axes) assert.match(title, /\[.+\]$/, `${id}: "${title}" says no unit`);
    assert.ok(seen.marks >= 1, `${id} has no marks`);
    assert.equal(seen.label, `${id}-title`);
    assert.ok(seen.box.width > 200 && seen.box.height > 100, `${id} is ${seen.box.width} x ${seen.box.height}`);
  }
});

/** A number as the page writes it: "−1.37 × 10⁻⁵". */
function read(shown) {
  const [, leading, power] = /^([^×]*?)(?:\u00a0×\u00a010([⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+))?$/.exec(shown) ?? [];
  const exponent = [...(power ?? "")].map((c) => (c === "⁻" ? "-" : "⁰¹²³⁴⁵⁶⁷⁸⁹".indexOf(c))).join("");
  return Number((leading ?? "").replace("−", "-") + (exponent ? `e${exponent}` : ""));
}

test("the numbers behind a chart and in its table are those of its CSV file", async () => {
  for (const name of files("sample", ".csv")) {
    const id = name.replace(".csv", "");
    const { header, rows } = csv("sample", id);
    const page = await sample.page.$eval(`[data-figure="${id}"]`, (figure) => ({
      chart: figure.querySelector(".chart")?.chart.rows ?? null,
      header: [...figure.querySelectorAll("table.numbers th")].map((cell) => cell.textContent),
      rows: [...figure.querySelectorAll("table.numbers tbody tr")].map((row) =>
        [...row.children].map((cell) => cell.textContent),
      ),
    }));
    assert.deepEqual(page.header, header, id);
    assert.equal(page.rows.length, Math.min(60, rows.length), id);
    const same = (shown, exact) =>
      shown.replace("\u00a0×\u00a010", "·10") === exact.replace(/\b(e|FC)_(?=[a-z]+\b)/, "$1") || // an index set low
      Math.abs(read(shown) - Number(exact)) <= 5.1e-6 * Math.abs(Number(exact)); // six digits
    page.rows.forEach((row, r) =>
      row.forEach((cell, c) => assert.ok(same(cell, rows[r][c]), `${id}: ${cell} for ${rows[r][c]}`)),
    );
    if (!page.chart) continue;
    assert.equal(page.chart.length, rows.length, id);
    page.chart.forEach((row, r) =>
      Object.values(row).forEach((value, c) => assert.equal(value === null ? "" : value, typeof value === "number" ? Number(rows[r][c]) : rows[r][c], id)),
    );
  }
});

test("ticks of the logarithmic speed axis stand at equal steps for equal powers of ten", async () => {
  const ticks = await sample.page.$eval('[data-chart="fig09"]', (place) => {
    const axis = [...place.querySelectorAll(".role-axis")].find((each) => /speed/.test(each.textContent));
    return [...axis.querySelectorAll(".role-axis-label text")].map((text) => ({
      label: text.textContent,
      y: Number(/translate\([^,]+,([^)]+)\)/.exec(text.getAttribute("transform"))[1]),
    }));
  });
  const digits = "⁰¹²³⁴⁵⁶⁷⁸⁹";
  const exponent = (label) => Number([...label.slice(2)].map((c) => (c === "⁻" ? "-" : digits.indexOf(c))).join(""));
  assert.ok(ticks.length >= 3);
  const slopes = ticks.slice(1).map((tick, k) => (tick.y - ticks[k].y) / (exponent(tick.label) - exponent(ticks[k].label)));
  for (const slope of slopes) assert.ok(Math.abs(slope - slopes[0]) < 1.5 / 2, `${slopes}`); // labels sit on half pixels
  assert.ok(slopes[0] < 0, "greater speeds stand higher");
});

test("every drawing has a title and a description that say something", async () => {
  const words = await sample.page.$$eval(".chart svg, .drawing svg", (all) =>
    all.map((svg) => {
      const named = (attribute, tag) =>
        (svg.getAttribute(attribute) ?? "").split(" ").map((id) => document.getElementById(id)?.textContent ?? "").join(" ") +
        (svg.querySelector(`:scope > ${tag}`)?.textContent ?? "");
      return { title: named("aria-labelledby", "title"), description: named("aria-describedby", "desc") };
    }),
  );
  assert.ok(words.length >= 20);
  for (const { title, description } of words) {
    assert.ok(title.trim().length > 5, title);
    assert.ok(description.trim().length > 15, description);
  }
});

test("headings follow each other without a gap, and all controls are reached by keyboard", async () => {
  const levels = await sample.page.$$eval("h1,h2,h3,h4", (all) => all.map((heading) => Number(heading.tagName[1])));
  assert.equal(levels[0], 1);
  levels.slice(1).forEach((level, k) => assert.ok(level <= levels[k] + 1, `h${levels[k]} is followed by h${level}`));
  const { page } = sample;
  const everything = "a[href], button, summary, input, select, [tabindex='0']";
  const controls = await page.$$eval(everything, (all) => all.filter((each) => each.checkVisibility()).length);
  const reached = new Set();
  for (let k = 0; k < 3 * controls; ++k) {
    await page.keyboard.press("Tab");
    const now = await page.evaluate((which) => {
      const element = document.activeElement;
      const all = [...document.querySelectorAll(which)].filter((each) => each.checkVisibility());
      return { index: all.indexOf(element), outline: getComputedStyle(element).outlineStyle };
    }, everything);
    if (now.index < 0) continue;
    assert.notEqual(now.outline, "none", "focus is seen");
    reached.add(now.index);
    if (reached.size === controls) break;
  }
  assert.equal(reached.size, controls);
});

test("indices of symbols are set low in charts, tables and captions", async () => {
  const words = await sample.page.$eval('[data-figure="fig03"]', (figure) => ({
    low: [...figure.querySelectorAll(".chart tspan[font-size]")].map((part) => part.textContent),
    raw: [...figure.querySelectorAll(".chart text, figcaption, td")].filter((part) => /\b(e|FC)_/.test(part.textContent)).length,
    caption: [...figure.querySelectorAll("figcaption sub")].map((part) => part.textContent),
  }));
  for (const index of ["min", "g", "eq", "threshold"]) assert.ok(words.low.includes(index), index);
  assert.ok(words.caption.includes("min"));
  assert.equal(words.raw, 0);
});

test("the answer is in one look: verdict, confidence, cards and the deciding picture begin in the first screen", async () => {
  const { page, context } = await open(browser, "sample", { viewport: { width: 1440, height: 900 } });
  for (const part of [".verdict", ".conf", ".cards", ".g .figure"]) {
    const box = await page.locator(`#answer ${part}`).first().boundingBox();
    assert.ok(box.y < 700, `${part} begins at ${box.y}`);
  }
  const folds = await page.$$eval("#answer details.fold", (all) => all.map((each) => each.open));
  assert.ok(folds.length >= 2 && folds.every((open) => !open), "the rest is folded");
  const caution = page.locator(".cards .w");
  assert.match(await caution.textContent(), /▲/);
  const card = await page.locator(".cards .item").nth(1).boundingBox(), warned = await caution.boundingBox();
  assert.ok(warned.x >= card.x - 1 && warned.y > card.y && warned.y < card.y + card.height, "it stands at its number");
  await page.screenshot({ path: join(samples, "first-screen.png") });
  await context.close();
});

test("on a phone the cards are rows, and the numbers stand at the right edge", async () => {
  const { page, context } = await open(browser, "sample", { viewport: { width: 390, height: 844 } });
  const cards = await page.$$eval(".cards .item", (all) =>
    all.map((card) => ({ card: card.getBoundingClientRect(), value: card.querySelector(".v").getBoundingClientRect() })),
  );
  for (const { card, value } of cards) {
    assert.ok(card.width > 340 && Math.abs(value.right - card.right) < 2, `${value.right} of ${card.right}`);
  }
  await context.close();
});

test("figures and tables are numbered in the order of the page, and the works that it names are listed", async () => {
  const numbers = (kind, selector) =>
    sample.page.$$eval(selector, (all, name) => all.map((each) => each.textContent).filter((text) => text.startsWith(name)), kind);
  for (const [kind, selector] of [["Figure", "figcaption > b"], ["Table", "caption > b"]]) {
    const found = (await numbers(kind, selector)).map((text) => Number(/\d+/.exec(text)[0]));
    assert.deepEqual(found, found.map((_, k) => k + 1));
  }
});

test("Node draws every chart for the page, on the page's own ground and no wider than its column", async () => {
  const folder = join(samples, "in-page");
  rmSync(folder, { recursive: true, force: true });
  mkdirSync(folder);
  const names = files("sample", ".vl.json"), labels = [];
  const specifications = names.map((name) => join(samples, "sample", "figures", name));
  execFileSync("node", [join(process.env.SUFFUSE_PAGE, "figures.mjs"), "--in-page", folder, ...specifications]);
  for (const name of names) {
    const svg = readFileSync(join(folder, name.replace(".vl.json", ".svg")), "utf8");
    const [, width] = /viewBox="0 0 ([\d.]+)/.exec(svg).map(Number);
    assert.ok(width <= 680, `${name} is ${width} wide`);
    assert.doesNotMatch(svg, /fill="white"/);
    assert.doesNotMatch(svg.replace(/>[^<]*</g, "><"), /\d\.\d{3}/, `${name} carries digits that nobody sees`);
    labels.push(...[...svg.matchAll(/>([^<]+)<\/text>/g)].map((found) => found[1]));
  }
  assert.ok(labels.some((label) => /^\d\.\d\d$/.test(label)), "labels keep their digits");
  execFileSync("node", [join(process.env.SUFFUSE_PAGE, "figures.mjs"), "--width=321.26", "--font=Times", folder, specifications[0]]);
  const narrow = readFileSync(join(folder, names[0].replace(".vl.json", ".svg")), "utf8");
  assert.match(narrow, /^<svg[^>]* width="321.26"/);
  assert.match(narrow, /Times/);
});

test("printed, it begins with a title page whose contents lead to the sections", async () => {
  const { page, context } = await open(browser, "sample");
  assert.ok(!(await page.locator(".cover").isVisible()));
  await page.emulateMedia({ media: "print" });
  assert.ok(await page.locator(".cover .big").isVisible());
  const targets = await page.$$eval(".cover .toc a", (all) => all.map((each) => each.getAttribute("href")));
  assert.ok(targets.length >= 5);
  for (const target of targets) assert.equal(await page.locator(target).count(), 1, target);
  assert.ok(!(await page.locator("header.top").isVisible()));
  assert.ok(await page.locator("#answer details.fold p, #answer details.fold li").first().isVisible(), "folds are open on paper");
  await context.close();
});

test("figures can be saved as SVG, PNG and CSV", async () => {
  const { page } = sample;
  async function saved(id, kind) {
    const [download] = await Promise.all([
      page.waitForEvent("download"),
      page.click(`[data-figure="${id}"] button:text-is("${kind}")`),
    ]);
    assert.equal(download.suggestedFilename(), `synthetic-0001-${id}.${kind.toLowerCase()}`);
    return readFileSync(await download.path());
  }
  for (const id of ["fig07", "fig08", "fig13"]) {
    const svg = (await saved(id, "SVG")).toString();
    const parsed = await page.evaluate((text) => {
      const root = new DOMParser().parseFromString(text, "image/svg+xml");
      const size = root.documentElement.viewBox.baseVal;
      return {
        ok: !root.querySelector("parsererror"),
        title: root.querySelector("title")?.textContent,
        desc: root.querySelector("desc")?.textContent,
        width: size.width,
        height: size.height,
      };
    }, svg);
    assert.ok(parsed.ok && parsed.title.length > 5 && parsed.desc.length > 5, id);
    const png = await saved(id, "PNG");
    assert.equal(png.subarray(1, 4).toString(), "PNG");
    assert.ok(Math.abs(png.readUInt32BE(16) - 3 * parsed.width) <= 3, `${id}: ${png.readUInt32BE(16)} pixels wide`);
    assert.ok(Math.abs(png.readUInt32BE(20) - 3 * parsed.height) <= 3);
    assert.equal((await saved(id, "CSV")).toString(), readFileSync(join(samples, "sample", "figures", `${id}.csv`), "utf8"));
  }
});

test("a hostile title stays text", async () => {
  const { page, complaints, requests, context } = await open(browser, "hostile");
  assert.equal(await page.title(), "</script><img src=x onerror=\"document.title='broken'\">");
  assert.equal(await page.textContent("h1"), "</script><img src=x onerror=\"document.title='broken'\">");
  assert.equal(await page.locator("img:not(.still img)").count(), 0);
  assert.deepEqual(complaints, []);
  assert.equal(requests.length, 1);
  await context.close();
});

test("without JavaScript the answer and the tables are there, and why the charts are not", async () => {
  const { page, context } = await open(browser, "sample", { javaScriptEnabled: false });
  assert.match(await page.textContent("#answer"), /void ratio/);
  assert.equal(await page.locator("table.findings tbody tr").count(), 7);
  await page.getByText("The charts are drawn by JavaScript").waitFor({ state: "visible" });
  await page.locator('[data-figure="fig11"] summary').click();
  assert.ok(await page.locator('[data-figure="fig11"] table.numbers').isVisible());
  assert.ok(await page.locator('[data-figure="fig07"] svg').isVisible());
  assert.equal(await page.getAttribute('[data-figure="fig11"] .tools a', "href"), "figures/fig11.csv");
  await context.close();
});

test("the plain report has everything but the charts, and says how to get them", async () => {
  const { page, complaints, requests, context } = await open(browser, "plain");
  assert.ok(await page.getByText("This report is plain").isVisible());
  assert.equal(await page.locator("script").count(), 0);
  assert.equal(await page.locator("figure.figure").count(), 23);
  assert.equal(await page.locator("table.findings tbody tr").count(), 7);
  assert.deepEqual(complaints, []);
  assert.equal(requests.length, 1);
  await page.screenshot({ path: join(samples, "plain.png"), fullPage: true });
  await context.close();
});

test("a run that is not complete says so on the first screen, with what is missing and how to go on", async () => {
  const { page, context } = await open(browser, "plain");
  const banner = page.locator("#unfinished"), box = await banner.boundingBox();
  assert.ok(box.y > 0 && box.y + box.height < page.viewportSize().height / 2, `from ${box.y}, ${box.height} high`);
  assert.match(await banner.textContent(), /not complete\.\s2\sof\s9\sstages\sare\smissing:\serosion\/erosion/);
  assert.equal(await banner.locator("code").textContent(), "suffuse resume runs/x-0001");
  await page.getByRole("link", { name: "Quality" }).last().click();
  assert.ok(await page.getByText("W602: a narrow cell").isVisible());
  await context.close();
  const whole = await open(browser, "sample");
  assert.equal(await whole.page.locator("#unfinished").count(), 0);
  await whole.context.close();
});

test("the live page loads itself anew, without script or server, and ends in the report", async () => {
  const folder = join(samples, "ends");
  rmSync(folder, { recursive: true, force: true });
  mkdirSync(folder);
  const put = (run) => {
    copyFileSync(join(samples, run, "report.html"), join(folder, "part"));
    renameSync(join(folder, "part"), join(folder, "report.html"));
  };
  put("live");
  const { page, complaints, requests, context } = await open(browser, "ends", { javaScriptEnabled: false });
  assert.match(await page.textContent("h1"), /<\/script><img/);
  await page.getByText("1 of 3 stages, 1.0-2 min left").waitFor(); // while it loads anew, it is not there
  assert.equal(await page.locator("script, img").count(), 0);
  await page.screenshot({ path: join(samples, "live.png"), fullPage: true });
  await page.waitForEvent("load"); // by itself
  await page.getByText("1 of 3 stages").waitFor();
  put("sample");
  await page.locator("#answer").waitFor();
  assert.equal(await page.locator("progress").count(), 0);
  assert.deepEqual(complaints, []);
  assert.ok(requests.length >= 3 && requests.every((url) => url.startsWith("file:") && url.endsWith("/ends/report.html")));
  await context.close();
});

for (const width of [375, 1024, 1920]) {
  for (const colorScheme of ["light", "dark"]) {
    test(`${width} pixels wide, ${colorScheme}: nothing overflows sideways and text can be read`, async () => {
      const { page, context } = await open(browser, "sample", { viewport: { width, height: 900 }, colorScheme });
      assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), width);
      const clipped = await page.$$eval(".chart svg, .drawing svg", (all) =>
        all.filter((svg) => svg.getBoundingClientRect().right > innerWidth).length,
      );
      assert.equal(clipped, 0);
      assert.deepEqual(await page.evaluate(paleTexts), []);
      await page.screenshot({ path: join(samples, `${width}-${colorScheme}.png`), fullPage: true, timeout: patience });
      await context.close();
    });
  }
}

/** Texts whose contrast with what lies behind them is below 4.5. Runs in the page. */
function paleTexts() {
  const channels = (color) => /rgba?\(([^)]+)\)/.exec(color)[1].split(/[ ,/]+/).map(Number);
  const luminance = ([r, g, b]) => {
    const linear = [r, g, b].map((c) => (c / 255 <= 0.04045 ? c / 255 / 12.92 : ((c / 255 + 0.055) / 1.055) ** 2.4));
    return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2];
  };
  const behind = (element) => {
    for (let e = element; e; e = e.parentElement) {
      const color = channels(getComputedStyle(e).backgroundColor);
      if (color.length === 3 || color[3] > 0.5) return color;
    }
    return [255, 255, 255];
  };
  const pale = [];
  for (const element of document.querySelectorAll("p, li, td, th, dt, dd, a, button, summary, h1, h2, h3, figcaption, svg text")) {
    const style = getComputedStyle(element);
    if (!element.textContent.trim() || style.opacity === "0") continue;
    const ink = luminance(channels(element.namespaceURI.endsWith("svg") ? style.fill : style.color));
    const paper = luminance(behind(element));
    const contrast = (Math.max(ink, paper) + 0.05) / (Math.min(ink, paper) + 0.05);
    if (contrast < 4.5) pale.push(`${contrast.toFixed(2)} ${element.textContent.slice(0, 30)}`);
  }
  return pale;
}

test("a narrower window draws the charts again to fit", async () => {
  const { page, context } = await open(browser, "sample");
  const wide = await page.locator('[data-chart="fig13"] svg').boundingBox();
  await page.setViewportSize({ width: 420, height: 900 });
  await page.waitForFunction(
    (before) => document.querySelector('[data-chart="fig13"] svg').getBoundingClientRect().width < before - 100,
    wide.width,
  );
  assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), 420);
  await context.close();
});

test("printed, it fits on a reasonable number of white pages", async () => {
  const { page, context } = await open(browser, "sample", { colorScheme: "dark" });
  await page.emulateMedia({ media: "print", colorScheme: "dark" });
  assert.equal(await page.evaluate(() => getComputedStyle(document.body).backgroundColor), "rgb(255, 255, 255)");
  assert.deepEqual(await page.evaluate(paleTexts), []);
  const pdf = await page.pdf({ format: "A4", path: join(samples, "report.pdf") });
  const pages = pdf.toString("latin1").match(/\/Type\s*\/Page\b(?!s)/g).length;
  assert.ok(pages >= 7 && pages <= 22, `${pages} pages`);
  // As wide as the paper between its margins: no figure is clipped, and each fits on a page.
  const inside = { width: Math.floor(((210 - 30) / 25.4) * 96), height: Math.floor(((297 - 32) / 25.4) * 96) };
  await page.setViewportSize({ width: inside.width, height: inside.height });
  const boxes = await page.$$eval("figure.figure, .still", (all) =>
    all.map((each) => ({ id: each.id, right: each.getBoundingClientRect().right, height: each.getBoundingClientRect().height })),
  );
  for (const box of boxes) {
    assert.ok(box.right <= inside.width + 1, `${box.id} ends at ${box.right} of ${inside.width}`);
    assert.ok(box.height <= inside.height, `${box.id} is ${box.height} high, the page ${inside.height}`);
  }
  await context.close();
});

test("the file stays small, and its charts come one by one before the view in 3D", async () => {
  const { size } = await import("node:fs").then((fs) => fs.statSync(join(samples, "sample", "report.html")));
  assert.ok(size < 3e6, `${size} bytes`);
  // No clock: what is asserted is that the first chart is there before the next is begun, and that the page is free in
  // between, so that a reader sees it as soon as the machine can.
  const context = await browser.newContext();
  context.setDefaultTimeout(patience);
  const page = await context.newPage();
  await page.addInitScript(() => {
    window.seen = [];
    let turns = 0;
    const channel = new MessageChannel(); // a turn of the event loop each: everything else that waits has had its turn
    channel.port1.onmessage = () => {
      ++turns;
      if (!document.documentElement?.dataset.drawn) channel.port2.postMessage(0);
    };
    channel.port2.postMessage(0);
    new MutationObserver((changes) => {
      for (const { addedNodes } of changes) {
        for (const node of addedNodes) {
          const chart = node.tagName === "svg" ? node.closest?.("[data-chart]")?.dataset.chart : undefined;
          if (chart || node.tagName === "CANVAS") seen.push({ what: chart ?? "3d", turns });
        }
      }
    }).observe(document, { childList: true, subtree: true });
  });
  await page.goto(`file://${join(samples, "sample", "report.html")}`);
  await page.waitForFunction(() => document.documentElement.dataset.drawn === "all");
  const seen = await page.evaluate(() => window.seen);
  const charts = [...new Set(seen.map((each) => each.what))];
  assert.equal(charts.at(-1), "3d", `${charts}`);
  assert.equal(charts.length, files("sample", ".vl.json").length + 1);
  charts.slice(1).forEach((name, k) => {
    const [first, next] = [charts[k], name].map((which) => seen.find((each) => each.what === which).turns);
    assert.ok(next > first, `${name} came in the same turn as ${charts[k]}`);
  });
  await context.close();
});

test("a reversed grading axis runs from large to small, in equal steps for equal ratios", async () => {
  const vega = await import(fromPage.resolve("vega"));
  const lite = await import(fromPage.resolve("vega-lite"));
  const specification = JSON.parse(readFileSync(join(samples, "sample", "figures", "fig08.vl.json"), "utf8"));
  const placed = async (reverse) => {
    specification.encoding.x.scale.reverse = reverse;
    const view = await new vega.View(vega.parse(lite.compile(specification).spec), { renderer: "none" }).runAsync();
    const scale = view.scale("x");
    const at = [0.1, 0.2, 0.4].map((size) => scale(size));
    view.finalize();
    return at;
  };
  const [usual, turned] = [await placed(false), await placed(true)];
  assert.ok(usual[0] < usual[1] && usual[1] < usual[2]);
  assert.ok(turned[0] > turned[1] && turned[1] > turned[2]);
  for (const at of [usual, turned]) assert.ok(Math.abs(at[2] - at[1] - (at[1] - at[0])) < 1e-6, `${at}`);
});

test("the specification files draw in Node as they are", async () => {
  const vega = await import(fromPage.resolve("vega"));
  const lite = await import(fromPage.resolve("vega-lite"));
  for (const name of files("sample", ".vl.json")) {
    const specification = JSON.parse(readFileSync(join(samples, "sample", "figures", name), "utf8"));
    const view = new vega.View(vega.parse(lite.compile(specification).spec), { renderer: "none" });
    const svg = await view.toSVG();
    assert.match(svg, /^<svg/, name);
    assert.ok(svg.length > 3000, name);
    view.finalize();
  }
});
