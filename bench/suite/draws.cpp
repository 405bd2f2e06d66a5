#include "bench/suite/draws.hpp"

#include <algorithm>

#include "bench/ensemble/output/output.hpp"
#include "bench/ensemble/visibly.hpp"
#include "bench/report/columns.hpp"
#include "bench/store/run_files.hpp"

namespace tautline::bench {
namespace {

/// Of each number of the start, about the case's own: [m], [rad], [m/s] or [rad/s].
constexpr double start_deviation = 1e-3;

/// In the result tree.
constexpr const char* folder = "ensemble";

/// The finest of `steps` at which every model can be afforded hundreds of runs, or the coarsest.
double step_of_draws(const std::vector<double>& steps) {
  constexpr double finest = 1e-3;  // [s]
  double step = *std::max_element(steps.begin(), steps.end());
  for (const double one : steps) {
    step = one >= finest ? std::min(step, one) : step;
  }
  return step;
}

EnsembleRequest request_of(const SuiteOptions& options) {
  EnsembleRequest request;
  EnsembleSpec& spec = request.spec;
  spec.the_case = std::get<Case>(
      *std::find_if(options.cases.begin(), options.cases.end(),
                    [](const BenchCase& one) { return name_of(one) == drawn_case; }));
  spec.count = options.draws;
  spec.law = options.law;
  for (const char* quantity : {"x", "y", "angle", "velocity_x", "velocity_y", "spin"}) {
    spec.varied.push_back({quantity, {Distribution::Kind::normal, {start_deviation}}});
  }
  spec.models = options.models;
  spec.steps = {step_of_draws(options.steps)};
  for (const RegisteredEngine& engine : options.engines) {
    if (engine.info && engine.name != control) {
      spec.engines.push_back(engine.name);
      request.engines.push_back(engine);
    }
  }
  request.setups = setups_of(spec, request.engines);
  request.limits = options.limits;
  return request;
}

/// What is said of the setup at `place`.
DistributionsRow row_of(const EnsembleRequest& request, const Findings& findings,
                        std::size_t place) {
  const EnsembleSetup& setup = request.setups[place];
  DistributionsRow row{
      {request.engines[*setup.engine].name, setup.model, setup.step}, findings.problems[place], {}};
  for (const Comparison& one : findings.comparisons) {
    if (one.setup == place) {
      row.statistics.push_back(
          {findings.statistics[one.statistic].name,
           findings.summaries[place][one.statistic].quantiles[median_place].value,
           one.kolmogorov.effect, one.probability(), one.visible, one.differs()});
    }
  }
  return row;
}

Distributions distributions_of(const EnsembleRequest& request, const Findings& findings) {
  Distributions result;
  result.the_case = name_of(request.spec.the_case);
  result.draws = request.spec.count;
  result.deviation = start_deviation;
  result.page = std::string(folder) + "/index.html";
  for (std::size_t place = 0; place < findings.statistics.size(); ++place) {
    const Statistic& statistic = findings.statistics[place];
    const bool compared =
        std::any_of(findings.comparisons.begin(), findings.comparisons.end(),
                    [&](const Comparison& one) { return one.statistic == place; });
    if (compared) {
      result.statistics.push_back({statistic.name, statistic.heading, statistic.unit,
                                   findings.summaries[0][place].quantiles[median_place].value});
    }
  }
  for (std::size_t place = 1; place < request.setups.size(); ++place) {
    result.setups.push_back(row_of(request, findings, place));
  }
  return result;
}

}  // namespace

std::vector<std::uint64_t> programs_of(const EnsembleRequest& request) {
  SuiteOptions engines;
  engines.engines = request.engines;
  std::vector<std::uint64_t> hashes;
  for (const EnsembleSetup& setup : request.setups) {
    const std::uint64_t plugin = setup.engine ? plugin_hash(engines, *setup.engine) : 0;
    hashes.push_back(program_hash() ^ plugin);
  }
  return hashes;
}

std::optional<Distributions> compare_draws(const SuiteOptions& options) {
  const EnsembleRequest request = request_of(options);
  if (request.setups.size() == 1) {  // the exact motion alone
    return std::nullopt;
  }
  const EnsembleOptions how = {options.out / folder, options.jobs, options.resume,
                               programs_of(request)};
  const EnsembleResult result = solve_visibly(request, how);
  if (result.interrupted) {
    return std::nullopt;
  }
  const Findings findings = findings_of(request, result, options.jobs);
  write_ensemble(how.out, {request, result, findings});
  return distributions_of(request, findings);
}

}  // namespace tautline::bench
