#include "bench/ensemble/statistic.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <boost/math/tools/roots.hpp>
#include <cassert>
#include <cmath>
#include <utility>

#include "bench/ensemble/largest_tension.hpp"
#include "bench/measure/impact_match.hpp"
#include "bench/measure/settling_match.hpp"
#include "bench/measure/tension_match.hpp"
#include "tautline/geometry.hpp"
#include "tautline/system_geometry.hpp"
#include "tautline/system_settling.hpp"

namespace tautline::bench {
namespace {

/// The places of the statistics, in the order of `statistics_of`: a value for each of them is put
/// there for every draw, and a name would be looked up as often. A system has others in some
/// places, and the taut share of each cable after the last.
struct Place {
  enum : std::size_t {
    settled_fast,
    settled_slow,
    lock,
    impacts,
    swing_energy,
    swing_amplitude,
    largest_angle,
    first_loss,  // of each cable one
    residual_energy = swing_energy,
    one_percent = swing_amplitude,
    impacts_a_period = largest_angle,
  };
  enum AfterLosses : std::size_t {
    largest_impulse,
    largest_tension,
    overstretch,
    captured,
    first_cable,
    end,
    repeats = overstretch,
    rests = captured,
  };

  static std::size_t of(const EnsembleSpec& spec, AfterLosses statistic) {
    return first_loss + cables_of(spec.the_case) + statistic;
  }
};

/// What the impulse on one cable takes [J]: the work of the mean rate. Summed over the cables of an
/// impact it is the whole loss, as 1/2 (v+ + v-) . M (v+ - v-) = 1/2 (v+ + v-) . J^T impulse.
double work_of(double impulse, double rate_before, double rate_after) {
  return -0.5 * impulse * (rate_before + rate_after);
}

/// What the impacts of either side say, one after another.
class ImpactSums {
 public:
  explicit ImpactSums(const EnsembleSpec& spec)
      : spec_(spec), values_(Place::of(spec, Place::end)) {}

  /// An impact on `cable` that is faster than the second speed; `speed` [m/s], of closing, is its
  /// own or a lower bound on the same side of the first.
  void add(double time, std::size_t cable, double speed, double energy_lost) {
    values_[Place::settled_slow] = time;
    if (speed > spec_.speeds[0]) {
      values_[Place::settled_fast] = time;
      count_ += 1.0;
    }
    lost_[cable] += energy_lost;
    sum_ += energy_lost;
    if (!first_cable_) {
      first_cable_ = cable;
    }
  }

  /// The impulse of one cable in an impact of any speed [N s].
  void note(double impulse) { largest_impulse_ = std::max(largest_impulse_, impulse); }

  /// The values that impacts say; the rest is none.
  StatisticValues values() && {
    values_[Place::impacts] = count_;
    values_[Place::of(spec_, Place::largest_impulse)] = largest_impulse_;
    if (first_cable_) {
      values_[Place::of(spec_, Place::first_cable)] = static_cast<double>(*first_cable_);
    }
    for (std::size_t cable = 0; cable < cables_of(spec_.the_case) && sum_ > 0.0; ++cable) {
      values_[Place::first_loss + cable] = lost_[cable] / sum_;
    }
    return std::move(values_);
  }

 private:
  const EnsembleSpec& spec_;
  StatisticValues values_;
  std::array<double, max_cables> lost_{};  // [J]
  double count_ = 0.0;                     // of those faster than the first speed
  double sum_ = 0.0;                       // [J]
  double largest_impulse_ = 0.0;           // [N s]
  std::optional<std::size_t> first_cable_;
};

/// Between which speeds an impact on one cable alone was [m/s], by its impulse: a speed v before it
/// takes an impulse of m (1 + e) v, of the mass m of the attachment along the cable, with
/// 1/m = 1/M + (arm x direction)^2 / I.
struct SpeedPerImpulse {
  double least;  // [1/kg]
  double most;

  SpeedPerImpulse(const Case& the_case, const Cable& cable) {
    constexpr double rounding = 1.0 + 1e-9;
    const bool constant = !depends_on_speed(cable);
    least = 1.0 / (the_case.body.mass * (1.0 + (constant ? cable.restitution : 1.0)) * rounding);
    most = rounding * most_response(the_case, cable) / (1.0 + (constant ? cable.restitution : 0.0));
  }
};

/// The gap rates of `cable` before and after an impact [m/s].
struct Rates {
  double before;
  double after;
};

/// What `gap_rate` says of both: they are at one pose, which is the greater part of the work.
Rates rates_at(const Cable& cable, const Event& event) {
  assert(event.before.angle == event.after.angle && "an impact changes velocities alone");
  const Vec2 arm = attachment_arm(event.before, cable);
  const Vec2 from_anchor = event.before.position + arm - cable.anchor;
  const double distance = from_anchor.norm();
  const auto rate = [&](const State& state) {
    const Vec2 velocity = state.velocity + state.spin * perpendicular(arm);
    return -from_anchor.dot(velocity) / distance;
  };
  return {rate(event.before), rate(event.after)};
}

/// Deals with an impact on one cable of which the impulse alone says where it is between the two
/// `speeds`, as of most: adds it, or passes over one that is too slow. False where its pose has to
/// be asked.
bool add_by_impulse(ImpactSums& sums, const Case& the_case, const Event& event,
                    const SpeedPerImpulse& speed, const std::array<double, 2>& speeds) {
  const double least = speed.least * event.impulses[0];
  const double most = speed.most * event.impulses[0];
  if (most <= speeds[1]) {
    return true;
  }
  if (!(least > speeds[1]) || (least <= speeds[0] && most > speeds[0])) {
    return false;
  }
  const double energy = kinetic_energy(the_case.body, event.before);
  const double lost = energy - kinetic_energy(the_case.body, event.after);
  constexpr double rounding = 1e-14;  // [-], of the difference: an elastic impact loses nothing
  sums.add(event.time, *event.cables.begin(), least, lost > rounding * energy ? lost : 0.0);
  return true;
}

void add_impacts(ImpactSums& sums, const Case& the_case, const Solution& solution,
                 const std::array<double, 2>& speeds) {
  std::vector<SpeedPerImpulse> per_impulse;
  for (const Cable& cable : the_case.cables) {
    per_impulse.emplace_back(the_case, cable);
  }
  for (const Event& event : solution.events()) {
    if (event.kind != EventKind::impact) {
      continue;
    }
    if (event.impulses.size() == 1) {
      sums.note(event.impulses[0]);
      if (add_by_impulse(sums, the_case, event, per_impulse[*event.cables.begin()], speeds)) {
        continue;
      }
    } else {
      sums.note(event.impulses.maxCoeff());
    }
    Eigen::Index place = 0;
    for (const std::size_t cable : event.cables) {
      const auto [before, after] = rates_at(the_case.cables[cable], event);
      if (-before > speeds[1]) {
        sums.add(event.time, cable, -before, work_of(event.impulses[place], before, after));
      }
      ++place;
    }
  }
}

template <int D>
void add_impacts(ImpactSums& sums, const BasicSystem<double, D>& system,
                 const BasicSolution<BasicSystem<double, D>>& solution, double slowest) {
  for (const auto& event : solution.events()) {
    if (event.kind != EventKind::impact) {
      continue;
    }
    sums.note(event.impulses.maxCoeff());
    Eigen::Index place = 0;
    for (const std::size_t index : event.cables) {
      const double before = gap_rate(system.cables[index], event.before);
      if (-before > slowest) {
        sums.add(
            event.time, index, -before,
            work_of(event.impulses[place], before, gap_rate(system.cables[index], event.after)));
      }
      ++place;
    }
  }
}

void add_impacts(ImpactSums& sums, const Trajectory& run, double slowest) {
  for (const RecordedImpact* impact : counted(run, slowest)) {
    sums.add(impact->time, impact->cable, -impact->rate_before,
             work_of(impact->impulse, impact->rate_before, impact->rate_after));
  }
}

/// How a body has turned.
struct Turning {
  double angle;  // [rad]
  double spin;   // [rad/s]
};

/// What `arc.after(dt)` says of the angle of an arc on taut cables, without the rest of it.
Turning turn_after(const Arc& arc, double dt) {
  Turning turn{0.0, 0.0};
  for (Eigen::Index k = arc.series.rows() - 1; k >= 0; --k) {
    turn.spin = turn.spin * dt + turn.angle;
    turn.angle = turn.angle * dt + arc.series(k, 2);
  }
  return turn;
}

/// A bound of |angle| along such an arc [rad], which its rounding is within, too.
double most_angle(const Arc& arc, double length) {
  constexpr double rounding = 1.0 + 1e-12;
  const Eigen::Index terms = arc.series.rows();
  const double* const coefficients = arc.series.data() + 2 * terms;  // of the angle
  const double square = length * length;
  // two sums side by side, of even and of odd powers
  double even = 0.0;
  double odd = 0.0;
  Eigen::Index k = terms - 1;
  if (k % 2 == 0) {
    even = std::abs(coefficients[k--]);
  }
  for (; k > 0; k -= 2) {
    odd = odd * square + std::abs(coefficients[k]);
    even = even * square + std::abs(coefficients[k - 1]);
  }
  return rounding * (even + length * odd);
}

/// The largest |angle| of such an arc: at its end, or where the spin changes its sign. It is far
/// shorter than a swing.
double largest_angle(const Arc& arc, double length) {
  const Turning end = turn_after(arc, length);
  if (!(arc.initial.spin * end.spin < 0.0)) {
    return std::abs(end.angle);
  }
  const boost::math::tools::eps_tolerance<double> half_of_digits(26);  // the angle is flat there
  std::uintmax_t most = 100;  // bisection alone needs no more
  const auto [low, high] =
      boost::math::tools::toms748_solve([&](double dt) { return turn_after(arc, dt).spin; }, 0.0,
                                        length, arc.initial.spin, end.spin, half_of_digits, most);
  return std::max(std::abs(end.angle), std::abs(turn_after(arc, 0.5 * (low + high)).angle));
}

/// The largest |angle| of an exact motion, also of a swing that has not been followed.
double largest_angle(const Solution& solution) {
  const std::optional<Swing>& swing = solution.swing();
  double largest = swing && swing->angle == SwingAngle::body
                       ? std::max(std::abs(swing->least), std::abs(swing->largest))
                       : 0.0;
  for (const Arc& arc : solution.arcs()) {
    const double length = arc.end - arc.start;
    if (arc.series.rows() == 0) {  // in flight the spin is constant
      largest = std::max({largest, std::abs(arc.initial.angle),
                          std::abs(arc.initial.angle + length * arc.initial.spin)});
    } else if (most_angle(arc, length) > largest) {
      largest = std::max({largest, std::abs(arc.initial.angle), largest_angle(arc, length)});
    }
  }
  return largest;
}

/// The largest impulse of one cable in an impact [N s], 0 without an impact.
double largest_impulse(const Trajectory& run) {
  double largest = 0.0;
  for (const RecordedImpact& impact : run.impacts) {
    largest = std::max(largest, impact.snap);
  }
  return largest;
}

double largest_angle(const Trajectory& run) {
  double largest = 0.0;
  for (const Point& point : run.points) {
    largest = std::max(largest, std::abs(point.state.angle));
  }
  for (const RecordedImpact& impact : run.impacts) {  // in flight it is at an impact, in a step
    largest = std::max({largest, std::abs(impact.before.angle), std::abs(impact.after.angle)});
  }
  return largest;
}

}  // namespace

double most_response(const Case& the_case, const Cable& cable) {
  const auto weight = inverse_mass(the_case.body);
  return weight[0] + cable.attachment.squaredNorm() * weight[2];
}

template <int D>
double most_response(const BasicSystem<double, D>& system,
                     const BasicCableOfSystem<double, D>& cable) {
  double result = 0.0;
  for (std::size_t i = 0; i <= cable.segments(); ++i) {
    if (const auto& end = cable.end(i); end.body) {
      const auto& body = system.bodies[*end.body];
      const double pulls = i == 0 || i == cable.segments() ? 1.0 : 2.0;  // on a ring both sides do
      const double turn =
          has_inertia(body.inertia) ? end.at.squaredNorm() / moments(body.inertia).minCoeff() : 0.0;
      result += pulls * pulls * (1.0 / body.mass + turn);
    }
  }
  return result;
}
template double most_response(const System&, const CableOfSystem&);
template double most_response(const SpatialSystem&, const SpatialCable&);

std::vector<Statistic> statistics_of(const EnsembleSpec& spec) {
  const auto& [fast, slow] = spec.speeds;
  const bool of_systems = is_system(spec.the_case);
  std::vector<Statistic> all = {
      {"settled_fast", fmt::format("last impact > {:g} m/s", fast), "s", fixed(4), true, true,
       OfEngines::all, "the last impact faster than the first speed: settling time"},
      {"settled_slow", fmt::format("last impact > {:g} m/s", slow), "s", fixed(4), true, true,
       OfEngines::all, "the last impact faster than the second speed"},
      {"lock", "lock", "s", fixed(4), true, true, OfEngines::none,
       of_systems ? "from which on the cables that are taut at the end stay taut; none where what "
                    "is given still varies"
                  : "from which on the last cables stay taut; of an engine's run none is known"},
      {"impacts", fmt::format("impacts > {:g} m/s", fast), "", as_count, true, true, OfEngines::all,
       "impacts faster than the first speed, one a cable"},
  };
  const auto add = [&](std::initializer_list<Statistic> of_case,
                       std::initializer_list<Statistic> of_system) {
    all.insert(all.end(), of_systems ? of_system : of_case);
  };
  add({{"swing_energy", "swing energy", "J", fixed(5), true, true, OfEngines::all,
        "above the equilibrium, in the last period; none where the exact motion has not locked and "
        "swung to and fro by the end"},
       {"swing_amplitude", "swing amplitude", "rad", fixed(4), true, true, OfEngines::all,
        "half the range of the angle in the last period"},
       {"largest_angle", "largest |angle|", "rad", fixed(4), true, true, OfEngines::all,
        "of the whole motion"}},
      {{"residual_energy", "residual energy", "J", fixed(5), true, true, OfEngines::none,
        "above the equilibrium of the cables that lock the motion, at the end"},
       {"one_percent", "time to 1 %", "s", fixed(4), true, true, OfEngines::none,
        "when drag has taken 99 % of the energy that is left at the lock"},
       {"impacts_a_period", "impacts a period", "", fixed(2), true, true, OfEngines::none,
        "of inextensible cables, in the last periods of the waves; none without waves"}});
  for (std::size_t cable = 0; cable < cables_of(spec.the_case); ++cable) {
    all.push_back({fmt::format("loss_{}", cable), fmt::format("loss in cable {}", cable), "",
                   fixed(4), true, true, OfEngines::all,
                   "share of the energy that impacts faster than the second speed lose"});
  }
  all.push_back({"largest_impulse", "largest impulse", "N s", fixed(5), true, true, OfEngines::all,
                 "of one cable in one impact; 0 without an impact"});
  all.push_back({"largest_tension", "largest tension", "N", fixed(4), true, true, OfEngines::some,
                 "of one cable that is taut, impacts aside; of an engine that tells its tensions "
                 "the largest mean over a step"});
  add({{"overstretch", "overstretch", "m", as_error, false, false, OfEngines::all,
        "the largest of the run"},
       {"captured", "captured", "", as_count, false, true, OfEngines::none,
        "1 where the cables that lock the motion are never let go, else 0; none before it is "
        "locked"}},
      {{"repeats", "repeats after", "periods", as_count, false, true, OfEngines::none,
        "every how many periods of the waves the motion repeats at the end; none where it does "
        "not"},
       {"rests", "rests", "", as_count, false, true, OfEngines::none,
        "1 where the bodies rest at the end, else 0; none before they are locked"}});
  all.push_back({"first_cable", "first cable", "", as_count, false, true, OfEngines::all,
                 "the cable of the first impact that is counted"});
  for (std::size_t cable = 0; of_systems && cable < cables_of(spec.the_case); ++cable) {
    all.push_back({fmt::format("taut_share_{}", cable), fmt::format("cable {} taut", cable), "",
                   fixed(4), true, true, OfEngines::none, "share of the time in which it is taut"});
  }
  return all;
}

std::size_t place_of_statistic(const std::vector<Statistic>& all, const std::string& name) {
  const auto place =
      std::find_if(all.begin(), all.end(), [&](const Statistic& one) { return one.name == name; });
  assert(place != all.end() && "a name of statistics_of");
  return static_cast<std::size_t>(place - all.begin());
}

StatisticValues exact_statistics(const EnsembleSpec& spec, const Case& the_case,
                                 const Solution& solution, const std::optional<Lock>& lock) {
  ImpactSums sums(spec);
  add_impacts(sums, the_case, solution, spec.speeds);
  StatisticValues values = std::move(sums).values();
  values[Place::largest_angle] = largest_angle(solution);
  values[Place::of(spec, Place::largest_tension)] = largest_tension(solution);
  if (lock) {
    values[Place::lock] = lock->time;
    values[Place::of(spec, Place::captured)] = lock->permanent ? 1.0 : 0.0;
  }
  if (const auto swing = measured_swing(the_case, solution, lock)) {
    values[Place::swing_energy] = swing->energy;
    values[Place::swing_amplitude] = swing->amplitude;
  }
  return values;
}

template <int D>
StatisticValues system_statistics(const EnsembleSpec& spec, const BasicSystem<double, D>& system,
                                  const BasicSolution<BasicSystem<double, D>>& solution) {
  ImpactSums sums(spec);
  add_impacts(sums, system, solution, spec.speeds[1]);
  StatisticValues values = std::move(sums).values();
  const SystemSettling settled = settling(system, solution);
  double largest = 0.0;
  for (const CableUse& use : settled.cables) {
    largest = std::max(largest, use.tension ? use.tension->value : 0.0);
    values.emplace_back(use.taut_share);
  }
  values[Place::of(spec, Place::largest_tension)] = largest;
  if (const auto& lock = settled.lock) {
    values[Place::lock] = lock->time;
    values[Place::residual_energy] = lock->residual_energy;
    values[Place::one_percent] = lock->one_percent;
    values[Place::of(spec, Place::rests)] = lock->at_rest ? 1.0 : 0.0;
  }
  if (const auto& forced = settled.forced) {
    values[Place::impacts_a_period] = forced->impacts;
    if (forced->repeats) {
      values[Place::of(spec, Place::repeats)] = static_cast<double>(*forced->repeats);
    }
  }
  return values;
}

template StatisticValues system_statistics(const EnsembleSpec&, const System&,
                                           const BasicSolution<System>&);
template StatisticValues system_statistics(const EnsembleSpec&, const SpatialSystem&,
                                           const BasicSolution<SpatialSystem>&);

StatisticValues run_statistics(const EnsembleSpec& spec, const ReferenceCase& reference,
                               const Trajectory& run) {
  ImpactSums sums(spec);
  add_impacts(sums, run, spec.speeds[1]);
  StatisticValues values = std::move(sums).values();
  values[Place::largest_angle] = largest_angle(run);
  values[Place::of(spec, Place::largest_impulse)] = largest_impulse(run);
  values[Place::of(spec, Place::largest_tension)] = largest_tension(run);
  values[Place::of(spec, Place::overstretch)] = run.overstretch;
  if (const auto swing =
          match_swing(reference.the_case, reference.solution, reference.settling, run)) {
    values[Place::swing_energy] = swing->energy.found;
    values[Place::swing_amplitude] = swing->amplitude.found;
  }
  return values;
}

}  // namespace tautline::bench
