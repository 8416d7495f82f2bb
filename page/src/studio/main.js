// The page of `suffuse studio`: four tabs, named in the address after #.
import { $, trouble } from "./words.js";
import { connectSoil, takeSoil } from "./soil.js";
import { connectSimulate, openCase, openSimulate } from "./simulate.js";
import { connectRuns, openRuns } from "./runs.js";
import { connectSweep, openSweep } from "./sweep.js";

const tabs = ["soil", "simulate", "runs", "sweep"];

/** A name out of the address, which may have been typed. */
function decoded(text) {
  try {
    return decodeURIComponent(text);
  } catch {
    return text;
  }
}

function open() {
  const [word, ...rest] = location.hash.slice(1).split("/"), tab = tabs.includes(word) ? word : "soil";
  for (const each of tabs) $(each).hidden = each !== tab;
  for (const link of document.querySelectorAll("nav a")) {
    if (link.hash === `#${tab}`) link.setAttribute("aria-current", "page");
    else link.removeAttribute("aria-current");
  }
  trouble();
  window.scrollTo(0, 0); // the address names the tab, and browsers jump to what it names
  if (tab === "simulate") openSimulate();
  const name = decoded(rest.join("/"));
  if (tab === "runs") openRuns(name);
  if (tab === "sweep") openSweep(name);
}

/** What is dropped anywhere: a case with its data, or a grading. */
function takeDropped(files) {
  const isCase = files.some((file) => file.name.endsWith(".toml"));
  if (!isCase && files.length > 1) {
    trouble(new Error("Drop one grading at a time. Its filter has a field of its own."));
    return;
  }
  location.hash = isCase ? "#simulate" : "#soil";
  if (isCase) openCase(files);
  else takeSoil(files[0]);
}

document.addEventListener("dragover", (event) => {
  if (!event.dataTransfer?.types.includes("Files")) return; // text is moved as elsewhere
  event.preventDefault();
  $("drop").classList.add("over");
});
document.addEventListener("dragleave", () => $("drop").classList.remove("over"));
document.addEventListener("drop", (event) => {
  if (!event.dataTransfer?.types.includes("Files")) return;
  event.preventDefault();
  $("drop").classList.remove("over");
  if (event.dataTransfer.files.length) takeDropped([...event.dataTransfer.files]);
});
connectSoil(() => $("simulate").hidden || openSimulate());
connectSimulate();
connectRuns();
connectSweep();
window.addEventListener("hashchange", open);
open();
document.documentElement.dataset.ready = "yes";
