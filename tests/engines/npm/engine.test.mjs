// node engine.test.mjs ENGINE: one engine of engines/npm over the protocol. Exit code 77 says that its package is not here.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { cableRow } from "../../../engines/protocol/javascript/cable.mjs";
import { engineFolder, isFetched, startChild } from "./client.mjs";
import { expected } from "./expected.mjs";
import { exact, firstImpact, flown, standardCase, stateOf } from "./standard_case.mjs";

const name = process.argv[2];
if (!isFetched(name)) {
  console.log(`skipped: the package of ${name} is not here; scripts/install-packages npm-engines brings it`);
  process.exit(77);
}

let child, info;
before(async () => {
  child = startChild(engineFolder(name));
  info = await child.ask("info");
});
after(() => child.end());

const start = (model, step, theCase = standardCase, parameters = undefined) =>
  child.ask("start", { case: theCase, model, step, law: "simultaneous", parameters });

/** Runs up to `until` [s] and calls visit(time, before, after, impulses) for each step. */
async function run(model, step, until, visit, parameters, theCase = standardCase) {
  let { state } = await start(model, step, theCase, parameters);
  const count = Math.round(until / step);
  for (let done = 0; done < count; ) {
    const { steps } = await child.ask("step", { dt: step, count: Math.min(100, count - done) });
    for (const row of steps) {
      visit(++done * step, state, row.slice(0, 6), row.slice(6));
      state = row.slice(0, 6);
    }
  }
}

/** A cable that pulls for longer is held taut [steps]; the longest bounce, a spring's, has some 20. */
const longestBounce = 25;

/** The largest distance from the exact motion, and of the first impact its start and its rebound. */
async function measured(model, step, parameters, theCase = standardCase) {
  const result = { deviation: 0, struck: undefined, rebound: undefined };
  let closing, open = true, steps = 0;
  await run(model, step, 2, (time, was, now, [impulse]) => {
    const [x, y] = exact(time);
    result.deviation = Math.max(result.deviation, Math.hypot(now[0] - x, now[1] - y));
    if (!open || (impulse === 0 && closing === undefined)) return;
    open = impulse > 0 && ++steps <= longestBounce;
    if (!open) return;
    const rate = (state) => cableRow(standardCase.cables[0], state).rate;
    result.struck ??= time - step;
    closing ??= -rate(was);
    result.rebound = Math.max(result.rebound ?? -Infinity, rate(now) / closing);
  }, parameters, theCase);
  return result;
}

/** Rebounds that no digit of `expected` tells apart. */
const sameRebound = 0.02;

/** Within a factor of 2, or as near as `same`. */
function near(found, wanted, what, same = 0) {
  assert.ok(Math.abs(found - wanted) <= same || (found < 2 * wanted && found > wanted / 2), `${what}: ${found}, expected about ${wanted}`);
}

test("says what it is, and of every setting why", () => {
  assert.equal(info.protocol, 2);
  assert.equal(info.name, name);
  assert.match(info.version, /^\d+\.\d+/);
  assert.match(info.precision, /^float(32|64)$/);
  for (const model of info.models) {
    assert.match(model.name, /^[a-z0-9-]+$/);
    assert.match(model.sentence, /\.$/, model.name);
    for (const { name: of, value, reason, origin } of model.settings) {
      assert.ok(of && value && /\.$/.test(reason), `${model.name}: ${of}`);
      assert.match(origin, /^(engine_default|engine_demo|ours)$/, `${model.name}: ${of}`);
    }
  }
  const steps = info.models.filter(({ drive }) => drive === "steps").map((model) => model.name);
  assert.deepEqual(steps.sort(), Object.keys(expected[name]).sort());
});

for (const [model, { deviation, rebound }] of Object.entries(expected[name] ?? {})) {
  test(`${model} is as far from the exact motion as it was measured to be`, async () => {
    for (const [k, step] of [1e-2, 1e-3, 1e-4].entries()) {
      if (deviation[k] === undefined && rebound?.[k] === undefined) continue;
      const found = await measured(model, step);
      if (deviation[k] !== undefined) near(found.deviation, deviation[k], `deviation at ${step}`);
      if (rebound?.[k] === undefined) continue;
      near(found.rebound, rebound[k], `rebound at ${step}`, sameRebound);
      assert.ok(Math.abs(found.struck - firstImpact) <= 2 * step, `first impact at ${found.struck}, exact ${firstImpact}`);
    }
  });
}

test("is not thrown back by the overstretch where nothing rebounds", async () => {
  const step = 1e-3, most = 0.05; // gravity and swing give 0.02 of the closing speed in a step, a fifth of the overstretch up to 0.2
  const dead = { ...standardCase, cables: standardCase.cables.map((cable) => ({ ...cable, restitution: 0 })) };
  for (const { name: model } of info.models) {
    if (!/^(solver-)?(row|early)/.test(model)) continue;
    const { rebound } = await measured(model, step, undefined, dead);
    assert.ok(rebound <= most, `${model}: ${rebound} of the closing speed`);
  }
});

test("rebounds otherwise with another value of each parameter", async () => {
  const step = 1e-3, told = 0.02;
  for (const { name: model, parameters = [], code } of info.models) {
    const middle = Object.fromEntries(parameters.map(({ name: of, low, high, scale, step_power: power = 0 }) =>
      [of, (scale === "log" ? Math.sqrt(low * high) : (low + high) / 2) * step ** power]));
    const { rebound } = parameters.length ? await measured(model, step, middle) : {};
    for (const { name: of, high, step_power: power = 0 } of parameters) {
      assert.ok(code.includes(`{${of}}`), `${model}: its code sets no ${of}`);
      const other = await measured(model, step, { ...middle, [of]: high * step ** power });
      assert.ok(Math.abs(other.rebound - rebound) > told, `${model}: e = ${rebound}, and with the largest ${of} ${other.rebound}`);
    }
  }
});

/** What the steps of an engine add to the damping ratio of a spring, in units of its frequency times the step [-]. */
const dampingOfSteps = { jolt: 0.5, mujoco3: 0 };

/** Restitution, duration and peak of a contact of a spring without a load, the last two in units of its frequency: (E5), (E6) and (E8). */
function contactOf(ratio) {
  const root = Math.sqrt(1 - ratio ** 2), phase = 2 * Math.acos(ratio) / root;
  return { restitution: Math.exp(-ratio * phase), phase, peak: Math.exp(-ratio * (Math.PI / 2 - 3 * Math.asin(ratio)) / root) };
}

test("bounces as the spring that it tells of, damped by its steps, too", async () => {
  const frequency = 70, ratio = 0.1; // 45 steps of 1 ms in a contact
  let tested = 0;
  for (const { name: model, parameters = [] } of info.models) {
    const [damping, of] = parameters.map((parameter) => parameter.name).sort();
    const told = { frequency: { frequency: frequency / (2 * Math.PI), damping: ratio }, stiffness: { stiffness: frequency ** 2, damping: 2 * ratio * frequency } }[of];
    if (!(damping === "damping" && told) && !model.startsWith("limit-spring")) continue; // that has the spring of its restitution
    ++tested;
    const same = told ? 0.02 : 0.03; // that is twice as much damped
    for (const step of [1e-3, 2e-4]) {
      const theCase = { name: "pull", duration: 1, gravity: [0, 0], body: { mass: 2, inertia: 0.01 }, cables: [{ anchor: [0, 0], attachment: [0, 0], length: 1, restitution: 0.5 }],
        initial: { position: [0.9, 0], angle: 0, velocity: [1, 0], spin: 0 } };
      const [row, ...others] = (await start(model, step, theCase, told)).soft;
      assert.equal(others.length, 0);
      if (told) assert.ok(Math.abs(row.stiffness / frequency ** 2 - 1) < 1e-9 && Math.abs(row.damping / (2 * ratio * frequency) - 1) < 1e-9, `${model} tells ${JSON.stringify(row)}`);
      const own = Math.sqrt(row.stiffness);
      const found = { restitution: 0, phase: 0, peak: 0 };
      await run(model, step, 0.2, (time, before, now, [impulse]) => {
        if (impulse > 0) found.phase += own * step;
        found.peak = Math.max(found.peak, impulse / step / (theCase.body.mass * own));
        found.restitution = -now[3];
      }, told, theCase);
      const wanted = contactOf(row.damping / (2 * own) + dampingOfSteps[name] * own * step);
      for (const key of Object.keys(wanted)) {
        // a duration is a whole number of steps
        const allowed = same * wanted[key] + (key === "phase" ? own * step : 0);
        assert.ok(Math.abs(found[key] - wanted[key]) <= allowed, `${model} at ${step}: ${key} ${found[key]}, of the spring ${wanted[key]}`);
      }
    }
  }
  assert.equal(tested > 0, name in dampingOfSteps);
});

test("flies the parabola, and solves an impact, as exactly as its numbers let it", async () => {
  const rounding = info.precision === "float64" ? 1e-14 : 1e-6;
  for (const dt of [1e-2, 1e-3, 1e-6]) {
    const { state } = await start("event", 1e-2);
    const flownTo = (await child.ask("fly", { dt })).state;
    flown(state, dt).forEach((value, k) => assert.ok(Math.abs(flownTo[k] - value) <= 4 * rounding, `${k} after ${dt}: ${flownTo[k]}, not ${value}`));
  }
  for (const body of [standardCase.body, { mass: 12, inertia: 0.5 }, { mass: 800, inertia: 1100 }]) {
    await start("event", 1e-2, { ...standardCase, body });
    const { state } = await child.ask("place", { state: [0.1, 0.1, 0.3, 0.2, -0.4, 2.5] });
    const rates = standardCase.cables.map((cable) => Math.abs(cableRow(cable, state).rate));
    const solved = await child.ask("solve", { cables: [0, 1], rates });
    standardCase.cables.forEach((cable, i) => {
      assert.ok(solved.impulses[i] >= 0);
      const missed = rates[i] - cableRow(cable, solved.state).rate;
      assert.ok(missed <= 20 * rounding && (solved.impulses[i] === 0 || missed >= -20 * rounding), `cable ${i} of a body of ${body.mass} kg misses its rate by ${missed}`);
    });
  }
});

test("keeps the whole turns of an angle", async () => {
  const turned = { ...standardCase, initial: { ...standardCase.initial, angle: 19.3, spin: 3 } };
  for (const { name: model } of info.models) {
    const { state } = await start(model, 1e-2, turned);
    assert.ok(Math.abs(state[2] - 19.3) < 1e-5, `${model} starts at ${state[2]}`);
  }
  const { state } = await child.ask("fly", { dt: 1e-2 }); // the last one is `event`
  assert.ok(Math.abs(state[2] - 19.33) < 1e-5, `it flies to ${state[2]}`);
});

test("repeats itself bit by bit, and gives back what a run held", async () => {
  const model = info.models[0].name, states = [];
  const runs = 150; // Box2D 3 has room for 127 worlds
  for (let k = 0; k < runs; ++k) {
    await start(model, 1e-3);
    const { steps } = await child.ask("step", { dt: 1e-3, count: 70 });
    states.push(JSON.stringify(steps.at(-1)));
  }
  assert.equal(new Set(states).size, 1);
});

test("refuses what it does not have, with a sentence", async () => {
  await assert.rejects(start("no-such-model", 1e-2), { code: -32602, message: /^unsupported: no model/ });
  const fast = { ...standardCase, initial: { ...standardCase.initial, velocity: [420, 0] } };
  if (/^(rapier|planck)/.test(name)) {
    await assert.rejects(start("row", 1e-2, fast), { code: -32602, message: /cuts a body's motion to (400 m\/s|2 m in a step)/ });
  } else {
    const { state } = await start("row", 1e-2, fast);
    const { steps } = await child.ask("step", { dt: 1e-4, count: 1 });
    assert.ok(Math.abs(steps[0][3] - stateOf(fast.initial)[3]) < 1e-3, `its speed of ${state[3]} is cut to ${steps[0][3]}`);
  }
});
