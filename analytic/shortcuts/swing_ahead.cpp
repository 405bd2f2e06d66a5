#include "shortcuts/swing_ahead.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "shortcuts/cosine_sum.hpp"
#include "shortcuts/two_cable_curve.hpp"
#include "tautline/detail/rounding.hpp"

namespace tautline {
namespace {

/// The way between the turning points of a swing.
struct Way {
  double fastest;                   // [J], the kinetic energy at the equilibrium
  std::array<CurvePoint, 2> turns;  // at rising s
  double middle;                    // s between them
  double half;                      // and of their distance
};

/// What is looked at on the way, at the nodes.
struct Along {
  std::array<CurvePoint, CosineSum::terms> points;
  CosineSum::Values pace;     // [s], of time by phase (Eq. 25)
  CosineSum::Values turning;  // of the angle, in s
  std::array<CosineSum::Values, max_cables> tensions_and_gaps;
};

/// The tension of one cable by the phase.
struct Tension {
  std::size_t cable = 0;
  CosineSum sum;
};
using Tensions = std::array<Tension, 2>;  // of the two that pull

class Watch {
 public:
  Watch(const Case& the_case, const State& state, CableSet pulling)
      : case_(the_case),
        pulling_(pulling),
        curve_(the_case, state, pulling),
        start_energy_(kinetic_energy(the_case.body, state)),
        speed_(curve_.direction().dot(mass_velocity(the_case.body, state))),
        force_(root_of_mass(the_case.body)[0] *
               Vector3<double>(the_case.gravity.x(), the_case.gravity.y(), 0.0)) {}

  [[nodiscard]] std::optional<Swing> swing(double left) const {
    const auto way = find_way();
    const auto along = way ? look_along(*way) : std::nullopt;
    const auto tensions = along ? undisturbed_tensions(*along) : std::nullopt;
    if (!tensions) {
      return std::nullopt;
    }
    const CosineSum pace(along->pace);
    if (!pace.has_no_zero()) {
      return std::nullopt;
    }
    const double half_period = pace.mean() * std::numbers::pi;
    const double cosine = std::clamp(-way->middle / way->half, -1.0, 1.0);
    const double phase = atan2(sqrt((1.0 - cosine) * (1.0 + cosine)), cosine);
    const double since = pace.integral(phase);  // or until: the turning point at phase 0
    // a start at rest is no turning point to those who follow
    const double until = speed_ == 0.0 ? half_period : speed_ > 0.0 ? since : half_period - since;
    constexpr double clearly = 1.0 - 1e-5;  // [-], beyond what is open of the time until then
    if (!(until + half_period < clearly * left)) {
      return std::nullopt;
    }
    const auto [least, largest] = std::minmax(way->turns[0].pose.angle, way->turns[1].pose.angle);
    Swing result{way->fastest, 2.0 * half_period, least, largest, (largest - least) / 2.0};
    result.largest_tension = largest_tension(*way, *along, *tensions);
    return result;
  }

 private:
  /// Kinetic, on the swing [J].
  [[nodiscard]] double energy_at(const CurvePoint& point) const {
    return start_energy_ + force_.dot(point.z);
  }

  /// Where the energy is largest, by Newton's method; none where that is not as near as in most
  /// swings.
  [[nodiscard]] std::optional<CurvePoint> equilibrium() const {
    std::optional<CurvePoint> point = curve_.start();
    double s = 0.0;
    constexpr int enough = 8;
    for (int iteration = 0; iteration < enough; ++iteration) {
      const double curvature = force_.dot(point->bend);
      if (!(curvature < 0.0)) {
        return std::nullopt;
      }
      const double step = -force_.dot(point->way) / curvature;
      s += step;
      point = curve_.at(s, *point);
      constexpr double small = 1e-8;  // [-]: the next step would gain the square of it
      if (!point || -curvature * step * step <= small * energy_at(*point)) {
        return point;
      }
    }
    return std::nullopt;
  }

  /// What a gap's rounding, and the angle's, make of a point of the curve.
  struct Rounding {
    double energy = 0.0;  // [J]: that on each cable is carried by its tension
    double angle = 0.0;   // [rad]
  };
  [[nodiscard]] Rounding rounding_at(const CurvePoint& point) const {
    const std::array<double, 2> static_tensions = tensions_at(point, 0.0);
    const RowSpace<Case> space = space_of(point);
    const double weight = case_.body.mass * case_.gravity.norm();
    const double angle_of_z = root_of_inverse_mass(case_.body)[2];
    const double turn = epsilon<double>() * std::abs(point.pose.angle);
    Rounding result{epsilon<double>() * start_energy_, turn};
    std::size_t row = 0;
    for (const std::size_t index : pulling_) {
      const Cable& cable = case_.cables[index];
      const double of_gap = rounding_of_gap(cable, point.pose) + turn * cable.attachment.norm();
      result.energy += (std::abs(static_tensions[row]) + weight) * of_gap;
      result.angle += std::abs(space.dual(row)[2]) * angle_of_z * of_gap;
      ++row;
    }
    return result;
  }

  /// The turning points to both sides of that.
  [[nodiscard]] std::optional<Way> find_way() const {
    const auto middle = equilibrium();
    const double fastest = middle ? energy_at(*middle) : 0.0;
    const Rounding rounding = middle ? rounding_at(*middle) : Rounding{};
    constexpr double enough = 1e12;  // [-], roundings, for ten digits of the swing
    if (!(fastest > enough * rounding.energy)) {
      return std::nullopt;
    }
    const double far = std::sqrt(2.0 * fastest / -force_.dot(middle->bend));
    const auto turn = [&](double ds) {
      return curve_.find(force_, -start_energy_, TwoCableCurve::onward(*middle, ds));
    };
    const auto low = turn(-far);
    const auto high = turn(far);
    if (!low || !high) {
      return std::nullopt;
    }
    const double from = curve_.direction().dot(low->z);
    const double to = curve_.direction().dot(high->z);
    const double near = 1e-9 * (to - from);  // the start may be one of them
    const double s = curve_.direction().dot(middle->z);
    if (!(from < s && s < to && from <= near && to >= -near) ||
        !(std::abs(high->pose.angle - low->pose.angle) > enough * rounding.angle)) {
      return std::nullopt;
    }
    return Way{fastest, {*low, *high}, (from + to) / 2.0, (to - from) / 2.0};
  }

  /// None where the curve between the turning points is another than that of the start, or the body
  /// is faster there than at the equilibrium.
  [[nodiscard]] std::optional<Along> look_along(const Way& way) const {
    Along along;
    const CosineSum::Nodes& nodes = CosineSum::nodes();
    CurvePoint point = way.turns[1];
    CurvePoint nearest = point;  // to the start
    for (std::size_t k = 0; k < CosineSum::terms; ++k) {
      const auto next = curve_.at(way.middle + way.half * nodes.cosine[k], point);
      const double energy = next ? energy_at(*next) : 0.0;
      constexpr double rounding = 1.0 + 1e-9;
      if (!(energy > 0.0 && energy < rounding * way.fastest)) {
        return std::nullopt;
      }
      point = *next;
      along.points[k] = point;
      nearest = point.z.squaredNorm() < nearest.z.squaredNorm() ? point : nearest;
      along.pace[k] = point.way.norm() * way.half * nodes.sine[k] / std::sqrt(2.0 * energy);
      along.turning[k] = point.way[2];
      const std::array<double, 2> tensions = tensions_at(point, energy);
      std::size_t row = 0;
      for (std::size_t index = 0; index < case_.cables.size(); ++index) {
        along.tensions_and_gaps[index][k] =
            pulling_.contains(index) ? tensions[row++] : gap(case_.cables[index], point.pose);
      }
    }
    const bool is_one =
        leads_to(curve_.start(), nearest, way) && leads_to(way.turns[0], point, way);
    return is_one ? std::optional(along) : std::nullopt;
  }

  /// True where the curve leads from `near` to `point`, and not to another point of the same s.
  [[nodiscard]] bool leads_to(const CurvePoint& point, const CurvePoint& near,
                              const Way& way) const {
    constexpr double same = 1e-6;  // [-], of the way
    const auto found = curve_.at(curve_.direction().dot(point.z), near);
    return found && (found->z - point.z).norm() <= same * way.half;
  }

  [[nodiscard]] static RowSpace<Case> space_of(const CurvePoint& point) {
    return {{point.rows[0], point.rows[1], Vector3<double>::Zero()}, 2};
  }

  /// Of the two cables [N], where the body passes with the kinetic `energy` [J] (Eq. 26): they
  /// carry its weight and bend its way.
  [[nodiscard]] std::array<double, 2> tensions_at(const CurvePoint& point, double energy) const {
    const RowSpace<Case> space = space_of(point);
    const double square = 2.0 * energy / point.way.squaredNorm();  // of ds / dt
    const Vector3<double> pull =
        -force_ - square * (point.bends[0] * space.dual(0) + point.bends[1] * space.dual(1));
    return {space.dual(0).dot(pull), space.dual(1).dot(pull)};
  }

  /// The largest tension of a cable [N]. Its sum says where it is, the curve how large it is there.
  [[nodiscard]] double largest_tension(const Way& way, const Along& along,
                                       const Tensions& tensions) const {
    double result = 0.0;
    for (std::size_t row = 0; row < 2; ++row) {
      const CosineSum::Values& values = along.tensions_and_gaps[tensions[row].cable];
      for (std::size_t k = 0; k < CosineSum::terms; ++k) {
        const bool is_maximum = (k == 0 || values[k] >= values[k - 1]) &&
                                (k + 1 == CosineSum::terms || values[k] >= values[k + 1]);
        if (is_maximum) {
          const double phase = tensions[row].sum.phase_of_maximum(k);
          const auto point = curve_.at(way.middle + way.half * cos(phase), along.points[k]);
          const double there = point ? tensions_at(*point, energy_at(*point))[row] : 0.0;
          result = std::max({result, values[k], there});
        }
      }
    }
    return result;
  }

  /// The tensions of the two cables where they pull all the way, no other closes, and the angle
  /// goes one way; else none.
  [[nodiscard]] std::optional<Tensions> undisturbed_tensions(const Along& along) const {
    if (!CosineSum(along.turning).has_no_zero()) {
      return std::nullopt;
    }
    Tensions tensions;
    auto next = tensions.begin();
    for (std::size_t index = 0; index < case_.cables.size(); ++index) {
      const CosineSum::Values& values = along.tensions_and_gaps[index];
      const CosineSum sum(values);
      if (!(values[0] > 0.0 && sum.has_no_zero())) {
        return std::nullopt;
      }
      if (pulling_.contains(index)) {
        *next++ = {index, sum};
      }
    }
    return tensions;
  }

  const Case& case_;
  CableSet pulling_;
  TwoCableCurve curve_;
  double start_energy_;    // [J], kinetic
  double speed_;           // ds / dt at the start
  Vector3<double> force_;  // M^-1/2 times the weight: the rate of the energy by z
};

}  // namespace

std::optional<Swing> swing_ahead(const Case& the_case, const State& state, CableSet pulling,
                                 double left) {
  if (pulling.size() != 2 || is_point_mass(the_case) || the_case.angle_limit || the_case.ceiling) {
    return std::nullopt;
  }
  return Watch(the_case, state, pulling).swing(left);
}

}  // namespace tautline
