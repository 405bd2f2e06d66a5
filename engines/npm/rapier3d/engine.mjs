// Rapier in three dimensions, held in the plane or free in space: single precision, with a rope joint that looks ahead, lands the body on
// the length and has no restitution.

import { serve, Unsupported } from "../../protocol/javascript/engine.mjs";
import { bounceModel, eventModel, limitModel, rowModels, setting, turnableInertia, turnableMoments, unwrap } from "../common/models.mjs";
import { actsAt, checkStraight, endAt, lengthAt, pairsOf } from "../common/space.mjs";

const R = (await import("@dimforge/rapier3d-compat")).default;
await R.init();

/** As shipped: `numSolverIterations`, which are substeps of the flight. */
const substeps = 4;

const engine = {
  title: "Rapier",
  precision: "float32",
  // no setting lifts the caps; a substep turns by twice an arctangent
  flight: { substeps, spinFor: (spin, dt) => (Math.tan((spin * dt) / (2 * substeps)) * 2 * substeps) / dt, speed: 400, turn: Math.PI / 4 },
  world,
  system,
  gyroscopicTerm: true,
  inSpace: [setting("enabledTranslations, enabledRotations", "as shipped", "Bodies of a system move in space.")],
};

const vector = ([x, y]) => ({ x, y, z: 0 });
const inPlane = { x: 0, y: 0, z: 0, w: 1 };

function world({ gravity, body: { mass, inertia }, cables }, { limit }) {
  const w = new R.World(vector(gravity)), same = turnableInertia({ mass, inertia });
  const body = w.createRigidBody(R.RigidBodyDesc.dynamic().setCanSleep(false)
    .setAdditionalMassProperties(mass, vector([0, 0]), { x: same, y: same, z: same }, inPlane)
    .enabledTranslations(true, true, false).enabledRotations(false, false, true));
  body.recomputeMassPropertiesFromColliders(); // without it the first step has no mass
  const ground = w.createRigidBody(R.RigidBodyDesc.fixed());
  if (limit) {
    for (const { anchor, attachment, length } of cables) {
      w.createImpulseJoint(R.JointData.rope(length, vector(anchor), vector(attachment)), ground, body, true);
    }
  }
  let angle = 0;
  return {
    state() {
      const { x, y } = body.translation(), v = body.linvel(), q = body.rotation();
      angle = unwrap(2 * Math.atan2(q.z, q.w), angle);
      return [x, y, angle, v.x, v.y, body.angvel().z];
    },
    place(state) {
      angle = state[2];
      body.setTranslation(vector(state), true);
      body.setRotation({ x: 0, y: 0, z: Math.sin(angle / 2), w: Math.cos(angle / 2) }, true);
      this.setVelocity(...state.slice(3));
    },
    setVelocity(x, y, spin) {
      body.setLinvel({ x, y, z: 0 }, true);
      body.setAngvel({ x: 0, y: 0, z: spin }, true);
    },
    push: (jx, jy, px, py) => body.applyImpulseAtPoint({ x: jx, y: jy, z: 0 }, { x: px, y: py, z: 0 }, true),
    step(dt) {
      w.timestep = dt;
      w.step();
      angle += body.angvel().z * dt;
    },
    free: () => w.free(),
  };
}

const point = ([x, y, z]) => ({ x, y, z });
const numbers = ({ x, y, z }) => [x, y, z];

function system(theSystem, { limit }) {
  if (limit) checkStraight(theSystem, "Rapier's rope joint", Unsupported);
  const w = new R.World(point([0, 0, 0]));
  const moving = theSystem.bodies.map(({ mass, inertia }) => {
    const body = w.createRigidBody(R.RigidBodyDesc.dynamic().setCanSleep(false)
      .setAdditionalMassProperties(mass, point([0, 0, 0]), point(turnableMoments({ mass, inertia })), inPlane));
    body.recomputeMassPropertiesFromColliders();
    return body;
  });
  const ground = w.createRigidBody(R.RigidBodyDesc.fixed());
  const createHook = (at) => w.createRigidBody(R.RigidBodyDesc.kinematicPositionBased().setTranslation(...at));
  const ends = limit ? pairsOf(theSystem, moving, ground, createHook) : [], joints = ends.map(() => ({ length: 0 }));
  return {
    bodies: moving.map((body) => ({
      read() {
        const q = body.rotation();
        return { position: numbers(body.translation()), orientation: [q.w, q.x, q.y, q.z], velocity: numbers(body.linvel()), turning: numbers(body.angvel()) };
      },
      place(position, [cosine, x, y, z]) {
        body.setTranslation(point(position), true);
        body.setRotation({ x, y, z, w: cosine }, true);
      },
      setVelocity(velocity, turning) {
        body.setLinvel(point(velocity), true);
        body.setAngvel(point(turning), true);
      },
    })),
    setGravity: (gravity) => (w.gravity = point(gravity)),
    /** The length of a rope joint cannot be changed: a winch takes a new one in each step. */
    prepare(time, dt) {
      ends.forEach(({ cable, ends: pair }, i) => {
        const length = actsAt(cable, time) ? lengthAt(cable, time + dt) : 0, [first, second] = pair;
        if (length !== joints[i].length) {
          if (joints[i].joint) w.removeImpulseJoint(joints[i].joint, true);
          joints[i] = { length, joint: length > 0 ? w.createImpulseJoint(R.JointData.rope(length, point(first.at), point(second.at)), first.body, second.body, true) : undefined };
        }
        for (const { end, hook } of pair) hook?.setNextKinematicTranslation(point(endAt(end, time + dt)));
      });
    },
    step(dt) {
      w.timestep = dt;
      w.step();
    },
    free: () => w.free(),
  };
}

const settings = [
  setting("canSleep", false, "Rapier freezes slow bodies."),
  setting("enabledTranslations, enabledRotations", "x, y and about z", "The cases are planar."),
];

const ends = [setting("kinematicPositionBased, createImpulseJoint", "where ends that move go, and joints of the length at the end of a step", "Rapier knows no function of time, and no other length of a rope joint.")];

serve({
  name: "rapier3d",
  version: R.version(),
  precision: engine.precision,
  dimensions: [2, 3],
  models: [
    limitModel(engine, "rope", "Rapier's rope joint, which has no restitution: what one tries first.", settings, { inSpace: ends }),
    bounceModel(engine, "rope-bounce", "The same joint, and after a step in which it pulled an impulse that gives the cable's restitution.", settings, { inSpace: ends }),
    ...rowModels(engine, settings),
    eventModel(engine, settings),
  ],
});
