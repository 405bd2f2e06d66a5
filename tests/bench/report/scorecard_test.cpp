#include "bench/report/scorecard.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "bench/report/output.hpp"
#include "bench/report/picture.hpp"
#include "tests/bench/gate/made_report.hpp"

namespace tautline::bench::test {
namespace {

/// An engine with a model as shipped, one by hand and tautline's.
void add_makers(Report& report, const std::string& name) {
  EngineRow row;
  row.name = name;
  row.info =
      EngineInfo{name,
                 "2.1",
                 "float64",
                 {Model{"joint", "", {}, Maker::engine}, Model{"row", "", {}, Maker::by_hand},
                  Model{"event", "", {}, Maker::tautline}}};
  report.engines.push_back(row);
}

/// A run whose early position error is `error` [m], and a judgement of its model in which all is
/// well.
RunRow& add_judged(Report& report, const std::string& engine, const std::string& model, double step,
                   double error) {
  RunRow& run = add_run(report, engine, 0.0, step);
  run.key.model = model;
  run.metrics->at(place("early_position_error")) = error;
  run.verdict = Verdict{Word::sound, {}};
  std::erase_if(report.models, [&](const ModelJudgement& one) {
    return one.engine == engine && one.model == model;
  });
  ModelJudgement judged;
  judged.engine = engine;
  judged.model = model;
  judged.step = step;
  judged.cases = judged.told = 1;
  judged.rebounds = sound_judgement().rebounds;
  judged.course = Course::as_good;
  judged.ratio = 0.5;
  judged.worst_case = "ball";
  report.models.push_back(judged);
  return run;
}

ModelJudgement& judged_of(Report& report, const std::string& model) {
  return *std::find_if(report.models.begin(), report.models.end(),
                       [&](const ModelJudgement& one) { return one.model == model; });
}

/// One case with a cable of 2 m.
Report report_of_two_metres() {
  Report report = made_report();
  report.cases.front().plane->geometry.front().length = 2.0;
  return report;
}

TEST(Scorecard, EnginesStandByNameAndTheControlIsNone) {
  Report report = report_of_two_metres();
  for (const char* name : {"zeta", "exact", "alpha", "mid"}) {
    add_makers(report, name);
    add_judged(report, name, "row", 1e-3, 0.01);
  }
  std::vector<std::string> names;
  for (const Scorecard& card : scorecards(report)) {
    names.push_back(card.engine);
  }
  EXPECT_EQ(names, (std::vector<std::string>{"alpha", "mid", "zeta"}));
}

TEST(Scorecard, TheSetupToUseIsTheLargestStepThatIsGoodEnough) {
  Report report = report_of_two_metres();
  add_makers(report, "e");
  add_judged(report, "e", "row", 1e-2, 0.019);  // 0.95 % of 2 m
  add_judged(report, "e", "row", 1e-3, 0.001);
  const Scorecard card = scorecard(report, "e");
  ASSERT_TRUE(card.use);
  EXPECT_EQ(card.use->step, 1e-2);
  EXPECT_DOUBLE_EQ(card.use->off.value(), 0.0095);
  report.runs.front().verdict->problems = {{"energy", "", 4.0, true, "it is so"}};
  EXPECT_FALSE(scorecard(report, "e").use) << "a run has a problem, at another step";
  EXPECT_NE(sentence_of(scorecard(report, "e")).find("row: at 0.01 s "), std::string::npos);
}

TEST(Scorecard, WhereNoneIsGoodEnoughNoneIsUsed) {
  Report report = report_of_two_metres();
  add_makers(report, "e");
  add_judged(report, "e", "row", 1e-2, 0.5);
  add_judged(report, "e", "row", 1e-3, 0.2);
  EXPECT_FALSE(scorecard(report, "e").use);
  EXPECT_NE(sentence_of(scorecard(report, "e")).find("within 1 % of a cable"), std::string::npos);
}

TEST(Scorecard, AModelWithAProblemIsNeverTheOneToUseAndTheSentenceNamesIt) {
  Report report = report_of_two_metres();
  add_makers(report, "e");
  add_judged(report, "e", "joint", 1e-3, 0.0001);
  add_judged(report, "e", "row", 1e-3, 0.01);
  Rebounds& rebounds = judged_of(report, "joint").rebounds;
  rebounds.word = Rebound::none;
  rebounds.stays_taut = true;
  rebounds.speed = 2.96;
  const Scorecard card = scorecard(report, "e");
  EXPECT_EQ(card.use->model, "row");
  EXPECT_EQ(
      sentence_of(card),
      "joint: restitution none: stays taut after 2.96 m/s. Use row at 0.001 s: 0.5 % of a cable "
      "off.");
  for (const auto& [spoil, said] :
       std::vector<std::pair<std::function<void(ModelJudgement&)>, std::string>>{
           {[](ModelJudgement& one) { one.rebounds.word = Rebound::off; }, "restitution 0 too low"},
           {[](ModelJudgement& one) {
              one.course = Course::does_not_converge;
              one.ratio = 71.0;
            },
            "does not converge: 71 times the error of a plain scheme"},
           {[](ModelJudgement& one) {
              one.impacts = {10, 4};
            },
            "misses 4 of 10 impacts"},
           {[](ModelJudgement& one) { one.overstretch = 4.5; }, "overstretches by 4.5 times"},
           {[](ModelJudgement& one) { one.energy = 5.0; }, "gains energy in flight, 5 times"}}) {
    spoil(judged_of(report, "row"));
    const Scorecard spoilt = scorecard(report, "e");
    EXPECT_FALSE(spoilt.use) << said;
    const auto& wrong = spoilt.models.back().wrong;
    EXPECT_TRUE(std::any_of(wrong.begin(), wrong.end(), [&text = said](const std::string& one) {
      return one.find(text) != std::string::npos;
    })) << said;
    EXPECT_NE(sentence_of(spoilt).find("None of its models can be recommended"), std::string::npos);
  }
}

TEST(Scorecard, TooFewImpactsAreNoReasonToUseAModel) {
  Report report = report_of_two_metres();
  add_makers(report, "e");
  add_judged(report, "e", "row", 1e-3, 0.0);
  judged_of(report, "row").rebounds.word = Rebound::too_few;
  EXPECT_FALSE(scorecard(report, "e").use);
  EXPECT_NE(sentence_of(scorecard(report, "e")).find("Too few impacts to judge 1 of 1 model."),
            std::string::npos)
      << sentence_of(scorecard(report, "e"));
}

TEST(Scorecard, AFrozenBodyIsWrongAndSeveralStepsAreNot) {
  for (const auto& [kind, right] :
       {std::pair("sleeping", false), std::pair("several-steps", true)}) {
    Report report = report_of_two_metres();
    add_makers(report, "e");
    add_judged(report, "e", "row", 1e-3, 0.1);
    Finding finding;
    finding.engine = "e";
    finding.model = "row";
    finding.kind = kind;
    report.findings = {finding};
    EXPECT_EQ(scorecard(report, "e").models.front().may_be_used(), right) << kind;
  }
}

TEST(Scorecard, VerdictsAreCountedRunByRunAndTheWorstIsSaid) {
  Report report = report_of_two_metres();
  add_makers(report, "e");
  for (int run = 0; run < 3; ++run) {
    add_judged(report, "e", "row", 1e-3, 0.1);
  }
  EXPECT_EQ(tally_text(scorecard(report, "e").verdicts), "sound");
  report.runs.back().verdict->word = Word::problem;
  const Tally tally = scorecard(report, "e").verdicts;
  EXPECT_EQ(tally.of(Word::sound), 2U);
  EXPECT_EQ(tally.of(Word::problem), 1U);
  EXPECT_EQ(tally.runs(), report.runs.size());
  EXPECT_EQ(tally_text(tally), "problem in 1 of 3");
}

/// A path straight down and up, from one of `heights` [m] to the next in a quarter of a second.
Path path_through(const std::vector<double>& heights) {
  const std::size_t pieces = heights.size() - 1;
  const std::vector<double> still(heights.size(), 0.0);
  std::vector<double> time;
  for (std::size_t knot = 0; knot < heights.size(); ++knot) {
    time.push_back(0.25 * static_cast<double>(knot));
  }
  constexpr double grid = 1e-6;
  Path path;
  path.time = on_grid(time, grid);
  path.x = path.angle = path.energy = on_grid(still, grid);
  path.y = on_grid(heights, grid);
  path.x_bends = path.y_bends = path.angle_bends =
      on_grid(std::vector<double>(2 * pieces, 0.0), grid);
  path.energy_time = path.time;
  return path;
}

/// The picture of a report.
std::string picture(const Report& report, const Replay& replay) {
  const std::optional<ImpactStills> stills = impact_stills(report, replay);
  return picture_html(stills ? &*stills : nullptr);
}

/// A report of a run of a body on one cable.
Report bouncing_report() {
  Report report = report_of_two_metres();
  add_makers(report, "e");
  add_judged(report, "e", "row", 1e-3, 0.1);
  return report;
}

/// What is drawn of it, through these `heights` [m]: slack, taut at 0.5 s, slack again.
Replay bouncing(const std::vector<double>& heights = {-1.0, -1.4, -2.0, -1.5, -1.2}) {
  ImpactColumns impacts;
  impacts.time = {0.5};
  impacts.cable = {0};
  impacts.requested = {0.75};
  impacts.rate_before = {-2.0};
  impacts.rate_after = {1.25};
  return {{}, {{path_through(heights), impacts}}};
}

TEST(Picture, TheStillsAreTheRunsOwnPosesAroundTheImpact) {
  const Report report = bouncing_report();
  const Replay replay = bouncing();
  const auto stills = impact_stills(report, replay);
  ASSERT_TRUE(stills);
  const CableRow& cable = report.cases.front().geometry().front();
  const auto gap = [&](std::size_t still) {
    return gap_of(cable, pose_at(stills->path, stills->times.at(still)));
  };
  EXPECT_EQ(stills->times[1], 0.5);
  EXPECT_NEAR(gap(1), 0.0, 1e-6);
  EXPECT_LT(stills->times[0], 0.5);
  EXPECT_GT(gap(0), 0.9);
  EXPECT_GT(stills->times[2], 0.5);
  EXPECT_GT(gap(2), 0.7);
  const std::string html = picture(report, replay);
  EXPECT_NE(html.find("closes at 2 m/s and opens at 1.25 m/s"), std::string::npos) << html;
  EXPECT_NE(html.find("<b>t = 0.500 s</b> taut: closes at 2 m/s"), std::string::npos) << html;
  EXPECT_NE(html.find("asked: <b>0.75</b>; got: <b>0.625</b>"), std::string::npos) << html;
}

/// Of such a report the exact motion, and an engine that is at the same place up to the impact and
/// rises to `height` [m] after it.
Replay beside_the_exact(Report& report, double height) {
  add_makers(report, "exact");
  add_judged(report, "exact", "event", 1e-3, 0.0);
  report.cases.front().horizon = 1.0;
  report.cases.front().extent = 2.0;
  Replay replay = bouncing({-1.0, -1.4, -2.0, -1.5 + height, -1.2 + height});
  replay.runs.push_back(bouncing().runs.front());
  replay.cases.resize(1);
  replay.cases[0].path = *replay.runs[1].path;
  replay.cases[0].events = {{0.5}, {"impact"}, {{0}}, {2.0}, 0};
  return replay;
}

TEST(Picture, AnErrorIsShownBesideTheExactMotionFromTheSameStart) {
  Report report = bouncing_report();
  const Replay replay = beside_the_exact(report, -0.3);
  EXPECT_NE(picture(report, replay).find("Engines are compared with this motion."),
            std::string::npos);
  report.runs[0].judgement->rebounds.word = Rebound::off;
  const auto stills = impact_stills(report, replay);
  ASSERT_TRUE(stills && stills->exact);
  EXPECT_EQ(stills->run, &report.runs[0]);
  const auto apart = [&](std::size_t still) {
    const double time = stills->times.at(still);
    return pose_at(*stills->exact, time).centre.y() - pose_at(stills->path, time).centre.y();
  };
  EXPECT_NEAR(apart(0), 0.0, 1e-6);
  EXPECT_NEAR(apart(1), 0.0, 1e-6);
  EXPECT_NEAR(apart(2), 0.3, 1e-6);
  const std::string html = picture(report, replay);
  EXPECT_NE(html.find("<span class=\"is-engine\">e row</span>"), std::string::npos) << html;
  EXPECT_NE(html.find("data-engine=\"e\" data-model=\"row\" data-step=\"0.001\""),
            std::string::npos)
      << html;
  EXPECT_NE(html.find("asked: <b>0.75</b>; got: <b>0.625</b>"), std::string::npos) << html;
  EXPECT_NE(html.find("0.3 m apart"), std::string::npos) << html;
}

TEST(Picture, ThePairEndsAtTheNextExactImpactAndItsWaysAreWithinTheFrame) {
  Report report = bouncing_report();
  Replay replay = beside_the_exact(report, 0.0);
  report.runs[0].judgement->rebounds.word = Rebound::off;
  report.cases.front().horizon = 3.0;
  // the two are apart the most long after 1 s, and between the stills lower than at any of them
  replay.runs[1].path = replay.cases[0].path =
      path_through({-1.0, -0.6, -2.0, -2.9, -2.0, -2.0, -2.0, -2.0, -2.0, -2.0, -2.0, -2.0, -2.0});
  replay.runs[0].path =
      path_through({-1.0, -0.6, -2.0, -2.9, -1.4, -1.4, -1.4, -1.4, -0.2, -0.2, -0.2, -0.2, -0.2});
  for (const std::vector<double>& again : {std::vector<double>{1.0}, std::vector<double>{}}) {
    EventColumns& events = replay.cases[0].events;
    events = {{0.5}, {"impact"}, {{0}}, {2.0}, 0};
    for (const double time : again) {
      events = {{0.5, time}, {"impact", "impact"}, {{0}, {0}}, {2.0, 1.0}, 0};
    }
    const auto stills = impact_stills(report, replay);
    ASSERT_TRUE(stills && stills->exact);
    EXPECT_GT(stills->times[2], 0.5);
    EXPECT_LE(stills->times[2], 1.0);
    const std::string svg = still_svg(*stills, 2);
    std::size_t ways = 0;
    for (std::size_t at = svg.find("class=\"trail\""); at != std::string::npos;
         at = svg.find("class=\"trail\"", at + 1), ++ways) {
      const std::size_t from = svg.find('M', at);
      std::string points = svg.substr(from, svg.find('"', from) - from);
      std::replace_if(
          points.begin(), points.end(), [](char c) { return c == 'M' || c == 'L'; }, ' ');
      std::istringstream words(points);
      for (double x = 0.0, y = 0.0; words >> x >> y;) {
        EXPECT_GE(y, 0.0) << svg;
        EXPECT_LE(y, 190.0) << svg;
      }
    }
    EXPECT_EQ(ways, 2U);
  }
}

TEST(Picture, ARunThatHasPartedBeforeItsImpactIsNoPair) {
  Report report = bouncing_report();
  Replay replay = beside_the_exact(report, -0.3);
  report.runs[0].judgement->rebounds.word = Rebound::off;
  replay.runs[0].path = path_through({-1.0, -1.2, -1.7, -1.5, -1.2});
  const auto stills = impact_stills(report, replay);
  ASSERT_TRUE(stills);
  EXPECT_FALSE(stills->exact);
}

TEST(Picture, WithoutAnImpactThatIsSeenThereIsNone) {
  EXPECT_EQ(picture(bouncing_report(), bouncing(std::vector<double>(5, -2.0))), "");
}

TEST(Picture, ACaseWithoutUnitsIsShownWithout) {
  Report report = bouncing_report();
  report.cases.front().plane->gravity = {0.0, -1.0};
  const std::string html = picture(report, bouncing());
  EXPECT_EQ(html.find("m/s"), std::string::npos) << html;
  EXPECT_EQ(html.find(" s:"), std::string::npos) << html;
}

/// Rows of a table in Markdown, without its heading.
long rows_of(const std::string& markdown) {
  long lines = 0;
  for (std::size_t at = 0; at < markdown.size(); at = markdown.find('\n', at) + 1) {
    lines += markdown[at] == '|' ? 1 : 0;
  }
  return lines - 2;
}

TEST(SummaryMarkdown, HasAtMostTwentyRowsTheWorstFirstAndCountsTheRest) {
  Report report = report_of_two_metres();
  for (int engine = 10; engine < 40; ++engine) {
    add_makers(report, "e" + std::to_string(engine));
    add_judged(report, "e" + std::to_string(engine), "row", 1e-3, 0.1);
  }
  report.runs[25].verdict->word = Word::problem;
  const std::string text = summary_markdown(report);
  EXPECT_EQ(rows_of(text), 20);
  EXPECT_TRUE(text.starts_with("- **e35**: ")) << text;
  EXPECT_EQ(text.substr(text.find("| e", text.find("| ---")) + 2, 3), "e35") << text;
  EXPECT_NE(text.find("and 10 further models"), std::string::npos) << text;
}

TEST(SummaryMarkdown, StaysShortWhateverTheNames) {
  Report report = report_of_two_metres();
  for (int engine = 0; engine < 50; ++engine) {
    const std::string name = std::string(20000, '|') + "\n<script>" + std::to_string(engine);
    add_makers(report, name);
    add_judged(report, name, "row", 1e-3, 0.1);
  }
  report.version = std::string(100000, 'v');
  const std::string text = summary_markdown(report);
  EXPECT_LE(text.size(), longest_summary);
  EXPECT_EQ(text.find("<script"), std::string::npos);
}

TEST(CardSvg, HasTheEngineItsVersionAndItsSentence) {
  Report report = bouncing_report();
  report.runs.front().metrics->at(place("early_position_error")) = 0.01;
  CostRow cost;
  cost.key = {"e", "row", 1e-3};
  cost.second_cost = 2.5e-3;
  report.context.costs = {cost};
  const std::string svg = card_svg(report, "e");
  for (const char* part : {">e<", "2.1, float64", "class=\"sound\"", "No problem found in 1 model.",
                           "0.5 % of a cable", "2.5 ms"}) {
    EXPECT_NE(svg.find(part), std::string::npos) << part << '\n' << svg;
  }
  EXPECT_NE(svg.find("prefers-color-scheme:dark"), std::string::npos);
}

TEST(CardSvg, AHostileNameWritesNoMarkupAndNoPath) {
  const std::string name = "\"/><script>alert(1)</script>&../..";
  Report report = report_of_two_metres();
  add_makers(report, name);
  report.engines.front().info->version = "</text><script>";
  add_judged(report, name, "row", 1e-3, 0.1);
  const std::string svg = card_svg(report, name);
  EXPECT_EQ(svg.find("<script"), std::string::npos) << svg;
  EXPECT_EQ(std::filesystem::path(card_name(name)).filename(), card_name(name));
}

TEST(ModelsTable, HasARowForEachModelAndItsNumbersAreTheCards) {
  Report report = report_of_two_metres();
  add_makers(report, "e");
  add_judged(report, "e", "joint", 1e-3, 0.04);
  add_judged(report, "e", "event", 1e-2, 0.002);
  const Table table = models_table(report);
  ASSERT_EQ(table.rows().size(), 2U);
  EXPECT_EQ(table.rows()[0].cells[1].text, "joint");
  EXPECT_EQ(table.rows()[0].cells[2].text, "as shipped");
  EXPECT_EQ(table.rows()[0].cells[3].text, "kept (4 impacts, from 0.25 m/s on)");
  EXPECT_EQ(table.rows()[0].cells[4].text, "as good as a step-by-step model can be");
  EXPECT_DOUBLE_EQ(table.rows()[0].cells[7].number.value(), 2.0);
  EXPECT_EQ(table.rows()[1].cells[2].text, "tautline’s driver");
  EXPECT_DOUBLE_EQ(table.rows()[1].cells[7].number.value(), 0.1);
  EXPECT_NE(report_markdown(report).find("## Engines"), std::string::npos);
}

TEST(ReportPage, UnitsStandOnlyWhereTheCasesHaveThem) {
  Report report = bouncing_report();
  report.options.steps = {1e-3};
  const std::string with = report_html(report, bouncing(), {});
  EXPECT_NE(with.find("[m]"), std::string::npos);
  report.cases.front().plane->gravity = {0.0, -1.0};
  const std::string without = report_html(report, bouncing(), {});
  for (const char* unit : {"[m]", "[s]", "[J]", "[m/s]"}) {
    EXPECT_EQ(without.find(unit), std::string::npos) << unit;
  }
}

}  // namespace
}  // namespace tautline::bench::test
