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
  std::vector<double> cuts = {};  // when each cable is cut [s], infinite: never; empty: none is
};

/// Pairs the contacts of elastic cables of the exact motion and of a run, both by rising entry. A
/// pair is of one cable, each the other's nearest by its entry. Peaks are compared where the exact
/// one comes by `end`; impulses, durations and restitutions where both contacts have ended, the
/// exact one by `end`. A contact that a cut ends has no restitution.
[[nodiscard]] ContactMatch match_contacts(const std::vector<ElasticContact>& exact,
                                          const std::vector<ElasticContact>& found,
                                          const CountedContacts& counted);

}  // namespace tautline::bench
