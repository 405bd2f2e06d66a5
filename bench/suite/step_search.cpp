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
#include "bench/judge/judgement.hpp"
#include "bench/judge/states.hpp"
#include "bench/run/record.hpp"
#include "bench/run/worker.hpp"

namespace tautline::bench {
namespace {

constexpr double longest_step = 0.01;    // [s], that is tried of any model
constexpr double below_safe = 0.1;       // [-], of the safe step: the shortest
constexpr double shortest_step = 1e-6;   // [s]
constexpr double usual_step = 1e-3;      // [s], where no safe step is known
constexpr double rounding = 1.0 + 1e-9;  // 0.0001 from a product is 0.0001
/// An error above this part of the error of a step ten times as long does not fall [-].
constexpr double no_progress = 0.7;

/// The largest distance of `run` from the exact motion, of the shortest cable [-]; none of a run
/// that does not reach the end.
template <class TheReference, class TheTrajectory>
std::optional<double> error_of(const TheReference& reference,
                               const std::optional<TheTrajectory>& run, double until) {
  if (!run || run->diverged || !reaches(*run, until)) {
    return std::nullopt;
  }
  double worst = 0.0;
  for (const auto& point : run->points) {
    if (point.time <= until) {
      worst = std::max(worst, apart(point.state, reference.solution.at(point.time)));
    }
  }
  return worst / shortest_cable(reference.the_case);
}

/// The step from which on shorter ones must do better [s].
double expected_step(const StepNeeded& needed) { return needed.unlike ? usual_step : needed.safe; }

/// Tries the steps of one model.
template <class TheReference>
class ModelSearch {
 public:
  ModelSearch(const SuiteOptions& options, const TheReference& reference, const StepNeeded& needed,
              const PlannedRun& planned, Workplace& workplace)
      : options_(options),
        reference_(reference),
        needed_(needed),
        planned_(planned),
        workplace_(workplace),
        case_(reference.the_case) {
    case_.duration = std::min(case_.duration, needed.until);
    found_.engine = options.engines[planned.engine].name;
    found_.model = planned.model.name;
  }

  /// None if the program is interrupted.
  std::optional<StepFound> result() {
    const double expected = expected_step(needed_);
    const double least = std::max(shortest_step, below_safe * expected);
    std::map<int, double> by_decade;  // the error of the first step tried in each
    for (double step = std::max(longest_step, needed_.typical); step >= least / rounding;
         step = next_smaller(step)) {
      const std::optional<double> error = run(step);
      if (interruption()) {
        return std::nullopt;
      }
      if (!error) {
        if (gave_up_) {
          break;
        }
        continue;
      }
      if (*error <= needed_.part) {
        found_.step = step;
        found_.error = *error;
        break;
      }
      const int decade = static_cast<int>(std::floor(std::log10(step) + 1e-9));
      by_decade.try_emplace(decade, *error);
      const auto before = by_decade.find(decade + 1);
      const bool falls =
          before == by_decade.end() || by_decade.at(decade) <= no_progress * before->second;
      if (step <= expected && !falls) {  // longer ones may be as far off as the case has room
        break;
      }
    }
    if (!found_.step) {
      found_.why = in_vain();
    } else if (locates_ && !at_longest_) {  // a longer step did
      const double cost = found_.cost;
      run(longest_step);
      found_.cost = cost;
    }
    if (locates_) {
      found_.located = at_longest_;
    }
    return interruption() ? std::nullopt : std::optional(found_);
  }

 private:
  /// The error of a run with this step; none of one that does not come to the end.
  std::optional<double> run(double step) {
    const RegisteredEngine& engine = options_.engines[planned_.engine];
    const RunReply reply = run_in_worker(
        {engine.plugin, case_, planned_.model.name, {step, options_.law}, options_.limits},
        workplace_);
    const auto& trajectory = run_of(reply, case_);
    const std::optional<double> error = error_of(reference_, trajectory, needed_.until);
    first_ = std::max(first_, step);
    last_ = step;
    if (!error) {
      failure_ = reply.failure.empty() ? "its runs end early" : printable(reply.failure);
      // shorter steps take longer still, and what a model refuses at one step it does at all
      gave_up_ =
          reply.failure.starts_with("timed out") || reply.failure.starts_with("unsupported: ");
      return std::nullopt;
    }
    found_.measured = true;
    found_.cost = reply.cost.dt > 0.0 ? reply.cost.step / reply.cost.dt : 0.0;
    last_measured_ = step;
    last_error_ = *error;
    locates_ = locates(*trajectory);
    if (std::abs(step - longest_step) < 0.1 * longest_step) {
      at_longest_ = error;
    }
    return error;
  }

  [[nodiscard]] std::string in_vain() const {
    const std::string tried = first_ > last_ ? fmt::format("none of {:g} to {:g} s", first_, last_)
                                             : fmt::format("not {:g} s", last_);
    if (!found_.measured) {
      return fmt::format("{}: {}", tried, failure_);
    }
    const std::string off = fmt::format("{:.2g} % off", 100.0 * last_error_);
    return last_ < last_measured_ ? fmt::format("{}: {} at {:g} s, below that {}", tried, off,
                                                last_measured_, failure_)
                                  : fmt::format("{}: {} at the shortest", tried, off);
  }

  const SuiteOptions& options_;
  const TheReference& reference_;
  const StepNeeded& needed_;
  const PlannedRun& planned_;
  Workplace& workplace_;
  decltype(TheReference::the_case) case_;
  StepFound found_;
  double first_ = 0.0;                // [s], the longest step tried
  double last_ = 0.0;                 // [s]
  double last_measured_ = 0.0;        // [s]
  double last_error_ = 0.0;           // [-], with that step
  std::optional<double> at_longest_;  // [-], the error at 0.01 s
  bool locates_ = false;
  bool gave_up_ = false;
  std::string failure_;
};

/// What the plain scheme says, in a sentence.
template <class TheReference>
std::string foretold(const TheReference& reference, const StepNeeded& needed) {
  if (needed.unlike) {
    return fmt::format(
        "Which step a step-by-step model needs is not known: the plain scheme follows the law "
        "simultaneous, and the law {} resolves the impact at {:.3g} s in another way.",
        to_string(reference.law), *needed.unlike);
  }
  if (needed.longest) {
    return fmt::format("For a step-by-step model any step up to {:g} s does.", needed.safe);
  }
  if (const double least = shortest_needed_for<TheReference>; needed.safe < least / rounding) {
    return fmt::format("A step-by-step model needs steps below {:g} s.", least);
  }
  return fmt::format(
      "A step-by-step model needs steps of {:g} s{}.", needed.safe,
      needed.typical > needed.safe ? fmt::format("; {:g} s often do", needed.typical) : "");
}

}  // namespace

bool StepSearch::measured() const {
  return std::any_of(found.begin(), found.end(), [](const StepFound& one) { return one.measured; });
}

template <class TheReference>
StepSearch search_steps(const SuiteOptions& options, const TheReference& reference,
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
          results[index] = ModelSearch(one, reference, needed, models[index], workplace).result();
        }
      });
    }
  }
  StepSearch search;
  search.models = models.size();
  for (std::optional<StepFound>& result : results) {
    if (result) {
      search.found.push_back(std::move(*result));
    }
  }
  return search;
}

template <class TheReference>
std::string steps_text(const TheReference& reference, const StepNeeded& needed,
                       std::vector<StepFound> found) {
  std::stable_sort(found.begin(), found.end(), [](const StepFound& one, const StepFound& two) {
    return one.step.has_value() != two.step.has_value() ? one.step.has_value()
                                                        : one.step && one.cost < two.cost;
  });
  const double longest = std::max(longest_step, needed.typical);
  std::string out = fmt::format(
      "{}: {:g} % of the shortest cable is {:.3g} m, over the first {:.3g} s. {}\n",
      printable(reference.the_case.name), 100.0 * needed.part,
      needed.part * shortest_cable(reference.the_case), needed.until, foretold(reference, needed));
  if (found.empty()) {
    return out;
  }
  Table table({"engine", "model", "largest step [s]", "off [%]", "cost [ms/s]", ""}, 2, 1);
  for (const StepFound& one : found) {
    std::string note = one.why;
    if (one.located) {
      note += fmt::format("{}locates its impacts: {:.2g} % off at {:g} s", note.empty() ? "" : "; ",
                          100.0 * *one.located, longest_step);
    }
    table.add({printable(one.engine), printable(one.model),
               one.step ? fmt::format("{:g}", *one.step) : "none",
               one.step ? fmt::format("{:.2g}", 100.0 * one.error) : "",
               one.step ? fmt::format("{:.2g}", 1e3 * one.cost) : "", note});
  }
  return out + table.plain() + fmt::format("No step above {:g} s was tried.\n", longest);
}

template StepSearch search_steps(const SuiteOptions&, const ReferenceCase&, const StepNeeded&);
template StepSearch search_steps(const SuiteOptions&, const ReferenceSystem&, const StepNeeded&);
template std::string steps_text(const ReferenceCase&, const StepNeeded&, std::vector<StepFound>);
template std::string steps_text(const ReferenceSystem&, const StepNeeded&, std::vector<StepFound>);

}  // namespace tautline::bench
