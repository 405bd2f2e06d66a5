#include <fmt/format.h>

#include <algorithm>
#include <tuple>

#include "bench/base/listed.hpp"
#include "bench/base/text.hpp"
#include "bench/report/scorecard/pull_request.hpp"
#include "bench/report/scorecard/scorecards_table.hpp"
#include "bench/report/tables/columns.hpp"
#include "bench/report/words.hpp"

namespace tautline::bench {
namespace {

/// A model and the engine it is of.
struct ModelRow {
  std::string engine;
  ModelCard card;
};

/// Those that break a limit first, then known deviations; within these what was found first.
std::vector<ModelRow> models_of(const std::vector<Scorecard>& cards) {
  std::vector<ModelRow> rows;
  for (const Scorecard& card : cards) {
    for (const MakerCard& maker : card.makers) {
      for (const ModelCard& model : maker.models) {
        rows.push_back({card.engine, model});
      }
    }
  }
  const auto urgency = [](const ModelRow& row) {
    const Tally& tally = row.card.verdicts;
    return std::tuple(tally.of(Word::breaks_limit), tally.of(Word::known_deviation),
                      row.card.wrong.size(), tally.of(Word::not_judged));
  };
  std::stable_sort(rows.begin(), rows.end(), [&](const ModelRow& one, const ModelRow& two) {
    return urgency(one) > urgency(two);
  });
  return rows;
}

std::string rebound_text(const ModelCard& card) {
  if (!card.wrong.empty()) {
    return fmt::format("wrong: {}", fmt::join(listed(card.wrong, kind_in_words), ", "));
  }
  return card.impacts == 0 ? "not measured" : "right";
}

/// At the smallest step, where the model is at its best.
Row row_of(const ModelRow& row) {
  const Setup& setup = row.card.setups.back();
  const auto cost = setup.cost ? std::optional(1e3 * setup.cost->second_cost) : std::nullopt;
  return {
      {word_cell(row.engine), word_cell(row.card.model), words_of(row.card.maker),
       tally_text(row.card.verdicts), sentence_cell(rebound_text(row.card)),
       number_cell(setup.step, as_count),
       brief_cell(setup.off ? std::optional(100.0 * *setup.off) : std::nullopt), brief_cell(cost)},
      "",
      ""};
}

Table table_of(const std::vector<ModelRow>& rows) {
  Table table({word_column("engine", ""), word_column("model", ""), word_column("cable", ""),
               word_column("verdict", ""), word_column("restitution", ""),
               number_column("step", "s", "", ""), number_column("off", "%", "", ""),
               number_column("cost", "ms/s", "", "")});
  for (std::size_t index = 0; index < std::min(rows.size(), most_summary_rows); ++index) {
    table.add(row_of(rows[index]));
  }
  return table;
}

std::string verdict_line(const std::vector<Scorecard>& cards) {
  Tally all;
  for (const Scorecard& card : cards) {
    all.add(card.verdicts);
  }
  return fmt::format("**{}**: {}\n", to_string(all.worst()), sentence_of(all));
}

std::string scope_line(const Report& report, std::size_t engines) {
  const std::vector<std::string> steps =
      listed(report.options.steps, [](double step) { return number_text(step, as_count); });
  return fmt::format(
      "\n{} on {}, at steps {} s, each run held against the exact motion by "
      "tautline {}{}.\n\n",
      counted(report.cases.size(), "case"), counted(engines, "engine"), joined(steps, "and"),
      markdown_text(printable(report.version)), report.complete ? "" : " (INCOMPLETE)");
}

}  // namespace

std::string summary_markdown(const Report& report) {
  const std::vector<Scorecard> cards = scorecards(report);
  const std::vector<ModelRow> rows = models_of(cards);
  std::string out = verdict_line(cards) + scope_line(report, cards.size());
  if (rows.empty()) {
    return out + "No engine has a run.\n";
  }
  out += table_of(rows).markdown();
  if (rows.size() > most_summary_rows) {
    out += fmt::format("\nand {}, in report.md and index.html.\n",
                       counted(rows.size() - most_summary_rows, "further model"));
  }
  out +=
      "\n*off*: position error over the first impacts, of the shortest cable's length, median "
      "over the cases; *cost*: processor time of a simulated second; both at the smallest "
      "step.\n";
  return out;
}

}  // namespace tautline::bench
