#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "bench/base/table.hpp"
#include "bench/report/report.hpp"
#include "bench/report/tally.hpp"

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
/// Whose choice a setting is: "its demo’s".
[[nodiscard]] const char* words_of(Origin origin);

/// The scorecards of a report: a row for each engine and maker of its models.
[[nodiscard]] Table scorecards_table(const Report& report);

/// "restitution ignored": the kind of a finding.
[[nodiscard]] std::string kind_in_words(std::string kind);

/// A number to two digits, with all of them kept.
[[nodiscard]] Cell brief_cell(const std::optional<double>& value);

/// How to read it, in a paragraph; marked up as in Markdown.
[[nodiscard]] std::string how_to_read_scorecards();

/// "right", "right; not in contact", "wrong", "not measured": the rebounds of some models.
[[nodiscard]] std::string rebounds_text(const MakerCard& card);

/// "contact: threshold, gain", a model each: what was found of the models of one maker.
[[nodiscard]] std::vector<std::string> findings_texts(const Scorecard& card, const MakerCard& of);

/// A share as a percentage: "0.61 %".
[[nodiscard]] std::string percent_text(double share);

// What fits a comment on a pull request, and a card to put next to it.

/// The most rows of the summary's table; GitHub folds a comment that is much longer.
inline constexpr std::size_t most_summary_rows = 20;

/// The most characters of the summary: a comment on GitHub has room for 65,536.
inline constexpr std::size_t longest_summary = 60000;

/// summary.md: the verdict in one line, then the models, those that break a limit first.
[[nodiscard]] std::string summary_markdown(const Report& report);

/// card-<engine>.svg: the engine, its version, its verdict and the three numbers that matter.
[[nodiscard]] std::string card_svg(const Report& report, const std::string& engine);

/// The name of that file.
[[nodiscard]] std::string card_name(const std::string& engine);

}  // namespace tautline::bench
