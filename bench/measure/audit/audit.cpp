// Goes over the runs of a report by model and asks each what it does to impacts.

#include "bench/measure/audit/audit.hpp"

#include <map>
#include <utility>

#include "bench/measure/audit/impacts.hpp"
#include "bench/report/replay_data.hpp"

namespace tautline::bench {
namespace {

using nlohmann::ordered_json;

/// The models of a report with their impacts, in the order of their first runs.
std::vector<AuditedModel> audited_models(ordered_json& report) {
  std::map<std::string, const ordered_json*> cases;
  for (const ordered_json& row : report.at("cases")) {
    cases[row.at("name")] = &row;
  }
  std::vector<AuditedModel> models;
  std::map<std::pair<std::string, std::string>, std::size_t> places;
  for (ordered_json& run : report.at("runs")) {
    if (run.at("impacts").is_null()) {
      continue;
    }
    const ordered_json& the_case = *cases.at(run.at("case"));
    run["audit"] = run_audit(run, the_case);
    const std::pair<std::string, std::string> key = {run.at("engine"), run.at("model")};
    const auto [place, is_new] = places.emplace(key, models.size());
    if (is_new) {
      models.push_back({key.first, key.second, 0, {}, {}});
    }
    AuditedModel& model = models[place->second];
    ++model.runs;
    for (const AuditedImpact& impact : audited_impacts(run, the_case)) {
      model.impacts.push_back(impact);
    }
    if (auto freeze = freeze_of(run, the_case)) {
      model.freezes.push_back(std::move(*freeze));
    }
  }
  return models;
}

}  // namespace

void add_audit(ordered_json& report) {
  ordered_json rows = ordered_json::array();
  for (const AuditedModel& model : audited_models(report)) {
    for (const auto& look : {restitution_findings, impulse_findings, sleep_findings}) {
      for (const AuditFinding& finding : look(model)) {
        rows.push_back({{"engine", model.engine},
                        {"model", model.model},
                        {"kind", finding.kind},
                        {"sentence", finding.sentence},
                        {"value", finding.value ? rounded(*finding.value) : ordered_json(nullptr)},
                        {"unit", finding.unit},
                        {"evidence", {{"runs", finding.runs}, {"impacts", finding.impacts}}}});
      }
    }
  }
  report["findings"] = std::move(rows);
}

}  // namespace tautline::bench
