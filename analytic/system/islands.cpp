#include "tautline/islands.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "instantiate.hpp"
#include "system/kernel.hpp"

namespace tautline {
namespace {

/// The ending of a motion that goes on as it ends, without end.
bool is_rest(Ending ending) { return ending == Ending::rest || ending == Ending::unstable_rest; }

}  // namespace

template <class Real, int D>
std::vector<Island> islands(const BasicSystem<Real, D>& system) {
  const std::vector<std::size_t> first = joined(system, CableSet::first(system.cables.size()));
  std::vector<Island> result;
  for (std::size_t body = 0; body < first.size(); ++body) {
    if (first[body] != body) {
      continue;
    }
    Island& island = result.emplace_back();
    for (std::size_t other = body; other < first.size(); ++other) {
      if (first[other] == body) {
        island.bodies.push_back(other);
      }
    }
    for (std::size_t index = 0; index < system.cables.size(); ++index) {
      const std::vector<std::size_t> on = bodies_on(system.cables[index]);
      if (!on.empty() && first[on.front()] == body) {
        island.cables.push_back(index);
      }
    }
  }
  return result;
}

template <class Real, int D>
BasicSystem<Real, D> part_of(const BasicSystem<Real, D>& system, const Island& island) {
  BasicSystem<Real, D> result;
  result.name = system.name;
  result.gravity = system.gravity;
  result.duration = system.duration;
  result.initial.time = system.initial.time;
  std::vector<std::size_t> place(system.bodies.size());
  for (const std::size_t body : island.bodies) {
    place[body] = result.bodies.size();
    result.bodies.push_back(system.bodies[body]);
    result.initial.bodies.push_back(system.initial.bodies[body]);
  }
  const auto renumber = [&](BasicEnd<Real, D>& end) {
    if (end.body) {
      end.body = place[*end.body];
    }
  };
  for (const std::size_t index : island.cables) {
    auto& cable = result.cables.emplace_back(system.cables[index]);
    renumber(cable.from);
    renumber(cable.to);
    std::for_each(cable.through.begin(), cable.through.end(), renumber);
  }
  return result;
}

template <class Real, int D>
BasicSystemMotion<Real, D>::BasicSystemMotion(BasicSystem<Real, D> system, std::vector<Part> parts)
    : system_(std::move(system)), parts_(std::move(parts)), end_(system_.duration) {
  find_end();
  merge_events();
}

template <class Real, int D>
void BasicSystemMotion<Real, D>::find_end() {
  bool rests = !parts_.empty();
  for (const Part& part : parts_) {
    const Ending ending = part.solution.ending();
    rests = rests && is_rest(ending);
    if (part.solution.end_time() < end_) {
      end_ = part.solution.end_time();
      ending_ = ending;
    }
  }
  if (rests) {
    ending_ = parts_.front().solution.ending();
  }
}

/// Writes the bodies and the elastic cables of one island to the state of all.
template <class Real, int D>
void BasicSystemMotion<Real, D>::put(const Part& part, const BasicSystemState<Real, D>& of_part,
                                     BasicSystemState<Real, D>& whole) const {
  for (std::size_t i = 0; i < part.island.bodies.size(); ++i) {
    whole.bodies[part.island.bodies[i]] = of_part.bodies[i];
  }
  if (of_part.elastic.damping.empty()) {
    return;
  }
  auto& [engaged, loose, resisting, damping, past] = whole.elastic;
  damping.resize(system_.cables.size(), Real(0));
  past.resize(system_.cables.size(), 0);
  for (std::size_t i = 0; i < part.island.cables.size(); ++i) {
    const std::size_t index = part.island.cables[i];
    damping[index] = of_part.elastic.damping[i];
    past[index] = of_part.elastic.corners_past(i);
    engaged.erase(index);
    loose.erase(index);
    resisting.erase(index);
    if (of_part.elastic.engaged.contains(i)) {
      engaged.insert(index);
    } else if (of_part.elastic.loose.contains(i)) {
      loose.insert(index);
    } else if (of_part.elastic.resisting.contains(i)) {
      resisting.insert(index);
    }
  }
}

template <class Real, int D>
BasicSystemState<Real, D> BasicSystemMotion<Real, D>::at(const Real& time) const {
  BasicSystemState<Real, D> result = system_.initial;
  result.time = time;
  for (const Part& part : parts_) {
    put(part, part.solution.at(time), result);
  }
  return result;
}

template <class Real, int D>
BasicCableVector<Real> BasicSystemMotion<Real, D>::tensions(const Real& time) const {
  BasicCableVector<Real> result =
      BasicCableVector<Real>::Zero(static_cast<Eigen::Index>(system_.cables.size()));
  for (const Part& part : parts_) {
    const BasicCableVector<Real> own = part.solution.tensions(time);
    for (std::size_t i = 0; i < part.island.cables.size(); ++i) {
      result[static_cast<Eigen::Index>(part.island.cables[i])] = own[static_cast<Eigen::Index>(i)];
    }
  }
  return result;
}

template <class Real, int D>
void BasicSystemMotion<Real, D>::merge_events() {
  for (const Part& part : parts_) {
    for (const auto& event : part.solution.events()) {
      if (event.time > end_) {
        break;
      }
      auto whole = event;
      whole.cables = {};
      for (const std::size_t index : event.cables) {
        whole.cables.insert(part.island.cables[index]);
      }
      whole.before = at(event.time);
      whole.after = whole.before;
      put(part, event.before, whole.before);
      put(part, event.after, whole.after);
      events_.push_back(std::move(whole));
    }
  }
  std::stable_sort(events_.begin(), events_.end(),
                   [](const auto& a, const auto& b) { return a.time < b.time; });
}

template <class Real, int D>
BasicSystemMotion<Real, D> solve_islands(const BasicSystem<Real, D>& system,
                                         const SolveOptions& options) {
  if (const auto broken = problems(in_double(system)); !broken.empty()) {
    throw std::invalid_argument(broken.front());
  }
  std::vector<typename BasicSystemMotion<Real, D>::Part> parts;
  for (const Island& island : islands(system)) {
    parts.push_back({island, solve(part_of(system, island), options)});
  }
  return BasicSystemMotion<Real, D>(system, std::move(parts));
}

template std::vector<Island> islands(const InstanceCase&);
template InstanceCase part_of(const InstanceCase&, const Island&);
template class BasicSystemMotion<Instance, instance_dimension>;
template BasicSystemMotion<Instance, instance_dimension> solve_islands(const InstanceCase&,
                                                                       const SolveOptions&);

}  // namespace tautline
