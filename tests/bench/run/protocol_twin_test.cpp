// A sound child: the same bits as a plug-in of the same arithmetic, and every double there and
// back.
#include <gtest/gtest.h>

#include <bit>
#include <limits>
#include <nlohmann/json.hpp>
#include <random>

#include "bench/cases/catalogue.hpp"
#include "bench/run/plugin.hpp"
#include "bench/run/protocol/children.hpp"
#include "tests/bench/run/protocol_support.hpp"

namespace tautline::test {
namespace {

using nlohmann::json;

/// What `run` finds and writes.
struct Found {
  json run;
  std::string trajectory;
  std::string events;
};

Found found_with(const std::string& engine, const std::string& model, const std::string& step) {
  const TemporaryFolder out;
  const std::string file = (out.path() / "run.json").string();
  const Outcome outcome =
      program({"run", "crane-load", "--engine", engine, "--model", model, "--step", step, "--json",
               file, "--out", (out.path() / "r").string()});
  Found found;
  found.run = json::parse(content_of(file), nullptr, false);
  EXPECT_FALSE(found.run.is_discarded()) << outcome.errors;
  const auto folder = out.path() / "r/runs/crane-load/twin" / model / step;
  found.trajectory = content_of(folder / "trajectory.csv");
  found.events = content_of(folder / "events.csv");
  return found;
}

class SoundChildren : public testing::TestWithParam<std::pair<std::string, std::string>> {};

TEST_P(SoundChildren, RunsLikeAPluginOfTheSameArithmeticBitForBit) {
  if (!has_python()) {
    GTEST_SKIP() << no_python;
  }
  const auto& [model, step] = GetParam();
  const TemporaryFolder folder;
  const Found outside = found_with(sound_child(folder), model, step);
  const Found plugin = found_with(bad_engine("twin"), model, step);
  EXPECT_GT(outside.trajectory.size(), 1000U);
  EXPECT_EQ(outside.trajectory, plugin.trajectory);
  EXPECT_EQ(outside.events, plugin.events);
  EXPECT_EQ(outside.run.at("metrics"), plugin.run.at("metrics"));
  EXPECT_EQ(outside.run.at("details"), plugin.run.at("details"));
}

INSTANTIATE_TEST_SUITE_P(Each, SoundChildren,
                         testing::Values(std::pair("row", "0.001"), std::pair("row", "0.03"),
                                         std::pair("event", "0.01")),
                         [](const auto& test) {
                           std::string name = test.param.first + test.param.second;
                           std::erase(name, '.');
                           return name;
                         });

/// Both numbers of each step that follow from these lengths.
std::vector<double> stepped(const bench::Plugin& plugin, const std::vector<double>& lengths) {
  const std::vector<std::string> names = {"crane-load"};
  const Case the_case = bench::select_cases(names).cases.front();
  const auto simulation = plugin.engine().start(the_case, "row", lengths.front());
  std::vector<double> numbers;
  for (const double dt : lengths) {
    simulation->step(dt);
    const State state = simulation->state();
    numbers.insert(numbers.end(),
                   {state.position.x(), state.position.y(), state.angle, state.velocity.x(),
                    state.velocity.y(), state.spin, simulation->impulses()[0]});
  }
  return numbers;
}

TEST(SoundChild, TakesAStepOfAnotherLengthWhereStepsWereAskedForAhead) {
  if (!has_python()) {
    GTEST_SKIP() << no_python;
  }
  std::vector<double> lengths(300, 0.01);
  for (const std::size_t odd : {1U, 140U, 141U, 250U}) {
    lengths[odd] = 0.004;
  }
  const TemporaryFolder folder;
  EXPECT_EQ(stepped(bench::Plugin::open(sound_child(folder)), lengths),
            stepped(bench::Plugin::open(bad_engine("twin")), lengths));
}

TEST(SoundChild, CostsTheProcessorTimeOfItsOwnProcess) {
  if (!has_python()) {
    GTEST_SKIP() << no_python;
  }
  const TemporaryFolder folder;
  const bench::Plugin plugin = bench::Plugin::open(bad_child(folder, "busy"));
  const std::vector<std::string> names = {"crane-load"};
  const Case the_case = bench::select_cases(names).cases.front();
  const bench::Cost cost =
      bench::measure_cost(the_case, plugin.engine(), "row", 0.1, plugin.meter());
  constexpr double least = 1e-3;  // [s], what the child takes for each step
  EXPECT_GE(cost.step, least);
  EXPECT_LT(cost.step, 2.0 * least) << "steps that were not asked for count";
  constexpr double interpreter = 5e6;  // [bytes]: none is smaller
  EXPECT_GT(cost.memory, interpreter);
}

bench::KeptCommand twin_command() {
  return {{"python3", (children_folder / "twin.py").string()}, "/", std::size_t{1} << 30U};
}

Case one_cable() {
  Case result;
  result.name = "one \"cable\"\n\t\\";
  result.cables.resize(1);
  return result;
}

std::vector<std::uint64_t> bits_of(const State& state) {
  std::vector<std::uint64_t> bits;
  for (const double value : {state.position.x(), state.position.y(), state.angle,
                             state.velocity.x(), state.velocity.y(), state.spin}) {
    bits.push_back(std::bit_cast<std::uint64_t>(value));
  }
  return bits;
}

TEST(Numbers, ComeBackFromAChildBitForBit) {
  if (!has_python()) {
    GTEST_SKIP() << no_python;
  }
  bench::Conversation child(twin_command());
  static_cast<void>(child.start(one_cable(), child.info().models.front(), 1e-3));
  constexpr unsigned seed = 7;
  std::mt19937_64 random(seed);
  const double infinity = std::numeric_limits<double>::infinity();
  std::vector<double> numbers = {-0.0,
                                 0.0,
                                 5e-324,
                                 -5e-324,
                                 infinity,
                                 -infinity,
                                 0.1,
                                 1e22,
                                 std::numeric_limits<double>::quiet_NaN(),
                                 9007199254740993.0,
                                 std::numeric_limits<double>::max(),
                                 1.0 / 3.0};
  while (numbers.size() < 6 * 500) {
    const auto drawn = std::bit_cast<double>(random());
    if (!std::isnan(drawn)) {  // of which there is one
      numbers.push_back(drawn);
    }
  }
  for (std::size_t at = 0; at < numbers.size(); at += bench::state_width) {
    const State state = bench::state_from(numbers.data() + at);
    EXPECT_EQ(bits_of(bench::state_from(child.place(state).data())), bits_of(state))
        << "seed " << seed << ", from " << at;
  }
}

TEST(Children, DoOneRunAtATimeAndTheNextAfterIt) {
  if (!has_python()) {
    GTEST_SKIP() << no_python;
  }
  bench::Children children(twin_command());
  const bench::Conversation* first = nullptr;
  {
    const bench::Children::Lease one(children);
    const bench::Children::Lease other(children);
    first = &*one;
    EXPECT_NE(&*one, &*other) << "two runs at once share a process";
  }
  const bench::Children::Lease next(children);
  EXPECT_EQ(&*next, first) << "a process that is free is not taken";
}

}  // namespace
}  // namespace tautline::test
