// Exact flight by an engine that moves a body in n substeps of semi-implicit Euler. An engine's `flight` is
//
//   substeps           n: a step of dt moves a body by v dt + g dt^2 (n + 1) / (2 n)
//   spinFor(w, dt)     the spin whose step turns the body by w dt, of engines that turn by an arctangent
//   speed              [m/s], to which the engine cuts a velocity without a word
//   turn, move         [rad], [m] in a step, to which it does
//
// of which all but the first may be absent.

import { Unsupported } from "../../protocol/javascript/engine.mjs";
import { fastest } from "./caps.mjs";

/** A flight is split so that no part comes near what the engine allows in a step [-]. */
const partOfCap = 0.9;

/** More parts than this are given up: the body turns a thousand times in a step. */
const mostParts = 1e5;

/** Changes the velocity by gravity's in `dt` [s]. */
export function kick(world, [gx, gy], dt) {
  const [, , , vx, vy, spin] = world.state();
  world.setVelocity(vx + dt * gx, vy + dt * gy, spin);
}

/**
 * Flies the parabola for `dt` [s]. Over a step of h the engine's own velocity changes n times by g h / n, and moves the
 * body each time: less by g h / (2 n) before, and more by the same after, is exact.
 */
export function fly(engine, world, theCase, dt) {
  const { substeps, spinFor = (spin) => spin, turn = Infinity, move = Infinity } = engine.flight;
  const start = world.state();
  const needed = (h) => Math.max(Math.abs(spinFor(start[5], h)) * h / turn, fastest(start, theCase.gravity, dt) * h / move);
  let parts = 1;
  while (!(needed(dt / parts) <= partOfCap)) {
    if ((parts *= 2) > mostParts) throw new Unsupported(`the body is too fast for a flight of ${dt} s`);
  }
  const h = dt / parts, spin = start[5];
  for (let part = 0; part < parts; ++part) {
    const [, , , vx, vy] = world.state(), [gx, gy] = theCase.gravity, k = h / (2 * substeps);
    world.setVelocity(vx - k * gx, vy - k * gy, spinFor(spin, h));
    world.step(h);
    const after = world.state();
    world.setVelocity(after[3] + k * gx, after[4] + k * gy, spin);
  }
}
