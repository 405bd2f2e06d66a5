#pragma once

#include <Eigen/Core>
#include <vector>

#include "tautline/case.hpp"
#include "tautline/detail/sensitivity.hpp"
#include "tautline/impact.hpp"
#include "tautline/solution.hpp"

namespace tautline::bench {

/// The factor [-] by which an exact motion magnifies a small difference of its start, in the metric
/// of Eq. 45, as `Sensitivity::growth` says it; but it goes on after impacts that hit several
/// cables in one instant. Only neighbours that hit them in one instant, too, are followed from
/// there on: the starts that a scheme with the symmetry of the case can come to.
class Growth {
 public:
  /// `solution` solves `the_case`, which must outlive this, under `law`.
  Growth(const Case& the_case, const Solution& solution, ImpactLaw law);

  /// At `time` [s], after the events of that instant; infinity where no derivative exists.
  [[nodiscard]] double at(double time) const;

 private:
  using Directions = Eigen::Matrix<double, 6, Eigen::Dynamic>;

  /// The motion from the start, or from an impact on several cables, on.
  struct Part {
    double start;             // [s]
    Directions derivative;    // of the state there, by differences of the start of size one
    Sensitivity sensitivity;  // to the state there
  };

  void pass(const Event& event);
  [[nodiscard]] Directions carried(double time) const;
  [[nodiscard]] Directions after_impact(const Event& event, const Directions& before) const;
  [[nodiscard]] double size(Directions derivative) const;

  const Case& case_;
  ImpactLaw law_;
  double radius_;            // [m], of gyration; 0 for a point mass
  std::vector<Part> parts_;  // in rising time, at least one
};

}  // namespace tautline::bench
