#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "tautline/case.hpp"
#include "tautline/detail/state_matrix.hpp"
#include "tautline/impact.hpp"
#include "tautline/solution.hpp"

namespace tautline {

// How the motion depends on its start (analytic/README.md, section "Sensitivity").

/// What the events of one instant do to a small difference of states (Eqs. 41 to 44).
template <class Real>
struct BasicSaltation {
  Real time;                      // [s]
  BasicStateMatrix<Real> matrix;  // infinite where no derivative exists
};
using Saltation = BasicSaltation<double>;

/// The derivative of the state along a solution with respect to the initial state.
///
/// It follows neighbours that have the same events in the same order. There is no derivative where
/// all neighbours, however close, part from the solution by a finite amount or at an infinite rate:
/// at an impact of rate zero (grazing), and where several cables close at the same instant by
/// chance, so that the neighbours hit them one after the other. From there on it is infinite.
template <class Real>
class BasicSensitivity {
 public:
  /// `solution` solves `the_case` under `law`.
  BasicSensitivity(const BasicCase<Real>& the_case, const BasicSolution<BasicCase<Real>>& solution,
                   ImpactLaw law = ImpactLaw::simultaneous);

  /// d state(time) / d initial state; at an event, of the state after it.
  /// Throws std::out_of_range outside [0, end of the solution].
  [[nodiscard]] BasicStateMatrix<Real> at(const Real& time) const;

  /// d state(to) / d state(from), both after the events of their instants; the identity where they
  /// are one instant. Unlike `at(to)` times the inverse of `at(from)` it exists where an impact
  /// without rebound has taken a freedom away. Infinite where no derivative exists.
  /// Throws std::out_of_range unless 0 <= from <= to <= the end of the solution.
  [[nodiscard]] BasicStateMatrix<Real> between(const Real& from, const Real& to) const;

  /// The factor [-] by which a small difference of states has grown at most at `time`: the largest
  /// singular value of `at` in the metric of Eq. 45. Infinity where no derivative exists.
  [[nodiscard]] Real growth(const Real& time) const;

  /// The first time [s] at which a difference of `local_error` at the start can have grown to
  /// `tolerance`, both in the metric of Eq. 45 and to first order; none if it never does.
  [[nodiscard]] std::optional<Real> horizon(const Real& tolerance, const Real& local_error) const;

  /// One for each instant with events, in rising time.
  [[nodiscard]] const std::vector<BasicSaltation<Real>>& saltations() const { return saltations_; }

 private:
  /// A stretch of motion without events, up to the start of the next.
  struct Piece {
    Real start;                      // [s]
    BasicStateMatrix<Real> initial;  // the derivative at `start`
    /// Taylor coefficients of d pose / d state at `start`; empty in free flight.
    std::vector<Eigen::Matrix<Real, 3, 6>> series;
    std::optional<Real> period = {};  // [s]: at rest, the same series serves one after the other
    BasicStateMatrix<Real> jump = BasicStateMatrix<Real>::Identity();  // of the events before it

    [[nodiscard]] BasicStateMatrix<Real> after(const Real& dt) const {
      return carried(dt, initial);
    }
    /// `matrix` at the start of the piece, `dt` [s] later.
    [[nodiscard]] BasicStateMatrix<Real> carried(const Real& dt,
                                                 const BasicStateMatrix<Real>& matrix) const;
    [[nodiscard]] BasicStateMatrix<Real> flow(const Real& dt) const;
  };

  void append(const Real& start, const Real& end, std::vector<Eigen::Matrix<Real, 3, 6>> series,
              std::optional<Real> period = {});
  void follow(const BasicCase<Real>& the_case, const BasicArc<BasicCase<Real>>& arc,
              const BasicVec2<Real>& gravity);
  [[nodiscard]] Real size(const BasicStateMatrix<Real>& matrix) const;
  /// The place of the piece that `time` [s] lies in; of several that start then, the last.
  /// Throws std::out_of_range outside of the solution.
  [[nodiscard]] std::size_t piece_at(const Real& time) const;

  Real radius_;  // [m], of gyration; 0 where the turn has no part in the motion
  Real end_;     // [s]
  BasicStateMatrix<Real> now_ = BasicStateMatrix<Real>::Identity();
  BasicStateMatrix<Real> jump_ = BasicStateMatrix<Real>::Identity();  // since the last piece
  std::vector<Piece> pieces_;
  std::vector<BasicSaltation<Real>> saltations_;
};
using Sensitivity = BasicSensitivity<double>;

}  // namespace tautline
