#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "bench/report/report.hpp"
#include "bench/report/tables/tally.hpp"

namespace tautline::bench {

// What a report says of one engine, in the few numbers that its maintainer asks for first.

/// An early position error this small, of the shortest cable of its case, is good enough for a
/// picture: a pixel where that cable is a hundred pixels long [-].
inline constexpr double good_enough = 0.01;

/// A model at a step: medians over its cases.
struct Setup {
  std::string model;
  double step = 0.0;          // [s]
  std::optional<double> off;  // [-], early position error over the shortest cable
  std::optional<CostRow> cost;
};

/// One model of an engine.
struct ModelCard {
  std::string model;
  Maker maker = Maker::by_hand;
  std::size_t impacts = 0;            // of one cable alone, audited at the smallest step
  std::optional<double> rebound_off;  // [-], root mean square of e got less e asked, in these
  std::vector<std::string> wrong;     // kinds of the findings against its rebounds
  std::vector<Setup> setups;          // in falling step
  Tally verdicts;

  /// Nothing was found against its rebounds, and there were some to find it in.
  [[nodiscard]] bool rebounds_rightly() const { return impacts > 0 && wrong.empty(); }
};

/// The models of one engine that have one maker.
struct MakerCard {
  Maker maker = Maker::engine;
  std::vector<ModelCard> models;  // in the engine's order
  /// Which model and step to use: of the models that rebound rightly and of which no run fails, at
  /// the largest step that is good enough, the one with the smallest error. Where none is good
  /// enough, the smallest error of all. None without an error.
  std::optional<Setup> use;
  bool use_is_right = false;  // false where no model rebounds rightly
  Tally verdicts;
};

/// One engine.
struct Scorecard {
  std::string engine;
  std::string version;
  std::string precision;
  std::vector<MakerCard>
      makers;  // as shipped, by hand, tautline's; those without models are left out
  std::vector<Finding> findings;
  Tally verdicts;
};
[[nodiscard]] Scorecard scorecard(const Report& report, const std::string& engine);

/// Of every engine that has runs, but for the control, by name: an order that favours none.
[[nodiscard]] std::vector<Scorecard> scorecards(const Report& report);

/// "as shipped", "made by hand", "tautline's driver".
[[nodiscard]] const char* words_of(Maker maker);

}  // namespace tautline::bench
