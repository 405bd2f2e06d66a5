#include "bench/measure/attribution/scheme.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "bench/base/statistics.hpp"
#include "bench/measure/audit_lost.hpp"
#include "tautline/detail/flight.hpp"
#include "tautline/geometry.hpp"

namespace tautline::bench {
namespace {

/// Slower impacts than gravity times this many steps are as much tension as impact [-].
constexpr double clear_of_gravity = 5.0;

/// Another rule than the plainest must leave less than this of its misfit [-].
constexpr double much_better = 0.2;

/// A correction is looked for where the overstretch is this part of the way of a step [-].
constexpr double clear_overstretch = 0.05;

/// Corrections beyond these are none: an engine takes out a part of an overstretch, not a multiple
/// of it [-].
constexpr double least_corrected = 0.01;
constexpr double most_corrected = 1.5;

/// Rebounds smaller than this part of what they should be are lost, not of a wrong size [-].
constexpr double least_size = 0.01;

constexpr std::array bounce_rules = {BounceRule::as_is,         BounceRule::with_gravity,
                                     BounceRule::after_gravity, BounceRule::after_both,
                                     BounceRule::end_of_step,   BounceRule::at_contact};

/// Impacts on the wrong side of a threshold, at most [-].
constexpr double wrong_side = 0.1;

/// What gravity adds to the gap rate per second [m/s^2].
double gravity_rate(const Case& the_case, const Jump& jump, const State& state) {
  return gap_gradient(the_case.cables[jump.cable], state).head<2>().dot(the_case.gravity);
}

/// The rate [m/s] that a rule of the velocity after the step adds to every rebound.
double step_rate(const Case& the_case, BounceRule rule, const Jump& jump, const State& state) {
  const bool after = rule == BounceRule::with_gravity || rule == BounceRule::after_both;
  return after ? -gravity_rate(the_case, jump, state) * jump.dt : 0.0;
}

/// The state of the flight through `state` where the gap is zero, by Newton's method: it is less
/// than a step away.
State at_contact(const Case& the_case, const Cable& cable, const State& state) {
  constexpr int enough = 4;
  double dt = 0.0;
  State result = state;
  for (int iteration = 0; iteration < enough; ++iteration) {
    const double rate = gap_rate(cable, result);
    if (!(rate < 0.0)) {
      return state;
    }
    dt -= gap(cable, result) / rate;
    result = fly(state, the_case.gravity, dt);
  }
  return result;
}

/// The gap rate [m/s] right after the run's own jump.
double rate_after(const Case& the_case, const Jump& jump) {
  State after = jump.before;
  after.velocity += jump.change.head<2>();
  after.spin += jump.change[2];
  return gap_rate(the_case.cables[jump.cable], after);
}

/// An impact that tells of the rule: alone in its step, and clearly an impact.
struct Witness {
  Jump* jump;
  double rate;  // [m/s], before, < 0
  double left;  // [m/s], after
};

std::vector<Witness> witnesses_of(const Case& the_case, std::vector<Jump>& jumps) {
  std::vector<Witness> result;
  for (std::size_t index = 0; index < jumps.size(); ++index) {
    Jump& jump = jumps[index];
    const bool shared =
        (index > 0 && jumps[index - 1].last_step >= jump.first_step) ||
        (index + 1 < jumps.size() && jumps[index + 1].first_step == jump.first_step);
    const double rate = gap_rate(the_case.cables[jump.cable], jump.before);
    if (!shared && -rate > clear_of_gravity * the_case.gravity.norm() * jump.dt) {
      result.push_back({&jump, rate, rate_after(the_case, jump)});
    }
  }
  return result;
}

double misfit(const Case& the_case, const Scheme& scheme, const Witness& witness, bool bounces) {
  const Jump& jump = *witness.jump;
  const double added = step_rate(the_case, scheme.bounce, jump, jump.before);
  const double bounced = bounced_rate(the_case, scheme.bounce, jump, jump.before, bounces);
  const double scaled = added + scheme.size * (bounced - added);
  const double rate = corrected_rate(the_case, scheme, jump, jump.before, scaled);
  return std::abs(witness.left - rate) / -witness.rate;
}

/// Summed over the run, each impact rebounding or not, as it fits; or none.
double misfit(const Case& the_case, const Scheme& scheme, const std::vector<Witness>& witnesses) {
  double sum = 0.0;
  for (const Witness& witness : witnesses) {
    const double without = misfit(the_case, scheme, witness, false);
    sum += scheme.ignores ? without : std::min(misfit(the_case, scheme, witness, true), without);
  }
  return sum;
}

/// True where no impact of the run rebounds once all its steps are over, by the audit's measure.
bool ignores_restitution(const Case& the_case, const std::vector<Witness>& witnesses) {
  std::ptrdiff_t asked = 0;
  std::ptrdiff_t lost = 0;
  for (const auto& [jump, rate, left] : witnesses) {
    const double requested = restitution(the_case.cables[jump->cable], rate);
    if (requested >= asking) {
      ++asked;
      lost += jump->rebound < lost_part * requested * -rate ? 1 : 0;
    }
  }
  return asked > 0 && static_cast<double>(asked - lost) <= wrong_side * static_cast<double>(asked);
}

/// The parts of the overstretch that the run may take out in a step [-]: the median over impacts
/// that rebound, and over those that do not.
std::vector<double> corrections(const Case& the_case, BounceRule rule,
                                const std::vector<Witness>& witnesses, CorrectionRule kind) {
  std::vector<double> result;
  for (const bool bounces : {true, false}) {
    std::vector<double> parts;
    for (const auto& [jump, rate, left] : witnesses) {
      if (jump->overstretch > clear_overstretch * -rate * jump->dt) {
        const double rest = left - (kind == CorrectionRule::added
                                        ? bounced_rate(the_case, rule, *jump, jump->before, bounces)
                                        : step_rate(the_case, rule, *jump, jump->before));
        const double part = rest * jump->dt / jump->overstretch;
        if (part > least_corrected && part < most_corrected) {
          parts.push_back(part);
        }
      }
    }
    if (!parts.empty()) {
      result.push_back(median(parts));
    }
  }
  return result;
}

/// The one factor of all rebounds [-]: the median over those that are not lost.
double size_of_rebounds(const Case& the_case, BounceRule rule,
                        const std::vector<Witness>& witnesses) {
  std::vector<double> sizes;
  for (const auto& [jump, rate, left] : witnesses) {
    const double added = step_rate(the_case, rule, *jump, jump->before);
    const double size =
        (left - added) / (bounced_rate(the_case, rule, *jump, jump->before) - added);
    if (std::isfinite(size) && size > least_size) {
      sizes.push_back(size);
    }
  }
  return sizes.empty() ? 1.0 : median(sizes);
}

struct Fit {
  Scheme scheme;
  double misfit;
};

/// The best rule of the bounce, without a correction; with `sized`, all rebounds may be too large
/// or too small by one factor.
Fit best_bounce(const Case& the_case, const std::vector<Witness>& witnesses, bool ignores,
                bool sized) {
  std::optional<Fit> best;
  for (const BounceRule rule : bounce_rules) {
    Scheme scheme;
    scheme.ignores = ignores;
    scheme.bounce = rule;
    scheme.size = sized ? size_of_rebounds(the_case, rule, witnesses) : 1.0;
    const double found = misfit(the_case, scheme, witnesses);
    if (!best || found < much_better * best->misfit) {
      best = Fit{scheme, found};
    }
  }
  return *best;
}

Fit best_correction(const Case& the_case, const std::vector<Witness>& witnesses, bool ignores,
                    double enough) {
  Fit best{{}, enough};
  for (const BounceRule rule : bounce_rules) {
    Scheme scheme;
    scheme.ignores = ignores;
    scheme.bounce = rule;
    for (const CorrectionRule kind : {CorrectionRule::added, CorrectionRule::at_least}) {
      scheme.correction = kind;
      std::vector<double> parts = corrections(the_case, rule, witnesses, kind);
      constexpr double usual = 0.2;  // what Bullet and ODE take out unless told otherwise
      parts.push_back(usual);
      for (const double part : parts) {
        scheme.corrected = part;
        if (const double found = misfit(the_case, scheme, witnesses); found < best.misfit) {
          best = {scheme, found};
        }
      }
    }
  }
  return best;
}

/// The rules that fit best; a more complicated one must fit much better. A correction must also
/// beat one factor on all rebounds: an impulse of a wrong size raises them by a part of the speed,
/// as the overstretch does on average; what tells them apart is whether the rise follows the
/// overstretch from impact to impact.
Scheme best_rules(const Case& the_case, const std::vector<Witness>& witnesses) {
  const bool ignores = ignores_restitution(the_case, witnesses);
  Fit simple = best_bounce(the_case, witnesses, ignores, false);
  if (!ignores) {  // what is not there has no size
    const Fit sized = best_bounce(the_case, witnesses, ignores, true);
    simple = sized.misfit < much_better * simple.misfit ? sized : simple;
  }
  const Fit corrected = best_correction(the_case, witnesses, ignores, simple.misfit);
  return corrected.misfit < much_better * simple.misfit ? corrected.scheme : simple.scheme;
}

/// The speed up to which the run's impacts do not rebound [m/s], and above which others do; or 0.
/// Marks those that do not.
double find_threshold(const Case& the_case, const Scheme& scheme,
                      const std::vector<Witness>& witnesses) {
  std::vector<std::pair<double, bool>> rebounds;  // speed, and whether it is lost
  for (const Witness& witness : witnesses) {
    witness.jump->lost =
        misfit(the_case, scheme, witness, false) < misfit(the_case, scheme, witness, true);
    rebounds.emplace_back(-witness.rate, witness.jump->lost);
  }
  std::sort(rebounds.begin(), rebounds.end());
  // from the slowest up: lost ones above the threshold and kept ones below it are wrong
  auto wrong = std::count_if(rebounds.begin(), rebounds.end(), [](auto& r) { return r.second; });
  auto least = wrong;
  double threshold = 0.0;
  for (const auto& [speed, lost] : rebounds) {
    wrong += lost ? -1 : 1;
    if (wrong < least) {
      least = wrong;
      threshold = speed;
    }
  }
  const bool any_faster = !rebounds.empty() && rebounds.back().first > threshold;
  const bool clear =
      static_cast<double>(least) <= wrong_side * static_cast<double>(rebounds.size());
  threshold = clear && any_faster ? threshold : 0.0;
  for (const Witness& witness : witnesses) {
    witness.jump->lost = witness.jump->lost && -witness.rate <= threshold;
  }
  return threshold;
}

/// Where in a step the velocity jumps: the pose tells, as it moves with the old velocity before and
/// with the new one after. Every scheme jumps at the start, in the middle or at the end.
double find_instant(const Case& the_case, const std::vector<Witness>& witnesses,
                    const Trajectory& run) {
  const Eigen::Vector3d mass(the_case.body.mass, the_case.body.mass, the_case.body.inertia);
  std::vector<double> found;
  for (const Witness& witness : witnesses) {
    const Jump& jump = *witness.jump;
    if (jump.located) {
      continue;
    }
    State flown = run.points[jump.first_step].state;
    flown.velocity += jump.change.head<2>();
    flown.spin += jump.change[2];
    flown = fly(flown, the_case.gravity, jump.dt);
    const State& own = run.points[jump.first_step + 1].state;
    const Vec2 shift = own.position - flown.position;
    const Eigen::Vector3d way(shift.x(), shift.y(), own.angle - flown.angle);
    const Eigen::Vector3d weighted = mass.cwiseProduct(jump.change);
    found.push_back(-way.dot(weighted) / (jump.change.dot(weighted) * jump.dt));
  }
  return found.empty() ? 0.0 : std::clamp(std::round(2.0 * median(found)) / 2.0, 0.0, 1.0);
}

Jump jump_of(const Case& the_case, const Trajectory& run, const RecordedImpact& impact) {
  const std::size_t most = run.points.size() - 2;
  const double steps = impact.time / run.step;
  Jump jump{impact.time, 0,   0,        impact.cable,      impact.before,
            {},          0.0, run.step, impact.steps == 0, impact.rate_after};
  // a start of a step is k times the step, but for rounding; a located instant is anywhere
  jump.first_step = std::min(most, static_cast<std::size_t>(jump.located ? steps : steps + 0.5));
  jump.last_step = std::min(most, jump.first_step + std::max<std::size_t>(1, impact.steps) - 1);
  jump.overstretch = std::max(0.0, -gap(the_case.cables[jump.cable], impact.before));
  if (jump.located) {
    jump.change << impact.after.velocity - impact.before.velocity,
        impact.after.spin - impact.before.spin;
  } else {
    const Point& from = run.points[jump.first_step];
    const Point& to = run.points[jump.first_step + 1];
    jump.dt = to.time - from.time;
    jump.change << to.state.velocity - from.state.velocity - jump.dt * the_case.gravity,
        to.state.spin - from.state.spin;
  }
  return jump;
}

}  // namespace

std::vector<Jump> jumps_of(const Case& the_case, const Trajectory& run) {
  std::vector<Jump> jumps;
  if (run.points.size() < 2) {
    return jumps;
  }
  jumps.reserve(run.impacts.size());
  for (const RecordedImpact& impact : run.impacts) {
    jumps.push_back(jump_of(the_case, run, impact));
  }
  return jumps;
}

double bounced_rate(const Case& the_case, BounceRule rule, const Jump& jump, const State& state,
                    bool bounces) {
  const Cable& cable = the_case.cables[jump.cable];
  const double added = step_rate(the_case, rule, jump, state);
  double rate = gap_rate(cable, state);
  if (rule == BounceRule::after_gravity || rule == BounceRule::after_both) {
    rate += gravity_rate(the_case, jump, state) * jump.dt;
  } else if (rule == BounceRule::end_of_step) {
    rate = gap_rate(cable, fly(state, the_case.gravity, jump.dt));
  } else if (rule == BounceRule::at_contact) {
    rate = gap_rate(cable, at_contact(the_case, cable, state));
  }
  return (bounces ? restitution(cable, rate) * std::max(0.0, -rate) : 0.0) + added;
}

double corrected_rate(const Case& the_case, const Scheme& scheme, const Jump& jump,
                      const State& state, double rate) {
  const double out = scheme.corrected * jump.overstretch / jump.dt;
  switch (scheme.correction) {
    case CorrectionRule::none:
      return rate;
    case CorrectionRule::added:
      return rate + out;
    case CorrectionRule::at_least:
      return std::max(rate, out + step_rate(the_case, scheme.bounce, jump, state));
  }
  return rate;
}

Scheme find_scheme(const Case& the_case, std::vector<Jump>& jumps, const Trajectory& run) {
  const std::vector<Witness> witnesses = witnesses_of(the_case, jumps);
  Scheme scheme = best_rules(the_case, witnesses);
  if (scheme.ignores) {  // also those that share a step with another
    std::for_each(jumps.begin(), jumps.end(), [](Jump& jump) { jump.lost = true; });
  } else {
    scheme.threshold = find_threshold(the_case, scheme, witnesses);
  }
  scheme.instant = find_instant(the_case, witnesses, run);
  for (Jump& jump : jumps) {
    jump.time += jump.located ? 0.0 : scheme.instant * jump.dt;
  }
  return scheme;
}

}  // namespace tautline::bench
