// Ensembles of exact motions: their statistics, resuming, and what can be told apart.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "bench/ensemble/draw_files.hpp"
#include "bench/ensemble/ensemble.hpp"
#include "bench/ensemble/output/comparison.hpp"
#include "bench/ensemble/output/kolmogorov.hpp"
#include "bench/ensemble/output/output.hpp"
#include "bench/ensemble/spec_file.hpp"
#include "tautline/detail/ledger.hpp"
#include "tautline/settling.hpp"
#include "tautline/solve.hpp"
#include "tests/bench/ensemble/solved.hpp"
#include "tests/bench/support.hpp"

namespace tautline::bench {
namespace {

/// All draws as text: the same bits, the same text.
std::string text_of(const EnsembleRequest& request, const EnsembleResult& result) {
  std::string text;
  for (const DrawTable& draws : result.draws) {
    std::vector<DrawResult> rows;
    for (std::size_t draw = 0; draw < draws.size(); ++draw) {
      rows.push_back({draw, draws.solved(draw) ? "" : "not solved", {}});
      for (std::size_t place = 0; place < statistics_of(request.spec).size(); ++place) {
        rows.back().values.push_back(draws.value(draw, place));
      }
    }
    text += chunk_csv(request.spec, 0, rows);
  }
  return text;
}

double value_of(const EnsembleRequest& request, const EnsembleResult& result, std::size_t draw,
                const std::string& name) {
  const std::size_t place = place_of_statistic(statistics_of(request.spec), name);
  return result.draws.front().value(draw, place).value();
}

// threads put draws in as they end
TEST(Ensemble, ATableOfDrawsIsTheSameInWhateverOrderTheyEnd) {
  const std::vector<DrawResult> results = {
      {0, "", {1.0, std::nullopt}}, {1, "early", {}}, {3, "late", {}}, {4, "", {3.0, 4.0}}};
  for (const std::vector<std::size_t>& order :
       {std::vector<std::size_t>{0, 1, 2, 3}, std::vector<std::size_t>{2, 3, 1, 0}}) {
    DrawTable table(2, 5, 5);
    for (const std::size_t place : order) {
      table.put(results[place]);
    }
    EXPECT_EQ(table.ended(), 4U) << "draw 2 has not";
    EXPECT_EQ(table.problems(), 2U);
    EXPECT_EQ(table.first_problem(), "early");
    const EnsembleSample second = sample_of(table, 1);
    EXPECT_EQ(second.values, std::vector<double>({4.0}));
    EXPECT_EQ(second.without, 1U) << "draw 0 has none; what is not solved does not count";
    EXPECT_EQ(sample_of(table, 0).values, std::vector<double>({1.0, 3.0}));
    EXPECT_FALSE(table.value(2, 0));
  }
}

// off by a part in 32,768 at most, and not at all where they are whole
TEST(ValueCounts, CountsValuesToFifteenBinaryDigits) {
  ValueCounts counts;
  for (const double value : {8.13, 8.13 * (1.0 + 1e-7), -0.0371, 0.0, 32767.0, 32768.0, 1e-200}) {
    counts.add(value);
  }
  counts.add(std::nullopt);
  EXPECT_EQ(counts.count(), 7U);
  EXPECT_EQ(counts.without(), 1U);
  std::vector<double> values;
  for (const auto& [value, times] : counts.values()) {
    values.push_back(value);
    EXPECT_EQ(times, std::abs(value - 8.13) < 1.0 ? 2U : 1U) << value;
  }
  constexpr double rounding = 1.0 / 32768.0;
  const std::vector<double> expected = {-0.0371, 0.0, 1e-200, 8.13, 32767.0, 32768.0};
  ASSERT_EQ(values.size(), expected.size());
  for (std::size_t place = 0; place < expected.size(); ++place) {
    EXPECT_NEAR(values[place], expected[place], rounding * std::abs(expected[place]));
  }
  EXPECT_EQ(values[4], 32767.0);
}

/// Settling times that nobody has measured, of a fifth of which there are none.
DrawResult made_up(std::size_t draw) {
  const double value = 8.0 + std::sin(static_cast<double>(draw * draw));
  return {draw, "", {draw % 5 == 0 ? std::nullopt : std::optional(value)}};
}

TEST(Ensemble, ATableThatHoldsAPartCountsTheRest) {
  constexpr std::size_t draws = 20000;
  DrawTable all(1, draws, draws);
  DrawTable part(1, draws, 1000);
  for (std::size_t draw = 0; draw < draws; ++draw) {
    all.put(made_up(draw));
    part.put(made_up(draws - 1 - draw));  // in another order
  }
  EXPECT_TRUE(all.holds_all());
  EXPECT_FALSE(part.holds_all());
  EXPECT_EQ(part.size(), 1000U);
  EXPECT_EQ(part.ended(), draws);
  EXPECT_EQ(sample_of(part, 0).size(), 1000U);
  EXPECT_EQ(part.value(999, 0), all.value(999, 0));
  const Summary exact = summary_of(sample_of(all, 0));
  const Summary counted = summary_of(part.counts(0));
  constexpr double rounding = 9.0 / 32768.0;  // of the largest value
  EXPECT_EQ(counted.count, exact.count);
  EXPECT_EQ(counted.without, exact.without);
  EXPECT_NEAR(counted.mean, exact.mean, rounding);
  EXPECT_NEAR(counted.deviation, exact.deviation, rounding);
  for (std::size_t place = 0; place < quantile_parts.size(); ++place) {
    const Quantile& one = counted.quantiles[place];
    const Quantile& other = exact.quantiles[place];
    ASSERT_EQ(one.value.has_value(), other.value.has_value());
    ASSERT_EQ(one.high.has_value(), other.high.has_value());
    if (other.value) {
      EXPECT_NEAR(*one.value, *other.value, rounding);
      EXPECT_NEAR(one.low.value(), other.low.value(), rounding);
    }
    if (other.high) {
      EXPECT_NEAR(*one.high, *other.high, rounding);
    }
  }
}

TEST(Ensemble, TestsAreOfTheDrawsThatAreHeldAndThePageSaysSo) {
  const EnsembleRequest request =
      request_of(perturbed("1710121100", 600) + "[[exact]]\nname = \"another seed\"\nseed = 2\n");
  const EnsembleResult whole = solved(request);
  EnsembleResult result;
  const std::size_t statistics = statistics_of(request.spec).size();
  for (const DrawTable& draws : whole.draws) {
    DrawTable& part = result.draws.emplace_back(statistics, draws.size(), 400);
    for (std::size_t draw = 0; draw < draws.size(); ++draw) {
      DrawResult one{draw, "", {}};
      for (std::size_t place = 0; place < statistics; ++place) {
        one.values.push_back(draws.value(draw, place));
      }
      part.put(one);
    }
  }
  const Findings findings = findings_of(request, result, 1);
  EnsembleRequest first = request;
  first.spec.count = 400;
  const Findings of_first = findings_of(first, solved(first), 1);
  ASSERT_EQ(findings.comparisons.size(), of_first.comparisons.size());
  for (std::size_t place = 0; place < findings.comparisons.size(); ++place) {
    const Comparison& one = findings.comparisons[place];
    EXPECT_EQ(one.draws, 400U);
    EXPECT_EQ(one.kolmogorov.effect, of_first.comparisons[place].kolmogorov.effect);
    EXPECT_EQ(one.probability(), of_first.comparisons[place].probability());
    const Summary& summary = findings.summaries[0][one.statistic];
    EXPECT_EQ(summary.count + summary.without, 600U);
  }
  const std::string text = ensemble_markdown({request, result, findings});
  EXPECT_NE(text.find("at n = 400"), std::string::npos) << text;
  EXPECT_NE(text.find("Tests and curves are of the first 400 draws"), std::string::npos) << text;
}

// the room of an ensemble, 14 statistics of two cables: doubles that are held, and counters
TEST(Ensemble, TheRoomOfATableDoesNotGrowWithItsDraws) {
  const auto counters_after = [](std::size_t draws) {
    ValueCounts counts;
    for (std::size_t draw = 0; draw < draws; ++draw) {
      counts.add(made_up(draw).values.front());
    }
    return counts.values().size();
  };
  constexpr std::size_t between_seven_and_nine = 16384 / 4 + 16384 / 8;
  EXPECT_LE(counters_after(100000), between_seven_and_nine + 1);
  EXPECT_LE(counters_after(400000), between_seven_and_nine + 1);
}

TEST(Ensemble, DoesNotDependOnTheNumberOfThreads) {
  const EnsembleRequest request = request_of("until = 2\n" + perturbed("1510121100", 250));
  const std::string one = text_of(request, solved(request, 1));
  EXPECT_EQ(text_of(request, solved(request, 3)), one);
  EXPECT_EQ(std::count(one.begin(), one.end(), '\n'), 252);
}

TEST(Ensemble, StatisticsOfADrawAreThoseOfItsMotion) {
  const EnsembleRequest request = request_of(perturbed("1910121100", 3));
  const EnsembleResult result = solved(request);
  for (std::size_t draw = 0; draw < 3; ++draw) {
    const auto the_case = std::get<Case>(case_of(request.spec, request.setups.front(), draw));
    const Solution solution = solve(the_case);
    const Settling settled = settling(the_case, solution);
    ASSERT_TRUE(settled.lock && settled.lock->swing);
    EXPECT_EQ(value_of(request, result, draw, "settled_fast"), settled.last_impacts[0].time);
    EXPECT_EQ(value_of(request, result, draw, "settled_slow"), settled.last_impacts[1].time);
    EXPECT_EQ(value_of(request, result, draw, "lock"), settled.lock->time);
    constexpr double rounding = 1e-13;  // the swing here is that of another stretch of the motion
    EXPECT_NEAR(value_of(request, result, draw, "swing_energy"), settled.lock->swing->energy,
                rounding);
    EXPECT_NEAR(value_of(request, result, draw, "swing_amplitude"), settled.lock->swing->amplitude,
                rounding);
    EXPECT_EQ(value_of(request, result, draw, "captured"), 1.0);
    EXPECT_NEAR(
        value_of(request, result, draw, "loss_0") + value_of(request, result, draw, "loss_1"), 1.0,
        1e-12);
    double sampled = 0.0;
    for (int sample = 0; sample <= 20'000; ++sample) {
      const double time = solution.end_time() * sample / 20'000;
      sampled = std::max(sampled, std::abs(solution.at(time).angle));
    }
    const double largest = value_of(request, result, draw, "largest_angle");
    EXPECT_GE(largest, sampled - 1e-12);
    EXPECT_LE(largest, sampled + 5e-3) << "a spin of some 5 rad/s for a millisecond";
  }
}

// a long way round: every impact's speed, every arc's whole state
class PassedOver : public ::testing::TestWithParam<const char*> {};

TEST_P(PassedOver, ChangesNoStatistic) {
  const EnsembleRequest request = request_of("until = 12\n" + perturbed(GetParam(), 20));
  const EnsembleResult result = solved(request);
  for (std::size_t draw = 0; draw < 20; ++draw) {
    const auto the_case = std::get<Case>(case_of(request.spec, request.setups.front(), draw));
    const Solution solution = solve(the_case, {.until_locked = true});
    double fast = 0.0;
    std::vector<double> lost(the_case.cables.size(), 0.0);
    for (const Event& event : solution.events()) {
      Eigen::Index place = 0;
      for (const std::size_t cable : event.cables) {
        const double before = gap_rate(the_case.cables[cable], event.before);
        const double after = gap_rate(the_case.cables[cable], event.after);
        if (event.kind == EventKind::impact && -before > request.spec.speeds[1]) {
          fast += -before > request.spec.speeds[0] ? 1.0 : 0.0;
          lost[cable] += -0.5 * event.impulses[place] * (before + after);
        }
        ++place;
      }
    }
    EXPECT_EQ(value_of(request, result, draw, "impacts"), fast);
    constexpr double rounding = 1e-13;  // a loss is there a difference of energies
    EXPECT_NEAR(value_of(request, result, draw, "loss_1"), lost[1] / (lost[0] + lost[1]), rounding);
    double impulse = 0.0;
    for (const Event& event : solution.events()) {
      if (event.kind == EventKind::impact) {
        impulse = std::max(impulse, event.impulses.maxCoeff());
      }
    }
    EXPECT_NEAR(value_of(request, result, draw, "largest_impulse"), impulse, 1e-12);
    double at_ends = 0.0;
    double sampled = 0.0;
    for (const Arc& arc : solution.arcs()) {
      const double length = arc.end - arc.start;
      at_ends = std::max({at_ends, std::abs(arc.initial.angle),
                          std::abs(arc.after(length, solution.gravity()).angle)});
      for (int sample = 0; sample <= 200; ++sample) {
        const State state = arc.after(length * sample / 200, solution.gravity());
        sampled = std::max(sampled, std::abs(state.angle));
      }
    }
    const double largest = value_of(request, result, draw, "largest_angle");
    constexpr double told = 1e-10;  // a swing that is told has ten digits
    EXPECT_GE(largest, std::max(at_ends, sampled) - told) << "draw " << draw;
    EXPECT_LE(largest, std::max(at_ends, sampled) + 1e-3) << "of a spin of 5 for a two hundredth";
  }
}

INSTANTIATE_TEST_SUITE_P(Ensemble, PassedOver,
                         ::testing::Values("1910121100", "1510121100", "1710121100", "1933121100",
                                           "1921121100"),
                         [](const auto& drawn) { return std::string(drawn.param); });

TEST(Ensemble, PartOfAFileOfDrawsIsNone) {
  const test::TemporaryFolder folder;
  const EnsembleRequest request = request_of("until = 1\n" + perturbed("1510121100", 3));
  const std::vector<DrawResult> draws = draw_solver(request, request.setups.front())->solve(0, 3);
  const std::string whole = chunk_csv(request.spec, 7, draws);
  const auto read = [&](const std::string& text) {
    return read_chunk(folder.file("draws.csv", text), request.spec, 7, 0, 3);
  };
  EXPECT_TRUE(read(whole));
  for (const std::size_t lost : {1U, 2U, 40U}) {  // a power cut leaves a part, or zeros
    const std::string part = whole.substr(0, whole.size() - lost);
    EXPECT_FALSE(read(part)) << lost;
    EXPECT_FALSE(read(part + std::string(lost, '\0'))) << lost;
  }
}

TEST(Ensemble, WhatImpactsOfASingleCableLoseIsTheWholeLoss) {
  const EnsembleRequest request = request_of(
      "case = \"bouncing-ball\"\ncount = 1\n[[vary]]\nquantities = [\"spin\"]\n"
      "list = [0]\n");
  EXPECT_EQ(value_of(request, solved(request), 0, "loss_0"), 1.0);
}

TEST(Ensemble, ADrawThatIsNoCaseIsNamedAndLeftOut) {
  const EnsembleRequest request = request_of(
      "case = \"breakwater/1510121100\"\ncount = 20\n[[vary]]\nquantities = [\"mass\"]\n"
      "list = [-1, 0.5]\n");
  const EnsembleResult result = solved(request);
  const Findings findings = findings_of(request, result, 1);
  EXPECT_GT(findings.problems[0], 0U);
  EXPECT_LT(findings.problems[0], 20U);
  EXPECT_NE(findings.first_problems[0].find("mass"), std::string::npos)
      << findings.first_problems[0];
  const Summary& impacts =
      findings.summaries[0][place_of_statistic(findings.statistics, "impacts")];
  EXPECT_EQ(impacts.count, 20U - findings.problems[0]);
}

TEST(Ensemble, ResumesFromWhatItsFolderHas) {
  const test::TemporaryFolder folder;
  EnsembleRequest request = request_of("until = 1\n" + perturbed("1510121100", 500));
  EnsembleOptions options{.out = folder.path(), .jobs = 2, .resume = true, .programs = {}};
  std::size_t kept = 0;
  const auto count_kept = [&](const auto&, std::size_t draws, bool was_kept) {
    kept += was_kept ? draws : 0;
  };
  const std::string all = text_of(request, solve_ensemble(request, options, count_kept));
  EXPECT_EQ(kept, 0U);
  std::filesystem::remove(chunk_file(folder.path(), request.setups[0], 200));
  EXPECT_EQ(text_of(request, solve_ensemble(request, options, count_kept)), all);
  EXPECT_EQ(kept, 300U) << "of three files, one is gone";
  kept = 0;
  request.spec.count = 600;  // the last file was cut off at 500
  EXPECT_TRUE(text_of(request, solve_ensemble(request, options, count_kept)).starts_with(all));
  EXPECT_EQ(kept, 400U);
  kept = 0;
  request.spec.seed = 2;
  EXPECT_NE(text_of(request, solve_ensemble(request, options, count_kept)), all);
  EXPECT_EQ(kept, 0U) << "other draws";
}

// The tables of how the two laws differ, measured by another solver in 60 digits: means and
// standard deviations of the settling time, n = 1000. Here n = 300: four standard errors of both.
TEST(Ensemble, LawsDifferAsAnotherSolverSays) {
  const EnsembleRequest request = request_of(
      perturbed("1510121100", 300) + "[[exact]]\nname = \"sequential\"\nlaw = \"sequential\"\n");
  const Findings findings = findings_of(request, solved(request), 2);
  const std::size_t settled = place_of_statistic(findings.statistics, "settled_fast");
  const std::size_t energy = place_of_statistic(findings.statistics, "swing_energy");
  const Summary& simultaneous = findings.summaries[0][settled];
  const Summary& sequential = findings.summaries[1][settled];
  const double error = 4.0 * std::sqrt(1.0 / 300.0 + 1.0 / 1000.0);
  EXPECT_NEAR(sequential.mean, 1.4419, 0.0044 * error);
  EXPECT_NEAR(sequential.deviation, 0.0044, 0.0044 * error);
  EXPECT_NEAR(simultaneous.mean, 1.5065, 0.0065 * error);
  EXPECT_NEAR(simultaneous.deviation, 0.0065, 0.0065 * error);
  for (const Comparison& one : findings.comparisons) {
    if (one.statistic == settled) {
      EXPECT_GT(one.kolmogorov.effect, 0.99);
      EXPECT_TRUE(one.differs());
    }
    if (one.statistic == energy) {
      EXPECT_NEAR(one.kolmogorov.effect, 0.133, 0.1) << "the noise of a distance at n = 300";
    }
  }
}

TEST(Ensemble, LawsAreTheSameWhereOneCableHitsAtATime) {
  const EnsembleRequest request = request_of(
      perturbed("1911121100", 60) + "[[exact]]\nname = \"sequential\"\nlaw = \"sequential\"\n");
  const EnsembleResult result = solved(request);
  const Findings findings = findings_of(request, result, 2);
  ASSERT_FALSE(findings.comparisons.empty());
  for (const Comparison& one : findings.comparisons) {
    EXPECT_FALSE(one.differs()) << findings.statistics[one.statistic].name;
  }
}

// the exact motions lock at some 2.5 s; no swing has lasted for a period of 3.3 s by the end
TEST(Ensemble, ABiasOfTwoPercentInRestitutionIsFoundAndAnotherSeedIsNone) {
  const EnsembleRequest request = request_of("until = 3\n" + perturbed("1710121100", 1000) +
                                             "[[exact]]\nname = \"another seed\"\nseed = 2\n"
                                             "[[exact]]\nname = \"biased\"\n"
                                             "quantity = \"restitution\"\nfactor = 0.98\n");
  const Findings findings = findings_of(request, solved(request), 2);
  ASSERT_EQ(findings.comparisons.size(), 18U);
  for (const Comparison& one : findings.comparisons) {
    EXPECT_EQ(one.differs(), one.setup == 2U)
        << findings.statistics[one.statistic].name << " of " << request.setups[one.setup].name
        << ": D = " << one.kolmogorov.effect << ", seen from " << one.visible << " on";
  }
}

}  // namespace
}  // namespace tautline::bench
