// PhysX 5, in single precision. Its joints need no plane: nothing pushes a body out of one. The limit of PxD6Joint has a
// restitution, which a speculative step brakes away; where the limit is there only once the cable is overstretched, it has it.

import { serve, Unsupported } from "../../protocol/javascript/engine.mjs";
import { cableRow } from "../../protocol/javascript/cable.mjs";
import { atOneSpeed, bounceModel, eventModel, limitModel, rowModels, setting, turnableInertia, turnableMoments, unwrap } from "../common/models.mjs";
import { actsAt, checkStraight, endAt, lengthAt, pairsOf } from "../common/space.mjs";
import { jointMaker } from "./joints.mjs";
import { loadPhysx } from "./load.mjs";

const P = await loadPhysx();
const top = P.PxTopLevelFunctions.prototype, identity = P.PxIDENTITYEnum.PxIdentity;
const foundation = top.CreateFoundation(P.PHYSICS_VERSION, new P.PxDefaultAllocator(), new P.PxDefaultErrorCallback());
const scale = new P.PxTolerancesScale(), physics = top.CreatePhysics(P.PHYSICS_VERSION, foundation, scale);
top.InitExtensions(physics);
const dispatcher = top.DefaultCpuDispatcherCreate(0); // no threads

const engine = {
  title: "PhysX",
  precision: "float32",
  flight: { substeps: 1 },
  world,
  system,
  gyroscopicTerm: true,
  inSpace: [setting("eENABLE_GYROSCOPIC_FORCES", true, "As shipped PhysX leaves the gyroscopic term out: a box keeps its spin and does not turn over.")],
};

/** PxRigidBodyFlag::eENABLE_GYROSCOPIC_FORCES, which the package has no name for. */
const gyroscopicForces = 1 << 10;

/** Instead of 100 rad/s, to which PhysX cuts a spin. */
const largestSpin = 1e6;

function createScene([gx, gy]) {
  const description = new P.PxSceneDesc(scale), gravity = new P.PxVec3(gx, gy, 0);
  description.gravity = gravity;
  description.cpuDispatcher = dispatcher;
  description.filterShader = top.DefaultFilterShader();
  const scene = physics.createScene(description);
  P.destroy(gravity);
  P.destroy(description);
  return scene;
}

function createBody({ mass, inertia }, defaults) {
  const same = turnableInertia({ mass, inertia }), moments = Array.isArray(inertia) ? turnableMoments({ mass, inertia }) : [same, same, same];
  const pose = new P.PxTransform(identity), tensor = new P.PxVec3(...moments);
  const body = physics.createRigidDynamic(pose);
  body.setMass(mass);
  body.setMassSpaceInertiaTensor(tensor);
  if (!defaults) {
    body.setAngularDamping(0);
    body.setSleepThreshold(0);
    body.setStabilizationThreshold(0);
    body.setMaxAngularVelocity(largestSpin);
  }
  P.destroy(tensor);
  P.destroy(pose);
  return body;
}

function world({ gravity, body: mass, cables }, { limit, tolerance, defaults }) {
  const scene = createScene(gravity), body = createBody(mass, defaults), make = jointMaker(P, physics);
  scene.addActor(body);
  const joints = limit ? cables.map((cable) => make[limit](body, cable, tolerance)) : [];
  const v = new P.PxVec3(0, 0, 0), w = new P.PxVec3(0, 0, 0), t = new P.PxTransform(identity), q = new P.PxQuat(0, 0, 0, 1);
  const limited = joints.map(() => true);
  let angle = 0;
  return {
    // a getter answers with a temporary that all getters share: it is read before the next call
    state() {
      const { p, q: turned } = body.getGlobalPose(), x = p.x, y = p.y;
      angle = unwrap(2 * Math.atan2(turned.z, turned.w), angle);
      const velocity = body.getLinearVelocity(), vx = velocity.x, vy = velocity.y;
      return [x, y, angle, vx, vy, body.getAngularVelocity().z];
    },
    place(state) {
      angle = state[2];
      [v.x, v.y, v.z] = [state[0], state[1], 0];
      [q.z, q.w] = [Math.sin(angle / 2), Math.cos(angle / 2)];
      t.p = v;
      t.q = q;
      body.setGlobalPose(t);
      this.setVelocity(...state.slice(3));
    },
    setVelocity(vx, vy, spin) {
      [v.x, v.y, v.z, w.z] = [vx, vy, 0, spin];
      body.setLinearVelocity(v);
      body.setAngularVelocity(w);
    },
    // addForceAtPos acts in the next step only
    push(jx, jy, px, py) {
      const [x, y, , vx, vy, spin] = this.state(), lighter = body.getInvMass();
      const turn = ((px - x) * jy - (py - y) * jx) * body.getMassSpaceInvInertiaTensor().z;
      this.setVelocity(vx + jx * lighter, vy + jy * lighter, spin + turn);
    },
    step(dt) {
      scene.simulate(dt);
      scene.fetchResults(true);
      angle += body.getAngularVelocity().z * dt;
    },
    pulls: joints.length > 0 ? (dt) => joints.map((joint, i) => {
      if (!limited[i]) return 0; // the force is still that of the last step in which it was
      joint.getConstraint().getForce(v, w);
      return Math.hypot(v.x, v.y) * dt;
    }) : undefined,
    limit(index, on) {
      if (on !== limited[index]) make.limit(joints[index], (limited[index] = on));
    },
    free() {
      for (const one of joints) one.release();
      body.release();
      scene.release();
      make.free();
      for (const object of [v, w, t, q]) P.destroy(object);
    },
  };
}

function system(theSystem, { limit, tolerance, defaults }) {
  if (limit) checkStraight(theSystem, "PhysX's distance joint", Unsupported);
  const scene = createScene([0, 0]), make = jointMaker(P, physics), hooks = [];
  const moving = theSystem.bodies.map((properties) => {
    const body = createBody(properties, defaults);
    body.setRigidBodyFlag(gyroscopicForces, !defaults);
    scene.addActor(body);
    return body;
  });
  const v = new P.PxVec3(0, 0, 0), w = new P.PxVec3(0, 0, 0), t = new P.PxTransform(identity), q = new P.PxQuat(0, 0, 0, 1);
  const set = (vector, [x, y, z]) => ([vector.x, vector.y, vector.z] = [x, y, z]);
  const numbers = ({ x, y, z }) => [x, y, z]; // of a temporary that all getters share
  const poseAt = (position) => {
    set(v, position);
    t.p = v;
    return t;
  };
  const createHook = (at) => {
    const body = physics.createRigidDynamic(poseAt(at));
    body.setRigidBodyFlag(P.PxRigidBodyFlagEnum.eKINEMATIC, true);
    scene.addActor(body);
    hooks.push(body);
    return body;
  };
  const ends = limit ? pairsOf(theSystem, moving, null, createHook) : [];
  const joints = ends.map(({ cable, ends: [first, second] }) => make.distance(second.body, { other: first.body, anchor: first.at, attachment: second.at, length: lengthAt(cable, 0) }, tolerance));
  return {
    bodies: moving.map((body) => ({
      read() {
        const { p, q: turned } = body.getGlobalPose(), position = numbers(p), orientation = [turned.w, ...numbers(turned)];
        return { position, orientation, velocity: numbers(body.getLinearVelocity()), turning: numbers(body.getAngularVelocity()) };
      },
      place(position, [cosine, ...axis]) {
        set(q, axis);
        q.w = cosine;
        t.q = q;
        body.setGlobalPose(poseAt(position));
      },
      setVelocity(velocity, turning) {
        set(v, velocity);
        set(w, turning);
        body.setLinearVelocity(v);
        body.setAngularVelocity(w);
      },
    })),
    setGravity(gravity) {
      set(v, gravity);
      scene.setGravity(v);
    },
    prepare(time, dt) {
      set(q, [0, 0, 0]);
      q.w = 1;
      t.q = q;
      ends.forEach(({ cable, ends: pair }, i) => {
        joints[i].setDistanceJointFlag(P.PxDistanceJointFlagEnum.eMAX_DISTANCE_ENABLED, actsAt(cable, time));
        joints[i].setMaxDistance(lengthAt(cable, time + dt));
        for (const { end, hook } of pair) hook?.setKinematicTarget(poseAt(endAt(end, time + dt)));
      });
    },
    step(dt) {
      scene.simulate(dt);
      scene.fetchResults(true);
    },
    pulls: joints.length > 0 ? (dt) => joints.map((joint, i) => {
      joint.getConstraint().getForce(v, w);
      return Math.hypot(v.x, v.y, v.z) * dt;
    }) : undefined,
    free() {
      for (const one of [...joints, ...moving, ...hooks, scene]) one.release();
      make.free();
      for (const object of [v, w, t, q]) P.destroy(object);
    },
  };
}

/** The limit is there in the steps that start overstretched: the speculative one that brakes the body is left out. */
const toggle = (world, state, cables) => cables.forEach((cable, i) => world.limit(i, cableRow(cable, state).gap <= 0));

const settings = [
  setting("angularDamping", 0, "As shipped a spin loses 5 % in a second."),
  setting("sleepThreshold, stabilizationThreshold", 0, "PhysX freezes slow bodies."),
  setting("maxAngularVelocity", largestSpin, "As shipped PhysX cuts a spin to 100 rad/s."),
];
const distance = setting("eMAX_DISTANCE_ENABLED", true, "Without it the joint limits nothing.");
const exact = [...settings, distance, setting("PxDistanceJoint.tolerance", 0, "As shipped the joint acts once the cable is overstretched by 0.025.")];
const d6 = [...settings,
  setting("eX, eY, eZ", "eLIMITED", "One distance then limits all three."),
  setting("PxJointLinearLimit.restitution", "the cable's", "As shipped it is 0."),
  setting("PxJointLinearLimit.bounceThreshold", 0, "As shipped slow impacts do not bounce.")];

const ends = [setting("setKinematicTarget, setMaxDistance", "where ends that move go, and how long cables are, at the end of a step", "PhysX knows no function of time.")];
const asShipped = [setting("eENABLE_GYROSCOPIC_FORCES", false, "As shipped: the box keeps its spin.", "engine_default")];

serve({
  name: "physx",
  version: [24, 16, 8].map((bits) => (P.PHYSICS_VERSION >> bits) & 255).join("."),
  precision: engine.precision,
  dimensions: [2, 3],
  models: [
    limitModel(engine, "distance-defaults", "The largest distance of PxDistanceJoint with its tolerance and the damping of PhysX as shipped: what one tries first.", [distance], { limit: "distance", defaults: true, inSpace: [...asShipped, ...ends] }),
    limitModel(engine, "distance", "The same joint without tolerance and damping; it has no restitution.", exact, { limit: "distance", tolerance: 0, inSpace: ends }),
    bounceModel(engine, "distance-bounce", "The same joint, and after a step in which it pulled an impulse that gives the cable's restitution.", exact, { limit: "distance", tolerance: 0, inSpace: ends }),
    atOneSpeed(limitModel(engine, "d6", "The distance limit of PxD6Joint with its restitution.", d6, { limit: "d6" }), "a limit of PhysX has one restitution"),
    atOneSpeed(limitModel(engine, "d6-toggled", "The same limit and restitution, switched on only in the steps that start overstretched.", d6, { limit: "d6", prepare: toggle }, "by_hand"), "a limit of PhysX has one restitution"),
    ...rowModels(engine, settings),
    eventModel(engine, settings),
  ],
});
