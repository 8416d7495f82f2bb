// The soil of one tab of the browser, which keeps it over a reload: its file and its filter, and what the form says.
import { $ } from "./words.js";

const most = 1 << 20; // [B] of a file; browsers keep about 5 MB
const filledLater = ["table", "sample", "filter-sample"];
const fields = () => [...$("soil-form").elements].filter((e) => e.id && !["file", "button"].includes(e.type) && !filledLater.includes(e.id));

function keep(key, value) {
  try {
    if (value) sessionStorage.setItem(key, JSON.stringify(value));
    else sessionStorage.removeItem(key);
  } catch {
    sessionStorage.removeItem(key); // there is no room
  }
}

function kept(key) {
  try {
    return JSON.parse(sessionStorage.getItem(key));
  } catch {
    return null;
  }
}

/** @param key "soil" or "filter" @param file { name, blob }; what is empty or too long is forgotten */
export async function keepFile(key, { name, blob }) {
  const hasRoom = blob?.size > 0 && blob.size <= most, bytes = hasRoom ? new Uint8Array(await blob.arrayBuffer()) : [];
  keep(key, hasRoom ? { name, text: Array.from(bytes, (byte) => String.fromCharCode(byte)).join("") } : null);
}

/** @return a File, or nothing */
export function keptFile(key) {
  const file = kept(key);
  return file && new File([Uint8Array.from(file.text, (letter) => letter.charCodeAt(0))], file.name);
}

/** The fields, and more that the caller will want again. */
export const keepForm = (more) => keep("form", { ...more, fields: Object.fromEntries(fields().map((field) => [field.id, field.value])) });

/** Fills the fields in. @return what else was kept */
export function restoreForm() {
  const { fields: values = {}, ...more } = kept("form") ?? {};
  for (const field of fields()) field.value = values[field.id] ?? field.value;
  return more;
}
