// Engines on systems in space, from the command line and from below.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "bench/cases/bench_case.hpp"
#include "bench/measure/compare.hpp"
#include "bench/measure/reference.hpp"
#include "bench/run/wire.hpp"
#include "tautline/scenarios.hpp"
#include "tautline/solve.hpp"
#include "tests/bench/program.hpp"
#include "tests/bench/schema.hpp"

namespace tautline::test {
namespace {

using nlohmann::json;
using namespace bench;

/// The report of cases on the control, Bullet and ODE.
json report_of(const std::vector<std::string>& cases, const TemporaryFolder& folder) {
  std::vector<std::string> arguments = {"bench"};
  arguments.insert(arguments.end(), cases.begin(), cases.end());
  for (const char* one : {"--engines", "exact,bullet64,ode", "--steps", "0.01", "--out"}) {
    arguments.emplace_back(one);
  }
  arguments.push_back((folder.path() / "out").string());
  const Outcome outcome = program(arguments);
  EXPECT_EQ(outcome.code, 0) << outcome.errors << outcome.output;
  return json::parse(content_of(folder.path() / "out" / "report.json"));
}

const json& run_in(const json& report, const std::string& the_case, const std::string& engine,
                   const std::string& model) {
  for (const json& run : report.at("runs")) {
    if (run.at("case") == the_case && run.at("engine") == engine && run.at("model") == model) {
      return run;
    }
  }
  static const json none;
  ADD_FAILURE() << "no run of " << the_case << " by " << engine << " " << model;
  return none;
}

TEST(SystemBench, ComparesModelsThatTakeSystemsWithTheirExactMotion) {
  const TemporaryFolder folder;
  const json report = report_of({"tethered-ball", "two-bodies"}, folder);
  for (const char* the_case : {"tethered-ball", "two-bodies"}) {
    for (const char* model : {"event", "sampled"}) {
      const json& metrics = run_in(report, the_case, "exact", model).at("metrics");
      EXPECT_LE(metrics.at("horizon_position_error"), 1e-14) << the_case << " " << model;
      EXPECT_LE(metrics.at("horizon_angle_error"), 1e-14) << the_case << " " << model;
    }
    for (const char* engine : {"bullet64", "ode"}) {
      const json& by_events = run_in(report, the_case, engine, "event");
      EXPECT_EQ(by_events.at("status"), "finished") << by_events.dump();
      EXPECT_LE(by_events.at("metrics").at("early_position_error"), 1e-9) << the_case << engine;
      const json& steps = run_in(report, the_case, engine, "row").at("metrics");
      EXPECT_LT(steps.at("early_position_error"), 0.5) << the_case << engine;
    }
  }
  // a fixed step is late to an impact
  EXPECT_GT(run_in(report, "tethered-ball", "ode", "row").at("metrics").at("early_position_error"),
            1e-4);
  // a model of one body in the plane is left out
  EXPECT_TRUE(std::none_of(report.at("runs").begin(), report.at("runs").end(),
                           [](const json& run) { return run.at("model") == "two-phase"; }));
  const json& pair = report.at("cases").at(0);  // systems in the plane come first
  EXPECT_EQ(pair.at("name"), "two-bodies");
  EXPECT_EQ(pair.at("system").at("bodies").size(), 2U);
  EXPECT_EQ(pair.at("system").at("bodies").at(0).at("inertia").size(), 3U);
  EXPECT_FALSE(pair.contains("body"));
  const std::string csv =
      content_of(folder.path() / "out/runs/tethered-ball/ode/row/0.01/trajectory.csv");
  EXPECT_TRUE(csv.starts_with("time,ball_x,ball_y,ball_z,ball_qw,")) << csv.substr(0, 100);
  EXPECT_NE(csv.find("ball_wz,event,tension_0\n0,"), std::string::npos) << csv.substr(0, 200);
}

/// How many cells a line of a table of Markdown has.
std::ptrdiff_t cells_of(const std::string& line) {
  return std::count(line.begin(), line.end(), '|') - 1;
}

TEST(SystemBench, ComparesContactsOfElasticCables) {
  const TemporaryFolder folder;
  const std::string out = (folder.path() / "out").string();
  const Outcome outcome = program({"bench", "snap", "elastic-strop", "--engines", "exact",
                                   "--steps", "1e-3", "--no-certify", "--out", out});
  EXPECT_EQ(outcome.code, 0) << outcome.errors << outcome.output;
  const json report = json::parse(content_of(folder.path() / "out" / "report.json"));
  EXPECT_EQ(broken_rules_of(report, "bench"), "");
  for (const json& the_case : report.at("cases")) {
    for (const json& cable : the_case.at("system").at("cables")) {
      // a report asks an elastic cable for its law, and an inextensible one for its restitution
      EXPECT_NE(cable.contains("elasticity"), cable.at("restitution").is_number());
    }
  }
  const json& law = report.at("cases").at(0).at("system").at("cables").at(0).at("elasticity");
  EXPECT_EQ(law.at("stiffness"), json({1e4}));
  EXPECT_EQ(law.at("cut"), "force");
  for (const char* model : {"event", "sampled", "plain"}) {
    const json& contacts = run_in(report, "snap", "exact", model).at("details").at("contacts");
    EXPECT_EQ(contacts.at("matched"), 8) << model;
    EXPECT_EQ(contacts.at("exact"), 8) << model;
    EXPECT_NEAR(contacts.at("peak").at("exact"), 277.952323, 1e-6) << model;
    EXPECT_LE(contacts.at("peak_error"), 2.0) << model;  // [%], at 30 steps in a contact
    // what the strop pulls at the hook in a step is no restitution of its rope
    const json& judgement = run_in(report, "elastic-strop", "exact", model).at("judgement");
    const std::string word = judgement.at("restitution").at("word");
    EXPECT_TRUE(word == "kept" || word == "too-few") << model << ": " << word;
  }
  std::istringstream lines(content_of(folder.path() / "out" / "report.md"));
  std::string header;
  std::size_t with_contacts = 0;  // tables
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("| engine ")) {
      header = line;
      with_contacts += header.find("contacts off by") != header.npos ? 1U : 0U;
    } else if (!header.empty() && line.starts_with("| exact ")) {
      EXPECT_EQ(cells_of(line), cells_of(header)) << header << line;
      EXPECT_EQ(header.find("largest tension of a contact") == header.npos,
                header.find("contacts off by") == header.npos);
    }
  }
  EXPECT_GT(with_contacts, 0U);
}

/// The metrics of one run.
json metrics_of(const std::string& the_case, const std::string& engine, const std::string& model,
                const std::string& step) {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "run.json").string();
  const Outcome outcome = program(
      {"run", the_case, "--engine", engine, "--model", model, "--step", step, "--json", file});
  EXPECT_EQ(outcome.code, 0) << outcome.errors << outcome.output;
  return json::parse(content_of(file)).at("metrics");
}

TEST(SystemBench, ATautCableThatIsCutPullsUntilThen) {
  for (const char* engine : {"bullet64", "ode"}) {
    const double coarse = metrics_of("tow", engine, "event", "0.02").at("horizon_position_error");
    const double fine = metrics_of("tow", engine, "event", "0.01").at("horizon_position_error");
    EXPECT_LE(coarse, 5e-4) << engine;
    EXPECT_LE(fine, 0.5 * coarse) << engine;
  }
}

TEST(SystemBench, AWinchThatStopsLetsItsCableGo) {
  for (const char* engine : {"bullet64", "ode"}) {
    // the load is thrown up, and falls back into its cable: 0.01 m off where that is left out
    EXPECT_LE(metrics_of("winch", engine, "event", "0.01").at("horizon_position_error"), 1e-4);
    EXPECT_LE(metrics_of("winch", engine, "event", "0.001").at("horizon_position_error"), 1e-6);
  }
}

TEST(SystemBench, ACutAfterTheEndChangesNothing) {
  const TemporaryFolder folder;
  const Outcome shown = program({"cases", "tethered-ball"});
  ASSERT_EQ(shown.code, 0);
  const std::string plain = (folder.path() / "plain.toml").string();
  const std::string cut = (folder.path() / "cut.toml").string();
  std::ofstream(plain) << shown.output;
  std::ofstream(cut) << shown.output << "cut_at = 1000.0\n";
  for (const auto& [engine, model] :
       {std::pair("mujoco", "impulse"), std::pair("mujoco", "event"), std::pair("ode", "row")}) {
    if (built_engines().count(engine) != 0) {
      EXPECT_EQ(metrics_of(plain, engine, model, "0.01"), metrics_of(cut, engine, model, "0.01"))
          << engine << " " << model;
    }
  }
}

TEST(SystemBench, SaysNothingOfSystemsWhereThereIsNone) {
  const TemporaryFolder folder;
  const json report = report_of({"bouncing-ball"}, folder);
  EXPECT_EQ(report.dump().find("in_space"), std::string::npos);
  EXPECT_FALSE(report.at("cases").at(0).contains("system"));
  EXPECT_TRUE(report.at("cases").at(0).contains("geometry"));
}

TEST(SystemBench, ShardsMakeTheReportOfTheWhole) {
  const TemporaryFolder folder;
  const auto out = [&](const std::string& name) { return (folder.path() / name).string(); };
  const auto shard = [&](const std::string& which, const std::string& name) {
    std::vector<std::string> arguments = {"bench",     "two-bodies", "winch",
                                          "--engines", "exact,ode",  "--steps",
                                          "0.01",      "--out",      out(name)};
    if (!which.empty()) {
      arguments.insert(arguments.end(), {"--shard", which});
    }
    EXPECT_EQ(program(arguments).code, 0) << which;
  };
  shard("", "whole");
  shard("1/2", "a");
  shard("2/2", "b");
  EXPECT_EQ(program({"merge", out("a"), out("b"), "--out", out("both")}).code, 0);
  json whole = json::parse(content_of(folder.path() / "whole" / "report.json"));
  json both = json::parse(content_of(folder.path() / "both" / "report.json"));
  whole.erase("context");
  both.erase("context");
  EXPECT_EQ(whole, both);
}

TEST(SystemBench, SaysWhichStepASystemNeeds) {
  const Outcome outcome =
      program({"bench", "two-bodies", "--within", "1%", "--engines", "exact,ode"});
  EXPECT_EQ(outcome.code, 0) << outcome.errors;
  for (const char* part : {"two-bodies: 1 % of the shortest cable is 0.01 m, over the first 1 s. A "
                           "step-by-step model needs steps of 0.002 s",
                           "exact   event ", "locates its impacts: 0 % off at 0.01 s"}) {
    EXPECT_NE(outcome.output.find(part), std::string::npos) << part << outcome.output;
  }
}

/// What --within prints of the exact model `event` on a system.
std::string steps_of(const std::string& system, const std::string& part, const std::string& law) {
  const Outcome outcome = program(
      {"bench", system, "--within", part, "--engines", "exact", "--models", "event", "--law", law});
  EXPECT_EQ(outcome.code, 0) << outcome.errors;
  return outcome.output;
}

TEST(SystemBench, SaysOfASystemThatEveryStepTriedIsTooLong) {
  // a step that notices the snap late is off by up to 4 m/s times the step, 1e-5 m is asked for
  const std::string said = steps_of("two-bodies", "0.001%", "simultaneous");
  EXPECT_NE(said.find("A step-by-step model needs steps below 0.0001 s.\n"), std::string::npos)
      << said;
}

TEST(SystemBench, ForetellsNoStepOfASystemUnderALawThatMatters) {
  const std::string cradle = steps_of("newtons-cradle", "1%", "sequential");
  EXPECT_NE(cradle.find("Which step a step-by-step model needs is not known: the plain scheme "
                        "follows the law simultaneous, and the law sequential resolves the impact "
                        "at 0 s in another way.\n"),
            std::string::npos)
      << cradle;
  // one cable is struck alike by every law
  for (const char* const law : {"sequential", "energetic"}) {
    const std::string pair = steps_of("two-bodies", "1%", law);
    EXPECT_NE(pair.find("A step-by-step model needs steps of 0.002 s.\n"), std::string::npos)
        << law << pair;
  }
}

TEST(SystemBench, SearchesNoStepOfAModelThatRefuses) {
  const Outcome outcome = program({"bench", "two-bodies", "--within", "1%", "--engines",
                                   "exact,bullet64", "--models", "event,two-phase"});
  EXPECT_NE(outcome.output.find("not 0.01 s: unsupported: "), std::string::npos) << outcome.output;
}

TEST(SystemBench, RefusesInASentence) {
  const TemporaryFolder folder;
  const std::string out = (folder.path() / "out").string();
  const Outcome law = program({"bench", "parallel-robot", "--law", "energetic", "--out", out});
  EXPECT_EQ(law.code, 2);
  EXPECT_NE(law.errors.find("parallel-robot has 8 cables"), std::string::npos) << law.errors;
  if (built_engines().count("box2d") != 0) {
    const Outcome none = program({"bench", "conical", "--engines", "box2d", "--out", out});
    EXPECT_EQ(none.code, 2);
    EXPECT_NE(none.errors.find("no model of these engines runs systems"), std::string::npos)
        << none.errors;
  }
  const Outcome model = program({"run", "conical", "--engine", "bullet64", "--model", "two-phase"});
  EXPECT_NE(model.output.find("model two-phase has one body in the plane alone"), std::string::npos)
      << model.output;
}

TEST(SystemBench, ASystemInThePlaneMovesInSpaceAsInThePlane) {
  for (const ShippedSystem& shipped : shipped_systems()) {
    const System& planar = shipped.system;
    const SpatialSystem spatial = in_space(planar);
    ASSERT_TRUE(problems(spatial).empty()) << problems(spatial).front();
    const auto one = solve(planar);
    const auto other = solve(spatial);
    const double until = std::min({one.end_time(), other.end_time(), 2.0});
    double worst = 0.0;
    for (int k = 0; k <= 50; ++k) {
      const double time = until * k / 50.0;
      const SystemState in_plane = one.at(time);
      const SpatialSystemState there = other.at(time);
      for (std::size_t body = 0; body < planar.bodies.size(); ++body) {
        worst = std::max(
            worst, (there.bodies[body].position.head<2>() - in_plane.bodies[body].position).norm());
        worst = std::max(worst, std::abs(there.bodies[body].position.z()));
      }
    }
    EXPECT_LE(worst, 1e-9) << planar.name;
  }
}

TEST(SystemBench, ARunComesBitForBit) {
  SystemRunAnswer run;
  SpatialSystemState state{0.25, {SpatialState(), SpatialState()}};
  state.bodies[1].orientation = Quaternion(0.5, -0.5, 0.5, 0.5);
  state.bodies[1].spin = Eigen::Vector3d(1.0 / 3.0, -0.0, 1e-300);
  run.trajectory.points = {{0.25, state}};
  run.trajectory.stop = StopOfRun{0.3, "enough"};
  run.trajectory.tensions = {1.5, -0.0};
  run.trajectory.impacts.resize(2);
  for (auto& impact : run.trajectory.impacts) {
    impact.cable = 1;
    impact.before = impact.after = state;
  }
  const std::string bytes = to_bytes(run);
  const auto answer = answer_from(bytes);
  EXPECT_EQ(to_bytes(answer.value()), bytes);
  EXPECT_FALSE(answer_from(bytes.substr(0, bytes.size() - 8)).has_value());
  run.trajectory.points[0].state.bodies.resize(9);  // one more than a system may have
  EXPECT_TRUE(std::holds_alternative<Failure>(answer_from(to_bytes(run)).value()));
  ASSERT_TRUE(answer && std::holds_alternative<SystemRunAnswer>(*answer));
  const SystemTrajectory& read = std::get<SystemRunAnswer>(*answer).trajectory;
  ASSERT_EQ(read.points.size(), 1U);
  ASSERT_EQ(read.points[0].state.bodies.size(), 2U);
  EXPECT_EQ(read.points[0].state.time, 0.25);
  EXPECT_EQ(read.points[0].state.bodies[1].orientation, state.bodies[1].orientation);
  EXPECT_EQ(read.points[0].state.bodies[1].spin, state.bodies[1].spin);
  EXPECT_EQ(read.stop->reason, "enough");
}

TEST(SystemBench, EnergyIsComparedWhereNothingDrives) {
  const auto gain_of = [](const SpatialSystem& system) {
    const ReferenceSystem reference = solve_case(system, ImpactLaw::simultaneous);
    SystemTrajectory run;
    run.points = {{0.0, system.initial}};
    return compare(system, reference.solution, reference.settling, reference.horizon, run)
        .energy_gain;
  };
  int found = 0;
  for (const ShippedSpatialSystem& shipped : shipped_spatial_systems()) {
    found += shipped.system.name == "conical" || shipped.system.name == "hoisted-load" ? 1 : 0;
    if (shipped.system.name == "conical") {
      EXPECT_TRUE(std::isfinite(gain_of(shipped.system)));
    } else if (shipped.system.name == "hoisted-load") {
      EXPECT_TRUE(std::isnan(gain_of(shipped.system)));
    }
  }
  EXPECT_EQ(found, 2);
}

}  // namespace
}  // namespace tautline::test
