#include "bench/ensemble/largest_tension.hpp"

#include <algorithm>
#include <array>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace tautline::bench {
namespace {

/// The tension of the only taut cable along an arc: what gives the body the part of its
/// acceleration that gravity does not, whatever its attachment.
class TensionOfOne {
 public:
  TensionOfOne(const Solution& solution, const Arc& arc)
      : arc_(arc), mass_(solution.system().body.mass), gravity_(solution.gravity()) {}

  /// [N], `dt` [s] after the start of the arc.
  [[nodiscard]] double at(double dt) const {
    Vec2 acceleration = Vec2::Zero();
    for (Eigen::Index k = arc_.series.rows() - 1; k >= 2; --k) {
      acceleration = acceleration * dt + factor(k) * coefficient(k);
    }
    return mass_ * (acceleration - gravity_).norm();
  }

  /// A bound of it over the first `length` [s] [N], its rounding included.
  [[nodiscard]] double most(double length) const {
    const Eigen::Index terms = arc_.series.rows();
    if (terms < 3) {  // at rest
      return mass_ * gravity_.norm();
    }
    const double* const x = arc_.series.data();
    const double* const y = x + terms;
    double rest = 0.0;
    auto k = static_cast<double>(terms - 1);
    for (Eigen::Index term = terms - 1; term >= 3; --term, k -= 1.0) {
      rest = (rest + k * (k - 1.0) * (std::abs(x[term]) + std::abs(y[term]))) * length;
    }
    constexpr double rounding = 1.0 + 1e-12;
    return rounding * mass_ * ((2.0 * coefficient(2) - gravity_).norm() + rest);
  }

 private:
  /// Of a coefficient in the second derivative.
  static double factor(Eigen::Index k) { return static_cast<double>(k * (k - 1)); }
  [[nodiscard]] Vec2 coefficient(Eigen::Index k) const {
    return {arc_.series(k, 0), arc_.series(k, 1)};
  }

  const Arc& arc_;
  double mass_;
  Vec2 gravity_;
};

/// Tensions at both ends of an arc, and at as many places between.
constexpr std::size_t parts_of_arc = 4;
using Nodes = std::array<double, parts_of_arc + 1>;

/// True where the polynomial through `nodes` rises at its start, whatever their distance.
bool rises(const Nodes& nodes) {
  return -25.0 * nodes[0] + 48.0 * nodes[1] - 36.0 * nodes[2] + 16.0 * nodes[3] - 3.0 * nodes[4] >
         0.0;
}

/// The largest value of the smooth function `tension` from 0 to `length` [s], or `known` if that is
/// larger. An arc is a small part of the radius of convergence: the tension turns once or twice.
template <class Tension>
double largest_along(const Tension& tension, const Nodes& nodes, double length, double known) {
  const auto [least, most] = std::minmax_element(nodes.begin(), nodes.end());
  double largest = std::max(known, *most);
  constexpr double rounding = 1e-13;  // [-], of a tension that is constant, as in a circle
  if (*most - *least <= rounding * *most) {
    return largest;
  }
  for (std::size_t k = 0; k <= parts_of_arc; ++k) {
    const bool is_first = k == 0;
    const bool is_last = k == parts_of_arc;
    const bool from_before = is_first ? rises(nodes) : nodes[k] >= nodes[k - 1];
    const bool to_after = is_last ? rises({nodes[4], nodes[3], nodes[2], nodes[1], nodes[0]})
                                  : nodes[k] >= nodes[k + 1];
    if (!from_before || !to_after) {
      continue;
    }
    const double low = length * static_cast<double>(is_first ? k : k - 1) / parts_of_arc;
    const double high = length * static_cast<double>(is_last ? k : k + 1) / parts_of_arc;
    constexpr int half_of_digits = 26;  // the tension is flat there
    std::uintmax_t tries = 100;         // the golden section alone needs no more
    const auto found = boost::math::tools::brent_find_minima(
        [&](double dt) { return -tension(dt); }, low, high, half_of_digits, tries);
    largest = std::max(largest, -found.second);
  }
  return largest;
}

double largest_of_one(const Solution& solution, const Arc& arc, double known) {
  const TensionOfOne tension(solution, arc);
  const double length = arc.end - arc.start;
  if (!(tension.most(length) > known)) {
    return known;
  }
  Nodes nodes{};
  for (std::size_t k = 0; k <= parts_of_arc; ++k) {
    nodes[k] = tension.at(length * static_cast<double>(k) / parts_of_arc);
  }
  return largest_along([&](double dt) { return tension.at(dt); }, nodes, length, known);
}

double largest_of_several(const Solution& solution, const Arc& arc, double known) {
  const double length = arc.end - arc.start;
  std::array<CableVector, parts_of_arc + 1> tensions;
  double low = known;
  double high = 0.0;
  const auto look = [&](std::size_t k) {
    tensions[k] = solution.tensions(arc, length * static_cast<double>(k) / parts_of_arc);
    for (const std::size_t cable : arc.taut) {
      const double tension = tensions[k][static_cast<Eigen::Index>(cable)];
      low = std::min(low, tension);
      high = std::max(high, tension);
    }
  };
  for (const std::size_t k : {std::size_t{0}, parts_of_arc / 2, parts_of_arc}) {
    look(k);
  }
  constexpr double margin = 0.5;  // [-], for what an arc bends more than a parabola
  if (!(high + margin * (high - low) > known)) {
    return known;
  }
  look(1);
  look(3);
  for (const std::size_t cable : arc.taut) {
    const auto row = static_cast<Eigen::Index>(cable);
    Nodes nodes{};
    for (std::size_t k = 0; k <= parts_of_arc; ++k) {
      nodes[k] = tensions[k][row];
    }
    known = largest_along([&](double dt) { return solution.tensions(arc, dt)[row]; }, nodes, length,
                          known);
  }
  return known;
}

}  // namespace

double largest_tension(const Solution& solution) {
  const auto& swing = solution.swing();
  double largest = swing ? swing->largest_tension.value_or(0.0) : 0.0;
  for (const Arc& arc : solution.arcs()) {
    if (arc.series.rows() == 0 || !(arc.end > arc.start)) {  // no cable pulls, or for an instant
      continue;
    }
    largest = arc.taut.size() == 1 ? largest_of_one(solution, arc, largest)
                                   : largest_of_several(solution, arc, largest);
  }
  return largest;
}

}  // namespace tautline::bench
