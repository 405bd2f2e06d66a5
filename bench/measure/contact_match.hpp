#pragma once

#include <vector>

#include "bench/measure/metrics.hpp"
#include "tautline/elastic_contacts.hpp"

namespace tautline::bench {

/// The contacts of elastic cables that begin up to `end` [s] and faster than `count_speed` [m/s],
/// of the exact motion and of a run, both by rising entry. A pair is of one cable, each the other's
/// nearest by its entry; one that has not ended on either side is compared by its peak alone.
[[nodiscard]] ContactMatch match_contacts(const std::vector<ElasticContact>& exact,
                                          const std::vector<ElasticContact>& found,
                                          double count_speed, double end);

}  // namespace tautline::bench
