#include "tautline/detail/hold.hpp"

#include <algorithm>
#include <bit>

#include "instantiate.hpp"
#include "tautline/detail/rounding.hpp"
#include "tautline/geometry.hpp"
#include "tautline/impact.hpp"

namespace tautline {
namespace {

/// Terms of the series: the 28 of a double make steps of about a quarter of the radius of
/// convergence, which is the cheapest; more digits need more terms in proportion.
template <class Real>
std::size_t series_order() {
  using std::log;
  const double digits = -static_cast<double>(log(epsilon<Real>())) / 2.302585092994046;
  return digits < 17.0 ? 28 : static_cast<std::size_t>(6.0 + 1.1 * digits);
}

/// The first coefficient that changes more than `rounding` over a time `h`: its sign, and how many
/// are before it. Sign 0: none does.
struct Leading {
  int sign;
  std::size_t zeros;
};
template <class Real>
Leading leading(std::span<const Real> coefficients, std::size_t known_zeros, const Real& h,
                const Real& rounding) {
  Real power(1);
  for (std::size_t k = 0; k < coefficients.size(); ++k) {
    const Real term = coefficients[k] * power;
    if (k >= known_zeros && abs(term) > rounding) {
      return {term > 0 ? 1 : -1, k};
    }
    power *= h;
  }
  return {0, coefficients.size()};
}

/// The series of full order, or of a lower one where its coefficients overflow: a body that turns a
/// million times in its unit of time. A cable that `bounces` on the motion returns long before
/// the end of the series: half of the order does.
template <class TheCase>
SeriesOf<TheCase> longest_series(const TheCase& the_case, const StateOf<TheCase>& state,
                                 CableSet pulling, bool bounces) {
  using Real = RealOf<TheCase>;
  std::size_t order = bounces ? series_order<Real>() / 2 : series_order<Real>();
  constexpr std::size_t least_order = 6;
  for (; order > least_order; order /= 2) {
    SeriesOf<TheCase> motion(the_case, state, pulling, order);
    if (motion.fits()) {
      return motion;
    }
  }
  return SeriesOf<TheCase>(the_case, state, pulling, least_order);
}

/// True where a cable of `cables` hangs side by side with `index`, so that their gaps are one.
template <class TheCase>
bool has_twin(const TheCase& the_case, std::size_t index, CableSet cables) {
  const std::vector<std::size_t> indices = cables.indices();
  return std::any_of(indices.begin(), indices.end(), [&](std::size_t other) {
    return side_by_side(the_case.cables[index], the_case.cables[other]);
  });
}

/// Cables whose tension and acceleration are both zero, up to `tension_errors` [N]: the next
/// derivatives decide.
template <class Real>
struct Doubtful {
  CableSet cables;
  std::array<Real, max_cables> tension_errors{};
};

/// One candidate: `pulling` of `resting` are held. None if a tension or a gap turns negative.
template <class TheCase, class Real = RealOf<TheCase>>
std::optional<BasicHold<TheCase>> candidate(const TheCase& the_case, const StateOf<TheCase>& state,
                                            const TouchingOf<TheCase>& touching, CableSet resting,
                                            CableSet pulling, const Doubtful<Real>& doubtful) {
  const Real acceleration = acceleration_scale(the_case, state);
  // over which a cable notices that acceleration
  const Real time = acceleration > 0
                        ? Real(sqrt(Real(shortest_length(the_case, state) / acceleration)))
                        : infinity<Real>();
  const bool bounces = !(touching.cables - resting).empty();
  BasicHold<TheCase> result{
      pulling, {}, longest_series(the_case, state, pulling, bounces), Real(0), {}};
  result.reach = result.motion.reach(epsilon<Real>() / 4);
  if (!pulling.empty()) {  // or tensions that hold a body still, rounded, would move it in the end
    result.reach = min(result.reach, time);
  }
  const Real least = min(result.reach, time);
  const Real h = isfinite(least) ? least : Real(1);  // nothing changes: any time will do
  for (const std::size_t index : resting | touching.cables) {
    const CableOf<TheCase>& cable = the_case.cables[index];
    if (pulling.contains(index)) {
      if (doubtful.cables.contains(index)) {
        const Leading first =
            leading(result.motion.tension(index), 0, h, doubtful.tension_errors[index]);
        if (first.sign <= 0) {
          return std::nullopt;
        }
        result.zeros[index] = first.zeros;
      }
    } else if (!resting.contains(index)) {
      result.zeros[index] = 1;  // it opens at its rate
    } else if (has_twin(the_case, index, pulling)) {
      result.following.insert(index);
    } else {
      const Real rounding = rounding_margin * rounding_of_gap(cable, state);
      const Leading first = leading(result.motion.gap(index), 2, h, rounding);
      if (first.sign < 0) {
        return std::nullopt;
      }
      if (first.sign == 0) {
        result.following.insert(index);
      }
      result.zeros[index] = first.zeros;
    }
  }
  return result;
}

/// The candidate that holds the `certain` cables and those of the `doubtful` that go on pulling.
template <class TheCase, class Real = RealOf<TheCase>>
std::optional<BasicHold<TheCase>> chosen(const TheCase& the_case, const StateOf<TheCase>& state,
                                         const TouchingOf<TheCase>& touching, CableSet resting,
                                         CableSet certain, const Doubtful<Real>& doubtful) {
  const std::vector<std::size_t> choices = doubtful.cables.indices();
  for (unsigned bits = 0; bits < (1U << choices.size()); ++bits) {
    CableSet pulling = certain;
    for (std::size_t choice = 0; choice < choices.size(); ++choice) {
      if (((bits >> choice) & 1U) != 0) {
        pulling.insert(choices[choice]);
      }
    }
    if (bits != 0 && !independent(the_case, state, pulling)) {
      continue;
    }
    if (auto found = candidate(the_case, state, touching, resting, pulling, doubtful)) {
      return found;
    }
  }
  return candidate(the_case, state, touching, {}, certain, {});  // rounding denies all of them
}

/// Those of `certain` whose tension falls to zero before `time_rounding`: at this instant, as far
/// as the time can tell.
template <class TheCase, class Real = RealOf<TheCase>>
CableSet released_now(const std::optional<BasicHold<TheCase>>& held, CableSet certain,
                      const Real& time_rounding) {
  CableSet result;
  for (const std::size_t index : held ? certain : CableSet{}) {
    const auto tension = held->motion.tension(index);
    if (tension[0] + tension[1] * time_rounding <= 0) {
      result.insert(index);
    }
  }
  return result;
}

}  // namespace

template <class TheCase>
std::optional<BasicHold<TheCase>> hold(const TheCase& the_case, const StateOf<TheCase>& state,
                                       const TouchingOf<TheCase>& touching, CableSet resting) {
  using Real = RealOf<TheCase>;
  if (resting.empty()) {
    return candidate(the_case, state, touching, {}, {}, Doubtful<Real>{});
  }
  const auto held = resting_tensions(the_case, state, resting);
  if (!held) {
    return std::nullopt;
  }
  CableSet certain;
  Doubtful<Real> doubtful;
  Eigen::Index row = 0;
  for (const std::size_t index : resting) {
    if (held->tension[row] > held->tension_error[row]) {
      certain.insert(index);
    } else if (held->acceleration[row] <= held->acceleration_error[row]) {
      doubtful.cables.insert(index);
      doubtful.tension_errors[index] = held->tension_error[row];
    }
    ++row;
  }
  auto found = chosen(the_case, state, touching, resting, certain, doubtful);
  const CableSet lost = released_now(found, certain, touching.time_rounding);
  if (lost.empty()) {
    return found;
  }
  for (const std::size_t index : lost) {
    doubtful.cables.insert(index);
    doubtful.tension_errors[index] = abs(found->motion.tension(index)[0]);
  }
  return chosen(the_case, state, touching, resting, certain - lost, doubtful);
}

template <class TheCase>
std::optional<BasicHold<TheCase>> continued(const TheCase& the_case, const StateOf<TheCase>& state,
                                            const TouchingOf<TheCase>& touching,
                                            const BasicHold<TheCase>& held) {
  return candidate(the_case, state, touching, held.taut(), held.pulling, {});
}

template <class TheCase, class Real>
BasicFirstContact<Real> first_change(const TheCase& the_case, const BasicHold<TheCase>& held,
                                     const std::type_identity_t<Real>& horizon) {
  BasicFirstContact<Real> result{min(held.reach, horizon), {}};
  std::array<std::optional<Real>, max_cables> roots;
  for (std::size_t index = 0; index < the_case.cables.size(); ++index) {
    if (held.following.contains(index)) {
      continue;
    }
    if constexpr (TheCase::has_several_bodies) {
      if (the_case.cables[index].elasticity) {  // see `first_switch`
        continue;
      }
    }
    const bool pulls = held.pulling.contains(index);
    const Polynomial<Real> f(pulls ? held.motion.tension(index) : held.motion.gap(index),
                             held.zeros[index]);
    const Real until = result.dt * (1 + simultaneous<Real>());
    const BasicRootSearch<Real> search = first_root_if_any(f, until);
    if (search.root && isnan(*search.root)) {
      return {*search.root, {}};
    }
    if (search.root && *search.root < result.dt) {
      result.dt = *search.root;
    }
    if (!pulls) {
      roots[index] = search.root;
    }
  }
  for (std::size_t index = 0; index < the_case.cables.size(); ++index) {
    if (roots[index] && *roots[index] <= result.dt * (1 + simultaneous<Real>())) {
      result.cables.insert(index);
    }
  }
  return result;
}

template std::optional<BasicHold<InstanceCase>> hold(const InstanceCase&,
                                                     const StateOf<InstanceCase>&,
                                                     const TouchingOf<InstanceCase>&, CableSet);
template std::optional<BasicHold<InstanceCase>> continued(const InstanceCase&,
                                                          const StateOf<InstanceCase>&,
                                                          const TouchingOf<InstanceCase>&,
                                                          const BasicHold<InstanceCase>&);
template BasicFirstContact<Instance> first_change(const InstanceCase&,
                                                  const BasicHold<InstanceCase>&, const Instance&);

}  // namespace tautline
