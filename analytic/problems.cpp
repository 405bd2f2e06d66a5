#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "tautline/case.hpp"
#include "tautline/detail/rounding.hpp"
#include "tautline/geometry.hpp"
#include "words.hpp"

namespace tautline {
namespace {

/// What a number is of. It is put into words only where the number is wrong: an ensemble asks of
/// every draw.
struct What {
  std::string_view number;
  std::optional<std::size_t> cable = std::nullopt;
  std::optional<std::size_t> point = std::nullopt;  // of its restitution over speed

  [[nodiscard]] std::string words() const {
    std::string result = cable ? cable_name(*cable) + ": " : "";
    if (point) {
      result += "restitution_table[" + std::to_string(*point) + "]: ";
    }
    return result.append(number);
  }
};

/// Collects the sentences; each check adds at most one.
class Checker {
 public:
  explicit Checker(const Case& the_case) : case_(the_case) {}

  std::vector<std::string> run() {
    check_body();
    check_cables();
    check_motion();
    check_limits();
    if (found_.empty()) {  // the rest needs sound numbers
      check_reach();
    }
    if (found_.empty()) {
      check_start();
    }
    return std::move(found_);
  }

 private:
  void add(std::string sentence) { found_.push_back(std::move(sentence)); }

  void finite(const What& what, std::initializer_list<double> values) {
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

  void check_body() {
    divisor({"body: mass"}, case_.body.mass, "[kg]");
    const double inertia = case_.body.inertia;
    if (!std::isfinite(inertia) || inertia < 0.0) {
      add("body: inertia " + text(inertia) + " must be a finite number, 0 or above [kg m^2]");
    } else if (inertia == 0.0 && !is_point_mass(case_)) {
      add("body: inertia 0 is for a point mass, whose attachments are all [0, 0]; give an inertia "
          "above 0 [kg m^2]");
    } else if (inertia > 0.0) {
      divisor({"body: inertia"}, inertia, "[kg m^2]");
    }
  }

  void check_cables() {
    const std::size_t count = case_.cables.size();
    if (count < 1 || count > max_cables) {
      add("cables: " + std::to_string(count) + " given; a case has 1 to " +
          std::to_string(max_cables));
    }
    for (std::size_t index = 0; index < count; ++index) {
      const Cable& cable = case_.cables[index];
      finite({"anchor", index}, {cable.anchor.x(), cable.anchor.y()});
      finite({"attachment", index}, {cable.attachment.x(), cable.attachment.y()});
      divisor({"length", index}, cable.length, "[m]");
      if (!(cable.restitution >= 0.0 && cable.restitution <= 1.0)) {
        add(What{"restitution ", index}.words() + text(cable.restitution) + " is outside [0, 1]");
      }
      check_speeds(index, cable);
    }
  }

  /// What makes the restitution depend on the speed.
  void check_speeds(std::size_t index, const Cable& cable) {
    speed({"capture_speed", index}, cable.capture_speed);
    const auto& table = cable.restitution_table;
    for (std::size_t point = 0; point < table.size(); ++point) {
      speed({"speed", index, point}, table[point].speed);
      if (point > 0 && table[point].speed <= table[point - 1].speed) {
        add(What{"speed ", index, point}.words() + text(table[point].speed) +
            " must be above the one before, " + text(table[point - 1].speed) + " [m/s]");
      }
      if (!(table[point].restitution >= 0.0 && table[point].restitution <= 1.0)) {
        add(What{"restitution ", index, point}.words() + text(table[point].restitution) +
            " is outside [0, 1]");
      }
    }
  }

  void speed(const What& what, double value) {
    if (!std::isfinite(value) || value < 0.0) {
      add(what.words() + " " + text(value) + " must be a finite number, 0 or above [m/s]");
    } else {
      finite(what, {value});
    }
  }

  void check_motion() {
    const State& state = case_.initial;
    finite({"gravity"}, {case_.gravity.x(), case_.gravity.y()});
    finite({"initial: position"}, {state.position.x(), state.position.y()});
    finite({"initial: angle"}, {state.angle});
    finite({"initial: velocity"}, {state.velocity.x(), state.velocity.y()});
    finite({"initial: spin"}, {state.spin});
    positive({"duration"}, case_.duration, "[s]");
  }

  void check_limits() {
    if (case_.angle_limit) {
      positive({"angle_limit"}, *case_.angle_limit, "[rad]");
      if (std::abs(case_.initial.angle) > *case_.angle_limit) {
        add("initial: angle " + text(case_.initial.angle) + " is beyond angle_limit " +
            text(*case_.angle_limit));
      }
    }
    if (case_.ceiling) {
      finite({"ceiling"}, {*case_.ceiling});
      for (std::size_t index = 0; index < case_.cables.size(); ++index) {
        const double height = attachment_point(case_.initial, case_.cables[index]).y();
        if (height > *case_.ceiling) {
          add(cable_name(index) + ": attachment starts at height " + text(height) +
              ", above ceiling " + text(*case_.ceiling));
        }
      }
    }
  }

  /// No pose satisfies two cables whose anchors are further apart than cables and body can span.
  void check_reach() {
    for (std::size_t i = 0; i < case_.cables.size(); ++i) {
      for (std::size_t j = i + 1; j < case_.cables.size(); ++j) {
        const Cable& one = case_.cables[i];
        const Cable& two = case_.cables[j];
        const double apart = (one.anchor - two.anchor).norm();
        const double span = one.length + two.length + (one.attachment - two.attachment).norm();
        const auto both = [&] {
          return "cables " + std::to_string(i) + " and " + std::to_string(j);
        };
        if (span < apart) {
          add(both() + " cannot reach: their anchors are " + text(apart) +
              " m apart, lengths and body span only " + text(span) + " m; the body cannot float");
        } else if (span == apart) {
          add(both() + " have no slack: their anchors are " + text(apart) +
              " m apart, which is all that lengths and body span; the body cannot float");
        }
      }
    }
  }

  void check_start() {
    for (std::size_t index = 0; index < case_.cables.size(); ++index) {
      const Cable& cable = case_.cables[index];
      const double distance = (attachment_point(case_.initial, cable) - cable.anchor).norm();
      const double rounding = rounding_of_gap(cable, case_.initial);
      if (cable.length > 0.0 && cable.length < rounding) {
        add(cable_name(index) + ": length " + text(cable.length) +
            " m is less than the rounding of its ends' coordinates, " + text(rounding) +
            " m: nothing says which way it pulls");
      } else if (cable.length - distance <
                 -std::max(gap_rounding * cable.length, few_roundings * rounding)) {
        add(cable_name(index) + ": overstretched at the start by " + text(distance - cable.length) +
            " m: its ends are " + text(distance) + " m apart, its length is " + text(cable.length) +
            " m; a length of " + text(distance) + " m would do");
      }
    }
  }

  const Case& case_;
  std::vector<std::string> found_;
};

}  // namespace

std::vector<std::string> problems(const Case& the_case) { return Checker(the_case).run(); }

}  // namespace tautline
