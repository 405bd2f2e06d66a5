#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "tautline/scenarios.hpp"

namespace tautline {
namespace {

using Point = BasicVector<double, 3>;
using One = Function<1>::Value;

constexpr double quarter = std::numbers::pi / 2.0;  // cos(x - quarter) = sin(x)

SpatialEnd body_end(std::size_t body, const Point& at = Point::Zero()) { return {body, at, {}}; }

SpatialEnd world_end(const Point& at) { return {std::nullopt, at, {}}; }

SpatialCable spatial_cable(SpatialEnd from, SpatialEnd to, double length, double restitution) {
  SpatialCable result;
  result.from = std::move(from);
  result.to = std::move(to);
  result.length = Function<1>::constant(length);
  result.restitution = restitution;
  return result;
}

SpatialSystem empty_space(const std::string& name, double gravity, double duration) {
  SpatialSystem result;
  result.name = name;
  result.gravity = Function<3>::constant(Point(0.0, 0.0, -gravity));
  result.duration = duration;
  return result;
}

void add_spatial_body(SpatialSystem& system, const std::string& name, double mass,
                      const Point& inertia, const SpatialState& start) {
  SpatialBody& body = system.bodies.emplace_back();
  body.name = name;
  body.mass = mass;
  body.inertia = inertia;
  system.initial.bodies.push_back(start);
}

SpatialState still_at(const Point& position) {
  SpatialState result;
  result.position = position;
  return result;
}

/// The orientation of a body turned by `angle` about a unit vector.
Quaternion turn(double angle, const Point& about) {
  Quaternion result;
  result << std::cos(angle / 2.0), std::sin(angle / 2.0) * about;
  return result;
}

/// The principal moments of a box of these sides.
Point box(double mass, double x, double y, double z) {
  return Point(y * y + z * z, x * x + z * z, x * x + y * y) * (mass / 12.0);
}

/// A body on equal cables around its axis, turned by `yaw` and let go, nondimensional.
SpatialSystem filar(const std::string& name, int cables, double anchors, double attachments,
                    double above, double yaw) {
  SpatialSystem result = empty_space(name, 1.0, 12.0);
  const double drop = 1.0 - anchors * anchors - attachments * attachments +
                      2.0 * anchors * attachments * std::cos(yaw);
  SpatialState start = still_at(Point(0.0, 0.0, -std::sqrt(drop) - above));
  start.orientation = turn(yaw, Point::UnitZ());
  add_spatial_body(result, "body", 1.0, Point(0.014, 0.01, 0.02), start);
  for (int i = 0; i < cables; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / cables;
    const Point around(std::cos(angle), std::sin(angle), 0.0);
    result.cables.push_back(
        spatial_cable(body_end(0, attachments * around + Point(0.0, 0.0, above)),
                      world_end(anchors * around), 1.0, 0.5));
  }
  return result;
}

SpatialSystem spherical_slack() {
  SpatialSystem result = empty_space("spherical-slack", 1.0, 12.0);
  SpatialState start = still_at(Point(0.8, 0.0, -0.6));
  start.velocity = Point(0.96, 0.3, 1.28);
  add_spatial_body(result, "ball", 1.0, Point::Zero(), start);
  result.cables = {spatial_cable(body_end(0), world_end(Point::Zero()), 1.0, 0.5)};
  return result;
}

/// The angle of its cable and the rate are the balance of the forces across the axis and of the
/// moments about the centre.
SpatialSystem conical() {
  constexpr double axis = 0.5;                       // [rad] from the vertical
  constexpr double of_cable = 0.478624255703534453;  // [rad] likewise
  constexpr double rate = 0.926550954845583893;      // [rad/s]
  constexpr double arm = 0.3;
  SpatialSystem result = empty_space("conical", 1.0, 20.0);
  const double radius = std::sin(of_cable) + arm * std::sin(axis);
  SpatialState start = still_at(Point(radius, 0.0, -std::cos(of_cable) - arm * std::cos(axis)));
  start.orientation = turn(-axis, Point::UnitY());
  start.velocity = Point(0.0, rate * radius, 0.0);
  start.spin = rate * Point(std::sin(axis), 0.0, std::cos(axis));
  add_spatial_body(result, "spindle", 1.0, Point(0.03, 0.03, 0.01), start);
  result.cables = {
      spatial_cable(body_end(0, Point(0.0, 0.0, arm)), world_end(Point::Zero()), 1.0, 0.5)};
  return result;
}

SpatialSystem tethered_ball() {
  SpatialSystem result = empty_space("tethered-ball", 1.0, 6.0);
  SpatialState start = still_at(Point(0.2, 0.0, -0.3));
  start.velocity = Point(0.5, 0.4, 0.6);
  start.spin = Point(3.0, -4.0, 12.0);
  add_spatial_body(result, "ball", 1.0, Point(0.004, 0.004, 0.004), start);
  result.cables = {
      spatial_cable(body_end(0, Point(0.1, 0.0, 0.0)), world_end(Point::Zero()), 1.0, 0.7)};
  return result;
}

SpatialSystem dzhanibekov() {
  SpatialSystem result = empty_space("dzhanibekov", 0.01, 40.0);
  SpatialState start = still_at(Point(0.0, 0.0, -0.4));
  start.velocity = Point(0.03, 0.01, 0.02);
  start.spin = Point(0.02, 6.0, 0.01);
  add_spatial_body(result, "box", 1.0, box(1.0, 0.3, 0.2, 0.08), start);
  result.cables = {
      spatial_cable(body_end(0, Point(0.15, 0.1, 0.04)), world_end(Point::Zero()), 1.0, 0.8)};
  return result;
}

/// The brick of check case 2 of NASA's comparison of flight simulations (TM-2015-218675): 5 lb, its
/// moments and its spins, 10, 20 and 30 degrees a second.
SpatialSystem tumbling_brick() {
  constexpr double degree = std::numbers::pi / 180.0;
  SpatialSystem result = empty_space("tumbling-brick", 9.81, 6.0);
  SpatialState start = still_at(Point(0.0, 0.0, -0.4));
  start.velocity = Point(0.4, 0.2, 3.0);
  start.spin = Point(10.0, 20.0, 30.0) * degree;
  add_spatial_body(result, "brick", 2.26796, Point(0.00256822, 0.00842101, 0.00975466), start);
  const Point corner(0.1016, 0.0508, 0.028575);
  result.cables = {spatial_cable(body_end(0, corner), world_end(Point::Zero()), 1.0, 0.8)};
  return result;
}

SpatialSystem crane_slings() {
  SpatialSystem result = empty_space("crane-slings", 9.81, 10.0);
  add_spatial_body(result, "load", 1000.0, box(1000.0, 2.0, 1.0, 0.5),
                   still_at(Point(0.0, 0.0, -1.55)));
  const double length = std::sqrt(3.5);
  for (const auto& [x, y] : {std::pair{1.0, 0.5}, {-1.0, 0.5}, {-1.0, -0.5}, {1.0, -0.5}}) {
    result.cables.push_back(spatial_cable(body_end(0, Point(x, y, 0.25)), world_end(Point::Zero()),
                                          result.cables.empty() ? length - 0.05 : length, 0.2));
  }
  return result;
}

/// The cables go from the top of a frame to the corners across, and are a little longer than the
/// platform at (0, 0, -1.4) needs.
SpatialSystem parallel_robot() {
  SpatialSystem result = empty_space("parallel-robot", 9.81, 5.0);
  SpatialState start = still_at(Point(0.003, -0.002, -1.38));
  start.orientation = turn(0.02, Point(0.6, 0.8, 0.0));
  add_spatial_body(result, "platform", 20.0, box(20.0, 0.5, 0.4, 0.3), start);
  constexpr std::array<double, 8> longer{0.0, 0.004, 0.001, 0.006, 0.003, 0.002, 0.005, 0.0015};
  for (const auto& [x, y] : {std::pair{1.0, 1.0}, {1.0, -1.0}, {-1.0, 1.0}, {-1.0, -1.0}}) {
    for (const double sign : {1.0, -1.0}) {
      const Point at(0.25 * x * sign, -0.2 * y * sign, 0.15 * sign);
      const Point anchor(2.0 * x, 1.5 * y, sign > 0.0 ? 0.0 : -0.1);
      const double length = (Point(0.0, 0.0, -1.4) + at - anchor).norm();
      result.cables.push_back(spatial_cable(body_end(0, at), world_end(anchor),
                                            length + longer[result.cables.size()], 0.3));
    }
  }
  return result;
}

/// Nondimensional: the hook is a point mass.
SpatialSystem hoisted_load() {
  SpatialSystem result = empty_space("hoisted-load", 1.0, 8.0);
  SpatialState load = still_at(Point(0.05, 0.02, -1.35));
  load.velocity = Point(0.1, -0.2, 0.1);
  load.spin = Point(0.4, -0.3, 1.0);
  add_spatial_body(result, "load", 2.0, Point(0.08, 0.1, 0.12), load);
  SpatialState hook = still_at(Point(0.1, 0.0, -0.85));
  hook.velocity = Point(0.0, 0.1, 0.0);
  add_spatial_body(result, "hook", 0.3, Point::Zero(), hook);
  for (const auto& [x, y] : {std::pair{-0.3, -0.2}, {0.3, -0.2}, {-0.3, 0.2}, {0.3, 0.2}}) {
    const double length = result.cables.size() < 3 ? 0.7 : 0.68;
    result.cables.push_back(spatial_cable(body_end(0, Point(x, y, 0.1)), body_end(1), length, 0.8));
  }
  SpatialEnd trolley = world_end(Point::Zero());
  trolley.motion.waves = {{Point(0.15, 0.0, 0.0), 1.5, -0.5}, {Point(0.0, 0.1, 0.02), 2.2, 0.3}};
  result.cables.push_back(spatial_cable(body_end(1), trolley, 1.0, 0.8));
  result.cables.back().length = Function<1>::linear({0.5, 1.5}, {One(1.0), One(0.7)});
  return result;
}

/// The force is buoyancy, 11 kN, and two waves.
SpatialSystem moored_buoy() {
  SpatialSystem result = empty_space("moored-buoy", 9.81, 60.0);
  add_spatial_body(result, "buoy", 800.0, Point(200.0, 200.0, 200.0), still_at(Point::Zero()));
  SpatialBody& buoy = result.bodies.front();
  buoy.drag = 400.0;
  buoy.spin_drag = 100.0;
  buoy.force = Function<3>::constant(Point(0.0, 0.0, 11e3));
  buoy.force.waves = {{Point(1500.0, 0.0, 0.0), 0.8, 0.0},
                      {Point(0.0, 400.0, 3500.0), 0.8, quarter}};
  for (const auto& [x, y] : {std::pair{1.0, 1.0}, {-1.0, 1.0}, {-1.0, -1.0}, {1.0, -1.0}}) {
    const Point at(0.4 * x, 0.4 * y, 0.0);
    const Point anchor(6.0 * x, 6.0 * y, -8.0);
    result.cables.push_back(
        spatial_cable(body_end(0, at), world_end(anchor), (at - anchor).norm() + 0.2, 0.0));
  }
  return result;
}

/// Its ropes are elastic, with the damping ratio of this restitution.
SpatialSystem elastic_hoist() {
  constexpr double stiffness = 5e4;  // [N/m]
  constexpr double restitution = 0.5;
  SpatialSystem result = empty_space("hoist-elastic", 9.81, 4.0);
  SpatialState start = still_at(Point(0.05, 0.02, -2.2));
  start.spin = Point(0.0, 0.0, 0.2);
  add_spatial_body(result, "box", 100.0, box(100.0, 1.2, 0.8, 0.5), start);
  for (const double side : {-0.5, 0.5}) {
    SpatialCable rope = spatial_cable(body_end(0, Point(side, 0.0, 0.25)),
                                      world_end(Point(side, 0.0, 0.0)), 2.0, 1.0);
    rope.length = Function<1>::linear({0.2, 1.2}, {One(2.0), One(1.5)});
    rope.elasticity.emplace().stiffness = {stiffness};
    rope.elasticity->damping_ratio = damping_ratio_of(restitution);
    result.cables.push_back(std::move(rope));
  }
  return result;
}

/// The standard breakwater in the plane of x = (0.8, -0.6, 0) and y = (0.36, 0.48, 0.8), which is
/// up.
SpatialSystem breakwater_in_a_tilted_plane() {
  const System planar = as_system(breakwater(table_5_1().front().parameters, ""));
  Eigen::Matrix3d axes;
  axes << 0.8, 0.36, -0.48, -0.6, 0.48, -0.64, 0.0, 0.8, 0.6;
  const auto place = [&](const Vec2& v) { return Point(axes.leftCols<2>() * v); };
  SpatialSystem result = empty_space("breakwater-in-a-tilted-plane", 1.0, 8.0);
  result.gravity = Function<3>::constant(place(planar.gravity.at(0.0)));
  const Eigen::Quaterniond q(axes);
  const State& start = planar.initial.bodies.front();
  SpatialState body = still_at(place(start.position));
  body.orientation = Quaternion(q.w(), q.x(), q.y(), q.z()).normalized();
  body.velocity = place(start.velocity);
  const double inertia = planar.bodies.front().inertia;
  add_spatial_body(result, "breakwater", 1.0, Point(0.6, 0.7, 1.0) * inertia, body);
  for (const CableOfSystem& one : planar.cables) {
    const Point at(one.from.at.x(), one.from.at.y(), 0.0);
    result.cables.push_back(spatial_cable(body_end(0, at), world_end(place(one.to.at)),
                                          one.length.at(0.0)[0], one.restitution));
  }
  return result;
}

}  // namespace

std::vector<ShippedSpatialSystem> shipped_spatial_systems() {
  return {
      {filar("bifilar", 2, 0.25, 0.25, 0.1, 0.6),
       "A body hangs on two parallel cables, turned by 0.6 rad and let go. It turns to and fro in "
       "3.67951, and rises as it turns: the way to measure a moment of inertia."},
      {filar("trifilar", 3, 0.3, 0.2, 0.05, 0.8),
       "A body on three cables that lean in, turned by 0.8 rad and let go. It comes back after "
       "3.83636, 6 % later than small turns do, and stays on all three."},
      {spherical_slack(),
       "A ball swings up on its cable out of any plane. The cable goes slack at 1.01699, where "
       "gravity alone bends the way, and catches the ball at 3.25421."},
      {conical(),
       "A spindle on one cable goes round steadily, its axis at 0.5 rad and its cable at 0.478624 "
       "rad from the vertical. Without the gyroscopic moment it would not stay so."},
      {tethered_ball(),
       "A spinning ball is thrown on a tether at its surface. Each snap changes its spin; they die "
       "out at 3.34612, and the spin soon slackens the tether again."},
      {dzhanibekov(),
       "A box spins about its middle axis and turns over every 4.62217, until its tether snaps at "
       "10.9315. An engine without the gyroscopic moment does not turn it over."},
      {tumbling_brick(),
       "The tumbling brick of NASA's second check case, thrown up on a tether at its corner. It "
       "flies free between snaps, and each of them gives it another spin."},
      {crane_slings(),
       "A box of 1000 kg falls level into four slings, one of them 5 cm short. The short one and "
       "the one across snap in turn; from 7.363 s on the box rocks on these two."},
      {parallel_robot(),
       "A platform on eight cables of slightly unequal lengths falls by 2 cm. After thousands of "
       "snaps within 2.16 s it rests on six of them, which its weight makes taut."},
      {hoisted_load(),
       "A load on four slings of a hook, one of them short, below a trolley that moves to and fro. "
       "The hoist draws the hook in from 0.5 to 1.5, and hook and load snap against each other."},
      {moored_buoy(),
       "A buoy on four mooring lines under the surface, with drag, in waves from the side. In each "
       "trough lines go slack, and they snap when the wave lifts it again."},
      {elastic_hoist(),
       "A box of 100 kg falls by 5 cm into two elastic ropes, which a hoist draws in by 0.5 m from "
       "0.2 s to 1.2 s. One rope pulls with up to 1668.97 N; when the hoist stops, the box flies."},
      {breakwater_in_a_tilted_plane(),
       "The standard breakwater in a tilted plane of space, gravity in it. It stays in its plane "
       "and moves as in two dimensions, which is a test of every rotation in a solver."}};
}

}  // namespace tautline
