#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "bench/replay/path.hpp"

namespace tautline::bench {

// What is drawn of a report's cases and runs: by the replay of its page, the charts of the audit
// and the stills. It is made beside the report, which has the numbers.

/// A report has at most this many impacts of one run, the fastest: half a megabyte of JSON.
inline constexpr std::size_t most_impacts = 5000;

/// A replay shows at most this many impacts of one run, or events of one case, the fastest.
inline constexpr std::size_t most_drawn = 300;

/// The counted impacts of a run in rising time, a column each; of very many the fastest.
struct ImpactColumns {
  std::vector<double> time;              // [s]
  std::vector<std::size_t> cable;        //
  std::vector<double> requested;         // [-], the cable's restitution at that speed
  std::vector<double> rate_before;       // [m/s], gap rate, negative when closing
  std::vector<double> rate_after;        // [m/s]
  std::vector<double> arm;               // [m], lever arm, > 0 where the pull turns anticlockwise
  std::vector<double> tangential_error;  // [N s], momentum across the cable that nothing explains
  std::vector<double> angular_error;     // [N m s], spin that no arm times impulse explains
  std::vector<std::size_t> steps;        // with an impulse; 0 if located
  std::size_t left_out = 0;              // counted impacts that are not here, all slower
};

/// Events of an exact motion, a column each; of thousands the fastest impacts.
struct EventColumns {
  std::vector<double> time;                      // [s]
  std::vector<std::string> kind;                 // "impact", "taut", "slack"
  std::vector<std::vector<std::size_t>> cables;  //
  std::vector<std::optional<double>>
      rate;                  // [m/s], of the fastest cable; none of what is no impact
  std::size_t left_out = 0;  // impacts that are not here, all slower
};

/// What is drawn of a run.
struct RunReplay {
  std::optional<Path> path;              // none in a report's JSON: see `CaseRow::motions`
  std::optional<ImpactColumns> impacts;  // none where nothing was recorded
};

/// What is drawn of a case's exact motion.
struct CaseReplay {
  Path path;
  EventColumns events;
};

/// What is drawn of a report, in the order of its cases and of its runs.
struct Replay {
  std::vector<CaseReplay> cases;
  std::vector<RunReplay> runs;

  /// Of the run at this place of the report: nothing, where the replay has no such run.
  [[nodiscard]] const RunReplay& of_run(std::size_t place) const {
    static const RunReplay nothing;
    return place < runs.size() ? runs[place] : nothing;
  }
};

/// `impacts` with the digits that a chart needs, and no more than `most` of them, the fastest.
[[nodiscard]] ImpactColumns drawable(ImpactColumns impacts, std::size_t most);

/// `replay` of a report of so many `cases` and `runs` likewise, with an entry for each of them, at
/// most `most` impacts of each run, and without the paths of the runs.
[[nodiscard]] Replay drawable(const Replay& replay, std::size_t cases, std::size_t runs,
                              std::size_t most);

/// The impacts of each run on a page of `runs`: at least 3, and about 1 MB of all.
[[nodiscard]] std::size_t page_impacts(std::size_t runs);

/// `value` with `digits` significant digits.
[[nodiscard]] double rounded(double value, int digits = 6);
void round_all(std::vector<double>& column, int digits = 6);

}  // namespace tautline::bench
