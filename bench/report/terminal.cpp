#include "bench/report/terminal.hpp"

#include <fmt/format.h>

#include <vector>

#include "bench/base/table.hpp"
#include "bench/base/text.hpp"
#include "bench/report/tables/answers_table.hpp"
#include "bench/report/tables/columns.hpp"
#include "bench/report/tables/tables.hpp"
#include "bench/report/words.hpp"

namespace tautline::bench {
namespace {

constexpr std::size_t line_length = 80;  // [columns], of sentences

/// What the headings of the answers mean, a line each.
std::string legend(const Report& report) {
  std::string out;
  for (const Metric& metric : metric_list()) {
    if (metric.shown == Shown::by_run_and_over_cases && !metric.brief.empty()) {
      const char* over = metric.aggregate == Aggregate::typical ? "median" : "worst";
      out += wrapped(fmt::format("{} ({}): {}", metric.brief, over, metric.meaning), line_length);
    }
  }
  out += wrapped(
      "match, of: Impacts of the run that have an exact match, of the exact ones, up to "
      "the horizon.",
      line_length);
  if (report.limits) {
    out += wrapped(fmt::format("verdict: By {}, version {}, the worst of all cases.",
                               printable(report.limits->file), printable(report.limits->version)),
                   line_length);
    for (const Word word : all_words) {
      out += wrapped(fmt::format("{}: {}.", to_string(word), meaning_of(word)), line_length);
    }
  }
  return out;
}

std::string number_and_unit(double value, const Digits& digits, const std::string& unit) {
  return number_text(value, digits) + (unit.empty() ? "" : " " + unit);
}

/// Every metric, with its unit.
Table metrics_of(const RunRow& run) {
  Table table({word_column("against the exact motion", ""), number_column("", "", "", ""),
               word_column("", "")});
  for (std::size_t place = 0; place < metric_list().size(); ++place) {
    const Metric& metric = metric_list()[place];
    table.add(
        {in_words(metric.name), number_cell(run.metric(place), metric.digits), shown_unit(metric)});
  }
  return table;
}

/// The impacts of each window and how far the run was compared.
Table windows_of(const RunDetails& details) {
  Table table({word_column("up to", ""), number_column("instant [s]", "", "", ""),
               number_column("compared to [s]", "", "", ""),
               number_column("exact impacts", "", "", ""), number_column("found", "", "", ""),
               number_column("matched", "", "", "")});
  for (const Window window : windows) {
    const RunDetails::OfWindow& of = details.in(window);
    const char* name = window == Window::early     ? "the first impacts"
                       : window == Window::horizon ? "the horizon"
                                                   : "the end";
    table.add({name, number_cell(of.until, as_instant), number_cell(of.covered, as_instant),
               count_cell(of.exact), count_cell(of.found), count_cell(of.matched)});
  }
  return table;
}

/// What the run found of a number, and what is exact.
std::string found_and_exact(const std::optional<double>& found, const std::optional<double>& exact,
                            const std::string& unit, int digits) {
  const auto text = [&](const std::optional<double>& value) {
    return value ? number_and_unit(*value, fixed(digits), unit) : std::string("none");
  };
  return fmt::format("{} (exact: {})", text(found), text(exact));
}

std::string swing_sentence(const SwingMatch& swing) {
  return fmt::format("Swing from {:.4f} to {:.4f} s: energy {}, amplitude {}.", swing.from,
                     swing.until, found_and_exact(swing.energy.found, swing.energy.exact, "J", 8),
                     found_and_exact(swing.amplitude.found, swing.amplitude.exact, "rad", 5));
}

std::string restitution_sentence(const MeasuredRestitution& measured) {
  return fmt::format("Restitution of {}: {} in the mean, from {} to {}.",
                     counted(measured.count, "impact"), fixed_text(measured.mean, 4),
                     fixed_text(measured.smallest, 4), fixed_text(measured.largest, 4));
}

/// Settling, the swing, restitution and what was recorded, a sentence each.
std::string sentences_of(const RunDetails& details) {
  std::vector<std::string> sentences;
  for (const LastImpactMatch& last : details.last_impacts) {
    sentences.push_back(fmt::format("Last impact faster than {:g} m/s: {}.", last.speed,
                                    found_and_exact(last.found, last.exact, "s", 4)));
  }
  if (details.swing) {
    sentences.push_back(swing_sentence(*details.swing));
  }
  if (details.restitution) {
    sentences.push_back(restitution_sentence(*details.restitution));
  }
  sentences.push_back(fmt::format("Recorded: {}.", counted(details.recorded_impacts, "impact")));
  if (details.slow_impacts > 0) {
    sentences.push_back(
        fmt::format("Slower, and only counted: {}.", counted(details.slow_impacts, "impact")));
  }
  std::string out;
  for (const std::string& sentence : sentences) {
    out += wrapped(sentence, line_length);
  }
  return out;
}

}  // namespace

std::string report_summary(const Report& report, const TerminalStyle& style) {
  std::string out = answers_table(report).plain(style) + "\n" + legend(report);
  if (const std::string stopped = stopped_sentence(report); !stopped.empty()) {
    out += wrapped(stopped, line_length);
  }
  const Table failures = failures_table(report);
  return failures.empty() ? out : out + "\n" + failures.plain();
}

std::string run_text(const RunRow& run) {
  std::string out =
      fmt::format("{} on {} {}, step {:g} s: {}{}\n", printable(run.key.the_case),
                  printable(run.key.engine), printable(run.key.model), run.key.step,
                  to_string(run.status), run.reason.empty() ? "" : ", " + printable(run.reason));
  if (run.metrics && run.details) {
    out += "\n" + metrics_of(run).plain() + "\n" + windows_of(*run.details).plain() + "\n" +
           sentences_of(*run.details);
  }
  return out;
}

}  // namespace tautline::bench
