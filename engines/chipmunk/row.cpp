// A cable is a constraint class of our own, as Chipmunk's joints are: it acts while the cable is
// overstretched where a step has taken the body (`row`), or already when the next step would
// overstretch it (`early`).

#include <functional>

#include "adapter/row_model.hpp"
#include "cable_constraint.hpp"
#include "models.hpp"

namespace tautline::chipmunk {
namespace {

/// Two coupled rows converge by a factor per iteration; Chipmunk's 10 leave an order of cables.
constexpr int row_iterations = 50;

class RowWorld {
 public:
  explicit RowWorld(const Case& the_case) : world_(the_case), rows_(the_case, world_) {
    cpSpaceSetIterations(world_.space(), row_iterations);
    cpSpaceSetUserData(world_.space(), this);
    for (std::size_t index = 0; index < rows_.size(); ++index) {
      rows_[index].join(world_);
    }
    if (rows_.size() > 0) {
      rows_[0].set_before_solve(before_solve);
    }
  }
  RowWorld(const RowWorld&) = delete;
  RowWorld& operator=(const RowWorld&) = delete;
  ~RowWorld() = default;

  [[nodiscard]] State state() const { return world_.state(); }
  void place(const State& state) { world_.place(state); }

  void advance(double dt, const std::function<void()>& look) {
    look_ = &look;
    world_.advance(dt);
  }

  void pull(std::size_t index, const CableRow& row, double rate) { rows_.pull(index, row, rate); }
  void let_go(std::size_t index) { rows_.let_go(index); }
  [[nodiscard]] double impulse(std::size_t index) const { return rows_.impulse(index); }

 private:
  /// Chipmunk calls this for the first constraint of all, after the body has moved and before
  /// gravity has changed its velocity.
  static void before_solve(cpConstraint* /*first*/, cpSpace* space) {
    (*static_cast<RowWorld*>(cpSpaceGetUserData(space))->look_)();
  }

  World world_;
  CableConstraints rows_;                        // leave the space before it goes
  const std::function<void()>* look_ = nullptr;  // during a step
};

}  // namespace

std::vector<ModelEntry> row_models() {
  return row_and_early<RowWorld>(
      {{"cpSpaceSetIterations", "50",
        "Two coupled rows converge slowly: with Chipmunk's 10 the order of the cables shows."}},
      {.row = "A constraint of its own class while the cable is overstretched where a step has "
              "moved the body; it asks for the bounce, and takes 0.2 of the overstretch out per "
              "step without throwing the body back.",
       .early = "The same constraint already when the next step would overstretch the cable."});
}

}  // namespace tautline::chipmunk
