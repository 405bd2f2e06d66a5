// MuJoCo 3, in doubles, on three joints in the plane or free ones in space. A cable is the upper limit of a spatial tendon: beyond its length a
// spring and a damper, which a user tunes to the restitution.

import { serve } from "../../protocol/javascript/engine.mjs";
import { atOneSpeed, eventModel, limitModel, rowModels, setting, tunable, turnableInertia, turnableMoments } from "../common/models.mjs";
import { actsAt, endAt, isGiven, lengthAt } from "../common/space.mjs";
import { bodiesOf, rotated, rotatedBack } from "../../protocol/javascript/space.mjs";
import { softRow, springFor } from "../common/spring.mjs";

const M = await (await import("@mujoco/mujoco")).default();

const engine = {
  title: "MuJoCo",
  precision: "float64",
  // by the method of Runge and Kutta, which is the parabola: its Euler method turns a body to first order
  flight: { substeps: 1, inSpace: { substeps: Infinity } },
  world,
  system,
  gyroscopicTerm: true,
  inSpace: [setting("joints", "free", "Bodies of a system move in space.")],
};

/** MuJoCo calls a velocity beyond this unstable [m/s] and puts the body back where it started, without an exception. */
const largestSpeed = 1e10;
engine.flight.speed = largestSpeed;

/** The constraint's impedance: as near to 1 as MuJoCo lets it, so that the limit takes over this part of the load [-]. */
const fullImpedance = 0.9999, impedance = `${fullImpedance} ${fullImpedance} 1 0.5 1`;

/** The spring of a tuned limit, whose bounce lasts 20 steps, or the one that a run sets. */
const springOf = ({ restitution }, { step, parameters }) => ({ ...softRow(springFor(restitution, step, { bounce: 20 })), ...parameters });
engine.soft = ({ cables }, { limit, ...run }) => (limit === "tuned" ? cables.map((cable) => ({ ...springOf(cable, run), load: fullImpedance })) : undefined);

function limitOf(cable, limit, step, parameters) {
  if (!limit) return "";
  const range = `limited="true" range="0 ${cable.length}"`;
  if (limit === "defaults") return range;
  const { stiffness, damping } = springOf(cable, { step, parameters });
  return `${range} solreflimit="${-stiffness} ${-damping}" solimplimit="${impedance}"`;
}

function xmlOf({ gravity, body: { mass, inertia }, cables }, limit, step, parameters) {
  const same = turnableInertia({ mass, inertia });
  const each = (text) => cables.map(text).join("");
  return `<mujoco><compiler autolimits="false" inertiafromgeom="false"/>
<option gravity="${gravity.join(" ")} 0" timestep="${step}" jacobian="dense" tolerance="0"/>
<worldbody>${each(({ anchor }, i) => `<site name="anchor${i}" pos="${anchor.join(" ")} 0"/>`)}
<body name="body"><joint type="slide" axis="1 0 0"/><joint type="slide" axis="0 1 0"/><joint type="hinge" axis="0 0 1"/>
<inertial pos="0 0 0" mass="${mass}" diaginertia="${same} ${same} ${same}"/>
${each(({ attachment }, i) => `<site name="attachment${i}" pos="${attachment.join(" ")} 0"/>`)}</body></worldbody>
<tendon>${each((cable, i) => `<spatial ${limitOf(cable, limit, step, parameters)}><site site="anchor${i}"/><site site="attachment${i}"/></spatial>`)}</tendon></mujoco>`;
}

/** The step of a world, and its end. */
const stepping = (model, data, options) => ({
  step(dt) {
    options.timestep = dt;
    M.mj_step(model, data);
  },
  free() {
    options.delete();
    data.delete();
    model.delete();
  },
});

function world(theCase, { limit, step, parameters }) {
  const { mass } = theCase.body, inertia = turnableInertia(theCase.body);
  const model = M.MjModel.from_xml_string(xmlOf(theCase, limit, step, parameters)), data = new M.MjData(model), options = model.opt;
  return {
    // views of the heap die as it grows: they are taken anew
    state: () => [...data.qpos, ...data.qvel],
    place([x, y, angle, ...velocity]) {
      data.qpos.set([x, y, angle]);
      data.qacc_warmstart.fill(0);
      this.setVelocity(...velocity);
    },
    setVelocity: (...velocity) => data.qvel.set(velocity),
    push(jx, jy, px, py) {
      const [x, y, , vx, vy, spin] = this.state();
      this.setVelocity(vx + jx / mass, vy + jy / mass, spin + ((px - x) * jy - (py - y) * jx) / inertia);
    },
    ...stepping(model, data, options),
  };
}

/** The model of a system. An end that moves is a mocap body; a ring is a site that the tendon goes through. */
function systemXml({ bodies, cables }, start, limit, step, parameters, exact) {
  const site = (i, k) => `<site name="cable${i}end${k}" pos="`;
  const sites = (here) => cables.flatMap(({ ends }, i) => ends.map((end, k) => (here(end) ? `${site(i, k)}${end.at.join(" ")}"/>` : ""))).join("");
  const moved = cables.flatMap(({ ends }, i) => ends.map((end, k) => (isGiven(end) ? `<body mocap="true" pos="${endAt(end, 0).join(" ")}">${site(i, k)}0 0 0"/></body>` : "")));
  const body = ({ mass, inertia }, i) => `<body pos="${start[i].position.join(" ")}" quat="${start[i].orientation.join(" ")}"><freejoint/>
<inertial pos="0 0 0" mass="${mass}" diaginertia="${turnableMoments({ mass, inertia }).join(" ")}"/>${sites((end) => end.body === i)}</body>`;
  const tendon = (cable, i) => `<spatial ${limitOf({ ...cable, length: lengthAt(cable, 0) }, limit, step, parameters)}>${cable.ends.map((_, k) => `<site site="cable${i}end${k}"/>`).join("")}</spatial>`;
  return `<mujoco><compiler autolimits="false" inertiafromgeom="false"/>
<option integrator="${exact ? "RK4" : "Euler"}" timestep="${step}" jacobian="dense" tolerance="0"/>
<worldbody>${sites((end) => end.body === undefined && !isGiven(end))}${bodies.map(body).join("")}${moved.join("")}</worldbody>
<tendon>${cables.map(tendon).join("")}</tendon></mujoco>`;
}

/** No tendon is as long [m]. */
const farAway = 1e10;

function system(theSystem, { limit, step, parameters, exact }) {
  const { cables } = theSystem, start = bodiesOf(theSystem.initial);
  const model = M.MjModel.from_xml_string(systemXml(theSystem, start, limit, step, parameters, exact)), data = new M.MjData(model), options = model.opt;
  return {
    bodies: start.map((_, i) => ({
      read() {
        const pose = data.qpos.slice(7 * i, 7 * i + 7), rates = data.qvel.slice(6 * i, 6 * i + 6), orientation = [...pose.slice(3)];
        return { position: [...pose.slice(0, 3)], orientation, velocity: [...rates.slice(0, 3)], turning: rotated(orientation, rates.slice(3)) };
      },
      place(position, orientation) {
        data.qpos.set([...position, ...orientation], 7 * i);
        data.qacc_warmstart.fill(0);
      },
      setVelocity(velocity, turning) { // a spin is in the axes of the body
        data.qvel.set([...velocity, ...rotatedBack(data.qpos.slice(7 * i + 3, 7 * i + 7), turning)], 6 * i);
      },
    })),
    setGravity: (gravity) => options.gravity.set(gravity),
    /** MuJoCo's limit looks at where ends and lengths are as a step starts. */
    prepare(time) {
      let mocap = 0;
      cables.forEach((cable, i) => {
        for (const end of cable.ends) if (isGiven(end)) data.mocap_pos.set(endAt(end, time), 3 * mocap++);
        // what is cut is long: the package cannot read tendon_limited
        if (limit) model.tendon_range[2 * i + 1] = actsAt(cable, time) ? lengthAt(cable, time) : farAway;
      });
    },
    ...stepping(model, data, options),
  };
}

const planar = [
  setting("joints", "two slides and a hinge", "The cases are planar; a free joint would hold the angle as a quaternion."),
  setting("jacobian, tolerance", "dense, 0", "A few rows are solved to the last bit."),
];
const moving = [setting("mocap_pos, tendon_range", "where ends that move are, and how long cables are, as a step starts; a cable that is cut is long", "MuJoCo knows no function of time, and no speed of such an end.")];
const limited = setting("tendon limited, range", "true, up to the cable's length", "Without them a tendon limits nothing.");

serve({
  name: "mujoco3",
  version: M.mj_versionString(),
  precision: engine.precision,
  dimensions: [2, 3],
  models: [
    limitModel(engine, "tendon-limit-defaults", "The limit of a spatial tendon with the soft spring that MuJoCo ships: what one tries first.", [...planar, limited], { limit: "defaults", inSpace: moving }),
    tunable(atOneSpeed(limitModel(engine, "tendon-limit", "The same limit with a spring and a damper whose bounce of 20 steps has the cable's restitution.", [...planar, limited,
      setting("solreflimit", "of the restitution and the step", "MuJoCo has no restitution; a spring and a damper have one."),
      setting("solimplimit", impedance, "The spring acts in full at any overstretch.")], { limit: "tuned", inSpace: moving }), "a limit of MuJoCo has one spring"),
      `<spatial limited="true" solreflimit="-{stiffness} -{damping}" solimplimit="${impedance}">`,
      [{ name: "damping", low: 1e-4, high: 1, scale: "log", step_power: -1 }, { name: "stiffness", low: 4.4e-4, high: 0.1, scale: "log", step_power: -2 }]),
    ...rowModels(engine, planar),
    eventModel(engine, planar, { inSpace: [setting("integrator", "RK4", "It flies the parabola, and turns a body to second order: Euler turns it to first.")] }),
  ],
});
