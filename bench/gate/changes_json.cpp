#include "bench/data/describer.hpp"
#include "bench/gate/changes_fields.hpp"
#include "bench/gate/changes_output.hpp"

namespace tautline::bench {

std::string changes_json(const Changes& changes) { return text_of(json_of(changes)); }

std::string trend_json(const Trend& trend) { return text_of(json_of(trend)); }

std::string version_trends_json(const std::vector<VersionTrend>& trends) {
  return text_of(json_of(VersionTrends{trends}));
}

std::string compare_schema_json() {
  return text_of(
      headed("What `tautline compare --json` writes",
             "Of two reports what changed beyond noise and tolerance, runs told apart by "
             "case, engine, model and step; of more a trend: "
             "how every engine, model and step does from report to report, each metric "
             "over the cases that all of them could measure.",
             {{"anyOf", {schema_of(Changes()), schema_of(Trend())}}}));
}

std::string version_trends_schema_json() {
  return text_of(headed("What `tautline trend --json` writes",
                        "How engines do over the versions of their packages.",
                        schema_of(VersionTrends())));
}

}  // namespace tautline::bench
