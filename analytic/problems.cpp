#include <cmath>
#include <string>
#include <vector>

#include "sentences.hpp"
#include "tautline/case.hpp"
#include "tautline/detail/rounding.hpp"
#include "tautline/geometry.hpp"
#include "words.hpp"

namespace tautline {
namespace {

/// Collects the sentences.
class Checker {
 public:
  explicit Checker(const Case& the_case) : case_(the_case) {}

  std::vector<std::string> run() {
    wrong_.body("body: ", case_.body, is_point_mass(case_));
    check_cables();
    check_motion();
    check_limits();
    if (wrong_.none()) {  // the rest needs sound numbers
      check_reach();
    }
    if (wrong_.none()) {
      check_start();
    }
    return std::move(wrong_).found();
  }

 private:
  void check_cables() {
    const std::size_t count = case_.cables.size();
    if (count < 1 || count > max_cables) {
      wrong_.add("cables: " + std::to_string(count) + " given; a case has 1 to " +
                 std::to_string(max_cables));
    }
    for (std::size_t index = 0; index < count; ++index) {
      const Cable& cable = case_.cables[index];
      wrong_.finite({"anchor", index}, {cable.anchor.x(), cable.anchor.y()});
      wrong_.finite({"attachment", index}, {cable.attachment.x(), cable.attachment.y()});
      wrong_.divisor({"length", index}, cable.length, "[m]");
      wrong_.restitution(index, cable);
    }
  }

  void check_motion() {
    wrong_.finite({"gravity"}, {case_.gravity.x(), case_.gravity.y()});
    wrong_.start("initial: ", case_.initial);
    wrong_.positive({"duration"}, case_.duration, "[s]");
  }

  void check_limits() {
    if (case_.angle_limit) {
      wrong_.positive({"angle_limit"}, *case_.angle_limit, "[rad]");
      if (std::abs(case_.initial.angle) > *case_.angle_limit) {
        wrong_.add("initial: angle " + text(case_.initial.angle) + " is beyond angle_limit " +
                   text(*case_.angle_limit));
      }
    }
    if (case_.ceiling) {
      wrong_.finite({"ceiling"}, {*case_.ceiling});
      for (std::size_t index = 0; index < case_.cables.size(); ++index) {
        const double height = attachment_point(case_.initial, case_.cables[index]).y();
        if (height > *case_.ceiling) {
          wrong_.add(cable_name(index) + ": attachment starts at height " + text(height) +
                     ", above ceiling " + text(*case_.ceiling));
        }
      }
    }
  }

  void check_reach() {
    for (std::size_t i = 0; i < case_.cables.size(); ++i) {
      for (std::size_t j = i + 1; j < case_.cables.size(); ++j) {
        const Cable& one = case_.cables[i];
        const Cable& two = case_.cables[j];
        wrong_.reach({(one.anchor - two.anchor).norm(),
                      one.length + two.length + (one.attachment - two.attachment).norm(), i, j});
      }
    }
  }

  void check_start() {
    for (std::size_t index = 0; index < case_.cables.size(); ++index) {
      const Cable& cable = case_.cables[index];
      const double distance = (attachment_point(case_.initial, cable) - cable.anchor).norm();
      wrong_.start_of_cable(index, cable.length, distance, rounding_of_gap(cable, case_.initial),
                            " m apart");
    }
  }

  const Case& case_;
  Sentences wrong_;
};

}  // namespace

std::vector<std::string> problems(const Case& the_case) { return Checker(the_case).run(); }

}  // namespace tautline
