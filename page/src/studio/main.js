// The page of `suffuse studio`: four tabs, named in the address after #.
import { $, trouble } from "./words.js";
import { connectSoil } from "./soil.js";
import { connectSimulate, openSimulate } from "./simulate.js";
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

connectSoil();
connectSimulate();
connectRuns();
connectSweep();
window.addEventListener("hashchange", open);
open();
document.documentElement.dataset.ready = "yes";
