#include "bench/report/attribution_json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "bench/base/statistics.hpp"
#include "bench/report/tables.hpp"

namespace tautline::bench {
namespace {

using nlohmann::ordered_json;

/// The runs of one engine, model and step.
struct Group {
  ordered_json row;                                       // what they have in common
  std::vector<double> deviations;                         // [m]
  std::array<std::vector<double>, causes.size()> shares;  // [-]
  double remainder = 0.0;                                 // [-] of the deviation, largest
};

void add(Group& group, const ordered_json& attribution) {
  if (!attribution.is_object() || attribution.at("parts").is_null()) {
    return;
  }
  double all = 0.0;
  for (const ordered_json& part : attribution.at("parts")) {
    all += std::abs(part.get<double>());
  }
  const double deviation = attribution.at("deviation");
  group.deviations.push_back(deviation);
  for (std::size_t index = 0; index < causes.size(); ++index) {
    const double part = attribution.at("parts").at(std::string(to_string(causes[index])));
    group.shares[index].push_back(all > 0.0 ? std::abs(part) / all : 0.0);
  }
  if (deviation > 0.0) {
    group.remainder =
        std::max(group.remainder, std::abs(attribution.at("remainder").get<double>()) / deviation);
  }
}

ordered_json finished(Group& group) {
  ordered_json row = std::move(group.row);
  row["cases"] = group.deviations.size();
  row["deviation"] = nullptr;
  row["shares"] = nullptr;
  row["remainder"] = nullptr;
  if (!group.deviations.empty()) {
    row["deviation"] = {
        {"median", median(group.deviations)},
        {"worst", *std::max_element(group.deviations.begin(), group.deviations.end())}};
    row["shares"] = ordered_json::object();
    for (std::size_t index = 0; index < causes.size(); ++index) {
      row["shares"][std::string(to_string(causes[index]))] = median(group.shares[index]);
    }
    row["remainder"] = group.remainder;
  }
  return row;
}

}  // namespace

ordered_json attribution_json(const Attribution& attribution) {
  ordered_json parts = nullptr;
  if (attribution.parts) {
    parts = ordered_json::object();
    for (std::size_t index = 0; index < causes.size(); ++index) {
      parts[std::string(to_string(causes[index]))] = (*attribution.parts)[index];
    }
  }
  return {{"until", attribution.until},  {"deviation", attribution.deviation},
          {"parts", std::move(parts)},   {"remainder", attribution.remainder},
          {"arcs", attribution.arcs},    {"impacts", attribution.impacts},
          {"reason", attribution.reason}};
}

ordered_json attribution_summary_json(const ordered_json& runs) {
  std::vector<Group> groups;
  std::map<std::tuple<std::string, std::string, double>, std::size_t> places;
  for (const ordered_json& run : runs) {
    const auto [place, added] =
        places.try_emplace({run.at("engine"), run.at("model"), run.at("step")}, groups.size());
    if (added) {
      groups.emplace_back().row = {
          {"engine", run.at("engine")}, {"model", run.at("model")}, {"step", run.at("step")}};
    }
    add(groups[place->second], run.at("attribution"));
  }
  ordered_json rows = ordered_json::array();
  for (Group& group : groups) {
    rows.push_back(finished(group));
  }
  return rows;
}

Table attribution_table(const ordered_json& report) {
  Table table(
      {"engine", "model", "step", "cases", "deviation", "flight bias", "event lag", "late rate",
       "position correction", "threshold", "solver residual", "taut drift", "amplification"},
      2);
  for (const ordered_json& row : report.at("attribution_summary")) {
    if (row.at("shares").is_null()) {
      continue;
    }
    std::vector<std::string> cells = {
        report_text(row.at("engine")), report_text(row.at("model")),
        fmt::format("{:g}", row.at("step").get<double>()),
        std::to_string(row.at("cases").get<int>()),
        fmt::format("{:.1e}", row.at("deviation").at("median").get<double>())};
    for (const ordered_json& share : row.at("shares")) {
      cells.push_back(fmt::format("{:.0f}%", 100.0 * share.get<double>()));
    }
    table.add(std::move(cells));
  }
  return table;
}

const char* attribution_reading() {
  return "The exact motion is restarted from the run's own state at the start and the end of every "
         "flight, impact and stretch on taut cables, and what the run did wrong in between is "
         "carried by the exact motion to one instant. Those tried are up to the horizon, after "
         "impacts 1, 2, 4, 8 and 16 of the exact motion, and the end of a run with fewer; it is "
         "the last of them at which amplification is no more than a tenth, or, if there is none, "
         "the first at which it is no more than half. There the parts, each along the deviation, "
         "add up to it. Shares of the sum of their sizes, median over the cases. *Flight bias*: "
         "the "
         "integrator's path, for semi-implicit Euler g dt t / 2. *Event lag*: the impact before or "
         "after its instant. *Late rate*: restitution of a rate that is not the one at that "
         "instant. *Position correction*: overstretch pushed out, by velocity on top of the bounce "
         "or as a shift. *Threshold*: slow impacts that do not rebound, or none that do. *Solver "
         "residual*: what else the impulse did. *Taut drift*: motion on taut cables. "
         "*Amplification*: what the "
         "exact motion makes of all this beyond first order, or of rounding.\n";
}

}  // namespace tautline::bench
