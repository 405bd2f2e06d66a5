#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tautline/case.hpp"
#include "tautline/detail/rounding.hpp"
#include "tautline/system_turning.hpp"
#include "words.hpp"

namespace tautline {

/// What a number is of. It is put into words only where the number is wrong: an ensemble asks of
/// every draw.
struct What {
  std::string_view number;
  std::optional<std::size_t> cable = std::nullopt;
  std::optional<std::size_t> point = std::nullopt;  // of its restitution over speed
  std::string_view owner{};  // what else has the number, with a colon and a space

  [[nodiscard]] std::string words() const {
    std::string result(owner);
    if (cable) {
      result += cable_name(*cable) + ": ";
    }
    if (point) {
      result += "restitution_table[" + std::to_string(*point) + "]: ";
    }
    return result.append(number);
  }
};

/// Two cables between points that stand still in the world, and one body.
struct Span {
  double apart;    // [m], of the points in the world
  double spanned;  // [m], by lengths and body
  std::size_t one;
  std::size_t other;
};

/// The sentences on a case or a system that breaks rules; each check adds at most one.
class Sentences {
 public:
  void add(std::string sentence) { found_.push_back(std::move(sentence)); }
  [[nodiscard]] bool none() const { return found_.empty(); }
  [[nodiscard]] std::vector<std::string> found() && { return std::move(found_); }

  void finite(const What& what, std::initializer_list<double> values) {
    finite(what, std::span(values.begin(), values.size()));
  }

  void finite(const What& what, std::span<const double> values) {
    for (const double value : values) {
      if (!std::isfinite(value)) {
        add(what.words() + " " + text(value) + " is not a finite number");
        return;
      }
    }
    for (const double value : values) {
      if (std::abs(value) > largest_number) {
        add(what.words() + " " + text(value) + " is larger in size than " + text(largest_number));
        return;
      }
    }
  }

  void positive(const What& what, double value, std::string_view unit) {
    if (!std::isfinite(value) || value <= 0.0) {
      add(what.words() + " " + text(value) + " must be a finite number above 0 " +
          std::string(unit));
    } else {
      finite(what, {value});
    }
  }

  /// A positive number that others are divided by.
  void divisor(const What& what, double value, std::string_view unit) {
    positive(what, value, unit);
    if (value > 0.0 && value < smallest_divisor) {
      add(what.words() + " " + text(value) + " is smaller than " + text(smallest_divisor));
    }
  }

  void zero_or_above(const What& what, double value, std::string_view unit) {
    if (!std::isfinite(value) || value < 0.0) {
      add(what.words() + " " + text(value) + " must be a finite number, 0 or above " +
          std::string(unit));
    } else {
      finite(what, {value});
    }
  }

  /// The mass and inertia of the body that `owner` names; `is_point`: all its ends are its centre.
  template <class TheBody>
  void body(std::string_view owner, const TheBody& body, bool is_point) {
    const auto of_body = [&](std::string_view number) {
      return What{number, std::nullopt, std::nullopt, owner};
    };
    divisor(of_body("mass"), body.mass, "[kg]");
    const What inertia = of_body("inertia");
    if (body.inertia == 0.0 && !is_point) {
      add(inertia.words() +
          " 0 is for a point mass, whose attachments are all [0, 0]; give an inertia above 0 "
          "[kg m^2]");
    } else if (!(body.inertia > 0.0)) {
      zero_or_above(inertia, body.inertia, "[kg m^2]");
    } else {
      divisor(inertia, body.inertia, "[kg m^2]");
    }
  }

  /// The mass and the principal moments of a body in space: all of them 0, or all above 0, and none
  /// larger than the other two together.
  void spatial_body(std::string_view owner, double mass, const std::array<double, 3>& moments,
                    bool is_point) {
    const auto of_body = [&](std::string_view number) {
      return What{number, std::nullopt, std::nullopt, owner};
    };
    divisor(of_body("mass"), mass, "[kg]");
    if (std::all_of(moments.begin(), moments.end(), [](double one) { return one == 0.0; })) {
      if (!is_point) {
        add(of_body("inertia").words() +
            " [0, 0, 0] is for a point mass, whose attachments are all [0, 0, 0]; give three "
            "moments above 0 [kg m^2]");
      }
      return;
    }
    for (std::size_t axis = 0; axis < moments.size(); ++axis) {
      divisor(of_body("inertia[" + std::to_string(axis) + "]"), moments[axis], "[kg m^2]");
    }
    std::array<double, 3> sorted = moments;
    std::sort(sorted.begin(), sorted.end());
    const double largest = sorted[2];
    const double others = sorted[0] + sorted[1];
    if (others > 0.0 && largest > others * (1.0 + gap_rounding)) {  // of a plate they are equal
      add(of_body("inertia").words() + ": the largest principal moment, " + text(largest) +
          ", must not be above the sum of the other two, " + text(others) + " [kg m^2]");
    }
  }

  /// Its state at the start, of the body that `owner` names.
  void start(std::string_view owner, const State& state) {
    const auto of_body = [&](std::string_view number) {
      return What{number, std::nullopt, std::nullopt, owner};
    };
    finite(of_body("position"), {state.position.x(), state.position.y()});
    finite(of_body("angle"), {state.angle});
    finite(of_body("velocity"), {state.velocity.x(), state.velocity.y()});
    finite(of_body("spin"), {state.spin});
  }

  /// Its state at the start in space.
  void start(std::string_view owner, const SpatialState& state) {
    const auto of_body = [&](std::string_view number) {
      return What{number, std::nullopt, std::nullopt, owner};
    };
    const auto vector = [&](std::string_view number, const BasicVector<double, 3>& value) {
      finite(of_body(number), {value.x(), value.y(), value.z()});
    };
    vector("position", state.position);
    const Quaternion& q = state.orientation;
    finite(of_body("orientation"), {q[0], q[1], q[2], q[3]});
    if (std::isfinite(q.norm()) && std::abs(q.norm() - 1.0) > gap_rounding) {
      add(of_body("orientation").words() + ": w x y z has the length " + text(q.norm()) +
          "; must be 1");
    }
    vector("velocity", state.velocity);
    vector("spin", state.spin);
  }

  /// The restitution of cable `index`, and what makes it depend on the speed.
  template <class TheCable>
  void restitution(std::size_t index, const TheCable& cable) {
    share({"restitution ", index}, cable.restitution);
    zero_or_above({"capture_speed", index}, cable.capture_speed, "[m/s]");
    const auto& table = cable.restitution_table;
    for (std::size_t point = 0; point < table.size(); ++point) {
      zero_or_above({"speed", index, point}, table[point].speed, "[m/s]");
      if (point > 0 && table[point].speed <= table[point - 1].speed) {
        rising({"speed ", index, point}, table[point].speed, table[point - 1].speed, "[m/s]");
      }
      share({"restitution ", index, point}, table[point].restitution);
    }
  }

  /// A number that is not above the one before it; `what` ends with a space.
  void rising(const What& what, double value, double before, std::string_view unit) {
    add(what.words() + text(value) + " must be above the one before, " + text(before) + " " +
        std::string(unit));
  }

  /// No pose satisfies two cables whose anchors are further apart than cables and body can span.
  void reach(const Span& span) {
    const auto both = [&] {
      return "cables " + std::to_string(span.one) + " and " + std::to_string(span.other);
    };
    if (span.spanned < span.apart) {
      add(both() + " cannot reach: their anchors are " + text(span.apart) +
          " m apart, lengths and body span only " + text(span.spanned) +
          " m; the body cannot float");
    } else if (span.spanned == span.apart) {
      add(both() + " have no slack: their anchors are " + text(span.apart) +
          " m apart, which is all that lengths and body span; the body cannot float");
    }
  }

  /// A cable whose ends are `distance` apart at the start, along it; `rounding`: of the
  /// coordinates, all in m.
  void start_of_cable(std::size_t index, double length, double distance, double rounding,
                      std::string_view apart) {
    if (length > 0.0 && length < rounding) {
      add(cable_name(index) + ": length " + text(length) +
          " m is less than the rounding of its ends' coordinates, " + text(rounding) +
          " m: nothing says which way it pulls");
    } else if (length - distance < -std::max(gap_rounding * length, few_roundings * rounding)) {
      add(cable_name(index) + ": overstretched at the start by " + text(distance - length) +
          " m: its ends are " + text(distance) + std::string(apart) + ", its length is " +
          text(length) + " m; a length of " + text(distance) + " m would do");
    }
  }

 private:
  void share(const What& what, double value) {
    if (!(value >= 0.0 && value <= 1.0)) {
      add(what.words() + text(value) + " is outside [0, 1]");
    }
  }

  std::vector<std::string> found_;
};

}  // namespace tautline
