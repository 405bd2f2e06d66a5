// cannon-es, in doubles. Its DistanceConstraint is a rod between two centres, so that a user builds a cable: of a contact
// that the length makes, or as an equation of the solver's own.

import { serve } from "../../protocol/javascript/engine.mjs";
import { atOneSpeed, eventModel, limitModel, rowModels, setting, turnableInertia, turnableMoments, unwrap } from "../common/models.mjs";
import { installedVersion } from "../common/version.mjs";
import { solverRow } from "./row_constraint.mjs";

const C = await import("cannon-es");

const engine = {
  title: "cannon-es",
  precision: "float64",
  // a step turns the quaternion by its derivative: by twice an arctangent
  flight: { substeps: 1, spinFor: (spin, dt) => (Math.tan((spin * dt) / 2) * 2) / dt },
  world,
  system,
  inSpace: [setting("linearFactor, angularFactor", "as shipped", "Bodies of a system move in space.")],
};

/** Two coupled rows converge by a factor for each iteration; cannon's 10 leave an order of cables. */
const iterations = 50;

function world({ gravity, body: { mass, inertia }, cables }, { rows, early, step }) {
  const w = new C.World({ gravity: new C.Vec3(...gravity, 0) });
  const body = new C.Body({ mass, linearDamping: 0, angularDamping: 0, allowSleep: false,
    linearFactor: new C.Vec3(1, 1, 0), angularFactor: new C.Vec3(0, 0, 1) });
  const ground = new C.Body({ mass: 0 }), same = turnableInertia({ mass, inertia });
  body.inertia.set(same, same, same); // a body without shapes has none
  body.invInertia.set(1 / same, 1 / same, 1 / same);
  w.addBody(body);
  w.addBody(ground);
  body.updateInertiaWorld(true);
  body.updateSolveMassProperties();
  let angle = 0, dt = step;
  const { position, velocity, quaternion, angularVelocity } = body;
  const world = {
    state() {
      angle = unwrap(2 * Math.atan2(quaternion.z, quaternion.w), angle);
      return [position.x, position.y, angle, velocity.x, velocity.y, angularVelocity.z];
    },
    place([x, y, turned, ...rates]) {
      angle = turned;
      position.set(x, y, 0);
      quaternion.set(0, 0, Math.sin(angle / 2), Math.cos(angle / 2));
      body.updateInertiaWorld(true);
      this.setVelocity(...rates);
    },
    setVelocity(vx, vy, spin) {
      velocity.set(vx, vy, 0);
      angularVelocity.set(0, 0, spin);
    },
    push: (jx, jy, px, py) => body.applyImpulse(new C.Vec3(jx, jy, 0), new C.Vec3(px - position.x, py - position.y, 0)),
    step(h) {
      w.step((dt = h)); // with a second argument it would interpolate, and may not step at all
      angle += angularVelocity.z * h;
    },
  };
  if (rows) {
    w.solver.iterations = iterations;
    w.solver.tolerance = 0;
    const constraints = cables.map((cable) => solverRow(C, ground, body, gravity, cable, rows, early, step, world.state, () => dt));
    for (const constraint of constraints) w.addConstraint(constraint);
    const equations = constraints.map((constraint) => constraint.equations[0]);
    world.pulls = (h) => equations.map(({ enabled, multiplier }) => (enabled ? Math.max(0, multiplier) * h : 0));
  }
  return world;
}

function system({ bodies }) {
  const w = new C.World();
  return {
    bodies: bodies.map(({ mass, inertia }) => {
      const body = new C.Body({ mass, linearDamping: 0, angularDamping: 0, allowSleep: false });
      const moments = turnableMoments({ mass, inertia }), { position, velocity, quaternion, angularVelocity } = body;
      body.inertia.set(...moments);
      body.invInertia.set(...moments.map((moment) => 1 / moment));
      w.addBody(body);
      body.updateSolveMassProperties();
      return {
        read: () => ({ position: position.toArray(), orientation: [quaternion.w, quaternion.x, quaternion.y, quaternion.z], velocity: velocity.toArray(), turning: angularVelocity.toArray() }),
        place(at, [cosine, ...axis]) {
          position.set(...at);
          quaternion.set(...axis, cosine);
          body.updateInertiaWorld(true);
        },
        setVelocity(v, turning) {
          velocity.set(...v);
          angularVelocity.set(...turning);
        },
      };
    }),
    setGravity: (gravity) => w.gravity.set(...gravity),
    step: (dt) => w.step(dt),
  };
}

const settings = [
  setting("linearDamping, angularDamping", 0, "As shipped a body loses a hundredth of its speed in a second."),
  setting("linearFactor, angularFactor", "x, y and about z", "The cases are planar."),
];
const solver = [...settings, setting("solver.iterations, solver.tolerance", `${iterations}, 0`, "Two coupled rows converge slowly: with cannon's 10 and 1e-7 the order of the cables shows.")];
const contact = [...solver,
  setting("contact stiffness", "1e12", "A cable does not give way."),
  setting("restitution", "the cable's", "Of the contact's equation; it bounces the velocity of the centre alone.")];
const inSolver = (name, sentence, given, options) => limitModel(engine, name, sentence, given, { limit: false, ...options }, "by_hand");

serve({
  name: "cannon",
  version: installedVersion(import.meta.url, "cannon-es"),
  precision: engine.precision,
  dimensions: [2, 3],
  models: [
    atOneSpeed(inSolver("contact", "A contact of cannon's between the body and the circle of the cable's length, in the steps that start overstretched; its restitution counts the velocity of the body's centre alone.", contact, { rows: "contact" }), "a contact of cannon-es has one restitution"),
    ...rowModels(engine, settings),
    inSolver("solver-row", "An equation of its own, a one-sided row in cannon's solver from the step after the cable is overstretched; it asks for the bounce, and takes 0.2 of the overstretch out per step without throwing the body back.", solver, { rows: "row" }),
    inSolver("solver-early", "The same row already in the step that would overstretch the cable.", solver, { rows: "row", early: true }),
    eventModel(engine, settings),
  ],
});
