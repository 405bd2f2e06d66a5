#include "world_xml.hpp"

#include <cmath>
#include <limits>
#include <locale>
#include <sstream>

#include "tautline/point_mass.hpp"

namespace tautline::mujoco {
namespace {

/// MuJoCo's largest impedance (mjMAXIMP): a limit acts with this part of what it should [-].
constexpr const char* impedance = "0.9999 0.9999 1 0.5 1";

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

}  // namespace

std::string model_xml(const Case& the_case, Integrator integrator,
                      const std::vector<TendonLimit>& limits) {
  std::ostringstream out;
  out.imbue(std::locale::classic());
  out.precision(std::numeric_limits<double>::max_digits10);
  out << "<mujoco><compiler angle='radian'/><option integrator='"
      << (integrator == Integrator::rk4 ? "RK4" : "Euler")
      << "' jacobian='dense' tolerance='0' gravity='" << InPlane{the_case.gravity}
      << "'/><worldbody>";
  for (std::size_t index = 0; index < the_case.cables.size(); ++index) {
    out << "<site name='anchor" << index << "' pos='" << InPlane{the_case.cables[index].anchor}
        << "'/>";
  }
  write_body(out, the_case);
  out << "</worldbody><tendon>";
  for (std::size_t index = 0; index < the_case.cables.size(); ++index) {
    out << "<spatial";
    if (!limits.empty()) {
      out << " limited='true' range='0 " << the_case.cables[index].length << "' solreflimit='"
          << -limits[index].stiffness << ' ' << -limits[index].damping << "' solimplimit='"
          << impedance << "'";
    }
    out << "><site site='anchor" << index << "'/><site site='attachment" << index
        << "'/></spatial>";
  }
  out << "</tendon></mujoco>";
  return out.str();
}

}  // namespace tautline::mujoco
