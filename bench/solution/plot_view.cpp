// The geometry of a picture: what it must show, round numbers for its axes, hulls and sags.

#include "bench/solution/plot_view.hpp"

#include <algorithm>
#include <cmath>

#include "tautline/geometry.hpp"

namespace tautline::bench {
namespace {

/// Room around the points, as a share of the larger side [-].
constexpr double margin = 0.06;

/// Coordinates are cut here: differences and squares of them stay finite [m].
constexpr double largest_coordinate = 1e150;

}  // namespace

void Extent::add(const Vec2& point) {
  if (!point.allFinite()) {
    return;
  }
  const Vec2 inside = point.cwiseMax(-largest_coordinate).cwiseMin(largest_coordinate);
  low_ = empty_ ? inside : Vec2(low_.cwiseMin(inside));
  high_ = empty_ ? inside : Vec2(high_.cwiseMax(inside));
  empty_ = false;
}

Extent Extent::with_margin() const {
  constexpr double thinnest = 0.25;  // of the larger side: a motion on a line needs room too [-]
  const double scale = std::max({low_.cwiseAbs().maxCoeff(), high_.cwiseAbs().maxCoeff(), 1e-150});
  // a body that does not move has no extent; below this, coordinates are not told apart
  const double larger = std::max(size().maxCoeff(), 1e-9 * scale);
  Extent result = *this;
  for (int axis = 0; axis < 2; ++axis) {
    const double missing = std::max(0.0, thinnest * larger - size()[axis]);
    result.low_[axis] -= 0.5 * missing + margin * larger;
    result.high_[axis] += 0.5 * missing + margin * larger;
  }
  return result;
}

double round_below(double length) {
  const double power = std::pow(10.0, std::floor(std::log10(length)));
  for (const double digit : {5.0, 2.0}) {
    if (digit * power <= length) {
      return digit * power;
    }
  }
  return power;
}

std::vector<double> ticks(double low, double size) {
  constexpr double fewest = 3.5;  // intervals
  const double step = round_below(size / fewest);
  std::vector<double> result;
  const double first = std::ceil(low / step);
  constexpr int most = 20;  // where the steps are lost in the size of the numbers
  for (int index = 0; index < most && (first + index) * step <= low + size; ++index) {
    result.push_back((first + index) * step);
  }
  return result;
}

double sag(double length, double chord) {
  return chord < length ? std::sqrt(3.0 / 16.0) * std::sqrt((length - chord) * (length + chord))
                        : 0.0;
}

std::vector<Vec2> convex_hull(std::vector<Vec2> points) {
  std::sort(points.begin(), points.end(), [](const Vec2& a, const Vec2& b) {
    return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
  });
  std::vector<Vec2> hull;
  // points of one line, which rounding has moved off it, stay on it [m^2]
  const double in_line =
      points.empty() ? 0.0 : 1e-9 * (points.back() - points.front()).squaredNorm();
  const auto go_round = [&](auto first, auto last) {  // Andrew's monotone chain, one half
    const std::size_t start = hull.size();
    for (; first != last; ++first) {
      while (hull.size() >= start + 2 &&
             cross<double>(hull.back() - hull[hull.size() - 2], *first - hull.back()) <= in_line) {
        hull.pop_back();
      }
      hull.push_back(*first);
    }
    hull.pop_back();  // begins the other half
  };
  if (points.size() < 3) {
    return points;
  }
  go_round(points.begin(), points.end());
  go_round(points.rbegin(), points.rend());
  return hull;
}

}  // namespace tautline::bench
