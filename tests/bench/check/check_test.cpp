// `tautline check` on engines with one planted flaw each, and on files that are no engines.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <ostream>
#include <set>

#include "bench/check/claims.hpp"
#include "tests/bench/program.hpp"
#include "tests/bench/schema.hpp"

namespace tautline::test {
namespace {

using nlohmann::json;

/// One flaw, and what the check must say of it.
struct Flaw {
  std::string name;
  std::string claim;             // the one that is about it
  std::string sentence;          // part of what is found there
  std::set<std::string> others;  // the other claims that it breaks: all of them, and no more
};

void PrintTo(const Flaw& flaw, std::ostream* out) { *out << flaw.name; }

/// The only model in the verdicts on a fixture.
json check_fixture(const std::string& name) {
  const Outcome outcome = program({"check", bad_engine(name), "--json", "-"});
  const json verdicts = json::parse(outcome.output, nullptr, false);
  EXPECT_FALSE(verdicts.is_discarded()) << outcome.errors;
  EXPECT_EQ(outcome.code, verdicts.value("holds", false) ? 0 : 1) << outcome.errors;
  return verdicts.at("models").at(0);
}

/// How many claims apply to the fixture `name`.
std::size_t claims_for(const std::string& name) {
  const auto all = bench::claims();
  const bool in_space = name.rfind("space-", 0) == 0;
  return 1U + static_cast<std::size_t>(std::count_if(
                  all.begin(), all.end(),
                  [&](const bench::Claim& claim) { return in_space || !claim.in_space; }));
}

class Flaws : public testing::TestWithParam<Flaw> {};

TEST_P(Flaws, AreFoundWhereTheyAreAndNowhereElse) {
  const Flaw& flaw = GetParam();
  const json model = check_fixture(flaw.name);
  EXPECT_FALSE(model.at("holds"));
  EXPECT_EQ(model.at("findings").size(), claims_for(flaw.name));
  std::set<std::string> broken;
  std::string said;
  for (const json& finding : model.at("findings")) {
    if (!finding.at("holds")) {
      broken.insert(finding.at("claim").get<std::string>());
    }
    if (finding.at("claim") == flaw.claim) {
      said = finding.at("sentence");
    }
  }
  std::set<std::string> wanted = flaw.others;
  wanted.insert(flaw.claim);
  EXPECT_EQ(broken, wanted);
  EXPECT_NE(said.find(flaw.sentence), std::string::npos) << said;
}

std::vector<Flaw> planted_flaws() {
  // every hit rebounds otherwise, and so the motion is another at any step
  const std::set<std::string> rebounds = {"central-restitution", "off-centre-restitution",
                                          "slow-restitution", "convergence"};
  const auto with = [](std::set<std::string> claims, const std::string& claim) {
    claims.insert(claim);
    return claims;
  };
  return {
      {"no-restitution", "central-restitution", "the restitution is ignored", rebounds},
      {"no-restitution", "off-centre-restitution", "the restitution is ignored", rebounds},
      {"twice", "central-restitution", "applied twice, as e^2", rebounds},
      // 2 % more than declared: in one step a hit is told from a spring's
      {"bouncy", "central-restitution", "something adds to the bounce", with(rebounds, "energy")},
      {"threshold",
       "slow-restitution",
       "lost below a threshold: hits at 0.05 m/s do not rebound, those at 0.15 m/s do",
       {}},
      // momenta are reckoned with the declared inertia
      {"wrong-inertia",
       "inertia",
       "as if its inertia were 1.3 times the declared one",
       {"angular-momentum", "step-momentum", "convergence"}},
      // an impulse whose moment is not that of its force does work from nothing
      {"wrong-arm",
       "arm",
       "it does not turn with the body",
       {"angular-momentum", "step-momentum", "off-centre-restitution", "energy", "taut-growth",
        "taut-turning", "convergence"}},
      {"drift",
       "flight",
       "drifts: a body that no cable pulls is off by",
       {"slow-flight", "taut-turning", "convergence"}},
      {"drift",
       "slow-flight",
       "bodies are damped: one at 2 m/s loses 4.88 % of its speed in 2.5 s",
       {"flight", "taut-turning", "convergence"}},
      // no integer fits a fall of 0.7 g h^2
      {"half-substeps", "flight", "drifts: a body that no cable pulls is off by", {}},
      {"capped",
       "fast-flight",
       "speeds are cut to 8 m/s; spins are cut to 30 rad/s, 0.03 rad in a step",
       {}},
      {"braked",
       "slow-flight",
       "slow bodies are braked: one at 0.03 m/s loses 100 % of its speed in 2.5 s",
       {"slow-restitution", "convergence"}},
      // every step of a swing is an impact, as fixed steps of a row have it
      {"braked-swing",
       "taut-turning",
       "a taut swing is braked, though nothing presses it outwards",
       {}},
      {"energy-gain", "energy", "hits add energy", rebounds},
      {"energy-gain", "central-restitution", "something adds to the bounce",
       with(rebounds, "energy")},
      {"float-state",
       "state-echo",
       "rounded to float, although float64 is declared",
       {"precision"}},
      {"float-step", "precision", "is rounded to float in 300 of the 300 steps that change it", {}},
      {"random", "determinism", "not deterministic: a second run of the same case differs", {}},
      {"random-process",
       "determinism",
       "not deterministic: in another process the same case runs otherwise",
       {}},
      {"stops-mirrored",
       "mirror-symmetry",
       "tilted-gravity: the run goes on, its mirror image stops at t = 0.001: the fixture",
       {}},
      {"fixed-step", "flight", "the step is ignored", {"convergence"}},
      {"talkative", "quiet", "the fixture took a step of", {}},
      {"space-no-gyroscopic-term",
       "gyroscopic-term",
       "leaves the gyroscopic term out: a free body turns as if it kept its spin in the world",
       {}},
      // momenta are reckoned with the declared moments
      {"space-wrong-moment",
       "space-inertia",
       "about the second axis turns the body as if its moment were 1.3 times the declared one",
       {"gyroscopic-term", "pair-momentum"}},
      {"space-wrong-arm",
       "space-arm",
       "the arm of an impulse is wrong in space",
       {"pair-momentum", "pair-restitution"}},
      {"space-other-mass",
       "pair-restitution",
       "a mass is left out: a cable between two bodies rebounds as if body 0 alone could move",
       {}},
      {"space-one-sided", "pair-momentum", "it does not pull at both alike", {"pair-restitution"}},
      {"space-still-anchor",
       "moving-anchor",
       "the speed of an anchor does not count as it should",
       {}},
      {"space-world-spin",
       "gyroscopic-term",
       "spins are in the axes of the world, not of the body: a free body turns so",
       {"space-arm", "pair-momentum", "pair-restitution"}},
      {"space-world-spin-told",
       "space-echo",
       "spins are in the axes of the world, not of the body",
       {"space-arm", "pair-momentum", "pair-restitution"}},
      // taken and told alike, which no echo shows: cables are attached elsewhere
      {"space-conjugate",
       "gyroscopic-term",
       "orientations are from the axes of the world to those of the body: a free body turns so",
       {"space-arm", "pair-momentum", "pair-restitution"}},
      {"space-scalar-last",
       "gyroscopic-term",
       "the scalar of a quaternion comes last, not first: a free body turns so",
       {"space-inertia", "space-arm", "pair-momentum", "pair-restitution"}},
      // the motion is right, but the other claims read it from what is told
      {"space-conjugate-told",
       "space-echo",
       "orientations are from the axes of the world to those of the body",
       {"gyroscopic-term", "pair-momentum", "pair-restitution"}},
      {"space-scalar-last-told",
       "space-echo",
       "the scalar of a quaternion comes last, not first",
       {"gyroscopic-term", "pair-momentum", "pair-restitution"}},
      {"space-beside",
       "pair-momentum",
       "changes their angular momentum, by 0.1 of its impulse times its length: it does not pull "
       "at "
       "both along one line",
       {}}};
}

INSTANTIATE_TEST_SUITE_P(Planted, Flaws, testing::ValuesIn(planted_flaws()), [](const auto& test) {
  std::string name = test.param.name + "_" + test.param.claim;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

TEST(Check, FindsNothingWrongWithASoundEngine) {
  for (const std::string name : {"sound", "space-sound"}) {
    const Outcome outcome = program({"check", bad_engine(name)});
    EXPECT_EQ(outcome.code, 0) << outcome.output << outcome.errors;
    const std::string all = "All " + std::to_string(claims_for(name)) + " claims hold.";
    EXPECT_NE(outcome.output.find(all), std::string::npos) << outcome.output;
    EXPECT_NE(outcome.output.find("sound: every claim holds for this model."), std::string::npos);
    EXPECT_EQ(outcome.output.find("does not hold"), std::string::npos);
  }
}

/// `text` on one line.
std::string unwrapped(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

TEST(Check, RefusesAModelOfElasticCablesAlone) {
  if (!built_engines().contains("ode")) {
    GTEST_SKIP() << "ode is not built";
  }
  const Outcome outcome = program({"check", "ode", "--model", "spring"});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_NE(unwrapped(outcome.errors)
                .find("engine ode has nothing to check here. The claims are about inextensible "
                      "cables, and spring runs elastic ones alone: not checked."),
            std::string::npos)
      << outcome.errors;
}

TEST(Check, SaysWhichClaimsInSpaceDoNotApplyAndCountsTheOthers) {
  const std::string in_the_plane = unwrapped(program({"check", bad_engine("sound")}).output);
  EXPECT_NE(in_the_plane.find("All 21 claims hold. Claims that do not apply: space-echo, "
                              "gyroscopic-term, space-inertia, space-arm, pair-momentum, "
                              "pair-restitution and moving-anchor, as sound is an engine of the "
                              "plane."),
            std::string::npos)
      << in_the_plane;
  const std::string at_rest =
      unwrapped(program({"check", bad_engine("space-anchors-at-rest")}).output);
  EXPECT_NE(at_rest.find("All 27 claims hold. Claims that do not apply: moving-anchor, as "
                         "the fixture has anchors at rest alone."),
            std::string::npos)
      << at_rest;
  const json model = check_fixture("space-anchors-at-rest");
  ASSERT_EQ(model.at("not_applying").size(), 1U);
  EXPECT_EQ(model.at("not_applying")[0].at("claim"), "moving-anchor");
  EXPECT_EQ(model.at("not_applying")[0].at("reason"), "the fixture has anchors at rest alone");
  EXPECT_TRUE(check_fixture("space-sound").at("not_applying").empty());
}

/// What `claim` found, of the only model of a fixture that keeps it.
std::string said_of(const std::string& fixture, const std::string& claim) {
  const json model = check_fixture(fixture);
  EXPECT_TRUE(model.at("holds")) << model.dump(2);
  for (const json& finding : model.at("findings")) {
    if (finding.at("claim") == claim) {
      return finding.at("sentence");
    }
  }
  return "none";
}

TEST(Check, NamesSubstepsAndArctangentsAndTakesThem) {
  EXPECT_EQ(said_of("substeps", "flight"), "flies 4 substeps of semi-implicit Euler");
  // 0.4 - 4 atan(0.1)
  EXPECT_EQ(said_of("arctangent", "flight"),
            "flies semi-implicit Euler, velocity first; turns by 4 atan(spin dt / 4), 0.0013 rad "
            "short of 0.4");
}

TEST(Check, NeverSaysThatNoNumberIsOffBySomething) {
  for (const std::string name : {"nan", "inf"}) {
    const Outcome outcome = program({"check", bad_engine(name)});
    EXPECT_EQ(outcome.code, 1);
    // the last sentence has the name of the fixture
    const std::string said =
        outcome.output.substr(0, outcome.output.find("Claims that do not apply"));
    EXPECT_EQ(said.find(" inf "), std::string::npos) << said;
    EXPECT_EQ(said.find(" nan "), std::string::npos) << said;
  }
}

TEST(Check, EndsItsTableWithWhatDoesNotHold) {
  const Outcome outcome = program({"check", bad_engine("threshold"), "--model", "row"});
  EXPECT_EQ(outcome.code, 1);
  EXPECT_NE(outcome.output.find(" claims does not hold: slow-restitution."), std::string::npos)
      << outcome.output;
  EXPECT_NE(outcome.output.find("threshold: 0 of 1 models keep every claim; row does not."),
            std::string::npos)
      << outcome.output;
}

/// True if `verdicts` is what the schema says.
bool is_sound_json(const json& verdicts) { return keeps_the_schema(verdicts, "check"); }

TEST(EnginesSchema, DescribesTheListOfEngines) {
  const json engines = json::parse(program({"engines", "--json", "-"}).output);
  EXPECT_TRUE(keeps_the_schema(engines, "engines"));
  json other = engines;
  other["engines"][0].erase("plugin");
  EXPECT_FALSE(keeps_the_schema(other, "engines"));
}

TEST(CheckSchema, AcceptsEveryKindOfVerdictAndNothingElse) {
  for (const std::string name : {"sound", "space-sound", "wrong-arm", "segfault", "nan"}) {
    const Outcome outcome = program({"check", bad_engine(name), "--json", "-"});
    json verdicts = json::parse(outcome.output, nullptr, false);
    ASSERT_FALSE(verdicts.is_discarded()) << name << outcome.errors;
    EXPECT_TRUE(is_sound_json(verdicts)) << verdicts.dump(2);
    verdicts["models"][0]["findings"][0].erase("sentence");
    EXPECT_FALSE(is_sound_json(verdicts));
  }
}

/// What the first finding that does not hold says, and of which claim.
std::string first_fault(const json& model) {
  for (const json& finding : model.at("findings")) {
    if (!finding.at("holds")) {
      return finding.at("claim").get<std::string>() + ": " +
             finding.at("sentence").get<std::string>();
    }
  }
  return "none";
}

TEST(Check, TellsOfACrashWhichClaimItWasAndKeepsWhatWasFoundBefore) {
  for (const auto& [name, sentence] :
       {std::pair("segfault", "precision: crashed: SIGSEGV"),
        std::pair("abort", "precision: crashed: SIGABRT"),
        std::pair("exit", "precision: ended by itself with exit code 0 and no result")}) {
    const json model = check_fixture(name);
    EXPECT_EQ(first_fault(model), sentence);
    EXPECT_EQ(model.at("findings").at(0).at("claim"), "state-echo");
    EXPECT_TRUE(model.at("findings").at(0).at("holds"));
  }
}

TEST(Check, EndsAHangingModelAtTheTimeLimit) {
  const Outcome outcome = program({"check", bad_engine("hang"), "--time-limit", "2"});
  EXPECT_EQ(outcome.code, 1);
  EXPECT_NE(outcome.output.find("timed out after 2 s"), std::string::npos) << outcome.output;
  EXPECT_NE(outcome.output.find("were not measured"), std::string::npos) << outcome.output;
}

/// True if a finding that does not hold says `sentence`.
bool complains(const json& model, const std::string& sentence) {
  return std::any_of(model.at("findings").begin(), model.at("findings").end(),
                     [&](const json& finding) {
                       const std::string said = finding.at("sentence");
                       return !finding.at("holds") && said.find(sentence) != std::string::npos;
                     });
}

TEST(Check, IsNotFooledByWhatMakesNoSense) {
  const std::pair<std::string, std::string> fixtures[] = {
      {"nan", "x is NaN at t = 0.1"},
      {"inf", "x is infinity at t = 0.1"},
      {"throw", "the engine threw: the fixture throws at step 10"},
      {"own-exception", "the engine threw: an error of the module's own"},
      {"gives-up", "the run stopped at t = 0.1: the fixture has had enough"},
      {"stop-first", "the run stopped at t = 0: the fixture does not do this case"},
      {"stop-nan", "the run stopped at t = NaN"},
      {"no-impulses", "it gives 0 impulses for 1 cables"},
      {"wrong-cable", "it gives an event of a cable that is not of the case"},
      {"no-taut-motion", "the cable is never hit"}};
  for (const auto& [name, sentence] : fixtures) {
    EXPECT_TRUE(complains(check_fixture(name), sentence)) << name << ": " << sentence;
  }
}

/// True if the program has an answer to what the fixture is, and runs it.
bool is_loaded(const std::string& fixture) {
  const Outcome outcome = program({"check", bad_engine(fixture), "--json", "-"});
  EXPECT_EQ(outcome.errors, "");
  return outcome.code == 1;  // it flies through its cables
}

TEST(CheckLoads, APluginByClang) { EXPECT_TRUE(is_loaded("clang")); }

TEST(CheckLoads, APluginWithVectorFlagsThatKeepsTheAlignment) {
  if (!std::filesystem::exists(bad_engine("vector-flags"))) {
    GTEST_SKIP() << "this processor is no x86-64";
  }
  const Outcome refused = program({"check", bad_engine("vector-flags")});
  EXPECT_EQ(refused.code, 2);
  EXPECT_NE(refused.errors.find("keep them, and add -DEIGEN_MAX_STATIC_ALIGN_BYTES=16"),
            std::string::npos)
      << refused.errors;
  if (__builtin_cpu_supports("avx")) {  // which its code is of
    EXPECT_TRUE(is_loaded("vector-flags-aligned"));
  }
}

/// A folder with the fixture "braked" and a contract.toml of `text`; gone with it.
class WithContract {
 public:
  explicit WithContract(const std::string& text) {
    std::filesystem::create_symlink(bad_engine("braked"), plugin_);
    (void)folder_.file("contract.toml", text);
  }
  [[nodiscard]] Outcome check(std::vector<std::string> more = {}) const {
    more.insert(more.begin(), {"check", plugin_.string()});
    return program(more);
  }

 private:
  TemporaryFolder folder_;
  std::filesystem::path plugin_ = folder_.path() / "braked.so";
};

TEST(CheckContract, TakesWhatIsKnownFromTheFileBesideThePlugin) {
  const WithContract braked(
      "[[exception]]\nmodel = 'row'\nclaims = ['slow-flight', 'slow-restitution', 'convergence']\n"
      "reason = 'so'\n"
      "[[exception]]\nengine = 'other'\nmodel = 'rope'\nclaims = ['mass']\nreason = 'so'\n");
  const Outcome outcome = braked.check({"--json", "-"});
  EXPECT_EQ(outcome.code, 0) << outcome.output << outcome.errors;
  const json verdicts = json::parse(outcome.output);
  EXPECT_TRUE(verdicts.at("holds"));
  EXPECT_TRUE(is_sound_json(verdicts)) << verdicts.dump(2);
  const std::string text = braked.check().output;
  EXPECT_NE(text.find("All other 18 claims hold. Violations listed in contract.toml: "),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("this model, except the listed violations."), std::string::npos);
}

TEST(CheckContract, FailsWhereAClaimHoldsThatIsSaidNotTo) {
  const WithContract braked(
      "[[exception]]\nmodel = 'row'\nclaims = ['slow-flight', 'mass']\nreason = 'so'\n");
  const Outcome outcome = braked.check();
  EXPECT_EQ(outcome.code, 1);
  EXPECT_NE(outcome.output.find("holds now"), std::string::npos) << outcome.output;
}

TEST(CheckContract, IsRefusedWhereItIsUnsound) {
  const WithContract braked("[[exception]]\nmodel = 'rows'\nclaims = ['mass']\nreason = 'so'\n");
  const Outcome outcome = braked.check();
  EXPECT_EQ(outcome.code, 2);
  EXPECT_NE(outcome.errors.find("contract.toml:1: unknown model rows"), std::string::npos)
      << outcome.errors;
}

/// Words and what the complaint must say.
struct Misuse {
  std::vector<std::string> arguments;
  int code;
  std::string sentence;
};

TEST(Check, RefusesWhatIsNotAPluginInClearSentences) {
  const Misuse misuses[] = {
      {{"check"}, 2, "PLUGIN is required"},
      {{"check", "/no/such/engine.so"}, 2, "no such file; give the path of a plug-in (.so)"},
      {{"check", TAUTLINE_FIXTURE_DIR}, 2, "is a directory; give the path of a plug-in (.so)"},
      {{"check", "/dev/null"}, 2, "is no regular file; give the path of a plug-in (.so)"},
      {{"check", TAUTLINE_README}, 2, "not a shared library that can be loaded"},
      {{"check", bad_engine("wrong-interface")}, 2, "built against another interface"},
      {{"check", bad_engine("mute")}, 1, "crashed: SIGSEGV"},
      {{"check", "exakt"}, 2, "unknown engine exakt; did you mean exact?"},
      {{"check", "exact", "--model", "events"}, 2, "unknown model events; did you mean event?"},
      {{"check", "exact", "--time-limit", "0"}, 2, "--time-limit 0: must be above 0 [s]"}};
  for (const Misuse& misuse : misuses) {
    const Outcome outcome = program(misuse.arguments);
    EXPECT_EQ(outcome.code, misuse.code) << misuse.sentence;
    EXPECT_NE(outcome.errors.find(misuse.sentence), std::string::npos) << outcome.errors;
    EXPECT_EQ(outcome.output, "") << misuse.sentence;
  }
}

}  // namespace
}  // namespace tautline::test
