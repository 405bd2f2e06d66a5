#pragma once

#include <vector>

#include "bench/measure/metrics.hpp"
#include "tautline/elastic_contacts.hpp"

namespace tautline::bench {

/// Which contacts are counted: near a lock many begin slowly. A cable that is taut at the start may
/// never begin another.
struct CountedContacts {
  double speed;  // those that begin faster [m/s]
  double start;  // and those that begin up to here [s]: an engine's may begin a step or two late
  double end;    // but none that begins later [s]
};

/// Pairs the contacts of elastic cables of the exact motion and of a run, both by rising entry. A
/// pair is of one cable, each the other's nearest by its entry; one that has not ended on either
/// side is compared by its peak alone.
[[nodiscard]] ContactMatch match_contacts(const std::vector<ElasticContact>& exact,
                                          const std::vector<ElasticContact>& found,
                                          const CountedContacts& counted);

}  // namespace tautline::bench
