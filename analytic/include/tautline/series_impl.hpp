#pragma once

// The recurrences of series.hpp, apart from their declarations. Equation numbers are those of
// analytic/README.md.

#include "tautline/series.hpp"

namespace tautline {
namespace series {

// The two numbers of a point are summed side by side, as a processor does it; even and odd terms
// apart, as it need not wait for itself.

/// Coefficient k of a x b.
template <class Real>
[[nodiscard]] Real cross_product(const Points<Real>& a, const Points<Real>& b, std::size_t k) {
  using Point = BasicVec2<Real>;
  Point even = Point::Zero();
  Point odd = Point::Zero();
  std::size_t j = 0;
  for (; j < k; j += 2) {
    even += a[j].cwiseProduct(b[k - j].reverse());
    odd += a[j + 1].cwiseProduct(b[k - j - 1].reverse());
  }
  if (j == k) {
    even += a[j].cwiseProduct(b[0].reverse());
  }
  return even[0] + odd[0] - even[1] - odd[1];
}

/// Coefficients k of p a, whose values are points, and of p b, without the terms of p[k]; k >= 1.
template <class Real>
[[nodiscard]] Vector3<Real> known_products(std::span<const Real> p, const Points<Real>& a,
                                           std::span<const Real> b, std::size_t k) {
  struct Sums {
    BasicVec2<Real> of_a = BasicVec2<Real>::Zero();
    Real of_b = Real(0);
  };
  const auto add = [&](Sums& sums, std::size_t j) {
    sums.of_a += p[j] * a[k - j];
    sums.of_b += p[j] * b[k - j];
  };
  Sums even;
  Sums odd;
  std::size_t j = 0;
  for (; j + 1 < k; j += 2) {
    add(even, j);
    add(odd, j + 1);
  }
  if (j < k) {
    add(even, j);
  }
  even.of_a += odd.of_a;
  return {even.of_a.x(), even.of_a.y(), even.of_b + odd.of_b};
}

/// Half of coefficient k of a^2; k >= 1.
template <class Real>
[[nodiscard]] Real half_square(const Points<Real>& a, std::size_t k) {
  BasicVec2<Real> pairs = a[0].cwiseProduct(a[k]);
  for (std::size_t j = 1; 2 * j < k; ++j) {
    pairs += a[j].cwiseProduct(a[k - j]);
  }
  return k % 2 == 0 ? Real(pairs.sum() + a[k / 2].squaredNorm() / 2) : Real(pairs.sum());
}

}  // namespace series

template <class Real>
TautSeries<Real>::TautSeries(const BasicCase<Real>& the_case, const BasicState<Real>& start,
                             CableSet taut, std::size_t order)
    : case_(&the_case), taut_(taut), order_(order) {
  start_channels(start);
  couple();
  for (std::size_t k = 0; k + 2 <= order; ++k) {
    expand_motion(k);
  }
  for (std::size_t index = 0; index < case_->cables.size(); ++index) {
    expand_gap(index);
  }
}

/// Makes the channels and sets the coefficients 0 and 1 that the state gives.
template <class Real>
void TautSeries<Real>::start_channels(const BasicState<Real>& start) {
  const std::size_t terms = order_ + 1;
  const std::size_t cables = case_->cables.size();
  constexpr std::size_t more_of_a_taut_cable = 2;
  constexpr std::size_t of_a_cable = 5;  // arm and from are two each
  store_.assign(terms * (6 + of_a_cable * cables + more_of_a_taut_cable * taut_.size()), Real(0));
  Real* next = store_.data();
  const auto make_points = [&](Points<Real>& points) {  // first of all: they are aligned
    points = Points<Real>(next);
    next += 2 * terms;
  };
  const auto make = [&](Channel& channel, std::size_t size) {
    channel = Channel(next, size);
    next += terms;
  };
  make_points(position_);
  make_points(heading_);
  for (std::size_t index = 0; index < cables; ++index) {
    make_points(cables_[index].arm);
    make_points(cables_[index].from);
  }
  make(angle_, terms);
  make(turn_, terms);
  position_[0] = start.position;
  position_[1] = start.velocity;
  heading_[0] = Point(cos(start.angle), sin(start.angle));
  angle_[0] = start.angle;
  set_angle(1, start.spin);
  expand_heading(1);
  for (std::size_t index = 0; index < cables; ++index) {
    CableSeries& cable = cables_[index];
    if (taut_.contains(index)) {
      for (Channel* channel : {&cable.lever, &cable.pull, &cable.tension}) {
        make(*channel, order_ - 1);
      }
    } else {
      make(cable.gap, terms);
    }
    expand_cable(index, 0);
    expand_cable(index, 1);
  }
}

/// The rows whose products are the matrix K_0 of Eq. 23.
template <class Real>
void TautSeries<Real>::couple() {
  weight_ = root_of_inverse_mass(case_->body);
  std::array<Vector3<Real>, 3> rows;
  std::size_t count = 0;
  for (const std::size_t index : taut_) {
    CableSeries& cable = cables_[index];
    cable.lever[0] = cross<Real>(cable.arm[0], cable.from[0]);
    rows[count++] = {cable.from[0].x() * weight_[0], cable.from[0].y() * weight_[1],
                     cable.lever[0] * weight_[2]};
  }
  coupled_ = RowSpace<Real>(rows, count);
}

template <class Real>
void TautSeries<Real>::set_angle(std::size_t k, const Real& value) {
  angle_[k] = value;
  turn_[k] = value * static_cast<double>(k);
}

/// heading' = angle' heading turned by 90 degrees. Coefficient k needs the angle's up to k.
template <class Real>
void TautSeries<Real>::expand_heading(std::size_t k) {
  Point sum = Point::Zero();
  for (std::size_t j = 1; j <= k; ++j) {
    sum += turn_[j] * heading_[k - j];
  }
  heading_[k] = perpendicular<Real>(sum) / static_cast<double>(k);
}

template <class Real>
void TautSeries<Real>::expand_cable(std::size_t index, std::size_t k) {
  const BasicCable<Real>& cable = case_->cables[index];
  CableSeries& series = cables_[index];
  const Point& at = cable.attachment;
  series.arm[k] = at.x() * heading_[k] + at.y() * perpendicular<Real>(heading_[k]);
  series.from[k] = position_[k] + series.arm[k];
  if (k == 0) {
    series.from[0] -= cable.anchor;
  }
}

/// From coefficients up to k + 1 of the pose, the tensions' k and the pose's k + 2 (Eqs. 22-24).
template <class Real>
void TautSeries<Real>::expand_motion(std::size_t k) {
  const double per_second = static_cast<double>((k + 1) * (k + 2));
  // coefficient k of the force over the root of the mass, without the unknown tensions
  Vector3<Real> known = Vector3<Real>::Zero();
  if (k == 0) {
    known.template head<2>() = case_->gravity * sqrt(case_->body.mass);
  } else {
    for (const std::size_t index : taut_) {
      CableSeries& cable = cables_[index];
      cable.lever[k] = series::cross_product<Real>(cable.arm, cable.from, k);
      known -= series::known_products<Real>(cable.pull, cable.from, cable.lever, k)
                   .cwiseProduct(weight_);
    }
  }
  // the heading's coefficient k + 2 but for the angle's, which is still zero
  expand_heading(k + 2);
  // by the cables, to keep their lengths
  Vector3<Real> kept = Vector3<Real>::Zero();
  std::size_t row = 0;
  for (const std::size_t index : taut_) {
    expand_cable(index, k + 2);  // the arm's known part only: the position is still zero, too
    const Real stretch = series::half_square<Real>(cables_[index].from, k + 2);
    kept += Real(per_second * stretch) * coupled_.dual(row++);
  }
  row = 0;
  for (const std::size_t index : taut_) {
    cables_[index].pull[k] = coupled_.dual(row++).dot(known + kept);
  }
  // not the known force less the tensions: of a light body both are large, and cancel
  const Vector3<Real> acceleration = (coupled_.across(known) - kept).cwiseProduct(weight_);
  position_[k + 2] = acceleration.template head<2>() / per_second;
  set_angle(k + 2, acceleration[2] / per_second);
  heading_[k + 2] += angle_[k + 2] * perpendicular<Real>(heading_[0]);
  for (std::size_t index = 0; index < case_->cables.size(); ++index) {
    expand_cable(index, k + 2);
  }
}

template <class Real>
void TautSeries<Real>::expand_gap(std::size_t index) {
  const Real& length = case_->cables[index].length;
  CableSeries& cable = cables_[index];
  if (taut_.contains(index)) {
    for (std::size_t k = 0; k + 2 <= order_; ++k) {
      cable.tension[k] = cable.pull[k] * length;
    }
    return;
  }
  for (std::size_t k = 1; k <= order_; ++k) {
    cable.gap[k] = -series::half_square<Real>(cable.from, k) / length;
  }
  const Point from = cable.from[0];
  cable.gap[0] = (length * length - from.x() * from.x() - from.y() * from.y()) / (2 * length);
}

template <class Real>
Eigen::Matrix<Real, Eigen::Dynamic, 3> TautSeries<Real>::pose() const {
  Eigen::Matrix<Real, Eigen::Dynamic, 3> result(static_cast<Eigen::Index>(order_ + 1), 3);
  for (std::size_t k = 0; k <= order_; ++k) {
    result.row(static_cast<Eigen::Index>(k)) << position_[k].transpose(), angle_[k];
  }
  return result;
}

template <class Real>
std::vector<Real> TautSeries<Real>::height(std::size_t index) const {
  std::vector<Real> result;
  result.reserve(order_ + 1);
  for (std::size_t k = 0; k <= order_; ++k) {
    result.push_back(cables_[index].from[k].y());
  }
  result[0] += case_->cables[index].anchor.y();
  return result;
}

template <class Real>
Real TautSeries<Real>::reach(const Real& error) const {
  Real reach = infinity<Real>();
  const auto limit = [&](const Real& last, const Real& scale, std::size_t k) {
    if (last > 0 && scale > 0) {
      reach = min(reach, Real(pow(Real(error * scale / last), Real(1) / static_cast<double>(k))));
    }
  };
  for (const std::size_t k : {order_ - 1, order_}) {
    Real pose = abs(angle_[k]);  // against a radian and the shortest cable
    for (std::size_t index = 0; index < case_->cables.size(); ++index) {
      const Real& length = case_->cables[index].length;
      pose = max(pose, Real(cables_[index].from[k].cwiseAbs().maxCoeff() / length));
    }
    limit(pose, Real(1), k);
    Real pull(0);
    Real pull_scale = case_->body.mass * case_->gravity.norm();  // a tension may fall to zero
    for (const std::size_t index : taut_) {
      pull = max(pull, Real(abs(cables_[index].tension[k - 2])));
      pull_scale = max(pull_scale, Real(abs(cables_[index].tension[0])));
    }
    limit(pull, pull_scale, k - 2);
  }
  return reach;
}

}  // namespace tautline
