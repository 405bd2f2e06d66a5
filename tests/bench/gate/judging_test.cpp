// Verdicts on reports made by hand, and what breaks the gate.

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

#include "bench/gate/broken.hpp"
#include "bench/gate/gate_text.hpp"
#include "bench/gate/verdict.hpp"
#include "bench/report/tables.hpp"
#include "bench/report/words.hpp"
#include "tests/bench/gate/made_report.hpp"

namespace tautline::bench::test {
namespace {

RunPattern runs_of(const std::string& engine) {
  RunPattern runs;
  runs.engine = engine;
  return runs;
}

/// One limit on every run.
Limits limits_with(const std::string& metric, double limit) {
  Limits limits;
  limits.file = "made.toml";
  limits.version = "1";
  limits.limits = {{RunPattern(), metric, limit, 0.0, 0.0, "a reason"}};
  return limits;
}

/// A report of one run of one engine, "e".
Report report_of(double value, double step = 1e-3) {
  Report report = made_report();
  add_engine(report, "e");
  add_run(report, "e", value, step);
  return report;
}

TEST(Pattern, OnlyStarsQuestionMarksAndBarsAreSpecial) {
  const auto on = [](const std::string& pattern, const std::string& name) {
    RunPattern runs;
    runs.model = pattern;
    return runs.holds({"c/d", "e", name, 1e-3}, "float64");
  };
  EXPECT_TRUE(on("r?w*", "row-early"));
  EXPECT_TRUE(on("row[2]", "row[2]"));
  EXPECT_FALSE(on("row[2]", "row2"));
  EXPECT_TRUE(on("a\\*", "a\\b"));
  EXPECT_FALSE(on("a\\*", "a*"));
  EXPECT_TRUE(on("row|ear*", "row"));
  EXPECT_TRUE(on("row|ear*", "early"));
  EXPECT_FALSE(on("row|ear*", "row|early-bird"));
  EXPECT_FALSE(on("row|ear*", "rows"));
}

TEST(Limits, EachOfSeveralPatternsMustNameSomethingThatIsThere) {
  LimitNames names;
  names.engines = {{"e", std::vector<std::string>{"row", "early"}}};
  names.cases = {"c/one", "c/two", "ball"};
  const auto problems = [&](const std::string& model, const std::string& the_case) {
    return read_limits_text("schema = 1\nversion = \"1\"\n[[limits]]\nengine = \"e\"\nmodel = \"" +
                                model + "\"\ncase = \"" + the_case +
                                "\"\nmetric = \"overstretch\"\nlimit = 0.5\nunit = \"m\"\n"
                                "reason = \"r\"\n",
                            "l.toml", names)
        .problems.size();
  };
  EXPECT_EQ(problems("row|early", "c/*|ball"), 0U);
  EXPECT_EQ(problems("row|none", "c/*|ball"), 1U);
  EXPECT_EQ(problems("row|early", "ball|c/three"), 1U);
}

TEST(Pattern, HoldsForAllThatItNamesTogether) {
  const RunKey run = {"c/d", "e", "row", 1e-3};
  RunPattern runs;
  runs.the_case = "c/*";
  runs.step = 0.1 * 0.01;  // up to rounding
  runs.precision = "float32";
  EXPECT_TRUE(runs.holds(run, "float32"));
  EXPECT_FALSE(runs.holds(run, "float64"));
  EXPECT_FALSE(runs.holds(run, ""));
  runs.step = 2e-3;
  EXPECT_FALSE(runs.holds(run, "float32"));
}

TEST(Limits, AreOnAnyMetricOfTheListInItsUnit) {
  for (const Metric& metric : metric_list()) {
    const std::string name(metric.name);
    const LimitsReading reading = read_limits_text(
        "schema = 1\nversion = \"1\"\n[[limits]]\nengine = \"*\"\nmodel = \"*\"\nmetric = \"" +
            name + "\"\nlimit = 0.5\nunit = \"" + std::string(metric.unit) + "\"\nreason = \"r\"\n",
        "l.toml");
    ASSERT_TRUE(reading.limits) << name << reading.problems.front();
    Report report = report_of(0.6);
    add_verdicts(report, *reading.limits);
    const Verdict& verdict = report.runs.front().verdict.value();
    ASSERT_EQ(verdict.checks.size(), 1U) << name;
    EXPECT_EQ(verdict.checks.front().metric, name);
    EXPECT_EQ(verdict.word, Word::breaks_limit) << name;
  }
}

TEST(Verdict, AMetricAtItsLimitPasses) {
  Report report = report_of(0.25);
  add_verdicts(report, limits_with("overstretch", 0.25));
  const Verdict& verdict = report.runs.front().verdict.value();
  EXPECT_EQ(verdict.word, Word::pass);
  ASSERT_EQ(verdict.checks.size(), 1U);
  EXPECT_EQ(verdict.checks.front().reason, "a reason");
  ASSERT_TRUE(report.limits);
  EXPECT_EQ(report.limits->file, "made.toml");
}

TEST(Verdict, OfAMetricThatCouldNotBeMeasuredIsLeftToTheOthersAndTold) {
  Limits limits = limits_with("overstretch", 0.25);
  limits.limits.push_back({RunPattern(), "first_impact_error", 0.25, 0.0, 0.0, "another"});
  Report report = report_of(0.25);
  report.runs.front().metrics->at(place("first_impact_error")) = std::nullopt;
  add_verdicts(report, limits);
  const Verdict& verdict = report.runs.front().verdict.value();
  EXPECT_EQ(verdict.word, Word::pass);
  ASSERT_EQ(verdict.checks.size(), 2U);
  EXPECT_EQ(verdict.checks.front().metric, "first_impact_error");
  EXPECT_EQ(verdict.checks.front().holds, Holds::not_measured);
  EXPECT_NE(runs_table(report).markdown().find("could not be measured: first impact error"),
            std::string::npos);
  report.runs.front().metrics->at(place("overstretch")) = std::nullopt;
  add_verdicts(report, limits);
  EXPECT_EQ(verdict_text(*report.runs.front().verdict),
            "not judged: nothing that has a limit could be measured");
}

/// Something that the audit finds in the run of "e".
Finding finding(const std::string& kind, double step = 1e-3) {
  Finding found;
  found.engine = "e";
  found.model = "row";
  found.kind = kind;
  found.sentence = "it is so";
  found.shown_in = {{"ball", step}};
  return found;
}

TEST(Verdict, OfARunThatShowsAFindingIsNeverAPass) {
  Limits limits = limits_with("overstretch", 0.25);
  for (const FindingKind& kind : finding_kinds) {
    const std::string name(kind.name);
    Report report = report_of(0.25);
    add_run(report, "e", 0.25, 1e-2);  // it is not found in this one
    report.findings = {finding(name)};
    limits.known.clear();
    add_verdicts(report, Limits());
    EXPECT_EQ(report.runs[0].verdict->word, Word::not_judged) << "there is nothing to contradict";
    add_verdicts(report, limits);
    EXPECT_EQ(report.runs[0].verdict->word,
              contradicts_a_pass(kind.name) ? Word::breaks_limit : Word::pass)
        << name;
    EXPECT_EQ(report.runs[1].verdict->word, Word::pass) << name;
    if (contradicts_a_pass(kind.name)) {
      EXPECT_EQ(report.runs[0].verdict->checks.front().reason, "it is so");
      ASSERT_EQ(broken_rows(report, limits).size(), 1U);
      EXPECT_EQ(broken_rows(report, limits).front().value, "found");
    }
    for (const std::string& known : {name, std::string(any_finding)}) {
      limits.known = {{runs_of("e"), known, "the engine says so"}};
      add_verdicts(report, limits);
      EXPECT_EQ(report.runs[0].verdict->word,
                contradicts_a_pass(kind.name) ? Word::known_deviation : Word::pass)
          << name;
      EXPECT_TRUE(broken_rows(report, limits).empty()) << name;
    }
  }
}

TEST(Verdict, TheLastLimitOnARunCountsAndGrowsWithTheStep) {
  Limits limits = limits_with("overstretch", 0.5);
  limits.limits.push_back({runs_of("e"), "overstretch", 0.25, 2.0, 0.001, "the special"});
  limits.limits.push_back({runs_of("other"), "overstretch", 9.0, 0.0, 0.0, "of another"});
  Report report = report_of(0.1, 1e-2);
  add_verdicts(report, limits);
  const Check& check = report.runs.front().verdict.value().checks.at(0);
  EXPECT_DOUBLE_EQ(check.limit.value(), 0.25 + 2.0 * 1e-2 + 0.001 / 1e-2);
  EXPECT_EQ(check.reason, "the special");
}

TEST(Verdict, WordsFollowFromStatusLimitsAndWhatIsNotJudged) {
  const Limits none;
  Report report = report_of(1.0);
  add_verdicts(report, none);
  EXPECT_EQ(verdict_text(*report.runs.front().verdict), "not judged: no limit is on it");
  Limits limits = limits_with("overstretch", 2.0);
  add_verdicts(report, limits);
  EXPECT_EQ(report.runs.front().verdict->word, Word::pass);
  report.runs.front().status = Status::stopped;
  report.runs.front().reason = "a cable is taut";
  add_verdicts(report, limits);
  EXPECT_EQ(verdict_text(*report.runs.front().verdict),
            "not judged: the model goes no further: a cable is taut");
  report.runs.front().status = Status::diverged;
  add_verdicts(report, limits);
  EXPECT_EQ(report.runs.front().verdict->word, Word::breaks_limit);
  limits.unjudged = {{runs_of("e"), "first"}, {runs_of("e"), "last"}};
  add_verdicts(report, limits);
  EXPECT_EQ(report.runs.front().verdict->word, Word::breaks_limit);  // to fail is judged always
  limits.known = {{runs_of("e"), std::string(failure), "it does"}};
  limits.unjudged.clear();
  add_verdicts(report, limits);
  EXPECT_EQ(report.runs.front().verdict->word, Word::known_deviation);
  limits.known.clear();
  limits.unjudged = {{runs_of("e"), "first"}, {runs_of("e"), "last"}};
  report.runs.front().status = Status::finished;
  add_verdicts(report, limits);
  EXPECT_EQ(verdict_text(*report.runs.front().verdict), "not judged: last");
}

TEST(Gate, ABrokenLimitIsARowWithValueLimitUnitAndReason) {
  const Limits limits = limits_with("overstretch", 1e-3);
  Report report = report_of(0.0125);
  report.runs.front().key.model = "ro\033w";  // as a plug-in may call it
  add_verdicts(report, limits);
  const std::vector<BrokenRow> rows = broken_rows(report, limits);
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_EQ(rows[0].model, "ro\\x1bw");
  EXPECT_EQ(rows[0].metric, "overstretch");
  EXPECT_EQ(rows[0].value, "0.0125 m");
  EXPECT_EQ(rows[0].limit, "0.001 m");
  EXPECT_EQ(rows[0].reason, "a reason");
  const std::string text = gate_text(report, limits, rows);
  EXPECT_NE(text.find("The gate is broken by 1 row (made.toml, version 1): 1 breaks a limit."),
            std::string::npos)
      << text;
}

TEST(Gate, HoldsWhileAKnownDeviationLastsAndIsBrokenWhenItStartsToHold) {
  Limits limits = limits_with("overstretch", 1e-3);
  limits.known = {{runs_of("e"), "overstretch", "it stretches"}};
  Report report = report_of(1.0);
  add_verdicts(report, limits);
  EXPECT_TRUE(report.runs.front().verdict->checks.front().known);
  EXPECT_EQ(report.runs.front().verdict->word, Word::known_deviation);
  EXPECT_TRUE(broken_rows(report, limits).empty());
  EXPECT_EQ(gate_text(report, limits, {}),
            "The gate holds (made.toml, version 1): 1 known deviation.\n");
  add_run(report, "e", 0.0, 1e-4);  // another run of the entry holds
  add_verdicts(report, limits);
  EXPECT_TRUE(broken_rows(report, limits).empty());
  report.runs.erase(report.runs.begin());
  add_verdicts(report, limits);
  const std::vector<BrokenRow> rows = broken_rows(report, limits);
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_NE(rows[0].reason.find("has started to hold"), std::string::npos) << rows[0].reason;
}

TEST(Gate, AKnownDeviationThatNoLimitTellsOrNoRunShows) {
  Limits limits = limits_with("overstretch", 1.0);
  limits.known = {{runs_of("absent"), "overstretch", "r"}};
  Report report = report_of(0.5);
  add_verdicts(report, limits);
  EXPECT_TRUE(broken_rows(report, limits).empty());  // an engine that is not here says nothing
  limits.known = {{runs_of("e"), "energy_gain", "r"}};
  add_verdicts(report, limits);
  ASSERT_EQ(broken_rows(report, limits).size(), 1U);
  EXPECT_EQ(broken_rows(report, limits)[0].value, "not checked");
}

TEST(Gate, AKnownDeviationOfSomeRunsNeedNotShowInAReport) {
  Limits limits = limits_with("overstretch", 1.0);
  limits.known = {{runs_of("e"), "overstretch", "it may", true}};
  Report report = report_of(0.5);
  add_verdicts(report, limits);
  EXPECT_TRUE(broken_rows(report, limits).empty());
  EXPECT_NE(gate_text(report, limits, {}).find("1 of 1 [[known]] entries are shown by no run"),
            std::string::npos);
}

TEST(Gate, ALimitThatCouldBeMeasuredOnNoRunBreaksIt) {
  Limits limits = limits_with("overstretch", 1.0);
  limits.limits.push_back({RunPattern(), "first_impact_error", 0.25, 0.0, 0.0, "another"});
  Report report = report_of(0.5);
  report.runs.front().metrics->at(place("first_impact_error")) = std::nullopt;
  add_verdicts(report, limits);
  const std::vector<BrokenRow> rows = broken_rows(report, limits);
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_EQ(rows[0].metric, "first_impact_error");
  EXPECT_EQ(rows[0].value, "not measured");
  add_run(report, "e", 0.125, 1e-2);  // one run is enough
  add_verdicts(report, limits);
  EXPECT_TRUE(broken_rows(report, limits).empty());
}

TEST(Gate, SaysWhichEntriesAreAboutNoRun) {
  Limits limits = limits_with("overstretch", 1.0);
  limits.limits.push_back({runs_of("absent"), "overstretch", 2.0, 0.0, 0.0, "r"});
  limits.known = {{runs_of("absent"), "energy_gain", "r"}};
  Report report = report_of(0.5);
  add_verdicts(report, limits);
  EXPECT_EQ(gate_text(report, limits, broken_rows(report, limits)),
            "1 of 1 [[known]] entries are about no run of this report: absent * "
            "energy_gain.\n"
            "1 of 2 limits are about no run of this report.\n"
            "The gate holds (made.toml, version 1): 1 pass.\n");
}

/// A limits file with one entry of a kind on these runs.
std::string entry_on(const std::string& engine, const std::string& model,
                     const std::string& the_case) {
  return "schema = 1\nversion = \"1\"\n[[limits]]\nengine = \"*\"\nmodel = \"*\"\n"
         "metric = \"overstretch\"\nlimit = 1.0\nunit = \"m\"\nreason = \"r\"\n"
         "[[known]]\nengine = \"" +
         engine + "\"\nmodel = \"" + model + "\"\ncase = \"" + the_case +
         "\"\nmetric = \"overstretch\"\nreason = \"r\"\n";
}

TEST(Limits, NamesThatThereAreNotAreMistakesWithTheNearestBesideThem) {
  LimitNames names;
  names.engines = {{"bullet64", std::vector<std::string>{"row", "contact"}}, {"ode", std::nullopt}};
  names.cases = {"breakwater/1910121100", "ball"};
  const auto problem = [&](const char* engine, const char* model, const char* the_case) {
    const LimitsReading reading = read_limits_text(entry_on(engine, model, the_case), "l", names);
    return reading.problems.empty() ? "" : reading.problems.front();
  };
  EXPECT_EQ(problem("bullet*", "r?w", "breakwater/19*"), "");
  EXPECT_EQ(problem("ode", "anything", "*"), "") << "it cannot be asked";
  EXPECT_EQ(problem("*", "anything", "*"), "") << "one of them cannot be asked";
  EXPECT_EQ(problem("of-my-own", "anything", "my/case"), "") << "need not be there each time";
  EXPECT_EQ(problem("bulet64", "row", "*"),
            "l:11: known[0].engine = \"bulet64\": there is no such engine; did you mean bullet64?");
  EXPECT_EQ(problem("bullet64", "rwo", "*"),
            "l:12: known[0].model = \"rwo\": no engine that this means has such a model; did you "
            "mean row?");
  EXPECT_EQ(
      problem("bullet64", "tendon", "*"),
      "l:12: known[0].model = \"tendon\": no engine that this means has such a model, must be "
      "contact or row");
  EXPECT_EQ(problem("bullet64", "row", "breakwater/20*"),
            "l:13: known[0].case = \"breakwater/20*\": there is no such case");
  EXPECT_EQ(problem("bullet64", "row", "bal"),
            "l:13: known[0].case = \"bal\": there is no such case; did you mean ball?");
}

TEST(Gate, RunsAndEnginesThatFailBreakItEvenWhereTheyAreNotJudged) {
  Limits limits = limits_with("overstretch", 1.0);
  limits.unjudged = {{runs_of("bad"), "r"}};
  Report report = report_of(0.5);
  add_engine(report, "bad");
  add_bad_run(report, "bad", Status::failed, "crashed: SIGSEGV");
  report.engines.push_back({"broken", std::nullopt, "has no entry point", false});
  report.engines.push_back({"absent", std::nullopt, "is not here", true});
  add_verdicts(report, limits);
  std::vector<BrokenRow> rows = broken_rows(report, limits);
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0].engine, "broken");
  EXPECT_EQ(rows[0].value, "no runs");
  EXPECT_EQ(rows[1].metric, "failure");
  EXPECT_EQ(rows[1].value, "failed");
  EXPECT_EQ(rows[1].reason, "crashed: SIGSEGV");
  limits.known = {{runs_of("bad"), std::string(failure), "it crashes"}};
  add_verdicts(report, limits);
  rows = broken_rows(report, limits);
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_EQ(rows[0].engine, "broken");
}

TEST(Gate, OneThatJudgesNoRunIsBroken) {
  Limits limits = limits_with("overstretch", 1.0);
  Report report = report_of(0.5);
  limits.limits[0].runs = runs_of("nobody");
  add_verdicts(report, limits);
  ASSERT_EQ(broken_rows(report, limits).size(), 1U);
  EXPECT_NE(broken_rows(report, limits)[0].reason.find("no limit of the file is on any run"),
            std::string::npos);
  limits.limits[0].runs = runs_of("e");
  limits.unjudged = {{runs_of("e"), "r"}};
  add_verdicts(report, limits);
  ASSERT_EQ(broken_rows(report, limits).size(), 1U);
  EXPECT_NE(broken_rows(report, limits)[0].reason.find("it is not judged"), std::string::npos);
}

}  // namespace
}  // namespace tautline::bench::test
