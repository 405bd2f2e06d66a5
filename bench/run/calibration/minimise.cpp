// NLopt's: the whole box is divided where it looks best (DIRECT), a point is refined by simplices
// of few coordinates each (Subplex). Neither needs a derivative or a random number.

#include "bench/run/calibration/minimise.hpp"

#include <stdexcept>

#ifdef TAUTLINE_NLOPT
#include <nlopt.hpp>
#endif

namespace tautline::bench {

#ifdef TAUTLINE_NLOPT

namespace {

/// Where refinement first looks around itself, as a part of the box [-].
constexpr double first_stride = 0.05;

using Objective = std::function<std::optional<double>(const std::vector<double>&)>;

/// The objective and who asks it.
struct Question {
  nlopt::opt& optimiser;
  const Objective& objective;
};

double value_at(const std::vector<double>& point, std::vector<double>& /*gradient*/, void* data) {
  const auto& question = *static_cast<Question*>(data);
  const std::optional<double> value = question.objective(point);
  if (!value) {
    question.optimiser.force_stop();
  }
  return value.value_or(0.0);
}

}  // namespace

void minimise(Pass pass, std::vector<double> start, int evaluations, double good_enough,
              const Objective& objective) {
  nlopt::opt optimiser(pass == Pass::whole_box ? nlopt::GN_DIRECT_L : nlopt::LN_SBPLX,
                       static_cast<unsigned>(start.size()));
  Question question{optimiser, objective};
  optimiser.set_lower_bounds(0.0);
  optimiser.set_upper_bounds(1.0);
  optimiser.set_initial_step(first_stride);
  optimiser.set_maxeval(evaluations);
  optimiser.set_stopval(good_enough);
  optimiser.set_min_objective(value_at, &question);
  double value = 0.0;
  try {
    optimiser.optimize(start, value);
  } catch (const nlopt::forced_stop&) {       // the objective was none
  } catch (const nlopt::roundoff_limited&) {  // as good as it gets
  }
}

#else

void minimise(
    Pass /*pass*/, std::vector<double> /*start*/, int /*evaluations*/, double /*good_enough*/,
    const std::function<std::optional<double>(const std::vector<double>&)>& /*objective*/) {
  throw std::runtime_error("this program was built without NLopt (Debian: libnlopt-cxx-dev)");
}

#endif

}  // namespace tautline::bench
