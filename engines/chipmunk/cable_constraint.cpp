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

CableConstraint::CableConstraint(World& world) {
  cpConstraintInit(&constraint_, &callbacks, world.ground(), world.body());
  cpConstraintSetUserData(&constraint_, this);
}

CableConstraint::~CableConstraint() {
  if (constraint_.space != nullptr) {
    cpSpaceRemoveConstraint(constraint_.space, &constraint_);
  }
}

void CableConstraint::pull(const CableRow& row, double rate) {
  row_ = row;
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

/// The row is told what it asks for before this.
void CableConstraint::prepare(cpConstraint* /*constraint*/, cpFloat /*dt*/) {}

/// The impulse of a bounce is no guess for the next step.
void CableConstraint::apply_cached(cpConstraint* /*constraint*/, cpFloat /*dt*/) {}

void CableConstraint::apply_once(cpConstraint* constraint, cpFloat /*dt*/) {
  self(constraint).apply();
}

cpFloat CableConstraint::impulse_of(cpConstraint* constraint) { return self(constraint).impulse_; }

CableConstraints::CableConstraints(const Case& the_case, World& world) {
  for (std::size_t index = 0; index < the_case.cables.size(); ++index) {
    rows_.push_back(std::make_unique<CableConstraint>(world));
  }
}

}  // namespace tautline::chipmunk
