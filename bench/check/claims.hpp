#pragma once

#include <span>
#include <string_view>

#include "bench/check/measure.hpp"
#include "bench/check/subject.hpp"

namespace tautline::bench {

// What every model of every engine should keep, each as a number with a limit. `tautline check`
// asks for limits that a sound engine with fixed steps can meet; the tests of the engines here ask
// the same measures for rounding.

/// One thing that is claimed of a model.
struct Claim {
  std::string_view name;      // [a-z-]+
  std::string_view sentence;  // what is claimed
  std::string_view reason;    // why the limit is what it is
  Measure (*measure)(const Subject& subject);
  bool in_space = false;  // about systems in space: it applies to models that run them
};

/// All claims, in the order in which a reader wants them: one that fails may break those after it.
[[nodiscard]] std::span<const Claim> claims();

/// The claim of this name, or null.
[[nodiscard]] const Claim* find_claim(std::string_view name);

}  // namespace tautline::bench
