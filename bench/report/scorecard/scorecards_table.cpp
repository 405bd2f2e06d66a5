#include "bench/report/scorecard/scorecards_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "bench/base/text.hpp"
#include "bench/report/tables/columns.hpp"

namespace tautline::bench {
namespace {

std::vector<Column> columns_of() {
  return {word_column("engine", "engine"),
          word_column("version", ""),
          word_column("cable", "maker"),
          word_column("restitution at impacts", "restitution"),
          word_column("verdict", "verdict"),
          word_column("use", "use"),
          number_column("step", "s", "", "step"),
          number_column("off", "%", "", "off"),
          number_column("cost", "ms/s", "", "cost"),
          word_column("found", "")};
}

std::optional<double> percent(const std::optional<Setup>& use) {
  return use && use->off ? std::optional(100.0 * *use->off) : std::nullopt;
}

/// Processor time of a simulated second [ms/s].
std::optional<double> cost_of(const std::optional<Setup>& use) {
  return use && use->cost ? std::optional(1e3 * use->cost->second_cost) : std::nullopt;
}

/// The model to use; where none rebounds rightly, that, and which is nearest.
Cell use_cell(const MakerCard& of) {
  if (!of.use) {
    return "none";
  }
  return word_cell((of.use_is_right ? "" : "none; nearest: ") + of.use->model);
}

Row row_of(const Scorecard& card, const MakerCard& of) {
  Cell found = sentence_cell(fmt::format("{}", fmt::join(findings_texts(card, of), "; ")));
  if (found.text.empty()) {
    found.text = "nothing";
  }
  return {{word_cell(card.engine), word_cell(card.version + ", " + card.precision),
           words_of(of.maker), sentence_cell(rebounds_text(of)), tally_cell(of.verdicts),
           use_cell(of), number_cell(of.use ? std::optional(of.use->step) : std::nullopt, as_count),
           brief_cell(percent(of.use)), brief_cell(cost_of(of.use)), std::move(found)},
          "",
          ""};
}

}  // namespace

std::string kind_in_words(std::string kind) {
  std::replace(kind.begin(), kind.end(), '-', ' ');
  return kind;
}

Cell brief_cell(const std::optional<double>& value) {
  Cell cell = number_cell(value, as_error);
  cell.text = value ? fmt::format("{:.2g}", *value) : cell.text;
  return cell;
}

Table scorecards_table(const Report& report) {
  Table table(columns_of());
  for (const Scorecard& card : scorecards(report)) {
    for (const MakerCard& of : card.makers) {
      table.add(row_of(card, of));
    }
  }
  return table;
}

std::string how_to_read_scorecards() {
  return fmt::format(
      "Engines stand by name, which favours none. *Cable*: whose it is. **As shipped** is a joint, "
      "a "
      "limit, a contact or a solver that the engine has; **made by hand** is built with the "
      "engine's "
      "parts; with **tautline's driver** the engine flies and solves, and tautline finds the "
      "instants. *Use*: of the models that rebound rightly and of which no run fails, at the "
      "largest "
      "step whose error is up to {:g} %, the most accurate. *Off*: its position error over the "
      "first "
      "impacts, of the shortest cable's length, median over the cases. *Cost*: processor time of a "
      "simulated second. *Verdict*: the worst of all runs, and how many have it.",
      100.0 * good_enough);
}

std::string rebounds_text(const MakerCard& card) {
  std::vector<std::string> right;
  std::vector<std::string> wrong;
  for (const ModelCard& model : card.models) {
    if (!model.wrong.empty()) {
      wrong.push_back(model.model);
    } else if (model.impacts > 0) {
      right.push_back(model.model);
    }
  }
  if (right.empty()) {
    return wrong.empty() ? "not measured" : "wrong";
  }
  return wrong.empty()
             ? "right"
             : fmt::format("right in {}; wrong in {}", joined(right, "and"), joined(wrong, "and"));
}

std::vector<std::string> findings_texts(const Scorecard& card, const MakerCard& of) {
  std::vector<std::string> texts;
  for (const ModelCard& model : of.models) {
    std::vector<std::string> kinds;
    for (const Finding& finding : card.findings) {
      if (finding.model == model.model) {
        kinds.push_back(kind_in_words(finding.kind));
      }
    }
    if (!kinds.empty()) {
      texts.push_back(fmt::format("{}: {}", model.model, fmt::join(kinds, ", ")));
    }
  }
  return texts;
}

std::string percent_text(double share) { return fmt::format("{:.2g} %", 100.0 * share); }

}  // namespace tautline::bench
