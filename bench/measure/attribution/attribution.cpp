#include "bench/measure/attribution/attribution.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include "bench/measure/attribution/carry.hpp"
#include "bench/measure/attribution/chain.hpp"
#include "bench/measure/attribution/scheme.hpp"
#include "bench/measure/attribution/segments.hpp"
#include "bench/measure/impact_match.hpp"
#include "tautline/geometry.hpp"

namespace tautline::bench {
namespace {

/// Up to this share of amplification the parts name where nine tenths of the deviation come from
/// [-].
constexpr double little_amplified = 0.1;

/// Beyond this share they say how the motion grows, and nothing of where it came from [-].
constexpr double most_amplified = 0.5;

/// The time is not later than after so many impacts: the work grows with their square, and what
/// they tell of an engine is told by then.
constexpr std::size_t most_impacts = 16;

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

StateDifference difference(const State& a, const State& b) {
  StateDifference result;
  result << a.position - b.position, a.angle - b.angle, a.velocity - b.velocity, a.spin - b.spin;
  return result;
}

/// What has been summed up to T.
struct Sum {
  Attribution result;
  double chaos = 0.0;  // [m], the amplification of defects above the noise
};

double& part(Sum& sum, Cause cause) {
  return sum.result.parts.value()[static_cast<std::size_t>(cause)];
}

class Attributor {
 public:
  Attributor(const Case& the_case, const Solution& solution, const Trajectory& run,
             const AttributionOptions& options)
      : case_(the_case),
        solution_(solution),
        run_(run),
        options_(options),
        jumps_(jumps_of(the_case, run)),
        scheme_(find_scheme(the_case, jumps_, run)) {}

  /// The parts at the sample `last`; none where the exact motion cannot be restarted.
  [[nodiscard]] std::optional<Sum> at(std::size_t last) {
    until_ = run_.points[last].time;
    const Vec2 deviation = run_.points[last].state.position - solution_.at(until_).position;
    direction_ = deviation.norm() > 0.0 ? Vec2(deviation.normalized()) : Vec2(Vec2::Zero());
    Sum sum;
    sum.result.until = until_;
    sum.result.deviation = deviation.norm();
    sum.result.parts = CauseParts{};
    const std::vector<Segment> cuts = segments(case_, run_, jumps_, last);
    if (cuts.size() > most_segments) {
      return std::nullopt;
    }
    const Carrier carrier(case_, options_.law, until_);
    auto from = carrier.carry(case_.initial, 0.0);
    for (const Segment& segment : cuts) {
      const double end = run_.points[segment.last].time;
      const bool is_last = segment.last == last;
      auto to = is_last ? Carried(run_.points[last].state) : carrier.carry(segment.end, end);
      if (!from || !to || !add(carrier, segment, *from, *to, sum)) {
        return std::nullopt;
      }
      ++(segment.kind == Segment::Kind::impact ? sum.result.impacts : sum.result.arcs);
      from = std::move(to);
    }
    const auto& parts = *sum.result.parts;
    sum.result.remainder = sum.result.deviation - std::accumulate(parts.begin(), parts.end(), 0.0);
    return sum;
  }

 private:
  /// Adds one segment, whose start and end are carried already. False where a link cannot be.
  [[nodiscard]] bool add(const Carrier& carrier, const Segment& segment, Carried& from, Carried& to,
                         Sum& sum) {
    const Chain chain = chain_of(case_, run_, segment, jumps_, scheme_, from.solution());
    const double start = run_.points[segment.first].time;
    const double end = run_.points[segment.last].time;
    const Vec2 whole = to.position() - from.position();
    if (is_noise(chain.exact, chain.links.back().state)) {
      part(sum, Cause::amplification) += direction_.dot(whole);
      return true;
    }
    return add_linear(chain, to, whole, sum) ||
           add_exactly(carrier, chain, from, to, end, end - start, sum);
  }

  /// Adds the links of a chain that ends in `to` and is carried by `whole` [m], if that is nearly
  /// what they are to first order.
  [[nodiscard]] bool add_linear(const Chain& chain, const Carried& to, const Vec2& whole,
                                Sum& sum) const {
    CauseParts linear{};
    Vec2 left = whole;
    double size = 0.0;
    State state = chain.exact;
    for (const Link& link : chain.links) {
      const Vec2 way = to.to_first_order(difference(link.state, state));
      linear[static_cast<std::size_t>(link.cause)] += direction_.dot(way);
      left -= way;
      size += way.norm();
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
  [[nodiscard]] bool add_exactly(const Carrier& carrier, const Chain& chain, const Carried& from,
                                 const Carried& to, double end, double patience, Sum& sum) const {
    auto before = carrier.carry_out(chain.exact, end, patience);
    Vec2 place = from.position();  // the exact motion goes through the chain's first state
    State state = chain.exact;
    for (std::size_t index = 0; before && index < chain.links.size(); ++index) {
      const Link& link = chain.links[index];
      const bool last = index + 1 == chain.links.size();
      const StateDifference defect = difference(link.state, state);
      if (!last && defect.isZero(0.0)) {
        continue;
      }
      auto after = last ? to : carrier.carry_out(link.state, end, patience);
      if (!after) {
        return false;
      }
      const Vec2 way = after->position() - place;
      const double first_order = first_order_of(*before, *after, defect);
      const double own = way.norm() > first_order ? first_order / way.norm() : 1.0;
      const double along = direction_.dot(way);
      part(sum, link.cause) += own * along;
      part(sum, Cause::amplification) += (1.0 - own) * along;
      sum.chaos += (1.0 - own) * std::abs(along);
      place = after->position();
      before = std::move(after);
      state = link.state;
    }
    return before.has_value();
  }

  /// How far a defect is carried to first order, by the derivative at either end [m]; an infinite
  /// one (grazing) says nothing.
  [[nodiscard]] static double first_order_of(const Carried& a, const Carried& b,
                                             const StateDifference& defect) {
    double most = 0.0;
    for (const Carried* end : {&a, &b}) {
      const Vec2 way = end->to_first_order(defect);
      most = way.allFinite() ? std::max(most, way.norm()) : most;
    }
    return most;
  }

  [[nodiscard]] bool is_noise(const State& a, const State& b) const {
    const double length = shortest_length(case_);
    const double speed =
        std::sqrt(case_.gravity.norm() * length) + speed_scale(case_, case_.initial);
    const double radius = attachment_radius(case_);
    const auto d = difference(a, b);
    const double size = std::max((d.head<2>().norm() + radius * std::abs(d[2])) / length,
                                 (d.segment<2>(3).norm() + radius * std::abs(d[5])) / speed);
    return size <= options_.noise;
  }

  const Case& case_;
  const Solution& solution_;
  const Trajectory& run_;
  const AttributionOptions& options_;
  std::vector<Jump> jumps_;
  Scheme scheme_;
  double until_ = 0.0;             // [s]
  Vec2 direction_ = Vec2::Zero();  // of D(T)
};

/// The instants to try: middles between impacts of the exact motion, then the end.
std::vector<double> instants(const std::vector<CountedImpact>& impacts, double end) {
  std::vector<double> result;
  std::size_t wanted = 1;
  for (std::size_t index = 0; index < impacts.size() && impacts[index].time < end; ++index) {
    if (index == most_impacts) {
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
std::string reason_to_end(const Attribution& found, double last, double end, double step) {
  if (last - found.until > 2.0 * step) {
    return fmt::format("after t = {:.6g} amplification takes over", found.until);
  }
  return end - found.until > 2.0 * step ? fmt::format("up to impact {}", most_impacts)
                                        : "the run ends there";
}

Attribution nothing(std::string reason) {
  Attribution result;
  result.reason = std::move(reason);
  return result;
}

}  // namespace

double noise_of(std::string_view precision) {
  constexpr double of_double = 1e-9;
  constexpr double of_float = 1e-5;
  return precision == "float32" ? of_float : of_double;
}

Attribution attribute(const Case& the_case, const Solution& solution, double horizon,
                      const Trajectory& run, const AttributionOptions& options) {
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
  Attributor attributor(the_case, solution, run, options);
  std::optional<Attribution> best;
  int failures = 0;
  const std::vector<double> tried = instants(impacts, end);
  for (const double instant : tried) {
    const auto after =
        std::upper_bound(run.points.begin(), run.points.end(), instant,
                         [](double time, const Point& point) { return time < point.time; });
    const auto last = static_cast<std::size_t>(after - run.points.begin());
    if (last < 2) {
      continue;
    }
    const auto sum = attributor.at(last - 1);
    const double share = sum ? amplified(*sum) : std::numeric_limits<double>::infinity();
    if (share <= little_amplified || (!best && share <= most_amplified)) {
      best = sum->result;
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
    best->reason = reason_to_end(*best, tried.back(), end, run.step);
  }
  return *best;
}

}  // namespace tautline::bench
