// A cable as a constraint of its own in cannon's solver: a one-sided row, or a contact at the length.

import { cableRow } from "../../protocol/javascript/cable.mjs";
import { acts, changeInStep, wantedRate } from "../common/fixed_step.mjs";

/** An impulse of more than this is cut off by the equation [N s]: none is. */
const largestImpulse = 1e12;

/** A contact's stiffness and relaxation [N/m], [steps], as stiff as a cable and as cannon relaxes its contacts. */
const contactStiffness = 1e12, contactRelaxation = 4;

/** `step` [s] is the run's, `dt()` [s] the one that is being made. */
export function solverRow(C, ground, body, gravity, cable, kind, early, step, state, dt) {
  const constraint = new C.Constraint(ground, body);
  const equation = kind === "contact" ? new C.ContactEquation(ground, body) : new C.Equation(ground, body, 0, largestImpulse);
  equation.minForce = 0; // pulls, and does not push
  equation.maxForce = largestImpulse;
  constraint.equations.push(equation);
  let row, most;
  if (kind === "row") {
    equation.eps = 0; // without a spring
    equation.computeB = (h) => wantedRate(row, cable, step, most) - equation.computeGW() - h * equation.computeGiMf();
  } else {
    equation.restitution = cable.restitution;
  }
  constraint.update = () => {
    const now = state();
    row = cableRow(cable, now);
    most = changeInStep(gravity, cable, row, now, dt());
    const { nx, ny, moment, px, py } = row, { anchor, length } = cable;
    equation.enabled = acts(row, early, dt());
    if (kind === "contact") {
      // the body touches from within the circle of the cable's length around the anchor
      equation.ni.set(nx, ny, 0);
      equation.rj.set(px - now[0], py - now[1], 0);
      equation.ri.set(anchor[0] - nx * length, anchor[1] - ny * length, 0);
      equation.setSpookParams(contactStiffness, contactRelaxation, dt());
    } else {
      equation.jacobianElementB.spatial.set(nx, ny, 0);
      equation.jacobianElementB.rotational.set(0, 0, moment);
    }
  };
  return constraint;
}
