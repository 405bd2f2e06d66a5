#include "bench/measure/attribution/attribution.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <type_traits>
#include <utility>
#include <vector>

#include "bench/measure/attribution/carry.hpp"
#include "bench/measure/attribution/chain.hpp"
#include "bench/measure/attribution/scheme.hpp"
#include "bench/measure/attribution/segments.hpp"
#include "bench/measure/attribution/soft_motion.hpp"
#include "bench/measure/attribution/systems.hpp"
#include "bench/measure/impact_match.hpp"
#include "bench/measure/reference.hpp"
#include "tautline/case_or_system.hpp"
#include "tautline/geometry.hpp"
#include "tautline/model_table.hpp"
#include "tautline/system_geometry.hpp"

namespace tautline::bench {
namespace {

/// Up to this share of amplification the parts name where nine tenths of the deviation come from
/// [-].
constexpr double little_amplified = 0.1;

/// Beyond this share they say how the motion grows, and nothing of where it came from [-].
constexpr double most_amplified = 0.5;

/// The time is not later than after so many impacts: the work grows with their square, and what
/// they tell of an engine is told by then. A motion of a system takes a hundred times as long.
template <class TheCase>
constexpr std::size_t most_impacts = std::is_same_v<TheCase, Case> ? 16 : 4;

/// The parts must add up to the deviation within this share of it [-].
constexpr double most_remainder = 0.05;

/// The time is tried after impact 1, 2, 4, 8, ...: each so many times later than the last [-].
constexpr double next_try = 2.0;

/// A search this many tries long without success is over: later is no better.
constexpr int most_failures = 1;

/// More segments than this are not followed: each costs a few solutions, and a cable that chatters
/// where it should be taut has no end of them.
constexpr std::size_t most_segments = 80;

/// Where defects carried to first order miss the whole by no more than this, they are taken as they
/// are, and no link is carried exactly [-]: it saves four solutions of five.
constexpr double nearly_linear = 0.02;

/// Reads a whole run, and cuts it then.
class Reading {
 public:
  Reading(const Case& the_case, const Trajectory& run)
      : case_(the_case),
        run_(run),
        jumps_(jumps_of(the_case, run)),
        scheme_(find_scheme(the_case, jumps_, run)) {}

  [[nodiscard]] std::vector<PlanarSegment> segments(std::size_t last) const {
    return bench::segments(case_, run_, jumps_, last);
  }
  [[nodiscard]] PlanarChain chain(const PlanarSegment& segment, const Solution& exact) const {
    return chain_of(case_, run_, segment, jumps_, scheme_, exact);
  }

 private:
  const Case& case_;
  const Trajectory& run_;
  std::vector<Jump> jumps_;
  Scheme scheme_;
};

/// The largest lengths and speeds of a case, and the arm that a turn moves.
struct Sizes {
  double length;  // [m]
  double speed;   // [m/s]
  double arm;     // [m]
};
Sizes sizes_of(const Case& the_case) {
  const double length = shortest_length(the_case);
  return {length,
          std::sqrt(the_case.gravity.norm() * length) + speed_scale(the_case, the_case.initial),
          attachment_radius(the_case)};
}
Sizes sizes_of(const SpatialSystem& system) {
  double arm = 0.0;
  for (std::size_t index = 0; index < system.bodies.size(); ++index) {
    arm = std::max(arm, longest_arm(system, index));
  }
  return {shortest_cable(system), likely_speed(system), arm};
}

/// How far one state is from another in all places, turns, and their rates, at most one body.
struct Apart {
  double position = 0.0;  // [m]
  double turn = 0.0;      // [rad]
  double velocity = 0.0;  // [m/s]
  double spin = 0.0;      // [rad/s]
};
Apart apart_by(const StateDifference<Case>& d) {
  return {d.head<2>().norm(), std::abs(d[2]), d.segment<2>(3).norm(), std::abs(d[5])};
}
Apart apart_by(const StateDifference<SpatialSystem>& d) {
  Apart most;
  const Eigen::Index half = d.size() / 2;
  for (Eigen::Index row = 0; row < half; row += freedoms_of_body<3>) {
    most.position = std::max(most.position, d.segment<3>(row).norm());
    most.turn = std::max(most.turn, d.segment<3>(row + 3).norm());
    most.velocity = std::max(most.velocity, d.segment<3>(half + row).norm());
    most.spin = std::max(most.spin, d.segment<3>(half + row + 3).norm());
  }
  return most;
}

/// The place of one body [m]: of a system the one that is the farthest off.
struct OneBody {
  Eigen::Index row;   // of a difference
  Eigen::Index size;  // numbers of its position

  [[nodiscard]] Eigen::VectorXd place(const Eigen::VectorXd& d) const {
    return d.segment(row, size);
  }
};
OneBody farthest(const StateDifference<Case>& /*d*/) { return {0, 2}; }
OneBody farthest(const StateDifference<SpatialSystem>& d) {
  Eigen::Index found = 0;
  for (Eigen::Index row = 0; row < d.size() / 2; row += freedoms_of_body<3>) {
    found = d.segment<3>(row).norm() > d.segment<3>(found).norm() ? row : found;
  }
  return {found, 3};
}

/// Splits D(T) of a run with soft cables into its model and its steps; says why where it cannot.
template <class TheCase>
void add_soft_parts(const TheCase& the_case, const BasicTrajectory<TheCase>& run,
                    const StateOf<TheCase>& there, const StateOf<TheCase>& exact,
                    Attribution& result) {
  if (run.soft_rows.size() != the_case.cables.size()) {
    return;  // its cables are not soft
  }
  const auto whole = difference(there, exact);
  const OneBody body = farthest(whole);
  const Eigen::VectorXd deviation = body.place(whole);
  const auto leave_out = [&](const std::string& why) {
    result.reason += (result.reason.empty() ? "" : "; ") + ("no model and step: " + why);
  };
  if (!(deviation.norm() > 0.0)) {
    return leave_out("there is no deviation");
  }
  const auto soft = soft_motion(the_case, run.soft_rows, result.until);
  if (!soft.state) {
    return leave_out(soft.why);
  }
  const double model = deviation.normalized().dot(body.place(difference(*soft.state, exact)));
  result.soft = SoftParts{model, deviation.norm() - model};
}

/// What has been summed up to T.
struct Sum {
  Attribution result;
  double chaos = 0.0;  // [m], the amplification of defects above the noise
};

double& part(Sum& sum, Cause cause) {
  return sum.result.parts.value()[static_cast<std::size_t>(cause)];
}

template <class TheCase, class TheReading>
class Attributor {
 public:
  using State = StateOf<TheCase>;
  using Run = BasicTrajectory<TheCase>;
  using Piece = BasicSegment<TheCase>;
  using Part = Carried<TheCase>;

  Attributor(const TheCase& the_case, const BasicSolution<TheCase>& solution, const Run& run,
             const AttributionOptions& options)
      : case_(the_case),
        solution_(solution),
        run_(run),
        options_(options),
        reading_(the_case, run),
        sizes_(sizes_of(the_case)) {}

  /// The parts at the sample `last`; none where the exact motion cannot be restarted.
  [[nodiscard]] std::optional<Sum> at(std::size_t last) {
    const double until = run_.points[last].time;
    const auto whole = difference(run_.points[last].state, solution_.at(until));
    body_ = farthest(whole);
    const Eigen::VectorXd deviation = body_.place(whole);
    direction_ = deviation;
    if (deviation.norm() > 0.0) {
      direction_.normalize();
    }
    Sum sum;
    sum.result.until = until;
    sum.result.deviation = deviation.norm();
    sum.result.parts = CauseParts{};
    const std::vector<Piece> cuts = reading_.segments(last);
    if (cuts.size() > most_segments) {
      return std::nullopt;
    }
    const Carrier<TheCase> carrier(case_, options_.law, until);
    auto from = carrier.carry(case_.initial, 0.0);
    for (const Piece& segment : cuts) {
      const double end = run_.points[segment.last].time;
      const bool is_last = segment.last == last;
      auto to = is_last ? Part(run_.points[last].state) : carrier.carry(segment.end, end);
      if (!from || !to || !add(carrier, segment, *from, *to, sum)) {
        return std::nullopt;
      }
      ++(segment.kind == Piece::Kind::impact ? sum.result.impacts : sum.result.arcs);
      from = std::move(to);
    }
    const auto& parts = *sum.result.parts;
    sum.result.remainder = sum.result.deviation - std::accumulate(parts.begin(), parts.end(), 0.0);
    return sum;
  }

 private:
  /// The way of the body from `b` to `a` [m].
  [[nodiscard]] Eigen::VectorXd way(const State& a, const State& b) const {
    return body_.place(difference(a, b));
  }

  /// Adds one segment, whose start and end are carried already. False where a link cannot be.
  [[nodiscard]] bool add(const Carrier<TheCase>& carrier, const Piece& segment, Part& from,
                         Part& to, Sum& sum) {
    const BasicChain<TheCase> chain = reading_.chain(segment, from.solution());
    const double start = run_.points[segment.first].time;
    const double end = run_.points[segment.last].time;
    const Eigen::VectorXd whole = way(to.end(), from.end());
    if (is_noise(chain.exact, chain.links.back().state)) {
      part(sum, Cause::amplification) += direction_.dot(whole);
      return true;
    }
    return add_linear(chain, to, whole, sum) ||
           add_exactly(carrier, chain, from, to, end, end - start, sum);
  }

  /// Adds the links of a chain that ends in `to` and is carried by `whole` [m], if that is nearly
  /// what they are to first order.
  [[nodiscard]] bool add_linear(const BasicChain<TheCase>& chain, const Part& to,
                                const Eigen::VectorXd& whole, Sum& sum) const {
    CauseParts linear{};
    Eigen::VectorXd left = whole;
    double size = 0.0;
    State state = chain.exact;
    for (const auto& link : chain.links) {
      const Eigen::VectorXd own = body_.place(to.to_first_order(difference(link.state, state)));
      linear[static_cast<std::size_t>(link.cause)] += direction_.dot(own);
      left -= own;
      size += own.norm();
      state = link.state;
    }
    if (!(left.norm() <= nearly_linear * size)) {
      return false;
    }
    for (const Cause cause : causes) {
      part(sum, cause) += linear[static_cast<std::size_t>(cause)];
    }
    part(sum, Cause::amplification) += direction_.dot(left);
    sum.chaos += std::abs(direction_.dot(left));
    return true;
  }

  /// Adds them one by one, each carried exactly from `end` [s]. False where one cannot be.
  [[nodiscard]] bool add_exactly(const Carrier<TheCase>& carrier, const BasicChain<TheCase>& chain,
                                 const Part& from, const Part& to, double end, double patience,
                                 Sum& sum) const {
    auto before = carrier.carry_out(chain.exact, end, patience);
    State place = from.end();  // the exact motion goes through the chain's first state
    State state = chain.exact;
    for (std::size_t index = 0; before && index < chain.links.size(); ++index) {
      const auto& link = chain.links[index];
      const bool last = index + 1 == chain.links.size();
      const auto defect = difference(link.state, state);
      if (!last && defect.isZero(0.0)) {
        continue;
      }
      auto after = last ? to : carrier.carry_out(link.state, end, patience);
      if (!after) {
        return false;
      }
      const Eigen::VectorXd whole = way(after->end(), place);
      const double first_order = first_order_of(*before, *after, defect);
      const double own = whole.norm() > first_order ? first_order / whole.norm() : 1.0;
      const double along = direction_.dot(whole);
      part(sum, link.cause) += own * along;
      part(sum, Cause::amplification) += (1.0 - own) * along;
      sum.chaos += (1.0 - own) * std::abs(along);
      place = after->end();
      before = std::move(after);
      state = link.state;
    }
    return before.has_value();
  }

  /// How far a defect is carried to first order, by the derivative at either end [m]; an infinite
  /// one (grazing) says nothing.
  [[nodiscard]] double first_order_of(const Part& a, const Part& b,
                                      const StateDifference<TheCase>& defect) const {
    double most = 0.0;
    for (const Part* end : {&a, &b}) {
      const Eigen::VectorXd way = body_.place(end->to_first_order(defect));
      most = way.allFinite() ? std::max(most, way.norm()) : most;
    }
    return most;
  }

  [[nodiscard]] bool is_noise(const State& a, const State& b) const {
    const Apart off = apart_by(difference(a, b));
    const double size = std::max((off.position + sizes_.arm * off.turn) / sizes_.length,
                                 (off.velocity + sizes_.arm * off.spin) / sizes_.speed);
    return size <= options_.noise;
  }

  const TheCase& case_;
  const BasicSolution<TheCase>& solution_;
  const Run& run_;
  const AttributionOptions& options_;
  TheReading reading_;
  Sizes sizes_;
  OneBody body_{0, 2};         // that D(T) is of
  Eigen::VectorXd direction_;  // of D(T)
};

/// The instants to try: middles between impacts of the exact motion, then the end.
std::vector<double> instants(const std::vector<CountedImpact>& impacts, double end,
                             std::size_t most) {
  std::vector<double> result;
  std::size_t wanted = 1;
  for (std::size_t index = 0; index < impacts.size() && impacts[index].time < end; ++index) {
    if (index == most) {
      return result;
    }
    if (index + 1 < wanted) {
      continue;
    }
    wanted = std::max(wanted + 1, static_cast<std::size_t>(next_try * static_cast<double>(wanted)));
    const double next = index + 1 < impacts.size() ? impacts[index + 1].time : end;
    result.push_back(std::min(end, 0.5 * (impacts[index].time + next)));
  }
  if (result.empty() || result.back() < end) {
    result.push_back(end);
  }
  return result;
}

/// The share of amplification above the noise [-]; infinite where the parts are not the whole.
double amplified(const Sum& sum) {
  double all = 0.0;
  for (const double part : *sum.result.parts) {
    all += std::abs(part);
  }
  if (!(std::abs(sum.result.remainder) <= most_remainder * sum.result.deviation)) {
    return std::numeric_limits<double>::infinity();
  }
  return sum.chaos > 0.0 ? sum.chaos / all : 0.0;
}

/// Why `found` ends before the horizon: `last` [s] was the last instant tried, `end` [s] the run's.
std::string reason_to_end(const Attribution& found, double last, double end, double step,
                          std::size_t most) {
  if (last - found.until > 2.0 * step) {
    return fmt::format("after t = {:.6g} amplification takes over", found.until);
  }
  return end - found.until > 2.0 * step ? fmt::format("up to impact {}", most)
                                        : "the run ends there";
}

Attribution nothing(std::string reason) {
  Attribution result;
  result.reason = std::move(reason);
  return result;
}

/// Attributes a run by a `TheReading` of it.
template <class TheReading, class TheCase>
Attribution attributed(const TheCase& the_case, const BasicSolution<TheCase>& solution,
                       double horizon, const BasicTrajectory<TheCase>& run,
                       const AttributionOptions& options) {
  const auto impacts = counted_impacts(the_case, solution, options.count_speed);
  if (run.diverged) {
    return nothing("the run diverged");
  }
  if (run.stride > 1) {
    return nothing("the run has more steps than are kept");
  }
  const double goal = std::min(horizon, solution.end_time());
  const double end = run.points.empty() ? 0.0 : std::min(goal, run.points.back().time);
  if (!(end > 0.0)) {
    return nothing("the run has no sample but its start");
  }
  if (run.impacts.empty() && !impacts.empty() && impacts.front().time < end) {
    return nothing("the run has no impact, the exact motion has");
  }
  Attributor<TheCase, TheReading> attributor(the_case, solution, run, options);
  std::optional<Attribution> best;
  std::size_t best_point = 0;
  int failures = 0;
  const std::vector<double> tried = instants(impacts, end, most_impacts<TheCase>);
  for (const double instant : tried) {
    const auto after =
        std::upper_bound(run.points.begin(), run.points.end(), instant,
                         [](double time, const auto& point) { return time < point.time; });
    const auto last = static_cast<std::size_t>(after - run.points.begin());
    if (last < 2) {
      continue;
    }
    const auto sum = attributor.at(last - 1);
    const double share = sum ? amplified(*sum) : std::numeric_limits<double>::infinity();
    if (share <= little_amplified || (!best && share <= most_amplified)) {
      best = sum->result;
      best_point = last - 1;
      failures = 0;
    } else if (++failures > most_failures) {
      break;
    }
  }
  if (!best) {
    return nothing("the deviation is amplification from the first impact on");
  }
  best->covered = std::min(1.0, best->until / goal);
  if (goal - best->until > 2.0 * run.step) {
    best->reason = reason_to_end(*best, tried.back(), end, run.step, most_impacts<TheCase>);
  }
  add_soft_parts(the_case, run, run.points[best_point].state, solution.at(best->until), *best);
  return *best;
}

}  // namespace

double noise_of(std::string_view precision) {
  constexpr double of_double = 1e-9;
  constexpr double of_float = 1e-5;
  return precision == "float32" ? of_float : of_double;
}

Attribution attribute(const Case& the_case, const Solution& solution, double horizon,
                      const Trajectory& run, const AttributionOptions& options) {
  return attributed<Reading>(the_case, solution, horizon, run, options);
}

Attribution attribute(const SpatialSystem& system, const BasicSolution<SpatialSystem>& solution,
                      double horizon, const SystemTrajectory& run,
                      const AttributionOptions& options) {
  if (first_elastic(system)) {
    return nothing("elastic cables have no impacts, which attribution goes by");
  }
  return attributed<SystemReading>(system, solution, horizon, run, options);
}

}  // namespace tautline::bench
