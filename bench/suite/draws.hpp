#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bench/ensemble/draw_solver.hpp"
#include "bench/store/plan.hpp"

namespace tautline::bench {

/// The case that a suite draws from: its motion is chaotic long before it settles.
inline constexpr std::string_view drawn_case = "breakwater/1910121100";

/// More draws than this are a matter of `tautline ensemble`.
inline constexpr std::size_t most_draws_of_suite = 10'000;

/// A hash of the programs that each setup depends on.
[[nodiscard]] std::vector<std::uint64_t> programs_of(const EnsembleRequest& request);

/// Solves `options.draws` draws of `drawn_case`, which is among the cases, exactly and by every
/// model, at the finest step that is not below 0.001 s. Shows how far it is, leaves the draws and a
/// page in the folder `ensemble` of the result tree, and keeps those that are there if `options`
/// say so. None where no engine has a model, or if the program was interrupted.
[[nodiscard]] std::optional<Distributions> compare_draws(const SuiteOptions& options);

}  // namespace tautline::bench
