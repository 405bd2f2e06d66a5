#pragma once

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <vector>

#include "system/elastic_systems.hpp"
#include "tautline/solve.hpp"

// The motion of systems on elastic cables by another method: it shares the numbers of a system with
// the solver, and nothing else. Lengths, ends in the world and gravity are constant.

namespace tautline::test {

using Numbers = Eigen::VectorXd;
using Rates = std::function<Numbers(const Numbers&)>;

/// The state `step` after `start`: the modified midpoint rule in 2, 4, ... 10 parts, extrapolated
/// (Gragg, Bulirsch and Stoer).
[[nodiscard]] inline Numbers extrapolated(const Rates& rates, const Numbers& start, double step) {
  constexpr int columns = 5;  // more would make more of rounding
  std::vector<Numbers> table;
  for (int row = 0; row < columns; ++row) {
    const int parts = 2 * (row + 1);
    const double h = step / parts;
    Numbers before = start;
    Numbers now = start + h * rates(start);
    for (int part = 1; part < parts; ++part) {
      const Numbers next = before + 2.0 * h * rates(now);
      before = now;
      now = next;
    }
    Numbers value = (now + before + h * rates(now)) / 2.0;
    for (int column = 0; column < row; ++column) {
      const double ratio = static_cast<double>(row + 1) / (row - column);
      const Numbers better =
          value + (value - table[static_cast<std::size_t>(column)]) / (ratio * ratio - 1.0);
      table[static_cast<std::size_t>(column)] = value;
      value = better;
    }
    table.push_back(value);
  }
  return table.back();
}

/// A cable begins or ceases to pull.
struct Switching {
  double time;
  std::size_t cable;
  bool engages;
};

/// A system whose cables are all elastic and slack at the start.
template <int D>
class Independent {
 public:
  /// `step` [s] is small against the period of the fastest cable.
  Independent(const BasicSystem<double, D>& system, double step)
      : system_(system),
        step_(step),
        zones_(system.cables.size(), Zone::slack),
        past_(system.cables.size(), 0) {
    state_ = Numbers::Zero(static_cast<Eigen::Index>(system.bodies.size()) * numbers);
    for (std::size_t i = 0; i < system.bodies.size(); ++i) {
      put(system.initial.bodies[i],
          state_.segment<numbers>(static_cast<Eigen::Index>(i) * numbers));
    }
  }

  /// Goes on to `time` [s].
  void run_to(double time) {
    while (time_ < time) {
      const double step = std::min(step_, time - time_);
      const Numbers next = ahead(step);
      double first = step;
      std::size_t which = system_.cables.size();
      Watched by = Watched::gap;
      for (std::size_t cable = 0; cable < system_.cables.size(); ++cable) {
        for (const Watched one :
             {Watched::tension, Watched::gap, Watched::next_corner, Watched::last_corner}) {
          if (value(next, cable, one) < 0.0) {
            const double root = root_of(cable, one, step);
            if (root < first || which == system_.cables.size()) {
              first = root;
              which = cable;
              by = one;
            }
          }
        }
      }
      state_ = first == step ? next : ahead(first);
      time_ += first;
      if (which < system_.cables.size()) {
        change(which, by);
      }
    }
  }

  [[nodiscard]] const std::vector<Switching>& switchings() const { return switchings_; }
  /// Of a body: place, angle or quaternion, velocity, spin.
  [[nodiscard]] Numbers of_body(std::size_t i) const {
    return state_.segment<numbers>(static_cast<Eigen::Index>(i) * numbers);
  }
  /// Those numbers of a state of the solver.
  [[nodiscard]] static Numbers of(const typename Turning<double, D>::BodyState& body) {
    Numbers result(numbers);
    put(body, result.head<numbers>());
    return result;
  }

 private:
  enum class Zone { slack, engaged, loose };
  enum class Watched { tension, gap, next_corner, last_corner };
  static constexpr int turn = D == 2 ? 1 : 4;
  static constexpr int spin = D == 2 ? 1 : 3;
  static constexpr int numbers = 2 * D + turn + spin;
  using Point = Eigen::Matrix<double, D, 1>;
  using Matrix = Eigen::Matrix<double, D, D>;

  template <class Target>
  static void put(const typename Turning<double, D>::BodyState& body, Target&& target) {
    if constexpr (D == 2) {
      target << body.position, body.angle, body.velocity, body.spin;
    } else {
      target << body.position, body.orientation, body.velocity, body.spin;
    }
  }

  static Matrix turned(const Numbers& y, Eigen::Index first) {
    if constexpr (D == 2) {
      return Eigen::Rotation2Dd(y[first + D]).toRotationMatrix();
    } else {
      return Eigen::Quaterniond(y[first + 3], y[first + 4], y[first + 5], y[first + 6])
          .normalized()
          .toRotationMatrix();
    }
  }

  /// An end of a cable, its velocity, and its arm in the axes of its body.
  struct Place {
    Point at;
    Point velocity;
  };
  Place place(const Numbers& y, const BasicEnd<double, D>& end) const {
    if (!end.body) {
      return {end.at, Point::Zero()};
    }
    const auto first = static_cast<Eigen::Index>(*end.body) * numbers;
    const Matrix axes = turned(y, first);
    Point swept;
    if constexpr (D == 2) {
      swept = y[first + 5] * Point(-end.at.y(), end.at.x());
    } else {
      swept = Point(y.segment<3>(first + 10)).cross(end.at);
    }
    return {y.segment<D>(first) + axes * end.at, y.segment<D>(first + D + turn) + axes * swept};
  }

  /// The stretch of a cable and its rate.
  std::pair<double, double> stretch(const Numbers& y, std::size_t cable) const {
    const auto& one = system_.cables[cable];
    double length = -one.length.at(0.0)[0];
    double rate = 0.0;
    for (std::size_t i = 0; i < one.segments(); ++i) {
      const Place a = place(y, one.end(i));
      const Place b = place(y, one.end(i + 1));
      const Point apart = a.at - b.at;
      length += apart.norm();
      rate += apart.normalized().dot(a.velocity - b.velocity);
    }
    return {length, rate};
  }

  double tension(const Numbers& y, std::size_t cable) const {
    const auto [s, rate] = stretch(y, cable);
    const auto& one = system_.cables[cable];
    const double damper = one.elasticity->damping * rate;
    return zones_[cable] == Zone::slack && one.elasticity->cut == ElasticCut::never
               ? damper
               : damper + force_by_lines(*one.elasticity, s, one.length.at(0.0)[0], past_[cable]);
  }

  Numbers rates(const Numbers& y) const {
    Numbers result = Numbers::Zero(y.size());
    const Point gravity = system_.gravity.at(0.0);
    for (std::size_t i = 0; i < system_.bodies.size(); ++i) {
      const auto first = static_cast<Eigen::Index>(i) * numbers;
      result.segment<D>(first) = y.segment<D>(first + D + turn);
      result.segment<D>(first + D + turn) = gravity;
      if constexpr (D == 2) {
        result[first + 2] = y[first + 5];
      } else {
        const Eigen::Quaterniond q(y[first + 3], y[first + 4], y[first + 5], y[first + 6]);
        const Point w = y.segment<3>(first + 10);
        const Eigen::Quaterniond rate = q * Eigen::Quaterniond(0.0, w.x(), w.y(), w.z());
        result.segment<4>(first + 3) << rate.w() / 2, rate.x() / 2, rate.y() / 2, rate.z() / 2;
        const Point momentum = system_.bodies[i].inertia.cwiseProduct(w);
        result.segment<3>(first + 10) = momentum.cross(w);
      }
    }
    for (std::size_t cable = 0; cable < zones_.size(); ++cable) {
      if (zones_[cable] == Zone::engaged ||
          system_.cables[cable].elasticity->cut == ElasticCut::never) {
        add_pull(y, cable, result);
      }
    }
    for (std::size_t i = 0; i < system_.bodies.size(); ++i) {
      const auto first = static_cast<Eigen::Index>(i) * numbers;
      const auto& inertia = system_.bodies[i].inertia;
      if constexpr (D == 2) {
        result[first + 5] /= inertia > 0.0 ? inertia : 1.0;
      } else {
        result.segment<3>(first + 10) = result.segment<3>(first + 10).cwiseQuotient(inertia);
      }
    }
    return result;
  }

  /// Adds accelerations of places, and moments to the places of spins.
  void add_pull(const Numbers& y, std::size_t cable, Numbers& result) const {
    const auto& one = system_.cables[cable];
    const double pull = tension(y, cable);
    for (std::size_t i = 0; i < one.segments(); ++i) {
      const Point along = (place(y, one.end(i)).at - place(y, one.end(i + 1)).at).normalized();
      for (const int side : {0, 1}) {
        const auto& end = one.end(i + static_cast<std::size_t>(side));
        if (!end.body) {
          continue;
        }
        const auto first = static_cast<Eigen::Index>(*end.body) * numbers;
        const Point force = (side == 0 ? -pull : pull) * along;
        result.segment<D>(first + D + turn) += force / system_.bodies[*end.body].mass;
        const Point in_body = turned(y, first).transpose() * force;
        if constexpr (D == 2) {
          result[first + 5] += end.at.x() * in_body.y() - end.at.y() * in_body.x();
        } else {
          result.segment<3>(first + 10) += end.at.cross(in_body);
        }
      }
    }
  }

  [[nodiscard]] Numbers ahead(double step) const {
    return extrapolated([this](const Numbers& y) { return rates(y); }, state_, step);
  }

  /// What falls below zero where a cable leaves its zone; above zero where nothing does.
  double value(const Numbers& y, std::size_t cable, Watched watched) const {
    const bool of_gap = watched == Watched::gap;
    if (!of_gap && watched != Watched::tension) {
      return way_to_corner(y, cable, watched);
    }
    switch (zones_[cable]) {
      case Zone::slack:
        return of_gap ? -stretch(y, cable).first : 1.0;
      case Zone::engaged:
        if (system_.cables[cable].elasticity->cut != ElasticCut::force) {
          return of_gap ? stretch(y, cable).first : 1.0;
        }
        return of_gap ? 1.0 : tension(y, cable);
      case Zone::loose:
        return of_gap ? stretch(y, cable).first : -tension(y, cable);
    }
    return 1.0;
  }

  /// How far a stretched cable is from a corner.
  double way_to_corner(const Numbers& y, std::size_t cable, Watched watched) const {
    const auto& one = system_.cables[cable];
    const auto& corners = one.elasticity->corners;
    const bool ahead = watched == Watched::next_corner;
    const std::size_t past = past_[cable];
    if (zones_[cable] == Zone::slack || past == (ahead ? corners.size() : 0)) {
      return 1.0;
    }
    const double at = corners[ahead ? past : past - 1].stretch *
                      (one.elasticity->of_strain ? one.length.at(0.0)[0] : 1.0);
    const double beyond = stretch(y, cable).first - at;
    return ahead ? -beyond : beyond;
  }

  double root_of(std::size_t cable, Watched watched, double high) const {
    double low = 0.0;
    while (true) {
      const double middle = low + (high - low) / 2.0;
      if (!(low < middle && middle < high) || high - low < 1e-17) {
        return high;
      }
      (value(ahead(middle), cable, watched) < 0.0 ? high : low) = middle;
    }
  }

  void change(std::size_t cable, Watched by) {
    Zone& zone = zones_[cable];
    if (by == Watched::next_corner) {
      ++past_[cable];
    } else if (by == Watched::last_corner) {
      --past_[cable];
    } else if (zone == Zone::engaged) {
      const auto& law = *system_.cables[cable].elasticity;
      zone = law.damping > 0.0 && law.cut == ElasticCut::force ? Zone::loose : Zone::slack;
      switchings_.push_back({time_, cable, false});
    } else if (zone == Zone::loose && by == Watched::gap) {
      zone = Zone::slack;
    } else {
      zone = Zone::engaged;
      switchings_.push_back({time_, cable, true});
    }
  }

  const BasicSystem<double, D>& system_;
  double step_;
  double time_ = 0.0;
  Numbers state_;
  std::vector<Zone> zones_;
  std::vector<std::size_t> past_;  // corners
  std::vector<Switching> switchings_;
};

/// What two methods differ in.
struct Apart {
  std::size_t switchings = 0;  // in the same order
  double time = 0.0;           // [s], of them
  double state = 0.0;          // at the end
};

/// How far `solve` and the other method, in steps of `step` [s], are apart after `duration` [s].
template <int D>
[[nodiscard]] Apart apart_from_extrapolation(BasicSystem<double, D> system, double duration,
                                             double step) {
  system.duration = duration;
  const auto solution = solve(system);
  Independent<D> other(system, step);
  other.run_to(duration);
  Apart result;
  for (const auto& event : solution.events()) {
    EXPECT_EQ(event.cables.size(), 1U);
    if (result.switchings == other.switchings().size()) {
      ADD_FAILURE() << "one more at " << event.time;
      break;
    }
    const Switching& switching = other.switchings()[result.switchings++];
    EXPECT_EQ(*event.cables.begin(), switching.cable) << event.time;
    EXPECT_EQ(event.kind == EventKind::entry, switching.engages) << event.time;
    result.time = std::max(result.time, std::abs(event.time - switching.time));
  }
  EXPECT_EQ(result.switchings, other.switchings().size());
  const auto end = solution.at(duration);
  for (std::size_t i = 0; i < system.bodies.size(); ++i) {
    result.state = std::max(
        result.state, (Independent<D>::of(end.bodies[i]) - other.of_body(i)).cwiseAbs().maxCoeff());
  }
  return result;
}

}  // namespace tautline::test
