// A cable is the upper limit of a spatial tendon (MuJoCo documentation, "Modeling", "Restitution"):
// beyond its length x'' = -k x - b x' for the overstretch x, a spring and a damper that cannot
// push. There is no restitution to set; k makes a bounce last a number of steps, b gives it its e.

#include <algorithm>
#include <numbers>
#include <utility>

#include "models.hpp"
#include "tautline/elasticity.hpp"
#include "world.hpp"

namespace tautline::mujoco {
namespace {

/// A bounce without damping lasts this many steps. Fewer overstretch the cable less, and come less
/// close to the restitution: with a stiffness of 1 / dt^2 (three steps) the run explodes.
constexpr double steps_per_bounce = 20.0;

/// The damping that stops a body in one step, b dt = 1, as a ratio [-]; more would overshoot.
constexpr double largest_damping_ratio = steps_per_bounce / (2.0 * std::numbers::pi);

/// The damping ratio [-] of x'' = -k x - b x' whose pulls give the restitution `e` (E6): it ends
/// where the pull is zero, before x is. The largest one where `e` is below what it gives, 0.02.
double limited_ratio_of(double e) { return std::min(damping_ratio_of(e), largest_damping_ratio); }

template <class TheCase>
std::vector<TendonLimit> limits_of(const TheCase& the_case, const RunSettings& run) {
  const double frequency = std::numbers::pi / (steps_per_bounce * run.step);  // [1/s]
  std::vector<TendonLimit> limits;
  for (const auto& cable : the_case.cables) {
    limits.push_back(
        {parameter_of(run, "stiffness", frequency * frequency),
         parameter_of(run, "damping", 2.0 * limited_ratio_of(cable.restitution) * frequency)});
  }
  return limits;
}

/// `limits` as MuJoCo takes them: with an impedance d that is the same for all overstretches it
/// asks for x'' = (1 - d) a - damping x' - stiffness x, so that its pull takes over d of the load.
std::vector<SoftRow> soft_rows_of(const std::vector<TendonLimit>& limits) {
  std::vector<SoftRow> rows;
  for (const TendonLimit& limit : limits) {
    rows.push_back({limit.stiffness, limit.damping, limit_impedance});
  }
  return rows;
}

/// A bounce takes 10 to 150 steps, and the damping stops a body in one step at most.
std::vector<Parameter> limit_parameters() {
  return {{.name = "damping", .low = 1e-4, .high = 1.0, .logarithmic = true, .step_power = -1},
          {.name = "stiffness", .low = 4.4e-4, .high = 0.1, .logarithmic = true, .step_power = -2}};
}

template <class TheCase, class TheWorld>
class TendonLimitSimulation final : public BasicSteppedSimulation<TheCase>, public SoftCables {
 public:
  TendonLimitSimulation(const TheCase& the_case, const RunSettings& run, Integrator integrator)
      : TendonLimitSimulation(the_case, integrator, limits_of(the_case, run)) {}

  [[nodiscard]] StateOf<TheCase> state() const override { return world_.state(); }
  [[nodiscard]] std::span<const double> impulses() const override { return impulses_; }
  [[nodiscard]] std::span<const SoftRow> soft_rows() const override { return rows_; }

  void step(double dt) override {
    world_.advance(dt);
    const std::vector<double> forces = world_.limit_forces();
    std::transform(forces.begin(), forces.end(), impulses_.begin(),
                   [dt](double force) { return force * dt; });
  }

 private:
  TendonLimitSimulation(const TheCase& the_case, Integrator integrator,
                        const std::vector<TendonLimit>& limits)
      : world_(the_case, integrator, limits),
        impulses_(the_case.cables.size()),
        rows_(soft_rows_of(limits)) {}

  TheWorld world_;
  std::vector<double> impulses_;
  std::vector<SoftRow> rows_;
};

std::vector<Setting> limit_settings() {
  return {{"limited, range", "true, 0 to length", "A cable limits a distance."},
          {"solreflimit", "-k, -b: k = (pi / (20 step))^2, b from the cable's restitution",
           "A bounce lasts 20 steps, and ends, where the pull does, with the restitution."},
          {"solimplimit", "0.9999 0.9999 1 0.5 1",
           "MuJoCo's 0.9 to 0.95 would give less pull than the limit asks for; more than 0.9999 is "
           "not allowed."}};
}

ModelEntry entry(std::string name, std::string sentence, Integrator integrator,
                 const std::vector<Setting>& own) {
  return {.model = {.name = std::move(name),
                    .sentence = std::move(sentence),
                    .settings = joined({world_settings(), limit_settings(), own}),
                    .maker = Maker::engine,
                    .parameters = limit_parameters(),
                    .code = "<spatial limited=\"true\" solreflimit=\"-{stiffness} -{damping}\" "
                            "solimplimit=\"0.9999 0.9999 1 0.5 1\">",
                    .in_space = system_settings()},
          .start = makes<TendonLimitSimulation<Case, World>>(integrator),
          .start_system = makes<TendonLimitSimulation<SpatialSystem, SystemWorld>>(integrator)};
}

}  // namespace

std::vector<ModelEntry> tendon_limit_models() {
  return {
      entry("tendon-limit",
            "The upper limit of a spatial tendon, a spring and a damper whose bounce lasts 20 "
            "steps: what MuJoCo has for a cable.",
            Integrator::euler, {}),
      entry("tendon-limit-rk4", "The same limit, integrated by the method of Runge and Kutta.",
            Integrator::rk4, {{"integrator", "RK4", "To see whether a better integrator helps."}})};
}

}  // namespace tautline::mujoco
