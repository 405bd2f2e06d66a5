// Ensembles whose accumulations are completed earlier.

#include <gtest/gtest.h>

#include "bench/ensemble/output/comparison.hpp"
#include "tests/bench/ensemble/solved.hpp"

namespace tautline::bench {
namespace {

// Every draw is another motion beyond its horizon, and the slower of the speeds is counted as
// before.
TEST(Ensemble, AnEarlierCompletionCannotBeToldApart) {
  const EnsembleRequest request = request_of(perturbed("1910121100", 300) +
                                             "[[exact]]\nname = \"early\"\ncompletion = 1e-10\n");
  const EnsembleResult result = solved(request);
  const Findings findings = findings_of(request, result, 2);
  EXPECT_EQ(findings.problems[0] + findings.problems[1], 0U) << findings.first_problems[1];
  ASSERT_EQ(findings.comparisons.size(), 11U);
  for (const Comparison& one : findings.comparisons) {
    EXPECT_FALSE(one.differs()) << findings.statistics[one.statistic].name
                                << ": D = " << one.kolmogorov.effect << ", seen from "
                                << one.visible << " on";
  }
  const std::size_t settled = place_of_statistic(findings.statistics, "settled_slow");
  int others = 0;
  for (std::size_t draw = 0; draw < 300; ++draw) {
    others += result.draws[0].value(draw, settled) != result.draws[1].value(draw, settled) ? 1 : 0;
  }
  EXPECT_GT(others, 0) << "the key reaches the solver";
}

// a rod of a hundred turns a second bounces a thousand times as fast as a size near one says
TEST(Ensemble, ACompletionThatLeavesOutAskedImpactsIsNamed) {
  const EnsembleRequest request = request_of(
      "case = \"spinning-rod\"\ncount = 2\ncompletion = 1e-10\n[[vary]]\n"
      "quantities = [\"x\"]\nnormal = 1e-9\n");
  const Findings findings = findings_of(request, solved(request), 2);
  EXPECT_EQ(findings.problems[0], 2U);
  EXPECT_NE(
      findings.first_problems[0].find("completion must be smaller to count those of 0.001 m/s"),
      std::string::npos)
      << findings.first_problems[0];
}

}  // namespace
}  // namespace tautline::bench
