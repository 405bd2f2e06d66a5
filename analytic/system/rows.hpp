#pragma once

#include <Eigen/Core>
#include <Eigen/QR>
#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

#include "system/sizes.hpp"
#include "tautline/detail/rows.hpp"
#include "tautline/system_geometry.hpp"

namespace tautline {

/// M^1/2 as a diagonal; 0 for the turn of a point mass.
template <class Real, int D>
[[nodiscard]] RowOf<BasicSystem<Real, D>> root_of_mass(
    const std::vector<BasicBodyOfSystem<Real, D>>& bodies) {
  return masses(bodies, [](const Real& mass) { return Real(sqrt(mass)); });
}

/// M^-1/2 as a diagonal; 0 for the turn of a point mass.
template <class Real, int D>
[[nodiscard]] RowOf<BasicSystem<Real, D>> root_of_inverse_mass(
    const std::vector<BasicBodyOfSystem<Real, D>>& bodies) {
  return masses(bodies, [](const Real& mass) { return Real(Real(1) / sqrt(mass)); });
}

/// The velocities of `state` times the root of the mass.
template <class Real, int D>
[[nodiscard]] RowOf<BasicSystem<Real, D>> mass_velocity(
    const std::vector<BasicBodyOfSystem<Real, D>>& bodies, const BasicSystemState<Real, D>& state) {
  RowOf<BasicSystem<Real, D>> result = root_of_mass(bodies);
  Eigen::Index row = 0;
  for (const auto& body : state.bodies) {
    result.template segment<D>(row) = result[row] * body.velocity;
    auto turning = result.template segment<spins<D>>(row + D);
    turning = turning.cwiseProduct(spin_of(body)).eval();
    row += freedoms_of_body<D>;
  }
  return result;
}

/// `state` after its velocities times the root of the mass have changed by `change`.
template <class Real, int D>
[[nodiscard]] BasicSystemState<Real, D> with_change(
    const std::vector<BasicBodyOfSystem<Real, D>>& bodies, BasicSystemState<Real, D> state,
    const std::type_identity_t<RowOf<BasicSystem<Real, D>>>& change) {
  return with_gain(std::move(state), change.cwiseProduct(root_of_inverse_mass(bodies)).eval());
}

/// A Householder QR of the columns A^T of independent rows. The freedoms are sorted by their
/// largest number, and the columns pivoted: then the error of each number is small against those of
/// its freedom, and a light body, whose columns are large, costs no digits.
template <class Real>
class SortedQr {
 public:
  using Matrix = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>;

  explicit SortedQr(const Matrix& columns)
      : order_(static_cast<std::size_t>(columns.rows())),
        column_(static_cast<std::size_t>(columns.cols())) {
    std::iota(order_.begin(), order_.end(), 0);
    const Eigen::Matrix<Real, Eigen::Dynamic, 1> size = columns.cwiseAbs().rowwise().maxCoeff();
    std::stable_sort(order_.begin(), order_.end(),
                     [&](Eigen::Index a, Eigen::Index b) { return size[a] > size[b]; });
    work_ = columns(order_, Eigen::all);
    std::iota(column_.begin(), column_.end(), 0);
    scale_.resize(column_.size());
    diagonal_.resize(column_.size());
    for (Eigen::Index k = 0; k < work_.cols(); ++k) {
      reflect(k);
    }
  }

  /// The vectors k_i, one a column, with k_i . a_j = 1 where i = j, else 0.
  [[nodiscard]] Matrix duals() const {
    const Eigen::Index count = work_.cols();
    Matrix result = Matrix::Zero(work_.rows(), count);
    for (Eigen::Index c = 0; c < count; ++c) {  // R^T z = unit vector c, R^T lower triangular
      for (Eigen::Index i = c; i < count; ++i) {
        Real sum(i == c ? 1 : 0);
        for (Eigen::Index j = c; j < i; ++j) {
          sum -= work_(j, i) * result(j, column_of(c));
        }
        result(i, column_of(c)) = sum / diagonal_[static_cast<std::size_t>(i)];
      }
    }
    return turned_back(std::move(result));
  }

  /// An orthonormal basis, one vector a column: first of the space of the rows, then of the rest.
  [[nodiscard]] Matrix basis() const {
    return turned_back(Matrix::Identity(work_.rows(), work_.rows()));
  }

 private:
  [[nodiscard]] Eigen::Index column_of(Eigen::Index c) const {
    return column_[static_cast<std::size_t>(c)];
  }

  /// Step k: the largest column left becomes zero below its number k.
  void reflect(Eigen::Index k) {
    const Eigen::Index rows = work_.rows() - k;
    Eigen::Index largest = 0;
    work_.bottomRightCorner(rows, work_.cols() - k).colwise().squaredNorm().maxCoeff(&largest);
    work_.col(k).swap(work_.col(k + largest));
    const auto at = static_cast<std::size_t>(k);
    std::swap(column_[at], column_[at + static_cast<std::size_t>(largest)]);
    auto v = work_.col(k).tail(rows);
    const Real size = v.norm();
    diagonal_[at] = v[0] > 0 ? Real(-size) : size;
    v[0] -= diagonal_[at];
    const Real square = v.squaredNorm();
    scale_[at] = square > 0 ? Real(2 / square) : Real(0);
    for (Eigen::Index c = k + 1; c < work_.cols(); ++c) {
      auto other = work_.col(c).tail(rows);
      const Real part = scale_[at] * v.dot(other);
      other -= part * v;
    }
  }

  /// Q x, in the given order of the freedoms.
  [[nodiscard]] Matrix turned_back(Matrix x) const {
    for (Eigen::Index k = work_.cols(); k-- > 0;) {
      const auto v = work_.col(k).tail(work_.rows() - k);
      for (Eigen::Index c = 0; c < x.cols(); ++c) {
        auto part = x.col(c).tail(work_.rows() - k);
        const Real along = scale_[static_cast<std::size_t>(k)] * v.dot(part);
        part -= along * v;
      }
    }
    Matrix result(x.rows(), x.cols());
    result(order_, Eigen::all) = x;
    return result;
  }

  std::vector<Eigen::Index> order_;   // of the freedoms
  std::vector<Eigen::Index> column_;  // of A^T, in the order of the steps
  Matrix work_;                       // reflectors below, R above the diagonal
  std::vector<Real> scale_;           // of each reflector, 2 / its square
  std::vector<Real> diagonal_;        // of R
};

/// Rows as wide as the freedoms of a system.
template <class Real, int D>
class RowSpace<BasicSystem<Real, D>> {
 public:
  using Row = RowOf<BasicSystem<Real, D>>;
  using Matrix = typename SortedQr<Real>::Matrix;

  /// No rows: nothing but zero is in it.
  RowSpace() = default;

  /// Spanned by independent `rows`.
  explicit RowSpace(const RowsOf<BasicSystem<Real, D>>& rows)
      : size_(static_cast<std::size_t>(rows.rows())) {
    if (size_ == 1) {
      duals_ = rows.transpose() / rows.squaredNorm();
      per_square_ = Real(1) / duals_.squaredNorm();
    } else if (size_ > 1) {
      const SortedQr<Real> qr{Matrix(rows.transpose())};
      duals_ = qr.duals();
      basis_ = qr.basis();
    }
  }

  [[nodiscard]] std::size_t size() const { return size_; }  // how many rows span it

  /// The vector k of the space with k · row(i) = 1 and k · row(j) = 0 for the others.
  [[nodiscard]] Row dual(std::size_t i) const { return duals_.col(static_cast<Eigen::Index>(i)); }

  /// The part of `v` across the space. The rounding of each number is small against its products.
  [[nodiscard]] Row across(const Row& v) const {
    if (size_ == 0) {
      return v;
    }
    if (size_ == 1) {
      return across_one(v);
    }
    const auto rest = basis_.rightCols(basis_.cols() - static_cast<Eigen::Index>(size_));
    return rest * Row(rest.transpose() * v);
  }

  /// The part of `v` in the space. Its error is rounding of `v`, however near to dependence.
  [[nodiscard]] Row part(const Row& v) const {
    if (size_ == 0) {
      return Row::Zero(v.size());
    }
    if (size_ == 1) {
      return duals_.col(0) * Real(duals_.col(0).dot(v) * per_square_);
    }
    const auto space = basis_.leftCols(static_cast<Eigen::Index>(size_));
    return space * Row(space.transpose() * v);
  }

 private:
  /// By the differences k_j v_i - k_i v_j, as a double cross product in the plane.
  [[nodiscard]] Row across_one(const Row& v) const {
    Row result = Row::Zero(v.size());
    for (Eigen::Index i = 0; i < v.size(); ++i) {
      const Real& own = duals_(i, 0);
      Real sum(0);
      for (Eigen::Index j = 0; j < v.size(); ++j) {
        sum += duals_(j, 0) * (duals_(j, 0) * v[i] - own * v[j]);
      }
      result[i] = own == 0 ? v[i] : Real(sum * per_square_);
    }
    return result;
  }

  std::size_t size_ = 0;
  Matrix duals_;
  Matrix basis_;               // of two rows or more
  Real per_square_ = Real(0);  // of the dual of one row: 1 / its square
};

/// The rows A = J M^-1/2 of the cables of a system.
template <class Real, int D>
class CableRows<BasicSystem<Real, D>> {
 public:
  using TheCase = BasicSystem<Real, D>;

  /// Takes `cables` at the poses of `state`.
  CableRows(const TheCase& system, const BasicSystemState<Real, D>& state, CableSet cables) {
    const auto width = static_cast<Eigen::Index>(freedoms_of(system));
    rows_.resize(static_cast<Eigen::Index>(cables.size()), width);
    shapes_.resize(rows_.rows(), width);
    const RowOf<TheCase> weight = root_of_inverse_mass(system.bodies);
    const RowOf<TheCase> comparable = lengths(system);
    Eigen::Index row = 0;
    for (const std::size_t index : cables) {
      const RowOf<TheCase> gradient = gap_gradient(system.cables[index], state);
      shapes_.row(row) = gradient.cwiseProduct(comparable).transpose();
      rows_.row(row++) = gradient.cwiseProduct(weight).transpose();
      dependent_ = max(dependent_,
                       Real(rounding_margin * rounding_of_direction(system.cables[index], state)));
    }
  }

  [[nodiscard]] std::size_t freedoms() const { return static_cast<std::size_t>(rows_.cols()); }
  [[nodiscard]] RowOf<TheCase> zero() const { return RowOf<TheCase>::Zero(rows_.cols()); }
  [[nodiscard]] const RowsOf<TheCase>& rows() const { return rows_; }  // A

  /// The gradients with angles times the longest arm of their body, in coordinates of the space
  /// that they span.
  [[nodiscard]] BasicCableMatrix<Real> shapes() const {
    using Matrix = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>;
    const Eigen::HouseholderQR<Matrix> qr{Matrix(shapes_.transpose())};
    const Eigen::Index count = std::min(shapes_.rows(), shapes_.cols());
    const Matrix upper = qr.matrixQR().topRows(count).template triangularView<Eigen::Upper>();
    return upper.transpose();
  }

  [[nodiscard]] const Real& dependent() const { return dependent_; }  // a sine that is zero [-]

  [[nodiscard]] CableSet all() const {
    return CableSet::first(static_cast<std::size_t>(rows_.rows()));
  }

  /// True where none of `chosen`, which are rows and not cables, is a sum of the others, beyond
  /// rounding.
  [[nodiscard]] bool independent(CableSet chosen) const {
    if (chosen.size() < 2) {
      return true;
    }
    return chosen.size() <= freedoms() && standing_out(chosen, Real(0)) == chosen;
  }

  /// The space of `chosen`, which are independent.
  [[nodiscard]] RowSpace<TheCase> space(CableSet chosen) const {
    RowsOf<TheCase> result(static_cast<Eigen::Index>(chosen.size()), rows_.cols());
    Eigen::Index i = 0;
    for (const std::size_t row : chosen) {
      result.row(i++) = rows_.row(static_cast<Eigen::Index>(row));
    }
    return RowSpace<TheCase>(result);
  }

  /// As many independent rows as there are: of those left the one that stands out most, while its
  /// sine is above `least` [-] and rounding.
  [[nodiscard]] CableSet most_independent(const Real& least = Real(0)) const {
    return standing_out(all(), least);
  }

 private:
  /// By what each freedom of a gradient becomes a length.
  [[nodiscard]] static RowOf<TheCase> lengths(const TheCase& system) {
    RowOf<TheCase> result(static_cast<Eigen::Index>(freedoms_of(system)));
    for (std::size_t i = 0; i < system.bodies.size(); ++i) {
      const Eigen::Index first = static_cast<Eigen::Index>(i) * freedoms_of_body<D>;
      const Real arm = longest_arm(system, i);
      const bool turns = arm > 0 && has_inertia(system.bodies[i].inertia);
      result.template segment<D>(first).setOnes();
      result.template segment<spins<D>>(first + D).setConstant(turns ? Real(Real(1) / arm)
                                                                     : Real(0));
    }
    return result;
  }

  /// Those of `chosen` that Gram and Schmidt take in, beginning with the first.
  [[nodiscard]] CableSet standing_out(CableSet chosen, const Real& least) const {
    RowsOf<TheCase> left = shapes_.rowwise().normalized();
    CableSet result;
    std::size_t next = *chosen.begin();
    while (true) {
      result.insert(next);
      chosen.erase(next);
      const auto row = static_cast<Eigen::Index>(next);
      const RowOf<TheCase> direction = left.row(row).transpose().normalized();
      Real largest = max(least, dependent_);
      bool found = false;
      for (const std::size_t other : chosen) {
        auto part = left.row(static_cast<Eigen::Index>(other));
        part -= Real(part.dot(direction.transpose())) * direction.transpose();
        if (const Real sine = part.norm(); sine > largest) {
          largest = sine;
          next = other;
          found = true;
        }
      }
      if (!found) {
        return result;
      }
    }
  }

  RowsOf<TheCase> rows_;
  RowsOf<TheCase> shapes_;  // as `shapes`, in all freedoms
  Real dependent_ = Real(0);
};

/// The part of the velocities of `state`, times the root of the mass, that changes the gaps of
/// `cables`: in the `space` of their rows `basis`, with what moving ends and lengths add.
template <class Real, int D>
[[nodiscard]] RowOf<BasicSystem<Real, D>> gap_velocity(
    const BasicSystem<Real, D>& system, const BasicSystemState<Real, D>& state, CableSet cables,
    CableSet basis, const RowSpace<BasicSystem<Real, D>>& space) {
  RowOf<BasicSystem<Real, D>> result = space.part(mass_velocity(system.bodies, state));
  if (!is_driven(system, state)) {
    return result;
  }
  const BasicSystemState<Real, D> still = standing_still(state);
  std::size_t row = 0;
  std::size_t i = 0;
  for (const std::size_t index : cables) {
    if (basis.contains(row++)) {
      result += gap_rate(system.cables[index], still) * space.dual(i++);
    }
  }
  return result;
}

}  // namespace tautline
