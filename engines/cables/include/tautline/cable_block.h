// The impulses of cables that share bodies, solved together and exactly. Bullet's and ODE's drop-in
// cables share it; it knows neither, and needs C++11 alone. It computes in double, whatever the
// host does.
//
// With K = J M^-1 J^T of the cables' rows and `lacking` the rates they are short of, it finds
//   0 <= impulse, K impulse >= lacking, and of each pair one with equality,
// by block principal pivoting (Judice and Pires, "A block principal pivoting algorithm for large-
// scale strictly monotone linear complementarity problems", Computers and Operations Research 21,
// 1994): guess which cables pull, solve for them, and exchange those that are wrong; one by one,
// after Murty, where exchanging all goes round in circles. A few solves do, mostly one, for the
// guess is the answer of the step before. K of a chain is banded, and its factor no wider.

#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "tautline/cable_block_end.h"

// NOLINTBEGIN(modernize-use-nodiscard): C++11 does not know it
namespace tautline {

class CableBlock {
 public:
  /// For a host whose numbers round to `rounding` of themselves [-].
  explicit CableBlock(double rounding) : rounding_(rounding) {}

  struct Row {
    CableBlockEnd end[2];
    double softness;    // gives by this part of what its own impulse changes [-], and
    double compliance;  // by this much of an impulse [1/kg]

    /// J M^-1 J^T of the cable by itself [1/kg].
    double inverse_mass() const {
      return end[0].coupling(end[0]) + end[1].coupling(end[1]) + 2 * end[0].coupling(end[1]);
    }
  };

  /// Empties it; `row` of 0 to `count` - 1 are to be filled, then `assemble`.
  void begin(std::size_t count) {
    count_ = count;
    if (rows_.size() < count) {
      rows_.resize(count);
      lacking_.resize(count);
      impulse_.resize(count);
      excess_.resize(count);
      rigid_.resize(count);
      pulls_of_[velocities].resize(count, 1);
      pulls_of_[positions].resize(count, 1);
    }
    for (std::size_t index = 0; index < count; ++index) {
      rows_[index].end[0].kept = rows_[index].end[1].kept = 1.0;
    }
    factored_ = false;
  }
  Row& row(std::size_t index) { return rows_[index]; }

  void assemble() {
    k_.resize(count_ * count_);
    yields_ = false;
    for (std::size_t one = 0; one < count_; ++one) {
      for (std::size_t two = 0; two <= one; ++two) {
        double sum = 0.0;
        for (const CableBlockEnd& a : rows_[one].end) {
          for (const CableBlockEnd& b : rows_[two].end) {
            sum += a.coupling(b);
          }
        }
        k_[one * count_ + two] = k_[two * count_ + one] = sum;
      }
      rigid_[one] = k(one, one);
      yields_ = yields_ || rows_[one].compliance > 0.0;
      k_[one * count_ + one] += give_of(one);
    }
  }
  double kept(std::size_t index, int side) const { return rows_[index].end[side].kept; }
  /// J M^-1 J^T of a cable by itself [1/kg].
  double inverse_mass(std::size_t index) const { return rigid_[index]; }

  /// What row `index` is short of if no cable pulls [m/s].
  double& lacking(std::size_t index) { return lacking_[index]; }
  /// The answer [N s].
  double impulse(std::size_t index) const { return impulse_[index]; }
  void forget() { std::fill(impulse_.begin(), impulse_.end(), 0.0); }

  /// What all impulses change the rate of row `index` by, and what it gives by its softness [m/s].
  double reaction(std::size_t index) const {
    double sum = 0.0;
    for (std::size_t other = 0; other < count_; ++other) {
      sum += k(index, other) * impulse_[other];
    }
    return sum;
  }
  double give(std::size_t index) const { return give_of(index) * impulse_[index]; }

  /// Finds the impulses of what `lacking` says for a step of `dt` [s], and stiffens what it cannot
  /// follow: a light body between taut cables with a heavy load on them swings to and fro by T a /
  /// I (tension, arm, inertia), which takes steps with T a dt^2 < 4 I; with longer ones it is torn
  /// around by radians, and its cables unwind from it without end. So of the torque of two cables
  /// or more on a body, no more is kept than what would turn one of the inertia I + T a dt^2 - 4 I
  /// (the geometric stiffness of an implicit step), nor more than what turns it by
  /// CableTorque::farthest_turn. What is left out would have done work on the spin, or the torque
  /// is kept until it does: it takes energy out, never in.
  void solve_stiffly(double dt) {
    solve_keeping(velocities, [this, dt](const CableBlockEnd& end) {
      return torque_on(end.body).part_to_keep(end.spin, dt);
    });
  }

  /// Finds the moves of what `lacking` says [m], in which no body turns by more than a step
  /// follows: the lines turn with it, and what they ask for farther on is another thing. What would
  /// turn by more is moved the more. True if that was so; then the rows are to be filled anew.
  bool solve_moves() {
    return solve_keeping(positions, [this](const CableBlockEnd& end) {
      const CableTorque all = torque_on(end.body);
      const double angle = std::sqrt(CableBlockEnd::dot(all.turned, all.turned));
      return end.kept * std::min(CableTorque::farthest_turn() / std::max(angle, 1e-9), 1.0);
    });
  }

  /// Which guess a solve begins with, and leaves behind.
  enum Kind { velocities, positions };

  /// Finds the impulses of what `lacking` says.
  void solve(Kind kind) {
    if (count_ == 1) {
      impulse_[0] = k(0, 0) > 0.0 ? std::max(0.0, lacking_[0] / k(0, 0)) : 0.0;
      return;
    }
    std::vector<char>& pulls = pulls_of_[kind];
    pulls_.swap(pulls);
    factored_ = factored_ && factored_of_ == kind;
    factored_of_ = kind;
    pivot();
    if (kind == velocities) {
      share();
    }
    pulls_.swap(pulls);
  }

 private:
  /// Solves, and keeps no more of the torque on a body than `part_of` its end; true if not all.
  template <typename Part>
  bool solve_keeping(Kind kind, const Part& part_of) {
    solve(kind);
    const int rounds = 12;  // the tension grows as bodies stiffen; two or three do mostly
    bool any = false;
    for (int done = 0; done < rounds && keep_less(part_of); ++done) {
      any = true;
      assemble();
      factored_ = false;
      solve(kind);
    }
    return any;
  }
  template <typename Part>
  bool keep_less(const Part& part_of) {
    bool any = false;
    for (std::size_t index = 0; index < count_; ++index) {
      for (const CableBlockEnd& end : rows_[index].end) {
        const double part = end.body != nullptr ? part_of(end) : 1.0;
        const double worth = 0.99;  // a round for less gains nothing
        if (part < worth * end.kept) {
          any = true;
          take_turn(end.body, part / end.kept);
        }
      }
    }
    return any;
  }
  CableTorque torque_on(const void* body) const {
    CableTorque result;
    for (std::size_t index = 0; index < count_; ++index) {
      for (const CableBlockEnd& end : rows_[index].end) {
        if (end.body == body && impulse_[index] > 0.0) {
          result.add(end, impulse_[index]);
        }
      }
    }
    return result;
  }
  void take_turn(const void* body, double part) {
    for (std::size_t index = 0; index < count_; ++index) {
      for (CableBlockEnd& end : rows_[index].end) {
        for (int axis = 0; axis < 3 && end.body == body; ++axis) {
          end.turn[axis] *= part;
        }
        end.kept *= end.body == body ? part : 1.0;
      }
    }
  }

  void pivot() {
    int patience = 3;
    std::size_t fewest = count_ + 1;
    const std::size_t most = 20 + 10 * count_;  // never seen to be needed
    for (std::size_t done = 0; done < most; ++done) {
      solve_for_those_that_pull();
      std::size_t wrong = 0;
      std::size_t last = 0;
      for (std::size_t index = 0; index < count_; ++index) {
        if (is_wrong(index)) {
          ++wrong;
          last = index;
        }
      }
      if (wrong == 0) {
        break;
      }
      patience = wrong < fewest ? 3 : patience - 1;
      fewest = std::min(fewest, wrong);
      exchange(patience > 0 ? 0 : last, last);
    }
    for (std::size_t index = 0; index < count_; ++index) {
      impulse_[index] = std::max(0.0, impulse_[index]);
    }
  }

  /// Where there are more cables than the bodies can feel apart, as four ropes on a box, the motion
  /// leaves open how they share the load. Of all impulses with these rates it takes those with the
  /// least sum of k impulse^2, if all of them pull: those that are alike pull alike.
  void share() {
    const double alike = 1e-4;  // of the largest rate: a gap of 0.3 um, say, does not unload [-]
    sharing_ = pulls_;
    for (std::size_t index = 0; index < count_; ++index) {
      sharing_[index] = excess_[index] <= alike * largest_rate_ ? 1 : 0;
    }
    if ((sharing_ == pulls_ && !redundant_) || !(largest_impulse_ > 0.0)) {
      return;
    }
    const std::vector<double> found = impulse_;
    const std::vector<double> lacking = lacking_;
    for (std::size_t index = 0; index < count_; ++index) {
      lacking_[index] = reaction(index);
    }
    factored_ = factored_ && sharing_ == pulls_;
    pulls_.swap(sharing_);
    solve_for_those_that_pull();
    const double off = 1e-9;  // of the largest: what regularisation leaves [-]
    for (std::size_t index = 0; index < count_; ++index) {
      if (!(impulse_[index] >= -off * largest_impulse_ &&
            std::abs(excess_[index]) <= off * largest_rate_)) {
        impulse_ = found;
        break;
      }
    }
    for (double& impulse : impulse_) {
      impulse = std::max(0.0, impulse);
    }
    factored_ = factored_ && sharing_ == pulls_;
    pulls_.swap(sharing_);  // the next guess
    lacking_ = lacking;
  }

  /// Cables that pull alike leave K singular. With this part more on its diagonal it can be
  /// factored; a refinement takes the part's effect out again, unless the host's numbers are so
  /// coarse that there is nothing to refine; elastic cables have little to yield by [-].
  double regularisation() const { return std::max(1e-10, 8.0 * rounding_); }
  int refinements() const { return rounding_ < 1e-10 || yields_ ? 1 : 0; }
  /// Rates and impulses as small as this part of the largest are zero [-].
  double nothing() const { return std::max(1e-13, rounding_); }

  double k(std::size_t one, std::size_t two) const { return k_[one * count_ + two]; }
  double give_of(std::size_t index) const {
    return rows_[index].softness * rigid_[index] + rows_[index].compliance;
  }

  bool is_wrong(std::size_t index) const {
    return pulls_[index] != 0 ? impulse_[index] < -nothing() * largest_impulse_
                              : excess_[index] < -nothing() * largest_rate_;
  }
  void exchange(std::size_t from, std::size_t to) {
    for (std::size_t index = from; index <= to; ++index) {
      if (is_wrong(index)) {
        pulls_[index] = pulls_[index] != 0 ? 0 : 1;
      }
    }
    factored_ = false;
  }

  void solve_for_those_that_pull() {
    if (!factored_) {
      factor();
    }
    std::fill(impulse_.begin(), impulse_.end(), 0.0);
    for (int done = 0; done <= refinements(); ++done) {
      find_excess();
      right_.resize(active_.size());
      for (std::size_t i = 0; i < active_.size(); ++i) {
        right_[i] = -excess_[active_[i]];
      }
      substitute();
      for (std::size_t i = 0; i < active_.size(); ++i) {
        impulse_[active_[i]] += right_[i];
      }
    }
    find_excess();
    largest_impulse_ = largest_rate_ = 0.0;
    for (std::size_t index = 0; index < count_; ++index) {
      largest_impulse_ = std::max(largest_impulse_, std::abs(impulse_[index]));
      largest_rate_ = std::max(largest_rate_, std::abs(lacking_[index]));
    }
  }

  /// excess = K impulse - lacking
  void find_excess() {
    for (std::size_t one = 0; one < count_; ++one) {
      double sum = -lacking_[one];
      for (std::size_t two = 0; two < count_; ++two) {
        sum += k(one, two) * impulse_[two];
      }
      excess_[one] = sum;
    }
  }

  /// Cholesky's factor of K's rows and columns that pull, from each row's first coupling on.
  void factor() {
    active_.clear();
    for (std::size_t index = 0; index < count_; ++index) {
      if (pulls_[index] != 0 && k(index, index) > 0.0) {
        active_.push_back(index);
      }
    }
    const std::size_t size = active_.size();
    factor_.resize(size * size);
    first_.resize(size);
    redundant_ = false;
    for (std::size_t i = 0; i < size; ++i) {
      std::size_t from = 0;
      while (from < i && k(active_[i], active_[from]) == 0.0) {  // exactly: they share no body
        ++from;
      }
      first_[i] = from;
      for (std::size_t j = from; j <= i; ++j) {
        double sum = k(active_[i], active_[j]) * (i == j ? 1.0 + regularisation() : 1.0);
        for (std::size_t m = std::max(from, first_[j]); m < j; ++m) {
          sum -= factor_[i * size + m] * factor_[j * size + m];
        }
        redundant_ =
            redundant_ || (i == j && sum < 100.0 * regularisation() * k(active_[i], active_[i]));
        const double least = regularisation() * k(active_[i], active_[i]) / 4.0;
        factor_[i * size + j] =
            i == j ? std::sqrt(std::max(sum, least)) : sum / factor_[j * size + j];
      }
    }
    factored_ = true;
  }

  /// right = (factor factor^T)^-1 right
  void substitute() {
    const std::size_t size = active_.size();
    for (std::size_t i = 0; i < size; ++i) {
      for (std::size_t m = first_[i]; m < i; ++m) {
        right_[i] -= factor_[i * size + m] * right_[m];
      }
      right_[i] /= factor_[i * size + i];
    }
    for (std::size_t i = size; i-- > 0;) {
      right_[i] /= factor_[i * size + i];
      for (std::size_t m = first_[i]; m < i; ++m) {
        right_[m] -= factor_[i * size + m] * right_[i];
      }
    }
  }

  double rounding_;
  std::size_t count_ = 0;
  std::vector<Row> rows_;
  std::vector<double> k_;          // K, count x count
  std::vector<double> lacking_;    // [m/s]
  std::vector<double> impulse_;    // [N s]
  std::vector<double> excess_;     // [m/s], K impulse - lacking
  std::vector<double> rigid_;      // its diagonal without softness [1/kg]
  std::vector<char> pulls_of_[2];  // 1: taken to pull
  std::vector<char> pulls_;        // while a solve goes on
  std::vector<char> sharing_;
  std::vector<std::size_t> active_;
  std::vector<std::size_t> first_;  // column of a row's first coupling
  std::vector<double> factor_;
  std::vector<double> right_;
  double largest_impulse_ = 0;
  double largest_rate_ = 0;
  bool yields_ = false;     // a row has a compliance
  bool redundant_ = false;  // the factor is that of a K that is nearly singular
  bool factored_ = false;
  Kind factored_of_ = velocities;
};

}  // namespace tautline
// NOLINTEND(modernize-use-nodiscard)
