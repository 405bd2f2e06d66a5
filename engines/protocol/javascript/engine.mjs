// An engine in a process of its own: `serve` answers tautline's messages until standard input ends.
// Import this before the engine's own package, which may keep the console it finds.

import fs from "node:fs";
import { syncBuiltinESMExports } from "node:module";
// Standard output belongs to the protocol. What a library prints goes to standard error: the console and
// process.stdout here, and what Emscripten writes past both.
const { readSync, writeSync } = fs;
Object.defineProperty(process, "stdout", { get: () => process.stderr });
fs.writeSync = (fd, ...rest) => writeSync(fd === 1 ? 2 : fd, ...rest);
syncBuiltinESMExports();

/** Thrown where the engine cannot do what a case asks for; says what and why. */
export class Unsupported extends Error {
  constructor(why) { super(`unsupported: ${why}`); }
}

/** Tries `transfer` until the pipe, which may be a non-blocking one, is ready. */
function patiently(transfer) {
  for (;;) {
    try {
      return transfer();
    } catch (error) {
      if (error.code !== "EAGAIN") throw error;
      Atomics.wait(new Int32Array(new SharedArrayBuffer(4)), 0, 0, 1); // for a millisecond
    }
  }
}

/** The lines of standard input, read without an event loop: an answer costs microseconds. */
function* lines() {
  const chunk = Buffer.allocUnsafe(1 << 16);
  let rest = Buffer.alloc(0);
  for (let size; (size = patiently(() => readSync(0, chunk))) > 0; ) {
    rest = Buffer.concat([rest, chunk.subarray(0, size)]);
    for (let end; (end = rest.indexOf("\n")) >= 0; rest = rest.subarray(end + 1)) yield rest.toString("utf8", 0, end);
  }
}

/** A text in an array is a number that JSON has none for. */
const read = (line) => JSON.parse(line, function (_, value) {
  return Array.isArray(this) && typeof value === "string" ? Number(value) : value;
});

/** The same for what is written; "-0" has a sign that JSON.stringify drops. */
function spelled(value) {
  if (typeof value === "number") return Object.is(value, -0) ? "-0" : Number.isFinite(value) ? value : String(value);
  if (Array.isArray(value)) return value.map(spelled);
  if (value === null || typeof value !== "object") return value;
  return Object.fromEntries(Object.entries(value).map(([key, entry]) => [key, spelled(entry)]));
}

/**
 * Serves `engine`: {name, version, precision, models}, and `dimensions` where it runs systems in space. A model is what
 * `info` says of it, and start(case, {step, law, parameters}), which returns a run: state(); step(dt), which returns
 * the impulse of each cable; or for a model driven by events fly(dt), place(state), in space place(state, time),
 * solve(cables, rates), which returns impulses, and `rounding`. A run may have `stopped`, {time, reason}, `soft`, the
 * springs of its cables, and free(), called once it is done.
 */
export function serve({ models, ...engine }) {
  let run;
  const methods = {
    info: () => ({ protocol: 2, ...engine, models: models.map(({ start, ...told }) => told) }),
    start({ case: the_case, model, step, law, parameters = {} }) {
      run?.free?.();
      run = undefined;
      const found = models.find(({ name }) => name === model);
      if (!found) throw new Unsupported(`no model "${model}"; there are ${models.map(({ name }) => name).join(", ")}`);
      run = found.start(the_case, { step, law, parameters });
      return { state: run.state(), rounding: run.rounding, soft: run.soft };
    },
    step({ dt, count }) {
      const steps = [];
      while (steps.length < count && !run.stopped) {
        const impulses = run.step(dt);
        if (!run.stopped) steps.push([...run.state(), ...impulses]);
      }
      return { steps, stopped: run.stopped };
    },
    fly: ({ dt }) => (run.fly(dt), { state: run.state() }),
    place: ({ state, time }) => (run.place(state, time), { state: run.state() }),
    solve: ({ cables, rates }) => ({ impulses: run.solve(cables, rates), state: run.state() }),
  };
  for (const line of lines()) {
    const answer = { jsonrpc: "2.0", id: null };
    try {
      const { id, method, params } = read(line);
      answer.id = id;
      if (!Object.hasOwn(methods, method)) throw Object.assign(new Error(`no method "${method}"`), { code: -32601 });
      if (!run && method !== "info" && method !== "start") throw new Error(`"${method}" before "start"`);
      answer.result = spelled(methods[method](params ?? {}));
    } catch (error) {
      const code = error instanceof Unsupported ? -32602 : error?.code === -32601 ? -32601 : -32000;
      answer.error = { code, message: String(error?.message ?? error) };
    }
    const bytes = Buffer.from(JSON.stringify(answer) + "\n");
    for (let done = 0; done < bytes.length; ) done += patiently(() => writeSync(1, bytes, done));
  }
  run?.free?.();
}
