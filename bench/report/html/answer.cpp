#include "bench/report/html/sections.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "bench/base/html.hpp"
#include "bench/base/listed.hpp"
#include "bench/report/tables/columns.hpp"
#include "bench/report/words.hpp"

namespace tautline::bench {
namespace {

/// The smallest and the largest of some numbers.
struct Range {
  double smallest;
  double largest;
};

/// The median errors up to the horizon at the smallest step, of the control or of the others; none
/// without a number.
std::optional<Range> median_errors(const Report& report, bool of_control) {
  double step = std::numeric_limits<double>::infinity();
  for (const SummaryRow& row : report.summary) {
    step = std::min(step, row.key.step);
  }
  const auto place = place_of("horizon_position_error");
  std::optional<Range> result;
  for (const SummaryRow& row : report.summary) {
    const auto& error = row.metrics.at(place.value());
    if (row.key.step == step && (row.key.engine == control) == of_control && error &&
        error->median) {
      const double value = *error->median;
      result = result ? Range{std::min(result->smallest, value), std::max(result->largest, value)}
                      : Range{value, value};
    }
  }
  return result;
}

/// How the runs ended; what did not happen is not said.
std::string endings_sentence(const Report& report) {
  const auto count = [&](auto... statuses) {
    return std::count_if(report.runs.begin(), report.runs.end(),
                         [&](const RunRow& run) { return ((run.status == statuses) || ...); });
  };
  std::vector<std::string> parts = {fmt::format("{} ran to the end", count(Status::finished))};
  if (const auto stopped = count(Status::stopped); stopped > 0) {
    parts.push_back(fmt::format("{} stopped where the engine goes no further", stopped));
  }
  if (const auto bad = count(Status::failed, Status::diverged); bad > 0) {
    parts.push_back(fmt::format("{} failed or diverged", bad));
  }
  return joined(parts, "and") + ".";
}

/// What the comparison makes of the exact motion itself.
std::string control_clause(double largest) {
  return "the exact motion, compared with itself as a control, " +
         (largest == 0.0 ? "shows no deviation"
                         : fmt::format("deviates by up to {} m", number_text(largest, as_error)));
}

std::string errors_sentence(const Report& report) {
  const auto engines = median_errors(report, false);
  const auto exact = median_errors(report, true);
  if (!engines) {
    return "";
  }
  return fmt::format(
             " At the smallest step the median distance from the exact position, up to the "
             "predictability horizon, is between {} and {} m, by engine and model",
             number_text(engines->smallest, as_error), number_text(engines->largest, as_error)) +
         (exact ? "; " + control_clause(exact->largest) + "." : ".");
}

std::string missing_sentence(const Report& report) {
  std::vector<std::string> names;
  for (const EngineRow& engine : report.engines) {
    if (engine.problem) {
      names.push_back(html_text(engine.name));
    }
  }
  return names.empty() ? "" : " Not compared: " + joined(names, "and") + ", for the reasons below.";
}

std::string main_findings(const Report& report) {
  constexpr std::size_t enough = 5;
  const auto& findings = report.findings;
  std::string out;
  for (std::size_t index = 0; index < std::min(enough, findings.size()); ++index) {
    out += fmt::format("<li>{} {}: {}</li>\n", html_text(findings[index].engine),
                       html_text(findings[index].model), html_prose(findings[index].sentence));
  }
  if (findings.size() > enough) {
    out += fmt::format("<li><a href=\"#audit\">and {} more</a></li>\n", findings.size() - enough);
  }
  return out.empty() ? "" : "<ul class=\"findings\">\n" + out + "</ul>\n";
}

/// "2 cases on 3 engines with 7 models, at steps 0.01 and 0.001 s: 42 runs (40 of engines, 2 of the
/// control)".
std::string scope(const Report& report) {
  std::set<std::string> engines;
  std::set<std::pair<std::string, std::string>> models;
  for (const SummaryRow& row : report.summary) {
    engines.insert(row.key.engine);
    models.emplace(row.key.engine, row.key.model);
  }
  const std::vector<std::string> steps =
      listed(report.options.steps, [](double step) { return number_text(step, as_count); });
  const auto controls = std::count_if(report.runs.begin(), report.runs.end(),
                                      [](const RunRow& run) { return run.key.engine == control; });
  const auto all = static_cast<std::ptrdiff_t>(report.runs.size());
  return fmt::format(
      "{} on {} with {}, at {} of {} s: {}{}", counted(report.cases.size(), "case"),
      counted(engines.size(), "engine"), counted(models.size(), "model"),
      steps.size() == 1 ? "a step" : "steps", joined(steps, "and"),
      counted(report.runs.size(), "run"),
      controls == 0 || controls == all
          ? ""
          : fmt::format(" ({} of engines, {} of the control)", all - controls, controls));
}

}  // namespace

std::string answer_paragraph(const Report& report) {
  std::string out =
      fmt::format("<p class=\"answer\">{}, each held against the exact motion of its case. {}",
                  scope(report), endings_sentence(report));
  if (!report.complete) {
    out += fmt::format(
        " <strong>This report is incomplete: {} planned.</strong>",
        counted(report.planned_runs, "run") + (report.planned_runs == 1 ? " was" : " were"));
  }
  return out + errors_sentence(report) + missing_sentence(report) + "</p>\n" +
         main_findings(report);
}

}  // namespace tautline::bench
