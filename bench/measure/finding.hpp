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

/// What a finding is about: the speed at which a body leaves, the impulse, or how long it takes.
enum class Aspect { rebound, impulse, duration };

/// A kind of finding.
struct FindingKind {
  std::string_view name;
  Aspect about;
};
inline constexpr std::array finding_kinds = {FindingKind{"none", Aspect::rebound},
                                             FindingKind{"lost-below", Aspect::rebound},
                                             FindingKind{"loses-some", Aspect::rebound},
                                             FindingKind{"scatters", Aspect::rebound},
                                             FindingKind{"off", Aspect::rebound},
                                             FindingKind{"sleeping", Aspect::rebound},
                                             FindingKind{"tangential-impulse", Aspect::impulse},
                                             FindingKind{"angular-impulse", Aspect::impulse},
                                             FindingKind{"several-steps", Aspect::duration}};

/// The kind of this name; null if there is none.
[[nodiscard]] constexpr const FindingKind* finding_kind(std::string_view name) {
  for (const FindingKind& kind : finding_kinds) {
    if (kind.name == name) {
      return &kind;
    }
  }
  return nullptr;
}

}  // namespace tautline::bench
