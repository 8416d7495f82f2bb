// Two runs compared: every number that differs, as `suffuse compare` lists them.
import { escaped, list } from "./words.js";
import { get } from "./server.js";

const most = 500;
const number = (text) => (text !== "" && Number.isFinite(Number(text)) ? String(Number(Number(text).toPrecision(4))) : text);

/** @return HTML @throws Refused */
export async function compareRuns(one, other) {
  const { result } = await get(`/api/compare/${encodeURIComponent(one)}/${encodeURIComponent(other)}`);
  const rows = result.differences.slice(0, most);
  const head = `<h2>${escaped(one)} and ${escaped(other)}</h2><ul class="cap">${list(result.circumstances)}</ul>`;
  return rows.length === 0 ? `${head}<p>No number differs.</p>` : `${head}<div class="tw"><table><caption>${result.differences.length} numbers differ${result.differences.length > most ? `; the first ${most}` : ""}.</caption><thead><tr><th>where</th><th class="n">${escaped(one)}</th><th class="n">${escaped(other)}</th><th class="n">difference</th></tr></thead><tbody>${rows.map((d) =>
    `<tr><td class="where">${escaped(d.where ?? "")}</td><td class="n">${escaped(number(String(d.first ?? "")))}</td><td class="n">${escaped(number(String(d.second ?? "")))}</td><td class="n">${typeof d.relative === "number" ? `${Number((100 * d.relative).toPrecision(2))} %` : ""}</td></tr>`).join("")}</tbody></table></div>`;
}
