#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "bench/check/stepping.hpp"
#include "bench/run/plugin.hpp"
#include "bench/run/registry.hpp"
#include "tautline/case.hpp"
#include "tautline/engine.hpp"

namespace tautline::test {

/// One model of one plug-in of the build.
struct ModelUnderTest {
  std::filesystem::path plugin;
  std::string engine;
  std::string model;
  std::string precision;  // "float64" or "float32"

  [[nodiscard]] bool in_double() const { return precision == "float64"; }

  /// What a measure may reach: one limit for engines in double, one for those in float.
  [[nodiscard]] double limit(double for_double, double for_float) const {
    return in_double() ? for_double : for_float;
  }
};

/// How a failing test names it.
void PrintTo(const ModelUnderTest& model, std::ostream* out);

/// Every engine of the build as the program found it, each in a process of its own. CTest runs each
/// test in a process of its own too, with one engine: some share symbols.
[[nodiscard]] std::vector<bench::RegisteredEngine> engines_of_the_build();

/// Every model of every plug-in there, but those of elastic cables.
[[nodiscard]] std::vector<ModelUnderTest> models_under_test();

/// Every model of every engine there that has a process of its own: those on npm that are fetched.
[[nodiscard]] std::vector<ModelUnderTest> models_outside();

/// Those called `event`, whose engines find the instants of the impacts.
[[nodiscard]] std::vector<ModelUnderTest> event_models();

/// "bullet64_contact_tuned".
[[nodiscard]] std::string test_name(const testing::TestParamInfo<ModelUnderTest>& info);

/// The plug-in `engine`; none where it is not built.
[[nodiscard]] std::optional<bench::Plugin> plugin_of(const std::string& engine);

using bench::Moment;
using bench::run;

/// The largest distance of the centre of mass from `solve`'s over a run to `end` [m].
[[nodiscard]] double largest_deviation(const Engine& engine, const std::string& model,
                                       const Case& the_case, double step, double end);

[[nodiscard]] bool is_finite(const State& state);

}  // namespace tautline::test
