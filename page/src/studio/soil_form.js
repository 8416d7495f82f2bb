// The soil of the tab Soil, and what its form says of it: what the tabs start from, as fields for the server.
import { $, numberIn } from "./words.js";
import { tableOf } from "./table_text.js";

/** The soil as given, and as edited; `edits` are those of a curve that is still to be read. */
export const soil = { name: "", blob: null, text: "", samples: [], which: 0, curve: null, edits: null, found: null, filter: null, sizes: null };

/** Of the form, how the file is read. */
export const readingIds = ["size-column", "size-unit", "amount-column", "amount-kind", "by", "sheet", "rows"];

/** The words of the form that say how the file is read. The program wants to know both columns or none: what is left open is as it was found. */
export function readingFields() {
  const [column, unit, amount, kind] = ["size-column", "size-unit", "amount-column", "amount-kind"].map((id) => $(id).value), fields = {};
  if (column || unit || amount || kind) {
    const found = soil.samples[soil.which]?.reading ?? {};
    fields.size = (column || found.size || "1") + (unit ? `:${unit}` : "");
    fields[kind || found.flag || "passing"] = amount || found.share || "2";
  }
  return { ...fields, by: $("by").value, sheet: $("sheet").value, rows: $("rows").value };
}

/** The curve and how it is read: the file as given, or the points where they were edited. */
export function curveFields() {
  if (soil.curve.isEdited) {
    return { curve: { name: `${soil.name.replace(/\.[^.]*$/, "")}-edited.csv`, blob: new Blob([tableOf(soil.curve, 12)]) } };
  }
  const sample = soil.samples.length > 1 ? soil.samples[soil.which].soil : "";
  return { curve: { name: soil.name, blob: soil.blob }, ...readingFields(), sample };
}

const seeps = () => Number(numberIn("gradient-number")) > 0;
export const withUnit = (id, unit) => (numberIn(id) ? numberIn(id) + unit : "");

/** Its filter: of a table with several soils one of them. */
export const filterFields = () => (soil.filter ? { filter: soil.filter, "filter-sample": soil.filter.samples.length > 1 ? $("filter-sample").value : "" } : {});

export const filterName = () => [soil.filter?.name, filterFields()["filter-sample"]].filter(Boolean).join(", ");

/** What the soil is under, as `assess` and `new` call it. @throws for a field that is no number */
export const conditionFields = () => ({
  gradient: seeps() ? numberIn("gradient-number") : "", flow: seeps() ? $("flow").value : "", fines: withUnit("fines", "mm"),
});

/** What only counts where water seeps. */
export const seepageFields = () => (seeps() ? { alpha: numberIn("alpha"), porosity: numberIn("porosity"), density: withUnit("grain-density", "kg/m^3") } : {});

/** Fields that are given and count for nothing without a gradient. */
export function showIgnored() {
  const given = [["porosity", "porosity"], ["grain-density", "density of the grains"], ["alpha", "α"]].filter(([id]) => $(id).value.trim()).map(([, name]) => name);
  $("ignored").textContent = given.length && !Number($("gradient-number").value.replace(",", ".")) ? `Counts only with a gradient: ${given.join(", ")}.` : "";
}
