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
// `engine` is {world(case, options), precision, flight}; `flight` is described in flight.mjs. One whose limits are springs has
// soft(case, options), these as the protocol has them. An engine that runs systems in space
// has bodies of these, too, as space.mjs says.

import { restitution } from "../../protocol/javascript/cable.mjs";
import { checkNumbers } from "./caps.mjs";
import { kindOf } from "./kinds.mjs";

export { changeInStep } from "./plane.mjs";

/** The part of an overstretch that is taken out in one step [-], as engines do unless told otherwise. */
const usualCorrection = 0.2;

/** A cable can have pulled in a step where its gap was no larger than so many of its moves in a step [-], ... */
const reach = 2;

/** ... or than this part of its length [-], which is some roundings in float. */
const touching = 1e-6;

/** What is common to the runs: each step looks at the caps of the engine first. */
function run(engine, theCase, options, step) {
  const kind = kindOf(theCase), initial = kind.initial(theCase);
  checkNumbers(engine, theCase);
  kind.checkCaps(engine, theCase, initial, options.step);
  const world = kind.world(engine, theCase, options);
  world.place(initial);
  let now = world.state(); // to read it costs some engines as much as to step
  return {
    soft: engine.soft?.(theCase, options),
    state: () => kind.numbers(now),
    step(dt) {
      kind.checkCaps(engine, theCase, now, dt);
      const impulses = step(kind, world, now, dt);
      now = world.state();
      return impulses;
    },
    free: () => world.free?.(),
  };
}

/** Pushes along the cables of `which`, such that each gap rate is raised by `rise(i)` [m/s] at least. */
function pull(kind, world, theCase, rows, which, rise) {
  const impulses = rows.map(() => 0);
  if (which.length === 0) return impulses;
  const found = kind.impulsesFor(theCase, which.map((i) => rows[i]), which.map(rise));
  which.forEach((i, k) => {
    if (!(found[k] > 0)) return;
    impulses[i] = found[k];
    kind.push(world, rows[i], found[k], theCase);
  });
  return impulses;
}

/** The row of each cable. */
const rowsOf = (kind, theCase, state) => theCase.cables.map((_, i) => kind.row(theCase, i, state));

/** Pulls by impulses from outside before the step; `early` also where the step would pass zero gap. */
export function startRow(engine, theCase, { early = false, ...options }) {
  return run(engine, theCase, options, (kind, world, before, dt) => {
    const rows = rowsOf(kind, theCase, before);
    const acting = [...rows.keys()].filter((i) => acts(rows[i], early, dt));
    const wanted = (i) => wantedRate(rows[i], theCase.cables[i], options.step, kind.changeInStep(theCase, i, rows[i], before, dt));
    const impulses = pull(kind, world, theCase, rows, acting, (i) => wanted(i) - kind.kick(theCase, i, rows[i], before, dt) - rows[i].rate);
    world.step(dt);
    moveOutOfOverstretch(kind, world, theCase, options.step, dt);
    return impulses;
  });
}

/** Whether a row acts in a step of `dt` [s]. Gravity in this step is left out, as engines do. */
export const acts = ({ gap, rate }, early, dt) => gap <= 0 || (early && gap < -rate * dt);

/** The gap rate that a row asks for [m/s]: its bounce, or `most` at most of the speed that takes out a part of the overstretch. */
export function wantedRate({ gap, rate }, cable, step, most) {
  return Math.max(restitution(cable, rate) * Math.max(0, -rate), Math.min(most, (usualCorrection / step) * Math.max(0, -gap)));
}

/**
 * Moves the body out of what rows leave of the overstretch, without a change of its velocity: that would be a rebound.
 * A cable that is about to be hit takes no part; one from which the body comes back by itself is left to it.
 */
function moveOutOfOverstretch(kind, world, theCase, step, dt) {
  const state = world.state(), correction = usualCorrection / step;
  const holding = theCase.cables.flatMap((_, i) => {
    const row = kind.row(theCase, i, state);
    if (row.gap > 0) return [];
    const most = kind.changeInStep(theCase, i, row, state, dt);
    if (row.rate < -most) return [];
    return [{ row, by: Math.max(0, dt * (-correction * row.gap - Math.max(most, row.rate))) }];
  });
  if (!holding.some(({ by }) => by > 0)) return;
  const rows = holding.map(({ row }) => row);
  world.place(kind.moved(theCase, state, rows, kind.impulsesFor(theCase, rows, holding.map(({ by }) => by))));
}

/**
 * The impulses behind a step that no reaction tells of. One that is no more than rounding is zero, and so is that of a
 * cable too slack to have pulled, unless the limit is one that `pullsSlack` cables too. `left(dt)` are the parts of velocity
 * and spin [-] that the engine's damping leaves in a step.
 */
function impulsesSeen(kind, engine, theCase, before, after, dt, { pullsSlack = false, left } = {}) {
  const rows = rowsOf(kind, theCase, before);
  const { jumps, noise } = kind.jumps(engine, theCase, rows, before, after, dt, left);
  // by least squares in the kinetic energy: the solution opens each gap at least as fast as the jump does
  return kind.impulsesFor(theCase, rows, jumps).map((impulse, i) => {
    const near = rows[i].gap < reach * Math.abs(rows[i].rate) * dt + touching * kind.length(theCase, i, rows[i]);
    return (near || pullsSlack) && impulse > noise ? impulse : 0;
  });
}

/**
 * The engine's own limit, or `rows` of its solver that ask for `wantedRate`. `prepare(world, state, cables)` switches it
 * before each step where a user would.
 */
export function startLimit(engine, theCase, { prepare, pullsSlack, left, ...options }) {
  return run(engine, theCase, { ...options, limit: options.limit ?? true }, (kind, world, before, dt) => {
    prepare?.(world, before, theCase.cables);
    world.step(dt);
    const pulls = world.pulls?.(dt);
    if (options.rows && options.rows !== "contact") moveOutOfOverstretch(kind, world, theCase, options.step, dt);
    return pulls ?? impulsesSeen(kind, engine, theCase, before, world.state(), dt, { pullsSlack, left });
  });
}

/**
 * The engine's own limit, and after a step in which it pulled, impulses up to the bounce that the step's start asked
 * for. Between the bounces the body flies the parabola.
 */
export function startBounce(engine, theCase, options) {
  const half = 0.5 / engine.flight.substeps;
  return run(engine, theCase, { ...options, limit: options.limit ?? true }, (kind, world, before, dt) => {
    kind.kickBy(world, theCase, before, dt, -half);
    world.step(dt);
    kind.kickBy(world, theCase, world.state(), dt, half);
    const now = world.state();
    const own = world.pulls?.(dt) ?? impulsesSeen(kind, engine, theCase, before, now, dt);
    const wanted = theCase.cables.map((cable, i) => {
      const { rate } = kind.row(theCase, i, before);
      return restitution(cable, rate) * Math.max(0, -rate);
    });
    const pulled = [...own.keys()].filter((i) => own[i] > 0), rows = rowsOf(kind, theCase, now);
    const more = pull(kind, world, theCase, rows, pulled, (i) => wanted[i] - rows[i].rate);
    return own.map((impulse, i) => impulse + more[i]);
  });
}
