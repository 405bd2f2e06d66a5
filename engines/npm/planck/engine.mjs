// planck: Box2D 2.4 in JavaScript, in doubles. Its RopeJoint looks ahead, lands the body on the length and has no
// restitution. `world.createJoint` takes any subclass of Joint, so a cable can be a row of the solver's own.

import { serve } from "../../protocol/javascript/engine.mjs";
import { bounceModel, eventModel, limitModel, rowModels, setting, turnableInertia, unwrap } from "../common/models.mjs";
import { installedVersion } from "../common/version.mjs";
import { solverRows } from "./row_joint.mjs";

const K = await import("planck");

/** What Box2D's manual suggests; a step of planck has no defaults for them. */
const velocityIterations = 8, positionIterations = 3;

/** A step of planck cuts a body's motion to 2 m and pi/2 rad (Settings.maxTranslation, Settings.maxRotation). */
const engine = {
  title: "planck",
  precision: "float64",
  flight: { substeps: 1, move: K.Settings.maxTranslation, turn: K.Settings.maxRotation },
  world,
};

function world({ gravity, body: { mass, ...rest }, cables }, { limit, rows, early, step }) {
  const w = new K.World({ gravity: K.Vec2(...gravity), allowSleep: false });
  const body = w.createBody({ type: "dynamic", allowSleep: false }), ground = w.createBody();
  body.setMassData({ mass, center: K.Vec2(0, 0), I: turnableInertia({ mass, ...rest }) });
  let joints = [];
  if (limit) {
    joints = cables.map(({ anchor, attachment, length }) => w.createJoint(new K.RopeJoint({ maxLength: length,
      localAnchorA: K.Vec2(...anchor), localAnchorB: K.Vec2(...attachment), bodyA: ground, bodyB: body })));
  } else if (rows) {
    joints = solverRows(K, ground, body, gravity, cables, early, step).map((joint) => w.createJoint(joint));
  }
  let angle = 0; // setTransform takes whole turns away
  return {
    state() {
      const { x, y } = body.getPosition(), v = body.getLinearVelocity();
      angle = unwrap(body.getAngle(), angle);
      return [x, y, angle, v.x, v.y, body.getAngularVelocity()];
    },
    place([x, y, turned, ...velocity]) {
      angle = turned;
      body.setTransform(K.Vec2(x, y), angle);
      this.setVelocity(...velocity);
    },
    setVelocity(vx, vy, spin) {
      body.setLinearVelocity(K.Vec2(vx, vy));
      body.setAngularVelocity(spin);
    },
    push: (jx, jy, px, py) => body.applyLinearImpulse(K.Vec2(jx, jy), K.Vec2(px, py), true),
    step(dt) {
      w.step(dt, velocityIterations, positionIterations);
      angle += body.getAngularVelocity() * dt;
    },
    // the reaction to a joint over a second is its impulse; exactly zero where it has not pulled
    pulls: joints.length > 0 ? () => joints.map((joint) => K.Vec2.lengthOf(joint.getReactionForce(1))) : undefined,
  };
}

const settings = [
  setting("allowSleep", false, "planck freezes a body slower than 0.01 m/s and 2 degrees/s for half a second."),
  setting("velocityIterations, positionIterations", `${velocityIterations}, ${positionIterations}`, "What a world of planck has; Box2D's manual suggests them.", "engine_default"),
];
const rope = [...settings, setting("RopeJoint.maxLength", "the cable's length", "The joint is made of it.")];

serve({
  name: "planck",
  version: installedVersion(import.meta.url, "planck"),
  precision: engine.precision,
  models: [
    limitModel(engine, "rope", "planck's RopeJoint, which has no restitution: what one tries first.", rope),
    bounceModel(engine, "rope-bounce", "The same joint, and after a step in which it pulled an impulse that gives the cable's restitution.", rope),
    ...rowModels(engine, settings),
    limitModel(engine, "solver-row", "A joint class of its own, a one-sided row in planck's solver from the step after the cable is overstretched; it asks for the bounce, and takes 0.2 of the overstretch out per step without throwing the body back.", settings, { limit: false, rows: true }, "by_hand"),
    limitModel(engine, "solver-early", "The same row already in the step that would overstretch the cable.", settings, { limit: false, rows: true, early: true }, "by_hand"),
    eventModel(engine, settings),
  ],
});
