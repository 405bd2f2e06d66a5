#include "bench/suite/step_search.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <map>
#include <thread>
#include <utility>

#include "bench/base/process.hpp"
#include "bench/base/table.hpp"
#include "bench/base/text.hpp"
#include "bench/run/record.hpp"
#include "bench/run/worker.hpp"

namespace tautline::bench {
namespace {

constexpr double longest_step = 0.01;   // [s], that is tried of any model
constexpr double below_safe = 0.1;      // [-], of the safe step: the shortest
constexpr double shortest_step = 1e-6;  // [s]
/// An error that is no smaller than this part of the error of a step ten times as long does not
/// fall
/// [-].
constexpr double no_progress = 0.7;

/// The largest distance of `run` from the exact motion, of the shortest cable [-]; none of a run
/// that does not reach the end.
std::optional<double> error_of(const ReferenceCase& reference, const RunReply& reply,
                               double until) {
  if (!reply.trajectory || reply.trajectory->diverged || !reaches(*reply.trajectory, until)) {
    return std::nullopt;
  }
  double worst = 0.0;
  for (const Point& point : reply.trajectory->points) {
    if (point.time <= until) {
      worst = std::max(worst,
                       (point.state.position - reference.solution.at(point.time).position).norm());
    }
  }
  return worst / shortest_cable(reference.the_case);
}

StepFound search(const SuiteOptions& options, const ReferenceCase& reference,
                 const StepNeeded& needed, const PlannedRun& planned, Workplace& workplace) {
  const RegisteredEngine& engine = options.engines[planned.engine];
  StepFound found;
  found.engine = engine.name;
  found.model = planned.model.name;
  Case the_case = reference.the_case;
  the_case.duration = std::min(the_case.duration, needed.until);
  const double least = std::max(shortest_step, below_safe * needed.safe);
  std::map<int, double> by_decade;  // the error of the first step tried in each
  for (double step = std::max(longest_step, needed.typical); step >= least && !interruption();
       step = next_smaller(step)) {
    const RunReply reply = run_in_worker(
        {engine.plugin, the_case, planned.model.name, {step, options.law}, options.limits},
        workplace);
    const std::optional<double> error = error_of(reference, reply, needed.until);
    if (!error) {
      found.why = reply.failure.empty() ? "its runs end early" : printable(reply.failure);
      continue;
    }
    if (*error <= needed.part) {
      found.step = step;
      found.error = *error;
      found.cost = reply.cost.dt > 0.0 ? reply.cost.step / reply.cost.dt : 0.0;
      return found;
    }
    found.why = fmt::format("no step does: {:.2g} % off at {:g} s", 100.0 * *error, step);
    const int decade = static_cast<int>(std::floor(std::log10(step) + 1e-9));
    by_decade.try_emplace(decade, *error);
    const auto before = by_decade.find(decade + 1);
    const bool falls =
        before == by_decade.end() || by_decade.at(decade) <= no_progress * before->second;
    if (step <= needed.safe && !falls) {  // longer ones may be as far off as the case has room
      break;
    }
  }
  return found;
}

}  // namespace

std::vector<StepFound> search_steps(const SuiteOptions& options, const ReferenceCase& reference,
                                    const StepNeeded& needed) {
  SuiteOptions one = options;
  one.cases = {reference.the_case};
  one.steps = {longest_step};
  const std::vector<PlannedRun> models = plan(one);
  std::vector<std::optional<StepFound>> results(models.size());
  std::atomic<std::size_t> next{0};
  {
    std::vector<std::jthread> workers;
    for (unsigned job = 0; job < options.jobs; ++job) {
      workers.emplace_back([&] {
        Workplace workplace;
        for (std::size_t index = next++; index < models.size() && !interruption(); index = next++) {
          results[index] = search(one, reference, needed, models[index], workplace);
        }
      });
    }
  }
  std::vector<StepFound> found;
  for (std::optional<StepFound>& result : results) {
    if (result) {
      found.push_back(std::move(*result));
    }
  }
  return found;
}

std::string steps_text(const ReferenceCase& reference, const StepNeeded& needed,
                       std::vector<StepFound> found) {
  std::stable_sort(found.begin(), found.end(), [](const StepFound& one, const StepFound& two) {
    return one.step.has_value() != two.step.has_value() ? one.step.has_value()
                                                        : one.step && one.cost < two.cost;
  });
  std::string out = fmt::format(
      "{}: for {:g} % of the shortest cable, {:.3g} m, over the first {:.3g} s a step-by-step "
      "model "
      "needs steps of {:g} s{}.\n",
      printable(reference.the_case.name), 100.0 * needed.part,
      needed.part * shortest_cable(reference.the_case), needed.until, needed.safe,
      needed.typical > needed.safe ? fmt::format("; {:g} s often do", needed.typical) : "");
  Table table({"engine", "model", "largest step [s]", "off [%]", "cost [ms/s]", ""}, 2, 1);
  for (const StepFound& one : found) {
    table.add({printable(one.engine), printable(one.model),
               one.step ? fmt::format("{:g}", *one.step) : "none",
               one.step ? fmt::format("{:.2g}", 100.0 * one.error) : "",
               one.step ? fmt::format("{:.2g}", 1e3 * one.cost) : "", one.step ? "" : one.why});
  }
  return out + table.plain();
}

}  // namespace tautline::bench
