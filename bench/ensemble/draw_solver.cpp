#include "bench/ensemble/draw_solver.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "bench/base/process.hpp"
#include "bench/base/text.hpp"
#include "bench/run/worker.hpp"
#include "tautline/settling.hpp"
#include "tautline/solve.hpp"
#include "tautline/solve_batch.hpp"

namespace tautline::bench {
namespace {

/// The fastest rebound that can have followed where bounces were completed [m/s], to leading order:
/// all that this has taken from the energy in one cable.
template <class TheCase>
double fastest_completed(const TheCase& the_case, const BasicSolution<TheCase>& solution) {
  double fastest = 0.0;
  for (const auto& completed : solution.accumulations()) {
    for (const std::size_t index : completed.cables) {
      const double response = most_response(the_case, the_case.cables[index]);
      fastest = std::max(fastest, std::sqrt(2.0 * std::max(0.0, completed.energy_lost) * response));
    }
  }
  return fastest;
}

/// Why the exact motion of a draw says nothing of impacts as slow as `slowest` [m/s], or empty.
template <class TheCase>
std::string exact_problem(const TheCase& the_case, const BasicSolution<TheCase>& solution,
                          double slowest) {
  if (const double completed = fastest_completed(the_case, solution); completed > slowest) {
    return fmt::format(
        "an accumulation was completed where bounces may have had {:.2g} m/s; completion must be "
        "smaller to count those of {} m/s",
        completed, shortest(slowest));
  }
  switch (solution.ending()) {
    case Ending::singular:
    case Ending::event_limit:
    case Ending::overflow:
      return "the exact motion ends early: " + std::string(to_string(solution.ending()));
    default:
      return "";
  }
}

/// Why there is no such case, or empty.
std::string case_problem(const AnyCase& the_case) {
  const std::vector<std::string> broken = problems(the_case);
  return broken.empty() ? "" : "no such case: " + broken.front();
}

/// The exact side of a draw, or why there is none. The horizon of a draw is not asked for.
std::pair<std::optional<ReferenceCase>, std::string> reference_of(const EnsembleSpec& spec,
                                                                  const EnsembleSetup& setup,
                                                                  std::size_t draw) {
  AnyCase drawn = case_of(spec, setup, draw);  // no system: it has no engine
  if (std::string problem = case_problem(drawn); !problem.empty()) {
    return {std::nullopt, std::move(problem)};
  }
  Case& the_case = std::get<Case>(drawn);
  const ImpactLaw law = setup.exact.law;
  Solution solution = solve(the_case, options_of(setup));
  if (std::string problem = exact_problem(the_case, solution, spec.speeds[1]); !problem.empty()) {
    return {std::nullopt, std::move(problem)};
  }
  Settling settled = settling(the_case, solution);
  return {ReferenceCase{std::move(the_case), std::move(solution), std::move(settled), 0.0, law},
          ""};
}

/// The exact motions of a chunk of draws, side by side.
class ExactSolver final : public DrawSolver {
 public:
  ExactSolver(const EnsembleRequest& request, const EnsembleSetup& setup)
      : request_(request), setup_(setup) {}

  std::vector<DrawResult> solve(std::size_t first, std::size_t end) override {
    std::vector<DrawResult> results;
    results.reserve(end - first);
    if (!interruption()) {  // which waits for a chunk, some hundredths of a second
      solve_all(first, end, results);
    }
    return results;
  }

 private:
  void solve_all(std::size_t first, std::size_t end, std::vector<DrawResult>& results) const {
    std::vector<Case> cases;
    std::vector<std::size_t> places;  // of their results
    for (std::size_t draw = first; draw < end; ++draw) {
      AnyCase the_case = case_of(request_.spec, setup_, draw);
      results.push_back({draw, case_problem(the_case), {}});
      if (results.back().problem.empty()) {
        cases.push_back(std::move(std::get<Case>(the_case)));
        places.push_back(results.size() - 1);
      }
    }
    SolveOptions options = options_of(setup_);
    options.until_locked = true;
    options.swing_ahead = true;
    solve_batch(cases, options, [&](std::size_t index, const Solution& solution) {
      const Case& the_case = cases[index];
      DrawResult& result = results[places[index]];
      result.problem = exact_problem(the_case, solution, request_.spec.speeds[1]);
      if (result.problem.empty()) {
        result.values =
            exact_statistics(request_.spec, the_case, solution, last_lock(the_case, solution));
      }
    });
  }

  const EnsembleRequest& request_;
  const EnsembleSetup& setup_;
};

/// The exact motions of draws of a system of D dimensions, one after another.
template <int D>
class SystemSolver final : public DrawSolver {
 public:
  SystemSolver(const EnsembleRequest& request, const EnsembleSetup& setup)
      : request_(request), setup_(setup) {}

  std::vector<DrawResult> solve(std::size_t first, std::size_t end) override {
    std::vector<DrawResult> results;
    for (std::size_t draw = first; draw < end && !interruption(); ++draw) {
      results.push_back({draw, "", {}});
      run(results.back());
    }
    return results;
  }

 private:
  void run(DrawResult& result) const {
    const AnyCase drawn = case_of(request_.spec, setup_, result.draw);
    result.problem = case_problem(drawn);
    if (!result.problem.empty()) {
      return;
    }
    const auto& system = std::get<BasicSystem<double, D>>(drawn);
    const auto solution = tautline::solve(system, options_of(setup_));
    result.problem = exact_problem(system, solution, request_.spec.speeds[1]);
    if (result.problem.empty()) {
      result.values = system_statistics(request_.spec, system, solution);
    }
  }

  const EnsembleRequest& request_;
  const EnsembleSetup& setup_;
};

class EngineSolver final : public DrawSolver {
 public:
  EngineSolver(const EnsembleRequest& request, const EnsembleSetup& setup)
      : request_(request), setup_(setup) {}

  std::vector<DrawResult> solve(std::size_t first, std::size_t end) override {
    std::vector<DrawResult> results;
    for (std::size_t draw = first; draw < end && !interruption(); ++draw) {
      if (auto result = run(draw, draw + 1 < end)) {
        results.push_back(std::move(*result));
      }
    }
    return results;
  }

 private:
  /// None if the program was interrupted. `more`: draws of the chunk follow. A plug-in begins each
  /// chunk in a new process: what it may keep from run to run is then the same in any number of
  /// threads.
  std::optional<DrawResult> run(std::size_t draw, bool more) {
    auto [reference, problem] = reference_of(request_.spec, setup_, draw);
    if (!reference) {
      return DrawResult{draw, std::move(problem), {}};
    }
    RunReply reply = run_in_worker({request_.engines[*setup_.engine].plugin,
                                    reference->the_case,
                                    setup_.model,
                                    {setup_.step, setup_.exact.law},
                                    request_.limits,
                                    false,
                                    more},
                                   workplace_);
    if (reply.interrupted) {
      return std::nullopt;
    }
    if (!reply.trajectory) {
      return DrawResult{draw, std::move(reply.failure), {}};
    }
    if (reply.trajectory->diverged) {
      return DrawResult{draw, "diverged", {}};
    }
    // a run that stopped, as some do where impacts accumulate, has its impacts up to there
    return DrawResult{draw, "", run_statistics(request_.spec, *reference, *reply.trajectory)};
  }

  const EnsembleRequest& request_;
  const EnsembleSetup& setup_;
  Workplace workplace_;
};

}  // namespace

std::unique_ptr<DrawSolver> draw_solver(const EnsembleRequest& request,
                                        const EnsembleSetup& setup) {
  if (setup.engine) {
    return std::make_unique<EngineSolver>(request, setup);
  }
  if (std::holds_alternative<System>(request.spec.the_case)) {
    return std::make_unique<SystemSolver<2>>(request, setup);
  }
  if (std::holds_alternative<SpatialSystem>(request.spec.the_case)) {
    return std::make_unique<SystemSolver<3>>(request, setup);
  }
  return std::make_unique<ExactSolver>(request, setup);
}

std::size_t chunk_size(const EnsembleSetup& setup) {
  return setup.engine ? 20 : 200;  // an engine takes some 0.1 s for a run, the solver some 0.3 ms
}

}  // namespace tautline::bench
