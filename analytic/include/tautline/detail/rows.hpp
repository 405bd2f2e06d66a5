#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <optional>
#include <utility>

#include "tautline/case.hpp"
#include "tautline/detail/rounding.hpp"
#include "tautline/geometry.hpp"

namespace tautline {

// A planar body has three degrees of freedom. Its velocity times the root of the mass is a vector
// of three numbers, and each cable a row of them, so that the Delassus matrix is G = A A^T. What
// the cables do to the body is computed from A: G has the square of its condition, and loses twice
// the digits.

/// A row of A, or a velocity times the root of the mass.
template <class Real>
using Vector3 = Eigen::Matrix<Real, 3, 1>;

/// M^1/2 as a diagonal; its last number is 0 for a point mass.
template <class Real>
[[nodiscard]] Vector3<Real> root_of_mass(const BasicBody<Real>& body) {
  const Real root = sqrt(body.mass);
  return {root, root, body.inertia > 0 ? Real(sqrt(body.inertia)) : Real(0)};
}

/// M^-1/2 as a diagonal; its last number is 0 for a point mass.
template <class Real>
[[nodiscard]] Vector3<Real> root_of_inverse_mass(const BasicBody<Real>& body) {
  const Real root = Real(1) / sqrt(body.mass);
  return {root, root, body.inertia > 0 ? Real(Real(1) / sqrt(body.inertia)) : Real(0)};
}

/// The velocity of `state` times the root of the mass.
template <class Real>
[[nodiscard]] Vector3<Real> mass_velocity(const BasicBody<Real>& body,
                                          const BasicState<Real>& state) {
  return Vector3<Real>(state.velocity.x(), state.velocity.y(), state.spin)
      .cwiseProduct(root_of_mass(body));
}

/// `state` after its velocity times the root of the mass has changed by `change`.
template <class Real>
[[nodiscard]] BasicState<Real> with_change(const BasicBody<Real>& body, BasicState<Real> state,
                                           const Vector3<Real>& change) {
  return with_gain(std::move(state),
                   Vector3<Real>(change.cwiseProduct(root_of_inverse_mass(body))));
}

/// The space of up to three independent rows a_i, and their dual vectors k_i in it: k_i . a_j is 1
/// where i = j, else 0. The multipliers that give A^T z = b are z_i = k_i . b.
///
/// By cross products: each number of a k_i then has a rounding error small against the products it
/// is made of, whatever the sizes of the columns. So a body with next to no inertia, whose last
/// column is large, costs no digits.
template <class TheCase>
class RowSpace {
 public:
  using Real = RealOf<TheCase>;

  /// No rows: nothing but zero is in it.
  RowSpace() = default;

  /// The first `size` of `rows`, which are independent.
  RowSpace(const std::array<RowOf<TheCase>, 3>& rows, std::size_t size) : size_(size) {
    if (size_ == 1) {
      dual_[0] = rows[0] / rows[0].squaredNorm();
      per_square_ = Real(1) / dual_[0].squaredNorm();
    } else if (size_ == 2) {
      normal_ = rows[0].cross(rows[1]);
      per_square_ = Real(1) / normal_.squaredNorm();
      dual_[0] = rows[1].cross(normal_) * per_square_;
      dual_[1] = normal_.cross(rows[0]) * per_square_;
    } else if (size_ == 3) {
      const RowOf<TheCase> last = rows[0].cross(rows[1]);
      const Real volume = last.dot(rows[2]);
      dual_[0] = rows[1].cross(rows[2]) / volume;
      dual_[1] = rows[2].cross(rows[0]) / volume;
      dual_[2] = last / volume;
    }
  }

  /// How many rows span it.
  [[nodiscard]] std::size_t size() const { return size_; }

  /// The vector k of the space with k · row(i) = 1 and k · row(j) = 0 for the others.
  [[nodiscard]] const RowOf<TheCase>& dual(std::size_t i) const { return dual_[i]; }

  /// The part of `v` across the space, in each number of which its rounding is small against the
  /// products that it is made of: what the rows leave of a force.
  [[nodiscard]] RowOf<TheCase> across(const RowOf<TheCase>& v) const {
    if (size_ == 1) {
      return dual_[0].cross(v.cross(dual_[0])) * per_square_;
    }
    if (size_ == 2) {
      return normal_ * (normal_.dot(v) * per_square_);
    }
    return size_ == 3 ? RowOf<TheCase>(RowOf<TheCase>::Zero()) : v;
  }

  /// The part of `v` in the space. Its error is rounding of `v`, however near to dependence.
  [[nodiscard]] RowOf<TheCase> part(const RowOf<TheCase>& v) const {
    if (size_ == 1) {
      return dual_[0] * (dual_[0].dot(v) * per_square_);
    }
    if (size_ == 2) {
      return v - normal_ * (normal_.dot(v) * per_square_);
    }
    return size_ == 3 ? v : RowOf<TheCase>(RowOf<TheCase>::Zero());
  }

 private:
  std::size_t size_ = 0;
  std::array<RowOf<TheCase>, 3> dual_{RowOf<TheCase>::Zero(), RowOf<TheCase>::Zero(),
                                      RowOf<TheCase>::Zero()};
  RowOf<TheCase> normal_;      // of the plane of two rows
  Real per_square_ = Real(0);  // of it, or of the dual of one row: 1 / its square
};

/// The part of the velocity of `state`, times the root of the mass, that changes the gaps of
/// `cables`: in the `space` of their rows `basis`.
template <class Real>
[[nodiscard]] Vector3<Real> gap_velocity(const BasicCase<Real>& the_case,
                                         const BasicState<Real>& state, CableSet /*cables*/,
                                         CableSet /*basis*/,
                                         const RowSpace<BasicCase<Real>>& space) {
  return space.part(mass_velocity(the_case.body, state));
}

/// The rows A = J M^-1/2 of `cables`, which know which of them are independent: by their geometry,
/// whatever the masses.
template <class TheCase>
class CableRows {
 public:
  using Real = RealOf<TheCase>;

  /// Of `cables` at the pose of `state`.
  CableRows(const TheCase& the_case, const StateOf<TheCase>& state, CableSet cables)
      : rows_(static_cast<Eigen::Index>(cables.size()), 3), shapes_(rows_.rows(), 3) {
    const RowOf<TheCase> weight = root_of_inverse_mass(the_case.body);
    Eigen::Index row = 0;
    for (const std::size_t index : cables) {
      const RowOf<TheCase> gradient = gap_gradient(the_case.cables[index], state);
      shapes_.row(row) = gradient.transpose();
      rows_.row(row++) = gradient.cwiseProduct(weight).transpose();
    }
    if (cables.size() > 1) {  // one depends on nothing
      make_comparable(the_case, state, cables);
    }
  }

  /// How many freedoms there are.
  [[nodiscard]] static constexpr std::size_t freedoms() { return TheCase::freedoms; }

  /// No change of any of them.
  [[nodiscard]] static RowOf<TheCase> zero() { return RowOf<TheCase>::Zero(); }

  /// A.
  [[nodiscard]] const RowsOf<TheCase>& rows() const { return rows_; }

  /// The gradients with the angle times the longest arm: every column is a length.
  [[nodiscard]] const RowsOf<TheCase>& shapes() const { return shapes_; }

  /// A sine up to this is rounding of zero [-].
  [[nodiscard]] const Real& dependent() const { return dependent_; }

  /// Every row.
  [[nodiscard]] CableSet all() const {
    CableSet result;
    for (Eigen::Index row = 0; row < rows_.rows(); ++row) {
      result.insert(static_cast<std::size_t>(row));
    }
    return result;
  }

  /// True where none of `chosen`, which are rows and not cables, is a sum of the others, beyond
  /// rounding.
  [[nodiscard]] bool independent(CableSet chosen) const {
    if (chosen.size() < 2) {
      return true;
    }
    if (chosen.size() > 3) {
      return false;
    }
    const auto [a, b, c] = vectors(shapes_, chosen);
    const RowOf<TheCase> normal = a.cross(b);
    if (chosen.size() == 2) {
      return normal.norm() > dependent_;
    }
    const Real widest =
        max(Real(normal.norm()), max(Real(b.cross(c).norm()), Real(c.cross(a).norm())));
    return widest > dependent_ && abs(normal.dot(c)) > dependent_ * widest;
  }

  /// That of `chosen`, which are independent.
  [[nodiscard]] RowSpace<TheCase> space(CableSet chosen) const {
    return RowSpace<TheCase>(vectors(rows_, chosen), chosen.size());
  }

  /// As many independent rows as there are: of those left the one that stands out most, while its
  /// sine is above `least` [-] and rounding.
  [[nodiscard]] CableSet most_independent(const Real& least = Real(0)) const {
    CableSet result = CableSet::of(0);
    while (result.size() < 3) {
      const auto [a, b, unused] = vectors(shapes_, result);
      const RowOf<TheCase> normal = a.cross(b);
      Real largest = max(least, dependent_);
      std::optional<std::size_t> best;
      for (Eigen::Index row = 0; row < shapes_.rows(); ++row) {
        const RowOf<TheCase> next = shapes_.row(row).transpose();
        const Real sine = result.size() == 1
                              ? Real(a.cross(next).norm() / (a.norm() * next.norm()))
                              : Real(abs(normal.dot(next)) / (normal.norm() * next.norm()));
        if (sine > largest) {
          largest = sine;
          best = static_cast<std::size_t>(row);
        }
      }
      if (!best) {
        break;
      }
      result.insert(*best);
    }
    return result;
  }

 private:
  using Three = std::array<RowOf<TheCase>, 3>;
  static Three vectors(const RowsOf<TheCase>& rows, CableSet chosen) {
    Three result{RowOf<TheCase>::Zero(), RowOf<TheCase>::Zero(), RowOf<TheCase>::Zero()};
    std::size_t count = 0;
    for (const std::size_t row : chosen) {
      result[count++] = rows.row(static_cast<Eigen::Index>(row)).transpose();
    }
    return result;
  }

  /// Gives the shapes a length as their last column, and their rounding.
  void make_comparable(const TheCase& the_case, const StateOf<TheCase>& state, CableSet cables) {
    Real longest(0);  // [m], of the arms
    Real rounding(0);
    for (const std::size_t index : cables) {
      const CableOf<TheCase>& cable = the_case.cables[index];
      longest = max(longest, Real(cable.attachment.norm()));
      rounding = max(rounding, rounding_of_direction(cable, state));
    }
    dependent_ = rounding_margin * rounding;
    const bool turns = longest > 0 && the_case.body.inertia > 0;
    shapes_.col(2) *= turns ? Real(Real(1) / longest) : Real(0);
  }

  RowsOf<TheCase> rows_;
  RowsOf<TheCase> shapes_;
  Real dependent_ = Real(0);
};

}  // namespace tautline
