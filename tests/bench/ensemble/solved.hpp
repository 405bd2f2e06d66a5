#pragma once

#include <gtest/gtest.h>

#include <string>

#include "bench/ensemble/ensemble.hpp"
#include "bench/ensemble/spec_file.hpp"

namespace tautline::bench {

/// The ensemble of a spec.
[[nodiscard]] inline EnsembleRequest request_of(const std::string& text) {
  const SpecReading reading = read_spec_text(text, "test.toml");
  EXPECT_TRUE(reading.problems.empty()) << reading.problems.front();
  EnsembleRequest request{reading.spec.value(), {}, {}, {}};
  request.setups = setups_of(request.spec, {});
  return request;
}

/// All of its draws.
[[nodiscard]] inline EnsembleResult solved(const EnsembleRequest& request, unsigned jobs = 2) {
  return solve_ensemble(request, {.out = {}, .jobs = jobs, .resume = false, .programs = {}},
                        [](const auto&, std::size_t, bool) {});
}

/// A case of the chapter, its start off by a thousandth in all six numbers.
[[nodiscard]] inline std::string perturbed(const std::string& name, int count) {
  return "case = \"breakwater/" + name + "\"\ncount = " + std::to_string(count) +
         "\n[[vary]]\nquantities = [\"x\", \"y\", \"angle\", \"velocity_x\", \"velocity_y\", "
         "\"spin\"]\nnormal = 1e-3\n";
}

}  // namespace tautline::bench
