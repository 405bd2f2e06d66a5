// matter-js, in doubles, with position Verlet: a velocity is a difference of positions. Its Constraint pulls and pushes, and
// weighs a body off its centre wrongly; a cable has to be made by hand.

import { serve } from "../../protocol/javascript/engine.mjs";
import { cableRow } from "../../protocol/javascript/cable.mjs";
import { eventModel, limitModel, rowModels, setting, turnableInertia } from "../common/models.mjs";

const K = (await import("matter-js")).default;

const engine = { title: "matter-js", precision: "float64", flight: { substeps: 1 }, world };

/** matter-js counts milliseconds, and accelerations per square millisecond. */
const second = 1000;

/** What matter-js takes for the latest step, where it is given a velocity [s]: of a short one the positions differ by rounding. */
const since = 1;

/** As shipped, frictionAir takes this part of a velocity [-] in a sixtieth of a second. */
const shippedAir = 0.01;

function world({ gravity: [gx, gy], body: { mass, inertia }, cables }, { limit, stiffness = 1, air = 0, exact }) {
  const simulation = K.Engine.create({ gravity: { x: gx, y: gy, scale: 1 / (second * second) } });
  const body = K.Bodies.circle(0, 0, 0.05, { collisionFilter: { mask: 0 } });
  K.Body.setMass(body, mass);
  K.Body.setInertia(body, turnableInertia({ mass, inertia })); // setMass changes it
  body.frictionAir = air;
  K.Composite.add(simulation.world, body);
  const constraints = !limit ? [] : cables.map(({ anchor: [x, y], attachment, length }) => K.Constraint.create({
    pointA: { x, y }, bodyB: body, pointB: { x: attachment[0], y: attachment[1] }, length, stiffness }));
  for (const constraint of constraints) K.Composite.add(simulation.world, constraint);
  let moved; // in the latest step; afterwards the difference of positions has it only to their rounding
  K.Events.on(simulation, "beforeSolve", () => (moved = [body.velocity.x, body.velocity.y, body.angularVelocity]));
  return {
    constraints,
    state() {
      const { position, positionPrev, angle, anglePrev } = body, dt = body.deltaTime / second;
      return [position.x, position.y, angle, (position.x - positionPrev.x) / dt, (position.y - positionPrev.y) / dt, (angle - anglePrev) / dt];
    },
    place([x, y, angle, ...velocity]) {
      K.Body.setPosition(body, { x, y });
      K.Body.setAngle(body, angle);
      this.setVelocity(...velocity);
    },
    setVelocity(vx, vy, spin) { // as the position that long ago
      body.deltaTime = since * second;
      body.positionPrev.x = body.position.x - vx * since;
      body.positionPrev.y = body.position.y - vy * since;
      body.anglePrev = body.angle - spin * since;
    },
    push(jx, jy, px, py) {
      const [x, y, , vx, vy, spin] = this.state();
      this.setVelocity(vx + jx * body.inverseMass, vy + jy * body.inverseMass, spin + ((px - x) * jy - (py - y) * jx) * body.inverseInertia);
    },
    step(dt) {
      K.Engine.update(simulation, dt * second);
      if (exact) this.setVelocity(...moved.map((way) => way / dt));
    },
  };
}

/** A cable is slack where its constraint has no stiffness. */
const toggle = (stiffness) => (world, state, cables) => cables.forEach((cable, i) => {
  world.constraints[i].stiffness = cableRow(cable, state).gap <= 0 ? stiffness : 0;
});

const settings = [
  setting("frictionAir", 0, "As shipped a body loses 45 % of its speed in a second."),
  setting("gravity.scale", 1e-6, "matter-js counts in milliseconds; the cases are in SI units."),
  setting("positionPrev, deltaTime", "of a second ago", "The velocity is a difference of positions, which over a short step is mostly rounding."),
  setting("collisionFilter.mask", 0, "Nothing is there to collide with."),
];
const constraint = [...settings, setting("Constraint.stiffness", 1, "A cable does not give way.")];
serve({
  name: "matter",
  version: K.version,
  precision: engine.precision,
  models: [
    limitModel(engine, "constraint", "matter-js's Constraint, which pushes as it pulls and has a wrong effective mass off the centre: what one tries first.", constraint, { pullsSlack: true }),
    limitModel(engine, "constraint-toggled", "The same constraint, stiff only in the steps that start overstretched.", constraint, { prepare: toggle(1) }, "by_hand"),
    ...rowModels(engine, settings),
    { ...rowModels(engine, settings.slice(1), { air: shippedAir })[0], name: "row-defaults", sentence: "The impulses of row on a body in the air that matter-js ships it with." },
    eventModel(engine, settings),
  ],
});
