// Boost.Odeint has no events of its own. Its example `find_crossing` has a controlled
// Dormand-Prince method with dense output take steps until the sign of a function has changed, and
// then halves on the dense output; here TOMS 748 of Boost.Math takes the place of halving.

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/dense_output_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>
#include <boost/version.hpp>
#include <limits>

#include "flight_events.hpp"

namespace tautline::peers {
namespace {

namespace odeint = boost::numeric::odeint;
using Method = odeint::runge_kutta_dopri5<Numbers>;
using Stepper = odeint::result_of::make_dense_output<Method>::type;

constexpr double first_step = 1e-3;  // [s], tried at the start of a flight

/// A flight that starts at zero gap may end in the step it starts in: so often that step is halved
/// to find a positive gap [-], which leaves a millionth of it.
constexpr int most_halvings = 20;

class OdeintPeer final : public Peer {
 public:
  std::string name() const override { return "Odeint"; }
  std::string version() const override {
    return "Boost " + std::to_string(BOOST_VERSION / 100000) + "." +
           std::to_string(BOOST_VERSION / 100 % 1000);
  }
  std::string method() const override {
    return "runge_kutta_dopri5, dense output, sign changes between steps, TOMS 748";
  }

  std::vector<Located> impacts(const Case& the_case, const Stop& stop,
                               const Effort& effort) override {
    return follow(the_case, stop, effort, [&](const State& state, double time) {
      return next(the_case, state, time, stop.horizon, effort);
    });
  }

 private:
  std::optional<Root> next(const Case& the_case, const State& state, double time, double horizon,
                           const Effort& effort) {
    const double longest = effort.longest_step > 0.0 ? effort.longest_step : horizon;
    Stepper stepper =
        odeint::make_dense_output(effort.tolerance, effort.tolerance, longest, Method());
    stepper.initialize(numbers_of(state), time, std::min(first_step, longest));
    const auto fly = [&](const Numbers& now, Numbers& rates, double /*time*/) {
      std::copy_n(now.begin() + 3, 3, rates.begin());
      rates[3] = the_case.gravity.x();
      rates[4] = the_case.gravity.y();
      rates[5] = 0.0;
    };
    while (stepper.current_time() < horizon) {
      const auto [from, to] = stepper.do_step(fly);
      const std::optional<Root> found = crossing(the_case, stepper, from, std::min(to, horizon));
      if (found) {
        return found;
      }
    }
    return std::nullopt;
  }

  /// The first root of a falling gap within a step.
  std::optional<Root> crossing(const Case& the_case, const Stepper& stepper, double from,
                               double to) {
    std::optional<Root> first;
    Numbers there;
    for (std::size_t index = 0; index < the_case.cables.size(); ++index) {
      const auto gap_then = [&](double time) {
        stepper.calc_state(time, there);
        return gap_at(the_case.cables[index], there.data());
      };
      const double until = first ? first->time : to;
      const double last = gap_then(until);
      if (last >= 0.0) {
        continue;
      }
      double open = from;
      double value = gap_then(open);
      for (int halving = 0; value <= 0.0 && halving < most_halvings; ++halving) {
        const double part = std::ldexp(until - from, -1 - halving);
        open = from + part;
        value = gap_then(open);
      }
      if (value <= 0.0) {
        continue;  // it was hit and has not opened
      }
      std::uintmax_t steps = 100;
      const auto bracket = boost::math::tools::toms748_solve(
          gap_then, open, until, value, last,
          boost::math::tools::eps_tolerance<double>(std::numeric_limits<double>::digits), steps);
      stepper.calc_state(bracket.second, there);
      first = Root{bracket.second, state_of(there), CableSet::of(index)};
    }
    return first;
  }
};

}  // namespace

std::unique_ptr<Peer> odeint_peer() { return std::make_unique<OdeintPeer>(); }

}  // namespace tautline::peers
