#include "system.hpp"

#include <cmath>
#include <limits>

#include <Interaction.hpp>
#include <LagrangianLinearTIDS.hpp>
#include <NewtonImpactNSL.hpp>
#include <NonSmoothDynamicalSystem.hpp>
#include <SiconosException.hpp>
#include <SiconosVector.hpp>
#include <SimpleMatrix.hpp>
#include <SimulationGraphs.hpp>
#include <Topology.hpp>

#include "cable_relation.hpp"
#include "tautline/geometry.hpp"

namespace tautline::siconos_engine {
namespace {

SP::SiconosVector vector(double x, double y, double z) {
  auto result = std::make_shared<SiconosVector>(3);
  (*result)(0) = x;
  (*result)(1) = y;
  (*result)(2) = z;
  return result;
}

std::shared_ptr<LagrangianDS> body_of(const Case& the_case, const State& start) {
  const double mass = the_case.body.mass;
  auto inertia = std::make_shared<SimpleMatrix>(3, 3);
  (*inertia)(0, 0) = mass;
  (*inertia)(1, 1) = mass;
  // a point mass does not turn: no cable of its own turns it, and none may divide by zero
  (*inertia)(2, 2) = the_case.body.inertia > 0.0 ? the_case.body.inertia : mass;
  auto body = std::make_shared<LagrangianLinearTIDS>(
      vector(start.position.x(), start.position.y(), start.angle),
      vector(start.velocity.x(), start.velocity.y(), start.spin), inertia);
  body->setFExtPtr(vector(mass * the_case.gravity.x(), mass * the_case.gravity.y(), 0.0));
  return body;
}

}  // namespace

System::System(const Case& the_case, const State& start)
    : case_(&the_case),
      body_(body_of(the_case, start)),
      // it must have an end; a run is stepped and never reaches it
      dynamics_(
          std::make_shared<NonSmoothDynamicalSystem>(0.0, std::numeric_limits<double>::max())) {
  dynamics_->insertDynamicalSystem(body_);
  for (const Cable& cable : case_->cables) {
    laws_.push_back(std::make_shared<NewtonImpactNSL>(cable.restitution));
    interactions_.push_back(
        std::make_shared<Interaction>(laws_.back(), std::make_shared<CableRelation>(cable)));
    dynamics_->link(interactions_.back(), body_);
  }
}

State System::state() const {
  const SiconosVector& q = *body_->q();
  const SiconosVector& rate = *body_->velocity();
  State result;
  result.position = Vec2(q(0), q(1));
  result.angle = q(2);
  result.velocity = Vec2(rate(0), rate(1));
  result.spin = rate(2);
  return result;
}

void System::set_restitutions(double capture_speed) {
  const State now = state();
  for (std::size_t index = 0; index < laws_.size(); ++index) {
    const Cable& cable = case_->cables[index];
    const double rate = gap_rate(cable, now);
    laws_[index]->setE(std::abs(rate) < capture_speed ? 0.0 : restitution(cable, rate));
  }
}

CableSet System::index_set(unsigned int level) const {
  CableSet result;
  const SP::InteractionsGraph graph = dynamics_->topology()->indexSet(level);
  for (std::size_t index = 0; index < interactions_.size(); ++index) {
    if (graph->is_vertex(interactions_[index])) {
      result.insert(index);
    }
  }
  return result;
}

double System::multiplier(std::size_t cable, unsigned int level) const {
  return (*interactions_[cable]->lambda(level))(0);
}

std::string reason(const std::exception& error) {
  if (const auto* thrown = dynamic_cast<const Siconos::exception*>(&error)) {
    if (const auto* said = boost::get_error_info<Siconos::exception::extra_message>(*thrown)) {
      return *said;
    }
  }
  return error.what();
}

}  // namespace tautline::siconos_engine
