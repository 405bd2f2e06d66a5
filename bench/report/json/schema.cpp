// The schema of a report, from the members by which it is written and read.

#include "bench/report/json/fields.hpp"
#include "bench/report/json/json.hpp"

namespace tautline::bench {

std::string report_schema_json() {
  Describer program;
  program.add_member("name", {{"const", "tautline"}});
  program("version", std::string());
  Describer metric;
  metric("name", std::string());
  metric("unit", std::string(), "1 for a ratio or a count");
  metric("meaning", std::string());

  Describer members;
  members.add_member("schema", {{"const", report_schema}});
  members.add_member("program", std::move(program).schema());
  members.add_member("metrics", list_of(std::move(metric).schema()),
                     "what a run is measured by; the smaller, the better");
  Report report;
  Replay replay;
  fields(members, report, replay);
  return text_of(headed("Report of `tautline bench`",
                        "Two runs of one suite on one program give the same text but for the last "
                        "key, context.",
                        std::move(members).schema()));
}

}  // namespace tautline::bench
