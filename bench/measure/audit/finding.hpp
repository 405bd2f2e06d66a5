#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tautline::bench {

/// One run of a model.
struct RunOfModel {
  std::string the_case;
  double step = 0.0;  // [s]
};

/// What a model does to impacts, found from its runs.
struct Finding {
  std::string engine;
  std::string model;
  std::string kind;                  // of `finding_kinds`
  std::string sentence;              //
  std::optional<double> value;       // in `unit`
  std::string unit;                  // "" for a ratio
  std::size_t runs = 0;              // that it is drawn from
  std::size_t impacts = 0;           // of these; 0 where it is not drawn from impacts
  std::vector<RunOfModel> shown_in;  // the runs that it is about, as it shows in them
};

/// A kind of finding, and whether a run that shows it can pass: what a limit on numbers misses must
/// not be called right.
struct FindingKind {
  std::string_view name;
  bool contradicts_a_pass;
};
inline constexpr std::array finding_kinds = {
    FindingKind{"threshold", true}, FindingKind{"sleeping", true},
    FindingKind{"restitution-ignored", true}, FindingKind{"scatter", true},
    FindingKind{"gain", true}, FindingKind{"offset", true}, FindingKind{"tangential-impulse", true},
    FindingKind{"angular-impulse", true},
    // how an impact is made, not what becomes of it
    FindingKind{"several-steps", false}};

}  // namespace tautline::bench
