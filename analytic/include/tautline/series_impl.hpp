#pragma once

// The recurrences of series.hpp, apart from their declarations. Equation numbers are those of
// analytic/README.md.

#include "tautline/series.hpp"

namespace tautline {
namespace series {

// Several sums share a loop: a processor adds them side by side.

/// Coefficient k of a b - c d.
template <class Real>
[[nodiscard]] Real cross_product(std::span<const Real> a, std::span<const Real> b,
                                 std::span<const Real> c, std::span<const Real> d, std::size_t k) {
  std::array<Real, 2> even{Real(0), Real(0)};
  std::array<Real, 2> odd = even;
  const auto add = [&](std::array<Real, 2>& sums, std::size_t j) {
    sums[0] += a[j] * b[k - j];
    sums[1] += c[j] * d[k - j];
  };
  std::size_t j = 0;
  for (; j < k; j += 2) {
    add(even, j);
    add(odd, j + 1);
  }
  if (j == k) {
    add(even, j);
  }
  return even[0] + odd[0] - even[1] - odd[1];
}

/// Coefficients k of p a, p b and p c, without the terms of p[k]; k >= 1.
template <class Real>
[[nodiscard]] std::array<Real, 3> known_products(std::span<const Real> p, std::span<const Real> a,
                                                 std::span<const Real> b, std::span<const Real> c,
                                                 std::size_t k) {
  using Sums = std::array<Real, 3>;
  const auto add = [&](Sums& sums, std::size_t j) {
    sums[0] += p[j] * a[k - j];
    sums[1] += p[j] * b[k - j];
    sums[2] += p[j] * c[k - j];
  };
  Sums even{Real(0), Real(0), Real(0)};
  Sums odd = even;
  std::size_t j = 0;
  for (; j + 1 < k; j += 2) {
    add(even, j);
    add(odd, j + 1);
  }
  if (j < k) {
    add(even, j);
  }
  return {even[0] + odd[0], even[1] + odd[1], even[2] + odd[2]};
}

/// Half of coefficient k of a^2 + b^2; k >= 1.
template <class Real>
[[nodiscard]] Real half_square(std::span<const Real> a, std::span<const Real> b, std::size_t k) {
  Real of_a = a[0] * a[k];
  Real of_b = b[0] * b[k];
  for (std::size_t j = 1; 2 * j < k; ++j) {
    of_a += a[j] * a[k - j];
    of_b += b[j] * b[k - j];
  }
  const std::size_t middle = k / 2;
  return k % 2 == 0 ? Real(of_a + of_b + (a[middle] * a[middle] + b[middle] * b[middle]) / 2)
                    : Real(of_a + of_b);
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
  constexpr std::size_t of_a_slack_cable = 5;
  constexpr std::size_t more_of_a_taut_one = 2;
  store_.assign(
      terms * (5 + of_a_slack_cable * case_->cables.size() + more_of_a_taut_one * taut_.size()),
      Real(0));
  Real* next = store_.data();
  const auto make = [&](Channel& channel, std::size_t size) {
    channel = Channel(next, size);
    next += terms;
  };
  for (Channel* channel : {&x_, &y_, &angle_, &sine_, &cosine_}) {
    make(*channel, terms);
  }
  x_[0] = start.position.x();
  y_[0] = start.position.y();
  angle_[0] = start.angle;
  x_[1] = start.velocity.x();
  y_[1] = start.velocity.y();
  angle_[1] = start.spin;
  sine_[0] = sin(start.angle);
  cosine_[0] = cos(start.angle);
  expand_trigonometry(1);
  for (std::size_t index = 0; index < case_->cables.size(); ++index) {
    CableSeries& cable = cables_[index];
    for (Channel* channel : {&cable.arm_x, &cable.arm_y, &cable.from_x, &cable.from_y}) {
      make(*channel, terms);
    }
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
    cable.lever[0] = cable.arm_x[0] * cable.from_y[0] - cable.arm_y[0] * cable.from_x[0];
    rows[count++] = {cable.from_x[0] * weight_[0], cable.from_y[0] * weight_[1],
                     cable.lever[0] * weight_[2]};
  }
  coupled_ = RowSpace<Real>(rows, count);
}

/// sin' = angle' cos, cos' = -angle' sin. Coefficient k needs the angle's up to k.
template <class Real>
void TautSeries<Real>::expand_trigonometry(std::size_t k) {
  Real sine(0);
  Real cosine(0);
  for (std::size_t j = 1; j <= k; ++j) {
    const Real turn = angle_[j] * static_cast<double>(j);
    sine += turn * cosine_[k - j];
    cosine -= turn * sine_[k - j];
  }
  sine_[k] = sine / static_cast<double>(k);
  cosine_[k] = cosine / static_cast<double>(k);
}

template <class Real>
void TautSeries<Real>::expand_cable(std::size_t index, std::size_t k) {
  const BasicCable<Real>& cable = case_->cables[index];
  CableSeries& series = cables_[index];
  const auto& p = cable.attachment;
  series.arm_x[k] = p.x() * cosine_[k] - p.y() * sine_[k];
  series.arm_y[k] = p.x() * sine_[k] + p.y() * cosine_[k];
  series.from_x[k] = x_[k] + series.arm_x[k];
  series.from_y[k] = y_[k] + series.arm_y[k];
  if (k == 0) {
    series.from_x[0] -= cable.anchor.x();
    series.from_y[0] -= cable.anchor.y();
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
      cable.lever[k] =
          series::cross_product<Real>(cable.arm_x, cable.from_y, cable.arm_y, cable.from_x, k);
      const auto [along_x, along_y, turning] =
          series::known_products<Real>(cable.pull, cable.from_x, cable.from_y, cable.lever, k);
      known -= Vector3<Real>(along_x, along_y, turning).cwiseProduct(weight_);
    }
  }
  // sine and cosine of order k + 2 but for the angle's coefficient k + 2, which is still zero
  expand_trigonometry(k + 2);
  // by the cables, to keep their lengths
  Vector3<Real> kept = Vector3<Real>::Zero();
  std::size_t row = 0;
  for (const std::size_t index : taut_) {
    expand_cable(index, k + 2);  // the arm's known part only: x and y are still zero, too
    const CableSeries& cable = cables_[index];
    const Real stretch = series::half_square<Real>(cable.from_x, cable.from_y, k + 2);
    kept += Real(per_second * stretch) * coupled_.dual(row++);
  }
  row = 0;
  for (const std::size_t index : taut_) {
    cables_[index].pull[k] = coupled_.dual(row++).dot(known + kept);
  }
  // not the known force less the tensions: of a light body both are large, and cancel
  const Vector3<Real> acceleration = (coupled_.across(known) - kept).cwiseProduct(weight_);
  x_[k + 2] = acceleration[0] / per_second;
  y_[k + 2] = acceleration[1] / per_second;
  angle_[k + 2] = acceleration[2] / per_second;
  sine_[k + 2] += cosine_[0] * angle_[k + 2];
  cosine_[k + 2] -= sine_[0] * angle_[k + 2];
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
    cable.gap[k] = -series::half_square<Real>(cable.from_x, cable.from_y, k) / length;
  }
  cable.gap[0] =
      (length * length - cable.from_x[0] * cable.from_x[0] - cable.from_y[0] * cable.from_y[0]) /
      (2 * length);
}

template <class Real>
std::vector<Real> TautSeries<Real>::height(std::size_t index) const {
  const Channel from_y = cables_[index].from_y;
  std::vector<Real> result(from_y.begin(), from_y.end());
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
      const CableSeries& cable = cables_[index];
      pose = max(pose, Real(max(abs(cable.from_x[k]), abs(cable.from_y[k])) / length));
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
