#include "bench/report/html/sections.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <vector>

#include "bench/base/html.hpp"
#include "bench/base/table.hpp"
#include "bench/report/scorecard/scorecards_table.hpp"
#include "bench/report/tables/columns.hpp"
#include "bench/report/tables/tables.hpp"
#include "bench/report/words.hpp"

namespace tautline::bench {
namespace {

/// The model of the control that gives only what a model with fixed steps gives.
constexpr const char* sampled = "sampled";

/// The control's own errors where it is only sampled, by metric and step; those that are zero
/// throughout are left out.
Table sampled_table(const Report& report) {
  std::map<double, const SummaryRow*, std::greater<>> rows;
  for (const SummaryRow& row : report.summary) {
    if (row.key.engine == control && row.key.model == sampled) {
      rows.emplace(row.key.step, &row);
    }
  }
  std::vector<Column> columns = {word_column("metric", ""), word_column("unit", "")};
  for (const auto& [step, row] : rows) {
    columns.push_back(
        number_column(fmt::format("step {}", number_text(step, as_count)), "", "", ""));
  }
  Table table(std::move(columns));
  for (std::size_t place = 0; place < metric_list().size(); ++place) {
    const Metric& metric = metric_list()[place];
    std::vector<Cell> cells = {in_words(metric.name), shown_unit(metric, report)};
    bool any = false;
    for (const auto& [step, row] : rows) {
      const auto& value = row->metrics.at(place);
      any = any || (value && value->worst != 0.0);
      cells.push_back(
          number_cell(value ? std::optional(value->worst) : std::nullopt, metric.digits));
    }
    if (any) {
      table.add(std::move(cells));
    }
  }
  return table;
}

/// What the comparison makes of the exact motion itself.
std::string control_paragraph(const Report& report) {
  const bool there = std::any_of(report.runs.begin(), report.runs.end(),
                                 [](const RunRow& run) { return run.key.engine == control; });
  if (!there) {
    return "<p>The control is not in this report; <code>--engines</code> with <code>exact</code> "
           "brings it.</p>\n";
  }
  std::string out =
      "<p><b>The control</b>, <code>exact</code>, is the same solver as the reference: it shows "
      "what "
      "the comparison itself costs, and nothing of whether the reference is right.";
  const Table table = sampled_table(report);
  if (table.empty()) {
    return out + "</p>\n";
  }
  return out +
         " Its model <code>sampled</code> gives only what a model with fixed steps gives: the "
         "state "
         "and the impulses of each step. What it has of an error, no such model can be blamed "
         "for:</p>\n" +
         html_table(table, "sampled-table",
                    "Worst over the cases of `exact sampled`, the exact motion seen at steps.");
}

/// With how many digits the cases are certified.
int digits_of_certificates(const Report& report) {
  const auto found = std::find_if(report.cases.begin(), report.cases.end(),
                                  [](const CaseRow& row) { return row.certified.has_value(); });
  return found != report.cases.end() ? found->certified->digits : 0;
}

}  // namespace

std::string command_html(const std::string& command) {
  return fmt::format("<span class=\"command\"><code>{}</code></span>", html_text(command));
}

std::string folded(const std::string& summary, const std::string& html) {
  return "<details class=\"fold\"><summary>" + summary + "</summary>\n" + html + "</details>\n";
}

std::string verdict_paragraph(const Report& report) {
  Tally all;
  for (const Scorecard& card : scorecards(report)) {
    all.add(card.verdicts);
  }
  return fmt::format("<p class=\"answer\"><b class=\"{}\"><span>{}</span></b>: {}</p>\n",
                     verdict_kind(all.worst()), to_string(all.worst()),
                     html_text(sentence_of(all), 500));
}

std::string scorecards_section(const Report& report) {
  const Table table = in_units_of(report, scorecards_table(report));
  std::string out = "<section id=\"engines\">\n<h2>Engines</h2>\n";
  out += table.empty() ? "<p>No engine has a run.</p>\n"
                       : html_table(table, "scorecards-table",
                                    "By name, which favours none: whose cable, and what it is "
                                    "worth.");
  return out + folded("How to read it", "<p>" + html_prose(how_to_read_scorecards()) + "</p>\n") +
         "</section>\n";
}

std::string trust_section(const Report& report) {
  std::string out =
      "<section id=\"trust\">\n<h2>Can the reference be believed?</h2>\n"
      "<p><b>Against many digits.</b> The exact motion is computed in double precision. The same "
      "motion in many digits says until when 9, 6 and 3 digits of it are right";
  if (const Table table = in_units_of(report, certified_table(report)); !table.empty()) {
    out += ":</p>\n" + html_table(table, "certified-table",
                                  fmt::format("The exact motion against the same in {} digits, of "
                                              "the same doubles.",
                                              digits_of_certificates(report)));
  } else {
    out += ": <code>--certify</code> brings the figures into this report, in seconds a case.</p>\n";
  }
  if (!report.cases.empty()) {
    out += "<p>One case, and all that is sure of it:</p>\n<p>" +
           command_html("tautline solve " + report.cases.front().name + " --certify") + "</p>\n";
  }
  out +=
      "<p><b>The horizon.</b> Errors of 1e-12 grow to 1e-3 by the predictability horizon of each "
      "case; beyond it a difference says nothing about an engine.</p>\n";
  return out + control_paragraph(report) + "</section>\n";
}

}  // namespace tautline::bench
