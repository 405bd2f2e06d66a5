// Verdicts on reports made by hand, and what breaks the gate.

#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

#include "bench/gate/gate_text.hpp"
#include "bench/gate/verdict.hpp"
#include "bench/report/tables.hpp"
#include "tests/bench/gate/made_report.hpp"

namespace tautline::bench::test {
namespace {

ListedProblems listing(const std::string& engine, const std::string& kind, bool in_some = false) {
  RunPattern runs;
  runs.engine = engine;
  return {"made.toml", "1", {{runs, kind, "", "a reason", in_some}}};
}

const ListedProblems nothing_listed = {"made.toml", "1", {}};

/// A report of one run of one engine, "e", that is sound but for what `spoil` does to it.
Report report_of(const std::function<void(RunRow&)>& spoil = [](RunRow&) {}) {
  Report report = made_report();
  add_engine(report, "e");
  spoil(add_run(report, "e", 0.0));
  return report;
}

Verdict verdict_of(Report report, const ListedProblems& listed = nothing_listed) {
  add_verdicts(report, listed);
  return report.runs.front().verdict.value();
}

Finding finding(const std::string& kind) {
  Finding found;
  found.engine = "e";
  found.model = "row";
  found.kind = kind;
  found.sentence = "it does";
  found.shown_in = {{"ball", 1e-3}};
  return found;
}

TEST(Pattern, OnlyStarsQuestionMarksAndBarsAreSpecial) {
  const auto on = [](const std::string& pattern, const std::string& name) {
    RunPattern runs;
    runs.model = pattern;
    return runs.holds({"c/d", "e", name, 1e-3});
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

TEST(Pattern, HoldsForAllThatItNamesTogether) {
  const RunKey run = {"c/d", "e", "row", 1e-3};
  RunPattern runs;
  runs.the_case = "c/*";
  runs.step = 0.1 * 0.01;  // up to rounding
  EXPECT_TRUE(runs.holds(run));
  runs.step = 2e-3;
  EXPECT_FALSE(runs.holds(run));
}

TEST(Verdict, OfARunWithoutAProblemIsSoundWhereEnoughCanBeTold) {
  EXPECT_EQ(verdict_of(report_of()).word, Word::sound);
  const auto few = [](RunRow& run) { run.judgement->rebounds.word = Rebound::too_few; };
  EXPECT_EQ(verdict_of(report_of(few)).word, Word::too_few);
  const auto untold = [](RunRow& run) { run.judgement->following.ratio.reset(); };
  EXPECT_EQ(verdict_of(report_of(untold)).word, Word::too_few);
  const auto marginal = [](RunRow& run) { run.judgement->following.ratio = 1.9; };
  EXPECT_EQ(verdict_of(report_of(marginal)).word, Word::sound);
}

TEST(Verdict, EachPartOfAJudgementIsAProblemOfItsKind) {
  const std::vector<std::pair<std::string, std::function<void(RunRow&)>>> faults = {
      {"restitution", [](RunRow& run) { run.judgement->rebounds.word = Rebound::off; }},
      {"restitution", [](RunRow& run) { run.judgement->rebounds.word = Rebound::none; }},
      {"restitution", [](RunRow& run) { run.judgement->rebounds.word = Rebound::lost_below; }},
      {"restitution", [](RunRow& run) { run.judgement->rebounds.word = Rebound::loses_some; }},
      {"restitution", [](RunRow& run) { run.judgement->rebounds.word = Rebound::scatters; }},
      {"position", [](RunRow& run) { run.judgement->following.ratio = 2.1; }},
      {"missed-impacts",
       [](RunRow& run) {
         run.judgement->impacts = {5, 1};
       }},
      {"overstretch", [](RunRow& run) { run.judgement->overstretch = 2.1; }},
      {"energy", [](RunRow& run) { run.judgement->energy = 3.1; }},
      {"flight", [](RunRow& run) { run.judgement->flight = 0.01; }},
      {"failure", [](RunRow& run) { run.status = Status::diverged; }},
      {"events",
       [](RunRow& run) {
         run.judgement->following.located = true;
         run.judgement->following.rounding = 2000.0;
       }},
      {"events", [](RunRow& run) {
         run.judgement->following.located = true;
         run.judgement->following.ratio = 0.3;
       }}};
  for (const auto& [kind, spoil] : faults) {
    const Report report = report_of(spoil);
    const Verdict verdict = verdict_of(report);
    EXPECT_EQ(verdict.word, Word::problem) << kind;
    ASSERT_EQ(verdict.problems.size(), 1U) << kind;
    EXPECT_EQ(verdict.problems.front().kind, kind);
    const Verdict listed = verdict_of(report, listing("*", kind));
    EXPECT_EQ(listed.word, Word::listed_problem) << kind;
    EXPECT_EQ(listed.problems.front().reason, "a reason") << kind;
    EXPECT_EQ(verdict_of(report, listing("other", kind)).word, Word::problem) << kind;
  }
}

TEST(Verdict, AFindingOfTheAuditIsAProblemUnlessItIsOfRebounds) {
  for (const std::string_view kind : finding_kinds) {
    Report report = report_of();
    report.findings = {finding(std::string(kind))};
    EXPECT_EQ(verdict_of(report).word, is_problem(kind) ? Word::problem : Word::sound) << kind;
  }
}

TEST(Verdict, AllOfItStandsInTheTableOfRuns) {
  Report report = report_of([](RunRow& run) { run.judgement->energy = 4.0; });
  add_verdicts(report, nothing_listed);
  const std::string table = runs_table(report).markdown();
  EXPECT_NE(table.find("energy: gains energy in flight, 4 times"), std::string::npos) << table;
}

TEST(Gate, IsBrokenByEachProblemThatIsNotListed) {
  Report report = report_of([](RunRow& run) { run.judgement->energy = 4.0; });
  add_verdicts(report, nothing_listed);
  const std::vector<BrokenRow> rows = broken_rows(report, nothing_listed);
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_EQ(rows.front().kind, "energy");
  const std::string text = gate_text(report, nothing_listed, rows);
  EXPECT_NE(text.find("The gate is broken by 1 row (made.toml, version 1): 1 problem."),
            std::string::npos)
      << text;
  const ListedProblems listed = listing("e", "energy");
  add_verdicts(report, listed);
  EXPECT_TRUE(broken_rows(report, listed).empty());
  EXPECT_EQ(gate_text(report, listed, {}),
            "The gate holds (made.toml, version 1): 1 listed problem.\n");
}

TEST(Gate, IsBrokenByAListedProblemThatIsGoneWhereItCouldShow) {
  const auto rows = [](const Report& made, const ListedProblems& listed) {
    Report report = made;
    add_verdicts(report, listed);
    return broken_rows(report, listed);
  };
  const std::vector<BrokenRow> gone = rows(report_of(), listing("e", "restitution"));
  ASSERT_EQ(gone.size(), 1U);
  EXPECT_NE(gone.front().what.find("delete it from the file; there: a reason"), std::string::npos);
  EXPECT_TRUE(rows(report_of(), listing("e", "restitution", true)).empty());
  EXPECT_TRUE(rows(report_of(), listing("other", "restitution")).empty());
  const auto few = [](RunRow& run) { run.judgement->rebounds.word = Rebound::too_few; };
  EXPECT_TRUE(rows(report_of(few), listing("e", "restitution")).empty());
}

TEST(Gate, IsBrokenByEnginesThatFailAndByRunsOfWhichNoneIsJudged) {
  Report report = made_report();
  add_engine(report, "e");
  add_verdicts(report, nothing_listed);
  ASSERT_EQ(broken_rows(report, nothing_listed).size(), 1U);
  EXPECT_EQ(broken_rows(report, nothing_listed).front().what, "no run could be judged");
  report.engines.front().problem = "it crashed";
  EXPECT_EQ(broken_rows(report, nothing_listed).front().what, "no runs: it crashed");
  report.engines.front().missing = true;
  EXPECT_EQ(broken_rows(report, nothing_listed).front().what, "no run could be judged");
}

TEST(ListedProblems, AreWrittenWithEveryProblemAndReadAgain) {
  Report report = report_of([](RunRow& run) { run.judgement->energy = 4.0; });
  add_run(report, "e", 0.0, 1e-2);
  ListedProblems listed = listing("e", "energy");
  add_verdicts(report, listed);
  const std::string text = problems_file_of(report, {}, listed);
  const ProblemsReading reading = read_problems_text(text, "p.toml");
  ASSERT_TRUE(reading.listed) << reading.problems.front() << text;
  ASSERT_EQ(reading.listed->problems.size(), 1U) << text;
  const ListedProblem& entry = reading.listed->problems.front();
  EXPECT_EQ(entry.runs.engine + " " + entry.runs.model + " " + entry.kind, "e row energy");
  EXPECT_EQ(entry.reason, "a reason");  // what a person has said stays
  EXPECT_NE(entry.finding.find("4 times"), std::string::npos);
  EXPECT_TRUE(entry.in_some);  // the run of the other step does not show it
  add_verdicts(report, *reading.listed);
  EXPECT_TRUE(broken_rows(report, *reading.listed).empty());
}

TEST(ListedProblems, AreKeptOfWhatDidNotRunAndDroppedOfWhatRanAndShowsThemNoMore) {
  Report report = report_of([](RunRow& run) { run.judgement->energy = 4.0; });
  const std::string text =
      "schema = 2\nversion = \"7\"\n"
      "[[problem]]\nengine = \"other\"\nmodel = \"*\"\nkind = \"energy\"\nreason = \"of another\"\n"
      "[[problem]]\nengine = \"e\"\nmodel = \"row\"\ncase = \"swing\"\nkind = \"position\"\n"
      "reason = \"of a case\"\n"
      "[[problem]]\nengine = \"e\"\nmodel = \"row\"\nstep = 0.01\nkind = \"position\"\n"
      "reason = \"of a step\"\n"
      "[[problem]]\nengine = \"e\"\nmodel = \"row\"\nkind = \"sleeping\"\nreason = \"of some\"\n"
      "in_some = true\n"
      "[[problem]]\nengine = \"e\"\nmodel = \"row\"\nkind = \"restitution\"\nreason = \"gone\"\n";
  const auto written = [&](const std::string& before) {
    const ListedProblems listed = read_problems_text(before, "p.toml").listed.value();
    add_verdicts(report, listed);
    return problems_file_of(report, listed, nothing_listed);
  };
  const std::string once = written(text);
  EXPECT_EQ(written(once), once);
  const std::string for_editors = "#:schema ./problems.schema.json\n";
  EXPECT_EQ(written(for_editors + text), for_editors + once);
  const ProblemsReading reading = read_problems_text(once, "p.toml");
  ASSERT_TRUE(reading.listed) << reading.problems.front() << once;
  EXPECT_EQ(reading.listed->version, "7");
  std::vector<std::string> reasons;
  for (const ListedProblem& problem : reading.listed->problems) {
    reasons.push_back(problem.reason);
  }
  EXPECT_EQ(reasons,
            (std::vector<std::string>{"of another", "of a case", "of a step", "of some", ""}))
      << once;
  EXPECT_EQ(reading.listed->problems[1].runs.the_case, "swing");
  EXPECT_EQ(reading.listed->problems[2].runs.step, 0.01);
  EXPECT_TRUE(reading.listed->problems[3].in_some);
  EXPECT_EQ(reading.listed->problems[4].kind, "energy");
  // the gate takes the new one, and says that its reason is wanted
  add_verdicts(report, *reading.listed);
  const std::string gate = gate_text(report, *reading.listed, broken_rows(report, *reading.listed));
  EXPECT_NE(gate.find("1 of 5 listed problems have no reason in the file yet: e row energy."),
            std::string::npos)
      << gate;
  EXPECT_NE(gate.find("The gate holds"), std::string::npos) << gate;
}

TEST(ListedProblems, EachOfSeveralPatternsMustNameSomethingThatIsThere) {
  ProblemNames names;
  names.engines = {{"e", std::vector<std::string>{"row", "early"}}};
  names.cases = {"c/one", "c/two", "ball"};
  const auto problems = [&](const std::string& model, const std::string& the_case) {
    return read_problems_text(
               "schema = 2\nversion = \"1\"\n[[problem]]\nengine = \"e\"\nmodel = \"" + model +
                   "\"\ncase = \"" + the_case + "\"\nkind = \"energy\"\nreason = \"r\"\n",
               "l.toml", names)
        .problems.size();
  };
  EXPECT_EQ(problems("row|early", "c/*|ball"), 0U);
  EXPECT_EQ(problems("row|none", "c/*|ball"), 1U);
  EXPECT_EQ(problems("row|early", "ball|c/three"), 1U);
}

TEST(ListedProblems, EveryMistakeOfAFileIsNamedWithLineKeyValueAndWhatWouldBeRight) {
  const std::string text =
      "schema = 1\n"
      "version = \"\"\n"
      "[[problem]]\n"
      "engine = 3\n"
      "model = \"*\"\n"
      "kind = \"restitutoin\"\n"
      "step = 0.0\n"
      "in_some = 1\n"
      "[[limits]]\n"
      "[[knwon]]\n";
  const ProblemsReading reading = read_problems_text(text, "l.toml");
  EXPECT_FALSE(reading.listed);
  std::string all;
  for (const std::string& sentence : reading.problems) {
    all += sentence + "\n";
  }
  for (const char* part :
       {"l.toml:1: schema = 1: must be 2", "l.toml:2: version", "l.toml:4: problem[0].engine = 3",
        "did you mean restitution", "l.toml:7: problem[0].step = 0: must be",
        "l.toml:8: problem[0].in_some", "problem[0].reason: is missing", "l.toml:9: limits",
        "is no longer asked for", "l.toml:10: knwon"}) {
    EXPECT_NE(all.find(part), std::string::npos) << part << "\n" << all;
  }
}

TEST(ListedProblems, AKeyThatEveryEntryOfEachHasIsRefusedInTheTableAroundThem) {
  const auto problems = [](const std::string& other) {
    return read_problems_text(
               "schema = 2\nversion = \"1\"\n[[problem]]\nengine = \"e\"\nmodel = \"row\"\n"
               "reason = \"r\"\neach = [\n  {kind = \"energy\", reason = \"own\"},\n  {" +
                   other + "},\n]\n",
               "l.toml")
        .problems;
  };
  EXPECT_EQ(problems("kind = \"flight\""), std::vector<std::string>());
  EXPECT_EQ(problems("kind = \"flight\", reason = \"too\""),
            std::vector<std::string>{"l.toml:6: problem[0].reason = \"r\": every entry of each has "
                                     "its own, leave it out"});
}

TEST(ListedProblems, WhatShipsIsSoundAndShort) {
  const ListedProblems shipped = shipped_problems();
  for (const ListedProblem& problem : shipped.problems) {
    EXPECT_FALSE(problem.reason.empty());
    EXPECT_EQ(problem.runs.the_case, "*") << "a problem is one of a model, not of a case";
  }
}

}  // namespace
}  // namespace tautline::bench::test
