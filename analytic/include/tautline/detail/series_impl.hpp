#pragma once

// The recurrences of series.hpp, apart from their declarations. Equation numbers are those of
// analytic/README.md.

#include "tautline/detail/series.hpp"

namespace tautline {
namespace series {

// Every product of series is one of points, number by number, as a processor multiplies two numbers
// at a time; a series of single numbers that takes part is kept as points of the same number twice.

/// Two numbers, multiplied and added each by itself; doubles by one instruction for both, where a
/// processor has it.
template <class Real>
struct SideBySide {
  using Numbers = Eigen::Array<Real, 2, 1>;
  [[nodiscard]] static Numbers zero() { return Numbers::Zero(); }
  [[nodiscard]] static Numbers at(const Real* first) { return {first[0], first[1]}; }
};
template <>
struct SideBySide<double> {
  using Numbers [[gnu::vector_size(16)]] = double;
  [[nodiscard]] static Numbers zero() { return Numbers{}; }
  [[nodiscard]] static Numbers at(const double* first) { return Numbers{first[0], first[1]}; }
};

/// The sum of a[j] b[k - j] over j from `first` up to `end`, four terms at a time. Every other one
/// is summed apart, as a processor need not wait for itself then.
template <class Real>
[[nodiscard, gnu::always_inline]] inline BasicVec2<Real> products(const Points<Real>& a,
                                                                  const Points<Real>& b,
                                                                  std::size_t k, std::size_t first,
                                                                  std::size_t end) {
  using Two = SideBySide<Real>;
  auto even = Two::zero();
  auto odd = Two::zero();
  const Real* rising = a.data() + 2 * first;
  const Real* falling = b.data() + 2 * (k - first);
  const auto add_two = [&] {
    even += Two::at(rising) * Two::at(falling);
    odd += Two::at(rising + 2) * Two::at(falling - 2);
    rising += 4;
    falling -= 4;
  };
  std::size_t left = end - first;
  for (; left >= 4; left -= 4) {
    add_two();
    add_two();
  }
  if (left >= 2) {
    add_two();
  }
  if (left % 2 == 1) {
    even += Two::at(rising) * Two::at(falling);
  }
  even += odd;
  return {even[0], even[1]};
}

/// A sum of products of points of three or four numbers, number by number; of doubles in pairs.
template <class Real, int D>
class SumOfProducts {
 public:
  void add(const Real* a, const Real* b) {
    for (Eigen::Index i = 0; i < D; ++i) {
      sum_[i] += a[i] * b[i];
    }
  }
  void subtract(const Real* a, const Real* b) {
    for (Eigen::Index i = 0; i < D; ++i) {
      sum_[i] -= a[i] * b[i];
    }
  }
  void add_times(const Real& factor, const Real* a) {
    for (Eigen::Index i = 0; i < D; ++i) {
      sum_[i] += factor * a[i];
    }
  }
  [[nodiscard]] Eigen::Matrix<Real, D, 1> point() const { return sum_; }

 private:
  Eigen::Matrix<Real, D, 1> sum_ = Eigen::Matrix<Real, D, 1>::Zero();
};
template <int D>
class SumOfProducts<double, D> {
 public:
  void add(const double* a, const double* b) {
    low_ += Two::at(a) * Two::at(b);
    high_ += Two::at(a + 2) * Two::at(b + 2);
  }
  void subtract(const double* a, const double* b) {
    low_ -= Two::at(a) * Two::at(b);
    high_ -= Two::at(a + 2) * Two::at(b + 2);
  }
  void add_times(double factor, const double* a) {
    low_ += factor * Two::at(a);
    high_ += factor * Two::at(a + 2);
  }
  [[nodiscard]] Eigen::Matrix<double, D, 1> point() const {
    if constexpr (D == 3) {
      return {low_[0], low_[1], high_[0]};
    } else {
      return {low_[0], low_[1], high_[0], high_[1]};
    }
  }

 private:
  using Two = SideBySide<double>;
  typename Two::Numbers low_ = Two::zero();
  typename Two::Numbers high_ = Two::zero();
};

/// The sum of a[j] b[k - j] over j from `first` up to `end`, in space.
template <class Real>
[[nodiscard]] Eigen::Matrix<Real, 3, 1> products(const Points<Real, 3>& a, const Points<Real, 3>& b,
                                                 std::size_t k, std::size_t first,
                                                 std::size_t end) {
  SumOfProducts<Real, 3> even;
  SumOfProducts<Real, 3> odd;
  std::size_t j = first;
  for (; j + 1 < end; j += 2) {
    even.add(a.data(j), b.data(k - j));
    odd.add(a.data(j + 1), b.data(k - j - 1));
  }
  if (j < end) {
    even.add(a.data(j), b.data(k - j));
  }
  return even.point() + odd.point();
}

/// A small number as one to count with.
[[nodiscard]] inline double number(std::size_t k) {
  return static_cast<double>(static_cast<int>(k));
}

/// Half of coefficient k of a^2; k >= 1.
template <class Real, int D>
[[nodiscard, gnu::always_inline]] inline Real half_square(const Points<Real, D>& a, std::size_t k) {
  const Eigen::Matrix<Real, D, 1> pairs = products(a, a, k, 0, (k + 1) / 2);
  return k % 2 == 0 ? Real(pairs.sum() + a[k / 2].squaredNorm() / 2) : Real(pairs.sum());
}

/// `at`, in the body's axes, seen in the world by a body whose own first axis is `heading`.
template <class Real>
[[nodiscard, gnu::always_inline]] inline BasicVec2<Real> in_the_world(
    const BasicVec2<Real>& at, const BasicVec2<Real>& heading) {
  return at.x() * heading + at.y() * perpendicular<Real>(heading);
}

/// The moment of a `force` at `at` is that of two numbers, along and across: heading . moment.
template <class Real>
[[nodiscard]] BasicVec2<Real> moment(const BasicVec2<Real>& at, const BasicVec2<Real>& force) {
  return {cross<Real>(at, force), -at.dot(force)};
}

}  // namespace series

template <class Real>
TautSeries<Real>::TautSeries(const BasicCase<Real>& the_case, const BasicState<Real>& start,
                             CableSet taut, std::size_t order)
    : case_(&the_case), taut_(taut), order_(order) {
  make_channels();
  start_at(start);
  couple();
  switch (taut_.size()) {  // their loops are short: a compiler shall know how often they go round
    case 0:
      expand_motion<0>();
      break;
    case 1:
      expand_motion<1>();
      break;
    case 2:
      expand_motion<2>();
      break;
    default:
      expand_motion<3>();
  }
  for (std::size_t index = 0; index < case_->cables.size(); ++index) {
    if (!taut_.contains(index)) {
      expand_gap(index);
    }
  }
  std::size_t row = 0;
  for (const std::size_t index : taut_) {
    const Points<Real> pull = held_[row++].pull;
    for (std::size_t k = 0; k + 2 <= order; ++k) {
      cables_[index].tension[k] = pull[k].x() * case_->cables[index].length;
    }
  }
}

/// Their numbers are undefined as yet.
template <class Real>
void TautSeries<Real>::make_channels() {
  const std::size_t terms = order_ + 1;
  const std::size_t cables = case_->cables.size();
  store_ = std::make_unique_for_overwrite<Real[]>(terms * (9 + 3 * cables + 2 * taut_.size()));
  Real* next = store_.get();
  const auto make_points = [&](Points<Real>& points) {  // first of all: they are aligned
    points = Points<Real>(next);
    next += 2 * terms;
  };
  const auto make = [&](Channel& channel, std::size_t size) {
    channel = Channel(next, size);
    next += terms;
  };
  for (Points<Real>* points : {&position_, &heading_, &turn_, &moment_}) {
    make_points(*points);
  }
  for (std::size_t index = 0; index < cables; ++index) {
    make_points(cables_[index].from);
  }
  std::size_t row = 0;
  for (const std::size_t index : taut_) {
    held_[row].at = case_->cables[index].attachment;
    held_[row].from = cables_[index].from;
    make_points(held_[row++].pull);
  }
  make(angle_, terms);
  for (std::size_t index = 0; index < cables; ++index) {
    if (taut_.contains(index)) {
      make(cables_[index].tension, order_ - 1);
    } else {
      make(cables_[index].gap, terms);
    }
  }
}

/// Sets the coefficients 0 and 1, which the state gives.
template <class Real>
void TautSeries<Real>::start_at(const BasicState<Real>& start) {
  position_[0] = start.position;
  position_[1] = start.velocity;
  const auto [cosine, sine] = heading(start.angle);
  heading_[0] = Point(cosine, sine);
  set_angle(0, start.angle);
  set_angle(1, start.spin);
  heading_[1] = turned(1);
  for (const std::size_t index : taut_) {
    const BasicCable<Real>& cable = case_->cables[index];
    Points<Real>& from = cables_[index].from;
    from[0] = position_[0] + series::in_the_world<Real>(cable.attachment, heading_[0]);
    from[0] -= cable.anchor;
    from[1] = position_[1] + series::in_the_world<Real>(cable.attachment, heading_[1]);
  }
}

/// The rows whose products are the matrix K_0 of Eq. 23.
template <class Real>
void TautSeries<Real>::couple() {
  weight_ = root_of_inverse_mass(case_->body);
  std::array<Vector3<Real>, 3> rows;
  for (std::size_t i = 0; i < taut_.size(); ++i) {
    const Point from = held_[i].from[0];
    held_[i].leverage = series::moment<Real>(held_[i].at, from);
    const Real lever = cross<Real>(series::in_the_world<Real>(held_[i].at, heading_[0]), from);
    rows[i] = {from.x() * weight_[0], from.y() * weight_[1], lever * weight_[2]};
  }
  coupled_ = RowSpace<BasicCase<Real>>(rows, taut_.size());
}

template <class Real>
void TautSeries<Real>::set_angle(std::size_t k, const Real& value) {
  angle_[k] = value;
  turn_[k].setConstant(Real(value * series::number(k)));
}

/// Coefficient k of the heading, of which heading' = angle' heading turned by 90 degrees; for k > 1
/// without the term of the angle's own.
template <class Real>
typename TautSeries<Real>::Point TautSeries<Real>::turned(std::size_t k) const {
  const std::size_t end = k > 1 ? k : k + 1;
  return perpendicular<Real>(series::products(turn_, heading_, k, 1, end)) / series::number(k);
}

template <class Real>
template <std::size_t held>
void TautSeries<Real>::expand_motion() {
  for (std::size_t k = 0; k + 2 <= order_; ++k) {
    expand_motion<held>(k);
  }
}

/// From coefficients up to k + 1 of the pose, the tensions' k and the pose's k + 2 (Eqs. 22-24) of
/// so many taut cables.
template <class Real>
template <std::size_t held>
void TautSeries<Real>::expand_motion(std::size_t k) {
  const double per_second = series::number((k + 1) * (k + 2));
  heading_[k + 2] = turned(k + 2);
  // what is known of coefficient k of the pulls' sum, and by the cables, to keep their lengths
  Point force = Point::Zero();
  Point moment = Point::Zero();
  Vector3<Real> kept = Vector3<Real>::Zero();
  for (std::size_t i = 0; i < held; ++i) {
    const HeldCable& cable = held_[i];
    const Point pull = series::products(cable.pull, cable.from, k, 0, k);
    force += pull;
    moment += series::moment<Real>(cable.at, pull);
    cable.from[k + 2] = series::in_the_world<Real>(cable.at, heading_[k + 2]);
    const Real stretch = series::half_square<Real>(cable.from, k + 2);
    kept += Real(per_second * stretch) * coupled_.dual(i);
  }
  moment_[k] = moment;
  // over the root of the mass
  Vector3<Real> known = Vector3<Real>::Zero();
  if (k == 0) {
    known.template head<2>() = case_->gravity * sqrt(case_->body.mass);
  } else if (held > 0) {
    const Real torque = series::products(heading_, moment_, k, 0, k + 1).sum();
    known = -Vector3<Real>(force.x(), force.y(), torque).cwiseProduct(weight_);
  }
  // not the known force less the tensions: of a light body both are large, and cancel
  const Vector3<Real> acceleration = (coupled_.across(known) - kept).cwiseProduct(weight_);
  position_[k + 2] = acceleration.template head<2>() / per_second;
  set_angle(k + 2, acceleration[2] / per_second);
  const Point turn = angle_[k + 2] * perpendicular<Real>(heading_[0]);
  heading_[k + 2] += turn;
  for (std::size_t i = 0; i < held; ++i) {
    const HeldCable& cable = held_[i];
    const Real pull = coupled_.dual(i).dot(known + kept);
    cable.pull[k].setConstant(pull);
    moment_[k] += pull * cable.leverage;
    cable.from[k + 2] += position_[k + 2] + series::in_the_world<Real>(cable.at, turn);
  }
}

/// Of a slack cable.
template <class Real>
void TautSeries<Real>::expand_gap(std::size_t index) {
  const BasicCable<Real>& cable = case_->cables[index];
  CableSeries& slack = cables_[index];
  for (std::size_t k = 0; k <= order_; ++k) {
    slack.from[k] = position_[k] + series::in_the_world<Real>(cable.attachment, heading_[k]);
  }
  slack.from[0] -= cable.anchor;
  for (std::size_t k = 1; k <= order_; ++k) {
    slack.gap[k] = -series::half_square<Real>(slack.from, k) / cable.length;
  }
  const Real& length = cable.length;
  const Point from = slack.from[0];
  slack.gap[0] = (length * length - from.x() * from.x() - from.y() * from.y()) / (2 * length);
}

template <class Real>
bool TautSeries<Real>::fits() const {
  using Numbers = Eigen::Map<const Eigen::Array<Real, Eigen::Dynamic, 1>>;
  const auto terms = static_cast<Eigen::Index>(order_ + 1);
  const auto sum = [](const Real* numbers, Eigen::Index size) {
    return Real((Numbers(numbers, size) * Real(0)).sum());  // NaN, where one is not finite
  };
  // an infinite number of another channel would be in these, times something
  Real all = sum(position_.data(), 2 * terms) + sum(angle_.data(), terms);
  for (std::size_t index = 0; index < case_->cables.size(); ++index) {
    const CableSeries& cable = cables_[index];
    const Channel& answer = taut_.contains(index) ? cable.tension : cable.gap;
    all += sum(answer.data(), static_cast<Eigen::Index>(answer.size()));
  }
  return all == Real(0);
}

template <class Real>
Eigen::Matrix<Real, Eigen::Dynamic, 3> TautSeries<Real>::pose() const {
  const auto terms = static_cast<Eigen::Index>(order_ + 1);
  Eigen::Matrix<Real, Eigen::Dynamic, 3> result(terms, 3);
  using Numbers = Eigen::Map<const Eigen::Matrix<Real, Eigen::Dynamic, 1>, 0, Eigen::InnerStride<>>;
  result.col(0) = Numbers(position_.data(), terms, Eigen::InnerStride<>(2));
  result.col(1) = Numbers(position_.data() + 1, terms, Eigen::InnerStride<>(2));
  result.col(2) = Numbers(angle_.data(), terms, Eigen::InnerStride<>(1));
  return result;
}

template <class Real>
std::vector<Real> TautSeries<Real>::lever(std::size_t index) const {
  std::vector<Real> result;
  result.reserve(order_ - 1);
  for (std::size_t k = 0; k + 2 <= order_; ++k) {
    Real sum(0);
    for (std::size_t j = 0; j <= k; ++j) {
      const Point arm = series::in_the_world<Real>(case_->cables[index].attachment, heading_[j]);
      sum += cross<Real>(arm, cables_[index].from[k - j]);
    }
    result.push_back(sum);
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
  Real least = infinity<Real>();
  const auto limit = [&](const Real& last, const Real& scale, std::size_t k) {
    if (last > 0 && scale > 0) {
      least = min(least, root(Real(error * scale / last), series::number(k)));
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
  return least;
}

}  // namespace tautline
