// Engines that tell what their cables pull with, beside statics.

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "tests/bench/program.hpp"
#include "tests/bench/run/protocol_support.hpp"

namespace tautline::test::tensions {
namespace {

using nlohmann::json;

/// A box of 5 kg on two vertical ropes, let go 0.05 m above their end.
const std::string hanging_box =
    "name = \"hanging-box\"\nduration = 4.0\ngravity = [0.0, -9.81]\n"
    "[body]\nmass = 5.0\ninertia = 0.8333333333333334\n"
    "[[cables]]\nanchor = [-0.5, 5.0]\nattachment = [-0.5, 0.5]\nlength = 3.0\nrestitution = 0.0\n"
    "[[cables]]\nanchor = [0.5, 5.0]\nattachment = [0.5, 0.5]\nlength = 3.0\nrestitution = 0.0\n"
    "[initial]\nposition = [0.0, 1.55]\n";

/// Models that have a cable's impulse from their engine.
const std::set<std::pair<std::string, std::string>> told = {
    {"exact", "sampled"},  {"exact", "event"},  {"bullet64", "row"},   {"bullet64", "cable"},
    {"bullet64", "event"}, {"bullet32", "row"}, {"bullet32", "cable"}, {"bullet32", "event"},
    {"ode", "row"},        {"ode", "cable"},    {"ode", "event"}};

TEST(TensionOfEngines, AtRestIsHalfTheWeightToAPercent) {
  const TemporaryFolder folder;
  const std::string box = folder.file("box.toml", hanging_box).string();
  const std::set<std::string> built = built_engines();
  const std::string engines =
      built.contains("bullet32") ? "exact,bullet64,bullet32,ode" : "exact,bullet64,ode";
  const Outcome outcome =
      program({"bench", box, "--engines", engines, "--models", "sampled,event,row,cable", "--steps",
               "1e-3", "--out", (folder.path() / "results").string()});
  ASSERT_EQ(outcome.code, 0) << outcome.errors;
  const json runs = json::parse(content_of(folder.path() / "results/report.json"))["runs"];
  std::set<std::pair<std::string, std::string>> found;
  for (const json& run : runs) {
    const std::string name =
        run["engine"].get<std::string>() + " " + run["model"].get<std::string>();
    const json& tension = run["details"]["rest_tension"];
    if (tension.is_null()) {
      continue;
    }
    found.emplace(run["engine"].get<std::string>(), run["model"].get<std::string>());
    EXPECT_NEAR(tension["exact"].get<double>(), 24.525, 1e-10) << name;
    EXPECT_NEAR(tension["found"].get<double>(), 24.525, 0.01 * 24.525) << name;
    EXPECT_NEAR(run["metrics"]["rest_tension_error"].get<double>(),
                std::abs(tension["found"].get<double>() - 24.525), 1e-9)
        << name;
  }
  for (const auto& one : told) {
    EXPECT_EQ(found.contains(one), built.contains(one.first)) << one.first << " " << one.second;
  }
}

// v = 6 at the bottom of a circle of 3 m, gravity 2: m v^2 / L + m g, in each of five turns
TEST(TensionOfEngines, OfAMotionThatRepeatsIsComparedWithThatOfItsPeriod) {
  const TemporaryFolder folder;
  const std::string circle =
      folder
          .file("circle.toml",
                "name = \"circle\"\nduration = 20.0\ngravity = [0.0, -2.0]\n"
                "[body]\nmass = 1.0\ninertia = 0.0\n"
                "[[cables]]\nanchor = [0.0, 0.0]\nattachment = [0.0, 0.0]\nlength = 3.0\n"
                "restitution = 0.5\n"
                "[initial]\nposition = [0.0, -3.0]\nvelocity = [6.0, 0.0]\n")
          .string();
  for (const auto& [engine, model] :
       {std::pair("exact", "sampled"), std::pair("bullet64", "cable")}) {
    const std::string out = (folder.path() / engine).string();
    const Outcome outcome = program({"run", circle, "--engine", engine, "--model", model, "--step",
                                     "1e-3", "--out", out, "--json", "-"});
    ASSERT_EQ(outcome.code, 0) << outcome.errors;
    const json found = json::parse(outcome.output)["details"]["largest_tension"];
    EXPECT_NEAR(found["exact"].get<double>(), 14.0, 1e-5) << engine;  // the mean over a step
    EXPECT_NEAR(found["found"].get<double>(), 14.0, 1e-4) << engine;
  }
}

TEST(TensionOfEngines, OfABodyAsleepIsNotKnown) {
  const TemporaryFolder folder;
  const std::string box = folder.file("box.toml", hanging_box).string();
  const Outcome outcome =
      program({"run", box, "--engine", "bullet64", "--model", "row-sleeping", "--step", "1e-3",
               "--out", (folder.path() / "results").string(), "--json", "-"});
  ASSERT_EQ(outcome.code, 0) << outcome.errors;
  EXPECT_TRUE(json::parse(outcome.output).at("details").at("rest_tension").is_null());
}

constexpr const char* told_header = "time,x,y,angle,vx,vy,spin,event,tension_0,tension_1";
constexpr const char* untold_header = "time,x,y,angle,vx,vy,spin,event";

/// Runs model "row" of the engine called `name` on the hanging box: the first line of its
/// trajectory, and what it finds.
std::pair<std::string, json> row_of(const TemporaryFolder& folder, const std::string& engine,
                                    const std::string& name) {
  const std::string box = folder.file("box.toml", hanging_box).string();
  const std::filesystem::path results = folder.path() / ("of-" + name);
  const Outcome outcome = program({"run", box, "--engine", engine, "--model", "row", "--step",
                                   "1e-2", "--out", results.string(), "--json", "-"});
  EXPECT_EQ(outcome.code, 0) << outcome.errors;
  const std::string csv =
      content_of(results / "runs/hanging-box" / name / "row/0.01/trajectory.csv");
  return {csv.substr(0, csv.find('\n')), json::parse(outcome.output)};
}

/// Expects the example of a kit, the engine `name` in `kit`, to tell its tensions.
void expect_told(const TemporaryFolder& folder, const std::string& kit, const std::string& name) {
  const auto [header, result] = row_of(folder, kit + "/example/engine.toml", name);
  EXPECT_EQ(header, told_header) << name;
  EXPECT_NEAR(result["details"]["rest_tension"]["found"].get<double>(), 24.525, 0.01 * 24.525)
      << name;
}

/// The source of an example with these words put for others, each of which it has.
std::string changed(std::string source,
                    const std::vector<std::pair<std::string, std::string>>& changes) {
  for (const auto& [from, to] : changes) {
    const std::size_t place = source.find(from);
    EXPECT_NE(place, std::string::npos) << from;
    source.replace(place, place == std::string::npos ? 0 : from.size(), to);
  }
  return source;
}

// an engine in another language says so of a model; a kit from before it was there does not
TEST(TensionOfEngines, InAnotherProcessIsToldByTheModelThatHasIt) {
  if (!has_python()) {
    GTEST_SKIP() << no_python;
  }
  const TemporaryFolder folder;
  const std::string kit = TAUTLINE_PYTHON_KIT;
  expect_told(folder, kit, "python-example");
  std::filesystem::create_directory(folder.path() / "old");
  (void)folder.file("old/engine.py",
                    changed(content_of(kit + "/example/engine.py"),
                            {{"\"tension\": True, ", ""}, {"python-example", "old"}}));
  (void)folder.file("old/tautline_engine.py", content_of(kit + "/tautline_engine.py"));
  const std::filesystem::path untold =
      folder.file("old/engine.toml", "name = \"old\"\ncommand = [\"python3\", \"engine.py\"]\n");
  EXPECT_EQ(row_of(folder, untold.string(), "old").first, untold_header);
}

#ifdef TAUTLINE_JAVASCRIPT_KIT  // node is there
TEST(TensionOfEngines, InNodeIsToldByTheModelThatHasIt) {
  const TemporaryFolder folder;
  const std::string kit = TAUTLINE_JAVASCRIPT_KIT;
  expect_told(folder, kit, "example-js");
  std::filesystem::create_directory(folder.path() / "old");
  (void)folder.file("old/engine.mjs", changed(content_of(kit + "/example/engine.mjs"),
                                              {{"  tension: true,\n", ""}, {"example-js", "old"}}));
  for (const char* part : {"engine.mjs", "cable.mjs"}) {
    (void)folder.file(part, content_of(kit + "/" + part));
  }
  const std::filesystem::path untold =
      folder.file("old/engine.toml", "name = \"old\"\ncommand = [\"node\", \"engine.mjs\"]\n");
  EXPECT_EQ(row_of(folder, untold.string(), "old").first, untold_header);
}
#endif

}  // namespace
}  // namespace tautline::test::tensions
