#pragma once

#include "bench/ensemble/ensemble.hpp"

namespace tautline::bench {

/// `solve_ensemble`, and how far it is on a terminal.
[[nodiscard]] EnsembleResult solve_visibly(const EnsembleRequest& request,
                                           const EnsembleOptions& options);

}  // namespace tautline::bench
