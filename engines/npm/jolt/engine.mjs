// Jolt, held in the plane or free in space, in single precision. Its distance constraint acts once a step ends beyond the length, and has
// no restitution.

import { serve, Unsupported } from "../../protocol/javascript/engine.mjs";
import { atOneSpeed, bounceModel, eventModel, limitModel, rowModels, setting, tunable, turnableInertia, turnableMoments, unwrap } from "../common/models.mjs";
import { actsAt, checkStraight, endAt, lengthAt, pairsOf } from "../common/space.mjs";
import { softRow, springFor } from "../common/spring.mjs";
import { installedVersion } from "../common/version.mjs";

const J = await (await import("jolt-physics/wasm-compat")).default();

const engine = {
  title: "Jolt",
  precision: "float32",
  flight: { substeps: 1 },
  world,
  system,
  gyroscopicTerm: true,
  soft: ({ cables }, options) => {
    const springs = cables.map((cable) => springOf(cable, options));
    return options.limit && springs.every(({ frequency }) => frequency > 0) ? springs.map(({ frequency, damping }) => softRow({ frequency: 2 * Math.PI * frequency, ratio: damping })) : undefined;
  },
  inSpace: [
    setting("mAllowedDOFs", "All", "Bodies of a system move in space."),
    setting("mApplyGyroscopicForce", true, "As shipped Jolt leaves the gyroscopic term out: a box keeps its spin and does not turn over."),
  ],
};

/** As shipped, of velocity and spin [1/s]. */
const shippedDamping = 0.05;

/** Instead of 500 m/s and 47.1 rad/s, to which Jolt cuts a body's velocity. */
const largestSpeed = 1e6;

/** A bounce on the spring of a limit, without damping, lasts this many steps. */
const bounce = 45;

/**
 * The spring of the limit of a cable: frequency [Hz], 0 where it is stiff, and damping ratio. For the restitution where the model has one;
 * `tuned` is less the damping that Jolt's implicit method of Euler adds.
 */
function springOf({ restitution }, { spring, step, parameters = {} }) {
  if (!spring) return { frequency: 0, damping: 0, ...parameters };
  const { frequency, ratio } = springFor(restitution, step, { bounce, numerical: spring === "tuned" ? 0.5 : 0 });
  return { frequency: frequency / (2 * Math.PI), damping: ratio };
}

/** Uses what Jolt copies, and gives it back. */
function lent(object, use) {
  const result = use(object);
  J.destroy(object);
  return result;
}

/** A world of one layer, in which all meets all. */
function createJolt() {
  const pairs = new J.ObjectLayerPairFilterTable(1), layers = new J.BroadPhaseLayerInterfaceTable(1, 1);
  lent(new J.BroadPhaseLayer(0), (layer) => layers.MapObjectToBroadPhaseLayer(0, layer));
  return lent(new J.JoltSettings(), (settings) => {
    settings.mMaxWorkerThreads = 1;
    settings.mObjectLayerPairFilter = pairs;
    settings.mBroadPhaseLayerInterface = layers;
    settings.mObjectVsBroadPhaseLayerFilter = new J.ObjectVsBroadPhaseLayerFilterTable(layers, 1, pairs, 1);
    return new J.JoltInterface(settings); // frees the tables with itself
  });
}

function createBody(bodies, { mass, inertia }, defaults, inSpace = false) {
  const at = new J.RVec3(0, 0, 0), turned = new J.Quat(0, 0, 0, 1);
  const settings = new J.BodyCreationSettings(new J.SphereShape(0.1), at, turned, J.EMotionType_Dynamic, 0);
  settings.mOverrideMassProperties = J.EOverrideMassProperties_MassAndInertiaProvided;
  settings.mMassPropertiesOverride.mMass = mass;
  if (inSpace) {
    lent(new J.Vec3(...turnableMoments({ mass, inertia })), (moments) => (settings.mMassPropertiesOverride.mInertia = J.Mat44.prototype.sScaleVec3(moments)));
    settings.mApplyGyroscopicForce = !defaults;
  } else {
    settings.mMassPropertiesOverride.mInertia = J.Mat44.prototype.sScale(turnableInertia({ mass, inertia }));
    settings.mAllowedDOFs = J.EAllowedDOFs_Plane2D;
  }
  if (!defaults) {
    settings.mLinearDamping = settings.mAngularDamping = 0;
    settings.mAllowSleeping = false;
    settings.mMaxLinearVelocity = settings.mMaxAngularVelocity = largestSpeed;
  }
  const body = bodies.CreateBody(settings);
  for (const object of [settings, at, turned]) J.destroy(object);
  bodies.AddBody(body.GetID(), J.EActivation_Activate);
  return body;
}

function createLimit(system, bodies, points, length, { frequency, damping }) {
  return lent(new J.DistanceConstraintSettings(), (settings) => {
    settings.mSpace = J.EConstraintSpace_LocalToBodyCOM;
    lent(new J.RVec3(...points[0]), (point) => (settings.mPoint1 = point));
    lent(new J.RVec3(...points[1]), (point) => (settings.mPoint2 = point));
    settings.mMinDistance = 0;
    settings.mMaxDistance = length;
    settings.mLimitsSpringSettings.mFrequency = frequency;
    settings.mLimitsSpringSettings.mDamping = damping;
    const limit = settings.Create(...bodies);
    system.AddConstraint(limit);
    return J.castObject(limit, J.DistanceConstraint);
  });
}

function world({ gravity, body: mass, cables }, { limit, defaults, ...run }) {
  const jolt = createJolt(), system = jolt.GetPhysicsSystem(), bodies = system.GetBodyInterface();
  lent(new J.Vec3(...gravity, 0), (g) => system.SetGravity(g));
  const body = createBody(bodies, mass, defaults), id = body.GetID();
  // GetTotalLambdaPosition is not always what has acted: the impulses are read from the velocities
  if (limit) cables.forEach((cable) => createLimit(system, [J.Body.prototype.sFixedToWorld, body], [[...cable.anchor, 0], [...cable.attachment, 0]], cable.length, springOf(cable, run)));
  const v = new J.Vec3(0, 0, 0), w = new J.Vec3(0, 0, 0), r = new J.RVec3(0, 0, 0), q = new J.Quat(0, 0, 0, 1);
  let angle = 0;
  return {
    // a getter answers with a temporary that all getters share: it is read before the next call
    state() {
      const turned = body.GetRotation();
      angle = unwrap(2 * Math.atan2(turned.GetZ(), turned.GetW()), angle);
      const position = body.GetPosition(), x = position.GetX(), y = position.GetY();
      const velocity = body.GetLinearVelocity(), vx = velocity.GetX(), vy = velocity.GetY();
      return [x, y, angle, vx, vy, body.GetAngularVelocity().GetZ()];
    },
    place(state) {
      angle = state[2];
      r.Set(state[0], state[1], 0);
      q.Set(0, 0, Math.sin(angle / 2), Math.cos(angle / 2));
      bodies.SetPositionAndRotation(id, r, q, J.EActivation_Activate);
      this.setVelocity(...state.slice(3));
    },
    setVelocity(vx, vy, spin) {
      v.Set(vx, vy, 0);
      w.Set(0, 0, spin);
      body.SetLinearVelocity(v);
      body.SetAngularVelocity(w);
    },
    push(jx, jy, px, py) {
      v.Set(jx, jy, 0);
      r.Set(px, py, 0);
      body.AddImpulse(v, r);
    },
    step(dt) {
      jolt.Step(dt, 1);
      angle += body.GetAngularVelocity().GetZ() * dt;
    },
    free() {
      for (const object of [v, w, r, q, jolt]) J.destroy(object);
    },
  };
}

/** A body that goes where it is told. */
function createHook(bodies, at) {
  const place = new J.RVec3(...at), turned = new J.Quat(0, 0, 0, 1);
  const body = lent(new J.BodyCreationSettings(new J.SphereShape(0.1), place, turned, J.EMotionType_Kinematic, 0), (settings) => bodies.CreateBody(settings));
  for (const object of [place, turned]) J.destroy(object);
  bodies.AddBody(body.GetID(), J.EActivation_Activate);
  return body;
}

function system(theSystem, { limit, defaults, ...run }) {
  if (limit) checkStraight(theSystem, "Jolt's distance constraint", Unsupported);
  const jolt = createJolt(), physics = jolt.GetPhysicsSystem(), bodies = physics.GetBodyInterface();
  const moving = theSystem.bodies.map((body) => createBody(bodies, body, defaults, true));
  const ends = limit ? pairsOf(theSystem, moving, J.Body.prototype.sFixedToWorld, (at) => createHook(bodies, at)) : [];
  const limits = ends.map(({ cable, ends: pair }) => createLimit(physics, pair.map(({ body }) => body), pair.map(({ at }) => at), lengthAt(cable, 0), springOf(cable, run)));
  const v = new J.Vec3(0, 0, 0), w = new J.Vec3(0, 0, 0), r = new J.RVec3(0, 0, 0), q = new J.Quat(0, 0, 0, 1), level = new J.Quat(0, 0, 0, 1);
  const numbers = (vector) => [vector.GetX(), vector.GetY(), vector.GetZ()]; // of a temporary that all getters share
  return {
    bodies: moving.map((body) => ({
      read() {
        const turned = body.GetRotation(), orientation = [turned.GetW(), ...numbers(turned)];
        return { position: numbers(body.GetPosition()), orientation, velocity: numbers(body.GetLinearVelocity()), turning: numbers(body.GetAngularVelocity()) };
      },
      place(position, [cosine, ...axis]) {
        r.Set(...position);
        q.Set(...axis, cosine);
        bodies.SetPositionAndRotation(body.GetID(), r, q, J.EActivation_Activate);
      },
      setVelocity(velocity, turning) {
        v.Set(...velocity);
        w.Set(...turning);
        body.SetLinearVelocity(v);
        body.SetAngularVelocity(w);
      },
    })),
    setGravity(gravity) {
      v.Set(...gravity);
      physics.SetGravity(v);
    },
    prepare(time, dt) {
      ends.forEach(({ cable, ends: pair }, i) => {
        limits[i].SetEnabled(actsAt(cable, time));
        limits[i].SetDistance(0, lengthAt(cable, time + dt));
        for (const { end, hook } of pair) {
          if (!hook) continue;
          r.Set(...endAt(end, time + dt));
          bodies.MoveKinematic(hook.GetID(), r, level, dt);
        }
      });
    },
    step: (dt) => jolt.Step(dt, 1),
    free() {
      for (const object of [v, w, r, q, level, jolt]) J.destroy(object);
    },
  };
}

const shipped = [setting("mAllowedDOFs", "Plane2D", "The cases are planar.")];
const settings = [
  ...shipped,
  setting("mLinearDamping, mAngularDamping", 0, "As shipped a body loses 5 % of its speed in a second."),
  setting("mAllowSleeping", false, "As shipped a body slower than 0.03 m/s for half a second is frozen."),
  setting("mMaxLinearVelocity, mMaxAngularVelocity", largestSpeed, "As shipped Jolt cuts a velocity to 500 m/s and 47.1 rad/s."),
];
const range = setting("mMinDistance, mMaxDistance", "0, the cable's length", "As shipped the constraint is a rod.");

const springs = (ratio) => [range,
  setting("mLimitsSpringSettings.mFrequency", `1 / (${2 * bounce} step)`, `Without damping a bounce lasts ${bounce} steps.`),
  setting("mLimitsSpringSettings.mDamping", ratio, "A spring and a damper have a restitution; the constraint has none.")];

const ends = [setting("MoveKinematic, SetDistance, SetEnabled", "where ends that move go, how long cables are, and which act, at the end of a step", "Jolt knows no function of time.")];
const asShipped = [setting("mApplyGyroscopicForce", false, "As shipped: the box keeps its spin.", "engine_default")];

serve({
  name: "jolt",
  version: installedVersion(import.meta.url, "jolt-physics"),
  precision: engine.precision,
  dimensions: [2, 3],
  models: [
    tunable(limitModel(engine, "distance", "The largest distance of Jolt's DistanceConstraint, which has no restitution: what one tries first.", [...settings, range], { inSpace: ends }),
      "settings.mLimitsSpringSettings.mFrequency = {frequency}; settings.mLimitsSpringSettings.mDamping = {damping};",
      [{ name: "damping", low: 0, high: 1 }, { name: "frequency", low: 0.0033, high: 0.05, scale: "log", step_power: -1 }]),
    limitModel({ ...engine, gyroscopicTerm: false }, "distance-defaults", "The same constraint on a body that is damped and put to sleep as Jolt ships it.", [...shipped, range], { defaults: true, left: (dt) => [1 - shippedDamping * dt, 1 - shippedDamping * dt], inSpace: [...asShipped, ...ends] }),
    atOneSpeed(limitModel(engine, "limit-spring", "The same constraint with a spring and a damper whose bounce would have the cable's restitution, by its closed form.", [...settings, ...springs("the ratio of the restitution e = exp(-2 ratio acos(ratio) / sqrt(1 - ratio^2))")], { spring: "closed form", inSpace: ends }), "a limit of Jolt has one spring"),
    atOneSpeed(limitModel(engine, "limit-spring-tuned", "The same less the damping that Jolt's own steps add.", [...settings, ...springs("that ratio less pi mFrequency step, what the implicit method of Euler adds; 0 at least")], { spring: "tuned", inSpace: ends }), "a limit of Jolt has one spring"),
    bounceModel(engine, "distance-bounce", "The same constraint, undamped, and after a step in which it pulled an impulse that gives the cable's restitution.", [...settings, range], { inSpace: ends }),
    ...rowModels(engine, settings),
    eventModel(engine, settings),
  ],
});
