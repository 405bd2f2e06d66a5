#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "sentences.hpp"
#include "system/elastic_problems.hpp"
#include "system/least_value.hpp"
#include "tautline/geometry.hpp"
#include "tautline/system.hpp"
#include "tautline/system_geometry.hpp"
#include "words.hpp"

namespace tautline {
namespace {

/// A shorter segment of a cable that runs through a ring, or that resists while it is slack, has no
/// direction: as a share of the cable [-].
constexpr double shortest_segment = 1e-6;

/// The place of `end` in the world at the start [m].
template <int D>
BasicVector<double, D> end_place(const BasicEnd<double, D>& end,
                                 const BasicSystem<double, D>& system) {
  if (!end.body) {
    return end.at + end.motion.at(0.0);
  }
  const auto& state = system.initial.bodies[*end.body];
  return state.position + in_the_world(state, end.at);
}

/// The largest number that its place is computed from [m].
template <int D>
double end_operand(const BasicEnd<double, D>& end, const BasicSystem<double, D>& system) {
  const double at = end.at.norm();
  return end.body ? std::max(at, system.initial.bodies[*end.body].position.norm())
                  : std::max(at, end.motion.at(0.0).norm());
}

/// "end 0", "ring 1" in the sentences on a segment.
template <int D>
std::string end_name(const BasicCableOfSystem<double, D>& cable, std::size_t index) {
  return index == 0                      ? "end \"from\""
         : index <= cable.through.size() ? "ring " + std::to_string(index - 1)
                                         : "end \"to\"";
}

/// The key of an end in a file.
template <int D>
std::string end_key(const BasicCableOfSystem<double, D>& cable, std::size_t index) {
  return index == 0                      ? "from"
         : index <= cable.through.size() ? "through[" + std::to_string(index - 1) + "]"
                                         : "to";
}

/// By which a file tells a body from the others.
template <int D>
std::string told_name(const BasicSystem<double, D>& system, std::size_t index) {
  const std::string& name = system.bodies[index].name;
  return name.empty() ? body_name(index) : name;
}

/// The mass and the inertia of the body that `owner` names.
void check_inertia(Sentences& wrong, const std::string& owner, const BodyOfSystem& body,
                   bool is_point) {
  wrong.body(owner, body, is_point);
}
void check_inertia(Sentences& wrong, const std::string& owner, const SpatialBody& body,
                   bool is_point) {
  wrong.spatial_body(owner, body.mass, {body.inertia.x(), body.inertia.y(), body.inertia.z()},
                     is_point);
}

/// Collects the sentences.
template <int D>
class SystemChecker {
 public:
  using System = BasicSystem<double, D>;
  using BodyOfSystem = BasicBodyOfSystem<double, D>;
  using CableOfSystem = BasicCableOfSystem<double, D>;
  using End = BasicEnd<double, D>;

  explicit SystemChecker(const System& system) : system_(system) {}

  std::vector<std::string> run() {
    check_bodies();
    check_cables();
    check_function("gravity", system_.gravity, "[m/s^2]");
    wrong_.positive({"duration"}, system_.duration, "[s]");
    if (wrong_.none()) {  // the rest needs sound numbers
      check_jumps();
      check_lengths();
    }
    if (wrong_.none()) {
      check_reach();
    }
    if (wrong_.none()) {
      check_start();
    }
    for (std::size_t index = 0; wrong_.none() && index < system_.cables.size(); ++index) {
      if (system_.cables[index].elasticity) {
        check_frequency(wrong_, system_, index);
        check_turn(wrong_, system_, index);
      }
    }
    return std::move(wrong_).found();
  }

 private:
  [[nodiscard]] std::size_t count() const { return system_.bodies.size(); }

  void check_bodies() {
    if (count() < 1 || count() > max_bodies) {
      wrong_.add("bodies: " + std::to_string(count()) + " given; a system has 1 to " +
                 std::to_string(max_bodies));
    }
    for (std::size_t index = 0; index < count(); ++index) {
      check_body(index);
      for (std::size_t other = 0; other < index; ++other) {
        if (told_name(system_, index) == told_name(system_, other)) {
          wrong_.add(body_name(index) + ": has the name of " + body_name(other) +
                     "; each body must have a name of its own");
        }
      }
    }
    if (system_.initial.time != 0.0) {
      wrong_.add("initial: time " + text(system_.initial.time) + " must be 0 [s]");
    }
    if (system_.initial.bodies.size() != count()) {
      wrong_.add("initial: " + std::to_string(system_.initial.bodies.size()) +
                 " states given; must be " + std::to_string(count()) + ", one for each body");
      return;
    }
    for (std::size_t index = 0; index < count(); ++index) {
      wrong_.start(body_name(index) + ": ", system_.initial.bodies[index]);
    }
  }

  void check_body(std::size_t index) {
    const BodyOfSystem& body = system_.bodies[index];
    const std::string owner = body_name(index) + ": ";
    check_inertia(wrong_, owner, body, is_point(index));
    wrong_.zero_or_above({"drag", {}, {}, owner}, body.drag, "[N s/m]");
    wrong_.zero_or_above({"spin_drag", {}, {}, owner}, body.spin_drag, "[N m s]");
    check_function(owner + "force", body.force, "[N]");
    check_function(owner + "moment", body.moment, "[N m]");
    const bool turns = moments(body.inertia).cwiseAbs().maxCoeff() > 0.0;
    if (!turns && body.spin_drag > 0.0) {
      wrong_.add(owner + "spin_drag " + text(body.spin_drag) +
                 " is for a body with an inertia, which a point mass has not; must be 0 [N m s]");
    }
    if (!turns && !body.moment.empty()) {
      wrong_.add(owner +
                 "moment is for a body with an inertia, which a point mass has not; must be left "
                 "out");
    }
  }

  /// True where all ends on the body are its centre.
  [[nodiscard]] bool is_point(std::size_t body) const {
    return std::all_of(system_.cables.begin(), system_.cables.end(), [&](const auto& cable) {
      bool at_centre = true;
      for (std::size_t i = 0; i <= cable.segments(); ++i) {
        const End& end = cable.end(i);
        at_centre = at_centre && !(end.body == body && !end.at.isZero(0.0));
      }
      return at_centre;
    });
  }

  void check_cables() {
    if (system_.cables.size() > max_cables) {
      wrong_.add("cables: " + std::to_string(system_.cables.size()) + " given; a system has 0 to " +
                 std::to_string(max_cables));
    }
    for (std::size_t index = 0; index < system_.cables.size(); ++index) {
      const CableOfSystem& cable = system_.cables[index];
      check_ends(index, cable);
      if (is_constant(cable.length)) {
        wrong_.divisor({"length", index}, cable.length.at(0.0)[0], "[m]");
      } else {
        check_function(cable_name(index) + ": length", cable.length, "[m]");
      }
      wrong_.restitution(index, cable);
      check_times(index, cable);
      if (cable.elasticity) {
        check_elasticity(index, cable);
      }
    }
  }

  void check_elasticity(std::size_t index, const CableOfSystem& cable) {
    const Elasticity& law = *cable.elasticity;
    const char* const key = stiffness_key(law);
    if (law.stiffness.empty()) {
      wrong_.add(cable_name(index) + ": " + key + " is empty; must have at least one coefficient " +
                 stiffness_unit(law));
    } else {
      wrong_.divisor({key, index}, law.stiffness.front(), stiffness_unit(law));
      wrong_.finite({key, index}, std::span(law.stiffness).subspan(1));
    }
    check_corners(index, law);
    wrong_.zero_or_above({"damping", index}, law.damping, "[N s/m]");
    wrong_.zero_or_above({"damping_ratio", index}, law.damping_ratio, "[-]");
    if (law.damping > 0.0 && law.damping_ratio > 0.0) {
      wrong_.add(cable_name(index) + ": damping " + text(law.damping) + " and damping_ratio " +
                 text(law.damping_ratio) + " are both given; one of them must be left out");
    }
    if (cable.restitution != 1.0 || cable.capture_speed > 0.0 || !cable.restitution_table.empty()) {
      wrong_.add(cable_name(index) +
                 ": restitution, capture_speed and restitution_table are for inextensible cables; "
                 "with a stiffness they must be left out, and damping_ratio does their part");
    }
  }

  /// The force rises from corner to corner.
  void check_corners(std::size_t index, const Elasticity& law) {
    if (!law.corners.empty() && law.stiffness.size() > 1) {
      wrong_.add(cable_name(index) + ": corners go on from one " + stiffness_key(law) + ", and " +
                 std::to_string(law.stiffness.size()) + " coefficients are given; must be one");
    }
    const char* const unit = law.of_strain ? "[-]" : "[m]";
    for (std::size_t i = 0; i < law.corners.size(); ++i) {
      const std::string owner = cable_name(index) + ": corners[" + std::to_string(i) + "]: ";
      wrong_.divisor({"stretch", {}, {}, owner}, law.corners[i].stretch, unit);
      wrong_.divisor({stiffness_key(law), {}, {}, owner}, law.corners[i].stiffness,
                     stiffness_unit(law));
      if (i > 0 && !(law.corners[i].stretch > law.corners[i - 1].stretch)) {
        wrong_.rising({"stretch ", {}, {}, owner}, law.corners[i].stretch,
                      law.corners[i - 1].stretch, unit);
      }
    }
  }

  void check_ends(std::size_t index, const CableOfSystem& cable) {
    bool on_body = false;
    for (std::size_t i = 0; i <= cable.segments(); ++i) {
      const End& end = cable.end(i);
      const std::string owner = cable_name(index) + ": " + end_key(cable, i);
      wrong_.finite({": at", {}, {}, owner}, std::span<const double>(end.at.data(), D));
      check_function(owner, end.motion, "[m]");
      on_body = on_body || end.body;
      if (end.body && *end.body >= count()) {
        wrong_.add(owner + ": body " + std::to_string(*end.body) +
                   " is not there; the system has " + std::to_string(count()));
      }
      if (end.body && !end.motion.empty()) {
        wrong_.add(owner +
                   ": is a point of a body, which does not move in it; only an end in the "
                   "world has a motion of its own");
      }
    }
    if (!on_body) {
      wrong_.add(cable_name(index) +
                 ": from, through and to are all in the world; one of them must be on a body");
    } else if (cable.through.empty() && cable.from.body == cable.to.body) {
      wrong_.add(cable_name(index) + ": from and to are both on " + body_name(*cable.from.body) +
                 ", which it cannot hold; must join two bodies, or a body with the world");
    }
  }

  void check_times(std::size_t index, const CableOfSystem& cable) {
    if (cable.from_time) {
      wrong_.positive({"from_time", index}, *cable.from_time, "[s]");
    }
    if (cable.cut_at) {
      wrong_.positive({"cut_at", index}, *cable.cut_at, "[s]");
      if (cable.from_time && *cable.cut_at <= *cable.from_time) {
        wrong_.add(cable_name(index) + ": cut_at " + text(*cable.cut_at) +
                   " must be above from_time " + text(*cable.from_time) + " [s]");
      }
    }
  }

  /// The numbers of a function that `owner` names.
  template <int N>
  void check_function(const std::string& owner, const Function<N>& function,
                      std::string_view unit) {
    const auto finite = [&](const std::string& what, const Eigen::Matrix<double, N, 1>& value) {
      for (int i = 0; i < N; ++i) {
        wrong_.finite({what, {}, {}, owner}, {value[i]});
      }
    };
    for (std::size_t i = 0; i < function.pieces.size(); ++i) {
      const auto& piece = function.pieces[i];
      const std::string name = ": pieces[" + std::to_string(i) + "]: ";
      wrong_.finite({name + "from", {}, {}, owner}, {piece.from});
      if (i > 0 && !(piece.from > function.pieces[i - 1].from)) {
        wrong_.rising({name + "from ", {}, {}, owner}, piece.from, function.pieces[i - 1].from,
                      "[s]");
      }
      if (piece.coefficients.empty()) {
        wrong_.add(owner + name + "polynomial is empty; must have at least one coefficient " +
                   std::string(unit));
      }
      for (const auto& coefficient : piece.coefficients) {
        finite(is_constant(function) ? "" : name + "polynomial", coefficient);
      }
    }
    for (std::size_t i = 0; i < function.waves.size(); ++i) {
      const auto& wave = function.waves[i];
      const std::string name = ": waves[" + std::to_string(i) + "]: ";
      finite(name + "amplitude", wave.amplitude);
      wrong_.zero_or_above({name + "frequency", {}, {}, owner}, wave.frequency, "[rad/s]");
      wrong_.finite({name + "phase", {}, {}, owner}, {wave.phase});
    }
  }

  /// A length or an end that jumps would pull with no bound.
  void check_jumps() {
    for (std::size_t index = 0; index < system_.cables.size(); ++index) {
      const CableOfSystem& cable = system_.cables[index];
      check_jumps(cable_name(index) + ": length", cable.length);
      for (std::size_t i = 0; i <= cable.segments(); ++i) {
        check_jumps(cable_name(index) + ": " + end_key(cable, i), cable.end(i).motion);
      }
    }
  }

  template <int N>
  void check_jumps(const std::string& owner, const Function<N>& function) {
    for (std::size_t i = 1; i < function.pieces.size(); ++i) {
      const auto& before = function.pieces[i - 1];
      const auto& after = function.pieces[i];
      const double since = after.from - before.from;
      Eigen::Matrix<double, N, 1> ends = Eigen::Matrix<double, N, 1>::Zero();
      double size = after.coefficients.front().norm();  // of what the two are computed from
      for (std::size_t k = before.coefficients.size(); k-- > 0;) {
        ends = Eigen::Matrix<double, N, 1>(since * ends + before.coefficients[k]);
        size = std::max(size, ends.norm());
      }
      const double jump = (after.coefficients.front() - ends).norm();
      if (!(jump <= gap_rounding * size)) {
        wrong_.add(owner + ": jumps by " + text(jump) + " m at " + text(after.from) +
                   " s; must go on from where the piece before it ends");
      }
    }
  }

  void check_lengths() {
    for (std::size_t index = 0; index < system_.cables.size(); ++index) {
      const CableOfSystem& cable = system_.cables[index];
      const double begin = cable.from_time.value_or(0.0);
      const double end = std::min(cable.cut_at.value_or(system_.duration), system_.duration);
      if (is_constant(cable.length) || begin > end) {
        continue;
      }
      if (const auto found = not_above_zero(cable.length, begin, end)) {
        wrong_.add(cable_name(index) + ": length " + text(found->value) + " at " +
                   text(found->time) + " s must be above 0 [m] as long as the cable acts");
      }
    }
  }

  void check_reach() {
    const auto held = [&](const CableOfSystem& cable) {  // between one body and a point at rest
      const End& world = cable.from.body ? cable.to : cable.from;
      return cable.through.empty() && !world.body && is_constant(world.motion) &&
             is_constant(cable.length) && cable.acts_at(0.0) && !cable.elasticity;
    };
    for (std::size_t i = 0; i < system_.cables.size(); ++i) {
      for (std::size_t j = i + 1; j < system_.cables.size(); ++j) {
        const CableOfSystem& one = system_.cables[i];
        const CableOfSystem& two = system_.cables[j];
        const auto& [body, anchor] = sides(one);
        const auto& [other, second] = sides(two);
        if (held(one) && held(two) && body.body == other.body) {
          wrong_.reach({(end_place(anchor, system_) - end_place(second, system_)).norm(),
                        one.length.at(0.0)[0] + two.length.at(0.0)[0] + (body.at - other.at).norm(),
                        i, j});
        }
      }
    }
  }

  /// The end of a straight cable on a body, and the other one.
  static std::pair<const End&, const End&> sides(const CableOfSystem& cable) {
    return cable.from.body ? std::pair<const End&, const End&>(cable.from, cable.to)
                           : std::pair<const End&, const End&>(cable.to, cable.from);
  }

  void check_start() {
    for (std::size_t index = 0; index < system_.cables.size(); ++index) {
      if (system_.cables[index].acts_at(0.0)) {
        check_start(index, system_.cables[index]);
      }
    }
  }

  void check_start(std::size_t index, const CableOfSystem& cable) {
    const double length = cable.length.at(0.0)[0];
    double distance = 0.0;
    double largest = std::max(length, end_operand(cable.from, system_));
    for (std::size_t i = 0; i < cable.segments(); ++i) {
      const double apart =
          (end_place(cable.end(i), system_) - end_place(cable.end(i + 1), system_)).norm();
      const bool resists = cable.elasticity && cable.elasticity->cut == ElasticCut::never;
      if ((resists || !cable.through.empty()) && apart < shortest_segment * length) {
        wrong_.add(cable_name(index) + ": its " + end_name(cable, i) + " and its " +
                   end_name(cable, i + 1) + " start " + text(apart) +
                   " m apart, which gives it no direction" +
                   (resists ? ", and with cut \"never\" its damper acts there" : "") +
                   "; must be at least " + text(shortest_segment * length) + " m");
        return;
      }
      distance += apart;
      largest = std::max(largest, end_operand(cable.end(i + 1), system_));
    }
    if (cable.elasticity) {
      distance = std::min(distance, length);  // it may start stretched
    }
    wrong_.start_of_cable(index, length, distance, epsilon<double>() * largest,
                          cable.through.empty() ? " m apart" : " m apart through its rings");
  }

  const System& system_;
  Sentences wrong_;
};

}  // namespace

std::vector<std::string> problems(const System& system) { return SystemChecker<2>(system).run(); }

std::vector<std::string> problems(const SpatialSystem& system) {
  return SystemChecker<3>(system).run();
}

}  // namespace tautline
