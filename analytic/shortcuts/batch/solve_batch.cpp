#include "tautline/solve_batch.hpp"

#include <array>
#include <memory>
#include <stdexcept>

#include "local_origin.hpp"
#include "loop/standing.hpp"
#include "shortcuts/batch/in_lane.hpp"
#include "shortcuts/paused_motion.hpp"

namespace tautline {
namespace {

/// The motions that are on their way, one a lane.
class Batch {
 public:
  Batch(std::span<const Case> cases, const SolveOptions& options, const TakeSolution& take)
      : cases_(cases), options_(options), take_(take), count_(cases.front().cables.size()) {
    question_.count = count_;
    question_.limits = options.completion;
  }

  /// Until all are solved.
  void run() {
    std::size_t flying = 0;
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      flying += start_next(lane) ? 1U : 0U;
    }
    const BounceLanes bounce_lanes = fastest_bounce_lanes();
    while (flying > 0) {
      bounce_lanes(question_, answer_);
      for (std::size_t lane = 0; lane < lanes; ++lane) {
        bounces_[lane] = InLane{lane}.get<SingleBounces<Case>::Bounce>(answer_);
      }
      for (std::size_t lane = 0; lane < lanes; ++lane) {
        if (bodies_[lane].motion && !goes_on(lane)) {
          flying -= start_next(lane) ? 0U : 1U;
        }
      }
    }
  }

 private:
  /// One that is on its way.
  struct Body {
    std::size_t index = 0;  // of its case
    Case near;              // seen from `origin`, where that is not the world's
    Vec2 origin = Vec2::Zero();
    std::unique_ptr<PausedMotion<Case>> motion;
    SingleBounces<Case>::Search search;  // its last
    Record<Case> room;                   // of the motion before
  };

  /// Puts the next case that flies into `lane`; false where there is none left.
  bool start_next(std::size_t lane) {
    Body& body = bodies_[lane];
    while (next_ < cases_.size()) {
      body.index = next_++;
      const Case& the_case = cases_[body.index];
      if (the_case.cables.size() != count_) {
        take_(body.index, solve(the_case, options_));  // lanes have the same cables each
        continue;
      }
      body.origin = local_origin(the_case);
      const bool moved = !body.origin.isZero(0);
      if (moved) {
        body.near = seen_from(body.origin, the_case);
      }
      body.motion = paused_motion(moved ? body.near : the_case, options_,
                                  touching_at_start(the_case), std::move(body.room));
      if (advance(lane)) {
        InLane{lane}(question_.world, body.motion->bounces().world());
        set_cables(lane);
        return true;
      }
    }
    body.motion.reset();
    InLane{lane}(question_.horizon, 0.0);  // nothing is searched for
    return false;
  }

  /// Takes the answer for `lane`; false where its motion has ended.
  bool goes_on(std::size_t lane) {
    Body& body = bodies_[lane];
    body.motion->round(bounces_[lane]);
    const CableSet last_hit = body.search.last_hit;
    if (!advance(lane)) {
      return false;
    }
    if (body.search.last_hit != last_hit) {
      set_cables(lane);
    }
    return true;
  }

  /// Follows the motion in `lane` to its next flight, and asks for the bounce there. False, and its
  /// solution given away, where it has ended.
  bool advance(std::size_t lane) {
    Body& body = bodies_[lane];
    while (!body.motion->has_ended() && !body.motion->may_bounce()) {
      body.motion->round({});
    }
    if (body.motion->has_ended()) {
      Solution solution = body.motion->solution();
      if (!body.origin.isZero(0)) {
        solution = seen_from<double>(-body.origin, solution, cases_[body.index]);
      }
      take_(body.index, solution);
      body.room = Record<Case>::in_room_of(std::move(solution));
      return false;
    }
    body.search = body.motion->search();
    const InLane set{lane};
    set(question_.from, body.search.from);
    set(question_.touches, body.search.last_hit.empty() ? 0.0 : 1.0);
    set(question_.horizon, body.search.horizon);
    for (std::size_t place = 0; place < count_; ++place) {
      set(question_.cables[place].tried, SingleBounces<Case>::tried_of(body.search, place));
    }
    return true;
  }

  /// The cable in this place of the body's search.
  static FlightCable<double> cable_at(std::size_t place, const Body& body) {
    return body.motion->bounces().cable_of(body.search, place);
  }

  /// The cables in the order in which they are searched now.
  void set_cables(std::size_t lane) {
    for (std::size_t place = 0; place < count_; ++place) {
      InLane{lane}(question_.cables[place], cable_at(place, bodies_[lane]));
    }
  }

  std::span<const Case> cases_;
  const SolveOptions& options_;
  const TakeSolution& take_;
  std::size_t count_;     // of cables
  std::size_t next_ = 0;  // case
  std::array<Body, lanes> bodies_;
  LaneQuestion question_;
  LaneAnswer answer_;
  // of each body: at once, as what has just been written number by number is slow to read as pairs
  std::array<SingleBounces<Case>::Bounce, lanes> bounces_;
};

}  // namespace

void solve_batch(std::span<const Case> cases, const SolveOptions& options,
                 const TakeSolution& take) {
  for (const Case& the_case : cases) {
    if (const auto broken = problems(the_case); !broken.empty()) {
      throw std::invalid_argument(broken.front());
    }
  }
  if (!cases.empty()) {
    Batch(cases, options, take).run();
  }
}

}  // namespace tautline
