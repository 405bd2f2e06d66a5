#pragma once

#include <Eigen/Cholesky>
#include <algorithm>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "box_forces.hpp"
#include "spring.hpp"
#include "tautline/detail/root_search.hpp"
#include "tautline/detail/series.hpp"

namespace tautline::energetic {

/// After so many steps the springs are cut: they keep what they have stored, and what still closes
/// is stopped [-]. An impact takes some twenty; a restitution near the least one, held taut by
/// other cables, takes 1e4; elastic cables that leave the body nowhere to go would need forever.
inline constexpr int most_steps = 50'000;

/// A row whose square keeps no more than this beside the held ones depends on them [-].
inline constexpr double dependent = 1e-12;

/// So often a cable may change its mode without time passing, where rounding decides; then it waits
/// for a time whose square is rounding [-].
inline constexpr int most_stalls = 3;

/// The body on its springs, during the impact.
template <class TheCase>
class SpringImpact {
 public:
  using Real = RealOf<TheCase>;

  SpringImpact(std::vector<Spring<TheCase>> springs, RowOf<TheCase> velocity)
      : springs_(std::move(springs)),
        velocity_(std::move(velocity)),
        motion_(enough_terms<Real>()) {}

  /// Goes on until no spring pulls and no cable closes, at most `most_steps`; returns the steps.
  int run() {
    for (int step = 0; step < most_steps; ++step) {
      read_rates();
      if (changed_) {
        choose_held();
      }
      if (is_over()) {
        return step;
      }
      advance();
    }
    return most_steps;
  }

  /// Those so far, one per spring.
  [[nodiscard]] BasicCableVector<Real> impulses() const {
    BasicCableVector<Real> result(static_cast<Eigen::Index>(springs_.size()));
    Eigen::Index row = 0;
    for (const Spring<TheCase>& spring : springs_) {
      result[row++] = spring.impulse;
    }
    return result;
  }

 private:
  void read_rates() {
    for (Spring<TheCase>& spring : springs_) {
      spring.rate = spring.row.dot(velocity_);
      if (abs(spring.rate) <= rounding<Real>()) {
        spring.rate = Real(0);
      }
    }
  }

  /// A held spring only answers the others.
  [[nodiscard]] bool is_over() const {
    return std::none_of(springs_.begin(), springs_.end(), [](const Spring<TheCase>& spring) {
      return spring.acts() || (spring.mode == Mode::slack && spring.rate < 0);
    });
  }

  /// The pull of all springs with a force of their own.
  [[nodiscard]] RowOf<TheCase> pull(std::size_t k) const {
    RowOf<TheCase> result = RowOf<TheCase>::Zero();
    for (const Spring<TheCase>& spring : springs_) {
      if (spring.acts()) {
        result += spring.row * (k == 0 ? spring.value : spring.series[k]);
      }
    }
    return result;
  }

  /// The part of `vector` that leaves the held springs where they are.
  [[nodiscard]] RowOf<TheCase> along_held(const RowOf<TheCase>& vector) const {
    return vector - held_.transpose() * factors_.solve(held_ * vector);
  }

  /// Decides, after a change of the forces, what each spring at its edge does next: part, load on,
  /// or be held.
  void choose_held() {
    std::vector<Spring<TheCase>*> edge;
    for (Spring<TheCase>& spring : springs_) {
      if (spring.at_edge()) {
        spring.mode = Mode::held;
        edge.push_back(&spring);
      }
    }
    held_.resize(0, Eigen::NoChange);
    for (Spring<TheCase>& spring : springs_) {
      spring.fixed = false;
    }
    if (edge.empty()) {
      return;
    }
    RowsOf<TheCase> rows;
    rows.resize(static_cast<Eigen::Index>(edge.size()), Eigen::NoChange);
    BasicCableVector<Real> largest(rows.rows());
    CableSet pulling;
    for (Eigen::Index row = 0; row < rows.rows(); ++row) {
      rows.row(row) = edge[static_cast<std::size_t>(row)]->row.transpose();
      largest[row] = edge[static_cast<std::size_t>(row)]->largest;
      if (std::exchange(edge[static_cast<std::size_t>(row)]->caught, false)) {
        pulling.insert(static_cast<std::size_t>(row));
      }
    }
    const RowOf<TheCase> others = pull(0);
    const BoxForces<Real> chosen = box_forces<TheCase>(rows, others, largest, pulling);
    for (Eigen::Index row = 0; row < rows.rows(); ++row) {
      Spring<TheCase>& spring = *edge[static_cast<std::size_t>(row)];
      spring.value = chosen.force[row];
      if (chosen.between.contains(static_cast<std::size_t>(row))) {
        held_.conservativeResize(held_.rows() + 1, Eigen::NoChange);
        held_.row(held_.rows() - 1) = spring.row.transpose();
      } else {
        spring.mode = spring.value > 0 ? Mode::loading : Mode::slack;
      }
    }
    factors_.compute(held_ * held_.transpose());
    if (held_.rows() > 0) {
      velocity_ = along_held(velocity_);
      for (Spring<TheCase>& spring : springs_) {
        spring.fixed = along_held(spring.row).squaredNorm() <= dependent * spring.row.squaredNorm();
      }
    }
  }

  /// The series of the motion and of every spring.
  void expand() {
    motion_[0].setZero();
    motion_[1] = velocity_;
    for (Spring<TheCase>& spring : springs_) {
      spring.series.assign(motion_.size() - (spring.mode == Mode::held ? 2 : 0), Real(0));
      spring.series[0] = spring.value;
      if (spring.mode != Mode::held && !spring.fixed) {
        spring.series[1] = -spring.slope() * spring.rate;
      }
    }
    for (std::size_t k = 0; k + 2 < motion_.size(); ++k) {
      RowOf<TheCase> total = pull(k);
      if (held_.rows() > 0) {
        const BasicCableVector<Real> forces = -factors_.solve(held_ * total);
        total += held_.transpose() * forces;
        Eigen::Index row = 0;
        for (Spring<TheCase>& spring : springs_) {
          if (spring.mode == Mode::held) {
            spring.series[k] = forces[row++];
            if (k == 0) {  // the value it was given, but for rounding
              const Real change = spring.value - spring.series[0];
              spring.series[0] += abs(change) <= rounding<Real>() ? change : Real(0);
            }
          }
        }
      }
      motion_[k + 2] = total / static_cast<double>((k + 1) * (k + 2));
      for (Spring<TheCase>& spring : springs_) {
        if (spring.mode != Mode::held && !spring.fixed) {
          spring.series[k + 2] = -spring.slope() * spring.row.dot(motion_[k + 2]);
        }
      }
    }
  }

  /// How long the series hold: one radian of the fastest swing. Without a force, until the last
  /// closing cable pulls.
  [[nodiscard]] Real reach() const {
    Real stiffness(0);  // the trace, above the square of every frequency
    Real latest(0);
    for (const Spring<TheCase>& spring : springs_) {
      if (spring.acts()) {
        stiffness += spring.slope() * spring.row.squaredNorm();
      } else if (spring.mode == Mode::slack && spring.rate < 0) {
        latest = max(latest, Real(2 * spring.value / -spring.rate));
      }
    }
    return stiffness > 0 ? Real(1 / sqrt(stiffness)) : latest;
  }

  /// When `spring` changes its mode, at most `horizon`; the series hold up to `longest`.
  [[nodiscard]] std::optional<Real> change(const Spring<TheCase>& spring, const Real& horizon,
                                           const Real& longest) const {
    const std::vector<Real>& series = spring.series;
    // the first fall through zero of a series, whose first `zeros` terms are zero; so are those
    // that rounding alone has left
    const auto fall = [&](const std::vector<Real>& f, std::size_t zeros) -> std::optional<Real> {
      const auto rest = [&](std::size_t k) {  // the terms after the k-th, against it
        Real size(0);
        for (std::size_t later = f.size(); later-- > k + 1;) {
          size = (size + abs(f[later])) * longest;
        }
        return size;
      };
      while (zeros < f.size() && abs(f[zeros]) <= epsilon<Real>() * rest(zeros)) {
        ++zeros;
      }
      if (zeros == f.size()) {
        return std::nullopt;
      }
      return f[zeros] < 0
                 ? Real(0)
                 : first_root(Polynomial<Real>(std::span<const Real>(f), zeros), horizon).root;
    };
    if (spring.mode == Mode::loading) {  // until it turns back
      std::vector<Real> speed;
      for (std::size_t k = 1; k < series.size(); ++k) {
        speed.push_back(series[k] * static_cast<double>(k));
      }
      return fall(speed, spring.rate == 0 ? 1 : 0);
    }
    // at a limit from which it starts its value has one zero, or two where it starts at rest
    const std::size_t zeros = spring.mode == Mode::held ? 0 : spring.rate == 0 ? 2 : 1;
    auto down = fall(series, series[0] == 0 ? zeros : 0);
    if (spring.mode == Mode::slack) {
      return down;
    }
    std::vector<Real> room;
    room.reserve(series.size());
    for (const Real& term : series) {
      room.push_back(-term);
    }
    room[0] += spring.largest;
    auto up = fall(room, room[0] == 0 ? zeros : 0);
    return !up || (down && *down < *up) ? down : up;
  }

  /// Moves to the first change of a mode, at most as far as the series hold, and changes it.
  void advance() {
    expand();
    const Real longest = reach();
    const bool waits = std::any_of(springs_.begin(), springs_.end(),
                                   [](const auto& spring) { return spring.stalls >= most_stalls; });
    Real dt = waits ? Real(sqrt(epsilon<Real>()) * longest) : longest;
    Spring<TheCase>* changing = nullptr;
    for (Spring<TheCase>& spring : springs_) {
      if (spring.stalls < most_stalls) {
        if (const auto time = change(spring, dt, longest);
            time && (*time < dt || changing == nullptr)) {
          dt = *time;
          changing = &spring;
        }
      }
    }
    const bool stalled = !(dt > rounding<Real>() * longest);
    if (dt > 0) {
      move(dt);
    }
    changed_ = changing != nullptr;
    for (Spring<TheCase>& spring : springs_) {
      spring.stalls = stalled ? spring.stalls + (&spring == changing ? 1 : 0) : 0;
    }
    if (changing != nullptr) {
      switch_mode(*changing);
    }
  }

  void move(const Real& dt) {
    RowOf<TheCase> velocity = RowOf<TheCase>::Zero();
    for (std::size_t k = motion_.size(); k-- > 1;) {
      velocity = (velocity * dt + motion_[k] * Real(static_cast<double>(k))).eval();
    }
    velocity_ = velocity;
    for (Spring<TheCase>& spring : springs_) {
      if (spring.mode != Mode::slack) {
        spring.impulse += max(Real(0), integral_of(spring.series, dt));
      }
      spring.value = max(Real(0), value_of(spring.series, dt));
      if (spring.mode == Mode::loading) {
        spring.largest = spring.value;
      } else if (spring.mode != Mode::slack) {
        spring.value = min(spring.value, spring.largest);
      }
    }
  }

  /// What `spring` does after its change; those at their edge are decided by `choose_held`.
  static void switch_mode(Spring<TheCase>& spring) {
    const bool elastic = spring.returned > 0;
    switch (spring.mode) {
      case Mode::loading:
        spring.mode = !(spring.largest > 0) ? Mode::slack : elastic ? Mode::returning : Mode::held;
        break;
      case Mode::returning: {
        const bool parts = 2 * spring.value < spring.largest;
        spring.mode = parts ? Mode::slack : Mode::loading;
        spring.value = parts ? Real(0) : spring.largest;
        break;
      }
      case Mode::slack:
        spring.caught = spring.rate == 0;
        spring.value = elastic ? Real(0) : spring.largest;
        spring.mode = elastic && spring.largest > 0 ? Mode::returning : Mode::loading;
        break;
      case Mode::held:
        break;
    }
  }

  std::vector<Spring<TheCase>> springs_;
  RowOf<TheCase> velocity_;                      // over the root of the mass
  std::vector<RowOf<TheCase>> motion_;           // series of the way gone
  bool changed_ = true;                          // the forces, since `choose_held`
  RowsOf<TheCase> held_;                         // rows of the held springs
  Eigen::LDLT<BasicCableMatrix<Real>> factors_;  // of their Delassus matrix
};

}  // namespace tautline::energetic
