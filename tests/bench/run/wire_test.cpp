#include "bench/run/wire.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>

namespace tautline::bench {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// What the other side reads of `answer`.
template <class Answer>
Answer sent(const Answer& answer) {
  return std::get<Answer>(answer_from(to_bytes(answer)).value());
}

State some_state() { return {Vec2(0.1, -0.0), 1e-300, Vec2(-1e300, 1.0 / 3.0), 7.0}; }

void expect_same(const State& a, const State& b) {
  EXPECT_EQ(a.position, b.position);
  EXPECT_EQ(a.velocity, b.velocity);
  EXPECT_EQ(a.angle, b.angle);
  EXPECT_EQ(a.spin, b.spin);
}

TEST(Wire, ARequestComesAsItWasSent) {
  WorkerRequest request{Task::run, "/a path/e.so",   std::size_t{3} << 30U,
                        "row",     "name = \"a\"\n", {0.1, ImpactLaw::energetic}};
  request.costs = false;
  request.more = true;
  const WorkerRequest read = request_from(to_bytes(request));
  EXPECT_EQ(read.task, request.task);
  EXPECT_EQ(read.plugin, request.plugin);
  EXPECT_EQ(read.memory, request.memory);
  EXPECT_EQ(read.model, request.model);
  EXPECT_EQ(read.case_text, request.case_text);
  EXPECT_EQ(read.settings.step, request.settings.step);
  EXPECT_EQ(read.settings.law, request.settings.law);
  EXPECT_EQ(read.costs, request.costs);
  EXPECT_EQ(read.more, request.more);
}

TEST(Wire, StrikesComeWithTheLawOfTheirCable) {
  const StrikesAnswer read = sent(StrikesAnswer{{0.5, infinite}, SoftRow{1e6, 98.7737, 0.9999}});
  ASSERT_EQ(read.restitutions.size(), 2U);
  EXPECT_EQ(read.restitutions[0], 0.5);
  EXPECT_TRUE(std::isnan(read.restitutions[1]));
  ASSERT_TRUE(read.law);
  EXPECT_EQ(read.law->stiffness, 1e6);
  EXPECT_EQ(read.law->damping, 98.7737);
  EXPECT_EQ(read.law->load, 0.9999);
  EXPECT_FALSE(sent(StrikesAnswer{{0.5}, std::nullopt}).law);
}

TEST(Wire, ARunComesBitForBit) {
  RunAnswer run;
  run.cost = {1e-7, 2e8, 3e-9, 4e-8, 5e-8, 6e-7, 0.5, 9};
  run.trajectory.step = 0.1;
  run.trajectory.stride = 3;
  run.trajectory.points = {{0.0, some_state()}, {0.3, State()}};
  run.trajectory.impacts = {
      {0.25, 7, 1.5, -1.0, 0.5, 2, some_state(), State(), {1.0, 2.0, 3.0}, 0.3, true}};
  run.trajectory.contacts = {{3, 0.1, 0.2, 1.0, 0.5, 40.0, 0.15, 0.01, 2.5},
                             {4, 0.2, std::nullopt, 1.5, 0.0, 30.0, 0.25, 0.02, 3.5}};
  run.trajectory.soft_rows = {{4.0, 0.5, 0.25}};
  run.trajectory.slow_impacts = 123'456'789;
  run.trajectory.overstretch = 1e-9;
  run.trajectory.largest_energy = 2.0;
  run.trajectory.stop = Simulation::Stop{0.3, "enough"};
  run.trajectory.diverged = true;
  const RunAnswer read = sent(run);
  EXPECT_EQ(read.cost.step, run.cost.step);
  EXPECT_EQ(read.cost.memory, run.cost.memory);
  EXPECT_EQ(read.cost.reference, run.cost.reference);
  EXPECT_EQ(read.cost.smallest, run.cost.smallest);
  EXPECT_EQ(read.cost.lower, run.cost.lower);
  EXPECT_EQ(read.cost.upper, run.cost.upper);
  EXPECT_EQ(read.cost.dt, run.cost.dt);
  EXPECT_EQ(read.cost.repetitions, run.cost.repetitions);
  EXPECT_EQ(read.trajectory.step, 0.1);
  EXPECT_EQ(read.trajectory.stride, 3U);
  ASSERT_EQ(read.trajectory.soft_rows.size(), 1U);
  EXPECT_EQ(read.trajectory.soft_rows[0].stiffness, 4.0);
  EXPECT_EQ(read.trajectory.soft_rows[0].damping, 0.5);
  EXPECT_EQ(read.trajectory.soft_rows[0].load, 0.25);
  EXPECT_EQ(read.trajectory.slow_impacts, 123'456'789U);
  EXPECT_EQ(read.trajectory.overstretch, 1e-9);
  EXPECT_EQ(read.trajectory.largest_energy, 2.0);
  EXPECT_TRUE(read.trajectory.diverged);
  ASSERT_TRUE(read.trajectory.stop);
  EXPECT_EQ(read.trajectory.stop->time, 0.3);
  EXPECT_EQ(read.trajectory.stop->reason, "enough");
  ASSERT_EQ(read.trajectory.points.size(), 2U);
  EXPECT_EQ(read.trajectory.points[1].time, 0.3);
  expect_same(read.trajectory.points[0].state, some_state());
  EXPECT_TRUE(std::signbit(read.trajectory.points[0].state.position.y()));
  ASSERT_EQ(read.trajectory.impacts.size(), 1U);
  const RecordedImpact& impact = read.trajectory.impacts.front();
  EXPECT_EQ(impact.time, 0.25);
  EXPECT_EQ(impact.cable, 7U);
  EXPECT_EQ(impact.impulse, 1.5);
  EXPECT_EQ(impact.rate_before, -1.0);
  EXPECT_EQ(impact.rate_after, 0.5);
  EXPECT_EQ(impact.steps, 2U);
  EXPECT_EQ(impact.stray, Eigen::Vector3d(1.0, 2.0, 3.0));
  EXPECT_TRUE(impact.shared);
  expect_same(impact.before, some_state());
  ASSERT_EQ(read.trajectory.contacts.size(), 2U);
  const ElasticContact& contact = read.trajectory.contacts.front();
  EXPECT_EQ(contact.cable, 3U);
  EXPECT_EQ(contact.entry, 0.1);
  EXPECT_EQ(contact.exit, 0.2);
  EXPECT_EQ(contact.entry_speed, 1.0);
  EXPECT_EQ(contact.exit_speed, 0.5);
  EXPECT_EQ(contact.peak, 40.0);
  EXPECT_EQ(contact.peak_time, 0.15);
  EXPECT_EQ(contact.greatest_stretch, 0.01);
  EXPECT_EQ(contact.impulse, 2.5);
  EXPECT_FALSE(read.trajectory.contacts.back().exit);
}

TEST(Wire, WhatIsNotFiniteComesAsNoNumber) {
  RunAnswer run;
  run.trajectory.points = {{0.0, State()}};
  run.trajectory.overstretch = infinite;
  run.trajectory.largest_energy = std::nan("");
  const RunAnswer read = sent(run);
  EXPECT_TRUE(std::isnan(read.trajectory.overstretch));
  EXPECT_TRUE(std::isnan(read.trajectory.largest_energy));
  EXPECT_FALSE(read.trajectory.stop);
  const CheckAnswer check =
      sent(CheckAnswer{{{"mass", infinite, 0.02, false, "never hit"}}, "", ""});
  EXPECT_TRUE(std::isnan(check.claims.front().found));
  EXPECT_EQ(check.claims.front().limit, 0.02);
}

TEST(Wire, EveryOtherAnswerComesAsItWasSent) {
  EXPECT_EQ(sent(Failure{"crashed"}).sentence, "crashed");
  EXPECT_EQ(sent(DigestAnswer{"0123"}).digest, "0123");
  const CheckAnswer check =
      sent(CheckAnswer{{{"mass", 0.0, 0.02, true, "moves"}}, "inertia", "0123"});
  ASSERT_EQ(check.claims.size(), 1U);
  EXPECT_EQ(check.claims.front().claim, "mass");
  EXPECT_TRUE(check.claims.front().holds);
  EXPECT_EQ(check.claims.front().sentence, "moves");
  EXPECT_EQ(check.unfinished, "inertia");
  EXPECT_EQ(check.digest, "0123");
  const EngineInfo info = sent(
      EngineInfo{"mine",
                 "1.0",
                 "float64",
                 {{"row", "A row.", {{"erp", "0.2", "The default.", Origin::engine_default}}}}});
  EXPECT_EQ(info.name, "mine");
  EXPECT_EQ(info.version, "1.0");
  EXPECT_EQ(info.precision, "float64");
  ASSERT_EQ(info.models.size(), 1U);
  EXPECT_EQ(info.models.front().sentence, "A row.");
  ASSERT_EQ(info.models.front().settings.size(), 1U);
  EXPECT_EQ(info.models.front().settings.front().value, "0.2");
  EXPECT_EQ(info.models.front().settings.front().origin, Origin::engine_default);
}

TEST(Wire, AMessageThatIsCutIsNone) {
  RunAnswer run;
  run.trajectory.points = {{0.0, some_state()}};
  const std::string bytes = to_bytes(run);
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    EXPECT_FALSE(answer_from(std::string_view(bytes).substr(0, size))) << size;
  }
}

TEST(Wire, AMessageThatMakesNoSenseIsAFailure) {
  std::string bytes = to_bytes(Failure{"a"});
  bytes.replace(bytes.find("sentence"), 8, "nonsense");
  EXPECT_EQ(std::get<Failure>(answer_from(bytes).value()).sentence,
            "gave a result that makes no sense");
}

/// True if `answer` with `from` changed to `to` is a failure.
template <class Answer>
bool fails(const Answer& answer, const std::string& from, const std::string& to) {
  std::string bytes = to_bytes(answer);
  const std::size_t at = bytes.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  bytes.replace(at, from.size(), to);
  std::uint64_t head = 0;  // its size comes first; where it has the number, it grows or shrinks
  std::memcpy(&head, bytes.data(), sizeof head);
  if (at < 2 * sizeof head + head) {
    head += to.size() - from.size();
    std::memcpy(bytes.data(), &head, sizeof head);
  }
  return std::holds_alternative<Failure>(answer_from(bytes).value());
}

TEST(Wire, ANumberThatDoesNotFitIsAFailure) {
  const auto bytes_of = [](double number) {
    std::string bytes(sizeof number, '\0');
    std::memcpy(bytes.data(), &number, sizeof number);
    return bytes;
  };
  constexpr double count = 123'456'789.0;  // the message has each of the two once
  constexpr double energy = 0.375;
  RunAnswer run;
  run.trajectory.points = {{0.0, State()}};
  run.trajectory.slow_impacts = static_cast<std::size_t>(count);
  run.trajectory.largest_energy = energy;
  EXPECT_FALSE(fails(run, bytes_of(count), bytes_of(0.0)));
  for (const double number : {-1.0, 1.5, 1e300, infinite, std::nan("")}) {
    EXPECT_TRUE(fails(run, bytes_of(count), bytes_of(number))) << number;
    EXPECT_FALSE(fails(run, bytes_of(energy), bytes_of(number))) << number;
  }

  Model model{"row", "A row.", {}};
  model.maker = Maker::engine;
  model.parameters = {{"k", 1.5, 2.5, false, -2}};
  const EngineInfo info{"mine", "1.0", "float64", {model}};
  EXPECT_FALSE(fails(info, "-2", "-1"));
  EXPECT_TRUE(fails(info, "-2", "-1e30"));
  EXPECT_TRUE(fails(info, "-2", "-0.5"));
  EXPECT_FALSE(fails(info, "\"maker\":0", "\"maker\":2"));
  EXPECT_TRUE(fails(info, "\"maker\":0", "\"maker\":3"));
  EXPECT_FALSE(fails(info, "\"cables\":0", "\"cables\":2"));
  EXPECT_TRUE(fails(info, "\"cables\":0", "\"cables\":3"));
  EXPECT_TRUE(fails(info, "[1,", "[1.5,"));
  EXPECT_TRUE(fails(info, "[1,", "[77,"));
}

TEST(Wire, ARunWhosePartsDoNotFitEachOtherIsAFailure) {
  const auto is_refused = [](const RunAnswer& run) {
    return std::holds_alternative<Failure>(answer_from(to_bytes(run)).value());
  };
  RunAnswer run;
  EXPECT_TRUE(is_refused(run)) << "no points";
  run.trajectory.points = {{0.0, State()}, {0.1, State()}};
  run.trajectory.tensions = {1.0, 2.0, 3.0, 4.0};
  run.trajectory.impacts.resize(1);
  EXPECT_FALSE(is_refused(run));
  run.trajectory.tensions.push_back(5.0);
  EXPECT_TRUE(is_refused(run)) << "tensions of half a point";
  run.trajectory.tensions.clear();
  run.trajectory.soft_rows.resize(max_cables + 1);
  EXPECT_TRUE(is_refused(run)) << "soft rows of more cables than a case has";
  run.trajectory.soft_rows.clear();
  run.trajectory.impacts[0].cable = max_cables;
  EXPECT_TRUE(is_refused(run)) << "an impact of a cable that no case has";
}

}  // namespace
}  // namespace tautline::bench
