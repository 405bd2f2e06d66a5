#include "bench/run/calibration/reach.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace tautline::bench {
namespace {

/// The strikes on one side of which the restitution stays.
struct Beyond {
  double nearest = 0.0;        // [-], what all of them reach
  std::vector<double> speeds;  // [m/s]
  std::vector<double> arms;    // [m]
  std::vector<double> spins;   // [-], their parts of the speed

  void add(const Strike& strike, double reached, const std::function<bool(double, double)>& less) {
    nearest = speeds.empty() || less(reached, nearest) ? reached : nearest;
    speeds.push_back(strike.speed);
    arms.push_back(strike.arm);
    spins.push_back(strike.spin_part);
  }
};

/// " at arms of 0.1 m", " at closing speeds of 0.05 to 0.17 m/s"; "" where `some` are as wide as
/// `all`.
std::string where(const char* what, const char* unit, const std::vector<double>& some,
                  const std::vector<double>& all) {
  const auto [low, high] = std::minmax_element(some.begin(), some.end());
  const auto [lowest, highest] = std::minmax_element(all.begin(), all.end());
  if (*low == *lowest && *high == *highest) {
    return "";
  }
  return *low == *high ? fmt::format(" at {} of {:.2g}{}", what, *low, unit)
                       : fmt::format(" at {} of {:.2g} to {:.2g}{}", what, *low, *high, unit);
}

}  // namespace

void Reach::include(double restitution) {
  if (std::isfinite(restitution)) {
    lowest = std::min(lowest, restitution);
    highest = std::max(highest, restitution);
  }
}

std::vector<std::string> sentences_of(const std::vector<Strike>& strikes,
                                      const std::vector<Reach>& reach, double wanted,
                                      double tolerance) {
  Beyond above;
  Beyond below;
  Beyond all;
  for (std::size_t index = 0; index < strikes.size(); ++index) {
    all.add(strikes[index], 0.0, std::less());
    if (reach[index].highest < wanted - tolerance) {
      above.add(strikes[index], std::max(0.0, reach[index].highest), std::less());
    } else if (reach[index].lowest > wanted + tolerance) {
      below.add(strikes[index], reach[index].lowest, std::greater());
    }
  }
  std::vector<std::string> result;
  const auto tell = [&](const Beyond& side, const char* word) {
    if (!side.speeds.empty()) {
      result.push_back(fmt::format("e {} {:.3g} is not reached at this step{}{}{}", word,
                                   side.nearest,
                                   where("closing speeds", " m/s", side.speeds, all.speeds),
                                   where("arms", " m", side.arms, all.arms),
                                   where("spin's parts", "", side.spins, all.spins)));
    }
  };
  tell(above, "above");
  tell(below, "below");
  return result;
}

}  // namespace tautline::bench
