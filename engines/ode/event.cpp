// The event driver over ODE: half of gravity's impulse before and after a step makes its
// semi-implicit Euler fly the exact parabola, and one `dWorldStep` without gravity, after which the
// pose is put back, gives the impulses of an impact.

#include <algorithm>
#include <array>

#include "models.hpp"
#include "tautline/event_driver.hpp"
#include "tautline/parabola.hpp"
#include "world.hpp"

namespace tautline::ode {
namespace {

/// Added to the diagonal of the Delassus matrix when several cables are hit together, of its
/// largest entry [-]. ODE's solver fails on dependent rows, such as any four cables of a planar
/// body; this makes them independent. Velocities are off by ten to a thousand times it.
constexpr double softness = 3e-15;

/// ODE's solver may give up, and leave every row as it is, where one row is satisfied exactly. Rows
/// that ask for so much more are not [-], of the speed of the body.
constexpr std::array nudges = {1e-14, 1e-13, 1e-12};

/// TheCase is Case or SpatialSystem.
template <class TheCase, class TheWorld>
class OdeAdapter final : public BasicEventAdapter<TheCase> {
 public:
  explicit OdeAdapter(const TheCase& the_case)
      : case_(the_case), world_(the_case, Rotation::finite) {
    check_contacts(the_case);
  }

  [[nodiscard]] StateOf<TheCase> state() const override { return world_.state(); }

  void fly(double dt) override { world_.fly(dt); }

  void place(const StateOf<TheCase>& state) override { world_.place(state); }

  [[nodiscard]] CableVector solve(CableSet cables, const CableVector& rates) override {
    const StateOf<TheCase> before = world_.state();
    const double largest = delassus(case_, before, cables).diagonal().maxCoeff();
    const double speed = speed_of(before);
    dWorldSetCFM(world_.id(), cables.size() > 1 ? softness * largest : 0.0);
    solve_once(cables, rates, before);
    for (const double more : nudges) {
      if (is_solved(cables, rates, nudges.back() * speed)) {
        break;
      }
      world_.place(before);
      solve_once(cables, rates.array() + more * speed, before);
    }
    CableVector impulses(rates.size());
    Eigen::Index position = 0;
    for (const std::size_t index : cables) {
      impulses[position++] = world_.impulses()[index];
    }
    return impulses;
  }

 private:
  [[nodiscard]] double speed_of(const State& state) const { return speed_scale(case_, state); }
  [[nodiscard]] double speed_of(const SpatialSystemState& state) const { return fastest(state); }

  void solve_once(CableSet cables, const CableVector& rates, const StateOf<TheCase>& before) {
    Eigen::Index position = 0;
    for (const std::size_t index : cables) {
      const auto row = cable_row(case_.cables[index], before);
      dSurfaceParameters surface{};
      surface.mode = dContactMotionN | dContactSoftERP;  // the gap is zero: nothing to correct
      surface.motionN = rate_of_bodies(row, rates[position++]);
      world_.pull(index, row, surface);
    }
    world_.solve_here();
  }

  [[nodiscard]] bool is_solved(CableSet cables, const CableVector& rates, double allowed) const {
    const StateOf<TheCase> now = world_.state();
    Eigen::Index position = 0;
    for (const std::size_t index : cables) {
      if (gap_rate(case_.cables[index], now) < rates[position++] - allowed) {
        return false;
      }
    }
    return true;
  }

  const TheCase case_;
  TheWorld world_;
};

}  // namespace

std::vector<ModelEntry> event_models() {
  const std::vector<Setting> own = {
      {"dWorldSetCFM", "0; 3e-15 of the largest diagonal entry for cables hit together",
       "ODE's 1e-10 softens every row a little; its solver fails on dependent rows without any."},
      {"dBodySetFiniteRotationMode", "1",
       "The default turns the body to first order only and renormalises."},
      {"dContactMotionN, motionN", "the rate that the bounce, or a taut cable, asks for",
       "One row for impacts and for taut cables; dContactBounce is only for impacts."},
      {"motionN of several cables", "1e-14 of the speed more, where it is needed",
       "ODE's solver may give up where a row is satisfied exactly."},
      {"dContactSoftERP, soft_erp", "0",
       "At the instant of an impact there is no overstretch for ODE's 0.2 to take out."},
      {"dWorldStep", "1 s for an impact",
       "No force acts, so that any step will do; a small one would lose digits."},
      {"dWorldSetGravity", "0 while an impact is solved",
       "No time passes in an impact; the case's gravity is put back after it."},
      {"dBodySetPosition, dBodySetQuaternion", "the pose before an impact",
       "The solve of an impact must not move the body."},
      parabola_setting()};
  return {event_model<OdeAdapter<Case, World>, OdeAdapter<SpatialSystem, SystemWorld>>(
      "ODE flies and solves, the event driver finds the instants: each impact is one solve at the "
      "exact pose.",
      joined({world_settings(), own}),
      joined({system_settings(),
              {{"dBodySetGyroscopicMode while an impact is solved", "0",
                "No time passes in an impact, and so no turn brings a gyroscopic moment."}}}))};
}

}  // namespace tautline::ode
