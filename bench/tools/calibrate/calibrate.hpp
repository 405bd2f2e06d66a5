#pragma once

#include <filesystem>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "bench/check/strike.hpp"
#include "bench/run/worker.hpp"
#include "tautline/engine.hpp"

namespace tautline::bench {

// The parameters of a model that give a cable the restitution that is wanted of it, over closing
// speeds, arms, inertias and spins: searched by strikes, judged by others.

/// What is wanted, and of which model.
struct CalibrationRequest {
  std::filesystem::path plugin;
  Model model;
  std::vector<Parameter> searched;      // of the model's
  std::map<std::string, double> fixed;  // the others that are not left to the model
  double restitution;                   // [-], wanted
  double slowest;                       // [m/s], of the closing speeds, > 0
  double fastest;                       // [m/s], above it
  double step;                          // [s]
  double tolerance;                     // [-], of the restitution of every strike
  int settings;                         // that are tried at most, > 0
  WorkerLimits limits;                  // for all strikes with one setting
};

/// A strike that the search did not see.
struct HeldOut {
  Strike strike;
  double restitution;  // [-], found; not a number where nothing was struck
};

/// The best that was found.
struct Calibration {
  std::map<std::string, double> parameters;  // rounded as they are printed; empty if all failed
  std::string code;                          // the model's, with them
  std::optional<SoftRow> law;                // of its cable, if it is a spring and a damper
  std::vector<HeldOut> held_out;
  double worst = 0.0;            // [-], of their errors; infinite where one gives no number
  double mean = 0.0;             // [-], likewise
  int evaluations = 0;           // settings that were tried
  std::vector<std::string> why;  // sentences: where it cannot be had; none of half a search
  std::string failure;           // why nothing was measured; else empty
  bool interrupted = false;      // the best so far

  [[nodiscard]] bool reached(double tolerance) const {
    return failure.empty() && worst <= tolerance;
  }
};

/// The damping ratio [-] of a law, the same for every mass.
[[nodiscard]] double damping_ratio_of(const SoftRow& law);

/// How many settings it takes to search so many parameters.
[[nodiscard]] int most_settings(std::size_t searched);

/// Searches; the same request gives the same answer. Tells `tried` after each setting.
[[nodiscard]] Calibration calibrate(const CalibrationRequest& request,
                                    const std::function<void()>& tried);

/// The restitutions of one strike over all settings that were tried [-].
struct Reach {
  double lowest = std::numeric_limits<double>::infinity();
  double highest = -std::numeric_limits<double>::infinity();

  void include(double restitution);  // one that is not finite says nothing
};

}  // namespace tautline::bench
