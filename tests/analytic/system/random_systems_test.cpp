#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/QR>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <vector>

#include "support.hpp"
#include "system/elastic_systems.hpp"
#include "system/random_system.hpp"
#include "system/systems.hpp"
#include "tautline/solve.hpp"
#include "tautline/system_geometry.hpp"
#include "tautline/system_ledger.hpp"

// What every motion of a system keeps to, on random ones.

namespace tautline::test {
namespace {

/// What became of many systems.
struct Tally {
  int solved = 0;
  std::array<int, 11> endings{};  // by Ending
  double overstretch = 0.0;       // [-], of a cable's length
  double residual = 0.0;          // [-], of the ledger's range
  double gained = 0.0;            // [-], in impacts, of that
  double slowest = 0.0;           // [s] of processor time
};

template <int D>
void measure(const BasicSystem<double, D>& system, Tally& tally) {
  SolveOptions options;
  options.max_events = 2000;
  options.max_steps = 20'000;  // a body that is drawn into a ring takes ever shorter ones
  const std::clock_t start = std::clock();
  const auto solution = solve(system, options);
  tally.slowest = std::max(tally.slowest, static_cast<double>(std::clock() - start) /
                                              static_cast<double>(CLOCKS_PER_SEC));
  ++tally.solved;
  ++tally.endings[static_cast<std::size_t>(solution.ending())];
  constexpr int samples = 300;
  for (int k = 0; k <= samples; ++k) {
    const double time = std::min(solution.end_time(), solution.end_time() * k / samples);
    const auto state = solution.at(time);
    for (const auto& cable : system.cables) {
      if (!cable.elasticity) {
        tally.overstretch =
            std::max(tally.overstretch, -gap(cable, state) / cable.length.at(time)[0]);
      }
    }
  }
  if (solution.ending() != Ending::reached_duration && solution.ending() != Ending::rest) {
    return;  // near a dead point, to which a winch pulls, speeds grow without bound
  }
  const SystemLedger ledger = energy_ledger(system, solution);
  const double range = std::max(ledger.range, 1e-3);
  tally.residual = std::max(tally.residual, std::abs(ledger.residual) / range);
  tally.gained = std::max(tally.gained, -std::min(ledger.impacts, ledger.dissipated) / range);
}

#ifdef TAUTLINE_SANITIZED
constexpr double patience = 50.0;  // [s]: sanitizers slow this down tenfold
#else
constexpr double patience = 5.0;  // [s] of processor time
#endif

void report(const Tally& tally) {
  std::printf("%d solved; endings:", tally.solved);
  int whole = 0;
  for (std::size_t i = 0; i < tally.endings.size(); ++i) {
    const auto ending = static_cast<Ending>(i);
    whole += ending == Ending::reached_duration || ending == Ending::rest ? tally.endings[i] : 0;
    std::printf(" %d", tally.endings[i]);
  }
  std::printf("\n");
  // a winch draws some into a dead point or a ring, and some have more than 2000 events
  expect_within("part that ends early [-]", 1.0 - static_cast<double>(whole) / tally.solved, 0.05);
  expect_within("slowest [s]", tally.slowest, patience);
  expect_within("overstretch [-]", tally.overstretch, 1e-12);
  expect_within("ledger [-]", tally.residual, 1e-12);
  expect_within("energy gained in impacts and elastic cables [-]", tally.gained, 1e-12);
}

#ifdef TAUTLINE_SANITIZED
constexpr int drawn_in_space = 30;  // sanitizers slow this down tenfold
constexpr int drawn_in_plane = 50;
constexpr int scanned = 8;
constexpr int elastic_in_plane = 12;
constexpr int elastic_in_space = 8;
#else
constexpr int drawn_in_space = 1000;
constexpr int drawn_in_plane = 2000;
constexpr int scanned = 200;
constexpr int elastic_in_plane = 300;
constexpr int elastic_in_space = 200;
#endif

TEST(RandomSystems, NeverOverstretchAndTheirLedgersClose) {
  Random random(39);
  Tally tally;
  for (int i = 0; i < drawn_in_plane; ++i) {
    const System system = random_system(random);
    if (problems(system).empty()) {
      SCOPED_TRACE("system " + std::to_string(i));
      measure(system, tally);
    }
  }
  EXPECT_GT(tally.solved, drawn_in_plane * 3 / 4);
  report(tally);
}

TEST(RandomSystems, NeverOverstretchInSpace) {
  Random random(40);
  Tally tally;
  for (int i = 0; tally.solved < drawn_in_space; ++i) {
    const SpatialSystem system = random_spatial_system(random);
    if (problems(system).empty()) {
      SCOPED_TRACE("system " + std::to_string(i));
      measure(system, tally);
    }
  }
  report(tally);
}

/// A point of a body in the world, by matrices.
Vec2 placed(const State& body, const Vec2& at) {
  return body.position + Eigen::Rotation2Dd(body.angle) * at;
}
Eigen::Vector3d placed(const SpatialState& body, const Eigen::Vector3d& at) {
  const Quaternion& q = body.orientation;
  return body.position + Eigen::Quaterniond(q[0], q[1], q[2], q[3]).toRotationMatrix() * at;
}

/// The length of a cable that its ends and rings take up at `state` [m].
template <int D>
double taken_up(const BasicCableOfSystem<double, D>& cable,
                const BasicSystemState<double, D>& state) {
  std::vector<BasicVector<double, D>> points;
  for (std::size_t i = 0; i <= cable.segments(); ++i) {
    const auto& end = cable.end(i);
    if (end.body) {
      points.push_back(placed(state.bodies[*end.body], end.at));
    } else {
      points.push_back(end.at + end.motion.at(state.time));
    }
  }
  double length = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    length += (points[i] - points[i - 1]).norm();
  }
  return length;
}

/// The acceleration of the spin, from the numbers of an arc, their rates and those of the rates.
template <class Numbers>
Eigen::Matrix<double, 1, 1> spin_rate(const State& /*plane*/, const Numbers& /*rate*/,
                                      const Numbers& second) {
  return Eigen::Matrix<double, 1, 1>(second[2]);
}
template <class Numbers>
Eigen::Vector3d spin_rate(const SpatialState& /*space*/, const Numbers& rate,
                          const Numbers& /*second*/) {
  return rate.template tail<3>();
}

/// Mass times acceleration, less all forces but those of cables, `dt` after the start of `arc`.
template <int D>
Eigen::VectorXd pull_along(const BasicSystem<double, D>& system,
                           const BasicArc<BasicSystem<double, D>>& arc, double dt) {
  constexpr int numbers = Turning<double, D>::pose_numbers;
  Eigen::VectorXd rate = Eigen::VectorXd::Zero(arc.series.cols());
  Eigen::VectorXd second = rate;
  for (Eigen::Index k = arc.series.rows() - 1; k >= 1; --k) {
    const auto row = arc.series.row(k).transpose();
    rate = dt * rate + static_cast<double>(k) * row;
    second = k < 2 ? second : Eigen::VectorXd(dt * second + static_cast<double>(k * (k - 1)) * row);
  }
  const auto state = arc.after(dt, system.gravity);
  Eigen::VectorXd result = no_change(state);
  for (std::size_t i = 0; i < system.bodies.size(); ++i) {
    const auto& body = system.bodies[i];
    const auto& now = state.bodies[i];
    const Eigen::Index first = static_cast<Eigen::Index>(i) * freedoms_of_body<D>;
    const Eigen::Index column = static_cast<Eigen::Index>(i) * numbers;
    const Eigen::Matrix<double, numbers, 1> rates = rate.segment<numbers>(column);
    const Eigen::Matrix<double, numbers, 1> seconds = second.segment<numbers>(column);
    result.segment<D>(first) =
        body.mass * (seconds.template head<D>() - system.gravity.at(state.time)) -
        body.force.at(state.time) + body.drag * now.velocity;
    if (has_inertia(body.inertia)) {
      result.segment<spins<D>>(first + D) =
          moments(body.inertia).cwiseProduct(spin_rate(now, rates, seconds)) -
          gyroscopic(body.inertia, now) - in_the_body(now, body.moment.at(state.time)) +
          body.spin_drag * spin_of(now);
    }
  }
  return result;
}

/// What is looked for on the arcs of motions, between all that the solver looks at.
template <int D>
class DenseScan {
 public:
  using System = BasicSystem<double, D>;

  explicit DenseScan(const System& system) : system_(system) {}

  /// Looks at `arc` on a grid, and where a cable comes nearest to its length between its points.
  void look_at(const BasicArc<System>& arc) {
    const double duration = arc.end - arc.start;
    const int count = 12 + static_cast<int>(400.0 * duration);
    for (std::size_t index = 0; index < system_.cables.size(); ++index) {
      std::array<double, 3> last{};
      for (int k = 0; k <= count; ++k) {
        last = {last[1], last[2], overstretch(arc, index, duration * k / count)};
        if (k > 1 && last[1] > last[0] && last[1] > last[2] && last[1] > -1e-3) {
          look_between(arc, index, duration * (k - 2) / count, duration * k / count);
        }
      }
    }
    for (int k = 0; arc.series.rows() > 2 && k <= count; ++k) {
      look_at_pulls(arc, duration * k / count);
    }
  }

  double most = -1.0;   // [-], overstretch in parts of a length; of taut cables either way
  double push = 0.0;    // [-], the most negative tension in parts of the largest force
  double amiss = 0.0;   // [-], the same of forces that are neither given nor a cable's
  double astray = 0.0;  // [-], how far an elastic cable is out of its zone, in parts of its length
  long long looks = 0;  // at a cable

 private:
  double overstretch(const BasicArc<System>& arc, std::size_t index, double dt) {
    const auto& cable = system_.cables[index];
    if (!cable.acts_at(arc.start)) {
      return -1.0;
    }
    const auto state = arc.after(dt, system_.gravity);
    const double length = cable.length.at(state.time)[0];
    const double over = taken_up(cable, state) / length - 1.0;
    ++looks;
    if (cable.elasticity) {
      look_at_zone(arc, index, state, over);
      return -1.0;
    }
    most = std::max(most, arc.taut.contains(index) ? std::abs(over) : over);
    return over;
  }

  /// The tension of an elastic cable that is stretched by `over` of its length, if it pulls.
  double tension(const BasicArc<System>& arc, std::size_t index, BasicSystemState<double, D> state,
                 double over) const {
    state.time = std::nextafter(state.time, arc.start);  // before a knot that ends the arc
    const auto& cable = system_.cables[index];
    const auto& law = *cable.elasticity;
    const double length = cable.length.at(state.time)[0];
    const double stretch = over * length;
    std::size_t past = 0;
    while (past < law.corners.size() &&
           law.corners[past].stretch < (law.of_strain ? over : stretch)) {
      ++past;
    }
    const double damper = arc.initial.elastic.damping[index] * gap_rate(cable, state);
    return arc.initial.elastic.resisting.contains(index)
               ? -damper
               : force_by_lines(law, stretch, length, past) - damper;
  }

  void look_at_zone(const BasicArc<System>& arc, std::size_t index,
                    const BasicSystemState<double, D>& state, double over) {
    const CableSet engaged = arc.initial.elastic.engaged;
    const CableSet loose = arc.initial.elastic.loose;
    if (!engaged.contains(index) && !loose.contains(index)) {
      astray = std::max(astray, over);
      return;
    }
    const auto& cable = system_.cables[index];
    if (cable.elasticity->cut != ElasticCut::force) {
      astray = std::max(astray, -over);
      return;
    }
    const double first = cable.elasticity->stiffness[0];  // [N/m], or [N]
    const double pull =
        tension(arc, index, state, over) /
        (cable.elasticity->of_strain ? first : first * cable.length.at(state.time)[0]);
    astray = std::max(astray, engaged.contains(index) ? -pull : std::max(pull, -over));
  }

  void look_at_pulls(const BasicArc<System>& arc, double dt) {
    Eigen::VectorXd pull = pull_along(system_, arc, dt);
    const auto state = arc.after(dt, system_.gravity);
    for (const std::size_t index : arc.initial.elastic.pulling()) {
      const auto& cable = system_.cables[index];
      const double over = taken_up(cable, state) / cable.length.at(state.time)[0] - 1.0;
      force_ = std::max(force_, pull.cwiseAbs().maxCoeff());
      pull -= tension(arc, index, state, over) * gap_gradient(cable, state);
    }
    Eigen::MatrixXd rows(pull.size(), static_cast<Eigen::Index>(arc.taut.size()));
    Eigen::Index column = 0;
    for (const std::size_t index : arc.taut) {
      rows.col(column++) = gap_gradient(system_.cables[index], state).transpose();
    }
    for (const auto& body : system_.bodies) {
      force_ = std::max(force_, body.mass * system_.gravity.at(state.time).norm());
    }
    force_ = std::max(force_, pull.cwiseAbs().maxCoeff());
    if (rows.cols() == 0) {
      amiss = std::max(amiss, pull.cwiseAbs().maxCoeff() / force_);
      return;
    }
    const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> solver(rows);
    const Eigen::VectorXd tensions = solver.solve(pull);
    amiss = std::max(amiss, (rows * tensions - pull).cwiseAbs().maxCoeff() / force_);
    if (solver.rank() == rows.cols()) {  // else there are many splits of the pull
      push = std::max(push, -tensions.minCoeff() / force_);
    }
  }

  void look_between(const BasicArc<System>& arc, std::size_t index, double low, double high) {
    for (int third = 0; third < 40; ++third) {
      const double a = low + (high - low) / 3.0;
      const double b = high - (high - low) / 3.0;
      if (overstretch(arc, index, a) < overstretch(arc, index, b)) {
        low = a;
      } else {
        high = b;
      }
    }
  }

  const System& system_;
  double force_ = 0.0;  // [N], the largest so far
};

/// Scans the motions of `count` random systems that `draw` gives.
template <int D, class Draw>
void scan_random_systems(std::uint64_t seed, int count, const Draw& draw) {
  Random random(seed);
  double most = -1.0;
  double push = 0.0;
  double amiss = 0.0;
  double astray = 0.0;
  long long looks = 0;
  int solved = 0;
  while (solved < count) {
    const BasicSystem<double, D> system = draw(random);
    if (!problems(system).empty()) {
      continue;
    }
    SolveOptions options;
    options.max_events = 500;
    const auto solution = solve(system, options);
    DenseScan<D> scan(system);
    for (const auto& arc : solution.arcs()) {
      scan.look_at(arc);
    }
    EXPECT_LE(scan.most, 1e-12) << "system " << solved;
    EXPECT_LE(scan.push, 1e-12) << "system " << solved;
    EXPECT_LE(scan.amiss, 1e-7) << "system " << solved;
    EXPECT_LE(scan.astray, 1e-12) << "system " << solved;
    astray = std::max(astray, scan.astray);
    most = std::max(most, scan.most);
    push = std::max(push, scan.push);
    amiss = std::max(amiss, scan.amiss);
    looks += scan.looks;
    ++solved;
  }
  std::printf("  %lld lengths\n", looks);
  expect_within("overstretch [-]", most, 1e-12);
  expect_within("tension below zero [-]", push, 1e-12);
  expect_within("elastic cable out of its zone [-]", astray, 1e-12);
  // poses are right to rounding: their second derivatives at the end of a short series are less so
  expect_within("force of nothing [-]", amiss, 1e-7);
}

TEST(RandomSystems, SkipNoImpactAndNeverPush) {
  scan_random_systems<2>(3902, scanned, random_system);
}

TEST(RandomSystems, SkipNoImpactAndNeverPushInSpace) {
  scan_random_systems<3>(4002, scanned, random_spatial_system);
}

/// `system` with elastic cables in the place of some.
template <int D>
BasicSystem<double, D> with_elastic_cables(Random& random, BasicSystem<double, D> system) {
  for (auto& cable : system.cables) {
    if (random.chance(0.3)) {
      continue;
    }
    const double stiffness = system.bodies[*cable.from.body].mass * random.log_uniform(10.0, 1e4);
    Elasticity law;
    law.stiffness = {stiffness};
    const double ratio = random.chance(0.2) ? 0.0 : random.log_uniform(0.01, 2.0);
    if (random.chance(0.5)) {
      law.damping_ratio = ratio;
    } else {
      law.damping = ratio * std::sqrt(stiffness * system.bodies[*cable.from.body].mass);
    }
    if (random.chance(0.2)) {
      law.stiffness.push_back(stiffness * random.uniform(0.0, 5.0));
      law.stiffness.push_back(stiffness * random.uniform(0.0, 5.0));
    } else if (random.chance(0.3)) {
      const double first = random.log_uniform(1e-3, 0.3);
      const double harder = random.log_uniform(0.2, 20.0);
      const double further = random.uniform(1.1, 3.0);
      const double last = random.log_uniform(0.2, 20.0);
      law.corners = {{first, stiffness * harder}, {first * further, stiffness * last}};
    }
    law.of_strain = random.chance(0.3);  // the same numbers over lengths of about 1 m
    if (random.chance(0.2)) {
      law.cut = random.chance(0.5) ? ElasticCut::stretch : ElasticCut::never;
    }
    cable.restitution = 1.0;
    cable.elasticity = law;
    if (random.chance(0.2)) {  // stretched from the start
      const double span = cable.length.at(0.0)[0] - gap(cable, system.initial);
      cable.length = Function<1>::constant(span * random.uniform(0.9, 1.0));
    }
  }
  return system;
}

/// Random systems on elastic cables, and on some of both kinds.
System elastic_in_the_plane(Random& random) {
  const System system = random_system(random);
  return with_elastic_cables(random, system);
}
SpatialSystem elastic_in_the_space(Random& random) {
  const SpatialSystem system = random_spatial_system(random);
  return with_elastic_cables(random, system);
}

constexpr std::uint64_t elastic_seed = 4102;  // the same systems keep their energy and are scanned

/// Measures `count` systems that `draw` gives.
template <class Draw>
void measure_random_systems(int count, const Draw& draw, Tally& tally) {
  Random random(elastic_seed);
  const int all = tally.solved + count;
  while (tally.solved < all) {
    const auto system = draw(random);
    if (problems(system).empty()) {
      SCOPED_TRACE("system " + std::to_string(tally.solved));
      measure(system, tally);
    }
  }
}

TEST(RandomSystems, OnElasticCablesKeepTheirEnergy) {
  Tally tally;
  measure_random_systems(elastic_in_plane, elastic_in_the_plane, tally);
  measure_random_systems(elastic_in_space, elastic_in_the_space, tally);
  report(tally);
}

TEST(RandomSystems, OnElasticCablesMissNoSwitch) {
  scan_random_systems<2>(elastic_seed, elastic_in_plane, elastic_in_the_plane);
}

TEST(RandomSystems, OnElasticCablesMissNoSwitchInSpace) {
  scan_random_systems<3>(elastic_seed, elastic_in_space, elastic_in_the_space);
}

TEST(DenseScan, SeesAnArcThatGoesOnPastItsImpact) {
  const System system = shaken<double>();
  const auto solution = solve(system);
  BasicArc<System> arc = solution.arcs().front();
  DenseScan<2> scan(system);
  scan.look_at(arc);
  EXPECT_LE(scan.most, 1e-12);
  arc.end += 1e-11;
  scan.look_at(arc);
  EXPECT_GT(scan.most, 1e-12);
}

}  // namespace
}  // namespace tautline::test
