// What the worker answers, as the picture and the chart ask it: a pose at a time, stretches, impacts.

/// The index of the last of rising `times` that is no later than `time`; 0 if there is none.
function lastUpTo(times, time) {
  let [low, high] = [0, times.length];
  while (low + 1 < high) {
    const half = (low + high) >> 1;
    [low, high] = times[half] <= time ? [half, high] : [low, half];
  }
  return low;
}

const bits = (set) => [...Array(8).keys()].filter((i) => (set >> i) & 1);

/// `answer` of the worker for `the_case`, with what the page draws of it.
export function motionOf(the_case, answer) {
  const { times, states, events, end_time, ending, taut, unsure } = answer;
  const cables = the_case.cables.length;
  const rests = ending === "rest" || ending === "unstable_rest";
  const end = rests ? the_case.duration : end_time; // what has come to rest stays
  const impacts = [];
  let largest = 0;
  for (let i = 0; i < events.count; ++i) {
    if (events.kind[i] !== "impact") continue;
    const impulses = events.impulses.subarray(cables * i, cables * (i + 1));
    const size = Math.max(...impulses);
    impacts.push({ time: events.time[i], cables: bits(events.cables[i]), impulses, size, x: events.before[6 * i], y: events.before[6 * i + 1] });
    largest = Math.max(largest, size);
  }
  // between events the energy does not change: a staircase
  const stairs = { times: [0], energies: [answer.energy] };
  for (let i = 0; i < events.count; ++i) {
    stairs.times.push(events.time[i]);
    stairs.energies.push(energy(the_case, events.after.subarray(6 * i, 6 * i + 6)));
  }
  const tautAt = (time) => taut.reduce((set, one) => (one.start <= time && (time < one.end || one.end >= end_time) ? set | one.taut : set), 0);
  let fastest = 0; // the largest kinetic energy, a scale for the chart
  const { mass, inertia } = the_case.body;
  for (let i = 3; i < states.length; i += 6) {
    fastest = Math.max(fastest, 0.5 * (mass * (states[i] ** 2 + states[i + 1] ** 2) + inertia * states[i + 2] ** 2));
  }
  const isSure = (time) => unsure.every(({ from, until }) => time < from || time > until);
  return { ...answer, the_case, end, impacts, largest, fastest, stairs, tautAt,
    moments: [...new Set(events.time)],
    horizon: unsure.length > 0 ? unsure[0].from : Infinity,
    isSure, sure: Uint8Array.from(times, (time) => (isSure(time) ? 1 : 0)),
    stretches: Array.from({ length: cables }, (_, cable) => joined(taut.filter((one) => (one.taut >> cable) & 1), end_time, end)),
    at(time) {
      const i = Math.min(lastUpTo(times, time), times.length - 2);
      if (times.length < 2 || time >= end_time) return [...states.subarray(states.length - 6)];
      const part = (time - times[i]) / (times[i + 1] - times[i]);
      return Array.from({ length: 6 }, (_, k) => states[6 * i + k] * (1 - part) + states[6 * i + 6 + k] * part);
    } };
}

/// Stretches one after the other as one; the last goes on while the body rests.
function joined(stretches, end_time, end) {
  const all = [];
  for (const { start, end: until } of stretches) {
    const last = all.at(-1), to = until >= end_time ? end : until;
    if (last && start - last.end < 1e-9 * end) last.end = to;
    else all.push({ start, end: to });
  }
  return all;
}

export function energy({ body: { mass, inertia }, gravity: [gx, gy] }, [x, y, , vx, vy, spin]) {
  return 0.5 * (mass * (vx * vx + vy * vy) + inertia * spin * spin) - mass * (gx * x + gy * y);
}

/// The run of an engine, with its energies.
export function runOf(the_case, { states, steps, rate, impulses, ...rest }) {
  const energies = new Float64Array(steps + 1);
  for (let i = 0; i <= steps; ++i) energies[i] = energy(the_case, states.subarray(6 * i, 6 * i + 6));
  return { ...rest, rate, steps, energies, impulses,
    at(time) {
      const place = Math.min(time * rate, steps), i = Math.min(Math.floor(place), Math.max(steps - 1, 0)), part = place - i;
      return Array.from({ length: 6 }, (_, k) => states[6 * i + k] * (1 - part) + (states[6 * i + 6 + k] ?? states[6 * i + k]) * part);
    } };
}
