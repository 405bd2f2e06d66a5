#pragma once

#include <optional>
#include <utility>

#include "loop/next_stop.hpp"
#include "loop/record.hpp"
#include "shortcuts/half_swing.hpp"
#include "shortcuts/single_bounces.hpp"
#include "shortcuts/swing_ahead.hpp"

namespace tautline {

/// Looks whether the motion so far repeats. This primary template knows no such motion.
template <class TheCase>
class HalfSwings {
 public:
  [[nodiscard]] static std::optional<Ending> found(const Present<TheCase>&,
                                                   const Stop<RealOf<TheCase>>&, CableSet,
                                                   const SolveOptions&, Record<TheCase>&) {
    return std::nullopt;
  }
};

/// In the plane (half_swing.hpp).
template <class Real>
class HalfSwings<BasicCase<Real>> {
 public:
  using TheCase = BasicCase<Real>;

  /// As Shortcuts::forever asks.
  [[nodiscard]] std::optional<Ending> found(const Present<TheCase>& now, const Stop<Real>& stop,
                                            CableSet pulling, const SolveOptions& options,
                                            Record<TheCase>& record) {
    const bool is_whole = stop.is_step || stop.ending == Ending::reached_duration;
    if (!is_whole || !has_one_freedom(now.the_case, now.state, pulling)) {
      return std::nullopt;
    }
    const auto half =
        watch_.follow(now.the_case, record.arcs, now.state, stop.dt, record.events.size());
    if (!half) {
      return std::nullopt;
    }
    if (options.until_locked) {
      record.arcs.back().end = half->end(record.arcs);
      record.swing = swing_of(now.the_case, *half, record.arcs, pulling);
      return Ending::locked;
    }
    record.repetition = repetition_of(now.the_case, *half, record.arcs);
    return Ending::reached_duration;
  }

 private:
  HalfSwingWatch<Real> watch_;
};

/// The one door to what exists for speed alone. The loop asks it twice: whether a single bounce is
/// all that happens next, and whether the motion goes on as it does for ever. Without the answers
/// the general path finds the same motion; SolveOptions turns each off.
template <class TheCase>
class Shortcuts {
 public:
  using Real = RealOf<TheCase>;

  using Bounce = typename SingleBounces<TheCase>::Bounce;
  using Search = typename SingleBounces<TheCase>::Search;

  Shortcuts(const TheCase& the_case, const SolveOptions& options)
      : options_(options), bounces_(the_case, options) {}

  /// True where a single bounce may follow, and `search` is to look for it.
  [[nodiscard]] bool may_bounce(const Present<TheCase>& now, Attempts<TheCase>& attempts) {
    return bounces_.may_follow(now, attempts);
  }
  [[nodiscard]] Search search(const Present<TheCase>& now,
                              const Attempts<TheCase>& attempts) const {
    return bounces_.search(now, attempts);
  }
  /// What `search` finds.
  [[nodiscard]] Bounce bounce(const Search& search) const { return bounces_.next(search); }
  /// `bounce`, found by a search after `last_hit`; keeps what it says about the next.
  [[nodiscard]] Landing<TheCase> land(const Bounce& bounce, CableSet last_hit) {
    return bounces_.land(bounce, last_hit);
  }
  /// The body is no longer as the last bounce has left it.
  void forget() { bounces_.forget(); }
  [[nodiscard]] const SingleBounces<TheCase>& bounces() const { return bounces_; }

  /// The swing for ever that the taut cables are certain to lead to, told before it is followed.
  [[nodiscard]] std::optional<BasicSwing<Real>> swing_ahead(const Present<TheCase>& now) const {
    return options_.until_locked && options_.swing_ahead && now.held
               ? tautline::swing_ahead(now.the_case, now.state, now.held->pulling, now.remaining)
               : std::nullopt;
  }

  /// Where the last arc of `record`, up to `stop` on the cables `pulling`, completes half a swing
  /// or a whole turn: the motion comes again for ever, and meets nothing new. Writes that to
  /// `record`, and returns the ending.
  [[nodiscard]] std::optional<Ending> forever(const Present<TheCase>& now, const Stop<Real>& stop,
                                              CableSet pulling, Record<TheCase>& record) {
    return options_.half_swings ? swings_.found(now, stop, pulling, options_, record)
                                : std::nullopt;
  }

 private:
  const SolveOptions& options_;
  SingleBounces<TheCase> bounces_;
  HalfSwings<TheCase> swings_;
};

}  // namespace tautline
