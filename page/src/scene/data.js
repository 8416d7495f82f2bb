// The scene as the program wrote it (suffuse/report/scene.hpp): base64 columns into typed arrays, meters into millimeters.

const arrays = { u8: Uint8Array, u16: Uint16Array, u32: Uint32Array, i16: Int16Array, f32: Float32Array };

function column({ type, data }) {
  const text = atob(data);
  const bytes = new Uint8Array(text.length);
  for (let k = 0; k < text.length; ++k) bytes[k] = text.charCodeAt(k);
  return new arrays[type](bytes.buffer);
}

const mm = 1e3;

/** Point of the cell from fractions of its vectors. */
export function point(cell, a, b, c) {
  return [0, 1, 2].map((k) => cell[0][k] * a + cell[1][k] * b + cell[2][k] * c);
}

function readState(raw, grains) {
  const cell = raw.cell.map((vector) => vector.map((x) => x * mm));
  const place = column(raw.place);
  const position = new Float32Array(place.length);
  for (let k = 0; k < place.length; k += 3) {
    position.set(point(cell, place[k] / 65535, place[k + 1] / 65535, place[k + 2] / 65535), k);
  }
  const coordination = column(raw.coordination);
  const present = grains.leftIn.map((left, row) => ((grains.enteredIn?.[row] ?? 0) <= raw.passes && (left === 0 || left > raw.passes) ? 1 : 0));
  const ends = column(raw.contacts.ends);
  const period = column(raw.contacts.period);
  const force = column(raw.contacts.normal_force);
  const meanForce = force.length ? force.reduce((sum, f) => sum + f, 0) / force.length : 0;
  const state = { label: raw.label, passes: raw.passes, cell, place, position, coordination, present, ends, period, force, meanForce };
  state.time = raw.time ?? null; // [s], in migrations only
  state.gradient = raw.gradient ?? null;
  state.inPeriod = raw.period ? column(raw.period) : null; // of each grain, likewise
  state.speed = raw.speed ? column(raw.speed) : null;
  state.fluidForce = raw.fluid_force ? column(raw.fluid_force) : null;
  state.mobileGradient = raw.mobile_gradient ? column(raw.mobile_gradient) : null;
  return state;
}

export function readScene(raw) {
  const scene = {
    id: column(raw.id),
    radius: column(raw.radius).map((r) => r * mm),
    fine: column(raw.fine),
    leftIn: column(raw.left_in),
    enteredIn: raw.entered_in ? column(raw.entered_in) : null,
    fate: raw.fate ? column(raw.fate) : null,
    fates: raw.fates ?? [],
    flowDirection: raw.flow_direction,
    gradient: raw.gradient,
  };
  scene.states = raw.states.map((state) => readState(state, scene));
  scene.isMigration = scene.states.some(({ time }) => time !== null);
  // What moves a grain belongs to the packing that was probed. The states before it show it ahead, by the same rows.
  for (let k = scene.states.length - 2; k >= 0; --k) scene.states[k].mobileGradient ??= scene.states[k + 1].mobileGradient;
  scene.rowOf = new Map([...scene.id].map((id, row) => [id, row]));
  return scene;
}

/** Both ends of a contact: the center of its first grain, and the image of the second that touches it. */
export function contactEnds(state, contact) {
  const i = 3 * state.ends[2 * contact];
  const j = 3 * state.ends[2 * contact + 1];
  const code = state.period[contact];
  const shift = point(state.cell, (code % 3) - 1, (Math.floor(code / 3) % 3) - 1, Math.floor(code / 9) - 1);
  const from = [...state.position.subarray(i, i + 3)];
  const to = [0, 1, 2].map((k) => state.position[j + k] + shift[k]);
  return { from, to };
}

/** Contacts of a grain: the other grain's row and the normal force, the largest force first. */
export function contactsOf(state, row) {
  const found = [];
  for (let c = 0; c < state.force.length; ++c) {
    const i = state.ends[2 * c];
    const j = state.ends[2 * c + 1];
    if (i === row || j === row) found.push({ contact: c, other: i === row ? j : i, force: state.force[c] });
  }
  return found.sort((a, b) => b.force - a.force);
}
