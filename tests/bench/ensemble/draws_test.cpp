// Draws: the same on any machine, in any order, whatever the count.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "bench/cases/quantity.hpp"
#include "bench/ensemble/draw.hpp"
#include "bench/ensemble/random.hpp"
#include "bench/ensemble/spec_file.hpp"

namespace tautline::bench {
namespace {

EnsembleSpec spec_of(const std::string& text) {
  const SpecReading reading = read_spec_text(text, "test.toml");
  EXPECT_TRUE(reading.problems.empty()) << reading.problems.front();
  return reading.spec.value();
}

const std::string standard = "case = \"breakwater/1910121100\"\n";

// Random123 1.14, kat_vectors: philox4x64 10, counter and key 0, and the first digits of pi
TEST(Draws, AreThePhiloxOfItsAuthors) {
  EXPECT_EQ(random_bits(0, Purpose(0), 0, 0), 0x16554d9eca36314cULL);
}

TEST(Draws, FollowFromSeedAndIndexAlone) {
  EnsembleSpec spec = spec_of(standard + "[[vary]]\nquantities = [\"x\", \"spin\"]\nnormal = 0.1");
  const DrawnValues seventh = drawn_values(spec, 1, 7);
  spec.count = 8;
  EXPECT_EQ(drawn_values(spec, 1, 7), seventh) << "whatever the count";
  EXPECT_NE(drawn_values(spec, 2, 7), seventh);
  EXPECT_NE(drawn_values(spec, 1, 8), seventh);
  EXPECT_NE(seventh[0], seventh[1]);
  spec.varied.pop_back();
  EXPECT_EQ(drawn_values(spec, 1, 7).front(), seventh.front()) << "whatever varies after it";
}

TEST(Draws, HaveTheMeanAndDeviationAskedFor) {
  const EnsembleSpec spec = spec_of(standard + "[[vary]]\nquantities = [\"x\"]\nnormal = 0.25");
  const double centre = std::get<Case>(spec.the_case).initial.position.x();
  const int count = 4000;
  double sum = 0.0;
  double squares = 0.0;
  for (int index = 0; index < count; ++index) {
    const double off = drawn_values(spec, 3, static_cast<std::size_t>(index))[0] - centre;
    sum += off;
    squares += off * off;
  }
  const double error = 4.0 / std::sqrt(count);  // four standard errors, of a fixed seed
  EXPECT_NEAR(sum / count, 0.0, error * 0.25);
  EXPECT_NEAR(squares / count, 0.0625, error * 0.0625 * std::sqrt(2.0));
}

TEST(Draws, OfSobolFillTheSquareEvenly) {
  const EnsembleSpec spec = spec_of(standard +
                                    "sampling = \"sobol\"\n[[vary]]\n"
                                    "quantities = [\"x\", \"y\"]\nuniform = [0, 1]");
  // 256 points, 16 x 16 cells: a net has one in each; a turn moves some to the next
  std::set<std::pair<int, int>> cells;
  for (std::size_t index = 0; index < 256; ++index) {
    const DrawnValues at = drawn_values(spec, 1, index);
    cells.emplace(static_cast<int>(at[0] * 16.0), static_cast<int>(at[1] * 16.0));
  }
  EXPECT_GE(cells.size(), 200U) << "256 random points would meet 162 of 256 cells";
}

TEST(Draws, GoOverEveryPointOfAGridAsOftenAsCounted) {
  const EnsembleSpec spec = spec_of(standard + "count = 3\n" +
                                    "[[vary]]\nquantities = [\"x\"]\ngrid = [0, 1]\npoints = 3\n"
                                    "[[vary]]\nquantities = [\"spin\"]\nnormal = 1\n"
                                    "[[vary]]\nquantities = [\"y\"]\ngrid = [0, 1]\npoints = 2");
  ASSERT_EQ(draw_count(spec), 18U);
  std::multiset<std::pair<double, double>> points;
  std::set<double> spins;
  for (std::size_t index = 0; index < draw_count(spec); ++index) {
    const DrawnValues at = drawn_values(spec, 1, index);
    points.emplace(at[0], at[2]);
    spins.insert(at[1]);
  }
  EXPECT_EQ(spins.size(), 18U);
  for (const double x : {0.0, 0.5, 1.0}) {
    for (const double y : {0.0, 1.0}) {
      EXPECT_EQ(points.count({x, y}), 3U) << x << ", " << y;
    }
  }
}

TEST(Draws, SetTheQuantityOfAllCablesOrOfOne) {
  EnsembleSpec spec = spec_of(standard +
                              "[[vary]]\nquantities = [\"restitution\"]\nlist = [0.5]\n"
                              "[[vary]]\nquantities = [\"length_1\"]\nlist = [1.25]");
  const Case the_case = std::get<Case>(case_of(spec, drawn_values(spec, 1, 0)));
  EXPECT_EQ(the_case.cables[0].restitution, 0.5);
  EXPECT_EQ(the_case.cables[1].restitution, 0.5);
  EXPECT_EQ(the_case.cables[0].length, std::get<Case>(spec.the_case).cables[0].length);
  EXPECT_EQ(the_case.cables[1].length, 1.25);
  for (const std::string& name : quantities_of(the_case)) {
    Case changed = the_case;
    set_quantity(changed, name, 0.75);
    EXPECT_EQ(quantity(changed, name), 0.75) << name;
  }
}

TEST(EnsembleSpec, NamesEveryMistakeWithItsLine) {
  const SpecReading reading = read_spec_text(
      "case = \"breakwater/1910121100\"\n"
      "count = 2.5\n"
      "speeds = [0.001, 0.01]\n"
      "sampling = \"sobel\"\n"
      "completion = 0.001\n"
      "[[vary]]\n"
      "quantities = [\"spinn\"]\n"
      "normal = 1\n"
      "[[vary]]\n"
      "quantities = [\"x\"]\n"
      "normal = 1\n"
      "uniform = [0, 1]\n"
      "[[vary]]\n"
      "quantities = [\"y\"]\n"
      "grid = [0, 1]\n"
      "colour = 3\n",
      "test.toml");
  EXPECT_FALSE(reading.spec);
  std::string all;
  for (const std::string& sentence : reading.problems) {
    all += sentence + "\n";
  }
  for (const char* part :
       {"test.toml:2: count = 2.5: must be a whole number", "test.toml:3: speeds",
        "test.toml:4: sampling", "did you mean sobol?",
        "test.toml:5: completion = 0.001: must be above 0 and at most 1e-10",
        "test.toml:7: vary[0].quantities", "spinn is none of this case; did you mean spin?",
        "test.toml:10: vary[1].quantities", "several are given", "vary[2].points: is missing",
        "test.toml:16: vary[2].colour = 3: unknown key"}) {
    EXPECT_NE(all.find(part), std::string::npos) << part << "\nis not in:\n" << all;
  }
}

// each is refused with its line before anything is made of it, and nothing else is said of it
TEST(EnsembleSpec, EveryNumberHasItsRange) {
  const std::string vary = standard + "[[vary]]\nquantities = [\"x\"]\n";
  const std::string drawn = vary + "normal = 1\n";
  const std::string grid = vary + "grid = [0, 1]\npoints = ";
  const std::string exact = drawn + "[[exact]]\nname = \"b\"\n";
  const std::string engines = drawn + "[engines]\nnames = [\"ode\"]\nsteps = ";
  const std::string points = "must be a whole number from 2 to 1000";
  const std::string number = "must be a number from -1e20 to 1e20";
  const std::string rising = "must be two numbers [low, high] with low below high";
  const std::string positive = "must be above 0 and at most 1e20";
  const std::string whole = "must be a whole number from 1 to 10000000";
  const std::string seed = "must be a whole number from 0 to 2^53";
  const std::string completion = "must be above 0 and at most 1e-10";
  struct Refused {
    std::string text;
    std::vector<std::string> problems;  // without the name of the file
  };
  for (const auto& [text, problems] : std::vector<Refused>{
           {grid + "-3", {"5: vary[0].points = -3: " + points}},
           {grid + "9223372036854775807", {"5: vary[0].points = 9223372036854775807: " + points}},
           {grid + "1", {"5: vary[0].points = 1: " + points}},
           {grid + "2.5", {"5: vary[0].points = 2.5: " + points}},
           {grid + "nan", {"5: vary[0].points = nan: " + points}},
           {grid + "inf", {"5: vary[0].points = inf: " + points}},
           {grid + "1e300", {"5: vary[0].points = 1e+300: " + points}},
           {vary + "grid = [-1e308, 1e308]\npoints = 3",
            {"4: vary[0].grid[0] = -1e+308: " + number, "4: vary[0].grid[1] = 1e+308: " + number}},
           {vary + "grid = [0, inf]\npoints = 3", {"4: vary[0].grid[1] = inf: " + number}},
           {vary + "uniform = [-1e308, 1e308]",
            {"4: vary[0].uniform[0] = -1e+308: " + number,
             "4: vary[0].uniform[1] = 1e+308: " + number}},
           {vary + "uniform = [nan, 1]", {"4: vary[0].uniform[0] = nan: " + number}},
           {vary + "uniform = [1, 1]", {"4: vary[0].uniform = [1, 1]: " + rising}},
           {vary + "normal = 1e308", {"4: vary[0].normal = 1e+308: " + positive}},
           {vary + "normal = 0", {"4: vary[0].normal = 0: " + positive}},
           {vary + "normal = -1", {"4: vary[0].normal = -1: " + positive}},
           {vary + "list = [1, 1e300]", {"4: vary[0].list[1] = 1e+300: " + number}},
           {vary + "list = [nan]", {"4: vary[0].list[0] = nan: " + number}},
           {"count = 0\n" + drawn, {"1: count = 0: " + whole}},
           {"count = -1\n" + drawn, {"1: count = -1: " + whole}},
           {"count = 9223372036854775807\n" + drawn, {"1: count = 9223372036854775807: " + whole}},
           {"seed = -1\n" + drawn, {"1: seed = -1: " + seed}},
           {"seed = 9223372036854775807\n" + drawn, {"1: seed = 9223372036854775807: " + seed}},
           {"until = 0\n" + drawn, {"1: until = 0: " + positive + " [s]"}},
           {"until = -inf\n" + drawn, {"1: until = -inf: " + positive + " [s]"}},
           {"until = 1e300\n" + drawn, {"1: until = 1e+300: " + positive + " [s]"}},
           {"speeds = [1e300, 1]\n" + drawn, {"1: speeds[0] = 1e+300: " + number + " [m/s]"}},
           {"speeds = [1, -1]\n" + drawn,
            {"1: speeds = [1, -1]: must be two falling speeds of at least 0.001 m/s"}},
           {"completion = 0\n" + drawn, {"1: completion = 0: " + completion}},
           {"completion = 1\n" + drawn, {"1: completion = 1: " + completion}},
           {exact + "seed = 0.5", {"7: exact[0].seed = 0.5: " + seed}},
           {exact + "completion = -1e-12", {"7: exact[0].completion = -1e-12: " + completion}},
           {exact + "quantity = \"x\"\nfactor = 1e300", {"8: exact[0].factor = 1e+300: " + number}},
           {engines + "[0]", {"7: engines.steps[0] = 0: " + positive + " [s]"}},
           {engines + "[-1e-3]", {"7: engines.steps[0] = -0.001: " + positive + " [s]"}},
           {engines + "[1e-3, inf]", {"7: engines.steps[1] = inf: " + positive + " [s]"}},
           {engines + "[1e-300]",
            {"7: engines.steps = [1e-300]: 1e-300 needs 2e+301 steps for 20 s, must need at most "
             "1e+09"}},
           {engines + "[1e-3, 1e-3]",
            {"7: engines.steps = [0.001, 0.001]: a step is given twice"}}}) {
    const SpecReading reading = read_spec_text(text, "test.toml");
    EXPECT_FALSE(reading.spec) << text;
    std::vector<std::string> expected;
    for (const std::string& problem : problems) {
      expected.push_back("test.toml:" + problem);
    }
    EXPECT_EQ(reading.problems, expected) << text;
  }
}

TEST(EnsembleSpec, ThoseToStartFromAreSound) {
  std::size_t count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(TAUTLINE_SPECS)) {
    const SpecReading reading = read_spec_file(entry.path());
    EXPECT_TRUE(reading.spec) << reading.problems.front();
    ++count;
  }
  EXPECT_EQ(count, 10U) << "as docs/guides/ensembles.md says";
}

TEST(EnsembleSpec, PathsCountFromItsFolder) {
  const std::string engines =
      "[engines]\nnames = [\"ode\", \"./mine.so\", \"js/engine.toml\", \"/there/a.so\"]\n";
  const std::string vary = "[[vary]]\nquantities = [\"x\"]\nnormal = 1\n";
  const SpecReading reading = read_spec_text(standard + vary + engines, "some/spec.toml");
  ASSERT_TRUE(reading.spec);
  EXPECT_EQ(
      reading.spec->engines,
      (std::vector<std::string>{"ode", "some/./mine.so", "some/js/engine.toml", "/there/a.so"}));
  const SpecReading missing =
      read_spec_text("case = \"mine.toml\"\n[[vary]]\nquantities = [\"length_1\"]\nnormal = 1\n",
                     "some/spec.toml");
  ASSERT_EQ(missing.problems.size(), 1U);
  EXPECT_NE(missing.problems[0].find("some/mine.toml"), std::string::npos) << missing.problems[0];
}

TEST(EnsembleSpec, RefusesWhatIsGivenTwiceByItsLine) {
  const SpecReading reading = read_spec_text(
      "case = \"breakwater/1910121100\"\n"
      "[[vary]]\nquantities = [\"x\", \"y\"]\nnormal = 1\n"
      "[[vary]]\nquantities = [\"spin\", \"x\"]\nnormal = 1\n"
      "[[exact]]\nname = \"other\"\n"
      "[[exact]]\nname = \"other\"\n"
      "[[exact]]\nname = \"exact\"\n",
      "test.toml");
  ASSERT_EQ(reading.problems.size(), 3U);
  std::string all;
  for (const std::string& problem : reading.problems) {
    all += problem + "\n";
  }
  for (const char* part : {"test.toml:6: vary[1].quantities = [\"spin\", \"x\"]: x is varied twice",
                           "test.toml:11: exact[1].name = \"other\": two are called other",
                           "test.toml:13: exact[2].name = \"exact\": two are called exact"}) {
    EXPECT_NE(all.find(part), std::string::npos) << part << "\nis not in:\n" << all;
  }
}

TEST(EnsembleSpec, AnotherExactMotionIsAsTheSpecInWhatItDoesNotSay) {
  const SpecReading reading = read_spec_text(
      "case = \"breakwater/1910121100\"\nlaw = \"sequential\"\n"
      "completion = 1e-12\n"
      "[[vary]]\nquantities = [\"x\"]\nnormal = 1\n"
      "[[exact]]\nname = \"another seed\"\nseed = 2\n"
      "[[exact]]\nname = \"another law\"\nlaw = \"simultaneous\"\n",
      "test.toml");
  ASSERT_TRUE(reading.spec) << reading.problems.front();
  const std::vector<ExactVariant>& exact = reading.spec->exact;
  ASSERT_EQ(exact.size(), 2U);
  EXPECT_EQ(exact[0].law, ImpactLaw::sequential);
  EXPECT_EQ(exact[0].completion, 1e-12);
  EXPECT_EQ(exact[1].law, ImpactLaw::simultaneous);
}

}  // namespace
}  // namespace tautline::bench
