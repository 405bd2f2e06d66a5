// p2-es, in doubles: its DistanceConstraint has an upper limit, whose rebound depends on the step. A cable can also be an
// equation of the solver's own.

import { serve } from "../../protocol/javascript/engine.mjs";
import { bounceModel, eventModel, limitModel, rowModels, setting, tunable, turnableInertia } from "../common/models.mjs";
import { installedVersion } from "../common/version.mjs";
import { solverRow } from "./row_constraint.mjs";

globalThis.P2_ARRAY_TYPE = Float64Array; // read as p2 loads: without it positions and velocities are float32
const C = await import("p2-es");

const engine = { title: "p2-es", precision: "float64", flight: { substeps: 1 }, world };

/** Two coupled rows converge by a factor for each iteration; p2's 10 leave an order of cables. */
const iterations = 50;

function world({ gravity, body: { mass, inertia }, cables }, { limit, rows, early, step, defaults, parameters = {} }) {
  const w = new C.World({ gravity });
  const body = new C.Body({ mass, ...(defaults ? {} : { damping: 0, angularDamping: 0 }) }), ground = new C.Body({ mass: 0 });
  body.inertia = turnableInertia({ mass, inertia }); // a body without shapes has none
  body.invInertia = 1 / body.inertia;
  w.addBody(body);
  w.addBody(ground);
  body.updateSolveMassProperties();
  let dt = step;
  const world = {
    state: () => [body.position[0], body.position[1], body.angle, body.velocity[0], body.velocity[1], body.angularVelocity],
    place([x, y, angle, ...velocity]) {
      body.position[0] = x;
      body.position[1] = y;
      body.angle = angle;
      this.setVelocity(...velocity);
    },
    setVelocity(vx, vy, spin) {
      body.velocity[0] = vx;
      body.velocity[1] = vy;
      body.angularVelocity = spin;
    },
    push: (jx, jy, px, py) => body.applyImpulse([jx, jy], [px - body.position[0], py - body.position[1]]),
    step: (h) => w.step((dt = h)),
  };
  if (limit) {
    for (const { anchor, attachment, length } of cables) {
      const constraint = new C.DistanceConstraint(ground, body, { localAnchorA: anchor, localAnchorB: attachment, distance: length, upperLimit: length });
      if ("stiffness" in parameters) constraint.setStiffness(parameters.stiffness);
      if ("relaxation" in parameters) constraint.setRelaxation(parameters.relaxation);
      w.addConstraint(constraint);
    }
  } else if (rows) {
    w.solver.iterations = iterations;
    w.solver.tolerance = 0;
    for (const cable of cables) w.addConstraint(solverRow(C, ground, body, gravity, cable, early, step, world.state, () => dt));
  }
  const equations = w.constraints.map((constraint) => constraint.equations[0]);
  if (equations.length > 0) world.pulls = (h) => equations.map(({ enabled, multiplier }) => (enabled ? Math.abs(multiplier) * h : 0));
  return world;
}

const arrays = setting("P2_ARRAY_TYPE", "Float64Array", "As shipped p2 keeps positions and velocities in single precision.");
const undamped = setting("damping, angularDamping", 0, "As shipped a body loses a tenth of its speed in a second.");
const settings = [arrays, undamped];
const limit = setting("DistanceConstraint.upperLimit", "the cable's length", "Without it the constraint is a rod.");
const solver = [...settings, setting("solver.iterations, solver.tolerance", `${iterations}, 0`, "Two coupled rows converge slowly: with p2's 10 and 1e-7 the order of the cables shows.")];

serve({
  name: "p2",
  version: installedVersion(import.meta.url, "p2-es"),
  precision: engine.precision,
  models: [
    tunable(limitModel(engine, "distance", "The upper limit of p2's DistanceConstraint, which has no restitution: what rebound there is depends on the step.", [...settings, limit]),
      "constraint.setStiffness({stiffness}); constraint.setRelaxation({relaxation});",
      [{ name: "relaxation", low: 0.1, high: 50, scale: "log" }, { name: "stiffness", low: 4e-4, high: 1, scale: "log", step_power: -2 }]),
    limitModel(engine, "distance-defaults", "The same limit on a body that is damped as p2 ships it.", [arrays, limit], { defaults: true }),
    bounceModel(engine, "distance-bounce", "The same limit, undamped, and after a step in which it pulled an impulse up to the cable's restitution.", [...settings, limit]),
    ...rowModels(engine, settings),
    limitModel(engine, "solver-row", "An equation of its own, a one-sided row in p2's solver from the step after the cable is overstretched; it asks for the bounce, and takes 0.2 of the overstretch out per step without throwing the body back.", solver, { limit: false, rows: true }, "by_hand"),
    limitModel(engine, "solver-early", "The same row already in the step that would overstretch the cable.", solver, { limit: false, rows: true, early: true }, "by_hand"),
    eventModel(engine, settings),
  ],
});
