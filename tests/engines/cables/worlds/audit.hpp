// Holds a world, step by step, against what the cables promise.

#pragma once

#include <algorithm>
#include <deque>
#include <utility>
#include <vector>

#include "engines/cables/worlds/ledger.hpp"

namespace tautline::test {

/// The largest of a measure, and where it was.
struct Worst {
  double value = 0.0;
  double time = 0.0;  // [s]
  int cable = -1;     // negative: of the whole world

  void hold(double candidate, double at, int of_cable) {
    if (candidate > value) {
      *this = {candidate, at, of_cable};
    }
  }
};

/// What was found; plain, to be sent from one process to another.
struct Findings {
  Worst overstretch;   // [m]
  Worst beyond;        // overstretch beyond a step's way [m]: see `way_allowance`
  Worst gain;          // of energy [J]; its part of the range is `gain_part`
  double range = 0.0;  // [J]
  Worst restitution;   // |rate after / closing - e| [-] at an isolated impact
  int impacts = 0;     // isolated ones
  int most_parts = 1;  // of one step by events
  Worst not_a_number;  // value 1 if there was one

  double weight = 0.0;  // of the loads [N]

  /// Of the range, or of what the loads weigh times the overstretch that is allowed at rest: in a
  /// world in which next to nothing moves, that is more than the range.
  [[nodiscard]] double gain_part() const {
    const double sag = 1e-3;  // [m]
    const double whole = std::max(range, 1e3 * weight * sag);
    return whole > 0.0 ? gain.value / whole : 0.0;
  }
};

/// What is allowed.
struct Claims {
  /// Beyond the way of one step at the highest speed of the last second [m]. The speed is that of a
  /// cable's ends relative to each other: the way that they can separate by before a fixed step
  /// sees it.
  double way_allowance;
  double gain_part;    // of the range of energy [-]
  double restitution;  // of the closing rate [-]
};
/// `hooks`: there are some that move.
[[nodiscard]] Claims claims(Stepping stepping, bool hooks);

/// Which claims are broken.
struct Broken {
  bool number;
  bool overstretch;
  bool energy;
  bool restitution;

  [[nodiscard]] bool any() const { return number || overstretch || energy || restitution; }
};
[[nodiscard]] Broken broken(const Findings& findings, const Claims& claims);

class Audit {
 public:
  Audit(const World& world, Stepping stepping, double dt, const Scene& scene);

  /// After a step, which took `parts`.
  void look(const Scene& scene, int parts);

  [[nodiscard]] const Findings& findings() const { return findings_; }
  [[nodiscard]] const Moment& now() const { return now_; }

 private:
  /// A cable's last second, and for how many steps it has been slack.
  struct Past {
    std::deque<std::pair<int, double>> highest;  // step and speed [m/s], falling
    int slack_steps = 0;
    double impulse = 0.0;  // of the step before [N s]
  };
  void look_at_overstretch(std::size_t cable);
  void look_at_impact(const Scene& scene, std::size_t cable, int parts);
  [[nodiscard]] bool is_isolated(const Scene& scene, std::size_t cable) const;

  World world_;
  Stepping stepping_;
  double dt_;  // [s]
  int step_ = 0;
  Moment before_;
  Moment now_;
  Ledger ledger_;
  std::vector<Past> past_;
  Findings findings_;
};

}  // namespace tautline::test
