#include <algorithm>
#include <utility>
#include <vector>

#include "bench/gate/changes.hpp"
#include "bench/gate/changes_output.hpp"
#include "bench/gate/listed_problems.hpp"
#include "bench/gate/trend.hpp"
#include "bench/gate/verdict.hpp"
#include "bench/report/json/json.hpp"
#include "bench/report/output.hpp"
#include "bench/store/manifest.hpp"
#include "fuzz/targets.hpp"

namespace tautline::fuzz {
namespace {

void use(bench::Report report, const bench::Replay& replay) {
  const std::string written = bench::report_json(report, replay);
  const bench::ReportReading again = bench::report_from(written, "written.json");
  require(again.report.has_value(), "what is written reads back");
  require(bench::report_json(*again.report, again.replay) == written, "it is written alike");

  const bench::Changes none = bench::changes(report, report);
  require(!none.worse() && none.count_better() == 0, "a report has not changed from itself");
  static_cast<void>(bench::changes_text(none) + bench::changes_json(none));
  const bench::Trend trend = bench::trend({report, report}, {"one.json", "two.json"});
  static_cast<void>(bench::trend_text(trend, true, bench::unlimited) + bench::trend_json(trend));

  static const bench::ListedProblems listed = bench::shipped_problems();
  bench::add_verdicts(report, listed);
  static_cast<void>(bench::report_markdown(report) +
                    bench::report_summary(report, true, bench::unlimited));
}

}  // namespace

void fuzz_reports(std::string_view input) {
  bench::ReportReading reading = bench::report_from(input, "input.json");
  require_sentences(reading.problems, !reading.report);
  static_cast<void>(bench::manifest_from(input));
  if (const auto record = bench::record_from(input, "")) {
    static_cast<void>(bench::run_json(record->row, record->replay));
  }
  if (reading.report && bench::contradiction(*reading.report).empty()) {
    use(std::move(*reading.report), reading.replay);
  }
}

}  // namespace tautline::fuzz
