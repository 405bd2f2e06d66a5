// The state of the page, and its form in the address:
//
//   #case=crane-load&law=poisson                a shipped case, and what differs from a fresh page
//   #name=mine&duration=20&gravity=0,-1&body=MASS,INERTIA&start=X,Y,ANGLE,VX,VY,SPIN
//     &cable=ANCHOR X,Y,ATTACHMENT X,Y,LENGTH,RESTITUTION[,CAPTURE SPEED[,taut]]    for each cable
//     &table=CABLE,SPEED,RESTITUTION,...                                            for a restitution over speed
//     &angle_limit=...&ceiling=...
//
// A number is the shortest decimal that reads back as the same double, so a link has every bit of a case.

export const LAWS = ["simultaneous", "poisson", "sequential", "energetic"];
/// Steps in a second of the engine.
export const RATES = [60, 240, 1000];
/// How fast the page plays.
export const SPEEDS = [0.1, 0.25, 0.5, 1, 2, 4];
/// How far the starts of the fog are apart.
export const APART = [1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12];
export const MOST_CABLES = 8;

/// What a page shows of a case unless its address says more. `model` is empty for no engine.
export const view = { law: "simultaneous", engine: "planck", model: "rope", rate: 60, fog: true, apart: 1e-4, speed: 1, time: 0 };

/// The members of a case in one order, with the defaults of a case file written out.
export function complete({ name, duration, gravity, angle_limit, ceiling, body, cables, initial }) {
  return {
    name, duration, gravity: [...gravity],
    ...(angle_limit != null && { angle_limit }), ...(ceiling != null && { ceiling }),
    body: { mass: body.mass, inertia: body.inertia },
    cables: cables.map(({ anchor, attachment, length, restitution, restitution_table: table = [], capture_speed = 0, taut = false }) => ({
      anchor: [...anchor], attachment: [...(attachment ?? [0, 0])], length, restitution,
      ...(table.length > 0 && { restitution_table: table.map((point) => [...point]) }),
      ...(capture_speed !== 0 && { capture_speed }), ...(taut && { taut }) })),
    initial: { position: [...initial.position], angle: initial.angle ?? 0, velocity: [...(initial.velocity ?? [0, 0])],
      spin: initial.spin ?? 0 },
  };
}

/// A number for the address, and for a field of the page.
export const spell = (value) => (Object.is(value, -0) ? "-0" : String(value).replace("e+", "e"));
const list = (values) => values.map(spell).join(",");

/// The address of every number of a case.
function spellCase(one) {
  const { initial: { position, angle, velocity, spin } } = one;
  return [`name=${encodeURIComponent(one.name)}`, `duration=${spell(one.duration)}`, `gravity=${list(one.gravity)}`,
    `body=${list([one.body.mass, one.body.inertia])}`, `start=${list([...position, angle, ...velocity, spin])}`,
    ...one.cables.map(({ anchor, attachment, length, restitution, capture_speed = 0, taut }) =>
      `cable=${list([...anchor, ...attachment, length, restitution, ...(capture_speed !== 0 || taut ? [capture_speed] : [])])}${taut ? ",taut" : ""}`),
    ...one.cables.flatMap(({ restitution_table: table }, i) => (table ? [`table=${i},${list(table.flat())}`] : [])),
    ...["angle_limit", "ceiling"].filter((key) => key in one).map((key) => `${key}=${spell(one[key])}`)].join("&");
}

/// The shipped case that `one` is to the last bit, if it is one.
export function shippedAs(one, shipped) {
  const found = shipped.find(({ name }) => name === one.name);
  return found && spellCase(complete(found)) === spellCase(one) ? found : undefined;
}

/// The address of a state, without its #.
export function spellState(state, shipped) {
  const said = [shippedAs(state.the_case, shipped) ? `case=${state.the_case.name}` : spellCase(state.the_case)];
  const { law, engine, model, rate, fog, apart, speed, time } = state;
  if (law !== view.law) said.push(`law=${law}`);
  if (engine !== view.engine || model !== view.model) said.push(`engine=${model === "" ? "none" : `${engine}/${model}`}`);
  if (rate !== view.rate) said.push(`rate=${rate}`);
  if (!fog) said.push("fog=0");
  if (apart !== view.apart) said.push(`apart=${spell(apart)}`);
  if (speed !== view.speed) said.push(`speed=${spell(speed)}`);
  if (time > 0) said.push(`t=${spell(time)}`);
  return said.join("&");
}

class Wrong extends Error {}

function numbers(key, text, least, most = least) {
  const values = text.split(",").map((one) => (one.trim() === "" ? NaN : Number(one)));
  if (values.length < least || values.length > most || values.some(Number.isNaN)) {
    throw new Wrong(`address: ${key}=${text} must be ${least === most ? least : `${least} to ${most}`} number${most > 1 ? "s" : ""}`);
  }
  return values;
}

function readCable(text) {
  const taut = text.endsWith(",taut");
  const [ax, ay, bx, by, length, restitution, capture_speed] = numbers("cable", taut ? text.slice(0, -5) : text, 6, 7);
  return { anchor: [ax, ay], attachment: [bx, by], length, restitution, capture_speed, taut };
}

function readTable(one, text) {
  const [cable, ...flat] = numbers("table", text, 3, 1000);
  if (!one.cables[cable] || flat.length % 2 !== 0) throw new Wrong(`address: table=${text} must be a cable and pairs of numbers`);
  one.cables[cable].restitution_table = Array.from({ length: flat.length / 2 }, (_, i) => flat.slice(2 * i, 2 * i + 2));
}

function readCase(first, all, shipped) {
  const name = first("case");
  if (name !== undefined) {
    const found = shipped.find((one) => one.name === name);
    if (!found) throw new Wrong(`address: no case "${name}" is shipped`);
    return complete(found);
  }
  if (first("cable") === undefined) return complete(shipped[0]);
  const given = (key, otherwise, least) => numbers(key, first(key) ?? otherwise, least);
  const [x, y, angle, vx, vy, spin] = given("start", "0,0,0,0,0,0", 6), [mass, inertia] = given("body", "1,0", 2);
  const one = { name: first("name") ?? "case", duration: given("duration", "20", 1)[0], gravity: given("gravity", "0,-1", 2),
    body: { mass, inertia }, cables: all("cable").map(readCable), initial: { position: [x, y], angle, velocity: [vx, vy], spin } };
  for (const key of ["angle_limit", "ceiling"]) {
    if (first(key) !== undefined) one[key] = numbers(key, first(key), 1)[0];
  }
  all("table").forEach((text) => readTable(one, text));
  return complete(one);
}

/// The keys of an address.
const KEYS = ["case", "name", "duration", "gravity", "body", "start", "cable", "table", "angle_limit", "ceiling", "law", "engine", "rate",
  "fog", "apart", "speed", "t"];

/// The state of an address, whether it `stays` at an instant, and a sentence on what is wrong with it: where that is its case,
/// it is the state of a fresh page.
export function readState(address, shipped) {
  try {
    const pairs = address.replace(/^#/, "").split("&").filter(Boolean).map((one) => {
      const [key, ...rest] = one.split("=");
      return [key, decodeURIComponent(rest.join("="))];
    });
    const all = (key) => pairs.filter(([one]) => one === key).map(([, text]) => text);
    const first = (key) => all(key)[0];
    const state = { ...view, the_case: readCase(first, all, shipped) };
    const wrong = [...new Set(pairs.map(([key]) => key))].filter((key) => !KEYS.includes(key)).map((key) => `${key} is no key`);
    const chosen = (key, choices, read = Number, write = String) => {
      if (first(key) === undefined) return;
      if (choices.includes(read(first(key)))) state[key] = read(first(key));
      else wrong.push(`${key}=${first(key)} must be ${choices.slice(0, -1).map(write).join(", ")} or ${write(choices.at(-1))}`);
    };
    chosen("law", LAWS, String);
    const [engine, model = ""] = (first("engine") ?? `${state.engine}/${state.model}`).split("/");
    if (engine === "none") state.model = "";
    else if (model === "") wrong.push(`engine=${engine} must be an engine and its model, such as planck/rope, or none`);
    else Object.assign(state, { engine, model });
    chosen("rate", RATES);
    chosen("apart", APART, Number, (apart) => apart.toExponential());
    chosen("speed", SPEEDS);
    chosen("fog", [false, true], (text) => ({ 0: false, 1: true })[text], Number);
    if (first("t") !== undefined) state.time = Math.max(0, numbers("t", first("t"), 1)[0]);
    return { state, stays: first("t") !== undefined, ...(wrong.length > 0 && { problem: `address: ${wrong.join("; ")}` }) };
  } catch (error) {
    if (!(error instanceof Wrong || error instanceof URIError)) throw error;
    return { state: { ...view, the_case: complete(shipped[0]) }, problem: error.message };
  }
}

/// A name for a case that was changed.
export const changedName = (name) => (name.endsWith(" changed") ? name : `${name} changed`);

/// The end of a cable on the body, in the world.
export function endOf({ attachment: [u, v] }, [x, y, angle]) {
  const c = Math.cos(angle), s = Math.sin(angle);
  return [x + c * u - s * v, y + s * u + c * v];
}

/// The state at the start as a row of numbers.
export const startOf = ({ initial: { position, angle, velocity, spin } }) => [...position, angle, ...velocity, spin];

/// A symbol of no unit for a case without units, whose gravity is 1.
export const inUnits = ({ gravity: [gx, gy] }, unit) => (gx ** 2 + gy ** 2 === 1 || unit === "" ? "" : ` ${unit}`);
