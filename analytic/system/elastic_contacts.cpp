#include "tautline/elastic_contacts.hpp"

#include <array>
#include <span>

#include "instantiate.hpp"
#include "system/kernel.hpp"

namespace tautline {
namespace {

/// The polynomial f, times `sign`, from `from` on, for a search.
template <class Real>
struct Onward {
  const Polynomial<Real>& f;
  Real from;
  int sign;

  [[nodiscard]] BasicSample<Real> at(const Real& s) const {
    const BasicSample<Real> now = f.at(Real(from + s));
    return {sign * now.value, sign * now.rate, sign * now.curvature, sign * now.jerk};
  }
  [[nodiscard]] Real snap_bound(const Real& s, const Real& window) const {
    return f.snap_bound(Real(from + s), window);
  }
};

/// A value of a polynomial, and where.
template <class Real>
struct ValueAt {
  Real value;
  Real time;
};

/// The largest value of the polynomial with these coefficients from 0 to `end`: there, or where its
/// rate falls through zero.
template <class Real>
ValueAt<Real> largest_value(std::span<const Real> coefficients, const Real& end) {
  const Polynomial<Real> f(coefficients);
  const auto rates =
      series::rate_of<Real>(coefficients.size(), [&](std::size_t k) { return coefficients[k]; });
  const Polynomial<Real> rate{std::span<const Real>(rates)};
  ValueAt<Real> result{coefficients[0], Real(0)};
  const auto take = [&](const Real& time) {
    if (const Real value = f.at(time).value; value > result.value) {
      result = {value, time};
    }
  };
  take(end);
  Onward<Real> part{rate, Real(0), rates[0] < 0 ? -1 : 1};
  for (std::size_t root = 0; root < rates.size(); ++root) {  // it has no more
    const auto found = first_root(part, Real(end - part.from), {root > 0}).root;
    if (!found || !isfinite(*found)) {
      break;
    }
    part.from += *found;
    take(part.from);
    part.sign = -part.sign;
  }
  return result;
}

/// Adds what cable `contact.cable` does along an arc of the motion up to `dt` [s].
template <class Real, int D>
void follow(const SystemSeries<Real, D>& motion, const Real& start, const Real& dt,
            BasicElasticContact<Real>& contact) {
  const auto tension = motion.tension(contact.cable);
  if (const auto found = largest_value(tension, dt); found.value > contact.peak) {
    contact.peak = found.value;
    contact.peak_time = start + found.time;
  }
  const auto gap = motion.gap(contact.cable);
  const auto stretch =
      series::polynomial<Real>(gap.size(), [&](std::size_t k) { return Real(-gap[k]); });
  contact.greatest_stretch =
      max(contact.greatest_stretch, largest_value(std::span<const Real>(stretch), dt).value);
  contact.impulse += series::integral<Real>(tension, dt);
}

/// Adds an arc on which nothing moves.
template <class Real, int D>
void stay(const BasicSystem<Real, D>& system, const BasicArc<BasicSystem<Real, D>>& arc,
          BasicElasticContact<Real>& contact) {
  const Real tension = elastic_tension(system, contact.cable, arc.initial);
  if (tension > contact.peak) {
    contact.peak = tension;
    contact.peak_time = arc.start;
  }
  contact.greatest_stretch =
      max(contact.greatest_stretch, Real(-gap(system.cables[contact.cable], arc.initial)));
  contact.impulse += tension * (arc.end - arc.start);
}

}  // namespace

template <class Real, int D>
std::vector<BasicElasticContact<Real>> elastic_contacts(
    const BasicSolution<BasicSystem<Real, D>>& solution) {
  const BasicSystem<Real, D>& system = solution.system();
  std::vector<BasicElasticContact<Real>> result;
  std::array<std::size_t, max_cables> last{};  // contact of each cable
  CableSet open;
  BasicSystemState<Real, D> end;  // of the arc before
  const auto close = [&](CableSet cables, const Real& time) {
    for (const std::size_t index : cables) {
      result[last[index]].exit = time;
      BasicCableOfSystem<Real, D> cable = system.cables[index];
      cable.cut_at.reset();  // a cut ends a contact, too
      result[last[index]].exit_speed = gap_rate(cable, end);
    }
    open = open - cables;
  };
  for (const auto& arc : solution.arcs()) {
    const CableSet engaged = arc.initial.elastic.engaged;
    close(open - engaged, arc.start);
    for (const std::size_t index : engaged - open) {
      last[index] = result.size();
      result.push_back({.cable = index,
                        .entry = arc.start,
                        .entry_speed = Real(-gap_rate(system.cables[index], arc.initial)),
                        .peak_time = arc.start});
    }
    open = engaged;
    if (engaged.empty()) {
      continue;
    }
    const auto motion = motion_along(system, arc);
    for (const std::size_t index : engaged) {
      BasicElasticContact<Real>& contact = result[last[index]];
      if (motion) {
        follow(*motion, arc.start, Real(arc.end - arc.start), contact);
      } else {
        stay(system, arc, contact);
      }
    }
    end = arc.after(Real(arc.end - arc.start), solution.gravity());
  }
  return result;
}

template std::vector<BasicElasticContact<Instance>> elastic_contacts(
    const BasicSolution<InstanceCase>&);

}  // namespace tautline
