// The mechanics of a system in space, for the models of this folder. A state is {time, bodies}, as the kit has bodies. What the models
// need of an engine is `system(system, options)`, bodies without cables unless `options.limit` asks for the engine's own:
//
//   bodies                    of each: read(), {position, orientation, velocity, turning}, of which the last is the spin in world axes;
//                             place(position, orientation); setVelocity(velocity, turning)
//   setGravity(gravity)       [m/s^2]
//   prepare(time, dt)         of an engine's own cables: where ends and lengths are at the end of a step
//   step(dt), pulls(dt), free()    as in the plane

import { actsAt, bodiesOf, cross, dot, followed, given, norm, normalized, numbersOf, plus, rotated, rotatedBack, systemRow, turned } from "../../protocol/javascript/space.mjs";
import { checkMotion } from "./caps.mjs";
import { partsOf } from "./flight.mjs";
import { impulsesOfMany } from "./impulses.mjs";
import { unseen } from "./plane.mjs";

const still = [0, 0, 0], level = [1, 0, 0, 0];
const times = (v, factor) => v.map((number) => factor * number);

/** One over mass and moments, six numbers a body; a point mass is not turned. */
const inverses = ({ bodies }) => bodies.flatMap(({ mass, inertia }) => [...still.map(() => 1 / mass), ...inertia.map((one) => (one > 0 ? 1 / one : 0))]);

/** An entry of J M^-1 J^T, or what a wrench makes of a change of motion. */
const along = (a, b, scale) => a.reduce((sum, number, k) => sum + number * scale[k] * b[k], 0);

/** The moment that turning gives [N m], in the axes of the body. */
const gyroscopic = (inertia, spin) => cross(inertia.map((one, k) => one * spin[k]), spin);

/** What a linear drag of `rate` [1/s] adds to the rate of `speed`, which grows by `growth` a second: the mean of `dt` [s], exactly. */
function braking(speed, growth, rate, dt) {
  const x = rate * dt, lost = -Math.expm1(-x);
  return x > 0 ? (-lost * speed + (lost / x - 1) * dt * growth) / dt : -rate * speed;
}

/** The accelerations that forces, moments and drag give `body` of a system in the middle of a step, without gravity: in the world, and in its own axes. */
function loadOf({ mass, inertia, drag, spin_drag, force, moment }, { orientation, velocity, spin }, gravity, time, dt) {
  const pushed = times(given(force, time + dt / 2)[0], 1 / mass);
  const linear = pushed.map((one, k) => one + braking(velocity[k], one + gravity[k], drag / mass, dt));
  if (!(inertia[0] > 0)) return { linear, angular: still };
  const turning = rotatedBack(orientation, given(moment, time + dt / 2)[0]).map((one, k) => one / inertia[k]);
  return { linear, angular: turning.map((one, k) => one + braking(spin[k], one, spin_drag / inertia[k], dt)) };
}

const isFree = ({ drag, spin_drag, force, moment }) => drag === 0 && spin_drag === 0 && [force, moment].every(({ pieces, waves }) => pieces.length + waves.length === 0);

/** What a step of `dt` [s] gives each body: gravity, and {linear, angular} of its load. */
function stepOf({ bodies, gravity }, state, dt) {
  const fall = given(gravity, state.time + dt / 2)[0];
  return { fall, loads: bodies.map((body, i) => (isFree(body) ? undefined : loadOf(body, state.bodies[i], fall, state.time, dt))) };
}

/** Whether the length of a cable or an end of it changes by itself. */
const isMoved = ({ length, ends }) => [length, ...ends.map(({ motion }) => motion)].some((one) => one && (one.pieces.length > 1 || one.waves.length > 0 || one.pieces[0]?.polynomial.length > 1));

/** The rate [m/s] that ends and length alone give the gap of a cable at `time` [s]. */
const givenRate = (cable, bodies, time) => (isMoved(cable) ? systemRow(cable, bodies.map((body) => ({ ...body, velocity: still, spin: still })), time).rate : 0);

/**
 * `body` of an engine, which flies each step from the origin without a turn. An engine in float rounds the pose in each step, some to one
 * side: near the origin that is little. `from` adds up the ways of the steps, in doubles. `bringHome` follows each step.
 */
function flownFromHome(body) {
  let from = { position: still, orientation: level };
  const read = () => {
    const { position, orientation, velocity, turning } = body.read();
    return { position: plus(from.position, position), orientation: followed(from.orientation, normalized(orientation)), velocity, turning: rotated(from.orientation, turning) };
  };
  const place = (position, orientation) => {
    from = { position, orientation: normalized(orientation) };
    body.place(still, level);
  };
  return {
    read,
    place,
    setVelocity: (velocity, turning) => body.setVelocity(velocity, rotatedBack(from.orientation, turning)),
    /** Set the velocity after it. */
    bringHome() {
      const { position, orientation } = read();
      place(position, orientation);
    },
  };
}

/** The world of `engine` with a clock, whose bodies carry what is given over time. */
function worldOf(engine, system, options) {
  const bare = engine.system(system, options);
  if (options.exact && engine.precision === "float32") bare.bodies = bare.bodies.map(flownFromHome);
  let time = 0;
  const setVelocity = (i, { orientation, velocity, spin }) => bare.bodies[i].setVelocity(velocity, rotated(orientation, spin));
  const world = {
    state: () => ({ time, bodies: bare.bodies.map((body) => {
      const { position, orientation, velocity, turning } = body.read(), q = normalized(orientation);
      return { position, orientation: q, velocity, spin: rotatedBack(q, turning) };
    }) }),
    place(state) {
      time = state.time;
      state.bodies.forEach((body, i) => {
        bare.bodies[i].place(body.position, body.orientation);
        setVelocity(i, body);
      });
    },
    setVelocity,
    turningOf: (i) => bare.bodies[i].read().turning,
    bringHome: () => bare.bodies.forEach((body) => body.bringHome?.()),
    setTurning: (i, velocity, turning) => bare.bodies[i].setVelocity(velocity, turning),
    /** The engine's own step under `fall`, its gravity. */
    advance(dt, fall) {
      bare.setGravity(fall);
      bare.prepare?.(time, dt);
      bare.step(dt);
      time += dt;
    },
    /** The same, after the impulses of all loads. */
    step(dt) {
      const state = world.state(), { fall, loads } = stepOf(system, state, dt);
      loads.forEach((load, i) => {
        const { velocity, spin } = state.bodies[i];
        if (load) setVelocity(i, { ...state.bodies[i], velocity: plus(velocity, load.linear, dt), spin: plus(spin, load.angular, dt) });
      });
      world.advance(dt, fall);
    },
    pulls: bare.pulls && ((dt) => bare.pulls(dt)),
    free: () => bare.free?.(),
  };
  return world;
}

export const space = {
  initial: ({ initial }) => ({ time: 0, bodies: bodiesOf(initial) }),
  numbers: ({ bodies }) => numbersOf(bodies),
  stateOf: (numbers, time) => ({ time, bodies: bodiesOf(numbers) }),
  world: worldOf,

  checkCaps(engine, system, { time, bodies }, dt) {
    const gained = dt * norm(given(system.gravity, time)[0]);
    checkMotion(engine, Math.max(...bodies.map(({ velocity }) => norm(velocity))) + gained, Math.max(...bodies.map(({ spin }) => norm(spin))), dt);
  },
  row: ({ cables }, index, { bodies, time }) => systemRow(cables[index], bodies, time),
  length: (system, index, { length }) => length,
  changeInStep(system, index, { wrench, acceleration }, { time, bodies }, dt) {
    const fall = given(system.gravity, time)[0];
    const free = system.bodies.flatMap((body, i) => {
      const { linear, angular } = loadOf(body, bodies[i], fall, time, 0);
      const turning = gyroscopic(body.inertia, bodies[i].spin);
      return [...plus(fall, linear), ...angular.map((one, k) => (body.inertia[k] > 0 ? one + turning[k] / body.inertia[k] : 0))];
    });
    return dt * (Math.abs(acceleration) + Math.abs(wrench.reduce((sum, number, k) => sum + number * free[k], 0)));
  },
  kick(system, index, { wrench }, state, dt) {
    const { fall, loads } = stepOf(system, state, dt), cable = system.cables[index];
    const gain = loads.flatMap((load) => [...plus(fall, load?.linear ?? still), ...(load?.angular ?? still)]);
    const moved = givenRate(cable, state.bodies, state.time + dt) - givenRate(cable, state.bodies, state.time);
    return moved + dt * wrench.reduce((sum, number, k) => sum + number * gain[k], 0);
  },

  impulsesFor(system, rows, rise) {
    const inverse = inverses(system);
    return impulsesOfMany(rows, rise, (a, b) => along(a.wrench, b.wrench, inverse));
  },
  push(world, { wrench }, impulse, system) {
    const inverse = inverses(system), { bodies } = world.state();
    bodies.forEach((body, i) => {
      const [linear, angular] = [0, 3].map((k) => [0, 1, 2].map((axis) => wrench[6 * i + k + axis] * inverse[6 * i + k + axis]));
      if (dot(linear, linear) > 0) world.setVelocity(i, { ...body, velocity: plus(body.velocity, linear, impulse), spin: plus(body.spin, angular, impulse) });
    });
  },
  moved(system, { time, bodies }, rows, pushes) {
    const inverse = inverses(system);
    const by = inverse.map((one, k) => one * rows.reduce((sum, { wrench }, i) => sum + pushes[i] * wrench[k], 0));
    return { time, bodies: bodies.map((body, i) => ({ ...body, position: plus(body.position, by.slice(6 * i, 6 * i + 3)), orientation: turned(body.orientation, by.slice(6 * i + 3, 6 * i + 6)) })) };
  },

  jumps({ precision, gyroscopicTerm }, system, rows, before, after, dt, left = () => [1, 1]) {
    const [linear, angular] = left(dt), { fall, loads } = stepOf(system, before, dt);
    let noise = 0;
    const jump = system.bodies.flatMap(({ mass, inertia }, i) => {
      const was = before.bodies[i], now = after.bodies[i], load = loads[i] ?? { linear: still, angular: still };
      const gained = plus(now.velocity, plus(was.velocity, plus(fall, load.linear), dt), -linear);
      // in the axes in which the body was: the engine's own turning has changed the spin by its term, but for what is of second order
      const spin = rotatedBack(was.orientation, rotated(now.orientation, now.spin)), size = norm(was.spin);
      const term = gyroscopicTerm ? gyroscopic(inertia, was.spin).map((one, k) => (inertia[k] > 0 ? one / inertia[k] : 0)) : still;
      const turned = plus(spin, plus(was.spin, plus(load.angular, term), dt), -angular);
      const moment = Math.max(...inertia), gyration = Math.sqrt(moment / mass);
      noise += unseen[precision] * (mass * (norm(was.velocity) + dt * norm(fall)) + mass * gyration * size);
      if (inertia[0] > 0) noise += (dt * size) ** 2 * norm(gyroscopic(inertia, was.spin)) * dt / gyration;
      return [...gained, ...(inertia[0] > 0 ? turned : still)];
    });
    return { jumps: rows.map(({ wrench }) => wrench.reduce((sum, number, k) => sum + number * jump[k], 0)), noise };
  },

  kickBy(world, system, state, dt, part) {
    const { fall } = stepOf(system, state, dt);
    state.bodies.forEach((body, i) => world.setVelocity(i, { ...body, velocity: plus(body.velocity, fall, part * dt) }));
  },

  /**
   * Flies `dt` [s] from `start`: gravity as in the plane, half of the loads before and half after each step of the engine, and the turn is
   * the engine's own. A spin that was set for the step is taken back, but for what the engine has changed of it.
   */
  fly(engine, world, system, start, dt) {
    const flight = { ...engine.flight, ...engine.flight.inSpace }, { substeps, spinFor } = flight;
    const gained = dt * norm(given(system.gravity, start.time)[0]);
    const parts = Math.max(...start.bodies.map(({ velocity, spin }) => partsOf(flight, norm(velocity) + gained, norm(spin), dt)));
    const h = dt / parts;
    for (let part = 0, now = start; part < parts; ++part) {
      if (part > 0) now = world.state();
      const { fall, loads } = stepOf(system, now, h);
      const half = (i, { velocity, spin, ...pose }, sign) => {
        const { linear, angular } = loads[i] ?? { linear: still, angular: still };
        return { ...pose, velocity: plus(plus(velocity, linear, h / 2), fall, (sign * h) / (2 * substeps)), spin: plus(spin, angular, h / 2) };
      };
      const begun = now.bodies.map((body, i) => half(i, body, -1)), set = begun.map(({ orientation, velocity, spin }, i) => {
        const size = norm(spin), factor = spinFor && size > 0 ? spinFor(size, h) / size : 1, turning = rotated(orientation, spin);
        world.setTurning(i, velocity, times(turning, factor));
        return { turning, factor, given: world.turningOf(i) };
      });
      world.advance(h, fall);
      const flown = world.state().bodies, turnings = flown.map((_, i) => world.turningOf(i));
      world.bringHome();
      flown.forEach((body, i) => {
        const { turning, factor, given: was } = set[i], { inertia: [first, ...others] } = system.bodies[i];
        const keeps = engine.precision === "float32" && others.every((moment) => moment === first); // a change is rounding
        const changed = keeps ? still : plus(turnings[i], was, -1);
        const own = plus(turning, changed, 1 / factor);
        world.setVelocity(i, half(i, { ...body, spin: rotatedBack(body.orientation, own) }, 1));
      });
    }
  },
};

/** Throws a sentence where a cable does not go straight from a body to another one, or to the world; `whose` cable does no more. */
export function checkStraight({ cables }, whose, Unsupported) {
  cables.forEach(({ ends }, i) => {
    if (ends.length > 2 || ends[0].body === ends[1].body) throw new Unsupported(`${whose} goes straight from a body to another one or to the world, cable ${i} does not`);
  });
}

/** The ends of straight cables, the one in the world first, with its body of the engine: `ground`, or a hook of its own where it moves. */
export function pairsOf({ cables }, bodies, ground, createHook) {
  return cables.map((cable) => {
    const hooks = cable.ends.map((end) => (isGiven(end) ? createHook(endAt(end, 0)) : undefined));
    const ends = cable.ends.map((end, k) => ({ end, hook: hooks[k], body: end.body !== undefined ? bodies[end.body] : hooks[k] ?? ground, at: hooks[k] ? still : end.at }));
    return { cable, ends: ends.sort((a, b) => (a.end.body === undefined ? 0 : 1) - (b.end.body === undefined ? 0 : 1)) };
  });
}

/** An end in the world that moves. */
export const isGiven = ({ motion }) => motion !== undefined && motion.pieces.length + motion.waves.length > 0;

/** An end as `prepare` wants it: where it is in the world at `time` [s], or in the frame of its body. */
export const endAt = ({ at, motion }, time) => (motion ? plus(at, given(motion, time)[0]) : at);
export const lengthAt = ({ length }, time) => given(length, time, 1)[0][0];
export { actsAt, isMoved };
