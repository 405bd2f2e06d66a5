#include "cable_constraint.hpp"

#include <algorithm>

namespace tautline::chipmunk {
namespace {

CableConstraint& self(cpConstraint* constraint) {
  return *static_cast<CableConstraint*>(cpConstraintGetUserData(constraint));
}

}  // namespace

const cpConstraintClass CableConstraint::callbacks = {prepare, apply_cached, apply_once,
                                                      impulse_of};

CableConstraint::CableConstraint(World& world, const Cable& cable) : cable_(cable) {
  cpConstraintInit(&constraint_, &callbacks, world.ground(), world.body());
  cpConstraintSetUserData(&constraint_, this);
}

void CableConstraint::pull(double rate) {
  row_ = cable_row(cable_, state_of(constraint_.b));
  rate_ = rate;
  impulse_ = 0.0;
  acts_ = true;
}

void CableConstraint::let_go() {
  acts_ = false;
  impulse_ = 0.0;
}

double CableConstraint::apply() {
  if (!acts_) {
    return 0.0;
  }
  cpBody* body = constraint_.b;
  const double response =
      body->m_inv + body->i_inv * row_.moment * row_.moment;  // of the rate to an impulse [1/kg]
  const double rate =
      cpvdot(body->v, vector(row_.towards)) + row_.moment * body->w;  // at the row's pose
  const double before = impulse_;
  impulse_ = std::max(0.0, before + (rate_ - rate) / response);
  const double impulse = impulse_ - before;
  body->v = cpvadd(body->v, cpvmult(vector(row_.towards), impulse * body->m_inv));
  body->w += impulse * body->i_inv * row_.moment;
  return impulse * response;
}

/// Chipmunk calls this after the body has moved and before gravity has changed its velocity.
void CableConstraint::prepare(cpConstraint* constraint, cpFloat dt) {
  CableConstraint& cable = self(constraint);
  cable.let_go();
  if (!cable.how_) {
    return;
  }
  const CableRow row = cable_row(cable.cable_, state_of(constraint->b));
  if (acts(row, cable.how_->activation, dt)) {
    cable.pull(wanted_rate(row, restitution(cable.cable_, row.rate), cable.how_->correction));
  }
}

/// The impulse of a bounce is no guess for the next step.
void CableConstraint::apply_cached(cpConstraint* /*constraint*/, cpFloat /*dt*/) {}

void CableConstraint::apply_once(cpConstraint* constraint, cpFloat /*dt*/) {
  self(constraint).apply();
}

cpFloat CableConstraint::impulse_of(cpConstraint* constraint) { return self(constraint).impulse_; }

std::vector<std::unique_ptr<CableConstraint>> cable_constraints(const Case& the_case,
                                                                World& world) {
  std::vector<std::unique_ptr<CableConstraint>> result;
  for (const Cable& cable : the_case.cables) {
    result.push_back(std::make_unique<CableConstraint>(world, cable));
  }
  return result;
}

}  // namespace tautline::chipmunk
