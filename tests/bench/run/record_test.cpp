#include "bench/run/record.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "bench/store/run_files.hpp"
#include "tautline/detail/flight.hpp"
#include "tautline/geometry.hpp"
#include "tautline/scenarios.hpp"

namespace tautline::bench {
namespace {

/// A simulation that does in each step what the test says.
class Scripted final : public Simulation {
 public:
  using Step = std::function<void(Scripted&, int index, double dt)>;

  Scripted(const Case& the_case, Step step)
      : now(the_case.initial), pulls(the_case.cables.size()), step_(std::move(step)) {}
  [[nodiscard]] State state() const override { return now; }
  [[nodiscard]] std::span<const double> impulses() const override { return pulls; }
  [[nodiscard]] std::span<const Event> events() const override { return located; }
  [[nodiscard]] std::optional<Stop> stopped() const override { return stop; }
  void step(double dt) override {
    std::fill(pulls.begin(), pulls.end(), 0.0);
    located.clear();
    step_(*this, index_++, dt);
  }

  State now;
  std::vector<double> pulls;
  std::vector<Event> located;
  std::optional<Stop> stop;

 private:
  Step step_;
  int index_ = 0;
};

/// The same, which tells that its pulls hold its tensions.
class ScriptedTensions final : public TensionImpulses, public Simulation {
 public:
  ScriptedTensions(const Case& the_case, Scripted::Step step) : inner_(the_case, std::move(step)) {}
  [[nodiscard]] State state() const override { return inner_.state(); }
  [[nodiscard]] std::span<const double> impulses() const override { return inner_.impulses(); }
  [[nodiscard]] std::span<const double> tension_impulses() const override {
    return inner_.impulses();
  }
  void step(double dt) override { inner_.step(dt); }

 private:
  Scripted inner_;
};

/// A mass 1 on one cable straight below its anchor, without gravity: gap rate = vertical velocity.
Case plumb() {
  Case the_case = bouncing_ball(0.5);
  the_case.gravity = Vec2::Zero();
  the_case.duration = 1.0;
  the_case.initial.position = Vec2(0.0, 1.0);
  the_case.initial.velocity = Vec2(0.0, -1.0);
  return the_case;
}

TEST(Record, ConsecutiveStepsWithAnImpulseAreOneImpact) {
  Scripted simulation(plumb(), [](Scripted& s, int index, double /*dt*/) {
    if (index == 3 || index == 4) {  // closing at 1, then half of it, then opening at 0.5
      s.now.velocity.y() += 0.75;
      s.pulls[0] = 0.75;
    }
    if (index == 7) {
      s.now.velocity.y() = -0.2;  // something turns it round
    }
    if (index == 8) {
      s.now.velocity.y() = 0.1;
      s.pulls[0] = 0.3;
    }
  });
  const Trajectory run = record(plumb(), simulation, 0.1);
  ASSERT_EQ(run.impacts.size(), 2U);
  const RecordedImpact& first = run.impacts[0];
  EXPECT_DOUBLE_EQ(first.time, 0.3);
  EXPECT_EQ(first.steps, 2U);
  EXPECT_DOUBLE_EQ(first.impulse, 1.5);
  EXPECT_DOUBLE_EQ(first.rate_before, -1.0);
  EXPECT_DOUBLE_EQ(first.rate_after, 0.5);
  EXPECT_DOUBLE_EQ(first.ended, 0.4);
  EXPECT_DOUBLE_EQ(run.impacts[1].ended, 0.8);
  EXPECT_DOUBLE_EQ(run.impacts[1].time, 0.8);
  EXPECT_NEAR(-run.impacts[1].rate_after / run.impacts[1].rate_before, 0.5, 1e-15);
}

TEST(Record, TellsImpactsThatShareAStep) {
  Case both = plumb();
  both.cables.push_back(both.cables.front());
  Scripted simulation(both, [](Scripted& s, int index, double) {
    if (index == 3) {
      s.now.velocity.y() = 0.5;
      s.pulls = {0.75, 0.75};
    }
    if (index == 6) {
      s.now.velocity.y() = -0.4;  // something turns it round
    }
    if (index == 7) {
      s.now.velocity.y() = 0.2;
      s.pulls[1] = 0.6;
    }
  });
  const Trajectory run = record(both, simulation, 0.1);
  ASSERT_EQ(run.impacts.size(), 3U);
  EXPECT_TRUE(run.impacts[0].shared);
  EXPECT_TRUE(run.impacts[1].shared);
  EXPECT_FALSE(run.impacts[2].shared);
}

// a pull of 0.5 N that grows by 0.5 N from step to step
TEST(Record, TensionsAreMeansBetweenPoints) {
  const auto grow = [](Scripted& s, int index, double dt) { s.pulls[0] = 0.5 * (index + 1) * dt; };
  ScriptedTensions simulation(plumb(), grow);
  const Trajectory run = record(plumb(), simulation, 0.125);
  ASSERT_EQ(run.tensions.size(), run.points.size());
  EXPECT_TRUE(std::isnan(run.tensions[0]));
  for (std::size_t point = 1; point < run.points.size(); ++point) {
    EXPECT_NEAR(run.tensions[point], 0.5 * static_cast<double>(point), 1e-12);
  }
  ScriptedTensions again(plumb(), grow);
  const Trajectory thinned = record(plumb(), again, 0.125, {.most_points = 4});
  ASSERT_EQ(thinned.stride, 2U);
  EXPECT_NEAR(thinned.tensions[1], 0.75, 1e-12) << "the mean of 0.5 N and 1 N";
  const std::string csv = trajectory_csv(plumb(), run, 1000);
  EXPECT_TRUE(csv.starts_with("time,x,y,angle,vx,vy,spin,event,tension_0\n")) << csv.substr(0, 80);
  EXPECT_NE(csv.find(",,0.5\n"), std::string::npos) << csv;
}

/// The same, whose cables are springs and dampers.
class ScriptedSoft final : public SoftCables, public Simulation {
 public:
  ScriptedSoft(const Case& the_case, std::vector<SoftRow> rows)
      : inner_(the_case, [](Scripted&, int, double) {}), rows_(std::move(rows)) {}
  [[nodiscard]] State state() const override { return inner_.state(); }
  [[nodiscard]] std::span<const double> impulses() const override { return inner_.impulses(); }
  [[nodiscard]] std::span<const SoftRow> soft_rows() const override { return rows_; }
  void step(double dt) override { inner_.step(dt); }

 private:
  Scripted inner_;
  std::vector<SoftRow> rows_;
};

TEST(Record, SoftRowsAreThoseOfTheCables) {
  const auto recorded = [](const std::vector<SoftRow>& rows) {
    ScriptedSoft simulation(plumb(), rows);
    return record(plumb(), simulation, 0.125).soft_rows;
  };
  EXPECT_TRUE(recorded({}).empty());
  ASSERT_EQ(recorded({{4.0, 0.5, 0.25}}).size(), 1U);
  EXPECT_EQ(recorded({{4.0, 0.5, 0.25}})[0].stiffness, 4.0);
  const double nothing = std::nan("");
  for (const std::vector<SoftRow>& wrong : {std::vector<SoftRow>{{4.0, 0.0}, {4.0, 0.0}},
                                            {{0.0, 0.5}},
                                            {{4.0, -0.5}},
                                            {{nothing, 0.5}},
                                            {{4.0, nothing}},
                                            {{4.0, 0.5, 1.5}},
                                            {{4.0, 0.5, -0.5}}}) {
    EXPECT_THROW(recorded(wrong), std::runtime_error) << wrong[0].stiffness << wrong[0].damping;
  }
}

// as every plug-in does that is older than TensionImpulses
/// A body that goes straight away from the anchor of its cable with 0.1 m/s, whatever pulls. Its
/// elastic cable pulls with 1 N between two times.
class GoesOn final : public SystemSimulation {
 public:
  GoesOn(SpatialSystem system, double from, double until)
      : now_(std::move(system.initial)), from_(from), until_(until) {}
  [[nodiscard]] SpatialSystemState state() const override { return now_; }
  [[nodiscard]] std::span<const double> impulses() const override { return impulses_; }
  void step(double dt) override {
    const double end = time_ + dt;
    impulses_[0] = std::max(0.0, std::min(end, until_) - std::max(time_, from_));
    time_ = end;
    now_.bodies[0].position += dt * now_.bodies[0].velocity;
  }

 private:
  SpatialSystemState now_;
  double from_;   // [s]
  double until_;  // [s]
  double time_ = 0.0;
  std::vector<double> impulses_ = {0.0};
};

TEST(Record, AContactHasItsSpeedsWhereItsCableIsHookedUpAndCutInAStep) {
  SpatialSystem system;
  system.name = "goes on";
  system.duration = 0.4;
  system.bodies.resize(1);
  system.initial.bodies.resize(1);
  system.initial.bodies[0].position = {0.0, -1.0, 0.0};
  system.initial.bodies[0].velocity = {0.0, -0.1, 0.0};
  SpatialCable cable;
  cable.from = {std::nullopt, Eigen::Vector3d::Zero(), {}};
  cable.to = {0, Eigen::Vector3d::Zero(), {}};
  cable.elasticity = Elasticity{{100.0}, 0.0, 0.0};
  cable.from_time = 0.1005;
  cable.cut_at = 0.2005;
  system.cables = {cable};
  GoesOn simulation(system, *cable.from_time, *cable.cut_at);
  const SystemTrajectory run = record(system, simulation, 1e-3);
  ASSERT_EQ(run.contacts.size(), 1U);
  const ElasticContact& contact = run.contacts.front();
  EXPECT_NEAR(contact.impulse, 0.1, 1e-12);
  EXPECT_NEAR(contact.entry_speed, 0.1, 1e-12);
  EXPECT_NEAR(contact.exit_speed, -0.1, 1e-12);  // it is cut while it is stretched
  EXPECT_NEAR(contact.exit.value(), *cable.cut_at, 1e-3);
}

TEST(Record, ASimulationThatTellsNoTensionsHasNone) {
  Scripted simulation(plumb(), [](Scripted& s, int, double dt) { s.pulls[0] = dt; });
  const Trajectory run = record(plumb(), simulation, 0.125);
  EXPECT_TRUE(run.tensions.empty());
  EXPECT_TRUE(trajectory_csv(plumb(), run, 1000).starts_with("time,x,y,angle,vx,vy,spin,event\n"));
}

TEST(Record, TheSnapOfACableThatGoesOnTautIsItsImpactAlone) {
  Scripted simulation(plumb(), [](Scripted& s, int index, double dt) {
    if (index == 3) {  // stops it, and then it pulls for ever
      s.pulls[0] = 1.0;
      s.now.velocity.y() = 0.0;
    } else if (index > 3) {
      s.pulls[0] = 9.81 * dt;
    }
    s.now.position += dt * s.now.velocity;
  });
  const Trajectory run = record(plumb(), simulation, 0.125);
  ASSERT_EQ(run.impacts.size(), 1U);
  EXPECT_EQ(run.impacts[0].snap, 1.0);
  EXPECT_GT(run.impacts[0].impulse, 1.0);
}

TEST(Record, TheSnapOfACableThatThrowsBackIsAllItPulled) {
  Scripted simulation(plumb(), [](Scripted& s, int index, double dt) {
    if (index >= 3 && index < 6) {  // closing at 1, 0.5, 0, then opening at 0.5
      s.pulls[0] = 0.5;
      s.now.velocity.y() += 0.5;
    }
    s.now.position += dt * s.now.velocity;
  });
  const Trajectory run = record(plumb(), simulation, 0.125);
  ASSERT_EQ(run.impacts.size(), 1U);
  EXPECT_EQ(run.impacts[0].snap, 1.5);
}

TEST(Record, TheRowAfterAPushOverSeveralStepsStandsWhereItEnded) {
  Scripted simulation(plumb(), [](Scripted& s, int index, double dt) {
    if (index == 3 || index == 4) {
      s.now.velocity.y() += 0.75;
      s.pulls[0] = 0.75;
    }
    s.now.position += dt * s.now.velocity;
  });
  const Trajectory run = record(plumb(), simulation, 0.125);
  std::istringstream csv(trajectory_csv(plumb(), run, 1000));
  std::map<std::string, std::vector<double>> rows;  // the last of each kind: time, x, y
  double latest = 0.0;
  for (std::string line; std::getline(csv, line);) {
    if (line.starts_with("time")) {
      continue;
    }
    std::istringstream cells(line);
    std::vector<double>& row = rows[line.substr(line.rfind(',') + 1)];
    row.clear();
    for (std::string cell; row.size() < 3 && std::getline(cells, cell, ',');) {
      row.push_back(std::stod(cell));
    }
    EXPECT_GE(row[0], latest) << line;
    latest = row[0];
  }
  EXPECT_EQ(rows.at("before")[0], 0.375);
  EXPECT_EQ(rows.at("before")[2], 1.0 - 0.375);
  EXPECT_EQ(rows.at("after")[0], 0.5);  // the start of the second of its steps
  EXPECT_EQ(rows.at("after")[2], run.points.at(4).state.position.y());
}

/// The events of a trajectory.csv with their times, in the order of the file.
std::vector<std::pair<double, std::string>> events_of(const std::string& csv) {
  std::vector<std::pair<double, std::string>> events;
  std::istringstream lines(csv);
  for (std::string line; std::getline(lines, line);) {
    const std::string event = line.substr(line.rfind(',') + 1);
    if (event == "before" || event == "after") {
      events.emplace_back(std::stod(line), event);
    }
  }
  return events;
}

TEST(Record, CablesThatActAtOneInstantShareOnePairOfRows) {
  Case the_case = plumb();
  the_case.cables.push_back(the_case.cables.front());
  the_case.cables.push_back(the_case.cables.front());
  // two cables from step 3 on, one of them for two steps; the third while that one still pulls
  Scripted simulation(the_case, [](Scripted& s, int index, double dt) {
    const auto pull = [&](std::size_t cable) {
      s.now.velocity.y() += 0.4;
      s.pulls[cable] = 0.4;
    };
    if (index == 3 || index == 4) {
      pull(0);
      pull(index == 3 ? 1 : 2);
    }
    s.now.position += dt * s.now.velocity;
  });
  const Trajectory run = record(the_case, simulation, 0.125);
  ASSERT_EQ(run.impacts.size(), 3U);
  const std::vector<std::pair<double, std::string>> expected = {
      {0.375, "before"}, {0.375, "after"}, {0.5, "before"}, {0.5, "after"}};
  EXPECT_EQ(events_of(trajectory_csv(the_case, run, 1000)), expected)
      << trajectory_csv(the_case, run, 1000);
}

TEST(Record, BelievesASimulationThatLocatesItsImpacts) {
  Scripted simulation(plumb(), [](Scripted& s, int index, double /*dt*/) {
    if (index == 2) {
      State after = s.now;
      after.velocity.y() = 0.5;
      CableVector impulse(1);
      impulse << 1.5;
      s.located.push_back({0.2345, EventKind::impact, CableSet::of(0), impulse, s.now, after});
      s.pulls[0] = 1.5;
      s.now = after;
    }
  });
  const Trajectory run = record(plumb(), simulation, 0.1);
  ASSERT_EQ(run.impacts.size(), 1U);
  EXPECT_EQ(run.impacts[0].time, 0.2345);
  EXPECT_EQ(run.impacts[0].steps, 0U);
  EXPECT_DOUBLE_EQ(run.impacts[0].rate_after, 0.5);
}

TEST(Record, MeasuresTheRestitutionOfTheVelocitiesThatTheEngineStores) {
  // semi-implicit Euler with a row, as engines do it: the bounce of the stored velocity includes
  // this step's gravity, whatever the step
  for (const double step : {1e-1, 1e-2, 1e-3}) {
    Case the_case = bouncing_ball(0.5);
    the_case.duration = 1.5;
    const Cable& cable = the_case.cables[0];
    Scripted simulation(the_case, [&cable](Scripted& s, int /*index*/, double dt) {
      const double closing = -s.now.velocity.y();
      s.now.velocity.y() -= dt;
      if (gap(cable, s.now) <= 0.0 && closing > 0.0) {
        s.pulls[0] = 0.5 * closing - s.now.velocity.y();
        s.now.velocity.y() = 0.5 * closing;
      }
      s.now.position.y() += dt * s.now.velocity.y();
    });
    const Trajectory run = record(the_case, simulation, step);
    ASSERT_GE(run.impacts.size(), 1U);
    EXPECT_NEAR(run.impacts[0].rate_before, -1.0, 2.0 * step);
    EXPECT_NEAR(-run.impacts[0].rate_after / run.impacts[0].rate_before, 0.5, 1e-14);
  }
}

TEST(Record, TakesAsManyStepsAsFitAndAShorterLastOne) {
  EXPECT_EQ(step_count(20.0, 1e-3), 20'000U);
  EXPECT_EQ(step_count(20.0, 1e-4), 200'000U);
  EXPECT_EQ(step_count(1.0, 0.3), 4U);
  EXPECT_EQ(step_count(1.0, 5.0), 1U);
  std::vector<double> steps;
  Scripted simulation(plumb(), [&](Scripted&, int, double dt) { steps.push_back(dt); });
  const Trajectory run = record(plumb(), simulation, 0.3);
  ASSERT_EQ(steps.size(), 4U);
  EXPECT_EQ(steps[0], 0.3);
  EXPECT_NEAR(steps[3], 0.1, 1e-15);
  EXPECT_EQ(run.points.back().time, 1.0);
}

TEST(Record, ThinsLongRunsButSeesEveryStep) {
  Scripted simulation(plumb(), [](Scripted& s, int index, double) {
    s.now.position.y() = index == 501 ? -0.25 : 1.0;  // 0.25 beyond the cable for one step
    s.now.velocity.y() = -1.0;
  });
  const Trajectory run = record(plumb(), simulation, 1e-3, {.most_points = 100});
  EXPECT_EQ(run.stride, 10U);
  EXPECT_EQ(run.points.size(), 101U);
  EXPECT_DOUBLE_EQ(run.overstretch, 0.25);
}

TEST(Record, EndsARunThatLeavesEveryReasonableRange) {
  for (const double wild :
       {1e9, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
    Scripted simulation(plumb(), [wild](Scripted& s, int index, double) {
      if (index == 3) {
        s.now.position.x() = wild;
      }
    });
    const Trajectory run = record(plumb(), simulation, 0.1);
    EXPECT_TRUE(run.diverged);
    EXPECT_DOUBLE_EQ(run.points.back().time, 0.3);  // the last sound state
  }
}

TEST(Record, KeepsTheTimeAtWhichASimulationStopped) {
  Scripted simulation(plumb(), [](Scripted& s, int index, double) {
    if (index == 4) {
      s.stop = Simulation::Stop{0.45, "enough"};
    }
  });
  const Trajectory run = record(plumb(), simulation, 0.1);
  ASSERT_TRUE(run.stop);
  EXPECT_EQ(run.points.back().time, 0.45);
  EXPECT_EQ(run.points.size(), 6U);
}

TEST(Record, OnlyCountsChatter) {
  Scripted simulation(plumb(), [](Scripted& s, int index, double) {
    s.now.velocity.y() = index % 2 == 0 ? -1e-6 : 1e-6;
    s.pulls[0] = index % 2 == 1 ? 2e-6 : 0.0;
  });
  const Trajectory run = record(plumb(), simulation, 0.01);
  EXPECT_TRUE(run.impacts.empty());
  EXPECT_EQ(run.slow_impacts, 50U);
}

}  // namespace
}  // namespace tautline::bench
