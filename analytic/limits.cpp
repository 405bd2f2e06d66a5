#include "tautline/detail/limits.hpp"

#include "instantiate.hpp"
#include "tautline/detail/flight.hpp"
#include "tautline/detail/root_search.hpp"
#include "tautline/geometry.hpp"

namespace tautline {
namespace {

/// How far one attachment is below the ceiling along a flight.
template <class Real>
class RoomAlongFlight {
 public:
  RoomAlongFlight(const BasicCase<Real>& the_case, const BasicCable<Real>& cable,
                  const BasicState<Real>& start)
      : the_case_(the_case), cable_(cable), start_(start) {}

  [[nodiscard]] BasicSample<Real> at(const Real& s) const {
    const BasicState<Real> state = fly(start_, the_case_.gravity, s);
    const BasicVec2<Real> point = attachment_point(state, cable_);
    const BasicVec2<Real> arm = point - state.position;
    const Real spin_squared = state.spin * state.spin;
    return {*the_case_.ceiling - point.y(), -attachment_velocity(state, cable_).y(),
            -(the_case_.gravity.y() - spin_squared * arm.y()), spin_squared * state.spin * arm.x()};
  }

  [[nodiscard]] Real snap_bound(const Real& /*s*/, const Real& /*window*/) const {
    const Real spin_squared = start_.spin * start_.spin;
    return spin_squared * spin_squared * cable_.attachment.norm();
  }

  /// While the centre is an arm below the ceiling no angle brings the attachment there.
  [[nodiscard]] Real clear(const Real& s, const Real& window) const {
    const BasicState<Real> state = fly(start_, the_case_.gravity, s);
    const Real room = *the_case_.ceiling - state.position.y() - cable_.attachment.norm();
    return room > 0 ? min(window, first_quadratic_root<Real>(room, -state.velocity.y(),
                                                             the_case_.gravity.y()))
                    : Real(0);
  }

 private:
  const BasicCase<Real>& the_case_;
  const BasicCable<Real>& cable_;
  const BasicState<Real>& start_;
};

/// The first root of `limit` - `series`.
template <class Real>
std::optional<Real> first_reaching(std::vector<Real> series, const Real& limit,
                                   const Real& horizon) {
  for (Real& coefficient : series) {
    coefficient = -coefficient;
  }
  series[0] += limit;
  const Polynomial<Real> room(series);
  return room.least(horizon) > 0 ? std::nullopt : first_root(room, horizon).root;
}

}  // namespace

template <class Real>
std::optional<Real> time_to_ceiling(const BasicCase<Real>& the_case, const BasicState<Real>& state,
                                    const std::type_identity_t<Real>& horizon) {
  std::optional<Real> earliest;
  if (!the_case.ceiling) {
    return earliest;
  }
  for (const BasicCable<Real>& cable : the_case.cables) {
    const RoomAlongFlight<Real> room(the_case, cable, state);
    const BasicRootSearch<Real> search = first_root(room, Real(earliest.value_or(horizon)));
    earliest = search.root ? search.root : earliest;
    if (earliest && isnan(*earliest)) {
      return earliest;
    }
  }
  return earliest;
}

template <class Real>
std::optional<Real> time_to_angle_limit(const BasicCase<Real>& the_case,
                                        const BasicState<Real>& state,
                                        const std::type_identity_t<Real>& horizon) {
  if (!the_case.angle_limit || state.spin == 0) {  // exactly zero: the body does not turn
    return std::nullopt;
  }
  const Real limit = state.spin > 0 ? *the_case.angle_limit : Real(-*the_case.angle_limit);
  const Real dt = max(Real(0), Real((limit - state.angle) / state.spin));
  return dt <= horizon ? std::optional(dt) : std::nullopt;
}

template <class Real>
std::optional<Real> time_to_ceiling(const BasicCase<Real>& the_case, const TautSeries<Real>& motion,
                                    const std::type_identity_t<Real>& horizon) {
  std::optional<Real> earliest;
  for (std::size_t index = 0; the_case.ceiling && index < the_case.cables.size(); ++index) {
    const Real until = earliest.value_or(horizon);
    const auto root = first_reaching(motion.height(index), *the_case.ceiling, until);
    earliest = root ? root : earliest;
    if (earliest && isnan(*earliest)) {
      return earliest;
    }
  }
  return earliest;
}

template <class Real>
std::optional<Real> time_to_angle_limit(const BasicCase<Real>& the_case,
                                        const TautSeries<Real>& motion,
                                        const std::type_identity_t<Real>& horizon) {
  if (!the_case.angle_limit) {
    return std::nullopt;
  }
  std::vector<Real> angle(motion.angle().begin(), motion.angle().end());
  const auto above = first_reaching(angle, *the_case.angle_limit, horizon);
  for (Real& coefficient : angle) {
    coefficient = -coefficient;
  }
  const auto below = first_reaching(std::move(angle), *the_case.angle_limit, horizon);
  if (!above || !below) {
    return above ? above : below;
  }
  return isnan(*above) || *above < *below ? above : below;
}

template std::optional<Instance> time_to_ceiling(const InstanceCase&, const BasicState<Instance>&,
                                                 const Instance&);
template std::optional<Instance> time_to_ceiling(const InstanceCase&, const TautSeries<Instance>&,
                                                 const Instance&);
template std::optional<Instance> time_to_angle_limit(const InstanceCase&,
                                                     const BasicState<Instance>&, const Instance&);
template std::optional<Instance> time_to_angle_limit(const InstanceCase&,
                                                     const TautSeries<Instance>&, const Instance&);

}  // namespace tautline
