#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

namespace tautline::bench {

/// A change counts as noise up to these. The first four are for runs on one machine or two: another
/// compiler rounds differently, and the motion amplifies that.
struct Noise {
  /// Of a number that is not itself rounding [-].
  double relative = 1e-6;
  /// What a run's rounding comes to up to the first few impacts: this times the precision of the
  /// engine's numbers over the step. Rounding adds up like a random walk: measured is a tenth.
  double early_rounding = 2.0;
  /// By how much the motion amplifies that up to the predictability horizon [-]: its definition,
  /// 1e-12 that grow to 1e-3.
  double growth = 1e9;
  /// Factor between the largest overstretch, restitution error or energy gain of two runs that go
  /// beyond the horizon, where each is one draw of a chaotic motion [-].
  double extremes = 2.0;
  /// Share of the impacts up to the horizon whose match may be lost or won, at least one [-].
  double impacts = 0.02;
  /// Factor between the costs of two machines, or two hours of one [-].
  double cost = 2.0;
};

/// A report, or all that is wrong with its file.
struct ReportReading {
  std::optional<nlohmann::ordered_json> report;
  std::vector<std::string> problems;
};

/// Reads report.json of this version of the program's `bench`.
[[nodiscard]] ReportReading read_report(const std::filesystem::path& path);

/// Why two reports cannot be compared at all; empty if they can.
[[nodiscard]] std::vector<std::string> incomparable(const nlohmann::ordered_json& before,
                                                    const nlohmann::ordered_json& after);

/// What changed beyond noise: an object of bench/gate/changes.schema.json. Of what lies beyond the
/// horizon, only extremes of the whole run are compared: overstretch, restitution error and energy
/// gain, by a factor (Noise::extremes). Throws nlohmann::json::exception where a row lacks what the
/// report's schema asks for.
[[nodiscard]] nlohmann::ordered_json compared_reports(const nlohmann::ordered_json& before,
                                                      const nlohmann::ordered_json& after,
                                                      const Noise& noise = {});

/// The same for a terminal. Drawn from `changes` alone.
[[nodiscard]] std::string comparison_text(const nlohmann::ordered_json& changes);

}  // namespace tautline::bench
