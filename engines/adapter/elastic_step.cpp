#include "tautline/elastic_step.hpp"

#include "system/elastic.hpp"

namespace tautline {

SpatialSystemState with_zones_of_step(const SpatialSystem& system, SpatialSystemState state) {
  for (std::size_t index = 0; index < system.cables.size(); ++index) {
    if (system.cables[index].elasticity) {
      const SpatialCable& cable = system.cables[index];
      sort_zone(system, index, gap(cable, state) < 0.0, cable.acts_at(state.time), state);
    }
  }
  return state;
}

std::vector<double> elastic_impulses(const SpatialSystem& system, const SpatialSystemState& state,
                                     double dt) {
  std::vector<double> result(system.cables.size());
  for (const std::size_t index : state.elastic.pulling()) {
    result[index] = dt * elastic_tension(system, index, state);
  }
  return result;
}

std::vector<BodyLoad> elastic_loads(const SpatialSystem& system, const SpatialSystemState& state) {
  RowOf<SpatialSystem> wrench = no_change(state);
  for (const std::size_t index : state.elastic.pulling()) {
    wrench += elastic_tension(system, index, state) * gap_gradient(system.cables[index], state);
  }
  std::vector<BodyLoad> result;
  Eigen::Index row = 0;
  for (const SpatialState& body : state.bodies) {
    result.push_back({wrench.segment<3>(row), in_the_world(body, wrench.segment<3>(row + 3))});
    row += 6;
  }
  return result;
}

}  // namespace tautline
