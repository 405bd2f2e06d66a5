#include "tautline/accumulation.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>

#include "tautline/geometry.hpp"
#include "tautline/impact.hpp"

namespace tautline {
namespace {

/// Margin of the certificate: how many times its scale a derivative is allowed to be [-].
constexpr double certificate_margin = 20.0;

/// Bounces shared by several cables last longer than the slowest cable's own series: measured on
/// the 21 cases of Table 5.1, up to 2.3 times as long [-].
constexpr double several_cables = 4.0;

/// Size of the gaps' accelerations [m/s^2] and the rate [1/s] at which they change.
struct Scales {
  double acceleration;
  double rate;
};

Scales scales(const Case& the_case, const State& state) {
  const double speed = speed_scale(the_case, state);
  double shortest = the_case.cables.front().length;
  double radius = 0.0;
  for (const Cable& cable : the_case.cables) {
    shortest = std::min(shortest, cable.length);
    radius = std::max(radius, cable.attachment.norm());
  }
  Scales result{};
  result.acceleration =
      the_case.gravity.norm() + state.spin * state.spin * radius + speed * speed / shortest;
  result.rate = std::abs(state.spin) + speed / shortest + std::sqrt(result.acceleration / shortest);
  return result;
}

/// The gap rates of `cables` [m/s].
CableVector rates(const Case& the_case, const State& state, CableSet cables) {
  CableVector result(static_cast<Eigen::Index>(cables.size()));
  Eigen::Index row = 0;
  for (const std::size_t index : cables) {
    result[row++] = gap_rate(the_case.cables[index], state);
  }
  return result;
}

/// The state with the gap rates of `cables` removed, M-orthogonally (Eq. 18).
State projected(const Case& the_case, const State& state, CableSet cables) {
  const CableMatrix g = delassus(the_case, state, cables);
  const CableVector impulses =
      g.completeOrthogonalDecomposition().solve(-rates(the_case, state, cables));
  return with_impulses(the_case, state, cables, impulses);
}

/// How the bounces on a set of almost taut cables go on.
struct Bouncing {
  double speed;        // [m/s], the fastest rebound their normal energy allows
  double remaining;    // [s] until all bounces are over
  double uncertainty;  // [s] of `remaining`
};

/// From the normal energy of `cables` (Eq. 17) and the tensions that will hold them; none if a
/// tension is not certain to stay > 0 until the bounces are over.
std::optional<Bouncing> bouncing(const Case& the_case, const State& state, CableSet touching,
                                 CableSet cables, const CableVector& tension, const Scales& scale) {
  const CableMatrix g = delassus(the_case, state, cables);
  const CableVector rate = rates(the_case, state, cables);
  const CableVector pull = tension.cwiseProduct(g.diagonal());  // [m/s^2], what closes each cable
  double twice_energy = rate.dot(CableVector(g.completeOrthogonalDecomposition().solve(rate)));
  Eigen::Index row = 0;
  for (const std::size_t index : cables) {
    const double height = gap(the_case.cables[index], state);
    twice_energy += touching.contains(index) ? 0.0 : 2.0 * tension[row] * std::max(0.0, height);
    ++row;
  }
  Bouncing result{};
  row = 0;
  for (const std::size_t index : cables) {
    const double lost = 1.0 - the_case.cables[index].restitution;
    if (pull[row] <= 0.0 || lost <= 0.0) {
      return std::nullopt;
    }
    const double speed = std::sqrt(twice_energy * g(row, row));
    result.speed = std::max(result.speed, speed);
    result.remaining = std::max(result.remaining, 2.0 * speed / (pull[row] * lost));
    ++row;
  }
  const double change = scale.acceleration * scale.rate * result.remaining;  // of a pull, meanwhile
  if (!(pull.minCoeff() > certificate_margin * change)) {  // also where `change` overflows to NaN
    return std::nullopt;
  }
  if (cables.size() ==
      1) {  // a geometric series (Eq. 19); only the change of the pull is neglected
    result.uncertainty = result.remaining * change / pull.minCoeff();
  } else {  // how the cables hand the energy to each other is open: up to several_cables times that
    result.remaining *= 0.5 * several_cables;
    result.uncertainty = result.remaining;
  }
  return result;
}

/// The cables outside `cables` that could close within `remaining` [s].
CableSet within_reach(const Case& the_case, const State& state, CableSet cables, double remaining,
                      const Scales& scale) {
  CableSet result;
  for (std::size_t index = 0; index < the_case.cables.size(); ++index) {
    if (cables.contains(index)) {
      continue;
    }
    const Cable& cable = the_case.cables[index];
    const double closing = std::max(0.0, -gap_rate(cable, state));
    const double reach =
        closing * remaining + certificate_margin * scale.acceleration * remaining * remaining;
    if (gap(cable, state) <= reach) {
      result.insert(index);
    }
  }
  return result;
}

/// The touching cables slow enough to be candidates; empty if one of them is still closing.
CableSet slow_contacts(const Case& the_case, const State& state, const Touching& touching,
                       double capture_speed) {
  CableSet slow;
  for (const std::size_t index : touching.cables) {
    const double rate = gap_rate(the_case.cables[index], state);
    if (rate < -touching.rate_rounding) {
      return {};
    }
    if (rate <= capture_speed) {
      slow.insert(index);
    }
  }
  return slow;
}

/// Those of `cables` that `held` keeps at zero gap: pulled, or left there by the others.
CableSet staying(CableSet cables, const Tensions& held, const Scales& scale) {
  constexpr double rounding = 1e-12;  // [-], of an acceleration that is zero
  CableSet result;
  Eigen::Index row = 0;
  for (const std::size_t index : cables) {
    if (held.tension[row] > 0.0 || held.acceleration[row] <= rounding * scale.acceleration) {
      result.insert(index);
    }
    ++row;
  }
  return result;
}

/// True where every one of `cables` touches at zero rate.
bool all_rest(const Case& the_case, const State& state, const Touching& touching, CableSet cables) {
  return (touching.cables | cables) == touching.cables &&
         rates(the_case, state, cables).cwiseAbs().maxCoeff() <= touching.rate_rounding;
}

}  // namespace

std::optional<Capture> capture(const Case& the_case, const State& state, const Touching& touching,
                               double capture_speed) {
  CableSet cables = slow_contacts(the_case, state, touching, capture_speed);
  const Scales scale = scales(the_case, state);
  // a round loses cables that leave or gains one that takes part; few rounds settle it
  for (std::size_t round = 0; round < 2 * max_cables && !cables.empty(); ++round) {
    const State after = projected(the_case, state, cables);
    const std::optional<Tensions> held = resting_tensions(the_case, after, cables);
    if (!held || !held->tension.allFinite() || !held->acceleration.allFinite() ||
        !std::isfinite(energy(the_case, after))) {  // what overflows is not certain
      return std::nullopt;
    }
    if (const CableSet rest = staying(cables, *held, scale); rest != cables) {
      cables = rest;
      continue;
    }
    if (all_rest(the_case, state, touching, cables)) {
      return Capture{cables, 0.0, 0.0, after};
    }
    const auto bounces = bouncing(the_case, state, touching.cables, cables, held->tension, scale);
    if (!bounces || bounces->speed > capture_speed) {
      return std::nullopt;
    }
    const double latest = bounces->remaining + bounces->uncertainty;
    const CableSet near = within_reach(the_case, state, cables, latest, scale);
    if (near.empty()) {
      return Capture{cables, bounces->remaining, bounces->uncertainty, after};
    }
    cables = cables | near;
  }
  return std::nullopt;
}

}  // namespace tautline
