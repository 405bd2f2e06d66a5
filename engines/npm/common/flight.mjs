// Exact flight by an engine that moves a body in n substeps of semi-implicit Euler. An engine's `flight` is
//
//   substeps           n: a step of dt moves a body by v dt + g dt^2 (n + 1) / (2 n)
//   spinFor(w, dt)     the spin whose step turns the body by w dt, of engines that turn by an arctangent
//   exactTurn          [rad] in a step, beyond which the engine's turn is not exact in its numbers
//   speed              [m/s], to which the engine cuts a velocity without a word
//   turn, move         [rad], [m] in a step, to which it does
//   inSpace            what of these is otherwise in space
//
// of which all but the first may be absent.

import { Unsupported } from "../../protocol/javascript/engine.mjs";
import { fastest } from "./caps.mjs";

/** A flight is split so that no part comes near what the engine allows in a step [-]. */
const partOfCap = 0.9;

/** A tangent is far from where it ends, if a part turns by less than this [rad]. */
const clearTurn = Math.PI / 2;

/** More parts than this are given up: the body turns a thousand times in a step. */
const mostParts = 1e5;

/** Changes the velocity of `state`, where the body is, by gravity's in `dt` [s]; the spin where it is given. */
export function kick(world, [, , , vx, vy, itsSpin], [gx, gy], dt, spin = itsSpin) {
  world.setVelocity(vx + dt * gx, vy + dt * gy, spin);
}

/** In how many parts a flight of `dt` [s] at these speeds [m/s], [rad/s] meets no cap, and turns as exactly as the engine can. */
export function partsOf({ spinFor, move = Infinity, turn: cap = Infinity, exactTurn = Infinity }, speed, spin, dt) {
  const turn = Math.min(cap, exactTurn, spinFor ? clearTurn : Infinity);
  const turned = (h) => Math.max(spin, spinFor ? Math.abs(spinFor(spin, h)) : 0) * h;
  const needed = (h) => Math.max(turned(h) / turn, (speed * h) / move);
  let parts = 1;
  while (!(needed(dt / parts) <= partOfCap)) {
    if ((parts *= 2) > mostParts) throw new Unsupported(`the body is too fast for a flight of ${dt} s`);
  }
  return parts;
}

/**
 * Flies the parabola for `dt` [s] from `start`, where the body is. Over a step of h the engine's own velocity changes
 * n times by g h / n, and moves the body each time: less by g h / (2 n) before, and more by the same after, is exact.
 */
export function fly(engine, world, { gravity }, start, dt) {
  const { substeps, spinFor = (spin) => spin } = engine.flight, spin = start[5];
  const parts = partsOf(engine.flight, fastest(start, gravity, dt), Math.abs(spin), dt);
  const h = dt / parts, half = (0.5 * h) / substeps;
  for (let part = 0, now = start; part < parts; ++part) {
    if (part > 0) now = world.state();
    kick(world, now, gravity, -half, spinFor(spin, h));
    world.step(h);
    kick(world, world.state(), gravity, half, spin);
  }
}
