// How far an engine is from the exact motion, for its own test runner. The package `tautline` has the exact motion.

import { execFileSync } from "node:child_process";

/** A bar on two cables, which hit it next to its centre one after the other, and at last both at once, ever slower. */
export const bar = {
  name: "bar", duration: 0.9, gravity: [0, -9.81], body: { mass: 2, inertia: 0.1 }, initial: { position: [0.05, 0.3], spin: 0.4 },
  cables: [{ anchor: [-1, 2], attachment: [-0.4, 0.1], length: 2.2, restitution: 0.5 },
    { anchor: [1, 2], attachment: [0.4, 0.1], length: 2.2, restitution: 0.5 }],
};

/** `bar` with impacts that rebound 3 % less: no engine that is right for `bar` is right for this. */
export const dull_bar = { ...bar, cables: bar.cables.map((cable) => ({ ...cable, restitution: 0.485 })) };

/** Runs `model` of the engine that `command` starts in `folder`: the states at its steps of `step` [s], the start first. */
export function samples([program, ...words], folder, the_case, { model, step }) {
  const count = Math.floor(the_case.duration / step);
  const ask = (id, method, params) => `${JSON.stringify({ jsonrpc: "2.0", id, method, params })}\n`;
  const input = ask(1, "start", { case: the_case, model, step, law: "simultaneous", parameters: {} })
    + ask(2, "step", { dt: step, count });
  const output = execFileSync(program, words, { cwd: folder, input, encoding: "utf8", stdio: ["pipe", "pipe", "inherit"], maxBuffer: 1 << 30 });
  const [start, run] = output.trimEnd().split("\n").map((line) => {
    const { error, result } = JSON.parse(line);
    if (error) throw new Error(error.message);
    return result;
  });
  if (run.stopped) throw new Error(`stopped at ${run.stopped.time} s: ${run.stopped.reason}`);
  if (run.steps.length !== count) throw new Error(`${run.steps.length} steps came back, ${count} were asked`);
  return [start.state, ...run.steps.map((row) => row.slice(0, 6))].map((row) => row.map(Number));
}

/**
 * The largest distance of a run from the exact motion, as a multiple [-] of two steps of the fastest speed: by so much a scheme of
 * first order may be late. `tautline` is what `load` of the package gives. A right engine stays below 1 at every step, until its
 * errors have grown; a wrong one exceeds it at small steps. `exact_case`: another case that it is compared with.
 */
export function lateness(tautline, command, folder, the_case, { model, step, exact_case = the_case }) {
  const whole = tautline.read(tautline.write(the_case, "json")); // with every key
  const rows = samples(command, folder, whole, { model, step });
  const motion = tautline.solve(exact_case);
  const exact = motion.states(rows.map((_, k) => Math.min(k * step, motion.end_time)));
  motion.dispose();
  const radius = Math.sqrt(whole.body.inertia / whole.body.mass); // [m], of gyration
  let fastest = 0, farthest = 0; // [m/s], [m]
  rows.forEach(([x, y, angle], k) => {
    const [ex, ey, turned, vx, vy, spin] = exact.subarray(6 * k, 6 * k + 6);
    fastest = Math.max(fastest, Math.hypot(vx, vy, radius * spin));
    farthest = Math.max(farthest, Math.hypot(x - ex, y - ey, radius * (angle - turned)));
  });
  return farthest / (2 * step * fastest);
}
