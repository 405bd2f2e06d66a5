// A cable as a constraint of its own: a one-sided equation that p2's solver iterates with its other equations.

import { cableRow } from "../../protocol/javascript/cable.mjs";
import { acts, changeInStep, wantedRate } from "../common/fixed_step.mjs";

/** `step` [s] is the run's, `dt()` [s] the one that is being made. */
export function solverRow(C, ground, body, gravity, cable, early, step, state, dt) {
  const constraint = new C.Constraint(ground, body, C.Constraint.DISTANCE, {});
  const equation = new C.Equation(ground, body, 0, Number.MAX_VALUE); // pulls, and does not push
  constraint.equations = [equation];
  let wanted = 0;
  equation.update = () => {
    equation.epsilon = 0; // a row without a spring
    equation.needsUpdate = false;
  };
  equation.computeB = (a, b, h) => wanted - equation.computeGW() - h * equation.computeGiMf();
  constraint.update = () => {
    const now = state(), row = cableRow(cable, now);
    wanted = wantedRate(row, cable, step, changeInStep(gravity, cable, row, now, dt()));
    equation.enabled = acts(row, early, dt());
    equation.G.set([0, 0, 0, row.nx, row.ny, row.moment]);
  };
  return constraint;
}
