#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <span>
#include <type_traits>
#include <vector>

#include "tautline/case.hpp"
#include "tautline/detail/root_search.hpp"
#include "tautline/detail/rows.hpp"
#include "tautline/geometry.hpp"

namespace tautline {

/// A polynomial of time, given by its coefficients in rising order, for `first_root`. `zeros` says
/// how many of the leading coefficients are zero exactly: they are divided out.
template <class Real>
class Polynomial {
 public:
  explicit Polynomial(std::span<const Real> coefficients, std::size_t zeros = 0)
      : coefficients_(coefficients.subspan(zeros)) {}

  [[nodiscard]] BasicSample<Real> at(const Real& s) const {
    Real value(0);
    Real rate(0);
    Real half_curvature(0);
    Real sixth_jerk(0);
    for (std::size_t k = coefficients_.size(); k-- > 0;) {
      sixth_jerk = sixth_jerk * s + half_curvature;
      half_curvature = half_curvature * s + rate;
      rate = rate * s + value;
      value = value * s + coefficients_[k];
    }
    return {value, rate, 2 * half_curvature, 6 * sixth_jerk};
  }

  /// at(0), of the first coefficients alone.
  [[nodiscard]] BasicSample<Real> at_start() const {
    const auto coefficient = [&](std::size_t k) {
      return k < coefficients_.size() ? coefficients_[k] : Real(0);
    };
    return {coefficient(0), coefficient(1), 2 * coefficient(2), 6 * coefficient(3)};
  }

  /// The fourth derivative's bound on [0, s + w]: the sum of the sizes of its terms.
  [[nodiscard]] Real snap_bound(const Real& s, const Real& window) const {
    const Real end = s + window;
    Real bound(0);
    for (std::size_t k = coefficients_.size(); k-- > 4;) {
      bound = bound * end +
              abs(coefficients_[k]) * static_cast<double>(k * (k - 1) * (k - 2) * (k - 3));
    }
    return bound;
  }

  /// A lower bound of the polynomial on [0, end]: positive means that it has no root there.
  [[nodiscard]] Real least(const Real& end) const {
    Real change(0);
    for (std::size_t k = coefficients_.size(); k-- > 1;) {
      change = change * end + min(Real(0), coefficients_[k]);
    }
    return coefficients_.empty() ? Real(0) : Real(coefficients_.front() + change * end);
  }

 private:
  std::span<const Real> coefficients_;
};

/// `first_root`, without a search where a bound says that there is no root.
template <class Real>
[[nodiscard]] BasicRootSearch<Real> first_root_if_any(const Polynomial<Real>& f,
                                                      const Real& horizon) {
  return f.least(horizon) > 0 ? BasicRootSearch<Real>{} : first_root(f, horizon);
}

/// Points of D dimensions one after the other among numbers that another owns.
template <class Real, int D = 2>
class Points {
 public:
  /// An array of numbers that have to be destroyed begins with how many there are.
  static constexpr int alignment =
      std::is_trivially_destructible_v<Real> ? Eigen::Aligned16 : Eigen::Unaligned;
  /// How many numbers a point takes: doubles are kept in pairs.
  static constexpr std::size_t stride =
      D == 3 && std::is_trivially_destructible_v<Real> ? 4 : static_cast<std::size_t>(D);
  using Point = Eigen::Map<Eigen::Matrix<Real, D, 1>, alignment>;

  Points() = default;
  explicit Points(Real* first) : first_(first) {}
  [[nodiscard]] Point operator[](std::size_t k) const { return Point(first_ + stride * k); }
  [[nodiscard]] const Real* data() const { return first_; }
  /// The numbers of point k.
  [[nodiscard]] const Real* data(std::size_t k) const { return first_ + stride * k; }

 private:
  Real* first_ = nullptr;
};

/// The motion from `start` with the cables of `taut` held at zero gap, as Taylor series in the time
/// since then (analytic/README.md section 6). The rows of `taut` are independent, their gaps and
/// gap rates zero. With an empty set it is free flight. The library has the definitions for double;
/// those for another scalar are in series_impl.hpp.
template <class Real>
class TautSeries {
 public:
  /// Series up to t^order, order >= 2.
  TautSeries(const BasicCase<Real>& the_case, const BasicState<Real>& start, CableSet taut,
             std::size_t order);
  TautSeries(TautSeries&&) noexcept = default;
  TautSeries& operator=(TautSeries&&) noexcept = default;
  TautSeries(const TautSeries&) = delete;  // its channels point into its own store
  TautSeries& operator=(const TautSeries&) = delete;
  ~TautSeries() = default;

  [[nodiscard]] CableSet taut() const { return taut_; }

  /// Coefficients 0 to order.
  [[nodiscard]] BasicVec2<Real> position(std::size_t k) const { return position_[k]; }
  [[nodiscard]] std::span<const Real> angle() const { return angle_; }
  /// Of both, one row a coefficient.
  [[nodiscard]] Eigen::Matrix<Real, Eigen::Dynamic, 3> pose() const;

  /// Coefficients 0 to order of (length^2 - distance^2) / (2 length) [m], Eq. 11.
  [[nodiscard]] std::span<const Real> gap(std::size_t index) const { return cables_[index].gap; }

  /// Coefficients 0 to order - 2 of the tension [N] of a taut cable.
  [[nodiscard]] std::span<const Real> tension(std::size_t index) const {
    return cables_[index].tension;
  }

  /// Coefficients 0 to order - 2 of (arm x from-anchor) [m^2] of a taut cable.
  [[nodiscard]] std::vector<Real> lever(std::size_t index) const;

  /// Coefficients 0 to order of the attachment's height [m].
  [[nodiscard]] std::vector<Real> height(std::size_t index) const;

  /// True while every coefficient is finite.
  [[nodiscard]] bool fits() const;

  /// How long [s] the series keep their last terms below `error` [-] of lengths and tensions.
  [[nodiscard]] Real reach(const Real& error) const;

 private:
  using Point = BasicVec2<Real>;
  using Channel = std::span<Real>;  // of coefficients, in store_
  struct CableSeries {
    Points<Real> from;  // anchor to attachment [m]
    Channel gap;        // of a slack cable
    Channel tension;    // of a taut one
  };
  struct HeldCable {    // a taut one, by its row
    Point at;           // its attachment
    Points<Real> from;  // as above
    Points<Real> pull;  // tension / length [N/m], twice
    Point leverage;     // moment of a pull of 1 N/m at the start, in the body's axes [m^2]
  };

  void make_channels();
  void start_at(const BasicState<Real>& start);
  void couple();

  void set_angle(std::size_t k, const Real& value);
  [[nodiscard]] Point turned(std::size_t k) const;
  template <std::size_t held>
  void expand_motion();
  template <std::size_t held>
  void expand_motion(std::size_t k);
  void expand_gap(std::size_t index);

  const BasicCase<Real>* case_;
  CableSet taut_;
  std::size_t order_;
  std::unique_ptr<Real[]> store_;
  Points<Real> position_;
  Points<Real> heading_;  // cosine and sine of the angle
  Points<Real> turn_;     // k times the angle's coefficient k, twice
  Points<Real> moment_;   // of all pulls, in the body's axes: heading . moment is the torque [N m]
  Channel angle_;
  std::array<CableSeries, max_cables> cables_;
  std::array<HeldCable, 3> held_;
  Vector3<Real> weight_;               // M^-1/2
  RowSpace<BasicCase<Real>> coupled_;  // of the rows L a of the taut cables (Eq. 23)
};

/// The response of cable `index`, the only one that pulls along `motion`, to an impulse of its own,
/// times its length squared [m^2/kg], the rate of that [m^2/(kg s)], and its length [m].
template <class Real>
[[nodiscard]] std::array<Real, 3> scaled_response(const BasicCase<Real>& the_case,
                                                  const BasicState<Real>& /*start*/,
                                                  const TautSeries<Real>& motion,
                                                  std::size_t index) {
  const Real& length = the_case.cables[index].length;
  const auto lever = motion.lever(index);
  const Vector3<Real> weight = inverse_mass(the_case.body);
  return {Real(length * length * weight[0] + lever[0] * lever[0] * weight[2]),
          Real(2 * lever[0] * lever[1] * weight[2]), length};
}

}  // namespace tautline
