#include "bench/measure/contact_match.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "bench/base/listed.hpp"
#include "bench/measure/impact_match.hpp"

namespace tautline::bench {
namespace {

std::vector<ElasticContact> those_of(const CountedContacts& counted,
                                     const std::vector<ElasticContact>& all) {
  std::vector<ElasticContact> result;
  std::ranges::copy_if(all, std::back_inserter(result), [&](const ElasticContact& one) {
    return one.entry_speed > counted.speed || one.entry <= counted.start;
  });
  return result;
}

std::vector<CountedImpact> entries(const std::vector<ElasticContact>& contacts) {
  return listed(contacts, [](const ElasticContact& one) {
    return CountedImpact{one.entry, one.cable};
  });
}

constexpr double rounding = 1e-12;  // [-], of an instant

double percent_off(double found, double exact) { return 100.0 * std::abs(found / exact - 1.0); }

void raise(std::optional<double>& worst, double error) {
  worst = std::max(worst.value_or(0.0), error);
}

/// True where the contact goes on to the cut of its cable: its exit speed is no rebound.
bool is_cut(const ElasticContact& one, const CountedContacts& counted) {
  return one.cable < counted.cuts.size() && one.exit && *one.exit >= counted.cuts[one.cable];
}

}  // namespace

ContactMatch match_contacts(const std::vector<ElasticContact>& exact,
                            const std::vector<ElasticContact>& found,
                            const CountedContacts& counted) {
  const std::vector<ElasticContact> right = those_of(counted, exact);
  const std::vector<ElasticContact> of_run = those_of(counted, found);
  const ImpactPairs pairs = match_impacts(entries(right), entries(of_run));
  const ImpactMatch counts = impacts_until(counted.end, entries(right), entries(of_run), pairs);
  // a peak at the end of the motion may be a rounding later
  const double last_instant = counted.end * (1.0 + rounding);
  ContactMatch result;
  result.exact = counts.exact;
  result.found = counts.found;
  result.matched = counts.matched;
  for (const auto& [i, j] : pairs) {
    const ElasticContact& one = right[i];
    const ElasticContact& other = of_run[j];
    if (one.entry > counted.end) {
      continue;
    }
    if (one.peak_time <= last_instant) {
      if (!result.peak || one.peak > result.peak->exact) {
        result.peak = ExactAndFound{one.peak, other.peak};
      }
      raise(result.peak_error, percent_off(other.peak, one.peak));
    }
    if (!one.exit || !other.exit || *one.exit > counted.end) {
      continue;
    }
    raise(result.impulse_error, percent_off(other.impulse, one.impulse));
    raise(result.time_error, percent_off(*other.exit - other.entry, *one.exit - one.entry));
    if (std::min(one.entry_speed, other.entry_speed) > counted.speed && !is_cut(one, counted) &&
        !is_cut(other, counted)) {
      raise(result.restitution_error,
            std::abs(other.exit_speed / other.entry_speed - one.exit_speed / one.entry_speed));
    }
  }
  return result;
}

}  // namespace tautline::bench
