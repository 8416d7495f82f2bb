// The page of `suffuse studio`: three tabs, named in the address after #.
import { $, trouble } from "./words.js";
import { connectSoil } from "./soil.js";
import { connectSimulate, openSimulate } from "./simulate.js";
import { connectRuns, openRuns } from "./runs.js";

const tabs = ["soil", "simulate", "runs"];

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
  if (tab === "runs") openRuns(decodeURIComponent(rest.join("/")));
}

connectSoil();
connectSimulate();
connectRuns();
window.addEventListener("hashchange", open);
open();
document.documentElement.dataset.ready = "yes";
