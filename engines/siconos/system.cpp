#include "system.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include <Interaction.hpp>
#include <LagrangianLinearTIDS.hpp>
#include <NewtonEulerDS.hpp>
#include <NewtonImpactNSL.hpp>
#include <NonSmoothDynamicalSystem.hpp>
#include <SiconosException.hpp>
#include <SiconosVector.hpp>
#include <SimpleMatrix.hpp>
#include <SimulationGraphs.hpp>
#include <Topology.hpp>

#include "cable_relation.hpp"
#include "tautline/cable_row.hpp"
#include "tautline/geometry.hpp"
#include "tautline/point_mass.hpp"

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

/// A body of a system under gravity and what is given to act, at every instant of a run that is
/// `start` [s] old where Siconos has 0.
class Loaded final : public NewtonEulerDS {
 public:
  Loaded(const SpatialSystem& system, std::size_t index, const SpatialState& place, double start,
         const std::vector<BodyLoad>& pulls)
      : NewtonEulerDS(place_of(place), twist_of(place), system.bodies[index].mass,
                      inertia_of(system.bodies[index])),
        system_(system),
        index_(index),
        start_(start),
        pulls_(pulls) {
    _fExt = vector(0.0, 0.0, 0.0);
    _mExt = vector(0.0, 0.0, 0.0);
    setIsMextExpressedInInertialFrame(true);
  }

  void computeFExt(double time, SP::SiconosVector force) override {
    const SpatialBody& body = system_.bodies[index_];
    const double now = start_ + time;
    const Eigen::Vector3d given = body.mass * system_.gravity.at(now) + body.force.at(now) -
                                  body.drag * numbers<3>(*_twist, 0);
    put(*force, given + pull().force);
  }
  void computeFExt(double time) override { computeFExt(time, _fExt); }

  void computeMExt(double time, SP::SiconosVector moment) override {
    const SpatialBody& body = system_.bodies[index_];
    SpatialState place;
    place.orientation = numbers<4>(*_q, 3).normalized();
    put(*moment, body.moment.at(start_ + time) -
                     body.spin_drag * in_the_world(place, numbers<3>(*_twist, 3)) + pull().moment);
  }
  void computeMExt(double time) override { computeMExt(time, _mExt); }

  template <int Count>
  [[nodiscard]] static Eigen::Matrix<double, Count, 1> numbers(const SiconosVector& of,
                                                               unsigned int first) {
    Eigen::Matrix<double, Count, 1> result;
    for (unsigned int i = 0; i < Count; ++i) {
      result[i] = of(first + i);
    }
    return result;
  }

 private:
  static void put(SiconosVector& to, const Eigen::Vector3d& values) {
    for (unsigned int i = 0; i < 3; ++i) {
      to(i) = values[i];
    }
  }
  static SP::SiconosVector place_of(const SpatialState& place) {
    auto result = std::make_shared<SiconosVector>(place_numbers);
    for (unsigned int i = 0; i < 3; ++i) {
      (*result)(i) = place.position[i];
    }
    for (unsigned int i = 0; i < 4; ++i) {
      (*result)(3 + i) = place.orientation[i];
    }
    return result;
  }
  static SP::SiconosVector twist_of(const SpatialState& place) {
    auto result = std::make_shared<SiconosVector>(twist_numbers);
    for (unsigned int i = 0; i < 3; ++i) {
      (*result)(i) = place.velocity[i];
      (*result)(3 + i) = place.spin[i];
    }
    return result;
  }
  static SP::SiconosMatrix inertia_of(const SpatialBody& body) {
    const Eigen::Vector3d moments = turnable_inertia(body);
    auto result = std::make_shared<SimpleMatrix>(3, 3);
    for (unsigned int i = 0; i < 3; ++i) {
      (*result)(i, i) = moments[i];
    }
    return result;
  }

  [[nodiscard]] BodyLoad pull() const {
    return pulls_.empty() ? BodyLoad{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()}
                          : pulls_[index_];
  }

  const SpatialSystem& system_;
  std::size_t index_;
  double start_;
  const std::vector<BodyLoad>& pulls_;
};

void check_cables(const SpatialSystem& system) {
  for (std::size_t index = 0; index < system.cables.size(); ++index) {
    const SpatialCable& cable = system.cables[index];
    bool moves = !cable.length.is_constant() || cable.from_time || cable.cut_at;
    for (std::size_t i = 0; i <= cable.segments(); ++i) {
      moves = moves || !cable.end(i).motion.empty();
    }
    if (moves || pulled_bodies(cable).size() > 2) {
      throw CableRefused("a relation of Siconos joins one body or two and knows no time", index,
                         moves ? "changes over time" : "joins more");
    }
  }
}

}  // namespace

Interactions::Interactions()
    // it must have an end; a run is stepped and never reaches it
    : dynamics_(
          std::make_shared<NonSmoothDynamicalSystem>(0.0, std::numeric_limits<double>::max())) {}

void Interactions::add(double restitution, std::shared_ptr<Relation> relation,
                       const std::vector<std::shared_ptr<DynamicalSystem>>& on) {
  laws_.push_back(std::make_shared<NewtonImpactNSL>(restitution));
  interactions_.push_back(std::make_shared<Interaction>(laws_.back(), std::move(relation)));
  dynamics_->link(interactions_.back(), on.front(), on.size() > 1 ? on[1] : nullptr);
}

template <class TheCase>
void Interactions::set_restitutions(const TheCase& the_case, const StateOf<TheCase>& now,
                                    double capture_speed) {
  for (std::size_t index = 0; index < laws_.size(); ++index) {
    const auto& cable = the_case.cables[index];
    const double rate = gap_rate(cable, now);
    laws_[index]->setE(std::abs(rate) < capture_speed ? 0.0 : restitution(cable, rate));
  }
}
template void Interactions::set_restitutions(const Case&, const State&, double);
template void Interactions::set_restitutions(const SpatialSystem&, const SpatialSystemState&,
                                             double);

CableSet Interactions::index_set(unsigned int level) const {
  CableSet result;
  const SP::InteractionsGraph graph = dynamics_->topology()->indexSet(level);
  for (std::size_t index = 0; index < interactions_.size(); ++index) {
    if (graph->is_vertex(interactions_[index])) {
      result.insert(index);
    }
  }
  return result;
}

double Interactions::multiplier(std::size_t cable, unsigned int level) const {
  return (*interactions_[cable]->lambda(level))(0);
}

System::System(const Case& the_case, const State& start)
    : case_(&the_case), body_(body_of(the_case, start)) {
  dynamics_->insertDynamicalSystem(body_);
  for (const Cable& cable : case_->cables) {
    add(cable.restitution, std::make_shared<CableRelation>(cable), {body_});
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

SystemInSpace::SystemInSpace(const SpatialSystem& system, const SpatialSystemState& start)
    : system_(&system), start_(start.time) {
  check_cables(system);
  for (std::size_t index = 0; index < system.bodies.size(); ++index) {
    bodies_.push_back(std::make_shared<Loaded>(system, index, start.bodies[index], start_, pulls_));
    dynamics_->insertDynamicalSystem(bodies_.back());
  }
  for (const SpatialCable& cable : system.cables) {
    const std::vector<std::size_t> on = pulled_bodies(cable);
    std::vector<std::shared_ptr<DynamicalSystem>> linked;
    for (const std::size_t body : on) {
      linked.push_back(bodies_[body]);
    }
    add(cable.restitution, std::make_shared<SystemCableRelation>(cable, on, system.bodies.size()),
        linked);
  }
}

SpatialSystemState SystemInSpace::state() const {
  SpatialSystemState result;
  result.time = start_;
  for (const auto& body : bodies_) {
    SpatialState one;
    one.position = Loaded::numbers<3>(*body->q(), 0);
    one.orientation = Loaded::numbers<4>(*body->q(), 3).normalized();
    one.velocity = Loaded::numbers<3>(*body->twist(), 0);
    one.spin = Loaded::numbers<3>(*body->twist(), 3);
    result.bodies.push_back(one);
  }
  return result;
}

std::vector<Setting> system_settings() {
  return {{"NewtonEulerDS, NewtonEulerR", "one per body, one per cable",
           "Bodies of a system move in space."},
          {"computeFExt, computeMExt", "gravity, forces, moments and drag at each instant",
           "They are overridden: Siconos' own plug-ins are functions of C."}};
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
