// The models `row` and `early`, on a world of the test's own: a point that moves first and is
// pulled then, as Chipmunk's.

#include "adapter/row_model.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace tautline {
namespace {

/// A point mass that keeps its velocity until a row wants more.
class PointWorld {
 public:
  explicit PointWorld(const Case& the_case, double extra = 0.0)
      : mass_(the_case.body.mass), extra_(extra), now_(the_case.initial) {}

  [[nodiscard]] State state() const { return now_; }
  void place(const State& state) { now_ = state; }

  template <class Look>
  void advance(double dt, const Look& look) {
    now_.position += dt * now_.velocity;
    look();
    impulses_.clear();
    for (const auto& [index, pull] : pulls_) {
      const auto& [row, rate] = pull;
      const double impulse = mass_ * (rate + extra_ - row.rate);
      now_.velocity += impulse / mass_ * row.towards;
      impulses_[index] = impulse;
    }
  }

  void pull(std::size_t index, const CableRow& row, double rate) {
    pulls_.insert_or_assign(index, std::pair(row, rate));
  }
  void let_go(std::size_t index) { pulls_.erase(index); }
  [[nodiscard]] double impulse(std::size_t index) const {
    return impulses_.contains(index) ? impulses_.at(index) : 0.0;
  }

 private:
  double mass_;
  double extra_;  // [m/s], on top of what is asked for
  State now_;
  std::map<std::size_t, std::pair<CableRow, double>> pulls_;
  std::map<std::size_t, double> impulses_;
};

/// A point of 2 kg that flies from the anchor of a cable of 1 m, at 1 m/s.
Case flying_from_the_anchor() {
  Case result;
  result.body = {.mass = 2.0, .inertia = 0.0};
  result.cables = {{.length = 1.0, .restitution = 0.5}};
  result.initial.velocity = Vec2(1.0, 0.0);
  return result;
}

/// The impulses of steps of 0.25 s of the model called `name`.
std::vector<double> impulses_of(const std::vector<ModelEntry>& models, const std::string& name,
                                int steps) {
  const auto simulation = start_model(models, name, flying_from_the_anchor(), 0.25);
  std::vector<double> result;
  for (int done = 0; done < steps; ++done) {
    simulation->step(0.25);
    result.push_back(simulation->impulses()[0]);
  }
  return result;
}

TEST(RowModel, RowBouncesWhereTheBodyIsAtItsLengthAndEarlyAStepBefore) {
  const auto models = row_and_early<PointWorld>({});
  const double bounce = 2.0 * (1.0 + 0.5);  // [N s], mass times the change of the rate
  EXPECT_EQ(impulses_of(models, "row", 5), (std::vector{0.0, 0.0, 0.0, bounce, 0.0}));
  // 0.25 m before its length it would just reach it in the next step, and not pass it
  EXPECT_EQ(impulses_of(models, "early", 5), (std::vector{0.0, 0.0, 0.0, bounce, 0.0}));
}

TEST(RowModel, EarlyBouncesBeforeTheStepThatWouldPassTheLength) {
  const auto models = row_and_early<PointWorld>({});
  const auto simulation = start_model(models, "early", flying_from_the_anchor(), 0.4);
  simulation->step(0.4);
  EXPECT_EQ(simulation->impulses()[0], 0.0);
  simulation->step(0.4);  // now at 0.8 m
  EXPECT_EQ(simulation->impulses()[0], 3.0);
  EXPECT_EQ(simulation->state().velocity.x(), -0.5);
}

TEST(RowModel, GivesItsWorldWhatIsItsOwn) {
  const std::vector<ModelEntry> models = {row_model<PointWorld>(
      {.name = "more", .sentence = "", .settings = {}}, Activation::overstretched, 0.25)};
  EXPECT_EQ(impulses_of(models, "more", 4).back(), 2.0 * (1.0 + 0.5 + 0.25));
  EXPECT_TRUE(models.front().follows_speed);
}

TEST(RowModel, WithoutRestitutionComesToRestAtTheLengthAndIsNotThrownBack) {
  const auto models = row_and_early<PointWorld>({});
  Case the_case = flying_from_the_anchor();
  the_case.cables[0].restitution = 0.0;
  for (const std::string model : {"row", "early"}) {
    const auto simulation = start_model(models, model, the_case, 0.3);
    double overstretch = 0.0;
    for (int done = 0; done < 60; ++done) {
      simulation->step(0.3);
      EXPECT_GE(simulation->state().velocity.x(), 0.0) << model << ": is thrown back";
      overstretch = std::max(overstretch, simulation->state().position.x() - 1.0);
    }
    EXPECT_EQ(simulation->state().velocity.x(), 0.0) << model;
    EXPECT_LT(simulation->state().position.x() - 1.0, 1e-5) << model;
    EXPECT_EQ(overstretch > 0.0, model == "row");
  }
}

TEST(SolveRows, TellsTheImpulsesInTheOrderOfTheCablesAndLetsGo) {
  Case the_case = flying_from_the_anchor();
  the_case.cables.push_back({.anchor = Vec2(0.0, -1.0), .length = 2.0, .restitution = 0.0});
  PointWorld world(the_case);
  CableSet second;
  second.insert(1);
  const CableVector impulses =
      solve_rows(world, the_case, world.state(), second, CableVector::Constant(1, 1.0),
                 [&] { world.advance(0.0, [] {}); });
  // towards the anchor below, across the velocity
  EXPECT_EQ(impulses[0], 2.0);
  EXPECT_EQ(world.state().velocity, Vec2(1.0, -1.0));
  world.advance(0.0, [] {});
  EXPECT_EQ(world.impulse(1), 0.0);
}

}  // namespace
}  // namespace tautline
