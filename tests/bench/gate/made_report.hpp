#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "bench/report/report.hpp"

namespace tautline::bench::test {

// Reports made by hand: what is drawn from a report needs no run of an engine.

/// The place of a metric that there is.
[[nodiscard]] inline std::size_t place(std::string_view metric) { return place_of(metric).value(); }

/// A report of one case, "ball", without runs: its horizon at 5 s of 10, its energy 1 J.
[[nodiscard]] inline Report made_report() {
  Report report;
  CaseRow ball;
  ball.name = "ball";
  ball.duration = 10.0;
  ball.horizon = 5.0;
  ball.start_energy = 1.0;
  ball.plane = PlaneRow{{}, Vec2::Zero(), {CableRow{}}};
  ball.start = Eigen::Vector3d::Zero();
  ball.step_needed.emplace();
  report.cases = {ball};
  return report;
}

/// Adds an engine with one model, "row".
inline void add_engine(Report& report, const std::string& name,
                       const std::string& precision = "float64") {
  EngineRow row;
  row.name = name;
  row.info = EngineInfo{name, "1", precision, {Model{"row", "Rows.", {}}}};
  report.engines.push_back(row);
}

/// A judgement in which all is well.
[[nodiscard]] inline Judgement sound_judgement() {
  Judgement judgement;
  judgement.rebounds.word = Rebound::kept;
  judgement.rebounds.readable = 4;
  judgement.rebounds.slowest = 0.25;
  judgement.rebounds.deviation = 0.0;
  judgement.following.ratio = 0.5;
  judgement.energy = 0.0;
  judgement.following.until = 5.0;
  judgement.impacts = {3, 0};
  return judgement;
}

/// Adds a finished run of the ball, whose metrics are all `value` and whose judgement is sound; its
/// exact motion has `exact_impacts` up to the horizon.
inline RunRow& add_run(Report& report, const std::string& engine, double value, double step = 1e-3,
                       std::size_t exact_impacts = 10) {
  RunRow row;
  row.key = {"ball", engine, "row", step};
  row.metrics = MetricValues(metric_list().size(), value);
  row.details = RunDetails();
  row.judgement = sound_judgement();
  row.details->of_windows[static_cast<std::size_t>(Window::horizon)].exact = exact_impacts;
  report.runs.push_back(row);
  return report.runs.back();
}

/// A run that did not do its work.
inline RunRow& add_bad_run(Report& report, const std::string& engine, Status status,
                           const std::string& reason) {
  RunRow& row = add_run(report, engine, 0.0);
  row.status = status;
  row.reason = reason;
  row.metrics.reset();
  row.details.reset();
  row.judgement.reset();
  return row;
}

}  // namespace tautline::bench::test
