// A host engine's step, split at the instants at which cables go taut. Bullet's and ODE's drop-in
// cables share it; it knows neither, and needs C++11 alone.
//
// A Host flies its whole world: `host.fly(dt)`. A Cable is one of its cables:
//
// clang-format off
//   bool flies()                   slack, so that its next impact is an event
//   bool touches()                 it has run out of gap
//   bool slack()                   it was, so that closing is an impact
//   bool is_tugged()               it rests, and closes by more than a step explains
//   Real gap(), rate()             now [m], [m/s]
//   Real gap_after(dt)             if nothing but the forces acts, <= one step ahead [m]
//   Real tolerance()               the gap that counts as zero [m]
//   Real rate_rounding()           the closing rate that counts as none [m/s]
//   Real explained()               the closing rate that a whole step explains [m/s]
//   Real rebound()                 of its closing now, see CableRule [m/s]
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

/// The impacts of `cables` at one pose.
template <typename Real, typename Cable>
class CableImpacts {
 public:
  /// Solves those of all cables that have run out of gap, together; and again where one impact
  /// makes other cables close, until none does. A heavy load on a light one takes some dozens. What
  /// is taut closes in every part, which is no impact; between two steps it may be.
  void solve(std::vector<Cable>& cables, bool between_steps) {
    touching_.clear();
    for (Cable& cable : cables) {
      if (cable.touches()) {
        touching_.push_back(&cable);
      }
    }
    if (!any_closes()) {
      return;
    }
    find_left(between_steps);
    assemble(block_, touching_);
    const int most = 200;  // then they no longer rebound, and nothing is left to close
    for (int done = 0; done < most && any_closes(); ++done) {
      strike(done + 1 == most, between_steps);
    }
  }

 private:
  /// A resting cable closes by rounding of what its ends move at; that is none.
  bool any_closes() const {
    for (Cable* cable : touching_) {
      if (-cable->rate() > cable->rate_rounding()) {
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
  void find_left(bool between_steps) {
    resting_.clear();
    for (Cable* cable : touching_) {
      if (cable->held() && !(between_steps && cable->is_tugged())) {
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
      of_resting_.lacking(index) =
          std::min(-resting_[index]->rate(), Real(0)) - resting_[index]->rate();
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
  void strike(bool plastic, bool between_steps) {
    rebounds_.clear();
    for (std::size_t index = 0; index < touching_.size(); ++index) {
      const Cable& cable = *touching_[index];
      const Real rate = cable.rate();
      const bool closes = -rate > cable.rate_rounding();
      Real wanted = std::min(-rate, Real(0));
      if (plastic) {
        wanted = 0;
      } else if (closes && (cable.slack() || (between_steps && cable.is_tugged()))) {
        wanted = cable.rebound();
      }
      rebounds_.push_back(closes ? wanted : Real(-1));
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
  CableImpacts<Real, Cable> impacts;
  impacts.solve(cables, true);  // of cables that were pulled taut between two steps
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
    impacts.solve(cables, false);
  }
  return parts;
}

}  // namespace tautline
// NOLINTEND(modernize-use-nodiscard)
