// Box2D version 3, in single precision. The limit of its distance joint looks ahead and has no restitution; it is there only
// where the joint has a spring, without which the joint is a rod.

import { serve } from "../../protocol/javascript/engine.mjs";
import { bounceModel, eventModel, limitModel, rowModels, setting, turnableInertia, unwrap } from "../common/models.mjs";
import { installedVersion } from "../common/version.mjs";

const B = await (await import("box2d3-wasm")).default();

/** An argument of a step, of which Box2D's samples give 4. */
const substeps = 4;

const engine = {
  title: "Box2D",
  precision: "float32",
  // a substep turns by an arctangent
  flight: { substeps, spinFor: (spin, dt) => (Math.tan((spin * dt) / substeps) * substeps) / dt, turn: Math.PI / 2 },
  world,
};

/** Instead of 400 m/s, to which Box2D cuts a velocity. */
const largestSpeed = 1e7;

/** What `read` takes of a vector; every one is a handle on the heap. */
function taken(vector, read) {
  const result = read(vector);
  vector.delete();
  return result;
}

function createWorld([gx, gy]) {
  return taken(B.b2DefaultWorldDef(), (definition) => {
    definition.gravity.Set(gx, gy);
    definition.enableSleep = false;
    definition.maximumLinearSpeed = largestSpeed;
    return B.b2CreateWorld(definition);
  });
}

function createBodies(w, { mass, inertia }) {
  return taken(B.b2DefaultBodyDef(), (definition) => {
    const ground = B.b2CreateBody(w, definition);
    definition.type = B.b2BodyType.b2_dynamicBody;
    definition.allowFastRotation = true;
    const body = B.b2CreateBody(w, definition);
    taken(new B.b2MassData(), (data) => {
      data.mass = mass;
      data.rotationalInertia = turnableInertia({ mass, inertia });
      B.b2Body_SetMassData(body, data);
    });
    return { ground, body };
  });
}

function createJoint(w, ground, body, { anchor, attachment, length }, spring) {
  return taken(B.b2DefaultDistanceJointDef(), (definition) => {
    definition.base.bodyIdA = ground;
    definition.base.bodyIdB = body;
    definition.base.localFrameA.p.Set(...anchor);
    definition.base.localFrameB.p.Set(...attachment);
    definition.length = definition.maxLength = length;
    definition.minLength = 0;
    definition.enableLimit = true;
    definition.enableSpring = spring;
    definition.hertz = definition.dampingRatio = 0; // a spring that does nothing
    return B.b2CreateDistanceJoint(w, definition);
  });
}

function world({ gravity, body: mass, cables }, { limit }) {
  const w = createWorld(gravity), { ground, body } = createBodies(w, mass);
  // b2Joint_GetConstraintForce tells of the last substep alone: the impulses are read from the velocities
  if (limit) cables.forEach((cable) => createJoint(w, ground, body, cable, limit !== "rod"));
  const v = new B.b2Vec2(0, 0), p = new B.b2Vec2(0, 0);
  let angle = 0;
  return {
    state() {
      const xy = ({ x, y }) => [x, y];
      angle = unwrap(taken(B.b2Body_GetRotation(body), ({ s, c }) => Math.atan2(s, c)), angle);
      return [...taken(B.b2Body_GetPosition(body), xy), angle, ...taken(B.b2Body_GetLinearVelocity(body), xy), B.b2Body_GetAngularVelocity(body)];
    },
    place([x, y, turned, ...velocity]) {
      angle = turned;
      p.Set(x, y);
      taken(B.b2MakeRot(0), (rotation) => { // b2MakeRot has an approximate sine
        [rotation.c, rotation.s] = [Math.cos(angle), Math.sin(angle)];
        B.b2Body_SetTransform(body, p, rotation);
      });
      this.setVelocity(...velocity);
    },
    setVelocity(vx, vy, spin) {
      v.Set(vx, vy);
      B.b2Body_SetLinearVelocity(body, v);
      B.b2Body_SetAngularVelocity(body, spin);
    },
    push(jx, jy, px, py) {
      v.Set(jx, jy);
      p.Set(px, py);
      B.b2Body_ApplyLinearImpulse(body, v, p, true);
    },
    step(dt) {
      B.b2World_Step(w, dt, substeps);
      angle += B.b2Body_GetAngularVelocity(body) * dt;
    },
    free() {
      B.b2DestroyWorld(w);
      for (const object of [v, p]) object.delete();
    },
  };
}

const settings = [
  setting("enableSleep", false, "Box2D freezes slow bodies."),
  setting("subStepCount", substeps, "A step has no default; Box2D's samples give 4.", "engine_demo"),
  setting("maximumLinearSpeed", largestSpeed, "As shipped Box2D cuts a velocity to 400 m/s."),
  setting("allowFastRotation", true, "As shipped Box2D cuts a turn to pi/4 in a step."),
];
const limited = [...settings, setting("enableLimit, maxLength", "true, the cable's length", "Without them the joint limits nothing.")];
const sprung = [...limited, setting("enableSpring, hertz", "true, 0", "Without a spring the joint is a rod.")];

serve({
  name: "box2d3",
  version: installedVersion(import.meta.url, "box2d3-wasm"),
  precision: engine.precision,
  models: [
    limitModel(engine, "distance-joint-rod", "The limit of b2DistanceJoint without a spring, with which the joint is a rod: what one tries first.", limited, { limit: "rod", pullsSlack: true }),
    limitModel(engine, "distance-joint", "The limit of b2DistanceJoint with a spring that does nothing; it has no restitution.", sprung),
    bounceModel(engine, "distance-joint-bounce", "The same joint, and after a step in which it pulled an impulse that gives the cable's restitution.", sprung),
    ...rowModels(engine, settings),
    eventModel(engine, settings),
  ],
});
