#include "bench/suite/rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <string_view>
#include <type_traits>
#include <utility>

#include "bench/base/listed.hpp"
#include "bench/base/text.hpp"
#include "bench/cases/elasticity_table.hpp"
#include "bench/cases/title.hpp"
#include "bench/data/coordinates.hpp"
#include "bench/judge/judgement.hpp"
#include "bench/measure/attribution/attribution.hpp"
#include "bench/measure/impact_match.hpp"
#include "bench/replay/motion.hpp"
#include "tautline/system_geometry.hpp"

namespace tautline::bench {
namespace {

constexpr std::size_t longest_reason = 400;  // [bytes], with a line of what the engine printed
constexpr std::size_t longest_escape = 4;    // [bytes], of a byte that cannot be shown

std::string comma_separated(const std::vector<double>& values) {
  std::string result;
  for (const double value : values) {
    result += (result.empty() ? "" : ",") + shortest(value);
  }
  return result;
}

/// Every number of a case as an address of the live page, which bench/playground/case.mjs reads.
std::string live_address(const Case& the_case) {
  std::string result = "name=";
  for (const char letter : the_case.name) {
    const bool plain = std::isalnum(static_cast<unsigned char>(letter)) != 0;
    result +=
        plain ? std::string(1, letter) : fmt::format("%{:02X}", static_cast<unsigned char>(letter));
  }
  const auto add = [&](std::string_view key, const std::vector<double>& values) {
    result += fmt::format("&{}={}", key, comma_separated(values));
  };
  add("duration", {the_case.duration});
  add("gravity", {the_case.gravity.x(), the_case.gravity.y()});
  add("body", {the_case.body.mass, the_case.body.inertia});
  std::vector<double> start;
  for (const auto& coordinate : coordinates(the_case.initial)) {
    start.push_back(coordinate.value);
  }
  add("start", start);
  for (const Cable& cable : the_case.cables) {
    add("cable", {cable.anchor.x(), cable.anchor.y(), cable.attachment.x(), cable.attachment.y(),
                  cable.length, cable.restitution, cable.capture_speed});
  }
  for (std::size_t index = 0; index < the_case.cables.size(); ++index) {
    std::vector<double> table = {static_cast<double>(index)};
    for (const RestitutionPoint& point : the_case.cables[index].restitution_table) {
      table.insert(table.end(), {point.speed, point.restitution});
    }
    if (table.size() > 1) {
      add("table", table);
    }
  }
  if (the_case.angle_limit) {
    add("angle_limit", {*the_case.angle_limit});
  }
  if (the_case.ceiling) {
    add("ceiling", {*the_case.ceiling});
  }
  return result;
}

/// How a run ended, and why if it did not finish.
template <class TheReference, class TheTrajectory>
std::pair<Status, std::string> status(const TheReference& reference, const RunReply& reply,
                                      const std::optional<TheTrajectory>& trajectory) {
  if (!trajectory) {
    const bool refused = reply.failure.starts_with("unsupported: ");  // the interface's word
    return {refused ? Status::unsupported : Status::failed,
            printable(reply.failure, longest_reason)};
  }
  const TheTrajectory& run = *trajectory;
  if (run.diverged) {
    return {Status::diverged,
            fmt::format("{} left every reasonable range after t = {:.6g}",
                        reply.in_space ? "a body" : "the body", run.points.back().time)};
  }
  if (run.stop) {
    const bool early = !reaches(run, std::min(reference.horizon, first_taut(reference.solution)));
    return {early ? Status::failed : Status::stopped,
            (early ? "gave up before the horizon: " : "") + printable(run.stop->reason)};
  }
  return {Status::finished, ""};
}

template <class TheCase>
RunDetails details_of(const Metrics& metrics, const BasicTrajectory<TheCase>& run) {
  RunDetails details;
  for (const Window window : windows) {
    const Deviation& deviation = metrics.deviation_in(window);
    const ImpactMatch& impacts = metrics.impacts_in(window);
    details.of_windows[static_cast<std::size_t>(window)] = {
        deviation.until, deviation.covered, impacts.exact, impacts.found, impacts.matched};
  }
  details.last_impacts = metrics.last_impacts;
  details.swing = metrics.swing;
  details.restitution = metrics.restitution;
  details.rest_tension = metrics.rest_tension;
  details.largest_tension = metrics.largest_tension;
  details.first_impulse = metrics.first_impulse;
  details.contacts = metrics.contacts;
  details.stride = run.stride;
  details.recorded_impacts = run.impacts.size();
  details.slow_impacts = run.slow_impacts;
  return details;
}

/// Puts into `record` all that is measured on `run`. A system has no ladder.
template <class TheReference, class TheCase>
void measure(const BasicExpectation<TheReference>& expectation, const Nearness& nearness,
             const EngineInfo& engine, const BasicTrajectory<TheCase>& run,
             const CompareOptions& options, RunRecord& record) {
  const TheReference& reference = expectation.reference();
  const double count_speed = options.count_speed;
  const Metrics metrics = compare(reference.the_case, reference.solution, reference.settling,
                                  reference.horizon, run, options);
  RunRow& row = record.row;
  row.metrics = values_of(metrics);
  row.details = details_of(metrics, run);
  record.replay = {run_path(reference.the_case, nearness, run),
                   run_impacts(reference.the_case, run, count_speed)};
  row.attribution = attribute(reference.the_case, reference.solution, reference.horizon, run,
                              {reference.law, noise_of(engine.precision), count_speed});
  if constexpr (std::is_same_v<TheCase, Case>) {
    record.audit = audit(reference, run, count_speed);
    row.ladder = record.audit->ladder;
  } else {
    record.audit = RunAudit{std::nullopt, audited_impacts(reference, run), std::nullopt};
  }
  row.judgement = judge(expectation, run, record.audit->impacts, engine.precision);
}

TimingRow timing_row(const RunKey& key, const Cost& cost) {
  TimingRow row;
  row.key = key;
  row.memory = cost.memory;
  row.step_cost = cost.step;
  row.reference_cost = cost.reference;
  row.cost_ratio = cost.reference > 0.0 ? cost.step / cost.reference : 0.0;
  row.second_cost = cost.step / cost.dt;
  row.second_spread = {cost.smallest / cost.dt, cost.lower / cost.dt, cost.upper / cost.dt};
  row.repetitions = cost.repetitions;
  return row;
}

}  // namespace

Nearness nearness_of(const AnyExpectation& expected) {
  return std::visit([](const auto& one) { return nearness_of(one.reference()); }, expected);
}

RunRecord run_record(const AnyExpectation& expected, const Nearness& nearness,
                     const EngineInfo& engine, const RunKey& key, const RunReply& reply,
                     const CompareOptions& options) {
  RunRecord record;
  record.row.key = key;
  std::visit(
      [&](const auto& expectation) {
        const auto& run = run_of(reply, expectation.reference().the_case);
        std::tie(record.row.status, record.row.reason) =
            status(expectation.reference(), reply, run);
        if (run) {
          measure(expectation, nearness, engine, *run, options, record);
          record.timing = timing_row(key, reply.cost);
        }
      },
      expected);
  if (!record.timing && !reply.output_tail.empty()) {
    const std::size_t size = std::min(reply.output_tail.size(), quotable_length);
    record.row.output_tail = printable(reply.output_tail.substr(reply.output_tail.size() - size),
                                       longest_escape * quotable_length);
  }
  return record;
}

namespace {

/// The row of a case of either kind.
CaseRow row_of(const auto& reference, double count_speed) {
  const auto& [the_case, solution, settling, horizon, law] = reference;
  CaseRow row;
  row.name = the_case.name;
  row.cables = the_case.cables.size();
  row.duration = the_case.duration;
  row.ending = to_string(solution.ending());
  row.end_time = solution.end_time();
  row.horizon = horizon;
  row.counted_impacts = counted_impacts(the_case, solution, count_speed).size();
  row.start_energy = energy(the_case, the_case.initial);
  row.end_energy = energy(the_case, solution.at(solution.end_time()));
  return row;
}

std::vector<double> numbers_of(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

/// `function` as a report has it; none of one that does not change.
template <int N>
std::optional<FunctionRow> over_time(const Function<N>& function) {
  if (function.is_constant()) {
    return std::nullopt;
  }
  const auto list = [](const typename Function<N>::Value& value) {
    return std::vector<double>(value.begin(), value.end());
  };
  FunctionRow row;
  for (const auto& piece : function.pieces) {
    row.pieces.push_back({piece.from, listed(piece.coefficients, list)});
  }
  for (const auto& wave : function.waves) {
    row.waves.push_back({list(wave.amplitude), wave.frequency, wave.phase});
  }
  return row;
}

EndRow end_row(const SpatialEnd& end) {
  // what is given and does not change is a part of the point
  return {end.body, numbers_of(end.motion.is_constant() ? end.at + end.motion.at(0.0) : end.at),
          over_time(end.motion)};
}

/// How `cable` stretches; none if it does not.
std::optional<ElasticityRow> elasticity_row(const SpatialCable& cable) {
  if (!is_elastic(cable)) {
    return std::nullopt;
  }
  const Elasticity& law = *cable.elasticity;
  const auto numbers = [](const Corner& corner) {
    return std::vector<double>{corner.stretch, corner.stiffness};
  };
  return ElasticityRow{.stiffness = law.stiffness,
                       .corners = listed(law.corners, numbers),
                       .of_strain = law.of_strain,
                       .damping = law.damping,
                       .damping_ratio = law.damping_ratio,
                       .cut = cut_words[static_cast<std::size_t>(law.cut)]};
}

/// From when on a run of these steps is judged no longer, and what it can be read by.
template <class TheReference>
void add_predictable(const BasicExpectation<TheReference>& expectation,
                     const std::vector<double>& steps, CaseRow& row) {
  for (const double step : steps) {
    const Allowance& allowance = expectation.allowance(step);
    row.predictable.push_back({step, allowance.until, allowance.barrier,
                               readable_impacts(expectation.reference(), step)});
  }
}

CaseRow case_row(const ReferenceSystem& reference, double count_speed) {
  const SpatialSystem& system = reference.the_case;
  CaseRow row = row_of(reference, count_speed);
  const std::size_t bodies = system.bodies.size();
  row.title = fmt::format("{} bod{} in space, {} cable{}", bodies, bodies == 1 ? "y" : "ies",
                          row.cables, row.cables == 1 ? "" : "s");
  row.settling.last_impacts = reference.settling.last_impacts;
  if (const auto& lock = reference.settling.lock) {
    row.settling.lock = Lock{.time = lock->time,
                             .uncertainty = lock->uncertainty,
                             .cables = lock->cables,
                             .permanent = lock->certain,
                             .rests = lock->at_rest,
                             .swing = {}};
  }
  SystemRow& shown = row.system.emplace();
  shown.hash = fmt::format("{:016x}", stable_hash(write_system(system)));
  shown.gravity = numbers_of(system.gravity.at(0.0));
  for (const SpatialBody& body : system.bodies) {
    shown.bodies.push_back({body.name, body.mass, numbers_of(body.inertia)});
  }
  for (const SpatialCable& cable : system.cables) {
    shown.cables.push_back(
        {end_row(cable.from), listed(cable.through, end_row), end_row(cable.to),
         cable.length.at(0.0)[0],
         depends_on_speed(cable) || is_elastic(cable) ? std::nullopt
                                                      : std::optional(cable.restitution),
         over_time(cable.length), cable.from_time, cable.cut_at, elasticity_row(cable)});
  }
  row.extent = drawn_extent(reference);
  return row;
}

}  // namespace

CaseRow case_row(const AnyExpectation& expected, const CompareOptions& options,
                 const std::vector<double>& steps) {
  if (const auto* const system = std::get_if<SystemExpectation>(&expected)) {
    CaseRow row = case_row(system->reference(), options.count_speed);
    add_predictable(*system, steps, row);
    row.step_needed = step_needed(system->reference(), usual_part);
    return row;
  }
  const auto& expectation = std::get<Expectation>(expected);
  const ReferenceCase& reference = expectation.reference();
  const Case& the_case = reference.the_case;
  CaseRow row = row_of(reference, options.count_speed);
  row.title = title_of(the_case);
  row.settling = reference.settling;
  PlaneRow& plane = row.plane.emplace();
  plane.body = the_case.body;
  plane.gravity = the_case.gravity;
  for (const Cable& cable : the_case.cables) {
    plane.geometry.push_back(
        {cable.anchor, cable.attachment, cable.length,
         depends_on_speed(cable) ? std::nullopt : std::optional(cable.restitution)});
  }
  row.extent = drawn_extent(reference);
  const State& start = the_case.initial;
  row.live = live_address(the_case);
  row.start = Eigen::Vector3d(start.position.x(), start.position.y(), start.angle);
  add_predictable(expectation, steps, row);
  row.step_needed = step_needed(reference, usual_part);
  return row;
}

}  // namespace tautline::bench
