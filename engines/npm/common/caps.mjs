// What an engine cannot do of a case: its caps on a body's speed, and its numbers.

import { Unsupported } from "../../protocol/javascript/engine.mjs";

/** The largest speed [m/s] in a step. */
export const fastest = ([, , , vx, vy], [gx, gy], dt) => Math.hypot(vx, vy) + dt * Math.hypot(gx, gy);

/** Throws a sentence where a step of `dt` [s] at these speeds [m/s], [rad/s] would meet a cap of the engine's. */
export function checkMotion({ title, flight }, speed, spin, dt) {
  const refuse = (cap, found) => {
    throw new Unsupported(`${title} cuts a body's motion to ${cap}; here it is ${found.toPrecision(4)}`);
  };
  if (speed > flight.speed) refuse(`${flight.speed} m/s`, speed);
  if (speed * dt > flight.move) refuse(`${flight.move} m in a step, for which ${dt} s is too long`, speed * dt);
  if (spin * dt > flight.turn) refuse(`${flight.turn.toPrecision(4)} rad in a step, for which ${dt} s is too long`, spin * dt);
}

/** Throws a sentence where a number of the case does not fit into the engine's. */
export function checkNumbers({ title, precision }, { gravity, body, bodies, cables, initial }) {
  if (precision !== "float32") return;
  const check = (value) => {
    const rounded = Math.fround(value);
    if (!Number.isFinite(rounded) || (rounded === 0 && value !== 0)) {
      throw new Unsupported(`${title}'s single precision cannot hold ${value}`);
    }
  };
  const numbers = (value) => {
    if (typeof value === "object") Object.values(value).forEach(numbers);
    else if (typeof value === "number") check(value);
  };
  numbers([gravity, body ?? bodies, cables, initial]);
}
