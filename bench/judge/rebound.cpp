#include "bench/judge/rebound.hpp"

#include <algorithm>
#include <cmath>

#include "bench/base/listed.hpp"
#include "bench/base/statistics.hpp"
#include "bench/measure/audit_lost.hpp"

namespace tautline::bench {
namespace {

/// An impact is off by more than this many times what its step explains, and this much [-]. Over
/// 13,938 impacts of sound models the most is 0.97 times; half above that no threshold misses a
/// fault that 1.0 finds.
constexpr double beyond = 1.5;
constexpr double least_deviation = 0.002;

/// So many readable impacts have a word; of fewer only a proof of a fault says something.
constexpr std::size_t enough = 3;

/// Parts [-]: of the readable ones that are off to one side, of those that are lost.
constexpr double most = 0.8;
constexpr double half = 0.5;
/// A cable that stays taut where few of the readable ones come back rebounds nowhere [-].
constexpr double few = 0.3;

using Impacts = std::vector<AuditedImpact>;

bool is_off(const AuditedImpact& impact) {
  return std::abs(impact.deviation()) > beyond * impact.rate_floor / impact.speed + least_deviation;
}

bool is_lost(const AuditedImpact& impact) {
  return impact.requested >= asking && impact.effective < lost_part * impact.requested;
}

double part(std::size_t count, std::size_t all) {
  return static_cast<double>(count) / static_cast<double>(all);
}

template <class Is>
std::size_t count_of(const Impacts& impacts, const Is& is) {
  return static_cast<std::size_t>(std::count_if(impacts.begin(), impacts.end(), is));
}

/// The restitution that all impacts ask for; none where they ask for several.
std::optional<double> asked_by(const Impacts& impacts) {
  const auto other = [&](const AuditedImpact& impact) {
    return impact.requested != impacts.front().requested;
  };
  return impacts.empty() || std::any_of(impacts.begin(), impacts.end(), other)
             ? std::nullopt
             : std::optional(impacts.front().requested);
}

/// The speed up to which most impacts are lost; none where it is not so.
std::optional<double> lost_up_to(const Impacts& impacts) {
  double fastest = 0.0;
  std::size_t lost = 0;
  for (const AuditedImpact& impact : impacts) {
    if (is_off(impact) && is_lost(impact)) {
      fastest = std::max(fastest, impact.speed);
      ++lost;
    }
  }
  const std::size_t below =
      count_of(impacts, [fastest](const AuditedImpact& impact) { return impact.speed <= fastest; });
  return lost > 0 && part(lost, below) >= most ? std::optional(fastest) : std::nullopt;
}

/// The word where some impacts are off.
Rebound word_on(const Impacts& impacts, Rebounds& result) {
  const auto off_and = [](const auto& also) {
    return [&also](const AuditedImpact& impact) { return is_off(impact) && also(impact); };
  };
  const auto lost_and_off = off_and(is_lost);
  const std::size_t lost = count_of(impacts, lost_and_off);
  if (lost > 0 && part(lost, result.off) >= most) {
    if (lost == impacts.size()) {
      return Rebound::none;
    }
    result.speed = lost_up_to(impacts);
    return result.speed ? Rebound::lost_below : Rebound::loses_some;
  }
  // what is lost below a speed says nothing of the others
  result.speed = lost_up_to(impacts);
  Impacts others = impacts;
  std::erase_if(others, [&](const AuditedImpact& impact) {
    return result.speed && is_off(impact) && is_lost(impact);
  });
  const auto above = [](const AuditedImpact& impact) { return impact.deviation() > 0.0; };
  const std::size_t off = count_of(others, is_off);
  const std::size_t high = count_of(others, off_and(above));
  const bool one_side = part(std::max(high, off - high), off) >= most;
  if (!one_side || part(off, others.size()) < half) {
    return Rebound::scatters;
  }
  std::erase_if(others, [](const AuditedImpact& impact) { return !is_off(impact); });
  result.off = off;
  result.deviation = median(listed(others, &AuditedImpact::deviation));
  return Rebound::off;
}

}  // namespace

Rebounds rebounds_of(const std::vector<AuditedImpact>& impacts,
                     const std::optional<StaysTaut>& stuck) {
  Rebounds result;
  result.readable = impacts.size();
  result.asked = asked_by(impacts);
  if (!impacts.empty()) {
    result.slowest =
        std::min_element(impacts.begin(), impacts.end(), [](const auto& one, const auto& two) {
          return one.speed < two.speed;
        })->speed;
    result.deviation = median(listed(impacts, &AuditedImpact::deviation));
    result.steps = median(listed(
        impacts, [](const AuditedImpact& impact) { return static_cast<double>(impact.steps); }));
  }
  result.off = count_of(impacts, is_off);
  const std::size_t back =
      count_of(impacts, [](const AuditedImpact& impact) { return !is_lost(impact); });
  if (stuck &&
      static_cast<double>(back) < std::max(1.0, few * static_cast<double>(impacts.size()))) {
    result.word = Rebound::none;
    result.speed = stuck->speed;
    result.stays_taut = true;
  } else if (result.off > 0) {
    result.word = word_on(impacts, result);
  } else {
    result.word = result.readable >= enough ? Rebound::kept : Rebound::too_few;
  }
  return result;
}

}  // namespace tautline::bench
