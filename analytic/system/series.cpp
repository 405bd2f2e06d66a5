#include "system/series.hpp"

#include "instantiate.hpp"
#include "tautline/detail/series_impl.hpp"

// The recurrence is as in TautSeries, for several bodies and for cables through rings. A cable
// pulls at each end of a segment with pull * along, where pull = tension / distance: no direction
// is divided. Of a straight taut cable the distance is its length, which is given.

namespace tautline {

using series::number;

template <class Real, int D>
SystemSeries<Real, D>::SystemSeries(const TheCase& system, const BasicSystemState<Real, D>& start,
                                    CableSet taut, std::size_t order)
    : system_(&system),
      taut_(taut),
      order_(order),
      bodies_(system.bodies.size()),
      cables_(system.cables.size()),
      pulled_(!(taut | start.elastic.pulling()).empty()),
      weight_(root_of_inverse_mass(system.bodies)),
      length_scale_(shortest_length(system, start)) {
  if (!isfinite(length_scale_)) {
    length_scale_ = Real(1);  // no cable acts: nothing else gives a length
  }
  make_channels();
  expand_given(start.time);
  start_at(start);
  couple(start);
  find_stretched(start);
  const std::size_t alike = is_ballistic() ? 1 : order_ - 1;
  for (std::size_t k = 0; k < alike; ++k) {
    advance(k);
  }
  for (std::size_t k = alike; k + 2 <= order_; ++k) {
    for (BodySeries& body : bodies_) {
      body.turning.coast(k);
    }
  }
  for (std::size_t index = 0; index < cables_.size(); ++index) {
    if ((taut_ | start.elastic.stretched() | start.elastic.resisting).contains(index)) {
      continue;
    }
    if (cables_[index].acts) {
      expand_gap(index);
    } else {
      cables_[index].gap[0] = length_scale_;  // never taut
    }
  }
  for (StretchSeries& one : stretched_) {
    expand_stretched(one);
  }
}

/// True where nothing but a constant gravity acts: the centres fly on parabolas.
template <class Real, int D>
bool SystemSeries<Real, D>::is_ballistic() const {
  bool result = !pulled_ && system_->gravity.is_constant();
  for (const BasicBodyOfSystem<Real, D>& body : system_->bodies) {
    result = result && body.drag == 0 && body.spin_drag == 0 && body.force.is_constant() &&
             body.moment.empty();
  }
  return result;
}

/// All numbers are zero at first.
template <class Real, int D>
void SystemSeries<Real, D>::make_channels() {
  constexpr std::size_t stride = Places::stride;
  const std::size_t terms = order_ + 2 - order_ % 2;  // even: points stay aligned
  std::size_t count = (stride + TurningSeries<Real, D>::numbers) * bodies_.size();
  for (std::size_t index = 0; index < cables_.size(); ++index) {
    cables_[index].segments.resize(system_->cables[index].segments());
    count += 3 * stride * cables_[index].segments.size() + 3;
  }
  store_ = std::make_unique<Real[]>(terms * count);
  Real* next = store_.get();
  const auto points = [&](Places& result) {
    result = Places(next);
    next += stride * terms;
  };
  const auto channel = [&](Channel& result, std::size_t size) {
    result = Channel(next, size);
    next += terms;
  };
  for (BodySeries& body : bodies_) {
    points(body.position);
    body.turning.make(next, terms);
  }
  for (CableSeries& cable : cables_) {
    for (SegmentSeries& segment : cable.segments) {
      points(segment.along);
      points(segment.distance);
      points(segment.pull);
    }
  }
  for (CableSeries& cable : cables_) {
    channel(cable.length, order_ + 1);
    channel(cable.gap, order_ + 1);
    channel(cable.tension, order_ - 1);
  }
}

template <class Real, int D>
void SystemSeries<Real, D>::expand_given(const Real& time) {
  const auto expand = [&](const auto& function, auto& result) {
    if (!function.empty()) {
      result.resize(order_ + 1);
      function.expand(time, result);
    }
  };
  expand(system_->gravity, gravity_);
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    const BasicBodyOfSystem<Real, D>& body = system_->bodies[i];
    bodies_[i].body = &body;
    expand(body.force, bodies_[i].force);
  }
  for (std::size_t index = 0; index < cables_.size(); ++index) {
    const BasicCableOfSystem<Real, D>& given = system_->cables[index];
    CableSeries& cable = cables_[index];
    cable.acts = given.acts_at(time);
    cable.straight = given.through.empty();
    cable.steady = given.length.is_constant();
    if (cable.steady) {
      cable.length[0] = given.length.at(time)[0];
    } else {
      std::vector<Eigen::Matrix<Real, 1, 1>> length;
      expand(given.length, length);
      for (std::size_t k = 0; k <= order_; ++k) {
        cable.length[k] = length[k][0];
      }
    }
    cable.ends.resize(given.segments() + 1);
    for (std::size_t i = 0; i < cable.ends.size(); ++i) {
      expand(given.end(i).motion, cable.ends[i]);
    }
  }
}

/// Sets the coefficients 0 and 1, which the state gives.
template <class Real, int D>
void SystemSeries<Real, D>::start_at(const BasicSystemState<Real, D>& start) {
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    BodySeries& body = bodies_[i];
    const auto& now = start.bodies[i];
    body.position[0] = now.position;
    body.position[1] = now.velocity;
    std::vector<BasicTurn<Real, D>> moment;
    if (const auto& given = system_->bodies[i].moment; !given.empty()) {
      moment.resize(order_ + 1);
      given.expand(start.time, moment);
    }
    body.turning.start(system_->bodies[i], now, std::move(moment));
  }
  for (const std::size_t index : taut_) {
    CableSeries& cable = cables_[index];
    for (std::size_t i = 0; i < cable.segments.size(); ++i) {
      SegmentSeries& segment = cable.segments[i];
      for (const std::size_t k : {std::size_t(0), std::size_t(1)}) {
        segment.along[k] = place(index, i, k) - place(index, i + 1, k);
        set_distance(segment, k, distance_of(segment, k));
      }
      for (std::size_t k = 0; cable.straight && k <= order_; ++k) {
        set_distance(segment, k, cable.length[k]);
      }
    }
  }
}

/// The rows whose products are the matrix D of (B2).
template <class Real, int D>
void SystemSeries<Real, D>::couple(const BasicSystemState<Real, D>& start) {
  RowsOf<TheCase> rows(static_cast<Eigen::Index>(taut_.size()), weight_.size());
  Eigen::Index row = 0;
  for (const std::size_t index : taut_) {
    rows.row(row++) = gap_gradient(system_->cables[index], start).cwiseProduct(weight_).transpose();
  }
  coupled_ = RowSpace<TheCase>(rows);
}

template <class Real, int D>
void SystemSeries<Real, D>::set_distance(SegmentSeries& segment, std::size_t k, const Real& value) {
  segment.distance[k].setConstant(value);
}

/// Coefficient k of the place of an end, of a body's only the part that its turn gives.
template <class Real, int D>
typename SystemSeries<Real, D>::Vector SystemSeries<Real, D>::turned_place(std::size_t index,
                                                                           std::size_t end,
                                                                           std::size_t k) const {
  const BasicEnd<Real, D>& one = system_->cables[index].end(end);
  if (one.body) {
    return bodies_[*one.body].turning.arm(one.at, k);
  }
  Vector result = k == 0 ? one.at : Vector(Vector::Zero());
  if (const Given& given = cables_[index].ends[end]; !given.empty()) {
    result += given[k];
  }
  return result;
}

/// Coefficient k of the place of an end.
template <class Real, int D>
typename SystemSeries<Real, D>::Vector SystemSeries<Real, D>::place(std::size_t index,
                                                                    std::size_t end,
                                                                    std::size_t k) const {
  const BasicEnd<Real, D>& one = system_->cables[index].end(end);
  const Vector turned = turned_place(index, end, k);
  return one.body ? Vector(bodies_[*one.body].position[k] + turned) : turned;
}

/// Coefficient k of |along| from the ones before (B3).
template <class Real, int D>
Real SystemSeries<Real, D>::distance_of(const SegmentSeries& segment, std::size_t k) const {
  if (k == 0) {
    return segment.along[0].norm();
  }
  const Real& distance = segment.distance[0].x();
  Real half = series::half_square<Real>(segment.along, k);
  for (std::size_t j = 1; 2 * j <= k; ++j) {
    const Real product = segment.distance[j].x() * segment.distance[k - j].x();
    half -= 2 * j == k ? Real(product / 2) : product;
  }
  return half / distance;
}

/// From coefficients up to k + 1 of the poses, the tensions' k and the poses' k + 2 (B1, B2).
template <class Real, int D>
void SystemSeries<Real, D>::advance(std::size_t k) {
  const double per_second = number((k + 1) * (k + 2));
  begin(k);
  for (const std::size_t index : taut_) {
    pull(index, k);
  }
  for (StretchSeries& one : stretched_) {
    if (one.pulls) {
      strain(one, k);
      pull(one, k);
    }
  }
  const RowOf<TheCase> known = driving(k);
  RowOf<TheCase> kept = RowOf<TheCase>::Zero(weight_.size());
  std::size_t i = 0;
  for (const std::size_t index : taut_) {
    kept += Real(per_second * opening(index, k + 2)) * coupled_.dual(i++);
  }
  // not the known force and the tensions: of a light body both are large, and cancel
  const RowOf<TheCase> change = coupled_.across(known) - kept;
  const RowOf<TheCase> accelerations = change.cwiseProduct(weight_) / Real(per_second);
  accelerate(k, accelerations);
  i = 0;
  for (const std::size_t index : taut_) {
    tighten(index, k, Real(-coupled_.dual(i++).dot(known + kept)), accelerations);
  }
}

/// Clears what the cables do, and lets the bodies turn on.
template <class Real, int D>
void SystemSeries<Real, D>::begin(std::size_t k) {
  for (BodySeries& body : bodies_) {
    body.pull.setZero();
    body.turning.begin(k);
  }
}

/// Adds coefficient k of a cable's `force` at `end` to its body.
template <class Real, int D>
void SystemSeries<Real, D>::add_pull(const BasicEnd<Real, D>& end, std::size_t k,
                                     const Vector& force) {
  if (end.body) {
    BodySeries& body = bodies_[*end.body];
    body.pull += force;
    body.turning.add_moment(end.at, force, k);
  }
}

/// Adds coefficient k of a cable's pulls, as far as it is known: all but the tension's own.
template <class Real, int D>
void SystemSeries<Real, D>::pull(std::size_t index, std::size_t k) {
  CableSeries& cable = cables_[index];
  for (std::size_t i = 0; i < cable.segments.size(); ++i) {
    SegmentSeries& segment = cable.segments[i];
    if (k == 0) {
      continue;  // nothing is known of the tension yet
    }
    if (!(cable.straight && cable.steady)) {
      const Vector shrinking = series::products(segment.distance, segment.pull, k, 1, k + 1);
      segment.pull[k] = -shrinking / segment.distance[0].x();
    }
    pull_segment(index, i, k);
  }
}

/// Adds coefficient k of the pulls of a segment.
template <class Real, int D>
void SystemSeries<Real, D>::pull_segment(std::size_t index, std::size_t i, std::size_t k) {
  const SegmentSeries& segment = cables_[index].segments[i];
  const Vector force = series::products(segment.pull, segment.along, k, 0, k + 1);
  add_pull(system_->cables[index].end(i), k, -force);
  add_pull(system_->cables[index].end(i + 1), k, force);
}

/// Coefficient k of the gap of a taut cable where coefficient k of all poses is zero, but for what
/// turns so far give.
template <class Real, int D>
Real SystemSeries<Real, D>::opening(std::size_t index, std::size_t k) {
  CableSeries& cable = cables_[index];
  Real result = cable.length[k];
  for (std::size_t i = 0; i < cable.segments.size(); ++i) {
    SegmentSeries& segment = cable.segments[i];
    segment.along[k] = turned_place(index, i, k) - turned_place(index, i + 1, k);
    const Real distance = cable.straight && cable.steady
                              ? Real(series::half_square<Real>(segment.along, k) / cable.length[0])
                              : distance_of(segment, k);
    result -= distance;
    if (!cable.straight) {
      set_distance(segment, k, distance);
    }
  }
  return result;
}

/// Coefficient k of the forces and moments that are known, over the root of the mass.
template <class Real, int D>
RowOf<BasicSystem<Real, D>> SystemSeries<Real, D>::driving(std::size_t k) const {
  RowOf<TheCase> result(weight_.size());
  Eigen::Index row = 0;
  for (const BodySeries& body : bodies_) {
    Vector force = body.pull - body.body->drag * Real(number(k + 1)) * body.position[k + 1];
    if (!gravity_.empty()) {
      force += body.body->mass * gravity_[k];
    }
    if (!body.force.empty()) {
      force += body.force[k];
    }
    result.template segment<D>(row) = force * weight_[row];
    auto turning = result.template segment<spins<D>>(row + D);
    turning =
        body.turning.torque(k, pulled_).cwiseProduct(weight_.template segment<spins<D>>(row + D));
    row += freedoms_of_body<D>;
  }
  return result;
}

/// Sets coefficient k + 2 of the poses.
template <class Real, int D>
void SystemSeries<Real, D>::accelerate(std::size_t k, const RowOf<TheCase>& accelerations) {
  Eigen::Index row = 0;
  for (BodySeries& body : bodies_) {
    body.position[k + 2] = accelerations.template segment<D>(row);
    body.turning.turn(k, accelerations.template segment<spins<D>>(row + D));
    row += freedoms_of_body<D>;
  }
}

/// Sets coefficient k of the tension of a cable, and adds what the bodies' `accelerations` do to
/// its segments.
template <class Real, int D>
void SystemSeries<Real, D>::tighten(std::size_t index, std::size_t k, const Real& tension,
                                    const RowOf<TheCase>& accelerations) {
  CableSeries& cable = cables_[index];
  cable.tension[k] = tension;
  const auto gain = [&](const BasicEnd<Real, D>& end) {
    if (!end.body) {
      return Vector(Vector::Zero());
    }
    const Eigen::Index row = static_cast<Eigen::Index>(*end.body) * freedoms_of_body<D>;
    return Vector(accelerations.template segment<D>(row) +
                  bodies_[*end.body].turning.swept(
                      end.at, accelerations.template segment<spins<D>>(row + D)));
  };
  for (std::size_t i = 0; i < cable.segments.size(); ++i) {
    SegmentSeries& segment = cable.segments[i];
    const BasicEnd<Real, D>& first = system_->cables[index].end(i);
    const BasicEnd<Real, D>& second = system_->cables[index].end(i + 1);
    const Real& distance = segment.distance[0].x();
    const Real part = tension / distance;
    segment.pull[k] += Vector::Constant(part);
    const Vector force = part * segment.along[0];
    add_pull(first, k, -force);
    add_pull(second, k, force);
    const Vector change = gain(first) - gain(second);
    segment.along[k + 2] += change;
    if (!cable.straight) {
      segment.distance[k + 2] += Vector::Constant(segment.along[0].dot(change) / distance);
    }
  }
}

/// Expands the gap of a slack cable.
template <class Real, int D>
void SystemSeries<Real, D>::expand_gap(std::size_t index) {
  CableSeries& cable = cables_[index];
  const Real& length = cable.length[0];
  for (std::size_t i = 0; i < cable.segments.size(); ++i) {
    SegmentSeries& segment = cable.segments[i];
    for (std::size_t k = 0; k <= order_; ++k) {
      segment.along[k] = place(index, i, k) - place(index, i + 1, k);
      if (!cable.straight) {
        set_distance(segment, k, distance_of(segment, k));
        cable.gap[k] -= segment.distance[k].x();
      }
    }
  }
  if (!cable.straight) {
    for (std::size_t k = 0; k <= order_; ++k) {
      cable.gap[k] += cable.length[k];
    }
    return;
  }
  const Places& along = cable.segments[0].along;
  cable.gap[0] = (length * length - along[0].squaredNorm()) / (2 * length);
  for (std::size_t k = 1; k <= order_; ++k) {
    Real half(0);  // of coefficient k of the length's square
    for (std::size_t j = 0; !cable.steady && j <= k; ++j) {
      half += cable.length[j] * cable.length[k - j] / 2;
    }
    cable.gap[k] = (half - series::half_square<Real>(along, k)) / length;
  }
}

template <class Real, int D>
bool SystemSeries<Real, D>::fits() const {
  Real all(0);  // NaN, where one is not finite
  for (const BodySeries& body : bodies_) {
    for (std::size_t k = 0; k <= order_; ++k) {
      all += (body.position[k].sum() + body.turning.sum(k)) * Real(0);
    }
  }
  for (const CableSeries& cable : cables_) {
    for (std::size_t k = 0; k <= order_; ++k) {
      all += (cable.gap[k] + (k + 2 <= order_ ? cable.tension[k] : Real(0))) * Real(0);
    }
  }
  return all == Real(0);
}

template <class Real, int D>
PosesOf<BasicSystem<Real, D>> SystemSeries<Real, D>::pose() const {
  constexpr Eigen::Index numbers = Turning<Real, D>::pose_numbers;
  PosesOf<TheCase> result(static_cast<Eigen::Index>(order_ + 1),
                          static_cast<Eigen::Index>(bodies_.size()) * numbers);
  for (std::size_t k = 0; k <= order_; ++k) {
    auto row = result.row(static_cast<Eigen::Index>(k));
    Eigen::Index column = 0;
    for (const BodySeries& body : bodies_) {
      row.template segment<D>(column) = body.position[k].transpose();
      body.turning.write(k, order_, row.segment(column + D, numbers - D));
      column += numbers;
    }
  }
  return result;
}

/// Coefficient k of what has a length or an angle, against the shortest cable and a radian.
template <class Real, int D>
Real SystemSeries<Real, D>::last_term(std::size_t k) const {
  Real angle(0);
  Real length(0);
  for (const BodySeries& body : bodies_) {
    angle = max(angle, body.turning.size(k));
    length = max(length, Real(body.position[k].cwiseAbs().maxCoeff()));
  }
  for (const CableSeries& cable : cables_) {
    length = max(length, max(Real(abs(cable.length[k])), Real(abs(cable.gap[k]))));
    for (const Given& end : cable.ends) {
      length = max(length, end.empty() ? Real(0) : Real(end[k].cwiseAbs().maxCoeff()));
    }
    for (const SegmentSeries& segment : cable.segments) {
      length = max(length, Real(segment.along[k].cwiseAbs().maxCoeff()));
      length = max(length, cable.straight ? Real(0) : Real(abs(segment.distance[k].x())));
    }
  }
  return max(angle, Real(length / length_scale_));
}

template <class Real, int D>
Real SystemSeries<Real, D>::reach(const Real& error) const {
  Real least = infinity<Real>();
  const auto limit = [&](const Real& last, const Real& scale, std::size_t k) {
    if (last > 0 && scale > 0) {
      least = min(least, root(Real(error * scale / last), number(k)));
    }
  };
  for (const std::size_t k : {order_ - 1, order_}) {
    limit(last_term(k), Real(1), k);
    for (const BodySeries& body : bodies_) {
      body.turning.limit_reach(k, limit);
    }
    Real pull(0);
    Real pull_scale(0);  // a tension may fall to zero
    for (const BodySeries& body : bodies_) {
      const Real weight = gravity_.empty() ? Real(0) : Real(gravity_[0].norm());
      const Real force = body.force.empty() ? Real(0) : Real(body.force[0].norm());
      pull_scale = max(pull_scale, Real(body.body->mass * weight + force));
    }
    const Real load = pull_scale;
    for (const StretchSeries& one : stretched_) {
      const Real scale = tension_scale(one, load);
      limit(abs(cables_[one.index].tension[k - 2]), scale, k - 2);
      pull_scale = max(pull_scale, scale);
    }
    for (const std::size_t index : taut_) {
      pull = max(pull, Real(abs(cables_[index].tension[k - 2])));
      pull_scale = max(pull_scale, Real(abs(cables_[index].tension[0])));
    }
    limit(pull, pull_scale, k - 2);
  }
  for (const CableSeries& cable : cables_) {
    for (const SegmentSeries& segment : cable.segments) {
      least = cable.straight || !cable.acts ? least : apart_for(segment, least);
    }
  }
  for (const StretchSeries& one : stretched_) {
    if (one.slack) {  // the ends of a stretched one are far apart
      for (const SegmentSeries& segment : cables_[one.index].segments) {
        least = apart_for(segment, least);
      }
    }
  }
  return least;
}

/// How long [s], at most `most`, the ends of a segment surely stay apart: its distance has a kink
/// where they meet, and the series has none.
template <class Real, int D>
Real SystemSeries<Real, D>::apart_for(const SegmentSeries& segment, const Real& most) const {
  const Real distance = segment.distance[0].x();
  Real result = most;
  for (std::size_t k = 1; k <= order_ && !isfinite(result); ++k) {  // by the first that moves them
    const Real term = abs(segment.distance[k].x());
    if (term > 0) {
      result = distance / term;
      result = k == 1 ? result : root(result, static_cast<double>(k));
    }
  }
  const auto may_meet = [&](const Real& time) {
    Real change(0);
    Real power(1);
    for (std::size_t k = 1; k <= order_; ++k) {
      power *= time;
      change += abs(segment.distance[k].x()) * power;
    }
    return change >= distance;
  };
  while (result > 0 && may_meet(result)) {
    result /= 2;
  }
  return result;
}

template class SystemSeries<Instance, instance_dimension>;

}  // namespace tautline
