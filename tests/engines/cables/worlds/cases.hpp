// The worlds in which cables once lost their loads or exploded, and what is right in them.

#pragma once

#include <string>
#include <vector>

#include "engines/cables/worlds/run.hpp"

namespace tautline::test {

struct Case {
  std::string name;  // the same for random starts of one case
  World world;
  bool rests;                    // at the end; else it swings on, for nothing damps it
  std::vector<Vec3> at_rest;     // each load's place then [m]
  std::vector<double> tensions;  // each cable's then [N]
};
[[nodiscard]] const std::vector<Case>& cases();

struct CaseFindings {
  Findings findings;
  // in the last ten seconds:
  double off = 0.0;            // farthest of a load from its place at rest [m]
  double tension_error = 0.0;  // of a cable's mean tension [-]
  double overstretch = 0.0;    // [m]
};
[[nodiscard]] CaseFindings findings_of(const Case& the_case, const Playing& playing,
                                       double seconds);

/// What is allowed at rest, beside the claims of all worlds.
constexpr double allowed_off = 1e-3;            // [m]
constexpr double allowed_tension_error = 1e-2;  // [-]

[[nodiscard]] bool is_broken(const Case& the_case, const CaseFindings& found, Stepping stepping);

/// Loads below each other on cables of `length` [m] and restitution `restitution`, each cable slack
/// by `slack` [m] as the case begins.
[[nodiscard]] Case series_of(const std::string& name, const std::vector<double>& masses,
                             double length, double restitution, double slack);

}  // namespace tautline::test
