// Every number of the module has the bits of the native solver.
import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import { test } from "node:test";
import { expect_same_bits, load, motions_program } from "./support.mjs";

const KINDS = ["impact", "taut", "slack"];
const ENDINGS = ["reached_duration", "rest", "unstable_rest", "locked", "angle_limit", "ceiling", "singular", "event_limit",
  "step_limit", "no_progress", "overflow"];
const INSTANTS = 20;
const set_of = (cables) => cables.reduce((sum, cable) => sum + 2 ** cable, 0);
const or_nan = (number) => number ?? NaN;

/** What the program of motions.cpp has written: for each system a line of JSON, and its numbers. */
async function* systems() {
  const child = spawn(motions_program(), { stdio: ["ignore", "pipe", "inherit"] });
  const ended = new Promise((resolve) => child.once("close", resolve));
  let rest = Buffer.alloc(0), chunks = [], size = 0;
  const source = child.stdout[Symbol.asyncIterator]();
  /** Reads on until `rest` has `count` bytes; false at the end. */
  async function more(count) {
    chunks = [rest];
    size = rest.length;
    while (size < count) {
      const { value, done } = await source.next();
      if (done) break;
      chunks.push(value);
      size += value.length;
    }
    rest = chunks.length > 1 ? Buffer.concat(chunks) : rest;
    return rest.length >= count;
  }
  for (;;) {
    let end;
    while ((end = rest.indexOf("\n")) < 0) if (!(await more(rest.length + 1))) break;
    if (end < 0) break;
    const head = JSON.parse(rest.toString("utf8", 0, end));
    rest = rest.subarray(end + 1);
    assert.ok(await more(8 * head.numbers), "the program stops within a system");
    const bytes = new Uint8Array(rest.subarray(0, 8 * head.numbers)); // a copy, aligned
    yield { ...head, numbers: new Float64Array(bytes.buffer) };
    rest = rest.subarray(8 * head.numbers);
  }
  assert.equal(await ended, 0);
}

/** The same numbers, from the module. */
function numbers_of(motion) {
  const all = [], add = (...numbers) => { for (const number of numbers) all.push(number); };
  for (const { time, kind, cables, before, after, impulses } of motion.events) {
    add(time, KINDS.indexOf(kind), set_of(cables), ...before, ...after, ...impulses);
  }
  for (const { start, end, taut } of motion.arcs) add(start, end, set_of(taut));
  for (const one of motion.accumulations) add(one.start, one.limit, one.uncertainty, one.energy_lost, set_of(one.cables));
  for (const { time, rate, before, after, impulses } of motion.event_errors()) add(time, rate, ...before, ...after, ...impulses);
  add(motion.horizon, or_nan(motion.lock_error));
  for (const { from, until } of motion.unsure) add(from, until);
  const times = Float64Array.from({ length: INSTANTS + 1 }, (_, k) => motion.end_time * (k / INSTANTS));
  const states = motion.states(times), errors = motion.state_errors(times), { total } = motion.energy(times);
  const bounds = motion.energy_errors(times), tensions = motion.tensions(times), width = tensions.length / times.length;
  times.forEach((_, k) => add(...states.subarray(6 * k, 6 * k + 6), ...errors.subarray(6 * k, 6 * k + 6), total[k], bounds[k],
    ...tensions.subarray(width * k, width * k + width)));
  const { time, swing } = motion.settling;
  add(or_nan(time), or_nan(swing?.period), or_nan(swing?.amplitude), ENDINGS.indexOf(motion.ending));
  return all;
}

test("the shipped cases and 1,000 random systems have the bits of the native solver", async () => {
  const tautline = await load();
  let count = 0, events = 0;
  for await (const { case: the_case, options, numbers } of systems()) {
    const motion = tautline.solve(the_case, options);
    expect_same_bits(numbers_of(motion), numbers, the_case.name);
    events += motion.events.length;
    motion.dispose();
    ++count;
  }
  assert.ok(count > 1000 && events > 50_000, `${count} systems, ${events} events`);
});
