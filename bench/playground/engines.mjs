// The engines in a worker of their own: the plug-ins of engines/npm as the benchmark runs them. build.mjs puts their
// imports before this file, and engine_host.mjs in the place of the protocol.

import { engines, Unsupported } from "./engine_host.mjs";

/// The restitution of a cable as the protocol has it: a number, or a table over the speed.
function restitution({ restitution: e, restitution_table: table = [], capture_speed = 0 }) {
  if (capture_speed === 0) return table.length > 0 ? table : e;
  const above = table.filter(([speed]) => speed > capture_speed), before = table.findLast(([speed]) => speed <= capture_speed);
  const between = before && above.length > 0
    ? before[1] + ((capture_speed - before[0]) / (above[0][0] - before[0])) * (above[0][1] - before[1]) : undefined;
  return [[0, 0], [capture_speed, 0], [capture_speed, between ?? before?.[1] ?? above[0]?.[1] ?? e], ...above];
}

const MOST_STEPS = 2_000_000;

/// The run of a model up to the end of the case: rows of states, and of the impulse of each cable in each step.
function run({ the_case, engine, model, rate, law, end }) {
  const found = engines.get(engine)?.models.find(({ name }) => name === model);
  if (!found) throw new Unsupported(`this page has no model ${model} of ${engine}`);
  const cables = the_case.cables.map((cable) => ({ ...cable, restitution: restitution(cable) }));
  const step = 1 / rate, steps = Math.ceil(end * rate - 1e-9), began = performance.now();
  if (!(steps <= MOST_STEPS)) throw new Unsupported(`${end} s are ${steps} steps: the page takes at most ${MOST_STEPS}`);
  const states = new Float64Array(6 * (steps + 1)), impulses = new Float64Array(cables.length * steps);
  const one = found.start({ ...the_case, cables }, { step, law, parameters: {} });
  let done = 0;
  try {
    states.set(one.state());
    for (; done < steps && !one.stopped; ++done) {
      impulses.set(one.step(step), cables.length * done);
      states.set(one.state(), 6 * (done + 1));
    }
  } catch (error) { // what was done up to there is drawn
    if (done === 0) throw error;
    return { rate, steps: done, states, impulses, took: performance.now() - began, refused: error.message };
  } finally {
    one.free?.();
  }
  return { rate, steps: done, states, impulses, took: performance.now() - began };
}

onmessage = ({ data }) => {
  try {
    postMessage({ answer: run(data) });
  } catch (error) {
    postMessage({ answer: { refused: error.message } });
  }
};
postMessage({ engines: [...engines.values()].map(({ name, version, precision, models }) => ({ name, version, precision,
  models: models.filter(({ drive }) => drive === "steps").map(({ name, sentence }) => ({ name, sentence })) })) });
