#include "bench/report/tables/tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "bench/base/listed.hpp"
#include "bench/base/text.hpp"
#include "bench/report/tables/columns.hpp"
#include "bench/report/words.hpp"

namespace tautline::bench {
namespace {

constexpr Digits as_distance = fixed(2);

/// The statistic that says when a motion has settled: the first of all.
constexpr std::size_t settling = 0;

std::vector<Column> columns_of(const Distributions& distributions) {
  std::vector<Column> columns = setup_columns();
  columns.push_back(word_column("verdict", "verdict"));
  columns.push_back(number_column("differ", "", "", "differ"));
  int rank = 0;  // the last ones go first
  for (const Distributions::Statistic& statistic : distributions.statistics) {
    columns.push_back(number_column(statistic.heading, "", "D", "distance-" + statistic.name,
                                    "D " + in_words(statistic.name), rank++));
  }
  const std::string& unit = distributions.statistics.at(settling).unit;
  columns.push_back(number_column("settled, median", unit, "", "settled", "settled", 1));
  columns.push_back(number_column("failed draws", "", "", "failed-draws", "failed", of_a_page));
  return columns;
}

const DistributionRow* find(const DistributionsRow& row, const std::string& name) {
  return find_by(row.statistics, &DistributionRow::statistic, name);
}

Cell distance_cell(const DistributionRow* row) {
  if (row == nullptr) {
    return dash;
  }
  Cell cell = number_cell(row->distance, as_distance);
  if (!row->differs) {
    cell.text = "(" + cell.text + ")";
  }
  return cell;
}

/// "differs", "not told apart", or that there is too little to say.
Cell verdict_cell(const DistributionsRow& row, std::size_t differing) {
  if (row.statistics.empty()) {
    return "too few draws";
  }
  Cell cell = differing > 0 ? "differs" : "not told apart";
  cell.kind = differing > 0 ? "verdict differs" : "verdict pass";
  cell.colour = differing > 0 ? Colour::red : Colour::green;
  return cell;
}

Row row_of(const Distributions& distributions, const DistributionsRow& of) {
  Row row = {setup_cells(of.key), "", ""};
  const auto differing = static_cast<std::size_t>(
      std::count_if(of.statistics.begin(), of.statistics.end(),
                    [](const DistributionRow& one) { return one.differs; }));
  row.cells.push_back(verdict_cell(of, differing));
  Cell share = count_cell(differing);
  share.text += fmt::format(" of {}", of.statistics.size());
  row.cells.push_back(std::move(share));
  for (const Distributions::Statistic& statistic : distributions.statistics) {
    row.cells.push_back(distance_cell(find(of, statistic.name)));
  }
  const DistributionRow* settled = find(of, distributions.statistics.at(settling).name);
  row.cells.push_back(number_cell(settled != nullptr ? settled->median : std::nullopt, fixed(3)));
  row.cells.push_back(count_cell(of.failed));
  return row;
}

/// The largest of the smallest distances that would have been called a difference.
double visible_in(const Distributions& distributions) {
  double visible = 0.0;
  for (const DistributionsRow& row : distributions.setups) {
    for (const DistributionRow& one : row.statistics) {
      visible = std::max(visible, one.visible);
    }
  }
  return visible;
}

}  // namespace

Table distributions_table(const Report& report) {
  if (!report.distributions || report.distributions->statistics.empty()) {
    return Table({});
  }
  Table table(columns_of(*report.distributions));
  for (const DistributionsRow& row : report.distributions->setups) {
    table.add(row_of(*report.distributions, row));
  }
  return table;
}

std::string distributions_paragraph(const Report& report) {
  if (!report.distributions) {
    return "";
  }
  const Distributions& of = *report.distributions;
  std::string settled;
  if (!of.statistics.empty() && of.statistics.at(settling).median) {
    const Distributions::Statistic& statistic = of.statistics.at(settling);
    settled = fmt::format(" The exact motion settles ({}) at {:.3f} {} in the median.",
                          statistic.heading, *statistic.median, statistic.unit);
  }
  return fmt::format(
      "{} draws of {}, every number of the start normal about the case's own with a standard "
      "deviation of {:g}.{} Every D above {:.2f} would have been called a difference.",
      of.draws, printable(of.the_case), of.deviation, settled, visible_in(of));
}

}  // namespace tautline::bench
