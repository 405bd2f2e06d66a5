#include "bench/suite/suite.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <atomic>
#include <cmath>
#include <exception>
#include <mutex>
#include <set>
#include <thread>

#include "bench/base/process.hpp"
#include "bench/base/text.hpp"
#include "bench/measure/horizon.hpp"
#include "bench/report/replay_data.hpp"
#include "bench/report/rows.hpp"
#include "bench/suite/run_files.hpp"
#include "tautline/solve.hpp"

namespace tautline::bench {
namespace {

/// One run: from the result tree if it is there, else in a worker, compared and written.
/// None if the program was interrupted.
std::optional<RunResult> do_run(const SuiteOptions& options, const ReferenceCase& reference,
                                const PlannedRun& run, std::atomic<std::size_t>& kept) {
  const RegisteredEngine& engine = options.engines[run.engine];
  const bool writes = !options.out.empty();
  const auto folder =
      run_folder(options.out, reference.the_case.name, engine.name, run.model.name, run.step);
  if (writes && options.resume) {
    if (auto earlier = read_run(folder, fingerprint(options, run));
        earlier && earlier->row.at("status") != "failed") {
      ++kept;
      return earlier;
    }
  }
  const RunReply reply = run_in_worker(
      {engine.plugin, reference.the_case, run.model.name, {run.step, options.law}, options.limits});
  if (reply.interrupted) {
    return std::nullopt;
  }
  RunResult result{run_row(reference, *engine.info, run, reply, options.compare),
                   timing_row(reference, *engine.info, run, reply)};
  if (writes) {
    write_run(folder, options, run, reply, result);
  }
  return result;
}

}  // namespace

std::vector<ReferenceCase> solve_cases(const std::vector<Case>& cases, ImpactLaw law) {
  std::vector<ReferenceCase> references;
  for (const Case& the_case : cases) {
    Solution solution = solve(the_case, {.law = law});
    const double horizon = predictability_horizon(the_case, solution, law);
    Settling settled = settling(the_case, solution);
    references.push_back({the_case, std::move(solution), std::move(settled), horizon, law});
  }
  return references;
}

std::vector<PlannedRun> plan(const SuiteOptions& options) {
  std::vector<PlannedRun> runs;
  for (std::size_t the_case = 0; the_case < options.cases.size(); ++the_case) {
    for (std::size_t engine = 0; engine < options.engines.size(); ++engine) {
      if (!options.engines[engine].info) {
        continue;
      }
      for (const Model& model : options.engines[engine].info->models) {
        const bool chosen = options.models.empty() ||
                            std::find(options.models.begin(), options.models.end(), model.name) !=
                                options.models.end();
        for (const double step : options.steps) {
          if (chosen) {
            runs.push_back({the_case, engine, model, step});
          }
        }
      }
    }
  }
  for (PlannedRun& run : runs) {
    run.path_samples = path_samples(runs.size());
  }
  return runs;
}

SuiteResult run_suite(const SuiteOptions& options, const std::vector<ReferenceCase>& references,
                      const std::function<void(std::size_t)>& progress) {
  const std::vector<PlannedRun> runs = plan(options);
  std::vector<std::optional<RunResult>> results(runs.size());
  std::atomic<std::size_t> next{0};
  std::atomic<std::size_t> kept{0};
  std::size_t ended = 0;
  std::exception_ptr failure;
  std::mutex guard;  // of `ended`, `failure` and `progress`
  const auto work = [&] {
    for (std::size_t index = next++; index < runs.size() && !interruption(); index = next++) {
      try {
        results[index] = do_run(options, references[runs[index].the_case], runs[index], kept);
      } catch (...) {
        const std::scoped_lock lock(guard);
        failure = std::current_exception();
        next = runs.size();
        return;
      }
      const std::scoped_lock lock(guard);
      progress(++ended);
    }
  };
  {
    std::vector<std::jthread> workers;
    for (unsigned job = 0; job < options.jobs; ++job) {
      workers.emplace_back(work);
    }
  }
  if (failure) {
    std::rethrow_exception(failure);
  }
  SuiteResult suite;
  suite.planned = runs.size();
  suite.kept = kept;
  suite.interrupted = interruption();
  for (std::optional<RunResult>& result : results) {
    if (result) {
      suite.runs.push_back(std::move(*result));
    }
  }
  return suite;
}

std::vector<std::string> suite_problems(const SuiteOptions& options) {
  std::vector<std::string> problems;
  for (const double step : options.steps) {
    if (!std::isfinite(step) || step <= 0.0) {
      problems.push_back(fmt::format("step {} must be a finite number above 0 [s]", step));
      continue;
    }
    for (const Case& the_case : options.cases) {
      if (the_case.duration / step > most_steps) {
        problems.push_back(fmt::format(
            "step {} needs {:.0e} steps for case {}, which lasts {} s; at most {:.0e} are allowed",
            step, the_case.duration / step, printable(the_case.name), the_case.duration,
            most_steps));
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
