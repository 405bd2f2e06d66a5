// Where the tension of a taut cable touches zero.

#include <algorithm>
#include <array>

#include "instantiate.hpp"
#include "sensitivity/linearised.hpp"
#include "tautline/geometry.hpp"
#include "tautline/projection.hpp"
#include "tautline/uncertainty.hpp"

namespace tautline {
namespace {

/// Tensions this small against the forces of the motion are looked at: errors that are larger are
/// trusted nowhere [-].
constexpr double near_zero = 1e-2;

/// The tension of one cable along an arc, as a function of the time since its start.
template <class Real>
class TensionAlongArc {
 public:
  TensionAlongArc(const BasicCase<Real>& the_case, const BasicArc<Real>& arc, CableSet pulling,
                  std::size_t cable)
      : case_(the_case), arc_(arc), pulling_(pulling) {
    for (const std::size_t index : pulling) {
      if (index == cable) {
        break;
      }
      ++row_;
    }
    const Real scale = acceleration_scale(the_case, arc.initial);
    force_ = the_case.body.mass * scale;
    // differences of fourth roots: the rounding of a second derivative is then its square root
    step_ = sqrt(Real(shortest_length(the_case) / scale)) * sqrt(Real(sqrt(epsilon<Real>())));
  }

  [[nodiscard]] Real at(const Real& time) const {
    return tensions(case_, arc_.after(time, case_.gravity), pulling_)[row_];
  }
  [[nodiscard]] const Real& force() const { return force_; }  // [N], of the motion

  /// Where its parabola at `time` is least; none where it bends down.
  [[nodiscard]] std::optional<BasicTouch<Real>> bottom(const Real& time) const {
    const Real here = at(time);
    const Real later = at(Real(time + step_));
    const Real earlier = at(Real(time - step_));
    const Real slope = (later - earlier) / (2 * step_);
    const Real bend = (later - 2 * here + earlier) / (step_ * step_);
    if (!(bend > 0)) {
      return std::nullopt;
    }
    return BasicTouch<Real>{0, time - slope / bend, here - slope * slope / (2 * bend), bend};
  }

  /// The minimum near `time`, by Newton's method.
  [[nodiscard]] std::optional<BasicTouch<Real>> minimum(Real time) const {
    constexpr int enough = 12;  // from a part of an arc: it doubles the digits each time
    for (int iteration = 0; iteration < enough; ++iteration) {
      const auto found = bottom(time);
      if (!found) {
        return std::nullopt;
      }
      const bool done = abs(Real(found->time - time)) <= step_;
      time = found->time;
      if (done) {
        return BasicTouch<Real>{0, time, at(time), found->bend};
      }
    }
    return std::nullopt;
  }

 private:
  const BasicCase<Real>& case_;
  const BasicArc<Real>& arc_;
  CableSet pulling_;
  Eigen::Index row_ = 0;
  Real force_;
  Real step_;  // [s]
};

/// True where an event of `kind`, or any if none is given, is at `time`, and has `cable`.
template <class Real>
bool has_event(const BasicSolution<Real>& solution, const Real& time, std::size_t cable,
               std::optional<EventKind> kind) {
  const auto& events = solution.events();
  auto event = std::lower_bound(
      events.begin(), events.end(), time,
      [](const BasicEvent<Real>& one, const Real& instant) { return one.time < instant; });
  for (; event != events.end() && event->time == time; ++event) {
    if ((!kind || event->kind == *kind) && (!kind || event->cables.contains(cable))) {
      return true;
    }
  }
  return false;
}

/// False where the parabola through three tensions stays clear of zero, with a margin for what an
/// arc, a part of the radius of convergence, bends more.
template <class Real>
bool comes_near(const Real& start, const Real& middle, const Real& end, const Real& force) {
  const Real low = min(start, min(middle, end));
  const Real high = max(start, max(middle, end));
  constexpr double margin = 0.5;  // [-]
  return low - margin * (high - low) <= near_zero * force;
}

}  // namespace

template <class Real>
BasicCableVector<Real> tensions(const BasicCase<Real>& the_case, const BasicState<Real>& state,
                                CableSet pulling) {
  BasicCableVector<Real> free(static_cast<Eigen::Index>(pulling.size()));
  Eigen::Index row = 0;
  for (const std::size_t index : pulling) {
    free[row++] = free_gap_acceleration(the_case, index, state);
  }
  return -multipliers<Real>(the_case, state, pulling, free);
}

template <class Real>
std::vector<BasicTouch<Real>> touches(const BasicCase<Real>& the_case,
                                      const BasicSolution<Real>& solution, std::size_t index) {
  const BasicArc<Real>& arc = solution.arcs()[index];
  const Real length = arc.end - arc.start;
  std::vector<BasicTouch<Real>> result;
  if (arc.series.rows() == 0 || is_rest(arc) || !(length > 0)) {
    return result;
  }
  const CableSet pulling = basis(the_case, arc.initial, arc.taut);
  if (pulling != arc.taut) {  // redundant cables have no tensions of their own
    return result;
  }
  const bool begins = index == 0 || has_event<Real>(solution, arc.start, 0, std::nullopt);
  for (const std::size_t cable : pulling) {
    const TensionAlongArc<Real> tension(the_case, arc, pulling, cable);
    const Real most = near_zero * tension.force();  // [N]
    const auto add = [&](std::optional<BasicTouch<Real>> found) {
      if (found && found->tension <= most) {
        found->cable = cable;
        found->time += arc.start;
        result.push_back(*found);
      }
    };
    const std::array ends = {tension.at(Real(0)), tension.at(Real(length / 2)), tension.at(length)};
    if (!comes_near(ends[0], ends[1], ends[2], tension.force())) {
      continue;
    }
    const bool releases = has_event<Real>(solution, arc.end, cable, EventKind::slack);
    if (releases) {
      add(tension.bottom(length));
    }
    constexpr int parts = 8;
    const Real near_end = length * 1e-6;  // of two arcs that meet at a minimum either may have it
    std::array<Real, parts + 1> values;
    for (int part = 0; part <= parts; ++part) {
      values[static_cast<std::size_t>(part)] = tension.at(Real(length * part / parts));
    }
    for (std::size_t part = begins ? 1 : 0; part <= (releases ? parts - 1U : parts); ++part) {
      const bool falls = part == 0 || values[part] <= values[part - 1];
      const bool rises = part == parts || values[part] <= values[part + 1];
      if (falls && rises) {
        const auto found = tension.minimum(Real(length * static_cast<double>(part) / parts));
        if (found && found->time >= -near_end && found->time <= length + near_end) {
          add(found);
        }
      }
    }
  }
  return result;
}

template BasicCableVector<Instance> tensions(const BasicCase<Instance>&,
                                             const BasicState<Instance>&, CableSet);
template std::vector<BasicTouch<Instance>> touches(const BasicCase<Instance>&,
                                                   const BasicSolution<Instance>&, std::size_t);

}  // namespace tautline
