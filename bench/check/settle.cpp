#include "bench/check/settle.hpp"

#include <fmt/format.h>

#include <exception>
#include <limits>

#include "bench/base/text.hpp"
#include "bench/check/claims.hpp"
#include "bench/check/stepping.hpp"

namespace tautline::bench {
namespace {

/// A greeting at each of the hundred runs of a check is fine, a line at each of its hundred
/// thousand steps is not [bytes].
constexpr double most_printed = 65536;

constexpr double not_measured = std::numeric_limits<double>::quiet_NaN();

/// Why a claim could not be measured.
std::string reason(const std::exception& error) {
  const bool shown = dynamic_cast<const RunStopped*>(&error) != nullptr ||
                     dynamic_cast<const NoMotion*>(&error) != nullptr;
  const std::string said = error.what();
  if (said.starts_with(refusal)) {
    return "the engine refuses the case of this claim: " + said;
  }
  return shown ? said : "the engine threw: " + said;
}

SettledClaim settle(const Claim& claim, const Subject& subject) {
  try {
    const Measure measure = claim.measure(subject);
    // false where it is not a number
    const bool holds = measure.found <= measure.limit;
    return {std::string(claim.name), measure.found, measure.limit, holds, measure.sentence};
  } catch (const NotRun& why) {
    SettledClaim result = unmeasured(claim.name, why.what());
    result.applies = false;
    return result;
  } catch (const std::exception& error) {
    return unmeasured(claim.name, reason(error));
  }
}

/// The last line of `text` that is not empty.
std::string last_line(std::string text) {
  text.erase(text.find_last_not_of('\n') + 1);
  return text.substr(text.rfind('\n') + 1);
}

}  // namespace

std::vector<SettledClaim> check_model(const Engine& engine, const std::string& model,
                                      const CheckProgress& progress) {
  std::vector<SettledClaim> settled;
  const std::string_view first = claims().front().name;
  progress(first, settled);
  try {
    const Subject subject(engine, model);
    for (const Claim& claim : claims()) {
      progress(claim.name, settled);
      settled.push_back(settle(claim, subject));
    }
  } catch (const std::exception& error) {
    settled.push_back(unmeasured(first, reason(error)));
  }
  return settled;
}

SettledClaim unmeasured(std::string_view claim, const std::string& why) {
  return {std::string(claim), not_measured, not_measured, false, why};
}

SettledClaim settle_quiet(std::size_t printed, const std::string& tail) {
  const auto bytes = static_cast<double>(printed);
  const std::string sentence =
      printed == 0 ? "prints nothing" : fmt::format("prints {} bytes", printed);
  if (bytes <= most_printed) {
    return {std::string(quiet_claim), bytes, most_printed, true, sentence};
  }
  return {std::string(quiet_claim), bytes, most_printed, false,
          sentence + ", the last line of them: " + printable(last_line(tail))};
}

std::vector<std::string> broken_claims(const std::vector<SettledClaim>& settled) {
  std::vector<std::string> names;
  for (const SettledClaim& one : settled) {
    if (!one.as_expected()) {
      names.push_back(one.claim);
    }
  }
  return names;
}

}  // namespace tautline::bench
