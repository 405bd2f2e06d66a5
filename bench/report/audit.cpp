// The restitution audit as it is read: the findings as sentences, and how far e is off by model.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

#include "bench/base/text.hpp"
#include "bench/report/tables.hpp"

namespace tautline::bench {
namespace {

using nlohmann::ordered_json;

/// The scatter of many runs taken together.
struct Pool {
  double count = 0.0;
  double sum = 0.0;
  double squares = 0.0;
  double smallest = std::numeric_limits<double>::infinity();
  double largest = -std::numeric_limits<double>::infinity();

  void add(const ordered_json& scatter) {
    const double n = scatter.at("count");
    const double mean = scatter.at("mean");
    const double deviation = scatter.at("standard_deviation");
    count += n;
    sum += n * mean;
    squares += n * (mean * mean + deviation * deviation);
    smallest = std::min(smallest, scatter.at("smallest").get<double>());
    largest = std::max(largest, scatter.at("largest").get<double>());
  }
};

/// "1 run", "2 runs".
std::string counted(std::size_t count, const char* what) {
  return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

/// "3 runs, 1 impact"; no impacts where a finding is not drawn from any.
std::string evidence_text(const ordered_json& evidence) {
  const std::size_t impacts = evidence.at("impacts");
  return counted(evidence.at("runs"), "run") +
         (impacts > 0 ? ", " + counted(impacts, "impact") : "");
}

}  // namespace

Table scatter_table(const ordered_json& report) {
  using Key = std::tuple<std::string, std::string, double>;  // engine, model, step
  std::vector<std::pair<Key, Pool>> pools;
  std::map<Key, std::size_t> places;
  for (const ordered_json& run : report.at("runs")) {
    if (run.at("audit").is_null() || run.at("audit").at("scatter").is_null()) {
      continue;
    }
    const Key key = {report_text(run.at("engine")), report_text(run.at("model")), run.at("step")};
    const auto [place, is_new] = places.emplace(key, pools.size());
    if (is_new) {
      pools.emplace_back(key, Pool{});
    }
    pools[place->second].second.add(run.at("audit").at("scatter"));
  }
  Table table({"engine", "model", "step", "impacts", "e off by: mean", "standard deviation",
               "smallest", "largest"},
              2);
  for (const auto& [key, pool] : pools) {
    const double mean = pool.sum / pool.count;
    const double variance = std::max(0.0, pool.squares / pool.count - mean * mean);
    table.add({std::get<0>(key), std::get<1>(key), fmt::format("{:g}", std::get<2>(key)),
               fmt::format("{:.0f}", pool.count), fmt::format("{:+.4f}", mean),
               fmt::format("{:.4f}", std::sqrt(variance)), fmt::format("{:+.4f}", pool.smallest),
               fmt::format("{:+.4f}", pool.largest)});
  }
  return table;
}

std::string findings_list(const ordered_json& report) {
  constexpr std::size_t longest = 1000;  // bytes of a sentence
  std::string out;
  for (const ordered_json& finding : report.at("findings")) {
    out += fmt::format("- **{} {}**: {} ({}).\n", markdown_text(report_text(finding.at("engine"))),
                       markdown_text(report_text(finding.at("model"))),
                       markdown_text(printable(finding.at("sentence").get<std::string>(), longest)),
                       evidence_text(finding.at("evidence")));
  }
  return out.empty() ? "No model was found to do anything else to an impact than its cable asks "
                       "for.\n"
                     : out;
}

}  // namespace tautline::bench
