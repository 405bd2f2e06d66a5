#pragma once

#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>

#include "bench/check/scheme.hpp"
#include "tautline/case.hpp"
#include "tautline/engine.hpp"
#include "tautline/system.hpp"

namespace tautline::bench {

/// What a run shows is no motion: a number that is none, too few impulses, the event of a cable
/// that is not there. No claim can be measured on it.
class NoMotion : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// How the sentence of a model begins that cannot run a case.
inline constexpr std::string_view refusal = "unsupported: ";

/// A model that cannot run a system says why in one sentence, which this is: no claim about such
/// systems applies to it.
class NotRun : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// One model of one engine, to be measured.
class Subject {
 public:
  /// The engine must outlive it. Throws what the engine throws when it is started. All its runs
  /// have these `parameters` of the model.
  Subject(const Engine& engine, std::string model, std::map<std::string, double> parameters = {});

  /// A run of `the_case`. It throws NoMotion where the engine reports what is none.
  [[nodiscard]] std::unique_ptr<Simulation> start(const Case& the_case, double step) const;
  /// A run of a system in space. It throws NotRun where the model does not take it.
  [[nodiscard]] std::unique_ptr<SystemSimulation> start(const SpatialSystem& system,
                                                        double step) const;
  [[nodiscard]] bool in_double() const { return in_double_; }

  /// What the engine's numbers leave of a number near 1 after a few operations [-].
  [[nodiscard]] double rounding() const { return in_double_ ? 1e-15 : 1e-6; }

  /// How it seems to fly, and to turn, from one step of each.
  [[nodiscard]] const Flight& flight() const { return flight_; }
  [[nodiscard]] const Turn& turn() const { return turn_; }

 private:
  [[nodiscard]] RunSettings settings(double step) const;

  const Engine* engine_;
  std::string model_;
  std::map<std::string, double> parameters_;
  bool in_double_;
  Flight flight_;
  Turn turn_;
};

}  // namespace tautline::bench
