#pragma once

#include <vector>

#include "tautline/solve.hpp"
#include "tautline/system.hpp"

namespace tautline {

/// Bodies that cables join, and the cables that do. The world joins none.
struct Island {
  std::vector<std::size_t> bodies;  // of the system, in rising order
  std::vector<std::size_t> cables;  // likewise
};

/// The islands of a system, in the order of their first bodies: each moves by itself.
template <class Real, int D>
[[nodiscard]] std::vector<Island> islands(const BasicSystem<Real, D>& system);

/// An island as a system of its own.
template <class Real, int D>
[[nodiscard]] BasicSystem<Real, D> part_of(const BasicSystem<Real, D>& system,
                                           const Island& island);

/// The exact motion of a system, each island solved apart: what happens to one cuts no arc of
/// another, and leaves every bit of it.
template <class Real, int D>
class BasicSystemMotion {
 public:
  using Solution = BasicSolution<BasicSystem<Real, D>>;  // of an island
  /// An island, and its motion.
  struct Part {
    Island island;      // of the system
    Solution solution;  // of its own time
  };

  /// Made by solve_islands().
  explicit BasicSystemMotion(BasicSystem<Real, D> system, std::vector<Part> parts);

  /// The state of all bodies at `time` in [0, end_time()]; at an event, after it.
  [[nodiscard]] BasicSystemState<Real, D> at(const Real& time) const;
  /// The tension [N] of each cable at `time`, as BasicSolution::tensions.
  [[nodiscard]] BasicCableVector<Real> tensions(const Real& time) const;
  /// All events up to end_time() in rising time, with the cables and bodies of the whole system.
  [[nodiscard]] const std::vector<BasicEvent<BasicSystem<Real, D>>>& events() const {
    return events_;
  }
  /// The first ending of an island before the duration; rest, where all rest.
  [[nodiscard]] Ending ending() const { return ending_; }
  [[nodiscard]] const Real& end_time() const { return end_; }                   // [s]
  [[nodiscard]] const std::vector<Part>& parts() const { return parts_; }       // at least one
  [[nodiscard]] const BasicSystem<Real, D>& system() const { return system_; }  // the whole

 private:
  void find_end();
  void merge_events();
  void put(const Part& part, const BasicSystemState<Real, D>& of_part,
           BasicSystemState<Real, D>& whole) const;

  BasicSystem<Real, D> system_;
  std::vector<Part> parts_;
  std::vector<BasicEvent<BasicSystem<Real, D>>> events_;
  Ending ending_ = Ending::reached_duration;
  Real end_;
};
using SystemMotion = BasicSystemMotion<double, 2>;         // in double, in the plane
using SpatialSystemMotion = BasicSystemMotion<double, 3>;  // in double, in space

/// Solves `system` island by island. Throws as solve() does.
template <class Real, int D>
[[nodiscard]] BasicSystemMotion<Real, D> solve_islands(const BasicSystem<Real, D>& system,
                                                       const SolveOptions& options = {});

}  // namespace tautline
