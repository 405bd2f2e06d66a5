#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bench/base/table.hpp"
#include "bench/report/scorecard/scorecard.hpp"

namespace tautline::bench {

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

}  // namespace tautline::bench
