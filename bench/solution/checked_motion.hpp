#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "bench/solution/samples.hpp"
#include "tautline/elastic_contacts.hpp"
#include "tautline/solution.hpp"
#include "tautline/solve.hpp"
#include "tautline/system_ledger.hpp"
#include "tautline/system_settling.hpp"

namespace tautline::bench {

/// The digits of a system's second solution where none are asked for.
inline constexpr int digits_of_systems = 30;

/// A number of a system's motion, and what it is called.
struct SampleName {
  std::string name;  // "load x", "tension 0"
  bool is_of_a_body;
};

/// How far two solutions agree in their settling; < 0 where nothing agrees.
struct SystemSettlingErrors {
  std::vector<double> last_impacts;   // [s], < 0: none agrees
  std::vector<double> tensions;       // [N], of each cable's largest
  std::vector<double> tension_times;  // [s]
  std::vector<double> impulses;       // [N s]
  std::vector<double> impulse_times;  // [s]
  std::vector<double> shares;         // [-]
  double lock = -1.0;                 // [s]
  double residual_energy = -1.0;      // [J]
  double one_percent = -1.0;          // [s]
  double ring_down = -1.0;            // [s]
};

/// A contact of an elastic cable, and how far each of its numbers is right, in its place; < 0 where
/// that is not known.
struct CheckedContact {
  ElasticContact contact;
  ElasticContact errors;
};

/// The motion of a system of D dimensions in double, and in more digits to say how far it is right:
/// of a number those digits are right that both have. From the horizon on the motion is one of
/// many.
template <int D>
class BasicCheckedMotion {
 public:
  using System = BasicSystem<double, D>;

  /// Solves `system`; with `digits`, too, unless they are 0. Not for several threads: see `Digits`.
  /// Throws std::invalid_argument on a system that `solve` does not take by its law.
  BasicCheckedMotion(System system, const SolveOptions& options, int digits = digits_of_systems);
  BasicCheckedMotion(const BasicCheckedMotion&) = delete;
  BasicCheckedMotion& operator=(const BasicCheckedMotion&) = delete;
  BasicCheckedMotion(BasicCheckedMotion&&) = delete;
  BasicCheckedMotion& operator=(BasicCheckedMotion&&) = delete;
  ~BasicCheckedMotion();

  [[nodiscard]] const System& system() const { return system_; }
  [[nodiscard]] const BasicSolution<System>& solution() const { return solution_; }
  [[nodiscard]] const SystemSettling& settling() const { return settling_; }
  [[nodiscard]] SystemSettlingErrors settling_errors() const;
  [[nodiscard]] const SystemLedger& ledger() const { return ledger_; }
  /// How far the members of the ledger agree, in their places; < 0 from the horizon on.
  [[nodiscard]] SystemLedger ledger_errors() const;
  [[nodiscard]] bool is_checked() const { return in_digits_ != nullptr; }
  [[nodiscard]] int digits() const { return digits_; }  // of the second solution; 0: none

  /// From here on the two solutions part [s]; none: they agree to the end. Of a motion that is not
  /// checked: its start.
  [[nodiscard]] const std::optional<double>& horizon() const { return horizon_; }

  /// The names of the numbers of a sample: of each body its pose and its rates; of each cable its
  /// gap, the rate of that and its tension; the energy.
  [[nodiscard]] std::vector<SampleName> names() const;

  /// They at `time` [s], after an event there.
  [[nodiscard]] std::vector<Bounded> at(double time) const;

  /// They on one side of event `index`.
  [[nodiscard]] std::vector<Bounded> at_event(std::size_t index, Side side) const;

  /// When event `index` is.
  [[nodiscard]] Bounded time(std::size_t index) const;

  /// Its impulses [N s], one for each of its cables.
  [[nodiscard]] std::vector<Bounded> impulses(std::size_t index) const;

  /// The contacts of its elastic cables, by rising entry.
  [[nodiscard]] std::vector<CheckedContact> contacts() const;

  /// How far the limit of accumulation `index` is right [s]; < 0 where that is not known.
  [[nodiscard]] double accumulation_error(std::size_t index) const;

 private:
  struct InDigits;

  void align();
  [[nodiscard]] bool end_alike(double speed) const;  // [m/s], the largest of the motion
  /// How long [s] the bounces last that event `index` completes; 0: it completes none.
  [[nodiscard]] double completed_time(std::size_t index) const;
  /// The event of the second solution that event `index` is; none from the horizon on.
  [[nodiscard]] std::optional<std::size_t> same_event(std::size_t index) const;

  System system_;
  BasicSolution<System> solution_;
  SystemSettling settling_;
  SystemLedger ledger_;
  int digits_;
  std::unique_ptr<InDigits> in_digits_;           // null: not checked
  std::vector<std::optional<std::size_t>> same_;  // event of the second solution, for each
  std::optional<double> horizon_;
};
using CheckedMotion = BasicCheckedMotion<2>;  // in the plane

}  // namespace tautline::bench
