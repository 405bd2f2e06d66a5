// The solver in a worker: it answers one question at a time. The page keeps two of them, one for the motion and one for
// the fog, so that neither waits for the other.

import { load } from "tautline";
import { endOf } from "./case.mjs";

/// Far more than a picture shows, and a few milliseconds of work: the page says where it stops.
const limits = { max_events: 20000, max_steps: 20000 };
/// Points of the path besides those at events; fewer while a hand moves.
const [POINTS, FEWER] = [2000, 1000];
/// Instants of the fog.
const INSTANTS = 400;
/// Starts are moved on all coordinates if no cable is nearer to its end than so many times their distance.
const CLEAR = 10;

let tautline;

const set = (cables) => cables.reduce((bits, cable) => bits | (1 << cable), 0);

/// The events as columns: objects would cost more to send than to solve.
function columns(events, cables) {
  const count = events.length, width = 6;
  const all = { count, time: new Float64Array(count), kind: new Array(count), cables: new Int32Array(count),
    before: new Float64Array(width * count), after: new Float64Array(width * count), impulses: new Float64Array(cables * count) };
  events.forEach((event, i) => {
    all.time[i] = event.time;
    all.kind[i] = event.kind;
    all.cables[i] = set(event.cables);
    all.before.set(event.before, width * i);
    all.after.set(event.after, width * i);
    all.impulses.set(event.impulses, cables * i);
  });
  return all;
}

/// `count` instants from 0 to `end` and those of `events`, in order, each once.
function instants(end, count, events) {
  const all = new Float64Array(count + events.length);
  for (let i = 0; i < count; ++i) all[i] = i === count - 1 ? end : (end * i) / (count - 1);
  all.set(events, count);
  all.sort();
  return all.filter((time, i) => i === 0 || time !== all[i - 1]);
}

/// Where which cables are taut. The arcs hold a motion that repeats itself for one period: a swing, whose cables stay taut.
function tautStretches({ arcs, end_time, summary: { repetition } }) {
  return arcs.filter(({ taut }) => taut.length > 0).map(({ start, end, taut }, k, all) =>
    ({ start, end: repetition && k === all.length - 1 ? end_time : end, taut: set(taut) }));
}

/// The motion of a case as the page draws it. `whole` also asks for what waits until a hand rests: how far its numbers are
/// sure takes longer than the motion.
function solve({ the_case, law, whole }) {
  const problems = tautline.problems(the_case);
  if (problems.length > 0) return { problems };
  const began = performance.now();
  const motion = tautline.solve(the_case, { law, ...limits });
  const took = performance.now() - began;
  try {
    const { ending, end_time } = motion;
    const events = columns(motion.events, the_case.cables.length);
    const times = instants(end_time, whole ? POINTS : FEWER, events.time);
    return { took, ending, end_time, events, times, states: motion.states(times), unsure: whole ? motion.unsure : [], energy: motion.summary.start_energy,
      taut: tautStretches(motion),
      ...(whole && { settling: motion.settling, toml: tautline.write(the_case, "toml"), json: tautline.write(the_case, "json"),
        notes: tautline.notes(the_case) }) };
  } finally {
    motion.dispose();
  }
}

/// Numbers from -1 to 1, the same at every call: a link shows the fog that its sender saw.
function* scatter() {
  for (let state = 1; ;) {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    yield state / 2 ** 31 - 1;
  }
}

/// `count` exact motions whose starts differ by up to `apart` in each coordinate. `spread` is their root mean square
/// distance from their mean pose, in the metric of the kinetic energy: a turn counts by the radius of gyration.
function fog({ the_case, law, count, apart, end }) {
  const began = performance.now(), { position, angle, velocity, spin } = the_case.initial;
  const start = { x: position[0], y: position[1], angle, vx: velocity[0], vy: velocity[1], spin };
  const moved = clearance(the_case) > CLEAR * apart ? Object.keys(start) : ["vx", "vy", "spin"];
  const random = scatter();
  const values = Object.fromEntries(moved.map((name) =>
    [name, Float64Array.from({ length: count }, () => start[name] + apart * random.next().value)]));
  const times = Float64Array.from({ length: INSTANTS }, (_, i) => (end * i) / (INSTANTS - 1));
  const { states, end_time } = tautline.sweep(the_case, values, { law, ...limits, times });
  const width = states.length / count / INSTANTS, scale = [1, 1, Math.sqrt(the_case.body.inertia / the_case.body.mass)];
  const futures = { count, instants: INSTANTS, end, poses: new Float32Array(count * INSTANTS * 3), spread: new Float64Array(INSTANTS) };
  const sums = new Float64Array(3 * INSTANTS), squares = new Float64Array(INSTANTS);
  let solved = 0;
  for (let one = 0; one < count; ++one) {
    const first = one * INSTANTS * width;
    solved += Number.isFinite(states[first]) ? 1 : 0;
    for (let i = 0, to = 3 * one * INSTANTS; i < INSTANTS; ++i, to += 3) {
      const from = first + i * width, ended = i > 0 && times[i] > end_time[one]; // what has come to rest stays
      for (let k = 0; k < 3; ++k) {
        const value = ended ? futures.poses[to + k - 3] : states[from + k];
        const off = scale[k] * (value - states[i * width + k]); // small numbers: few roundings
        futures.poses[to + k] = value;
        if (off === off) {
          sums[3 * i + k] += off;
          squares[i] += off * off;
        }
      }
    }
  }
  for (let i = 0; i < INSTANTS; ++i) {
    const mean = (sums[3 * i] ** 2 + sums[3 * i + 1] ** 2 + sums[3 * i + 2] ** 2) / solved;
    futures.spread[i] = Math.sqrt(Math.max(0, squares[i] - mean) / solved);
  }
  return { ...futures, took: performance.now() - began };
}

/// The smallest gap at the start.
function clearance({ cables, initial: { position, angle } }) {
  return Math.min(...cables.map((cable) => {
    const [x, y] = endOf(cable, [...position, angle]);
    return cable.taut ? 0 : cable.length - Math.hypot(x - cable.anchor[0], y - cable.anchor[1]);
  }));
}

/// A case from the text of a file.
function read({ text, name }) {
  try {
    return { the_case: tautline.read(text, name) };
  } catch (error) {
    return { problems: error.message.split("\n") };
  }
}

/// What is handed over and not copied.
const buffers = (answer) => [...Object.values(answer), ...Object.values(answer.events ?? {})].filter(ArrayBuffer.isView).map(({ buffer }) => buffer);

const answers = { solve, fog, read };

onmessage = async ({ data }) => {
  if (data.module) {
    try {
      tautline = await load(data.module);
      postMessage({ version: tautline.version });
    } catch ({ message }) {
      postMessage({ failed: message });
    }
    return;
  }
  try {
    const answer = answers[data.what](data);
    postMessage({ answer }, buffers(answer));
  } catch (error) {
    postMessage({ answer: { problems: error.message.split("\n") } });
  }
};
