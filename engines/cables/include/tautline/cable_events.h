// A host engine's step, split at the instants at which cables go taut. Bullet's and ODE's drop-in
// cables share it; it knows neither, and needs C++11 alone.
//
// A Host flies its whole world: `host.fly(dt)`. A Cable is one of its cables:
//
// clang-format off
//   bool flies()                   slack, so that its next impact is an event
//   bool touches()                 it has run out of gap
//   bool slack()                   it was, so that closing is an impact
//   bool held()                    it rests taut
//   bool is_tugged()               it rests, and closes by more than a step explains
//   Real gap(), rate()             now [m], [m/s]
//   Real gap_after(dt)             if nothing but the forces acts, <= one step ahead [m]
//   Real tolerance()               the gap that counts as zero [m]
//   Real rate_rounding()           the closing rate that counts as none [m/s]
//   Real explained()               the closing rate that a whole step explains [m/s]
//   Real rebound()                 of its closing now, see CableRule [m/s]
//   Real braking()                 what its winch and hooks, which brake, are slower by at the end
//                                  of the step than in its mean [m/s]
//   void fill(CableBlock::Row&)    its ends, as the impacts are solved
//   void apply(impulse)            changes the velocities of its ends now, impulse in [N s]
//   bool held()                    it rests taut
//   void struck(impulse, impact)   it was, by impulse > 0; `impact` of it is of an impact, the rest
//                                  is what was left of the tension of a part [N s]
//   void hold(), rebounds()        how it goes on after the solve
//   void ran_out()                 the step ran out of parts
// clang-format on
//
// Energy: an impact's rows ask for no more than the rate they closed with, as in CableRule, so none
// gains any. A load on a taut cable moves by half of the forces' change of a part before, half
// after, and the cable's pull in between (RATTLE), which keeps the energy to second order.
//
// Winches and hooks have one speed in a step. Where they brake from step to step by less than the
// forces press the load outwards, the load does not leave its cable: it ends the step at the speed
// that they are to have by then, and not at the mean of the step, from which it would fly up.

#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "tautline/cable_block.h"

// NOLINTBEGIN(modernize-use-nodiscard): C++11 does not know it
namespace tautline {

/// The first time in (0, dt] at which `cable` runs out of gap, located to rounding; `dt` if it does
/// not. A cable that runs out twice within `dt` and is slack at its end is not seen.
template <typename Real, typename Cable>
Real time_to_taut(Cable& cable, Real dt) {
  Real slack = 0;
  Real taut = dt;
  if (cable.gap_after(dt) >= 0) {
    return dt;
  }
  // halving: a cable that was just struck starts from a gap of rounding, of either sign
  const int halvings = std::numeric_limits<Real>::digits;
  for (int done = 0; done < halvings; ++done) {
    const Real middle = (slack + taut) / 2;
    (cable.gap_after(middle) < 0 ? taut : slack) = middle;
  }
  return taut;
}

/// What the winch and the hooks of a resting cable are slower by at the end of a step than in its
/// mean [m/s]: half of the `change` since the step before, if that is known. The load has `ahead`
/// of their mean as the step begins, which is as much if they brake evenly: where they have just
/// begun to brake, or nothing is known, that says better. No more than half of the `fall` by which
/// the forces press the load outwards in a step: else it leaves the cable [m/s].
template <typename Real>
Real cable_braking(bool known, Real change, Real ahead, Real fall) {
  const Real begun = fall / 16;  // more than braking that changes steadily leaves [m/s]
  const Real half = known && !(ahead > change / 2 + begun) ? change / 2 : ahead;
  return known && !(change > 0) ? Real(0) : std::max(std::min(half, fall / 2), Real(0));
}

/// The impacts of `cables` at one pose.
template <typename Real, typename Cable>
class CableImpacts {
 public:
  /// Solves those of all cables that have run out of gap, together; and again where one impact
  /// makes other cables close, until none does. A heavy load on a light one takes some dozens. What
  /// is taut closes in every part, which is no impact; between two steps it may be.
  enum When { between_steps, between_parts, at_the_end };
  void solve(std::vector<Cable>& cables, When when) {
    when_ = when;
    touching_.clear();
    for (Cable& cable : cables) {
      if (cable.touches()) {
        touching_.push_back(&cable);
      }
    }
    if (!any_closes()) {
      return;
    }
    find_left();
    assemble(block_, touching_);
    const int most = 200;  // then they no longer rebound, and nothing is left to close
    for (int done = 0; done < most && any_closes(); ++done) {
      strike(done + 1 == most);
    }
  }

 private:
  /// The closing rate with which `cable` goes on [m/s].
  Real left_to(const Cable& cable) const {
    return when_ == at_the_end && cable.held() ? cable.braking() : Real(0);
  }
  /// The rate that `cable` is to have if there is no impact: what opens turns around [m/s].
  Real rest_of(const Cable& cable) const {
    const Real rate = cable.rate();
    return std::min(-rate, -std::min(left_to(cable), std::max(-rate, Real(0))));
  }
  /// A resting cable closes by rounding of what its ends move at; that is none.
  bool closes(const Cable& cable) const {
    return -cable.rate() > cable.rate_rounding() + left_to(cable);
  }
  bool any_closes() const {
    for (Cable* cable : touching_) {
      if (closes(*cable)) {
        return true;
      }
    }
    return false;
  }

  static void assemble(CableBlock& block, const std::vector<Cable*>& cables) {
    block.begin(cables.size());
    for (std::size_t index = 0; index < cables.size(); ++index) {
      cables[index]->fill(block.row(index));
    }
    block.assemble();
  }

  /// What the taut cables' tension of the last part has left to do: the impulses that stop them, if
  /// there is no impact. All that they get, if no other cable touches.
  void find_left() {
    resting_.clear();
    for (Cable* cable : touching_) {
      if (cable->held() && !(when_ == between_steps && cable->is_tugged())) {
        resting_.push_back(cable);
      }
    }
    const bool no_impact = resting_.size() == touching_.size();
    left_.assign(touching_.size(), no_impact ? std::numeric_limits<Real>::infinity() : Real(0));
    if (no_impact || resting_.empty()) {
      return;
    }
    assemble(of_resting_, resting_);
    for (std::size_t index = 0; index < resting_.size(); ++index) {
      of_resting_.lacking(index) = rest_of(*resting_[index]) - resting_[index]->rate();
    }
    of_resting_.solve(CableBlock::velocities);
    for (std::size_t index = 0, rests = 0; index < touching_.size(); ++index) {
      if (rests < resting_.size() && resting_[rests] == touching_[index]) {
        left_[index] = static_cast<Real>(of_resting_.impulse(rests++));
      }
    }
  }

  /// One solve. A row asks for the rebound of what is an impact, for rest of what is held, and lets
  /// what opens turn around, no faster than it opened.
  void strike(bool plastic) {
    rebounds_.clear();
    for (std::size_t index = 0; index < touching_.size(); ++index) {
      const Cable& cable = *touching_[index];
      const Real rate = cable.rate();
      const bool closing = closes(cable);
      Real wanted = rest_of(cable);
      if (plastic) {
        wanted = -left_to(cable);
      } else if (closing && (cable.slack() || (when_ == between_steps && cable.is_tugged()))) {
        wanted = cable.rebound();
      }
      rebounds_.push_back(closing ? std::max(wanted, Real(0)) : Real(-1));
      block_.lacking(index) = wanted - rate;
    }
    block_.solve(CableBlock::velocities);
    for (std::size_t index = 0; index < touching_.size(); ++index) {
      Cable& cable = *touching_[index];
      const Real impulse = static_cast<Real>(block_.impulse(index));
      if (impulse > 0) {
        cable.apply(impulse);
        const Real left = std::min(impulse, left_[index]);
        cable.struck(impulse, impulse - left);
        left_[index] -= left;
      }
      if (rebounds_[index] > 0) {
        cable.rebounds();
      } else if (rebounds_[index] == 0) {  // exactly: it closed, and was to stop
        cable.hold();
      }
    }
  }

  CableBlock block_{std::numeric_limits<Real>::epsilon()};
  CableBlock of_resting_{std::numeric_limits<Real>::epsilon()};
  std::vector<Cable*> touching_;
  std::vector<Cable*> resting_;  // those of them that are taut
  std::vector<Real> left_;       // see find_left, by those that touch [N s]
  std::vector<Real> rebounds_;   // asked for [m/s]; negative: it did not close
  When when_ = between_steps;
};

/// Steps the world by `dt` [s] in at most `most` + 1 parts, each ending where a slack cable goes
/// taut; impacts are solved there, in no time. What is left after `most` parts is one part, in
/// which no more impacts are looked for: before it, a cable that rebounds no faster than the forces
/// of a step turn around is held taut; after it, what closes is struck where it is. Returns the
/// number of parts.
template <typename Real, typename Host, typename Cable>
int step_by_events(Host& host, std::vector<Cable>& cables, Real dt, int most) {
  // in a step of rounding, engines do nothing or worse; an instant that close to a part's end is it
  const Real shortest = dt * Real(1e-4);
  typedef CableImpacts<Real, Cable> Impacts;
  Impacts impacts;
  impacts.solve(cables,
                Impacts::between_steps);  // of cables that were pulled taut between two steps
  Real left = dt;
  int parts = 0;
  while (left > 0) {
    Real part = left;
    for (Cable& cable : cables) {
      if (!cable.flies()) {
        continue;
      }
      if (parts < most) {
        part = std::min(part, std::max(shortest, time_to_taut(cable, part)));
      } else if (cable.touches() && cable.rate() <= cable.explained() &&
                 cable.gap_after(part) < 0) {
        cable.hold();
      }
    }
    if (left - part <= shortest) {
      part = left;
    }
    if (parts == most) {
      for (Cable& cable : cables) {
        cable.ran_out();
      }
    }
    host.fly(part);
    left -= part;
    ++parts;
    impacts.solve(cables, left > 0 ? Impacts::between_parts : Impacts::at_the_end);
  }
  return parts;
}

}  // namespace tautline
// NOLINTEND(modernize-use-nodiscard)
