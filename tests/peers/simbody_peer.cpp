// Simbody as its documentation has it for contacts found by hand: a TriggeredEventHandler for each
// cable watches the gap, falling alone, and the integrator locates its instant.

#include <limits>
#include <stdexcept>

#include "engines/simbody/simbody.hpp"
#include "flight_events.hpp"

namespace tautline::peers {
namespace {

// the coordinates of MobilizedBody::Planar
constexpr int angle = 0;
constexpr int x = 1;
constexpr int y = 2;

/// A body that flies, in the numbers of Simbody.
class Flier {
 public:
  explicit Flier(const Case& the_case) : body_(matter_.updGround(), rigid(the_case.body)) {
    const Vec2& gravity = the_case.gravity;
    SimTK::Force::UniformGravity(forces_, matter_, SimTK::Vec3(gravity.x(), gravity.y(), 0.0));
  }

  [[nodiscard]] SimTK::MultibodySystem& system() { return system_; }

  [[nodiscard]] State state_of(const SimTK::State& state) const {
    State result;
    result.position = Vec2(body_.getOneQ(state, x), body_.getOneQ(state, y));
    result.angle = body_.getOneQ(state, angle);
    result.velocity = Vec2(body_.getOneU(state, x), body_.getOneU(state, y));
    result.spin = body_.getOneU(state, angle);
    return result;
  }

  void place(SimTK::State& state, const State& wanted) const {
    body_.setOneQ(state, x, wanted.position.x());
    body_.setOneQ(state, y, wanted.position.y());
    body_.setOneQ(state, angle, wanted.angle);
    body_.setOneU(state, x, wanted.velocity.x());
    body_.setOneU(state, y, wanted.velocity.y());
    body_.setOneU(state, angle, wanted.spin);
  }

 private:
  static SimTK::Body::Rigid rigid(const Body& body) {
    const double about_z = body.inertia > 0.0 ? body.inertia : 1.0;  // a point mass does not turn
    return SimTK::Body::Rigid(
        SimTK::MassProperties(body.mass, SimTK::Vec3(0.0), SimTK::Inertia(about_z)));
  }

  SimTK::MultibodySystem system_;
  SimTK::SimbodyMatterSubsystem matter_{system_};
  SimTK::GeneralForceSubsystem forces_{system_};
  SimTK::MobilizedBody::Planar body_;
};

/// Ends the integration where the gap of one cable falls to zero.
class GapHandler final : public SimTK::TriggeredEventHandler {
 public:
  GapHandler(const Flier& flier, const Cable& cable, std::size_t index, CableSet& found)
      : TriggeredEventHandler(SimTK::Stage::Position),
        flier_(flier),
        cable_(cable),
        index_(index),
        found_(found) {
    getTriggerInfo().setTriggerOnRisingSignTransition(false);
  }

  [[nodiscard]] SimTK::Real getValue(const SimTK::State& state) const override {
    const double value = gap(cable_, flier_.state_of(state));
    // Simbody's search fails an assertion where it meets a zero
    return value == 0.0 ? std::numeric_limits<double>::min() : value;
  }

  void handleEvent(SimTK::State& /*state*/, SimTK::Real /*accuracy*/, bool& ends) const override {
    found_.insert(index_);
    ends = true;
  }

 private:
  const Flier& flier_;
  const Cable& cable_;
  std::size_t index_;
  CableSet& found_;
};

class SimbodyPeer final : public Peer {
 public:
  std::string name() const override { return "Simbody"; }
  std::string version() const override {
    int major = 0;
    int minor = 0;
    int build = 0;
    SimTK_version_simbody(&major, &minor, &build);
    return std::to_string(major) + "." + std::to_string(minor);
  }
  std::string method() const override {
    return "RungeKuttaMersonIntegrator, TriggeredEventHandler on the gaps, falling only";
  }

  std::size_t most_arcs() const override { return arcs_of_slow_peers; }

  std::vector<Located> impacts(const Case& the_case, const Stop& stop,
                               const Effort& effort) override {
    Flier flier(the_case);
    CableSet found;
    for (std::size_t index = 0; index < the_case.cables.size(); ++index) {
      flier.system().addEventHandler(new GapHandler(flier, the_case.cables[index], index, found));
    }
    flier.system().realizeTopology();
    SimTK::RungeKuttaMersonIntegrator integrator(flier.system());
    integrator.setAccuracy(effort.tolerance);
    if (effort.longest_step > 0.0) {
      integrator.setMaximumStepSize(effort.longest_step);
    }
    SimTK::TimeStepper stepper(flier.system(), integrator);
    SimTK::State state = flier.system().getDefaultState();
    return follow(the_case, stop, effort,
                  [&](const State& now, double time) -> std::optional<Root> {
                    if (time >= stop.horizon) {
                      return std::nullopt;
                    }
                    found = {};
                    flier.place(state, now);
                    state.setTime(time);
                    stepper.initialize(state);
                    stepper.stepTo(stop.horizon);
                    if (found.empty()) {
                      return std::nullopt;
                    }
                    return Root{integrator.getTime(), flier.state_of(integrator.getState()), found};
                  });
  }
};

}  // namespace

std::unique_ptr<Peer> simbody_peer() { return std::make_unique<SimbodyPeer>(); }

}  // namespace tautline::peers
