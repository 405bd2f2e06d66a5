// A cable as a joint class of its own: a one-sided row that planck's solver iterates with its other joints.

import { cableRow } from "../../protocol/javascript/cable.mjs";
import { acts, changeInStep, wantedRate } from "../common/fixed_step.mjs";

/** A row for each of `cables`; `step` [s] is the run's. */
export function solverRows(K, ground, body, gravity, cables, early, step) {
  class RowJoint extends K.Joint {
    constructor(cable) {
      super({}, ground, body);
      this.m_type = "cable-row";
      this.cable = cable;
    }
    getAnchorA() { return K.Vec2(...this.cable.anchor); }
    getAnchorB() { return body.getWorldPoint(K.Vec2(...this.cable.attachment)); }
    getReactionForce(inverseStep) { return K.Vec2(this.row.nx * this.impulse * inverseStep, this.row.ny * this.impulse * inverseStep); }
    getReactionTorque() { return 0; }

    /** `m_linearVelocity` is the velocity before this step's gravity, `c_velocity` the one after it. */
    initVelocityConstraints({ dt }) {
      const { c, a } = body.c_position, v = body.m_linearVelocity;
      const now = [c.x, c.y, a, v.x, v.y, body.m_angularVelocity];
      this.row = cableRow(this.cable, now);
      this.impulse = 0;
      this.active = acts(this.row, early, dt);
      this.wanted = wantedRate(this.row, this.cable, step, changeInStep(gravity, this.cable, this.row, now, dt));
    }

    solveVelocityConstraints() {
      if (!this.active) return;
      const { nx, ny, moment } = this.row, now = body.c_velocity;
      const rate = nx * now.v.x + ny * now.v.y + moment * now.w;
      const response = body.m_invMass + moment * moment * body.m_invI;
      const more = Math.max(-this.impulse, (this.wanted - rate) / response); // never less than none in all
      this.impulse += more;
      now.v.x += more * nx * body.m_invMass;
      now.v.y += more * ny * body.m_invMass;
      now.w += more * moment * body.m_invI;
    }

    solvePositionConstraints() { return true; }
  }
  return cables.map((cable) => new RowJoint(cable));
}
