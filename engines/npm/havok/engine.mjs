// Havok, in single precision; in space without the gyroscopic term, for which it has no setting. Its limit on the distance looks ahead, lands the body on the length and has no restitution.
// It brakes bodies slower than about 0.1 m/s, whatever is set: lengths are scaled, so that no body of a case is so slow.

import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { serve, Unsupported } from "../../protocol/javascript/engine.mjs";
import { bounceModel, eventModel, limitModel, rowModels, setting, turnableInertia, turnableMoments, unwrap } from "../common/models.mjs";
import { actsAt, checkStraight, endAt, lengthAt, pairsOf } from "../common/space.mjs";
import { installedVersion } from "../common/version.mjs";

// node has no address to fetch the WebAssembly from: it is handed over
const wasm = createRequire(import.meta.url).resolve("@babylonjs/havok").replace(/[^/]*$/, "HavokPhysics.wasm");
const H = await (await import("@babylonjs/havok")).default({ wasmBinary: readFileSync(wasm) });

/** Havok moves a body in 4 substeps, without a setting, and turns it by a series: off by 1e-5 at 0.8 rad, 3e-8 at 0.25. */
const engine = {
  title: "Havok",
  precision: "float32",
  flight: { substeps: 4, exactTurn: 0.25 },
  world,
  system,
  inSpace: [setting("units of mass and length", "mass 1 for the heaviest body", "Havok keeps the inverses of three moments in 8 bits: they are off by up to 0.4 %.")],
};

/** Havok's lengths in one of the case's [-], at least: a slow body is braked at 1/64 of the speed. */
const leastScale = 64;

/**
 * Havok keeps the inverses of mass and inertia in 8 bits: of 12 kg it makes 11.98. In units in which the mass is 1 and the
 * inertia a power of two it keeps both.
 */
function unitsOf({ mass, inertia }) {
  const perMass = turnableInertia({ mass, inertia }) / mass;
  return { length: Math.sqrt(2 ** Math.ceil(Math.log2(leastScale ** 2 * perMass)) / perMass), mass };
}

/** As shipped, of the spin [1/s]. */
const shippedDamping = 0.1;

/** Instead of 200 m/s and 100 rad/s, to which Havok cuts a velocity as it is set. */
const largestSpeed = 1e6;

/** The value of an answer, or an exception. */
function told(answer) {
  const [result, value] = Array.isArray(answer) ? answer : [answer];
  if (result !== H.Result.RESULT_OK) throw new Error(`Havok answers with result ${result?.value ?? result}`);
  return value;
}

function createBody(w, type) {
  const body = told(H.HP_Body_Create()), shape = told(H.HP_Shape_CreateSphere([0, 0, 0], 0.1));
  told(H.HP_Body_SetMotionType(body, type));
  told(H.HP_Shape_SetFilterInfo(shape, [0, 0])); // meets nothing
  told(H.HP_Body_SetShape(body, shape));
  return body;
}

function createLimit(ground, body, { anchor, attachment, length }, scale) {
  const limit = told(H.HP_Constraint_Create()), axis = H.ConstraintAxis.LINEAR_DISTANCE;
  const point = ([x, y, z = 0]) => [scale * x, scale * y, scale * z], x = [1, 0, 0], y = [0, 1, 0];
  told(H.HP_Constraint_SetParentBody(limit, ground));
  told(H.HP_Constraint_SetChildBody(limit, body));
  told(H.HP_Constraint_SetAnchorInParent(limit, point(anchor), x, y));
  told(H.HP_Constraint_SetAnchorInChild(limit, point(attachment), x, y));
  H.HP_Constraint_SetAxisMode(limit, axis, H.ConstraintAxisLimitMode.LIMITED); // says that it is invalid, and works
  told(H.HP_Constraint_SetAxisMinLimit(limit, axis, 0));
  told(H.HP_Constraint_SetAxisMaxLimit(limit, axis, scale * length));
  told(H.HP_Constraint_SetEnabled(limit, 1));
  return limit;
}

function world({ gravity, body: { mass, inertia }, cables }, { limit, defaults }) {
  const units = defaults ? { length: 1, mass: 1 } : unitsOf({ mass, inertia }), scale = units.length;
  const w = told(H.HP_World_Create()), same = (scale ** 2 * turnableInertia({ mass, inertia })) / mass;
  told(H.HP_World_SetGravity(w, [scale * gravity[0], scale * gravity[1], 0]));
  const body = createBody(w, H.MotionType.DYNAMIC), ground = createBody(w, H.MotionType.STATIC);
  told(H.HP_Body_SetMassProperties(body, [[0, 0, 0], mass / units.mass, [same, same, same], [0, 0, 0, 1]])); // an inertia of 1 kg
  told(H.HP_Body_SetActivationControl(body, H.ActivationControl.ALWAYS_ACTIVE));
  if (!defaults) {
    told(H.HP_World_SetSpeedLimit(w, largestSpeed, largestSpeed));
    told(H.HP_Body_SetAngularDamping(body, 0));
  }
  for (const one of [body, ground]) told(H.HP_World_AddBody(w, one, false));
  const limits = limit ? cables.map((cable) => createLimit(ground, body, cable, scale)) : [];
  let angle = 0, ideal = 0;
  return {
    state() {
      const [x, y] = told(H.HP_Body_GetPosition(body)), turned = told(H.HP_Body_GetOrientation(body));
      const [vx, vy] = told(H.HP_Body_GetLinearVelocity(body));
      angle = unwrap(2 * Math.atan2(turned[2], turned[3]), angle);
      return [x / scale, y / scale, angle, vx / scale, vy / scale, told(H.HP_Body_GetAngularVelocity(body))[2]];
    },
    place([x, y, turned, ...velocity]) {
      angle = turned;
      told(H.HP_Body_SetQTransform(body, [[scale * x, scale * y, 0], [0, 0, Math.sin(angle / 2), Math.cos(angle / 2)]]));
      this.setVelocity(...velocity);
    },
    setVelocity(vx, vy, spin) {
      told(H.HP_Body_SetLinearVelocity(body, [scale * vx, scale * vy, 0]));
      told(H.HP_Body_SetAngularVelocity(body, [0, 0, spin]));
    },
    push: (jx, jy, px, py) => told(H.HP_Body_ApplyImpulse(body, [scale * px, scale * py, 0], [(scale * jx) / units.mass, (scale * jy) / units.mass, 0])),
    step(dt) {
      if (dt !== ideal) told(H.HP_World_SetIdealStepTime(w, (ideal = dt)));
      told(H.HP_World_Step(w, dt));
      angle += told(H.HP_Body_GetAngularVelocity(body))[2] * dt;
    },
    free() {
      for (const one of limits) H.HP_Constraint_Release(one);
      for (const one of [body, ground]) {
        H.HP_World_RemoveBody(w, one);
        H.HP_Shape_Release(told(H.HP_Body_GetShape(one)));
        H.HP_Body_Release(one);
      }
      H.HP_World_Release(w);
    },
  };
}

function system(theSystem, { limit, defaults }) {
  if (limit) checkStraight(theSystem, "Havok's limit on the distance", Unsupported);
  const heaviest = Math.max(...theSystem.bodies.map(({ mass }) => mass)), scale = defaults ? 1 : leastScale;
  const w = told(H.HP_World_Create()), level = [0, 0, 0, 1], times = (v) => v.map((number) => scale * number);
  const create = (type) => {
    const body = createBody(w, type);
    told(H.HP_Body_SetActivationControl(body, H.ActivationControl.ALWAYS_ACTIVE));
    return body;
  };
  const moving = theSystem.bodies.map(({ mass, inertia }) => {
    const body = create(H.MotionType.DYNAMIC), perMass = turnableMoments({ mass, inertia }).map((moment) => (scale ** 2 * moment) / mass);
    told(H.HP_Body_SetMassProperties(body, [[0, 0, 0], mass / (defaults ? 1 : heaviest), perMass, level]));
    if (!defaults) told(H.HP_Body_SetAngularDamping(body, 0));
    return body;
  });
  if (!defaults) told(H.HP_World_SetSpeedLimit(w, largestSpeed, largestSpeed));
  const all = [...moving], added = (body) => (all.push(body), body), ground = added(createBody(w, H.MotionType.STATIC));
  const createHook = (at) => {
    const hook = added(create(H.MotionType.KINEMATIC));
    told(H.HP_Body_SetQTransform(hook, [times(at), level]));
    return hook;
  };
  const ends = limit ? pairsOf(theSystem, moving, ground, createHook) : [];
  for (const body of all) told(H.HP_World_AddBody(w, body, false));
  const limits = ends.map(({ cable, ends: [first, second] }) => createLimit(first.body, second.body, { anchor: first.at, attachment: second.at, length: lengthAt(cable, 0) }, scale));
  let ideal = 0;
  return {
    bodies: moving.map((body) => ({
      read() {
        const [position, [x, y, z, cosine]] = told(H.HP_Body_GetQTransform(body));
        return { position: position.map((number) => number / scale), orientation: [cosine, x, y, z],
          velocity: told(H.HP_Body_GetLinearVelocity(body)).map((number) => number / scale), turning: told(H.HP_Body_GetAngularVelocity(body)) };
      },
      place: (position, [cosine, ...axis]) => told(H.HP_Body_SetQTransform(body, [times(position), [...axis, cosine]])),
      setVelocity(velocity, turning) {
        told(H.HP_Body_SetLinearVelocity(body, times(velocity)));
        told(H.HP_Body_SetAngularVelocity(body, turning));
      },
    })),
    setGravity: (gravity) => told(H.HP_World_SetGravity(w, times(gravity))),
    prepare(time, dt) {
      ends.forEach(({ cable, ends: pair }, i) => {
        told(H.HP_Constraint_SetEnabled(limits[i], actsAt(cable, time) ? 1 : 0));
        told(H.HP_Constraint_SetAxisMaxLimit(limits[i], H.ConstraintAxis.LINEAR_DISTANCE, scale * lengthAt(cable, time + dt)));
        for (const { end, hook } of pair) if (hook) told(H.HP_Body_SetTargetQTransform(hook, [times(endAt(end, time + dt)), level]));
      });
    },
    step(dt) {
      if (dt !== ideal) told(H.HP_World_SetIdealStepTime(w, (ideal = dt)));
      told(H.HP_World_Step(w, dt));
    },
    free() {
      for (const one of limits) H.HP_Constraint_Release(one);
      for (const one of all) {
        H.HP_World_RemoveBody(w, one);
        H.HP_Shape_Release(told(H.HP_Body_GetShape(one)));
        H.HP_Body_Release(one);
      }
      H.HP_World_Release(w);
    },
  };
}

const ideal = setting("HP_World_SetIdealStepTime", "the step", "Havok tunes its solver for 1/60 s.");
const active = setting("HP_Body_SetActivationControl", "ALWAYS_ACTIVE", "Havok puts slow bodies to sleep.");
const mode = setting("HP_Constraint_SetAxisMode", "LIMITED on LINEAR_DISTANCE", "As shipped a constraint limits nothing.");
const settings = [
  active,
  ideal,
  setting("unit of length", `1/${leastScale} m or less`, "Havok brakes a body slower than about 0.1 of its units a second to a stand."),
  setting("units of mass and length", "mass 1, inertia a power of two", "Havok keeps the inverses of both in 8 bits."),
  setting("HP_Body_SetAngularDamping", 0, "As shipped a spin loses a tenth in a second."),
  setting("HP_World_SetSpeedLimit", largestSpeed, "As shipped Havok cuts a velocity to 200 m/s and 100 rad/s."),
];

const ends = [setting("HP_Body_SetTargetQTransform, HP_Constraint_SetAxisMaxLimit", "where ends that move go, and how long cables are, at the end of a step", "Havok knows no function of time.")];

serve({
  name: "havok",
  version: installedVersion(import.meta.url, "@babylonjs/havok"),
  precision: engine.precision,
  dimensions: [2, 3],
  models: [
    limitModel(engine, "distance-defaults", "Havok's limit on the distance on a body that is damped, and braked where it is slow, as Havok ships it: what one tries first.", [active, ideal, mode], { defaults: true, left: (dt) => [1, 1 - shippedDamping * dt], inSpace: ends }),
    limitModel(engine, "distance", "The same limit, undamped and with scaled lengths; it has no restitution.", [...settings, mode], { inSpace: ends }),
    bounceModel(engine, "distance-bounce", "The same limit, undamped and with scaled lengths, and after a step in which it pulled an impulse that gives the cable's restitution.", [...settings, mode], { inSpace: ends }),
    ...rowModels(engine, settings),
    eventModel(engine, settings),
  ],
});
