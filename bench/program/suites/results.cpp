#include "bench/program/suites/results.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <ctime>

#include "bench/base/atomic_file.hpp"
#include "bench/base/terminal.hpp"
#include "bench/gate/broken.hpp"
#include "bench/gate/gate_text.hpp"
#include "bench/program/common.hpp"
#include "bench/report/json/json.hpp"
#include "bench/report/output.hpp"
#include "bench/report/scorecard/pull_request.hpp"
#include "bench/report/scorecard/scorecard.hpp"
#include "bench/suite/report_of.hpp"

namespace tautline::bench {
namespace {

/// True if a run or an engine did not do what it should.
bool any_failure(const Report& report) {
  return std::any_of(report.runs.begin(), report.runs.end(),
                     [](const RunRow& run) { return !did_its_work(run.status); }) ||
         std::any_of(report.engines.begin(), report.engines.end(), [](const EngineRow& engine) {
           return engine.problem.has_value() && !engine.missing;
         });
}

}  // namespace

void write_results(const ResultsTarget& target, const Report& report) {
  const std::string json = report_json(report);
  write_file(target.out / "report.json", json);
  write_file(target.out / "report.md", report_markdown(report));
  write_motions(target.out, report);
  write_file(target.out / "index.html", report_html(report, page_assets()));
  write_file(target.out / "summary.md", summary_markdown(report));
  for (const Scorecard& card : scorecards(report)) {
    write_file(target.out / card_name(card.engine), card_svg(report, card.engine));
  }
  if (!target.json.empty()) {
    write_output(target.json, json);
  }
}

void print_results(const ResultsTarget& target, const Report& report, const std::string& last) {
  if (target.json != "-") {
    fmt::print("{}\n{}; report: {}, with report.md and report.json next to it\n",
               report_summary(report, output_style()), last, (target.out / "index.html").string());
  }
}

int judged(const ResultsTarget& target, const Report& report) {
  if (!target.gate) {
    return any_failure(report) ? exit_failed : exit_done;
  }
  // a known failure does not break it
  const std::vector<BrokenRow> broken = broken_rows(report, target.limits);
  fmt::print(target.json == "-" ? stderr : stdout, "\n{}",
             gate_text(report, target.limits, broken));
  return broken.empty() ? exit_done : exit_failed;
}

std::string now_utc() {
  return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr)));
}

}  // namespace tautline::bench
