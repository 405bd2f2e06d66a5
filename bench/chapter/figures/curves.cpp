#include "bench/chapter/figures/curves.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "bench/base/listed.hpp"

namespace tautline::bench {
namespace {

struct Point {
  double x;
  double y;
};
using Points = std::vector<Point>;

/// A curve may be off by so much of its extent: less than a pixel of a large plot.
constexpr double invisible = 5e-4;

/// How far `point` is from the line through `one` and `other`, or from `one` if they coincide.
double distance(const Point& point, const Point& one, const Point& other) {
  const double x = other.x - one.x;
  const double y = other.y - one.y;
  const double length = std::hypot(x, y);
  return length > 0.0 ? std::abs(x * (point.y - one.y) - y * (point.x - one.x)) / length
                      : std::hypot(point.x - one.x, point.y - one.y);
}

/// The points that a polygon needs to stay within `tolerance` of `curve` (Ramer, Douglas and
/// Peucker): the corners at impacts stay.
Points polygon(const Points& curve, double tolerance) {
  std::vector<bool> kept(curve.size(), false);
  std::vector<std::pair<std::size_t, std::size_t>> open = {{0, curve.size() - 1}};
  while (!open.empty()) {
    const auto [first, last] = open.back();
    open.pop_back();
    kept[first] = kept[last] = true;
    std::size_t farthest = first;
    double largest = tolerance;
    for (std::size_t index = first + 1; index < last; ++index) {
      const double away = distance(curve[index], curve[first], curve[last]);
      if (away > largest) {
        largest = away;
        farthest = index;
      }
    }
    if (farthest != first) {
      open.emplace_back(first, farthest);
      open.emplace_back(farthest, last);
    }
  }
  Points result;
  for (std::size_t index = 0; index < curve.size(); ++index) {
    if (kept[index]) {
      result.push_back(curve[index]);
    }
  }
  return result;
}

/// `curve` with both axes drawn to their own extents in mind, in at most `most_points`.
Points thinned(const Points& curve) {
  if (curve.size() < 3) {
    return curve;
  }
  const auto by_x = [](const Point& one, const Point& two) { return one.x < two.x; };
  const auto by_y = [](const Point& one, const Point& two) { return one.y < two.y; };
  const auto [left, right] = std::minmax_element(curve.begin(), curve.end(), by_x);
  const auto [low, high] = std::minmax_element(curve.begin(), curve.end(), by_y);
  const double width = right->x > left->x ? right->x - left->x : 1.0;
  const double height = high->y > low->y ? high->y - low->y : 1.0;
  Points drawn;
  drawn.reserve(curve.size());
  for (const Point& point : curve) {
    drawn.push_back({point.x / width, point.y / height});
  }
  double tolerance = invisible;
  Points result = polygon(drawn, tolerance);
  while (result.size() > most_points) {
    tolerance *= 1.5;
    result = polygon(drawn, tolerance);
  }
  for (Point& point : result) {
    point = {point.x * width, point.y * height};
  }
  return result;
}

/// The fastest `most_points` impacts in the order of time.
Points fastest(Points impacts) {
  if (impacts.size() > most_points) {
    const auto cut = impacts.begin() + static_cast<std::ptrdiff_t>(most_points);
    std::nth_element(impacts.begin(), cut, impacts.end(),
                     [](const Point& one, const Point& two) { return one.y > two.y; });
    impacts.erase(cut, impacts.end());
    std::sort(impacts.begin(), impacts.end(),
              [](const Point& one, const Point& two) { return one.x < two.x; });
  }
  return impacts;
}

Points points_of(const FigureData& data, std::size_t x, std::size_t y) {
  Points points;
  for (const DataRow& row : data.rows) {
    points.push_back({row.numbers[x], row.numbers[y]});
  }
  return points;
}

Curve curve_of(const std::string& name, const Points& points) {
  Curve curve{name, {}, {}};
  for (const Point& point : points) {
    curve.x.push_back(point.x);
    curve.y.push_back(point.y);
  }
  return curve;
}

}  // namespace

std::vector<Curve> figure_curves(const ChapterFigure& figure) {
  if (!figure.by) {
    const Points motion = points_of(figure.data, figure.x, figure.y);
    return {curve_of("case " + figure.case_number, thinned(motion))};
  }
  std::map<std::size_t, Points> of_cable;
  for (const DataRow& row : figure.data.rows) {
    const auto cable = static_cast<std::size_t>(row.numbers[*figure.by]);
    of_cable[cable].push_back({row.numbers[figure.x], row.numbers[figure.y]});
  }
  return listed(of_cable, [](const auto& one) {
    return curve_of("cable " + std::to_string(one.first), fastest(one.second));
  });
}

Curve boundary_curve(const Boundary& boundary) {
  return curve_of("boundary at angle 0",
                  thinned(points_of(boundary.data, boundary_column::x, boundary_column::lowest)));
}

}  // namespace tautline::bench
