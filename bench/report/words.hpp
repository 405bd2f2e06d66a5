#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "bench/report/report.hpp"

namespace tautline::bench {

// What a report says in sentences, for Markdown and for a page: *stressed*, **strong** and `code`
// words are marked as in Markdown.

/// Sentences of plug-ins and files are cut after this many bytes.
inline constexpr std::size_t longest_sentence = 1000;

/// A name of the report's files in words: "early_position_error" is "early position error".
[[nodiscard]] std::string in_words(std::string_view name);

/// What the words of the tables mean, an item each.
[[nodiscard]] std::vector<std::string> how_to_read(const Report& report);

/// What a verdict's word means: "every limit on the run holds".
[[nodiscard]] std::string_view meaning_of(Word word);

/// The words of verdicts and what they mean, in a sentence each.
[[nodiscard]] std::string verdict_words();

/// How well a run follows the exact motion, in a phrase: "0.99 times what a plain scheme may be off
/// by, up to 2.3 s".
[[nodiscard]] std::string followed_text(const Following& following);

/// What was compared and what was found, in a paragraph.
[[nodiscard]] std::string answer_text(const Report& report);

/// What the page is about, for one who has never seen it.
[[nodiscard]] std::string lead_sentence(const Report& report);

/// What a finding is drawn from: "17 impacts of 3 runs".
[[nodiscard]] std::string evidence_text(const Finding& finding);

/// Says which models stopped before their end, each with its first reason, and that this is no
/// failure; "" without one. Not marked up.
[[nodiscard]] std::string stopped_sentence(const Report& report);

/// What is said of systems, and of the models that run none; "" where no case is a system.
[[nodiscard]] std::string systems_sentence(const Report& report);

/// What made the report, a name and a text each. Not marked up.
struct Fact {
  std::string name;
  std::string text;
  bool as_typed = false;  // is code: a command or its like
};
[[nodiscard]] std::vector<Fact> context_facts(const Report& report);

/// A case in units of its own: its gravity is exactly one, as a case says that has no metres and no
/// seconds (see BasicCase).
[[nodiscard]] bool is_nondimensional(const CaseRow& the_case);

/// Every case of the report is, and there is one.
[[nodiscard]] bool is_nondimensional(const Report& report);

/// "1 run", "2 runs".
[[nodiscard]] std::string counted(std::size_t count, const std::string& one);

}  // namespace tautline::bench
