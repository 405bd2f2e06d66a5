// A cable is a constraint row of our own (Bullet manual, "Constraints"): it exists while the cable
// is overstretched when a step starts (`row`), or already when the step would overstretch it
// (`early`). `row-sleeping` is `row` on a body that Bullet may put to sleep, as it does with every
// body unless it is told not to. `spring` pulls elastic cables by forces, and leaves the others to
// these rows.

#include <string>

#include "adapter/row_model.hpp"
#include "adapter/spring_model.hpp"
#include "cable_constraint.hpp"
#include "models.hpp"

namespace tautline::bullet {
namespace {

/// Two coupled rows converge by a factor per iteration: with Bullet's 10 the mirror image of a run
/// differs by 3e-7, with 50 by 1e-14.
constexpr int row_iterations = 50;

/// Rows of a system.
class SystemRowWorld {
 public:
  explicit SystemRowWorld(const SpatialSystem& system)
      : world_(system), rows_(system, world_, Acting::in_steps) {
    world_.solver_info().m_numIterations = row_iterations;
  }

  [[nodiscard]] SpatialSystemState state() const { return world_.state(); }
  void place(const SpatialSystemState& state) { world_.place(state); }
  void add(const std::vector<BodyLoad>& loads) { world_.add(loads); }

  template <class Look>
  void advance(double dt, const Look& look) {
    look();
    world_.advance(dt);
  }

  void pull(std::size_t index, const SystemRow& row, double rate) { rows_.pull(index, row, rate); }
  void let_go(std::size_t index) { rows_.let_go(index); }
  [[nodiscard]] double impulse(std::size_t index) const { return rows_.impulse(index); }

 private:
  SystemWorld world_;
  SystemCableConstraints rows_;
};

class RowWorld {
 public:
  using InSpace = SystemRowWorld;

  explicit RowWorld(const Case& the_case, Sleep sleep = Sleep::never)
      : world_(the_case, sleep), rows_(the_case, world_, Acting::in_steps) {
    world_.solver_info().m_numIterations = row_iterations;
  }

  [[nodiscard]] State state() const { return world_.state(); }
  void place(const State& state) { world_.place(state); }

  template <class Look>
  void advance(double dt, const Look& look) {
    look();
    world_.advance(dt);
  }

  void pull(std::size_t index, const CableRow& row, double rate) { rows_.pull(index, row, rate); }
  void let_go(std::size_t index) { rows_.let_go(index); }
  [[nodiscard]] double impulse(std::size_t index) const { return rows_.impulse(index); }
  [[nodiscard]] bool asleep() const { return world_.asleep(); }

 private:
  World world_;
  CableConstraints rows_;
};

std::vector<Setting> row_settings(Sleep sleep) {
  return joined(
      {world_settings(sleep),
       {{"m_numIterations", std::to_string(row_iterations),
         "With Bullet's 10 the order of the cables shows: mirror images differ by 3e-7."}}});
}

}  // namespace

std::vector<ModelEntry> row_models() {
  std::vector<ModelEntry> result =
      row_and_early<RowWorld>(row_settings(Sleep::never), {}, system_settings());
  result.push_back(row_model<RowWorld>(
      {.name = "row-sleeping",
       .sentence = "The row of `row` with Bullet's own deactivation: a body slower than 0.8 m/s "
                   "and 1 rad/s for 2 s is frozen where it is.",
       .settings = row_settings(Sleep::as_shipped)},
      Activation::overstretched, Sleep::as_shipped));
  result.push_back(spring_model<RowSimulation<SystemRowWorld, SpatialSystem>>(
      result.front(), {}, Activation::overstretched));
  return result;
}

}  // namespace tautline::bullet
