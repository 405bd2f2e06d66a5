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
    const wanted = rows.map((row, i) => wantedRate(row, cables[i], options.step, changeInStep(theCase.gravity, cables[i], row, before, dt)));
    const impulses = pull(world, theCase, rows, acting, wanted, rows.map(({ nx, ny }) => dt * (nx * gx + ny * gy)));
    world.step(dt);
    moveOutOfOverstretch(world, theCase, options.step, dt);
    return impulses;
  });
}

/** Whether a row acts in a step of `dt` [s]. Gravity in this step is left out, as engines do. */
export const acts = ({ gap, rate }, early, dt) => gap <= 0 || (early && gap < -rate * dt);

/** By how much the gap rate of `row` changes at most in a step in which its cable is not hit [m/s]: by gravity and swing. */
export function changeInStep([gx, gy], { length }, { nx, ny, px, py, gap }, [x, y, , vx, vy, spin], dt) {
  const rx = px - x, ry = py - y, distance = length - gap, across = nx * (vy + spin * rx) - ny * (vx - spin * ry);
  const turned = distance > 0 ? (across * across) / distance + spin * spin * (nx * rx + ny * ry) : 0;
  return dt * (Math.abs(turned) + Math.abs(nx * gx + ny * gy));
}

/** The gap rate that a row asks for [m/s]: its bounce, or `most` at most of the speed that takes out a part of the overstretch. */
export function wantedRate({ gap, rate }, cable, step, most) {
  return Math.max(restitution(cable, rate) * Math.max(0, -rate), Math.min(most, (usualCorrection / step) * Math.max(0, -gap)));
}

/**
 * Moves the body out of what rows leave of the overstretch, without a change of its velocity: that would be a rebound.
 * A cable that is about to be hit takes no part; one from which the body comes back by itself is left to it.
 */
function moveOutOfOverstretch(world, theCase, step, dt) {
  const state = world.state(), correction = usualCorrection / step;
  const holding = theCase.cables.flatMap((cable) => {
    const row = cableRow(cable, state), most = changeInStep(theCase.gravity, cable, row, state, dt);
    if (row.gap > 0 || row.rate < -most) return [];
    return [{ row, by: Math.max(0, dt * (-correction * row.gap - Math.max(most, row.rate))) }];
  });
  if (!holding.some(({ by }) => by > 0)) return;
  const { mass, inertia } = theCase.body, moved = [...state];
  impulsesFor(holding.map(({ row }) => row), theCase.body, holding.map(({ by }) => by)).forEach((push, i) => {
    const { nx, ny, moment } = holding[i].row;
    moved[0] += (push * nx) / mass;
    moved[1] += (push * ny) / mass;
    moved[2] += inertia > 0 ? (push * moment) / inertia : 0;
  });
  world.place(moved);
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

/**
 * The engine's own limit, or `rows` of its solver that ask for `wantedRate`. `prepare(world, state, cables)` switches it
 * before each step where a user would.
 */
export function startLimit(engine, theCase, { prepare, pullsSlack, left, ...options }) {
  return run(engine, theCase, { ...options, limit: options.limit ?? true }, (world, before, dt) => {
    prepare?.(world, before, theCase.cables);
    world.step(dt);
    const pulls = world.pulls?.(dt);
    if (options.rows && options.rows !== "contact") moveOutOfOverstretch(world, theCase, options.step, dt);
    return pulls ?? impulsesSeen(engine, theCase, before, world.state(), dt, { pullsSlack, left });
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
