#include "bench/report/summary.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <numeric>
#include <utility>

#include "bench/base/listed.hpp"
#include "bench/base/statistics.hpp"

namespace tautline::bench {
namespace {

/// An error this small is rounding: it does not shrink with the step [m].
constexpr double rounding_error = 1e-9;

template <class Row>
using Group = std::vector<const Row*>;

/// The rows that have one key, in the order of their first.
template <class Row, class KeyOf>
std::vector<Group<Row>> grouped(const std::vector<Row>& rows, const KeyOf& key_of) {
  std::vector<Group<Row>> groups;
  std::map<std::decay_t<decltype(key_of(rows.front()))>, std::size_t> places;
  for (const Row& row : rows) {
    const auto [place, added] = places.try_emplace(key_of(row), groups.size());
    if (added) {
      groups.emplace_back();
    }
    groups[place->second].push_back(&row);
  }
  return groups;
}

const auto setup = [](const auto& row) { return setup_of(row.key); };

double largest(const std::vector<double>& values) {
  return *std::max_element(values.begin(), values.end());
}

double mean(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

std::optional<MedianAndWorst> median_and_worst(const std::vector<double>& values) {
  return values.empty() ? std::nullopt
                        : std::optional(MedianAndWorst{median(values), largest(values)});
}

/// One metric over the runs: a typical one of those that did their work, as one that gave up at
/// once has no error to speak of; an extreme one of all that have it.
std::optional<MedianAndWorst> aggregated(const Group<RunRow>& runs, std::size_t place) {
  const Aggregate aggregate = metric_list()[place].aggregate;
  if (aggregate == Aggregate::none) {
    return std::nullopt;
  }
  std::vector<double> values;
  for (const RunRow* run : runs) {
    const std::optional<double> value = run->metric(place);
    if (value && (aggregate == Aggregate::extreme || did_its_work(run->status))) {
      values.push_back(*value);
    }
  }
  std::optional<MedianAndWorst> result = median_and_worst(values);
  if (result && aggregate == Aggregate::extreme) {
    result->median.reset();
  }
  return result;
}

/// What is counted over runs: impacts up to the horizon, and last impacts.
void count(const RunDetails& details, SummaryRow& row) {
  const RunDetails::OfWindow& horizon = details.in(Window::horizon);
  row.exact += horizon.exact;
  row.found += horizon.found;
  row.matched += horizon.matched;
  if (!details.last_impacts.empty()) {
    row.exact_settled += details.last_impacts.front().exact ? 1U : 0U;
    row.found_settled += details.last_impacts.front().found ? 1U : 0U;
  }
}

SummaryRow summary_of(const Group<RunRow>& runs) {
  SummaryRow row;
  row.key = setup_of(runs.front()->key);
  row.cases = runs.size();
  for (const RunRow* run : runs) {
    row.failed += did_its_work(run->status) ? 0U : 1U;
    if (run->details) {
      count(*run->details, row);
    }
  }
  for (std::size_t place = 0; place < metric_list().size(); ++place) {
    row.metrics.push_back(aggregated(runs, place));
  }
  return row;
}

/// The early position error of a run.
struct ErrorPoint {
  double step;   // [s]
  double error;  // [m]
  double bound;  // [m], what rounding alone may add up to
};

/// What rounding may add up to in `run` [m]: half of the last place of the largest coordinate in
/// each step of the window, all in one direction. `extent` of its case [m].
double rounding_bound(const RunRow& run, double extent, bool single) {
  constexpr double half_place_of_a_float = 6e-8;  // [-]: 2^-24
  const double steps = run.details ? run.details->of_windows.front().until / run.key.step : 0.0;
  return single ? std::max(rounding_error, half_place_of_a_float * extent * steps) : rounding_error;
}

/// Leaves out of a curve over falling steps the finest ones whose errors are rounding: below their
/// bound, and not smaller by a quarter for a decade of the step. The coarsest one has nothing
/// before it: its error is rounding if that at the next step is.
void drop_rounding(std::vector<ErrorPoint>& curve) {
  const auto falls = [](const ErrorPoint& from, const ErrorPoint& to) {
    constexpr double least_fall = 0.75;  // [-], of the error for a decade of the step
    return to.error <= std::pow(least_fall, std::log10(from.step / to.step)) * from.error;
  };
  const std::size_t all = curve.size();
  const auto is_rounding = [&](std::size_t place) {
    const ErrorPoint& one = curve[place];
    if (one.error > one.bound) {
      return false;
    }
    return one.error <= rounding_error ||
           (place == 0 ? curve.size() < all && all > 1 : !falls(curve[place - 1], one));
  };
  while (!curve.empty() && is_rounding(curve.size() - 1)) {
    curve.pop_back();
  }
}

/// The curve of each case, where its error could be measured.
std::map<std::string, std::vector<ErrorPoint>> curves(const Group<RunRow>& runs,
                                                      const Report& report) {
  const auto engine =
      std::find_if(report.engines.begin(), report.engines.end(),
                   [&](const EngineRow& one) { return one.name == runs.front()->key.engine; });
  const bool single =
      engine != report.engines.end() && engine->info && engine->info->precision == "float32";
  const std::size_t early = place_of("early_position_error").value();
  std::map<std::string, std::vector<ErrorPoint>> result;
  for (const RunRow* run : runs) {
    if (const std::optional<double> error = run->metric(early)) {
      const auto of =
          std::find_if(report.cases.begin(), report.cases.end(),
                       [&](const CaseRow& one) { return one.name == run->key.the_case; });
      const double extent = of == report.cases.end() ? 0.0 : of->extent;
      result[run->key.the_case].push_back(
          {run->key.step, *error, rounding_bound(*run, extent, single)});
    }
  }
  for (auto& [name, curve] : result) {
    std::sort(curve.begin(), curve.end(),
              [](const ErrorPoint& a, const ErrorPoint& b) { return a.step > b.step; });
  }
  return result;
}

ConvergenceRow convergence_of(const Group<RunRow>& runs, const Report& report) {
  ConvergenceRow row;
  row.engine = runs.front()->key.engine;
  row.model = runs.front()->key.model;
  std::vector<double> slopes;
  for (auto& [name, curve] : curves(runs, report)) {
    drop_rounding(curve);
    if (curve.empty()) {
      ++row.cases_at_rounding;
    } else if (curve.size() >= 2) {
      slopes.push_back(slope(listed<double>(curve, &ErrorPoint::step),
                             listed<double>(curve, &ErrorPoint::error)));
    }
  }
  row.cases = slopes.size();
  if (!slopes.empty()) {
    row.slope = {*std::min_element(slopes.begin(), slopes.end()), median(slopes), largest(slopes)};
  }
  return row;
}

CausesRow causes_row(const Group<RunRow>& runs) {
  CausesRow row;
  row.key = setup_of(runs.front()->key);
  std::vector<double> deviations;
  std::array<std::vector<double>, causes.size()> shares;
  std::vector<double> covered;
  std::vector<double> model_shares;
  double remainder = 0.0;
  for (const RunRow* run : runs) {
    if (!run->attribution || !run->attribution->parts) {
      continue;
    }
    const Attribution& found = *run->attribution;
    double all = 0.0;
    for (const double part : *found.parts) {
      all += std::abs(part);
    }
    // of a run without any error there is nothing to share out
    for (std::size_t cause = 0; all > 0.0 && cause < causes.size(); ++cause) {
      shares[cause].push_back(std::abs((*found.parts)[cause]) / all);
    }
    if (found.soft) {
      const double model = std::abs(found.soft->model);
      model_shares.push_back(model / (model + std::abs(found.soft->step)));
    }
    deviations.push_back(found.deviation);
    covered.push_back(found.covered);
    if (found.deviation > 0.0) {
      remainder = std::max(remainder, std::abs(found.remainder) / found.deviation);
    }
  }
  row.cases = deviations.size();
  row.deviation = median_and_worst(deviations);
  if (row.deviation) {
    if (!shares.front().empty()) {
      row.shares.emplace();
      std::transform(shares.begin(), shares.end(), row.shares->begin(), mean);
    }
    row.covered = median(covered);
    row.remainder = remainder;
    if (!model_shares.empty()) {
      row.model_share = mean(model_shares);
    }
  }
  return row;
}

CostRow cost_row(const Group<TimingRow>& timing) {
  const auto values = [&](double TimingRow::*number) {
    return listed(timing, [&](const TimingRow* row) { return row->*number; });
  };
  const std::vector<double> seconds = values(&TimingRow::second_cost);
  return {setup_of(timing.front()->key),
          median(values(&TimingRow::cost_ratio)),
          median(seconds),
          {quantile(seconds, 0.0), quantile(seconds, 0.25), quantile(seconds, 0.75)},
          timing.size()};
}

/// `row_of` every group.
template <class Row, class KeyOf, class RowOf>
auto rows(const std::vector<Row>& all, const KeyOf& key_of, const RowOf& row_of) {
  return listed(grouped(all, key_of), row_of);
}

}  // namespace

std::vector<SummaryRow> summary(const std::vector<RunRow>& runs) {
  return rows(runs, setup, summary_of);
}

std::vector<ConvergenceRow> convergence(const Report& report) {
  const auto model = [](const RunRow& run) { return std::pair(run.key.engine, run.key.model); };
  return rows(report.runs, model,
              [&](const Group<RunRow>& runs) { return convergence_of(runs, report); });
}

std::vector<CausesRow> causes_of(const std::vector<RunRow>& runs) {
  return rows(runs, setup, causes_row);
}

std::vector<CostRow> costs(const std::vector<TimingRow>& timing) {
  return rows(timing, setup, cost_row);
}

}  // namespace tautline::bench
