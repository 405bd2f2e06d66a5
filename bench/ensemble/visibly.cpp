#include "bench/ensemble/visibly.hpp"

#include "bench/base/progress.hpp"

namespace tautline::bench {

EnsembleResult solve_visibly(const EnsembleRequest& request, const EnsembleOptions& options) {
  // an engine's run costs some hundred times an exact motion
  const auto work_of = [&](const EnsembleSetup& setup) { return setup.engine ? 100.0 : 1.0; };
  const std::size_t draws = draw_count(request.spec);
  double work = 0.0;
  for (const EnsembleSetup& setup : request.setups) {
    work += work_of(setup) * static_cast<double>(draws);
  }
  Progress progress(work, draws * request.setups.size(), "draws");
  progress.show_rate();
  EnsembleResult result = solve_ensemble(
      request, options, [&](const EnsembleSetup& setup, std::size_t ended, bool kept) {
        for (std::size_t draw = 0; draw < ended; ++draw) {
          progress.ended(work_of(setup), kept);
        }
      });
  progress.finish();
  return result;
}

}  // namespace tautline::bench
