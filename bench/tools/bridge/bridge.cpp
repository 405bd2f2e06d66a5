#include "bench/tools/bridge/bridge.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>
#include <variant>

#include "bench/base/statistics.hpp"
#include "bench/base/text.hpp"
#include "tautline/elastic_contacts.hpp"
#include "tautline/solve.hpp"
#include "tautline/system.hpp"
#include "tautline/system_geometry.hpp"

namespace tautline::bench {
namespace {

/// The softest chosen stiffness has this many radians of its frequency in the shortest time between
/// impacts: a contact, about 3 radians, takes 3 % of it.
constexpr double radians_between_impacts = 100.0;

/// The part of the mean time between impacts that counts as the shortest one at least [-]: two
/// that all but coincide would ask for a stiffness without end.
constexpr double least_part_between = 0.1;

/// Times at which positions are compared: 100 between impacts miss the largest difference by less
/// than a hundredth of it.
constexpr int compared_times = 1000;

/// Why a cable cannot become elastic, as the end of a sentence; "": it can.
template <int D>
std::string obstacle(const BasicCableOfSystem<double, D>& cable) {
  if (cable.elasticity) {
    return "is elastic already; a bridge makes all cables elastic, from inextensible ones";
  }
  if (!cable.restitution_table.empty()) {
    return "has a restitution that depends on the speed, to which no one damping ratio belongs";
  }
  if (!(cable.restitution > 0.0)) {
    return "has restitution 0, to which no damping ratio belongs: it would be infinite";
  }
  return "";
}

/// The first impacts of a motion that contacts of single cables can come in place of.
struct LeadingImpacts {
  std::vector<BridgeImpact> impacts;
  double next = 0.0;  // [s], of the event after them, or of the end
  std::string why;    // a sentence: what that event is; "": no more impacts were asked for
};

template <int D>
LeadingImpacts leading_impacts(const BasicSystem<double, D>& system,
                               const BasicSolution<BasicSystem<double, D>>& solution,
                               std::size_t most) {
  LeadingImpacts result;
  result.next = solution.end_time();
  for (const auto& event : solution.events()) {
    if (result.impacts.size() == most) {
      result.next = event.time;
      break;
    }
    const std::string at = fmt::format("at t = {:.6g} ", event.time);
    if (event.kind != EventKind::impact) {
      result.why = at + (event.kind == EventKind::taut ? "cables stay taut" : "cables are let go");
    } else if (event.cables.size() > 1) {
      result.why = at +
                   "several cables take part in an impact, and how elastic ones share it depends "
                   "on the ratios of their stiffnesses";
    } else if (const std::size_t cable = event.cables.indices().front();
               !(gap_rate(system.cables[cable], event.after) > 0.0)) {
      result.why = at + fmt::format("cable {} does not rebound", cable);
    } else {
      result.impacts.push_back({event.time, cable});
      continue;
    }
    result.next = event.time;
    break;
  }
  return result;
}

/// How many contacts come in place of `impacts`, in their order, each after the end of the one
/// before.
std::size_t in_place(const std::vector<BridgeImpact>& impacts,
                     const std::vector<ElasticContact>& contacts) {
  std::size_t count = 0;
  double free_since = 0.0;
  while (count < impacts.size() && count < contacts.size() && contacts[count].exit &&
         contacts[count].cable == impacts[count].cable && contacts[count].entry >= free_since) {
    free_since = *contacts[count].exit;
    ++count;
  }
  return count;
}

/// The exponent with which `member` of the rows falls; none where it is 0.
std::optional<double> exponent(const std::vector<BridgeRow>& rows, double BridgeRow::*member) {
  std::vector<double> across;
  std::vector<double> up;
  for (const BridgeRow& row : rows) {
    if (!(row.*member > 0.0)) {
      return std::nullopt;
    }
    across.push_back(row.stiffness);
    up.push_back(row.*member);
  }
  return slope(across, up);
}

/// Solves both kinds of motion of one system.
template <int D>
class BridgeComparison {
 public:
  using TheSystem = BasicSystem<double, D>;
  using TheSolution = BasicSolution<TheSystem>;

  BridgeComparison(const TheSystem& system, const BridgeOptions& options)
      : system_(system),
        options_(options),
        inextensible_(solve(system)),
        leading_(leading_impacts(system, inextensible_, options.impacts)) {}

  BridgeReading run() {
    if (leading_.impacts.empty()) {
      const bool quiet = inextensible_.events().empty();
      return {std::nullopt,
              "there is no impact to compare: " +
                  (quiet ? fmt::format("nothing happens until t = {:.6g}", inextensible_.end_time())
                         : leading_.why)};
    }
    for (const double stiffness : stiffnesses()) {
      TheSystem elastic = with_stiffness(stiffness);
      if (const auto wrong = tautline::problems(elastic); !wrong.empty()) {
        if (options_.softest == 0.0 && motions_.size() >= 2) {
          break;  // chosen too stiff for the duration
        }
        return {std::nullopt,
                fmt::format("with a stiffness of {:g} N/m: {}", stiffness, wrong.front())};
      }
      motions_.push_back({stiffness, solve(elastic), {}});
      if (const TheSolution& solution = motions_.back().solution;
          solution.end_time() < elastic.duration) {
        return {std::nullopt,
                fmt::format("with a stiffness of {:g} N/m the motion ends at t = {:.6g} ({}), "
                            "before the impacts that are to be compared",
                            stiffness, solution.end_time(), to_string(solution.ending()))};
      }
      motions_.back().contacts = elastic_contacts(motions_.back().solution);
    }
    Bridge bridge;
    bridge.name = system_.name;
    bridge.why = leading_.why;
    for (const auto& cable : system_.cables) {
      bridge.cables.push_back({cable.restitution, damping_ratio_of(cable.restitution)});
    }
    bridge.impacts = leading_.impacts;
    if (const std::string problem = drop_unmatched(bridge); !problem.empty()) {
      return {std::nullopt, problem};
    }
    // a contact changes what comes after it: half of the flight after the last one is compared
    const std::size_t count = bridge.impacts.size();
    const double after =
        count < leading_.impacts.size() ? leading_.impacts[count].time : leading_.next;
    bridge.until = (bridge.impacts.back().time + after) / 2.0;
    for (const Motion& motion : motions_) {
      bridge.rows.push_back(row_of(bridge, motion));
    }
    bridge.deviation_slope = exponent(bridge.rows, &BridgeRow::deviation);
    // the first contact begins with its impact: alone, its shift is rounding
    if (count > 1) {
      bridge.shift_slope = exponent(bridge.rows, &BridgeRow::shift);
    }
    return {bridge, ""};
  }

 private:
  struct Motion {
    double stiffness;  // [N/m]
    TheSolution solution;
    std::vector<ElasticContact> contacts;
  };

  /// The shortest time from an impact that is compared to the event after it, as it counts [s].
  [[nodiscard]] double between_impacts() const {
    const std::vector<BridgeImpact>& impacts = leading_.impacts;
    double shortest_one = leading_.next - impacts.back().time;
    for (std::size_t index = 1; index < impacts.size(); ++index) {
      shortest_one = std::min(shortest_one, impacts[index].time - impacts[index - 1].time);
    }
    const double mean =
        (leading_.next - impacts.front().time) / static_cast<double>(impacts.size());
    return std::max(shortest_one, least_part_between * mean);
  }

  /// From the softest on by factors of ten [N/m].
  [[nodiscard]] std::vector<double> stiffnesses() const {
    double softest = options_.softest;
    double decades = std::log10(options_.stiffest / options_.softest);
    if (!(softest > 0.0)) {
      double mass = std::numeric_limits<double>::infinity();
      for (const auto& body : system_.bodies) {
        mass = std::min(mass, body.mass);
      }
      const double frequency = radians_between_impacts / between_impacts();
      softest = std::pow(10.0, std::round(std::log10(mass * frequency * frequency)));
      decades = chosen_decades;
    }
    std::vector<double> result;
    constexpr double rounding = 1e-9;  // of a logarithm
    for (int power = 0; power <= decades + rounding; ++power) {
      result.push_back(softest * std::pow(10.0, power));
    }
    return result;
  }

  /// The system up to the event after the impacts that are compared, with all cables elastic.
  [[nodiscard]] TheSystem with_stiffness(double stiffness) const {
    TheSystem result = system_;
    result.duration = leading_.next;
    for (auto& cable : result.cables) {
      cable.elasticity.emplace();
      cable.elasticity->stiffness = {stiffness};
      cable.elasticity->damping_ratio = damping_ratio_of(cable.restitution);
      cable.restitution = 1.0;  // it has no impacts: the numbers of an elastic cable that is given
      cable.capture_speed = 0.0;
    }
    return result;
  }

  /// Leaves out the impacts in whose place no contact comes at some stiffness. A sentence where
  /// none is left.
  std::string drop_unmatched(Bridge& bridge) const {
    for (const Motion& motion : motions_) {
      const std::size_t count = in_place(bridge.impacts, motion.contacts);
      if (count == bridge.impacts.size()) {
        continue;
      }
      bridge.why = fmt::format(
          "with {:g} N/m no whole contact of one cable comes in the place of impact {}; a larger "
          "stiffness has more of them",
          motion.stiffness, count + 1);
      bridge.impacts.resize(count);
    }
    return bridge.impacts.empty() ? bridge.why : "";
  }

  [[nodiscard]] BridgeRow row_of(const Bridge& bridge, const Motion& motion) const {
    BridgeRow row{motion.stiffness, 0.0, 0.0, 0.0, {}};
    for (std::size_t index = 0; index < bridge.impacts.size(); ++index) {
      const ElasticContact& contact = motion.contacts[index];
      const BridgeImpact& impact = bridge.impacts[index];
      const BridgeContact compared{
          contact.entry - impact.time,
          contact.exit_speed / contact.entry_speed - bridge.cables[impact.cable].restitution};
      row.shift = std::max(row.shift, std::abs(compared.shift));
      row.restitution_error = std::max(row.restitution_error, std::abs(compared.restitution_error));
      row.contacts.push_back(compared);
    }
    for (int index = 1; index <= compared_times; ++index) {
      const double time = bridge.until * index / compared_times;
      const auto exact = inextensible_.at(time);
      const auto found = motion.solution.at(time);
      for (std::size_t body = 0; body < exact.bodies.size(); ++body) {
        row.deviation = std::max(
            row.deviation, (found.bodies[body].position - exact.bodies[body].position).norm());
      }
    }
    return row;
  }

  const TheSystem& system_;
  const BridgeOptions& options_;
  TheSolution inextensible_;
  LeadingImpacts leading_;
  std::vector<Motion> motions_;  // by rising stiffness
};

template <int D>
BridgeReading bridge_of_system(const BasicSystem<double, D>& system, const BridgeOptions& options) {
  for (std::size_t index = 0; index < system.cables.size(); ++index) {
    if (const std::string words = obstacle(system.cables[index]); !words.empty()) {
      return {std::nullopt, fmt::format("cable {} {}", index, words)};
    }
  }
  return BridgeComparison<D>(system, options).run();
}

}  // namespace

BridgeReading bridge_of(const AnyCase& any, const BridgeOptions& options) {
  return std::visit(
      [&](const auto& one) {
        if constexpr (std::is_same_v<std::decay_t<decltype(one)>, Case>) {
          return bridge_of_system(as_system(one), options);
        } else {
          return bridge_of_system(one, options);
        }
      },
      any);
}

}  // namespace tautline::bench
