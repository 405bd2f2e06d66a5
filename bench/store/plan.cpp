#include "bench/store/plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "bench/base/text.hpp"
#include "bench/run/record.hpp"
#include "bench/store/tree.hpp"
#include "tautline/model_table.hpp"

namespace tautline::bench {

RunKey key_of(const SuiteOptions& options, const PlannedRun& run) {
  return {name_of(options.cases[run.the_case]), options.engines[run.engine].info->name,
          run.model.name, run.step};
}

bool runs(const Model& model, const BenchCase& any) {
  return (model.in_space || std::holds_alternative<Case>(any)) &&
         std::visit([&](const auto& one) { return has_cables_of(model, one); }, any);
}

std::vector<PlannedRun> plan(const SuiteOptions& options) {
  std::vector<PlannedRun> planned;
  for (std::size_t the_case = 0; the_case < options.cases.size(); ++the_case) {
    for (std::size_t engine = 0; engine < options.engines.size(); ++engine) {
      if (!options.engines[engine].info) {
        continue;
      }
      for (const Model& model : options.engines[engine].info->models) {
        const bool named = std::find(options.models.begin(), options.models.end(), model.name) !=
                           options.models.end();
        const bool chosen =
            named || (options.models.empty() && runs(model, options.cases[the_case]));
        for (const double step : options.steps) {
          if (chosen) {
            planned.push_back({the_case, engine, model, step});
          }
        }
      }
    }
  }
  return planned;
}

std::vector<std::string> suite_problems(const SuiteOptions& options) {
  std::vector<std::string> problems;
  for (const double step : options.steps) {
    if (!std::isfinite(step) || step <= 0.0) {
      problems.push_back(fmt::format("step {} must be a finite number above 0 [s]", step));
      continue;
    }
    for (const BenchCase& the_case : options.cases) {
      const double duration = duration_of(the_case);
      if (duration / step > most_steps) {
        problems.push_back(fmt::format(
            "step {} needs {:.0e} steps for case {}, which lasts {} s; at most {:.0e} are allowed",
            step, duration / step, printable(name_of(the_case)), duration, most_steps));
        break;
      }
    }
  }
  if (std::set<double>(options.steps.begin(), options.steps.end()).size() != options.steps.size()) {
    problems.emplace_back("a step is given twice");
  }
  if (!(options.limits.time > 0.0)) {
    problems.push_back(fmt::format("--time-limit {}: must be above 0 [s]", options.limits.time));
  }
  if (options.jobs < 1 || options.jobs > most_jobs) {
    problems.push_back(fmt::format("--jobs {}: must be 1 to {}", options.jobs, most_jobs));
  }
  if (options.steps.empty()) {
    problems.emplace_back("no step is given");
  }
  if (!options.out.empty()) {
    if (auto problem = tree_problem(options.out)) {
      problems.push_back(std::move(*problem));
    }
  }
  return problems;
}

}  // namespace tautline::bench
