#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "bench/base/table.hpp"
#include "bench/report/report.hpp"
#include "bench/report/tally.hpp"

namespace tautline::bench {

// One engine in a report: its models in words and numbers, and which of them to use.

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
  std::string engine;
  std::string model;
  Maker maker = Maker::by_hand;
  std::optional<ModelJudgement> judged;  // none where no run could be judged
  std::vector<std::string> wrong;        // what is wrong with it, the gravest first
  std::vector<std::string> listed;       // why problems of it are listed, each once
  std::vector<Setup> setups;             // in falling step
  Tally verdicts;
  bool unsupported = false;  // its engine does none of the runs

  /// It keeps the restitution, follows the exact motion as well as its step can, and nothing else
  /// is wrong with it.
  [[nodiscard]] bool may_be_used() const;
};

/// One engine.
struct Scorecard {
  std::string engine;
  std::string version;
  std::string precision;
  std::vector<ModelCard> models;  // as shipped, by hand, tautline's; in the engine's order
  /// Which model and step to use, of the models that may be used and at steps at which no run has a
  /// problem: at the largest step that is good enough, the one with the smallest error. None where
  /// no model may be used, or none is good enough.
  std::optional<Setup> use;
  Tally verdicts;
};
[[nodiscard]] Scorecard scorecard(const Report& report, const std::string& engine);

/// One for every engine that has runs, but for the control, by name.
[[nodiscard]] std::vector<Scorecard> scorecards(const Report& report);

/// The same, those with the most grave problems first.
[[nodiscard]] std::vector<Scorecard> worst_first_scorecards(const Report& report);

/// What is said of an engine, in sentences without its name; not marked up.
struct EngineWords {
  std::string model;          // whose fault comes first, or else the one to use, or the first
  std::string fault;          // the faults of its models
  std::string advice;         // which model to use, at which step, with error and cost
  Word word = Word::too_few;  // sound only where every model was judged and is
};
[[nodiscard]] EngineWords words_of(const Scorecard& card);

/// Fault and advice.
[[nodiscard]] std::string sentence_of(const Scorecard& card);

/// "as shipped", "made by hand", "tautline's driver".
[[nodiscard]] const char* words_of(Maker maker);
/// Whose choice a setting is: "its demo’s".
[[nodiscard]] const char* words_of(Origin origin);

/// A row for each model: whose it is, its restitution and its position in words, its verdict, the
/// step that it is judged at, error and cost there.
[[nodiscard]] Table models_table(const Report& report);

/// A number to two digits, with all of them kept.
[[nodiscard]] Cell brief_cell(const std::optional<double>& value);

/// How to read it, in a paragraph; marked up as in Markdown.
[[nodiscard]] std::string how_to_read_models();

/// A share as a percentage: "0.61 %".
[[nodiscard]] std::string percent_text(double share);

// What fits a comment on a pull request, and a card to put next to it.

/// The most rows of the summary's table; GitHub folds a comment that is much longer.
inline constexpr std::size_t most_summary_rows = 20;

/// The most characters of the summary: a comment on GitHub has room for 65,536.
inline constexpr std::size_t longest_summary = 60000;

/// summary.md: a sentence for each engine, then its models, the worst first.
[[nodiscard]] std::string summary_markdown(const Report& report);

/// card-<engine>.svg: the engine, its version, what is said of it and the model to use.
[[nodiscard]] std::string card_svg(const Report& report, const std::string& engine);

/// The name of that file.
[[nodiscard]] std::string card_name(const std::string& engine);

}  // namespace tautline::bench
