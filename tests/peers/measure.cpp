#include "measure.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <limits>
#include <span>

namespace tautline::peers {
namespace {

/// Of the calling process [s].
double processor_time() {
  return static_cast<double>(std::clock()) / static_cast<double>(CLOCKS_PER_SEC);
}

/// A measurement takes this long at least [s]: 2e4 times the clock's grain.
constexpr double long_enough = 0.02;

}  // namespace

Accuracy accuracy(Peer& peer, const std::vector<KnownMotion>& motions, const Effort& effort) {
  Accuracy result{};
  std::vector<double> errors;
  for (const KnownMotion& motion : motions) {
    const std::vector<Located> found = peer.impacts(motion.the_case, motion.stop, effort);
    result.of += motion.impacts.size();
    std::size_t index = 0;
    for (; index < std::min(found.size(), motion.impacts.size()); ++index) {
      const double error = std::abs(found[index].time - motion.impacts[index].time);
      if (error > other_impact || found[index].cables != motion.impacts[index].cables) {
        break;
      }
      errors.push_back(error);
      result.first = index == 0 ? std::max(result.first, error) : result.first;
    }
    result.followed += index;
    if (index == 0) {
      result.first = std::numeric_limits<double>::infinity();
    }
  }
  std::sort(errors.begin(), errors.end());
  result.median =
      errors.empty() ? std::numeric_limits<double>::infinity() : errors[errors.size() / 2];
  return result;
}

double cost(Peer& peer, const std::vector<KnownMotion>& motions, const Effort& effort) {
  std::size_t impacts = 0;
  const double start = processor_time();
  double spent = 0.0;
  do {
    for (const KnownMotion& motion : motions) {
      impacts += peer.impacts(motion.the_case, motion.stop, effort).size();
    }
    spent = processor_time() - start;
  } while (spent < long_enough);
  return 1e9 * spent / static_cast<double>(impacts);
}

Missed missed(Peer& peer, const std::vector<Graze>& arcs, const Effort& effort) {
  Missed result;
  for (const Graze& arc : std::span(arcs).first(std::min(arcs.size(), peer.most_arcs()))) {
    const auto band =
        static_cast<std::size_t>(std::find_if(depth_bands.begin(), depth_bands.end(),
                                              [&](double least) { return arc.depth >= least; }) -
                                 depth_bands.begin());
    ++result.of[band];
    if (!has_graze(arc, peer.impacts(arc.the_case, stop_of(arc), effort))) {
      ++result.missed[band];
    }
  }
  return result;
}

}  // namespace tautline::peers
