#include "saltation.hpp"

#include "instantiate.hpp"
#include "linearised.hpp"

namespace tautline {

template <class Real>
Eigen::Matrix<Real, 6, 1> state_rate(const BasicArc<BasicCase<Real>>& arc, const Real& dt,
                                     const BasicVec2<Real>& gravity) {
  const BasicState<Real> state = arc.after(dt, gravity);
  Eigen::Matrix<Real, 3, 1> acceleration(gravity.x(), gravity.y(), Real(0));
  if (arc.series.rows() > 0) {
    acceleration.setZero();
    for (Eigen::Index k = arc.series.rows() - 1; k >= 2; --k) {
      acceleration =
          (acceleration * dt + arc.series.row(k).transpose() * static_cast<double>(k * (k - 1)))
              .eval();
    }
  }
  Eigen::Matrix<Real, 6, 1> result;
  result << state.velocity, state.spin, acceleration;
  return result;
}

template <class Real>
BasicJump<Real> saltation(const BasicInstant<Real>& instant, CableSet taut) {
  BasicStateMatrix<Real> reset = BasicStateMatrix<Real>::Identity();
  CableSet hit;
  for (const BasicEvent<BasicCase<Real>>& event : instant.events) {
    switch (event.kind) {
      case EventKind::impact:
        hit = hit | (event.cables - taut);
        reset = rebound_derivative(instant.the_case, instant.law, event, taut) * reset;
        break;
      case EventKind::taut:
        taut = taut | event.cables;
        reset = projection_derivative(instant.the_case, event.before, taut) * reset;
        break;
      case EventKind::slack:  // state and forces are continuous: nothing to add
        taut = taut - event.cables;
        break;
      case EventKind::entry:  // elastic cables are of systems
      case EventKind::exit:
        break;
    }
  }
  if (hit.empty()) {
    return {reset, taut};
  }
  const auto delay = delay_derivative(instant.the_case, instant.events.front().before, hit);
  if (!delay) {
    return {no_derivative<Real>(), taut};
  }
  return {reset + (reset * instant.rate_before - instant.rate_after) * *delay, taut};
}

template Eigen::Matrix<Instance, 6, 1> state_rate(const BasicArc<InstanceCase>&, const Instance&,
                                                  const BasicVec2<Instance>&);
template BasicJump<Instance> saltation(const BasicInstant<Instance>&, CableSet);

}  // namespace tautline
