// Models with fixed steps. What they need of an engine is a world, one body of a case:
//
//   state()                 [x, y, angle, vx, vy, spin], the angle not wrapped
//   place(state)
//   setVelocity(vx, vy, spin)
//   push(jx, jy, px, py)    an impulse [N s] at a point of the world, felt at once
//   step(dt)                the engine's own
//   pulls(dt)               of an engine that tells: the impulses [N s] of its cables over the latest step
//   free()                  of an engine on WebAssembly's heap
//
// `engine` is {world(case, options), precision, flight}; `flight` is described in flight.mjs.

import { cableRow, restitution } from "../../protocol/javascript/cable.mjs";
import { impulsesBehind, impulsesFor } from "./impulses.mjs";
import { checkCaps, checkNumbers, initialState } from "./caps.mjs";
import { kick } from "./flight.mjs";

/** The part of an overstretch that is taken out in one step [-], as engines do unless told otherwise. */
const usualCorrection = 0.2;

/** A change of momentum below this part of the body's own is the rounding of a step [-]. */
const unseen = { float64: 1e-10, float32: 1e-5 };

/** A cable can have pulled in a step where its gap was no larger than so many of its moves in a step [-], ... */
const reach = 2;

/** ... or than this part of its length [-], which is some roundings in float. */
const touching = 1e-6;

/** What is common to the runs: each step looks at the caps of the engine first. */
function run(engine, theCase, options, step) {
  checkNumbers(engine, theCase);
  checkCaps(engine, theCase, initialState(theCase), options.step);
  const world = engine.world(theCase, options);
  world.place(initialState(theCase));
  let now = world.state(); // to read it costs some engines as much as to step
  return {
    state: () => now,
    step(dt) {
      checkCaps(engine, theCase, now, dt);
      const impulses = step(world, now, dt);
      now = world.state();
      return impulses;
    },
    free: () => world.free?.(),
  };
}

/** Pushes the body along the cables of `which`, such that each gap rate is `wanted` [m/s] at least after `kicks`. */
function pull(world, { body }, rows, which, wanted, kicks) {
  const impulses = rows.map(() => 0);
  if (which.length === 0) return impulses;
  const found = impulsesFor(which.map((i) => rows[i]), body, which.map((i) => wanted[i] - kicks[i] - rows[i].rate));
  which.forEach((i, k) => {
    if (!(found[k] > 0)) return;
    impulses[i] = found[k];
    world.push(found[k] * rows[i].nx, found[k] * rows[i].ny, rows[i].px, rows[i].py);
  });
  return impulses;
}

/** Pulls by impulses from outside before the step; `early` also where the step would pass zero gap. */
export function startRow(engine, theCase, { early = false, ...options }) {
  const { cables, gravity: [gx, gy] } = theCase;
  return run(engine, theCase, options, (world, before, dt) => {
    const rows = cables.map((cable) => cableRow(cable, before));
    const acting = [...rows.keys()].filter((i) => acts(rows[i], early, dt));
    const wanted = rows.map((row, i) => wantedRate(row, cables[i], options.step));
    const impulses = pull(world, theCase, rows, acting, wanted, rows.map(({ nx, ny }) => dt * (nx * gx + ny * gy)));
    world.step(dt);
    return impulses;
  });
}

/** Whether a row acts in a step of `dt` [s]. Gravity in this step is left out, as engines do. */
export const acts = ({ gap, rate }, early, dt) => gap <= 0 || (early && gap < -rate * dt);

/** The gap rate that a row asks for [m/s]: its bounce, or the speed that takes out a part of the overstretch. */
export function wantedRate({ gap, rate }, cable, step) {
  return Math.max(restitution(cable, rate) * Math.max(0, -rate), (usualCorrection / step) * Math.max(0, -gap));
}

const undamped = () => [1, 1];

/**
 * The impulses behind a step that no reaction tells of. One that is no more than rounding is zero, and so is that of a
 * cable too slack to have pulled, unless the limit is one that `pullsSlack` cables too. `left(dt)` are the parts of velocity
 * and spin [-] that the engine's damping leaves in a step.
 */
function impulsesSeen(engine, { body, cables, gravity }, before, after, dt, { pullsSlack = false, left = undamped } = {}) {
  const rows = cables.map((cable) => cableRow(cable, before));
  const [linear, angular] = left(dt), [gx, gy] = gravity;
  const jump = [after[3] - linear * (before[3] + dt * gx), after[4] - linear * (before[4] + dt * gy), after[5] - angular * before[5]];
  const speed = Math.hypot(before[3], before[4]) + dt * Math.hypot(...gravity);
  const noise = unseen[engine.precision] * (body.mass * speed + Math.sqrt(body.mass * body.inertia) * Math.abs(before[5]));
  return impulsesBehind(rows, body, jump).map((impulse, i) => {
    const near = rows[i].gap < reach * Math.abs(rows[i].rate) * dt + touching * cables[i].length;
    return (near || pullsSlack) && impulse > noise ? impulse : 0;
  });
}

/** The engine's own limit. `prepare(world, state, cables)` switches it before each step where a user would. */
export function startLimit(engine, theCase, { prepare, pullsSlack, left, ...options }) {
  return run(engine, theCase, { ...options, limit: options.limit ?? true }, (world, before, dt) => {
    prepare?.(world, before, theCase.cables);
    world.step(dt);
    return world.pulls?.(dt) ?? impulsesSeen(engine, theCase, before, world.state(), dt, { pullsSlack, left });
  });
}

/**
 * The engine's own limit, and after a step in which it pulled, impulses up to the bounce that the step's start asked
 * for. Between the bounces the body flies the parabola.
 */
export function startBounce(engine, theCase, options) {
  const { cables, gravity } = theCase, half = 0.5 / engine.flight.substeps;
  return run(engine, theCase, { ...options, limit: options.limit ?? true }, (world, before, dt) => {
    kick(world, before, gravity, -half * dt);
    world.step(dt);
    kick(world, world.state(), gravity, half * dt);
    const now = world.state();
    const own = world.pulls?.(dt) ?? impulsesSeen(engine, theCase, before, now, dt);
    const wanted = cables.map((cable) => {
      const { rate } = cableRow(cable, before);
      return restitution(cable, rate) * Math.max(0, -rate);
    });
    const pulled = [...own.keys()].filter((i) => own[i] > 0);
    const more = pull(world, theCase, cables.map((cable) => cableRow(cable, now)), pulled, wanted, own.map(() => 0));
    return own.map((impulse, i) => impulse + more[i]);
  });
}
