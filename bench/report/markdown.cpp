#include "bench/report/output.hpp"

#include <fmt/format.h>

#include "bench/base/text.hpp"
#include "bench/report/scorecard.hpp"
#include "bench/report/tables.hpp"
#include "bench/report/words.hpp"

namespace tautline::bench {
namespace {

/// A name and a sentence from outside.
std::string name_text(const std::string& name) { return markdown_text(printable(name)); }
std::string sentence_text(const std::string& sentence) {
  return markdown_text(printable(sentence, longest_sentence));
}

std::string engines_markdown(const Report& report) {
  const Table table = models_table(report);
  std::string sentences;
  for (const Scorecard& card : worst_first_scorecards(report)) {
    sentences +=
        fmt::format("- **{}**: {}\n", name_text(card.engine), sentence_text(sentence_of(card)));
  }
  return "## Engines\n\n" + sentences + "\n" +
         (table.empty() ? "No engine has a run.\n" : table.markdown()) + "\n" +
         how_to_read_models() + "\n\n";
}

std::string answers_markdown(const Report& report) {
  const std::string stopped = stopped_sentence(report);
  return "## Answers\n\nOver all cases, by engine, model and step.\n\n" +
         answers_table(report).markdown() +
         (stopped.empty() ? "" : "\n" + markdown_text(stopped) + "\n");
}

std::string convergence_section(const Report& report) {
  return "\n## Convergence\n\nSlope of log error over log step of the early position error, case "
         "by case: 1 is first order, 0 does not converge.\n\n" +
         convergence_table(report).markdown();
}

std::string causes_markdown(const Report& report) {
  const Table table = causes_table(report);
  if (table.empty()) {
    return "";
  }
  std::string out =
      "\n## Where errors come from\n\n" + table.markdown() + "\n" + how_to_read_causes() + "\n\n";
  for (const Cause cause : causes) {
    out += fmt::format("- *{}*: {}.\n", in_words(to_string(cause)), meaning_of(cause));
  }
  return out;
}

std::string distributions_markdown(const Report& report) {
  if (!report.distributions) {
    return "";
  }
  return "\n## Settling, as distributions\n\n" + distributions_paragraph(report) + "\n\n" +
         how_to_read_distributions + "\n\n" + distributions_table(report).markdown() +
         fmt::format("\n[All distributions over each other]({})\n", report.distributions->page);
}

std::string failures_section(const Report& report) {
  const Table failures = failures_table(report);
  return "\n## Failures\n\n" + (failures.empty() ? "None.\n" : failures.markdown());
}

std::string audit_markdown(const Report& report) {
  std::string list;
  for (const Finding& finding : report.findings) {
    list +=
        fmt::format("- **{} {}**: {} ({}).\n", name_text(finding.engine), name_text(finding.model),
                    sentence_text(finding.sentence), evidence_text(finding));
  }
  if (list.empty()) {
    list = "Nothing was found.\n";
  }
  return "\n## Restitution audit\n\nWhat the models do to impacts, found from their runs.\n\n" +
         list;
}

std::string runs_markdown(const Report& report) {
  std::string out = "\n## Case by case\n";
  for (const CaseRow& row : report.cases) {
    out += fmt::format("\n### {}: {}\n\n{}", name_text(row.name), name_text(row.title),
                       runs_table(report, row.name).markdown());
  }
  return out;
}

std::string models_markdown(const Report& report) {
  std::string out = "\n## How each engine models a cable\n\n";
  for (const EngineRow& engine : report.engines) {
    if (!engine.info) {
      continue;
    }
    out += fmt::format("### {} {}, {}\n\n", name_text(engine.name), name_text(engine.info->version),
                       name_text(engine.info->precision));
    for (const Model& model : engine.info->models) {
      const Table settings = settings_table(model);
      out += fmt::format("**{}**: {}\n\n", name_text(model.name), sentence_text(model.sentence));
      out += settings.empty() ? "" : settings.markdown() + "\n";
    }
  }
  return out;
}

std::string reading_markdown(const Report& report) {
  std::string out = "## How to read this report\n\n";
  for (const std::string& item : how_to_read(report)) {
    out += "- " + item + "\n";
  }
  return out;
}

std::string context_markdown(const Report& report) {
  std::string out = "\n## Context\n\n";
  for (const Fact& fact : context_facts(report)) {
    out += fmt::format("- {}: {}\n", fact.name, markdown_text(fact.text));
  }
  return out;
}

}  // namespace

std::string report_markdown(const Report& report) {
  std::string out =
      fmt::format("# Physics engines on slack cables, against the exact solution\n\n{}, {}{}.\n\n",
                  counted(report.cases.size(), "case"), counted(report.runs.size(), "run"),
                  report.complete ? "" : fmt::format(" of {} (INCOMPLETE)", report.planned_runs));
  out += engines_markdown(report) + answers_markdown(report) + convergence_section(report) +
         distributions_markdown(report) + causes_markdown(report);
  out += failures_section(report) + audit_markdown(report);
  out += "\n## The exact solutions\n\n" + cases_table(report).markdown();
  if (const Table certified = certified_table(report); !certified.empty()) {
    out += "\nCompared with the same motions in many digits:\n\n" + certified.markdown();
  }
  out += runs_markdown(report) + models_markdown(report) + reading_markdown(report);
  return out + context_markdown(report);
}

}  // namespace tautline::bench
