// The card of the grain that was chosen: what it is, what holds it, what the water does to it, when it leaves.
import { short } from "./colors.js";
import { contactsOf } from "./data.js";
import { pathOf } from "./paths.js";

const shownContacts = 6;

function row(list, name, value) {
  const [term, words] = [document.createElement("dt"), document.createElement("dd")];
  term.textContent = name;
  words.append(value);
  list.append(term, words);
}

/** What a migration did to the grain. */
function addMigration(list, scene, state, grain) {
  const [enters, leaves] = [scene.enteredIn?.[grain] ?? 0, scene.leftIn[grain]];
  const before = (k) => `before ${scene.states[k].label}`;
  if (enters > 0) row(list, "enters", before(enters));
  row(list, "leaves", leaves === 0 ? "no, it stays" : state.passes < leaves ? before(leaves) : `left ${before(leaves)}`);
  if (scene.fate) row(list, "fate", scene.fates[scene.fate[grain]]);
  if (scene.fine[grain]) {
    const way = pathOf(scene, grain, scene.states.indexOf(state)).length / (2 * scene.radius[grain]);
    row(list, "way so far", `${short(way)} diameters`);
  }
}

/** Fills `place` for the grain in `row`; `choose(row)` is called when a neighbor is wanted instead. */
export function showCard(place, scene, state, grain, choose) {
  place.replaceChildren();
  const heading = document.createElement("h3");
  if (grain < 0) {
    heading.textContent = "No grain chosen";
    const hint = document.createElement("p");
    hint.className = "quiet";
    hint.textContent = "Click a grain, or type its number above.";
    place.append(heading, hint);
    return;
  }
  heading.textContent = `Grain ${scene.id[grain]}, ${scene.fine[grain] ? "fine" : "coarse"}`;
  const list = document.createElement("dl");
  const leaves = scene.leftIn[grain];
  row(list, "diameter d", `${short(2 * scene.radius[grain])} mm`);
  if (scene.isMigration) addMigration(list, scene, state, grain);
  else row(list, "leaves", leaves === 0 ? "no, it stays" : state.present[grain] ? `in pass ${leaves}` : `left in pass ${leaves}`);
  place.append(heading, list);
  if (!state.present[grain]) return;
  const contacts = contactsOf(state, grain);
  const fines = contacts.filter(({ other }) => scene.fine[other]).length;
  row(list, scene.isMigration ? "contacts of free fines" : "contacts Z", contacts.length ? `${contacts.length}: ${contacts.length - fines} coarse, ${fines} fine` : "0");
  if (contacts.length > 0) {
    const largest = contacts[0].force;
    row(list, "largest normal force", `${short(largest)} N, ${short(largest / state.meanForce, 2)} × mean`);
  }
  const force = state.fluidForce?.[grain];
  if (Number.isFinite(force)) row(list, `fluid force, i = ${state.gradient ?? scene.gradient}`, `${short(force)} N`);
  const speed = state.speed?.[grain];
  if (Number.isFinite(speed)) row(list, scene.isMigration ? "speed" : "speed in the probe", `${short(speed)} m/s`);
  const moves = state.mobileGradient?.[grain];
  if (Number.isFinite(moves)) row(list, "moves at gradient", short(moves, 2));
  if (contacts.length === 0) return;
  const links = document.createElement("p");
  links.className = "neighbors";
  links.append("touches ");
  for (const { other, force: f } of contacts.slice(0, shownContacts)) {
    const button = document.createElement("button");
    button.type = "button";
    button.textContent = scene.id[other];
    button.title = `${short(f)} N; choose grain ${scene.id[other]}`;
    button.addEventListener("click", () => choose(other));
    links.append(button, " ");
  }
  if (contacts.length > shownContacts) links.append(`and ${contacts.length - shownContacts} more`);
  place.append(links);
}
