// What a grain's color says. Coarse is sand and fines are red, here as in the charts; scales are viridis, which stays
// apart for color-blind readers and in gray.

const hex = (text) => [1, 3, 5].map((k) => parseInt(text.slice(k, k + 2), 16));
const coarse = hex("#cfa457");
const fines = hex("#c8322b");
const neutral = hex("#b9b5ab");
const passColors = ["#3b82b8", "#d55e00", "#17ac5b", "#835380", "#c57c92", "#a74346"].map(hex);
const fateColors = ["#cfa457", "#8f9aa3", "#0072b2", "#56c8e9", "#d55e00", "#4b2e63"].map(hex);
const viridis = ["#440154", "#472d7b", "#3b528b", "#2c728e", "#21918c", "#28ae80", "#5ec962", "#addc30", "#fde725"].map(hex);

const css = ([r, g, b]) => `rgb(${Math.round(r)} ${Math.round(g)} ${Math.round(b)})`;

export function scaleColor(share) {
  const at = Math.min(Math.max(share, 0), 1) * (viridis.length - 1);
  const low = Math.min(Math.floor(at), viridis.length - 2);
  return viridis[low].map((c, k) => c + (at - low) * (viridis[low + 1][k] - c));
}

export const scaleGradient = `linear-gradient(to right, ${viridis.map(css).join(", ")})`;

/** A number as one reads it: three digits, powers of ten outside 0.001 to 100,000. */
export function short(value, digits = 3) {
  if (!Number.isFinite(value)) return "–";
  if (value === 0) return "0";
  const size = Math.abs(value);
  if (size >= 1e5 || size < 1e-3) {
    const [mantissa, exponent] = value.toExponential(digits - 1).split("e");
    const raised = [...String(Number(exponent))].map((c) => (c === "-" ? "⁻" : "⁰¹²³⁴⁵⁶⁷⁸⁹"[c])).join("");
    return `${Number(mantissa)}·10${raised}`;
  }
  return size >= 1000 ? Math.round(value).toLocaleString("en") : String(Number(value.toPrecision(digits)));
}

function quantile(values, share) {
  const sorted = Float64Array.from(values).sort();
  return sorted[Math.min(sorted.length - 1, Math.floor(share * sorted.length))];
}

/** Swatches for classes, each with the number of grains that has it; without those of no grain if `skipsEmpty`. */
function classes(list, classOf, skipsEmpty = false) {
  return {
    color: (state, row) => list[classOf(state, row)].color,
    legend: (state, rows) => {
      const count = list.map(() => 0);
      for (const row of rows) ++count[classOf(state, row)];
      const swatches = list.map((each, k) => ({ name: each.name, count: count[k], color: css(each.color) }));
      return { swatches: swatches.filter((each) => each.count > 0 || !skipsEmpty) };
    },
  };
}

/** A scale over the values of all states, so that a color keeps its meaning when the slider moves. */
function scale(scene, valueOf, { log = false, unit, missing }) {
  const values = [];
  scene.states.forEach((state) => {
    for (let row = 0; row < scene.id.length; ++row) {
      const value = state.present[row] ? valueOf(state, row) : NaN;
      if (Number.isFinite(value) && (!log || value > 0)) values.push(value);
    }
  });
  const low = values.length ? quantile(values, log ? 0.02 : 0) : 0;
  const high = values.length ? quantile(values, 0.99) : 1;
  const place = log ? (x) => Math.log(x / low) / (Math.log(high / low) || 1) : (x) => (x - low) / (high - low || 1);
  const has = (state, row) => Number.isFinite(valueOf(state, row));
  return {
    color: (state, row) => {
      const value = valueOf(state, row);
      return Number.isFinite(value) ? scaleColor(log && !(value > 0) ? 0 : place(value)) : neutral;
    },
    legend: (state, rows) => ({
      range: values.length ? [short(low), short(log ? Math.sqrt(low * high) : (low + high) / 2), short(high)] : null,
      unit,
      swatches: rows.some((row) => !has(state, row))
        ? [{ name: missing, count: rows.filter((row) => !has(state, row)).length, color: css(neutral) }]
        : [],
    }),
  };
}

/** Name -> how a grain is colored and what the legend says; only what the scene has data for. */
export function colorModes(scene) {
  const fine = (row) => scene.fine[row] !== 0;
  const modes = {
    class: {
      label: "class",
      ...classes(
        [{ name: "coarse", color: coarse }, { name: "fines", color: fines }],
        (_, row) => (fine(row) ? 1 : 0),
      ),
    },
    activity: {
      label: "activity",
      ...classes(
        [
          { name: "active: 2 contacts or more", color: hex("#3b82b8") },
          { name: "1 contact", color: hex("#e8b13d") },
          { name: "no contact", color: hex("#d55e00") },
        ],
        (state, row) => (state.coordination[row] >= 2 ? 0 : state.coordination[row] === 1 ? 1 : 2),
      ),
    },
    coordination: {
      label: "coordination",
      ...scale(scene, (state, row) => state.coordination[row], { unit: "contacts of the grain, Z [-]" }),
    },
  };
  // The gradient of a migration changes from state to state.
  const gradient = scene.isMigration ? "" : `, i = ${scene.gradient}`;
  const at = scene.isMigration ? "" : ` under the water's force${gradient}`;
  const unprobed = scene.isMigration ? "coarse, or held" : "coarse, or not probed";
  if (scene.states.some((state) => state.speed)) {
    modes.speed = {
      label: "speed",
      ...scale(scene, (state, row) => state.speed?.[row] ?? NaN, { log: true, unit: `v [m/s]${at}`, missing: unprobed }),
    };
  }
  if (scene.states.some((state) => state.fluidForce)) {
    modes.force = {
      label: "fluid force",
      ...scale(scene, (state, row) => state.fluidForce?.[row] ?? NaN, { log: true, unit: `F [N]${gradient}`, missing: unprobed }),
    };
  }
  if (scene.states.some((state) => state.mobileGradient)) {
    modes.moves = {
      label: "gradient that moves it",
      ...scale(scene, (state, row) => state.mobileGradient?.[row] ?? NaN, {
        unit: "hydraulic gradient i that first moves the grain [-]",
        missing: "coarse, or stays",
      }),
    };
  }
  if (scene.fate) {
    const list = scene.fates.map((name, k) => ({ name, color: fateColors[k % fateColors.length] }));
    modes.fate = { label: "where it ends", ...classes(list, (_, row) => scene.fate[row], true) };
  }
  const passes = [...new Set(scene.leftIn)].filter((pass) => pass > 0).sort((a, b) => a - b);
  if (passes.length > 0 && !scene.isMigration) {
    const list = [{ name: "stays", color: neutral }, ...passes.map((pass, k) => ({ name: `leaves in pass ${pass}`, color: passColors[k % passColors.length] }))];
    modes.pass = { label: "pass in which it leaves", ...classes(list, (_, row) => (scene.leftIn[row] ? passes.indexOf(scene.leftIn[row]) + 1 : 0)) };
  }
  return modes;
}
