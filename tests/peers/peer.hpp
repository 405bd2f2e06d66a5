#pragma once

#include <cstddef>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "tautline/case.hpp"

namespace tautline::peers {

/// An impact as a peer located it.
struct Located {
  double time;      // [s] from the start
  CableSet cables;  // that were struck
};

/// How far a run goes.
struct Stop {
  double horizon;    // [s], > 0
  std::size_t most;  // impacts
};

/// How exactly a peer is asked to integrate.
struct Effort {
  double tolerance;     // [-], relative and absolute
  double longest_step;  // [s]; 0: the peer's own choice
};

/// Arcs of a peer that takes about a millisecond for one.
inline constexpr std::size_t arcs_of_slow_peers = 10'000;

/// A library that integrates a flight with error control and locates the zeros of the gaps.
class Peer {
 public:
  Peer() = default;
  Peer(const Peer&) = delete;
  Peer& operator=(const Peer&) = delete;
  virtual ~Peer() = default;

  [[nodiscard]] virtual std::string name() const = 0;
  [[nodiscard]] virtual std::string version() const = 0;  // of the library
  [[nodiscard]] virtual std::string method() const = 0;   // what it is asked to do, in a phrase
  /// False where the peer has one way to do it, whatever the effort.
  [[nodiscard]] virtual bool has_effort() const { return true; }

  /// How many grazing arcs it flies, the first of all: fewer where one takes about a millisecond.
  [[nodiscard]] virtual std::size_t most_arcs() const {
    return std::numeric_limits<std::size_t>::max();
  }

  /// The impacts of `the_case` in the order of time. Impulses are those of Newton's law, all cables
  /// at once. The case's cables start slack. Throws std::runtime_error where the library gives up.
  [[nodiscard]] virtual std::vector<Located> impacts(const Case& the_case, const Stop& stop,
                                                     const Effort& effort) = 0;
};

[[nodiscard]] std::unique_ptr<Peer> exact_peer();    // the solver of tautline
[[nodiscard]] std::unique_ptr<Peer> cvode_peer();    // SUNDIALS CVODE
[[nodiscard]] std::unique_ptr<Peer> odeint_peer();   // Boost.Odeint
[[nodiscard]] std::unique_ptr<Peer> siconos_peer();  // Siconos' EventDriven
[[nodiscard]] std::unique_ptr<Peer> simbody_peer();  // Simbody

/// The exact solver first, then every peer that was here when this was built.
[[nodiscard]] std::vector<std::unique_ptr<Peer>> all_peers();

}  // namespace tautline::peers
