// What changed between two reports, for a terminal: what is broken first.

#include <fmt/format.h>

#include <algorithm>

#include "bench/base/table.hpp"
#include "bench/gate/changes.hpp"
#include "bench/report/tables.hpp"

namespace tautline::bench {
namespace {

using nlohmann::ordered_json;

/// Rows of one kind that anyone reads; the JSON has them all.
constexpr std::size_t most_rows = 100;

std::string step_text(const ordered_json& row) {
  return fmt::format("{:g}", row.at("step").get<double>());
}

std::string value_text(const ordered_json& value) {
  return value.is_number() ? fmt::format("{:.3g}", value.get<double>())
         : value.is_null() ? "not measured"
                           : report_text(value);
}

std::string factor_text(const ordered_json& row) {
  const ordered_json& one = row.at("before");
  const ordered_json& two = row.at("after");
  const bool both = one.is_number() && two.is_number() && one.get<double>() > 0.0;
  return both ? fmt::format("{:.3g}", two.get<double>() / one.get<double>()) : "–";
}

/// One section of rows; "" without any.
template <class Cells>
std::string section(const std::string& title, const ordered_json& rows,
                    const std::vector<std::string>& headings, std::size_t left, std::size_t words,
                    const Cells& cells) {
  if (rows.empty()) {
    return "";
  }
  Table table(headings, left, words);
  for (std::size_t index = 0; index < std::min(most_rows, rows.size()); ++index) {
    table.add(cells(rows[index]));
  }
  const std::string rest =
      rows.size() > most_rows ? fmt::format("and {} more\n", rows.size() - most_rows) : "";
  return fmt::format("{} ({}):\n{}{}\n", title, rows.size(), table.plain(), rest);
}

std::vector<std::string> who(const ordered_json& row) {
  return {report_text(row.at("engine")), report_text(row.at("model")), report_text(row.at("case")),
          step_text(row)};
}

std::vector<std::string> joined_cells(std::vector<std::string> cells,
                                      std::initializer_list<std::string> more) {
  cells.insert(cells.end(), more);
  return cells;
}

std::string statuses(const std::string& title, const ordered_json& rows) {
  return section(title, rows, {"engine", "model", "case", "step", "before", "after", "reason"}, 3,
                 3, [](const ordered_json& row) {
                   return joined_cells(who(row),
                                       {report_text(row.at("before")), report_text(row.at("after")),
                                        report_text(row.at("reason"))});
                 });
}

std::string metrics(const std::string& title, const ordered_json& rows) {
  return section(title, rows,
                 {"engine", "model", "case", "step", "metric", "before", "after", "factor", "unit"},
                 3, 1, [](const ordered_json& row) {
                   return joined_cells(
                       who(row),
                       {report_text(row.at("metric")), value_text(row.at("before")),
                        value_text(row.at("after")), factor_text(row),
                        row.at("unit") == "1" ? std::string("-") : report_text(row.at("unit"))});
                 });
}

std::string runs(const std::string& title, const ordered_json& rows) {
  return section(title, rows, {"engine", "model", "case", "step"}, 3, 0, who);
}

}  // namespace

std::string comparison_text(const ordered_json& changes) {
  std::string out;
  out += section("Versions that differ", changes.at("versions"), {"what", "before", "after"}, 3, 0,
                 [](const ordered_json& row) {
                   const auto text = [](const ordered_json& value) {
                     return value.is_null() ? std::string("not there") : report_text(value);
                   };
                   return std::vector<std::string>{report_text(row.at("what")),
                                                   text(row.at("before")), text(row.at("after"))};
                 });
  out += statuses("New failures", changes.at("new_failures"));
  out += metrics("Worse", changes.at("got_worse"));
  out += runs("Runs that are gone", changes.at("only_before"));
  out += statuses("Failures that are gone", changes.at("recovered"));
  out += metrics("Better", changes.at("got_better"));
  out += runs("New runs", changes.at("only_after"));
  out += runs("Not compared, the case is not the same", changes.at("other_case"));
  out += section("Costs of a step, which are noisy and judge nothing", changes.at("costs"),
                 {"engine", "model", "step", "cases", "factor"}, 2, 0, [](const ordered_json& row) {
                   return std::vector<std::string>{
                       report_text(row.at("engine")), report_text(row.at("model")), step_text(row),
                       std::to_string(row.at("cases").get<int>()),
                       fmt::format("{:.2f}", row.at("factor").get<double>())};
                 });
  const std::size_t bad = changes.at("new_failures").size() + changes.at("got_worse").size() +
                          changes.at("only_before").size();
  const std::size_t good = changes.at("recovered").size() + changes.at("got_better").size();
  return out + fmt::format("{} runs compared: {}.\n", changes.at("compared").get<std::size_t>(),
                           bad + good == 0 ? "nothing changed beyond noise"
                                           : fmt::format("{} changes for the worse, {} for the "
                                                         "better",
                                                         bad, good));
}

}  // namespace tautline::bench
