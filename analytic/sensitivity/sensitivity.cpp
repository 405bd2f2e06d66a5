#include "tautline/detail/sensitivity.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <iterator>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>

#include "instantiate.hpp"
#include "linearised.hpp"
#include "saltation.hpp"
#include "tautline/detail/hold.hpp"

namespace tautline {
namespace {

/// What the series of a derivative may leave out [-].
template <class Real>
Real truncation() {
  return 45 * epsilon<Real>();
}

/// How many of the first `events` belong to the start of an arc at `time`: an impact, which the
/// first arc of all comes before, and what follows from it at once.
template <class Real>
std::size_t together(std::span<const BasicEvent<BasicCase<Real>>> events, const Real& time,
                     bool first_arc) {
  std::size_t count = 0;
  while (count < events.size() && events[count].time <= time &&
         (events[count].kind != EventKind::impact || (count == 0 && !first_arc))) {
    ++count;
  }
  return count;
}

/// The time up to which the last terms of `series` are as small as they need be.
template <class Real>
Real reach(const std::vector<Eigen::Matrix<Real, 3, 6>>& series) {
  Real result = infinity<Real>();
  for (std::size_t k = series.size() - 2; k < series.size(); ++k) {
    const Real last = series[k].cwiseAbs().maxCoeff();
    if (last > 0) {
      result = min(result, root(Real(truncation<Real>() / last), static_cast<double>(k)));
    }
  }
  return result;
}

/// The largest singular value. The double it is found in is relative to the largest entry: the
/// matrix may be beyond its range.
template <class Real>
Real largest_singular_value(const BasicStateMatrix<Real>& matrix) {
  const Real scale = matrix.cwiseAbs().maxCoeff();
  if (!(scale > 0) || !isfinite(scale)) {
    return isnan(scale) ? infinity<Real>() : scale;
  }
  const StateMatrix part = BasicStateMatrix<Real>(matrix / scale).template cast<double>();
  const Eigen::SelfAdjointEigenSolver<StateMatrix> squares(part.transpose() * part,
                                                           Eigen::EigenvaluesOnly);
  return scale * sqrt(squares.eigenvalues().maxCoeff());
}

}  // namespace

/// d state(dt) / d state(0) of one series, or of free flight (Eq. 40).
template <class Real>
BasicStateMatrix<Real> BasicSensitivity<Real>::Piece::flow(const Real& dt) const {
  BasicStateMatrix<Real> result = BasicStateMatrix<Real>::Identity();
  if (series.empty()) {
    result.template topRightCorner<3, 3>().diagonal().setConstant(dt);
    return result;
  }
  Eigen::Matrix<Real, 3, 6> pose = Eigen::Matrix<Real, 3, 6>::Zero();
  Eigen::Matrix<Real, 3, 6> rate = Eigen::Matrix<Real, 3, 6>::Zero();
  for (std::size_t k = series.size(); k-- > 0;) {
    rate = (rate * dt + pose).eval();
    pose = (pose * dt + series[k]).eval();
  }
  result << pose, rate;
  return result;
}

template <class Real>
BasicStateMatrix<Real> BasicSensitivity<Real>::Piece::carried(
    const Real& dt, const BasicStateMatrix<Real>& matrix) const {
  if (!period || dt < *period) {
    return flow(dt) * matrix;
  }
  // the whole periods by repeated squaring
  auto periods = static_cast<unsigned long long>(Real(dt / *period));
  BasicStateMatrix<Real> result = flow(dt - *period * static_cast<double>(periods)) * matrix;
  for (BasicStateMatrix<Real> power = flow(*period); periods > 0; periods /= 2) {
    result = periods % 2 == 1 ? (power * result).eval() : result;
    power = (power * power).eval();
  }
  return result;
}

template <class Real>
BasicSensitivity<Real>::BasicSensitivity(const BasicCase<Real>& the_case,
                                         const BasicSolution<BasicCase<Real>>& solution,
                                         ImpactLaw law)
    : radius_(gyration_radius(the_case)), end_(solution.end_time()) {
  const std::vector<BasicArc<BasicCase<Real>>> arcs = solution.arcs_until(end_);
  std::span<const BasicEvent<BasicCase<Real>>> left(solution.events());
  Eigen::Matrix<Real, 6, 1> before = state_rate(arcs.front(), Real(0), solution.gravity());
  CableSet taut;
  for (std::size_t index = 0; index < arcs.size(); ++index) {
    const BasicArc<BasicCase<Real>>& arc = arcs[index];
    const bool pause = index + 1 < arcs.size() && !(arcs[index + 1].start > arc.start);
    // near an accumulation impacts follow each other within the rounding of time: one an arc
    for (bool again = true; again;) {
      const std::size_t count = together(left, arc.start, index == 0);
      if (count > 0) {
        const BasicInstant<Real> instant{the_case, law, left.first(count), before,
                                         state_rate(arc, Real(0), solution.gravity())};
        const BasicJump<Real> jump = saltation(instant, taut);
        saltations_.push_back({arc.start, jump.matrix});
        jump_ = (jump.matrix * jump_).eval();
        taut = jump.taut;
        now_ = jump.matrix.allFinite() && now_.allFinite() ? (jump.matrix * now_).eval()
                                                           : no_derivative<Real>();
        left = left.subspan(count);
      }
      again = count > 0 && !pause;
    }
    follow(the_case, arc, solution.gravity());
    before = state_rate(arc, Real(arc.end - arc.start), solution.gravity());
  }
}

template <class Real>
void BasicSensitivity<Real>::append(const Real& start, const Real& end,
                                    std::vector<Eigen::Matrix<Real, 3, 6>> series,
                                    std::optional<Real> period) {
  pieces_.push_back({start, now_, std::move(series), std::move(period), jump_});
  jump_.setIdentity();
  if (now_.allFinite()) {
    now_ = pieces_.back().after(end - start);
  }
}

/// Appends the pieces of `arc`.
template <class Real>
void BasicSensitivity<Real>::follow(const BasicCase<Real>& the_case,
                                    const BasicArc<BasicCase<Real>>& arc,
                                    const BasicVec2<Real>& gravity) {
  std::optional<BasicHold<BasicCase<Real>>> held;
  if (arc.series.rows() > 0 && now_.allFinite()) {
    held = hold(the_case, arc.initial, {arc.taut, infinity<Real>()}, arc.taut);
    if (!held) {
      now_ = no_derivative<Real>();
    }
  }
  if (!held || held->pulling.empty()) {
    append(arc.start, arc.end, {});
    return;
  }
  const bool rests = is_rest(arc);
  for (Real start = arc.start; start == arc.start || start < arc.end;) {
    auto series = flow_derivative(the_case, arc.after(start - arc.start, gravity), held->pulling,
                                  held->motion.angle().size() - 1);
    const Real length = reach(series);
    const Real end = rests ? arc.end : Real(min(arc.end, Real(start + length)));
    if (!(end > start) && arc.end > start) {  // no step is small enough
      now_ = no_derivative<Real>();
      append(start, arc.end, {});
      return;
    }
    append(start, end, std::move(series), rests ? std::optional(length) : std::nullopt);
    if (end == start) {
      return;
    }
    start = end;
  }
}

template <class Real>
std::size_t BasicSensitivity<Real>::piece_at(const Real& time) const {
  if (!(time >= 0 && time <= end_)) {
    throw std::out_of_range("time " + std::to_string(static_cast<double>(time)) +
                            " is outside the solution, which ends at " +
                            std::to_string(static_cast<double>(end_)));
  }
  const auto next =
      std::upper_bound(pieces_.begin(), pieces_.end(), time,
                       [](const Real& t, const Piece& piece) { return t < piece.start; });
  return static_cast<std::size_t>(std::prev(next) - pieces_.begin());
}

template <class Real>
BasicStateMatrix<Real> BasicSensitivity<Real>::at(const Real& time) const {
  const Piece& piece = pieces_[piece_at(time)];
  return piece.initial.allFinite() ? piece.after(time - piece.start) : piece.initial;
}

template <class Real>
BasicStateMatrix<Real> BasicSensitivity<Real>::between(const Real& from, const Real& to) const {
  std::size_t place = piece_at(from);
  const std::size_t last = piece_at(to);
  if (!(from <= to)) {
    throw std::out_of_range("no derivative goes back in time");
  }
  if (!pieces_[last].initial.allFinite()) {
    return no_derivative<Real>();
  }
  // along a piece nothing is lost: its flow has an inverse
  BasicStateMatrix<Real> result =
      from > pieces_[place].start
          ? BasicStateMatrix<Real>(
                pieces_[place]
                    .carried(from - pieces_[place].start, BasicStateMatrix<Real>::Identity())
                    .partialPivLu()
                    .inverse())
          : BasicStateMatrix<Real>::Identity();
  for (; place < last; ++place) {
    const Piece& next = pieces_[place + 1];
    result = (next.jump * pieces_[place].carried(next.start - pieces_[place].start, result)).eval();
  }
  return pieces_[last].carried(to - pieces_[last].start, result);
}

template <class Real>
Real BasicSensitivity<Real>::size(const BasicStateMatrix<Real>& matrix) const {
  BasicStateMatrix<Real> scaled = matrix;
  for (const Eigen::Index axis : {2, 5}) {
    if (radius_ > 0) {
      scaled.row(axis) *= radius_;
      scaled.col(axis) /= radius_;
    } else {
      scaled.row(axis).setZero();
      scaled.col(axis).setZero();
    }
  }
  return largest_singular_value(scaled);
}

template <class Real>
Real BasicSensitivity<Real>::growth(const Real& time) const {
  return size(at(time));
}

template <class Real>
std::optional<Real> BasicSensitivity<Real>::horizon(const Real& tolerance,
                                                    const Real& local_error) const {
  const Real limit = tolerance / local_error;
  for (std::size_t index = 0; index < pieces_.size(); ++index) {
    const Piece& piece = pieces_[index];
    if (!piece.initial.allFinite() || size(piece.initial) >= limit) {
      return piece.start;
    }
    Real length = (index + 1 < pieces_.size() ? pieces_[index + 1].start : end_) - piece.start;
    // in free flight the growth is convex: no larger within than at the ends. Along a series it is
    // as smooth as the motion, of which a piece is a fraction of the natural time; about a state of
    // rest it swings, and repeats itself
    constexpr int periods = 64;
    const int samples = piece.series.empty() ? 1 : 8 * (piece.period ? periods : 1);
    if (piece.period) {
      length = min(length, Real(*piece.period * periods));
    }
    Real low(0);
    for (int sample = 1; sample <= samples; ++sample) {
      Real high = length * sample / samples;
      if (size(piece.after(high)) < limit) {
        low = high;
        continue;
      }
      constexpr int halvings = 52;  // to a double's last bit of the arc
      for (int halving = 0; halving < halvings; ++halving) {
        const Real middle = (low + high) / 2;
        (size(piece.after(middle)) < limit ? low : high) = middle;
      }
      return piece.start + high;
    }
  }
  return std::nullopt;
}

template class BasicSensitivity<Instance>;

}  // namespace tautline
