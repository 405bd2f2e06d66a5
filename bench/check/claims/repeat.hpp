#pragma once

#include <string>

#include "bench/check/measure.hpp"
#include "bench/check/subject.hpp"

namespace tautline::bench {

// Whether a model does the same again, and the same in a mirror.
[[nodiscard]] Measure measure_mirror_symmetry(const Subject& subject);
[[nodiscard]] Measure measure_determinism(const Subject& subject);

/// A digest of the run of `determinism`: any two runs of a deterministic model have the same, in
/// whatever process. Throws what the engine throws.
[[nodiscard]] std::string run_digest(const Engine& engine, const std::string& model);

}  // namespace tautline::bench
