// Texts of figures that are drawn without a browser: as wide as a browser draws them.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { launch } from "./browser.mjs";
import { textWidth } from "../src/text_width.js";

let browser, page;

before(async () => {
  browser = await launch();
  page = await browser.newPage();
});

after(() => browser?.close());

const texts = [
  "share of the grains removed in the pass [%]",
  "constant volume",
  "hydraulic gradient i [-]",
  "1,234.5",
  "Kenney and Lau 1985",
  "FC = 20 %, e = 0.67",
  "μm and ρ, ε and σ₃",
  "WMM illl",
];

// What a figure asks for, and a font of these widths that the package lists bring: Helvetica itself is on few machines.
const fonts = { "Helvetica, Arial": "Liberation Sans", "DejaVu Sans": "DejaVu Sans" };

/** Widths of texts as the browser draws them; null where it does not have the font. */
function drawnIn(family, all) {
  const context = document.createElement("canvas").getContext("2d");
  const widthBefore = (fallback, text) => {
    context.font = `12px "${family}", ${fallback}`;
    return context.measureText(text).width;
  };
  if (widthBefore("monospace", "mil") !== widthBefore("serif", "mil")) return null;
  return all.map((text) => widthBefore("sans-serif", text));
}

test("a text is no narrower than drawn, and at most a quarter wider", async () => {
  for (const [font, family] of Object.entries(fonts)) {
    const drawn = await page.evaluate(`(${drawnIn})(${JSON.stringify(family)}, ${JSON.stringify(texts)})`);
    assert.ok(drawn, `the browser has no ${family}`);
    texts.forEach((text, k) => {
      const width = textWidth({ fontSize: 12, font, text });
      assert.ok(width > 0.99 * drawn[k] && width < 1.25 * drawn[k], `${font}, ${text}: ${width} for ${drawn[k]}`);
    });
  }
});

test("a text with a limit is no wider than that", () => {
  assert.equal(textWidth({ fontSize: 12, limit: 30 }, "a long sentence of many words"), 30);
  assert.equal(textWidth({ fontSize: 12 }, null), 0);
});
