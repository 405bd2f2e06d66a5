// The models that an engine's folder lists, as the kit takes them: what `info` says of each, and how it starts.

import { Unsupported } from "../../protocol/javascript/engine.mjs";
import { startEvent } from "./event.mjs";
import { startBounce, startLimit, startRow } from "./fixed_step.mjs";

/** `origin` says whose choice the value is: "engine_default", "engine_demo" or "ours". */
export const setting = (name, value, reason, origin = "ours") => ({ name, value: String(value), reason, origin });

/** What is set in space, beside an engine's own: only what has bodies in space, `system`, runs systems. */
function inSpace(engine, settings = []) {
  if (!engine.system) return undefined;
  return [...engine.inSpace, setting("gravity, body velocity", "gravity as it is in the middle of the step; impulses of forces, moments and drag", `${engine.title} is given no function of time.`), ...settings];
}

/** A model whose restitution is a table over the speed as well as a number. */
const model = (name, maker, sentence, settings, start, more = {}) => ({ name, sentence, maker, drive: "steps",
  follows_speed: true, settings, start, ...more });

/** `row` and `early`, by impulses from outside before a step of the engine. */
export function rowModels(engine, settings, options = {}) {
  const start = (early) => (theCase, run) => startRow(engine, theCase, { ...options, ...run, early });
  return [
    model("row", "by_hand", `Impulses by hand before the steps that start overstretched, for the bounce; 0.2 of the overstretch goes out per step without throwing the body back. ${engine.title} flies.`, settings, start(false), { tension: true, in_space: inSpace(engine) }),
    model("early", "by_hand", "The same impulses already before the step that would overstretch the cable.", settings, start(true), { tension: true, in_space: inSpace(engine) }),
  ];
}

/** The engine's own limit, as `maker` would use it; in space where `options.inSpace`, a list of settings, says so. */
export function limitModel(engine, name, sentence, settings, { inSpace: own, ...options } = {}, maker = "engine") {
  return model(name, maker, sentence, settings, (theCase, run) => startLimit(engine, theCase, { ...options, ...run }), { in_space: own && inSpace(engine, own) });
}

/** `model` with numbers that a run may set, and the code that sets them in a user's program. */
export const tunable = (model, code, parameters) => ({ ...model, parameters, code });

/** A model whose cable has `what`, one number for all speeds. */
export function atOneSpeed({ start, ...told }, what) {
  return { ...told, follows_speed: false, start(theCase, run) {
    if (theCase.cables.some(({ restitution }) => typeof restitution !== "number")) throw new Unsupported(`${what} for all speeds`);
    return start(theCase, run);
  } };
}

/** The engine's own limit and a bounce by hand after it. */
export function bounceModel(engine, name, sentence, settings, { inSpace: own, ...options } = {}) {
  return model(name, "by_hand", sentence, [...settings, kicks(engine)], (theCase, run) => startBounce(engine, theCase, { ...options, ...run }), { in_space: own && inSpace(engine, own) });
}

/** What a model that flies the parabola says of it. */
const kicks = ({ flight: { substeps: n } }) => setting("body velocity", `1/${2 * n} of gravity's impulse less before and more after each step`,
  n > 1 ? `${n} substeps of semi-implicit Euler then fly the exact parabola.` : "Semi-implicit Euler then flies the exact parabola.");

/** The event driver's model. */
export function eventModel(engine, settings, { inSpace: inSpaceToo = [], ...options } = {}) {
  const own = [kicks(engine)];
  if (engine.flight.spinFor) own.push(setting("body spin", "the tangent of the turn, during a step", `${engine.title} turns a body by the arctangent of spin times step.`));
  return model("event", "tautline", `${engine.title} flies, the event driver finds the instants: each impact is solved by hand at the exact pose, in the mass and inertia that ${engine.title} has been given.`,
    [...settings, ...own], (theCase, run) => startEvent(engine, theCase, { ...options, ...run }), { drive: "events", in_space: inSpace(engine, inSpaceToo) });
}

/** The engine's mass and inertia: a point mass gets one that no cable turns, as engines have none without. */
export const turnableInertia = ({ mass, inertia }) => (inertia > 0 ? inertia : mass);

/** The same in space, three moments. */
export const turnableMoments = ({ mass, inertia }) => (inertia[0] > 0 ? inertia : [mass, mass, mass]);

/** `angle` plus the whole turns that bring it nearest to `expected` [rad]. */
export const unwrap = (angle, expected) => angle + 2 * Math.PI * Math.round((expected - angle) / (2 * Math.PI));
