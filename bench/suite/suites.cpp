#include "bench/suite/suites.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "bench/base/listed.hpp"
#include "bench/base/text.hpp"

namespace tautline::bench {
namespace {

/// See every difference of 0.2 between two distribution functions.
constexpr std::size_t usual_draws = 200;

}  // namespace

const std::vector<double>& usual_steps() {
  static const std::vector<double> steps = {1e-2, 1e-3, 1e-4};
  return steps;
}

std::span<const Suite> suites() {
  static const std::vector<Suite> all = {
      {"quick",
       "a first answer in a minute",
       {1e-2, 1e-3},
       {{"bouncing-ball", "single impacts that accumulate, and then rest"},
        {"level-beam", "two cables struck in one instant, then in turn"},
        {"elastic-box", "e = 1: energy only moves between flight and spin"},
        {"caught-swing", "e = 0: a taut swing, a release, and a second catch"},
        {"spinning-rod", "an arm 5 times the radius of gyration: spin-up"},
        {"breakwater/1910121100", "79 impacts, ever slower, into a swing without losses"}}},
      {"chapter",
       "the source chapter's cases",
       usual_steps(),
       {{"breakwater/*", "e from 0.5 to 1; rings, boxes and a point mass"}},
       usual_draws},
      {"all",
       "every shipped case",
       usual_steps(),
       {{"*", "those of both, a load, a buoy, a plate: 1 to 4 cables"}},
       usual_draws},
      {"space",
       "bodies in space",
       {1e-2, 1e-3},
       {{"bifilar", "two taut cables that twist"},
        {"spherical-slack", "a ball in no plane, slack and caught again"},
        {"conical", "a spindle that goes round: the gyroscopic term"},
        {"tethered-ball", "impacts on a spinning ball"},
        {"dzhanibekov", "a box that turns over in flight, then snaps"},
        {"tumbling-brick", "an asymmetric brick thrown up on its corner"}},
       0,
       true},
      {"systems",
       "several bodies, winches, moving ends, waves",
       {1e-2, 1e-3},
       {{"two-bodies", "momentum of a pair"},
        {"newtons-cradle", "five balls in a row"},
        {"winch", "slack taken up, lifted, stopped"},
        {"bouncer-stable", "an anchor that vibrates, a snap in each period"},
        {"breakwater-in-waves", "force, moment and drag"},
        {"tow", "a tug and a barge"},
        {"crane-slings", "four slings, one too short"},
        {"hoisted-load", "a hook and a load below a trolley"}},
       0,
       true},
      {"elastic",
       "cables that stretch",
       {1e-3, 1e-4},
       {{"snap", "seven snaps, then a mass that hangs"},
        {"bungee", "long soft contacts under a load"},
        {"breakwater-elastic", "two cables that snap in turn"},
        {"hoist-elastic", "a box in space, lifted by two ropes"},
        {"elastic-strop", "an elastic cable below an inextensible one"}},
       0,
       true},
  };
  return all;
}

const Suite* find_suite(std::string_view name) { return find_by(suites(), &Suite::name, name); }

std::string suite_names(const std::string& last_word) {
  return joined(listed<std::string>(suites(), &Suite::name), last_word);
}

std::vector<std::string> cases_of(const Suite& suite) {
  return listed<std::string>(suite.entries, &SuiteCases::cases);
}

std::string suites_text() {
  std::string out;
  for (const Suite& suite : suites()) {
    out += fmt::format("{}: {}; steps {} s{}\n", suite.name, suite.sentence,
                       fmt::join(suite.steps, ", "),
                       suite.draws > 0 ? fmt::format(", {} draws", suite.draws) : "");
    for (const SuiteCases& entry : suite.entries) {
      out += fmt::format("  {:<23}{}\n", entry.cases, entry.shows);
    }
  }
  return out;
}

}  // namespace tautline::bench
