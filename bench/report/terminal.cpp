#include "bench/report/output.hpp"

#include <fmt/format.h>

#include "bench/base/table.hpp"
#include "bench/base/text.hpp"
#include "bench/report/tables/tables.hpp"
#include "bench/report/words.hpp"

namespace tautline::bench {
namespace {

/// What the headings of the answers mean, a line each.
std::string legend(const Report& report, std::size_t width) {
  std::string out;
  for (const Metric& metric : metric_list()) {
    if (is_asked_first(metric)) {
      const char* over = metric.aggregate == Aggregate::typical ? "median" : "worst";
      out += wrapped(fmt::format("{} ({}): {}", metric.brief, over, metric.meaning), width);
    }
  }
  out += wrapped(
      "match, of: Impacts of the run that have an exact match, of the exact ones, up to "
      "the horizon.",
      width);
  if (report.limits) {
    out += wrapped(fmt::format("verdict: By {}, version {}, the worst of all cases.",
                               printable(report.limits->file), printable(report.limits->version)),
                   width);
    for (const Word word : all_words) {
      out += wrapped(fmt::format("{}: {}.", to_string(word), meaning_of(word)), width);
    }
  }
  return out;
}

}  // namespace

std::string report_summary(const Report& report, const TerminalStyle& style) {
  std::string out = answers_table(report).plain(style) + "\n" + legend(report, style.text);
  if (const std::string stopped = stopped_sentence(report); !stopped.empty()) {
    out += wrapped(stopped, style.text);
  }
  if (report.distributions) {
    out += "\n" + distributions_table(report).plain(style) + "\n" +
           wrapped(distributions_paragraph(report), style.text) +
           wrapped(how_to_read_distributions, style.text);
  }
  const Table failures = failures_table(report);
  return failures.empty() ? out : out + "\n" + failures.plain(style);
}

}  // namespace tautline::bench
