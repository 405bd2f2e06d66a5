// The standard case, breakwater/1910121100, as an engine is asked to run it, and its exact motion from tests/data: between
// two impacts the body flies a parabola.

import { readFileSync } from "node:fs";

const data = JSON.parse(readFileSync(new URL("../../data/breakwater_impacts.json", import.meta.url), "utf8"))["1910121100"];
const restitution = 0.9; // the data has its decimal as a text
const gravity = [0, -1];

export const standardCase = {
  name: "breakwater/1910121100",
  duration: 20,
  gravity,
  body: { mass: 1, inertia: Number(data.inertia) },
  cables: [-1, 1].map((side) => ({ anchor: [side, Number(data.h)], attachment: [side * Number(data.a), 0], length: Number(data.r), restitution })),
  initial: {
    position: [Number(data.initial.x), Number(data.initial.y)],
    angle: Number(data.initial.angle),
    velocity: [Number(data.initial.vx), Number(data.initial.vy)],
    spin: Number(data.initial.spin),
  },
};

export const stateOf = ({ position, angle, velocity, spin }) => [...position, angle, ...velocity, spin];

/** The state after a flight of `dt` [s] on which no cable pulls. */
export function flown([x, y, angle, vx, vy, spin], dt, [gx, gy] = gravity) {
  return [x + dt * vx + 0.5 * dt * dt * gx, y + dt * vy + 0.5 * dt * dt * gy, angle + dt * spin, vx + dt * gx, vy + dt * gy, spin];
}

const impacts = data.impacts.map(({ time, after }) => ({ time: Number(time), after: after.map(Number) }));
export const firstImpact = impacts[0].time;

/** The exact state at `time` [s]. */
export function exact(time) {
  const latest = impacts.filter((impact) => impact.time <= time).at(-1);
  return latest ? flown(latest.after, time - latest.time) : flown(stateOf(standardCase.initial), time);
}
