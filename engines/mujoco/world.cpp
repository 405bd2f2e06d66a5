#include "world.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <stdexcept>
#include <string>

#include "library.hpp"
#include "tautline/geometry.hpp"
#include "tautline/impulses_by_hand.hpp"

namespace tautline::mujoco {
namespace {

/// x, y and the angle: the generalised coordinates of a body in the plane.
constexpr int coordinates = 3;
using Vec3 = Eigen::Vector3d;

/// A free joint: a position and a quaternion, a velocity in the world and a spin in the body's
/// axes.
constexpr int pose_numbers = 7;
constexpr int motion_numbers = 6;

/// A file in memory; MuJoCo reads models from files only.
class VirtualFile {
 public:
  VirtualFile(const char* name, const std::string& text) : files_(std::make_unique<mjVFS>()) {
    mj_defaultVFS(files_.get());
    if (mj_makeEmptyFileVFS(files_.get(), name, static_cast<int>(text.size())) != 0) {
      throw std::runtime_error("MuJoCo has no room for the model");
    }
    std::memcpy(files_->filedata[0], text.data(), text.size());
  }
  VirtualFile(const VirtualFile&) = delete;
  VirtualFile& operator=(const VirtualFile&) = delete;
  ~VirtualFile() { mj_deleteVFS(files_.get()); }

  [[nodiscard]] const mjVFS* get() const { return files_.get(); }

 private:
  std::unique_ptr<mjVFS> files_;  // 2 MB
};

mjModel* load(const std::string& xml) {
  constexpr const char* name = "case.xml";
  const VirtualFile file(name, xml);
  std::array<char, 500> why{};
  mjModel* model = mj_loadXML(name, file.get(), why.data(), static_cast<int>(why.size()));
  if (model == nullptr) {
    const std::string text = why.data();  // its second line tells the line of the XML
    throw std::runtime_error("MuJoCo refuses the case: " + text.substr(0, text.find('\n')));
  }
  return model;
}

}  // namespace

BareWorld::BareWorld(const std::string& xml)
    : model_(load(xml)), data_(mj_makeData(model_.get())) {}

void BareWorld::step(double dt) {
  model_->opt.timestep = dt;
  mj_step(model_.get(), data_.get());
  throw_warning();
}

void BareWorld::measure() {
  mj_fwdPosition(model_.get(), data_.get());
  mj_fwdVelocity(model_.get(), data_.get());
}

std::vector<double> BareWorld::limit_forces() const {
  std::vector<double> forces(static_cast<std::size_t>(model_->ntendon));
  for (int row = 0; row < data_->nefc; ++row) {
    if (data_->efc_type[row] == mjCNSTR_LIMIT_TENDON) {
      forces[static_cast<std::size_t>(data_->efc_id[row])] = data_->efc_force[row];
    }
  }
  return forces;
}

template <int Freedoms, int Most, class TheCase>
CableVector BareWorld::apply(CableSet cables, const CableVector& rates, double rounding) {
  const Eigen::Index freedoms = model_->nv;
  Eigen::Matrix<double, Freedoms, Eigen::Dynamic, 0, Most, max_cables> gradients(freedoms,
                                                                                 rates.size());
  CableVector excess(rates.size());
  Eigen::Index position = 0;
  for (const std::size_t index : cables) {
    const auto tendon = static_cast<Eigen::Index>(index);
    gradients.col(position) = -Eigen::Map<const Eigen::Matrix<double, Freedoms, 1, 0, Most>>(
        data_->ten_J + freedoms * tendon, freedoms);  // d length
    excess[position] = -data_->ten_velocity[tendon] - rates[position];
    ++position;
  }
  auto responses = gradients;
  mj_solveM(model_.get(), data_.get(), responses.data(), gradients.data(),
            static_cast<int>(gradients.cols()));
  CableVector impulses =
      impulses_by_hand(gradients.transpose() * responses, excess, rounding, rank_of<TheCase>);
  Eigen::Map<Eigen::Matrix<double, Freedoms, 1, 0, Most>>(data_->qvel, freedoms) +=
      responses * impulses;
  return impulses;
}

World::World(const Case& the_case, Integrator integrator, const std::vector<TendonLimit>& limits)
    : BareWorld(model_xml(the_case, integrator, limits)), case_(the_case) {
  place(the_case.initial);
}

State World::state() const {
  State result;
  result.position = Vec2(data().qpos[0], data().qpos[1]);
  result.angle = data().qpos[2];
  result.velocity = Vec2(data().qvel[0], data().qvel[1]);
  result.spin = data().qvel[2];
  return result;
}

void World::place(const State& state) {
  Eigen::Map<Vec3>(data().qpos) << state.position, state.angle;
  Eigen::Map<Vec3>(data().qvel) << state.velocity, state.spin;
}

void World::kick(const Vec2& change) { Eigen::Map<Vec2>(data().qvel) += change; }

World::Rows World::look(double /*dt*/) {
  measure();
  Rows rows;
  for (const Cable& cable : case_.cables) {
    const std::size_t index = rows.size();
    const Eigen::Map<const Vec3> longer(data().ten_J + coordinates * index);  // d length
    rows.push_back({attachment_point(state(), cable), -longer.head<2>(), -longer[2],
                    cable.length - data().ten_length[index], -data().ten_velocity[index]});
  }
  return rows;
}

CableVector World::pull(CableSet cables, const CableVector& rates) {
  measure();
  return apply<coordinates, coordinates, Case>(cables, rates, impact_rounding(case_, state()));
}

SystemWorld::SystemWorld(const SpatialSystem& system, Integrator integrator,
                         const std::vector<TendonLimit>& limits)
    : BareWorld(model_xml(system, integrator, limits)),
      system_(system),
      limits_(!limits.empty()),
      given_(system.cables.size()) {
  place(system.initial);
}

SpatialSystemState SystemWorld::state() const {
  SpatialSystemState result;
  result.time = time_;
  const double* pose = data().qpos;
  const double* motion = data().qvel;
  for (std::size_t index = 0; index < system_.bodies.size(); ++index) {
    SpatialState one;
    one.position = Eigen::Map<const Vec3>(pose);
    one.orientation = Eigen::Map<const Quaternion>(pose + 3).normalized();
    one.velocity = Eigen::Map<const Vec3>(motion);
    one.spin = Eigen::Map<const Vec3>(motion + 3);
    result.bodies.push_back(one);
    pose += pose_numbers;
    motion += motion_numbers;
  }
  return result;
}

void SystemWorld::place(const SpatialSystemState& state) {
  time_ = state.time;
  double* pose = data().qpos;
  double* motion = data().qvel;
  for (const SpatialState& body : state.bodies) {
    Eigen::Map<Eigen::Matrix<double, pose_numbers, 1>>(pose) << body.position, body.orientation;
    Eigen::Map<Eigen::Matrix<double, motion_numbers, 1>>(motion) << body.velocity, body.spin;
    pose += pose_numbers;
    motion += motion_numbers;
  }
}

void SystemWorld::set_cables() {
  double* mocap = data().mocap_pos;
  for (std::size_t index = 0; index < system_.cables.size(); ++index) {
    const SpatialCable& cable = system_.cables[index];
    model().tendon_range[2 * index + 1] = cable.length.at(time_)[0];
    if (limits_ && (cable.from_time || cable.cut_at)) {
      model().tendon_limited[index] = cable.acts_at(time_) ? 1 : 0;
    }
    for (std::size_t i = 0; i <= cable.segments(); ++i) {
      const SpatialEnd& end = cable.end(i);
      if (!end.motion.empty()) {
        Eigen::Map<Vec3> place(mocap);
        place = end.at + end.motion.at(time_);
        mocap += 3;
      }
    }
  }
}

void SystemWorld::advance(double dt) {
  const SpatialSystemState now = state();
  set_cables();
  Eigen::Map<Vec3> gravity(model().opt.gravity);
  gravity = gravity_in_step(system_, now, dt);
  add(loads_in_step(system_, now, dt));
  step(dt);
  mju_zero(data().xfrc_applied, 6 * model().nbody);
  time_ += dt;
}

void SystemWorld::add(const std::vector<BodyLoad>& loads) {
  for (std::size_t index = 0; index < loads.size(); ++index) {
    Eigen::Map<Eigen::Matrix<double, 6, 1>> of_body(data().xfrc_applied + 6 * (index + 1));
    of_body.head<3>() += loads[index].force;
    of_body.tail<3>() += loads[index].moment;
  }
}

SystemWorld::Rows SystemWorld::look(double dt) {
  set_cables();
  measure();
  Rows rows;
  const SpatialSystemState now = state();
  for (const SpatialCable& cable : system_.cables) {
    const std::size_t index = rows.size();
    SystemRow row = row_in_step(cable, now, dt);
    given_[index] = row.given;
    if (cable.acts_at(time_)) {
      row.gap = cable.length.at(time_)[0] - data().ten_length[index];
    }
    rows.push_back(row);
  }
  return rows;
}

CableVector SystemWorld::pull(CableSet cables, const CableVector& rates) {
  CableVector of_bodies = rates;
  Eigen::Index position = 0;
  for (const std::size_t index : cables) {
    of_bodies[position++] -= given_[index];
  }
  constexpr double rounding = 1e-12;  // [-], as impact_rounding has it
  return apply<Eigen::Dynamic, SpatialSystem::most_freedoms, SpatialSystem>(
      cables, of_bodies, rounding * fastest(state()));
}

std::vector<Setting> world_settings() {
  return {
      {"joints", "slide x, slide y, hinge z", "The problem is planar."},
      {"jacobian", "dense", "One row of three numbers per cable is there to be read."},
      {"tolerance", "0", "MuJoCo's 1e-8 ends the solver's iteration before rounding does."},
      {"mju_user_error, mju_user_warning", "exceptions",
       "MuJoCo would wait for a key and end the process, and write MUJOCO_LOG.TXT into the "
       "user's folder."},
  };
}

std::vector<Setting> system_settings() {
  return {{"joints", "free", "Bodies of a system move in space."},
          {"opt.gravity, xfrc_applied",
           "what is given, as it is in the middle of the step; drag as it decays in the step",
           "MuJoCo knows no function of time."},
          {"mocap_pos, tendon_range",
           "where ends that move are, and how long cables are, as a step starts",
           "MuJoCo knows no function of time, and no velocity of such an end."}};
}

}  // namespace tautline::mujoco
