#include "engines/cables/worlds/random_world.hpp"

#include <algorithm>
#include <array>

#include "engines/cables/draw.hpp"

namespace tautline::test {
namespace {

constexpr std::size_t most_cables = 8;  // but for chains

/// A world in the making, and what its draws have in common.
class Maker {
 public:
  explicit Maker(std::uint64_t seed) : draw(seed) {
    world.seed = seed;
    planar = draw.chance(0.3);
    taut = draw.chance(0.3);
    base_mass = draw.scale(0.5, 10.0);
    mass_ratio = draw.scale(1.0, 100.0);
    if (draw.chance(0.5)) {
      shared_restitution = draw.between(0.0, 1.0);
    }
    world.has_ground = draw.chance(0.5);
  }

  /// Masses of `count` loads: two of them are at the world's ratio.
  std::vector<double> masses(int count) {
    std::vector<double> result(static_cast<std::size_t>(count), base_mass);
    for (double& mass : result) {
      mass *= std::pow(mass_ratio, draw.between(0.0, 1.0));
    }
    if (count > 1) {
      const int light = draw.whole(0, count - 1);
      const int heavy = (light + draw.whole(1, count - 1)) % count;
      result[static_cast<std::size_t>(light)] = base_mass;
      result[static_cast<std::size_t>(heavy)] = base_mass * mass_ratio;
    }
    return result;
  }

  /// Adds a load at about `position`; it may be a box where there is ground to hit.
  int add_load(double mass, const Vec3& position) {
    // boxes that begin inside each other would be thrown apart
    const auto is_near = [&position](const Load& other) {
      return (other.position - position).norm() < 2.0 * box_side;
    };
    const bool is_box = world.has_ground && draw.chance(0.3) &&
                        std::none_of(world.loads.begin(), world.loads.end(), is_near);
    const Vec3 velocity = draw.within(draw.chance(0.2) ? 0.0 : 4.0, planar);
    Vec3 spin = draw.within(draw.chance(0.4) ? 0.0 : 5.0, false);
    if (planar) {
      spin = Vec3(0.0, 0.0, spin.z());
    }
    world.loads.push_back({mass, draw.between(0.1, 0.3), position, velocity, spin, is_box});
    return world.load_count() - 1;
  }

  /// A place on a load for a cable: off its centre, in most.
  CableEnd end_on(int load) {
    const bool is_box = world.loads[static_cast<std::size_t>(load)].is_box;
    const double radius = is_box ? 0.5 * box_side : 0.3;
    return {load, draw.within(draw.chance(0.2) ? 0.0 : radius, planar)};
  }

  CableEnd above(const Vec3& position, double height) {
    return {-1, position + draw.within(0.8, planar) + height * Vec3::UnitY()};
  }

  void add_cable(const CableEnd& first, const CableEnd& second) {
    const double slack = taut ? 0.0 : draw.between(0.0, 0.6);
    tie(world, first, second, slack,
        shared_restitution < 0.0 ? draw.between(0.0, 1.0) : shared_restitution);
  }

  /// A cable from a load to a place that is `height` above `position`.
  void hang_from(int load, const Vec3& position, double height) {
    const CableEnd holder = above(position, height);
    const CableEnd end = end_on(load);
    add_cable(end, holder);
  }

  /// A cable from one load to another.
  void join(int load, int other) {
    const CableEnd second = end_on(other);
    const CableEnd first = end_on(load);
    add_cable(first, second);
  }

  /// A hook that goes to and fro, no faster than 2 m/s.
  CableEnd add_hook(const Vec3& at) {
    const double pace = draw.between(0.5, 4.0);
    const Vec3 sway = draw.within(std::min(1.0, 2.0 / pace), planar);
    world.hooks.push_back({at, sway, pace, draw.between(0.0, 6.0)});
    return {world.hook(static_cast<int>(world.hooks.size()) - 1), Vec3::Zero()};
  }

  /// Loads below each other, the first on `holder`.
  void hang(const CableEnd& holder, int count, double shortest, double longest, bool straight) {
    CableEnd from = holder;
    Vec3 at = place(world, holder);
    const std::vector<double> of_each = masses(count);
    const Vec3 aside = straight ? Vec3::Zero() : draw.within(1.0, planar);
    for (const double mass : of_each) {
      const Vec3 down = (aside - Vec3::UnitY()).normalized();
      const Vec3 step = straight ? down : (down + draw.within(0.4, planar)).normalized();
      at += draw.between(shortest, longest) * step;
      const int load = add_load(mass, at);
      add_cable(end_on(load), from);
      from = end_on(load);
    }
  }

  Draw draw;
  World world;
  bool planar;
  bool taut;
  double base_mass;                  // [kg]
  double mass_ratio;                 // [-]
  double shared_restitution = -1.0;  // negative: each cable has its own [-]
};

const Vec3 middle(0.0, 4.0, 0.0);  // [m]

/// One load on one cable, or on several.
void one_load(Maker& make, int cables) {
  const int load = make.add_load(make.base_mass, middle);
  for (int index = 0; index < cables; ++index) {
    const double height = make.draw.between(0.8, 3.0);
    make.hang_from(load, middle, height);
  }
}

void series(Maker& make) {
  const bool straight = make.draw.chance(0.3);
  const int loads = make.draw.whole(2, 3);
  make.hang({-1, Vec3(0.0, 7.0, 0.0)}, loads, 0.5, 2.0, straight);
  // a second cable beside the first, now and then
  if (make.draw.chance(0.3)) {
    make.hang_from(0, middle, 3.0);
  }
}

void chain(Maker& make) {
  const int loads = make.draw.whole(4, 10);
  const bool straight = make.draw.chance(0.3);
  make.hang({-1, Vec3(0.0, 7.0, 0.0)}, loads, 0.2, 0.6, straight);
  if (make.draw.chance(0.2)) {
    make.hang_from(loads - 1, make.world.loads.back().position, 1.0);
  }
}

/// Lengthens the cables of a load on several hooks where these go farther apart than two of them
/// reach: no cable could keep its length there.
void give_room(World& world) {
  constexpr int steps = 3600;
  constexpr double step = 1.0 / 60.0;  // [s]
  for (std::size_t one = 1; one < world.hooks.size(); ++one) {
    for (std::size_t other = 0; other < one; ++other) {
      double farthest = 0.0;
      for (int index = 0; index < steps; ++index) {
        const double time = index * step;
        farthest =
            std::max(farthest, (world.hooks[one].at(time) - world.hooks[other].at(time)).norm());
      }
      double& longer = world.cables[one].length;
      longer = std::max(longer, farthest - world.cables[other].length);
    }
  }
}

/// One to three loads below each other on a hook, or one on several hooks.
void moving_hooks(Maker& make) {
  // the scene numbers hooks after loads: their number is settled first
  const int loads = make.draw.whole(1, 3);
  const int hooks = loads == 1 ? make.draw.whole(1, 4) : 1;
  const std::vector<double> of_each = make.masses(loads);
  Vec3 at = middle;
  for (const double mass : of_each) {
    make.add_load(mass, at);
    const Vec3 aside = make.draw.within(0.3, make.planar);
    const double drop = make.draw.between(0.5, 1.5);
    at -= Vec3(0.0, drop, 0.0) + aside;
  }
  for (int index = 0; index < hooks; ++index) {
    const Vec3 aside = make.draw.within(0.8, make.planar);
    const double height = make.draw.between(0.8, 2.5);
    const CableEnd hook = make.add_hook(middle + height * Vec3::UnitY() + aside);
    const CableEnd end = make.end_on(0);
    make.add_cable(end, hook);
  }
  give_room(make.world);
  for (int load = 1; load < loads; ++load) {
    make.join(load, load - 1);
  }
}

/// A box on four cables, with boxes that fall on it and a load below it.
void platform(Maker& make) {
  make.world.has_ground = true;
  const bool moves = make.draw.chance(0.5);
  const double half = 0.5 * box_side;
  const Vec3 velocity = make.draw.within(1.0, make.planar);
  const double heavy = make.base_mass * make.mass_ratio;
  make.world.loads.push_back({heavy, 0.0, middle, velocity, Vec3::Zero(), true});
  for (int cargo = make.draw.whole(0, 2); cargo > 0; --cargo) {
    const Vec3 above_it = middle + (0.05 + 1.1 * cargo * box_side) * Vec3::UnitY();
    make.world.loads.push_back({make.base_mass, 0.0, above_it, velocity, Vec3::Zero(), true});
  }
  const bool below = make.draw.chance(0.5);
  const int lower =
      below ? make.add_load(make.base_mass, middle - make.draw.between(0.5, 1.5) * Vec3::UnitY())
            : 0;
  const double height = make.draw.between(0.6, 2.0);
  const Vec3 sway = make.draw.within(0.5, make.planar);
  const double pace = make.draw.between(0.5, 3.0);
  const double phase = make.draw.between(0.0, 6.0);
  for (const double x : {-half, half}) {
    for (const double z : {-half, half}) {
      const Vec3 fixed_end = middle + Vec3(x, half + height, z);
      CableEnd holder{-1, fixed_end};
      if (moves) {
        make.world.hooks.push_back({fixed_end, sway, pace, phase});
        holder = {make.world.hook(static_cast<int>(make.world.hooks.size()) - 1), Vec3::Zero()};
      }
      make.add_cable({0, Vec3(x, half, z)}, holder);
    }
  }
  if (below) {
    make.add_cable(make.end_on(lower), {0, Vec3(0.0, -half, 0.0)});
  }
}

/// Boxes in a row on the ground, each tied to the next.
void tied_boxes(Maker& make) {
  make.world.has_ground = true;
  const std::vector<double> of_each = make.masses(make.draw.whole(2, 4));
  const double half = 0.5 * box_side;
  double x = 0.0;
  for (const double mass : of_each) {
    x += make.draw.between(0.4, 0.9);
    const double lift = make.draw.chance(0.5) ? 0.001 : make.draw.between(0.1, 1.0);
    const Vec3 velocity(make.draw.between(-4.0, 4.0), 0.0, 0.0);
    make.world.loads.push_back(
        {mass, 0.0, Vec3(x, half + lift, 0.0), velocity, Vec3::Zero(), true});
  }
  for (int box = 1; box < make.world.load_count(); ++box) {
    make.add_cable({box - 1, Vec3(half, 0.0, 0.0)}, {box, Vec3(-half, 0.0, 0.0)});
  }
  if (make.draw.chance(0.5)) {
    make.add_cable({0, Vec3(-half, 0.0, 0.0)}, {-1, Vec3(0.0, half, 0.0)});
  }
}

/// Loads that hang from the world and from each other.
void web(Maker& make) {
  const std::vector<double> of_each = make.masses(make.draw.whole(2, 5));
  for (const double mass : of_each) {
    make.add_load(mass, middle + make.draw.within(1.5, make.planar));
  }
  const int loads = make.world.load_count();
  for (int load = 0; load < loads; ++load) {
    if (load == 0 || make.draw.chance(0.5)) {
      const double height = make.draw.between(1.5, 3.0);
      make.hang_from(load, middle, height);
    } else {
      const int other = make.draw.whole(0, load - 1);
      make.join(load, other);
    }
  }
  const auto wanted =
      static_cast<std::size_t>(make.draw.whole(loads, static_cast<int>(most_cables)));
  while (make.world.cables.size() < wanted) {
    const int one = make.draw.whole(0, loads - 1);
    const int other = (one + make.draw.whole(1, loads - 1)) % loads;
    make.join(one, other);
  }
}

/// Loads that go round on taut cables, which nothing but their swing presses outwards: without
/// gravity, which is a table seen from above too, or falling together. Some are fast.
void whirl(Maker& make) {
  make.world.has_ground = false;
  make.taut = make.draw.chance(0.8);
  const bool anchored = make.draw.chance(0.4);
  const bool falls = !anchored && make.draw.chance(0.3);
  constexpr double gentle = 0.1;  // [m/s^2]: they fall for a minute, and floats see millimetres
  make.world.gravity = falls ? gentle : 0.0;
  const double pace = make.draw.scale(0.2, 20.0);  // [rad/s]
  const bool turning = make.draw.chance(0.5);      // with the swing, as a stone on a string
  const std::vector<double> of_each = make.masses(make.draw.whole(anchored ? 1 : 2, 3));
  std::vector<double> along;
  double reach = 0.0;
  double mass = 0.0;
  double moment = 0.0;
  for (const double one : of_each) {
    reach += make.draw.between(0.4, 1.5);
    along.push_back(reach);
    mass += one;
    moment += one * reach;
  }
  // about the anchor, or about their centre of mass
  const double centre = anchored ? 0.0 : moment / mass;
  for (std::size_t index = 0; index < of_each.size(); ++index) {
    const Vec3 out = (along[index] - centre) * Vec3::UnitX();
    make.world.loads.push_back({of_each[index], make.draw.between(0.1, 0.3), middle + out,
                                pace * Vec3::UnitZ().cross(out),
                                (turning ? pace : 0.0) * Vec3::UnitZ(), false});
  }
  CableEnd from = {-1, middle};
  for (int load = 0; load < make.world.load_count(); ++load) {
    const double arm = turning ? make.draw.between(0.0, 0.15) : 0.0;
    if (load > 0 || anchored) {
      make.add_cable({load, -arm * Vec3::UnitX()}, from);
    }
    from = {load, arm * Vec3::UnitX()};
  }
}

/// Boxes that lie and fall where no load gets.
void add_boxes(Maker& make) {
  const int levels = make.draw.whole(1, 3);
  for (int level = 0; level < levels; ++level) {
    make.world.boxes.emplace_back(50.0, 0.1 + 0.21 * level, 0.0);
    make.world.boxes.emplace_back(-50.0, 1.0 + level, 0.0);
  }
}

}  // namespace

World random_world(std::uint64_t seed) {
  Maker make(seed);
  constexpr std::array kinds = {"one", "several",  "series", "chain", "moving hooks",
                                "web", "platform", "series", "boxes", "several"};
  // one in twelve is a whirl; the others take turns
  constexpr std::uint64_t whirls = 12;
  make.world.kind = seed % whirls == whirls - 1 ? "whirl" : kinds[seed % kinds.size()];
  const std::string& kind = make.world.kind;
  if (kind == "one") {
    one_load(make, 1);
  } else if (kind == "several") {
    one_load(make, make.draw.whole(2, static_cast<int>(most_cables)));
  } else if (kind == "series") {
    series(make);
  } else if (kind == "chain") {
    chain(make);
  } else if (kind == "moving hooks") {
    moving_hooks(make);
  } else if (kind == "whirl") {
    whirl(make);
  } else if (kind == "web") {
    web(make);
  } else if (kind == "platform") {
    platform(make);
  } else {
    tied_boxes(make);
  }
  if (make.world.has_ground) {
    add_boxes(make);
  }
  make.world.may_sleep = make.world.hooks.empty() && make.draw.chance(0.125);
  return make.world;
}

}  // namespace tautline::test
