#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "tautline/engine.hpp"

namespace tautline::bench {

/// A claim about one model, settled.
struct SettledClaim {
  std::string claim;
  double found = 0.0;
  double limit = 0.0;
  bool holds = false;
  std::string sentence;    // what was found; where it does not hold, what seems to be wrong
  std::string known = {};  // why it is known not to hold; empty where it is not
  /// False where the model does not run its systems: `sentence` says why, and it does not count.
  bool applies = true;

  /// As it should be: it holds, or it is known not to.
  [[nodiscard]] bool as_expected() const { return (holds || !applies) == known.empty(); }
};

/// Called before each claim, with its name and the claims that are settled so far.
using CheckProgress = std::function<void(std::string_view, const std::vector<SettledClaim>&)>;

/// Settles every claim about `model` of `engine`, which has it. A claim does not hold where the
/// engine throws.
[[nodiscard]] std::vector<SettledClaim> check_model(const Engine& engine, const std::string& model,
                                                    const CheckProgress& progress);

/// A claim that could not be measured, and why.
[[nodiscard]] SettledClaim unmeasured(std::string_view claim, const std::string& why);

/// The claim `quiet`, which only the process around the engine can settle: what the engine
/// `printed` [bytes], and the last of it.
[[nodiscard]] SettledClaim settle_quiet(std::size_t printed, const std::string& tail);
inline constexpr std::string_view quiet_claim = "quiet";
inline constexpr std::string_view quiet_sentence = "the engine does not print at every step";
inline constexpr std::string_view quiet_reason = "a greeting at each of the runs of a check";

/// The claims among `settled` that are not as they should be, by name.
[[nodiscard]] std::vector<std::string> broken_claims(const std::vector<SettledClaim>& settled);

}  // namespace tautline::bench
