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

/// The kinds of findings: on rebounds, on a body that stands still, on impulses, and on how long an
/// impact takes.
inline constexpr std::array<std::string_view, 9> finding_kinds = {
    "none",     "lost-below",         "loses-some",      "scatters",     "off",
    "sleeping", "tangential-impulse", "angular-impulse", "several-steps"};

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

}  // namespace tautline::bench
