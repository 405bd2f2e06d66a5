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

/// x, y and the angle.
constexpr int coordinates = 3;

/// The generalised coordinates of a body in the plane, or a force or an impulse on them.
using Vec3 = Eigen::Vector3d;

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

World::World(const Case& the_case, Integrator integrator, const std::vector<TendonLimit>& limits)
    : case_(the_case),
      model_(load(model_xml(the_case, integrator, limits))),
      data_(mj_makeData(model_.get())) {
  place(the_case.initial);
}

State World::state() const {
  State result;
  result.position = Vec2(data_->qpos[0], data_->qpos[1]);
  result.angle = data_->qpos[2];
  result.velocity = Vec2(data_->qvel[0], data_->qvel[1]);
  result.spin = data_->qvel[2];
  return result;
}

void World::place(const State& state) {
  Eigen::Map<Vec3>(data_->qpos) << state.position, state.angle;
  Eigen::Map<Vec3>(data_->qvel) << state.velocity, state.spin;
}

void World::kick(const Vec2& change) { Eigen::Map<Vec2>(data_->qvel) += change; }

void World::advance(double dt) {
  model_->opt.timestep = dt;
  mj_step(model_.get(), data_.get());
  throw_warning();
}

std::vector<double> World::limit_forces() const {
  std::vector<double> forces(case_.cables.size());
  for (int row = 0; row < data_->nefc; ++row) {
    if (data_->efc_type[row] == mjCNSTR_LIMIT_TENDON) {
      forces[static_cast<std::size_t>(data_->efc_id[row])] = data_->efc_force[row];
    }
  }
  return forces;
}

std::vector<CableRow> World::look() {
  mj_fwdPosition(model_.get(), data_.get());
  mj_fwdVelocity(model_.get(), data_.get());
  std::vector<CableRow> rows;
  for (const Cable& cable : case_.cables) {
    const std::size_t index = rows.size();
    const Eigen::Map<const Vec3> longer(data_->ten_J + coordinates * index);  // d length
    rows.push_back({attachment_point(state(), cable), -longer.head<2>(), -longer[2],
                    cable.length - data_->ten_length[index], -data_->ten_velocity[index]});
  }
  return rows;
}

CableVector World::pull(CableSet cables, const CableVector& rates) {
  const std::vector<CableRow> rows = look();
  Eigen::Matrix<double, coordinates, Eigen::Dynamic, 0, coordinates, max_cables> gradients(
      coordinates, rates.size());
  CableVector excess(rates.size());
  Eigen::Index position = 0;
  for (const std::size_t index : cables) {
    gradients.col(position) << rows[index].towards, rows[index].moment;
    excess[position] = rows[index].rate - rates[position];
    ++position;
  }
  auto responses = gradients;
  mj_solveM(model_.get(), data_.get(), responses.data(), gradients.data(),
            static_cast<int>(gradients.cols()));
  CableVector impulses =
      impulses_by_hand(gradients.transpose() * responses, excess, impact_rounding(case_, state()));
  Eigen::Map<Vec3>(data_->qvel) += responses * impulses;
  return impulses;
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

}  // namespace tautline::mujoco
