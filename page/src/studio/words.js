// Elements, numbers and words of the page.
import "../assess/curve.js";

export const { three, mm, rangeText, factor, escaped } = globalThis.CurveChart;
export const $ = (id) => document.getElementById(id);
export const seconds = (s) =>
  s < 1 ? "less than 1 s" : s < 100 ? `${Math.round(s)} s` : s < 5400 ? `${Math.round(s / 60)} min` : s < 172800 ? `${(s / 3600).toPrecision(2)} h` : `${Math.round(s / 86400)} days`;
export const secondsRange = ([least, most]) =>
  (seconds(least) === seconds(most) ? seconds(most) : least < 1 ? `up to ${seconds(most)}` : `${seconds(least)} to ${seconds(most)}`);
export const bytes = (b) => (b < 1e9 ? `${Math.max(1, Math.round(b / 1e6))} MB` : `${(b / 1e9).toPrecision(3)} GB`);
export const list = (texts) => texts.map((text) => `<li>${escaped(text)}</li>`).join("");

const nameOf = (input) => (input.getAttribute("aria-label") ?? input.labels[0].textContent).trim();

/** The number in a field, as the program reads it: with a decimal point, "" where the field is empty. @throws what is wrong with it */
export function numberIn(id) {
  const input = $(id), typed = input.value.trim(), text = typed.replace(",", "."), number = Number(text);
  if (!typed) return "";
  const least = Number(input.getAttribute("min") ?? -Infinity), most = Number(input.getAttribute("max") ?? Infinity);
  const range = Number.isFinite(most) ? `from ${least} to ${most}` : `at least ${least}`;
  if (/^[1-9]\d{0,2},\d{3}$/.test(typed)) throw new Error(`${nameOf(input)}: ${typed} could be ${Number(text)} or ${typed.replace(",", "")}; write it without the comma.`);
  if (!Number.isFinite(number)) throw new Error(`${nameOf(input)}: ${typed} is not a number.`);
  if (number < least || number > most) throw new Error(`${nameOf(input)}: ${typed} is out of range; give a number ${range}.`);
  return text;
}

/** Shows an error at the top of the page until the next success. */
export function trouble(error) {
  $("trouble").hidden = !error;
  $("trouble").textContent = error ? error.message : "";
}
