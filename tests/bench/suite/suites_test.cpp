#include "bench/suite/suites.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>

#include "bench/cases/catalogue.hpp"
#include "bench/measure/impact_match.hpp"
#include "bench/measure/reference.hpp"
#include "tautline/geometry.hpp"
#include "tests/bench/support.hpp"

namespace tautline::bench {
namespace {

TEST(Suites, NameShippedCasesAndSayWhatEachShows) {
  std::set<std::string_view> names;
  for (const Suite& suite : suites()) {
    EXPECT_TRUE(names.insert(suite.name).second) << suite.name;
    EXPECT_FALSE(suite.steps.empty()) << suite.name;
    const CaseSelection selection = select_cases(
        cases_of(suite), {}, suite.systems ? Kinds::cases_and_systems : Kinds::cases_alone);
    EXPECT_TRUE(selection.problems.empty()) << selection.problems.front();
    EXPECT_GE(selection.cases.size() + selection.systems.size() + selection.in_space.size(),
              suite.entries.size());
    for (const SuiteCases& entry : suite.entries) {
      EXPECT_FALSE(entry.shows.empty()) << entry.cases;
    }
  }
  EXPECT_EQ(suites().front().name, "quick");
  EXPECT_EQ(find_suite("chapter")->steps, usual_steps());
  EXPECT_EQ(find_suite("swift"), nullptr);
}

TEST(Suites, AreListedInTheDocumentAsTheProgramHasThem) {
  const std::string document = test::content_of(TAUTLINE_SCALING);
  const std::string mark = "<!-- suites -->\n```\n";
  ASSERT_NE(document.find(mark), std::string::npos);
  const std::size_t start = document.find(mark) + mark.size();
  EXPECT_EQ(document.substr(start, document.find("```", start) - start), suites_text());
}

TEST(Suites, TextFitsATerminal) {
  std::istringstream lines(suites_text());
  for (std::string line; std::getline(lines, line);) {
    EXPECT_LT(line.size(), 80U) << line;
  }
}

/// A case of the quick suite with its exact motion.
ReferenceCase quick(const std::string& name) {
  const std::vector<SuiteCases>& entries = suites().front().entries;
  EXPECT_TRUE(std::any_of(entries.begin(), entries.end(),
                          [&](const SuiteCases& entry) { return entry.cases == name; }))
      << name << " is not in the quick suite";
  const std::vector<std::string> names = {name};
  return solve_cases(select_cases(names).cases, ImpactLaw::simultaneous).front();
}

/// The kinds of the events in their order, those alike that follow each other once: "impact taut".
std::string story(const Solution& solution) {
  std::string result;
  EventKind last{};
  for (const Event& event : solution.events()) {
    if (result.empty() || event.kind != last) {
      result += (result.empty() ? "" : " ") + std::string(to_string(event.kind));
    }
    last = event.kind;
  }
  return result;
}

TEST(QuickSuite, ShowsAccumulationToRest) {
  const ReferenceCase ball = quick("bouncing-ball");
  ASSERT_TRUE(ball.settling.lock.has_value());
  EXPECT_TRUE(ball.settling.lock->rests);
  EXPECT_GT(ball.solution.events().size(), 10U);
}

TEST(QuickSuite, ShowsTwoCablesStruckAtOnce) {
  const ReferenceCase beam = quick("level-beam");
  EXPECT_EQ(beam.solution.events().front().cables.indices().size(), 2U);
  EXPECT_EQ(beam.solution.events()[1].cables.indices().size(), 1U);
  ASSERT_TRUE(beam.settling.lock.has_value());
  EXPECT_EQ(beam.settling.lock->cables.indices().size(), 2U);
}

TEST(QuickSuite, ShowsElasticImpacts) {
  const ReferenceCase box = quick("elastic-box");
  const double start = energy(box.the_case, box.the_case.initial);
  const State end = box.solution.at(box.solution.end_time());
  // rounding of some ten impacts
  EXPECT_NEAR(energy(box.the_case, end), start, 1e-12 * std::abs(start));
  EXPECT_EQ(box.the_case.cables.front().restitution, 1.0);
  EXPECT_GE(box.solution.events().size(), 5U);
}

TEST(QuickSuite, ShowsAPlasticCatchATautSwingAReleaseAndASecondCatch) {
  const ReferenceCase swing = quick("caught-swing");
  EXPECT_EQ(swing.the_case.cables.front().restitution, 0.0);
  EXPECT_EQ(story(swing.solution), "impact taut slack impact taut");
}

TEST(QuickSuite, ShowsSpinUpAtAHighInertiaRatio) {
  const ReferenceCase rod = quick("spinning-rod");
  const Case& the_case = rod.the_case;
  const double arm = the_case.cables.front().attachment.norm();
  const double gyration = std::sqrt(the_case.body.inertia / the_case.body.mass);
  EXPECT_NEAR(arm / gyration, 5.4, 0.05);
  EXPECT_EQ(the_case.initial.spin, 0.0);
  EXPECT_GT(std::abs(rod.solution.events().front().after.spin), 5.0);  // [rad/s]
}

TEST(QuickSuite, ShowsManyImpactsIntoASwingOnTwoCables) {
  const ReferenceCase standard = quick("breakwater/1910121100");
  ASSERT_TRUE(standard.settling.lock && standard.settling.lock->swing);
  EXPECT_TRUE(standard.settling.lock->permanent);
  EXPECT_EQ(counted_impacts(standard.the_case, standard.solution, 0.01).size(), 79U);
}

}  // namespace
}  // namespace tautline::bench
