// The runs of every engine are drawn within a pixel of what was recorded of them.

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "bench/measure/reference.hpp"
#include "bench/replay/motion.hpp"
#include "bench/replay/path.hpp"
#include "engines/engine_support.hpp"
#include "tautline/geometry.hpp"
#include "tautline/scenarios.hpp"

namespace tautline::test {
namespace {

/// One model of each engine: a test is about the engine as a whole.
std::vector<ModelUnderTest> one_of_each() {
  std::vector<ModelUnderTest> result;
  for (const ModelUnderTest& model : models_under_test()) {
    if (result.empty() || result.back().engine != model.engine) {
      result.push_back(model);
    }
  }
  return result;
}

class DrawnEngine : public testing::TestWithParam<ModelUnderTest> {
 protected:
  bench::Plugin plugin_ = bench::Plugin::open(GetParam().plugin);
};

TEST_P(DrawnEngine, IsDrawnWithinAPixelOfItsRuns) {
  constexpr std::size_t runs = 6;  // of ten engines: 60
  std::vector<Model> models = plugin_.engine().info().models;
  std::erase_if(models, [](const Model& one) { return one.cables == Cables::elastic; });
  const std::vector<Case> cases = shipped_cases();
  const unsigned seed = 12;
  std::mt19937 random(seed);
  const auto any = [&](const auto& of) -> const auto& { return of[random() % of.size()]; };
  const std::vector<double> steps = {1e-1, 1e-2, 3e-3, 1e-3};
  for (std::size_t index = 0; index < runs; ++index) {
    Case the_case = any(cases);
    the_case.duration = std::min(the_case.duration, 8.0);
    const std::string& model = any(models).name;
    const double step = any(steps);
    const bench::ReferenceCase reference =
        bench::solve_cases({the_case}, ImpactLaw::simultaneous).front();
    const auto simulation = plugin_.engine().start(the_case, model, step);
    const bench::Trajectory run = bench::record(the_case, *simulation, step);
    const bench::Path path = bench::run_path(the_case, bench::nearness_of(reference), run);
    const bench::DrawnPath drawn(path);
    double worst = 0.0;
    for (const bench::Point& point : run.points) {
      const Eigen::Vector3d pose = drawn.pose(point.time);
      worst =
          std::max(worst, (Vec2(pose.head<2>()) - point.state.position).norm() +
                              attachment_radius(the_case) * std::abs(pose[2] - point.state.angle));
    }
    const double pixel = 1e-3 * bench::drawn_extent(reference);
    const std::string name = the_case.name + ", " + model + ", step " + std::to_string(step) +
                             ", seed " + std::to_string(seed);
    EXPECT_LE(worst, path.error * (1.0 + 1e-9) + 1e-12) << name;
    if (!run.diverged) {
      EXPECT_LE(worst, pixel) << name;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Engines, DrawnEngine, testing::ValuesIn(one_of_each()),
                         [](const auto& one) { return one.param.engine; });

}  // namespace
}  // namespace tautline::test
