#include "world_xml.hpp"

#include <cmath>
#include <limits>
#include <locale>
#include <sstream>

#include "tautline/point_mass.hpp"

namespace tautline::mujoco {
namespace {

/// A point of the plane, as MuJoCo reads it.
struct InPlane {
  Vec2 point;
};

std::ostream& operator<<(std::ostream& out, const InPlane& in) {
  return out << in.point.x() << ' ' << in.point.y() << " 0";
}

/// The body. MuJoCo weighs a tendon once and for all at the pose the model is written in, which is
/// the initial one, where no cable has zero length. With `ref` the coordinates are nevertheless
/// those of the world. A joint's axis is in the body's frame.
void write_body(std::ostream& out, const Case& the_case) {
  const State& start = the_case.initial;
  const double c = std::cos(start.angle);
  const double s = std::sin(start.angle);
  const double inertia = turnable_inertia(the_case.body);
  out << "<body pos='" << InPlane{start.position} << "' axisangle='0 0 1 " << start.angle << "'>"
      << "<joint type='slide' axis='" << InPlane{{c, -s}} << "' ref='" << start.position.x()
      << "'/><joint type='slide' axis='" << InPlane{{s, c}} << "' ref='" << start.position.y()
      << "'/><joint type='hinge' axis='0 0 1' ref='" << start.angle << "'/>"
      << "<inertial pos='0 0 0' mass='" << the_case.body.mass << "' diaginertia='" << inertia << ' '
      << inertia << ' ' << inertia << "'/>";
  for (std::size_t index = 0; index < the_case.cables.size(); ++index) {
    out << "<site name='attachment" << index << "' pos='"
        << InPlane{the_case.cables[index].attachment} << "'/>";
  }
  out << "</body>";
}

/// Everything before the world.
template <class Gravity>
void write_options(std::ostream& out, Integrator integrator, const Gravity& gravity) {
  out.imbue(std::locale::classic());
  out.precision(std::numeric_limits<double>::max_digits10);
  out << "<mujoco><compiler angle='radian'/><option integrator='"
      << (integrator == Integrator::rk4 ? "RK4" : "Euler")
      << "' jacobian='dense' tolerance='0' gravity='" << gravity << "'/>";
}

/// A tendon through the sites of these names, with its limit, if it has one.
void write_tendon(std::ostream& out, const std::vector<std::string>& sites, double length,
                  const TendonLimit* limit) {
  out << "<spatial";
  if (limit != nullptr) {
    out << " limited='true' range='0 " << length << "' solreflimit='" << -limit->stiffness << ' '
        << -limit->damping << "' solimplimit='" << limit_impedance << ' ' << limit_impedance
        << " 1 0.5 1'";
  }
  out << ">";
  for (const std::string& site : sites) {
    out << "<site site='" << site << "'/>";
  }
  out << "</spatial>";
}

/// A point of space, as MuJoCo reads it.
struct InSpace {
  Eigen::Vector3d point;
};

std::ostream& operator<<(std::ostream& out, const InSpace& in) {
  return out << in.point.x() << ' ' << in.point.y() << ' ' << in.point.z();
}

std::string site_name(std::size_t cable, std::size_t end) {
  return "cable" + std::to_string(cable) + "end" + std::to_string(end);
}

/// The sites that `here` is true of, at their `at`.
template <class Here>
void write_sites(std::ostream& out, const SpatialSystem& system, const Here& here) {
  for (std::size_t index = 0; index < system.cables.size(); ++index) {
    for (std::size_t i = 0; i <= system.cables[index].segments(); ++i) {
      const SpatialEnd& end = system.cables[index].end(i);
      if (here(end)) {
        out << "<site name='" << site_name(index, i) << "' pos='" << InSpace{end.at} << "'/>";
      }
    }
  }
}

void write_bodies(std::ostream& out, const SpatialSystem& system) {
  for (std::size_t index = 0; index < system.bodies.size(); ++index) {
    const SpatialBody& body = system.bodies[index];
    const SpatialState& start = system.initial.bodies[index];
    const Eigen::Vector3d inertia = turnable_inertia(body);
    const Quaternion& turn = start.orientation;
    out << "<body pos='" << InSpace{start.position} << "' quat='" << turn[0] << ' '
        << InSpace{turn.tail<3>()} << "'><freejoint/><inertial pos='0 0 0' mass='" << body.mass
        << "' diaginertia='" << InSpace{inertia} << "'/>";
    write_sites(out, system, [&](const SpatialEnd& end) { return end.body == index; });
    out << "</body>";
  }
}

/// The bodies that go where they are put.
void write_moving_ends(std::ostream& out, const SpatialSystem& system) {
  for (std::size_t index = 0; index < system.cables.size(); ++index) {
    for (std::size_t i = 0; i <= system.cables[index].segments(); ++i) {
      const SpatialEnd& end = system.cables[index].end(i);
      if (!end.motion.empty()) {
        out << "<body mocap='true' pos='" << InSpace{end.at + end.motion.at(0.0)}
            << "'><site name='" << site_name(index, i) << "'/></body>";
      }
    }
  }
}

}  // namespace

std::string model_xml(const Case& the_case, Integrator integrator,
                      const std::vector<TendonLimit>& limits) {
  std::ostringstream out;
  write_options(out, integrator, InPlane{the_case.gravity});
  out << "<worldbody>";
  for (std::size_t index = 0; index < the_case.cables.size(); ++index) {
    out << "<site name='anchor" << index << "' pos='" << InPlane{the_case.cables[index].anchor}
        << "'/>";
  }
  write_body(out, the_case);
  out << "</worldbody><tendon>";
  for (std::size_t index = 0; index < the_case.cables.size(); ++index) {
    const std::string number = std::to_string(index);
    write_tendon(out, {"anchor" + number, "attachment" + number}, the_case.cables[index].length,
                 limits.empty() ? nullptr : &limits[index]);
  }
  out << "</tendon></mujoco>";
  return out.str();
}

std::string model_xml(const SpatialSystem& system, Integrator integrator,
                      const std::vector<TendonLimit>& limits) {
  std::ostringstream out;
  write_options(out, integrator, InSpace{system.gravity.at(0.0)});
  out << "<worldbody>";
  write_sites(out, system, [](const SpatialEnd& end) { return !end.body && end.motion.empty(); });
  write_bodies(out, system);
  write_moving_ends(out, system);
  out << "</worldbody><tendon>";
  for (std::size_t index = 0; index < system.cables.size(); ++index) {
    std::vector<std::string> sites;
    for (std::size_t i = 0; i <= system.cables[index].segments(); ++i) {
      sites.push_back(site_name(index, i));
    }
    write_tendon(out, sites, system.cables[index].length.at(0.0)[0],
                 limits.empty() ? nullptr : &limits[index]);
  }
  out << "</tendon></mujoco>";
  return out.str();
}

}  // namespace tautline::mujoco
