#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

namespace tautline::bench {

/// The stretches of time over which a run is compared, all from the start.
enum class Window { early, horizon, whole };
inline constexpr std::array<Window, 3> windows = {Window::early, Window::horizon, Window::whole};
[[nodiscard]] std::string_view to_string(Window window);

/// Deviation of a run from the exact solution over one window.
struct Deviation {
  double until = 0.0;     // [s], end of the window, from the exact solution alone
  double covered = 0.0;   // [s], the run's last sample in it; 0 if there is none but the start
  double position = 0.0;  // [m], largest distance
  double angle = 0.0;     // [rad], largest
  double velocity = 0.0;  // [m/s], mean over time: next to an impact the largest is the whole jump
};

/// Impacts of a run against those of the exact solution, over one window.
struct ImpactMatch {
  std::size_t exact = 0;                   // counted impacts of the exact solution
  std::size_t found = 0;                   // counted impacts of the run: >= `matched`
  std::size_t matched = 0;                 // pairs, one to one
  std::optional<double> first_time_error;  // [s], of the exact solution's first counted impact
  std::optional<double> worst_time_error;  // [s], over the pairs
};

/// Restitution measured at each counted impact of a single step, up to the exact lock, or to the
/// end of the exact solution without one, against the cables' own.
struct MeasuredRestitution {
  std::size_t count = 0;
  double smallest = 0.0;  // [-]
  double mean = 0.0;      // [-]
  double largest = 0.0;   // [-]
  double worst = 0.0;     // [-], largest distance from the cable's restitution
};

/// The last impact faster than a threshold: settling by its first definition.
struct LastImpactMatch {
  double speed = 0.0;           // [m/s], the threshold
  std::optional<double> exact;  // [s]; none if the exact motion does not lock
  std::optional<double> found;  // [s], the run's; none too if it stopped before `exact`
};

/// A number of the exact motion and the run's.
struct ExactAndFound {
  double exact = 0.0;
  double found = 0.0;
};

/// Contacts of elastic cables that begin up to the horizon, of a run against those of the exact
/// motion: the errors are the worst of the pairs, none without a pair that has the number by then.
struct ContactMatch {
  std::size_t exact = 0;                    // counted contacts of the exact motion
  std::size_t found = 0;                    // counted contacts of the run
  std::size_t matched = 0;                  // pairs, one to one
  std::optional<ExactAndFound> peak;        // [N], the largest tension; the run's over a step
  std::optional<double> peak_error;         // [%] of a contact's exact largest tension
  std::optional<double> impulse_error;      // [%] of a contact's exact impulse
  std::optional<double> time_error;         // [%] of a contact's exact time
  std::optional<double> restitution_error;  // [-], of a contact's exit speed over its entry speed
};

/// The swing on the cables that are taut in the end, over the last period of a run.
struct SwingMatch {
  double from = 0.0;        // [s]
  double until = 0.0;       // [s], one period of the exact swing later
  ExactAndFound energy;     // [J], above the equilibrium of the exact swing; the run's is a mean
  ExactAndFound amplitude;  // [rad], half the range of the angle; the run's over its samples
};

/// Everything that one run is measured by.
struct Metrics {
  std::array<Deviation, windows.size()> deviation;  // by Window
  std::array<ImpactMatch, windows.size()> impacts;  // by Window
  std::vector<LastImpactMatch> last_impacts;        // in falling speed
  std::size_t later_impacts = 0;    // counted impacts of the run after the exact lock
  std::size_t long_impacts = 0;     // counted impacts, up to the exact lock, of several steps
  std::optional<SwingMatch> swing;  // none without an exact swing, or a period of it in the run
  double overstretch = 0.0;         // [m], largest
  double energy_gain = 0.0;   // [J], largest rise above the start; no number where the case drives
  double energy_error = 0.0;  // [J], against exact at the end of Window::whole
  std::optional<MeasuredRestitution> restitution;  // none if no impact was counted
  std::optional<double> impulse_error;             // [%] of the exact impulse, at worst
  std::optional<double> energy_loss_error;         // [J] of one impact, at worst
  std::optional<ExactAndFound> rest_tension;       // [N], of the cable that is off most
  std::optional<ExactAndFound> largest_tension;    // [N], of a taut phase
  std::optional<ExactAndFound> first_impulse;      // [N s], of the first impact
  std::optional<ContactMatch> contacts;            // none without an elastic cable

  [[nodiscard]] const Deviation& deviation_in(Window window) const {
    return deviation[static_cast<std::size_t>(window)];
  }
  [[nodiscard]] const ImpactMatch& impacts_in(Window window) const {
    return impacts[static_cast<std::size_t>(window)];
  }
};

}  // namespace tautline::bench
