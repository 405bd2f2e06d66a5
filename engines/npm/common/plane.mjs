// The mechanics of a body in the plane, for the models of this folder. A state is [x, y, angle, vx, vy, spin]; space.mjs has the
// same of a system in space.

import { cableRow } from "../../protocol/javascript/cable.mjs";
import { checkMotion, fastest } from "./caps.mjs";
import { fly, kick } from "./flight.mjs";
import { impulsesFor, response } from "./impulses.mjs";

/** A change of momentum below this part of the body's own is the rounding of a step [-]. */
export const unseen = { float64: 1e-10, float32: 1e-5 };

const undamped = () => [1, 1];

/** By how much the gap rate of `row` changes at most in a step in which its cable is not hit [m/s]: by gravity and swing. */
export function changeInStep([gx, gy], { length }, { nx, ny, px, py, gap }, [x, y, , vx, vy, spin], dt) {
  const rx = px - x, ry = py - y, distance = length - gap, across = nx * (vy + spin * rx) - ny * (vx - spin * ry);
  const turned = distance > 0 ? (across * across) / distance + spin * spin * (nx * rx + ny * ry) : 0;
  return dt * (Math.abs(turned) + Math.abs(nx * gx + ny * gy));
}

export const plane = {
  initial: ({ initial: { position, angle, velocity, spin } }) => [...position, angle, ...velocity, spin],
  numbers: (state) => state,
  stateOf: (numbers) => numbers,
  world: (engine, theCase, options) => engine.world(theCase, options),

  checkCaps: (engine, { gravity }, state, dt) => checkMotion(engine, fastest(state, gravity, dt), Math.abs(state[5]), dt),
  row: ({ cables }, index, state) => cableRow(cables[index], state),
  length: ({ cables }, index) => cables[index].length,
  changeInStep: ({ gravity, cables }, index, row, state, dt) => changeInStep(gravity, cables[index], row, state, dt),
  /** By how much the gap rate of `row` changes in a step without its cable [m/s]. */
  kick: ({ gravity: [gx, gy] }, index, { nx, ny }, state, dt) => dt * (nx * gx + ny * gy),

  impulsesFor: ({ body }, rows, rise) => impulsesFor(rows, rise, (a, b) => response(a, b, body)),
  push: (world, { nx, ny, px, py }, impulse) => world.push(impulse * nx, impulse * ny, px, py),
  /** The state after pushes along `rows` that have changed the pose alone. */
  moved({ body: { mass, inertia } }, state, rows, pushes) {
    const moved = [...state];
    pushes.forEach((push, i) => {
      const { nx, ny, moment } = rows[i];
      moved[0] += (push * nx) / mass;
      moved[1] += (push * ny) / mass;
      moved[2] += inertia > 0 ? (push * moment) / inertia : 0;
    });
    return moved;
  },

  /** What cables have changed of the velocity in a step, as rates of the gaps of `rows` [m/s], and what of impulses is rounding [N s]. */
  jumps({ precision }, { body, gravity }, rows, before, after, dt, left = undamped) {
    const [linear, angular] = left(dt), [gx, gy] = gravity;
    const jump = [after[3] - linear * (before[3] + dt * gx), after[4] - linear * (before[4] + dt * gy), after[5] - angular * before[5]];
    const speed = Math.hypot(before[3], before[4]) + dt * Math.hypot(...gravity);
    const noise = unseen[precision] * (body.mass * speed + Math.sqrt(body.mass * body.inertia) * Math.abs(before[5]));
    return { jumps: rows.map(({ nx, ny, moment }) => nx * jump[0] + ny * jump[1] + moment * jump[2]), noise };
  },

  /** `part` [-] of gravity's impulse in a step of `dt` [s]. */
  kickBy: (world, { gravity }, state, dt, part) => kick(world, state, gravity, part * dt),
  fly,
};
