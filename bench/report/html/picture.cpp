#include "bench/report/html/picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "bench/base/html.hpp"
#include "bench/base/listed.hpp"
#include "bench/report/html/stills_svg.hpp"
#include "bench/report/tables/columns.hpp"
#include "bench/report/words.hpp"

namespace tautline::bench {
namespace {

/// A cable with less gap than this, of its length, does not look slack [-].
constexpr double visible_gap = 0.01;

/// One with more, before or beyond, does not look taut [-].
constexpr double taut = 0.005;

/// Instants that are looked at between two impacts.
constexpr int instants = 40;

const CaseRow* case_of(const Report& report, const RunRow& run) {
  return find_by(report.cases, &CaseRow::name, run.key.the_case);
}

/// The least gap of all cables, of their length [-].
double least_gap(const CaseRow& the_case, const DrawnPath& path, double time) {
  const Pose pose = pose_at(path, time);
  double least = std::numeric_limits<double>::infinity();
  for (const CableRow& cable : the_case.geometry) {
    least = std::min(least, gap_of(cable, pose) / cable.length);
  }
  return least;
}

/// The instant between two others at which the body flies, with every cable as slack as it gets.
double slackest(const CaseRow& the_case, const DrawnPath& path, double from, double until) {
  double best = from;
  for (int instant = 1; instant < instants; ++instant) {
    const double time = from + (until - from) * instant / instants;
    if (least_gap(the_case, path, time) > least_gap(the_case, path, best)) {
      best = time;
    }
  }
  return best;
}

/// The stills of the impact at `place`; none where its cable does not look taut at it, or slack
/// around it.
std::optional<ImpactStills> stills_of(const CaseRow& the_case, const RunRow& run,
                                      const ImpactColumns& impacts, const DrawnPath& path,
                                      std::size_t place) {
  const std::size_t index = impacts.cable[place];
  if (index >= the_case.geometry.size() || impacts.rate_after[place] <= 0.0) {
    return std::nullopt;
  }
  const CableRow& cable = the_case.geometry[index];
  const double time = impacts.time[place];
  const double before = place > 0 ? impacts.time[place - 1] : 0.0;
  const double after =
      place + 1 < impacts.time.size() ? impacts.time[place + 1] : 2 * time - before;
  const std::array<double, 3> times = {slackest(the_case, path, before, time), time,
                                       slackest(the_case, path, time, after)};
  if (least_gap(the_case, path, times[0]) < visible_gap ||
      least_gap(the_case, path, times[2]) < visible_gap ||
      std::abs(gap_of(cable, pose_at(path, time))) > taut * cable.length) {
    return std::nullopt;
  }
  return ImpactStills{&the_case, &run, &impacts, path, index, place, times};
}

/// How slack all cables are seen to be, before or after, whichever is less [-].
double clearness(const ImpactStills& stills) {
  return std::min(least_gap(*stills.the_case, stills.path, stills.times[0]),
                  least_gap(*stills.the_case, stills.path, stills.times[2]));
}

/// The path of a run: of the exact motion that of its case, which a report that was read back has
/// too; none of another run there.
std::optional<Path> path_of(const Report& report, const Replay& replay, std::size_t run) {
  const RunKey& key = report.runs[run].key;
  if (key.engine != control || key.model != "event") {
    return replay.of_run(run).path;
  }
  const auto of = static_cast<std::size_t>(case_of(report, report.runs[run]) - report.cases.data());
  return of < replay.cases.size() ? std::optional(replay.cases[of].path) : std::nullopt;
}

/// Of the run at `index`, the stills that show best how slack the cables are.
std::optional<ImpactStills> stills_of(const Report& report, const Replay& replay,
                                      std::size_t index) {
  const RunRow& run = report.runs[index];
  const std::optional<ImpactColumns>& impacts = replay.of_run(index).impacts;
  const CaseRow* const the_case = case_of(report, run);
  const std::optional<Path> recorded =
      the_case != nullptr && impacts ? path_of(report, replay, index) : std::nullopt;
  if (!recorded) {
    return std::nullopt;
  }
  const DrawnPath path(*recorded);
  std::optional<ImpactStills> best;
  for (std::size_t place = 0; place < impacts->time.size(); ++place) {
    const auto stills = stills_of(*the_case, run, *impacts, path, place);
    if (stills && (!best || clearness(*stills) > clearness(*best))) {
      best = stills;
    }
  }
  return best;
}

/// "1.23 m/s", or "1.23" of a case without units.
std::string speed_text(const CaseRow& the_case, double speed) {
  return fmt::format("{:.3g}{}", speed, is_nondimensional(the_case) ? "" : " m/s");
}

std::string instant_text(const ImpactStills& stills, std::size_t still) {
  return fmt::format("t = {:.3f}{}", stills.times.at(still),
                     is_nondimensional(*stills.the_case) ? "" : " s");
}

std::vector<std::string> captions(const ImpactStills& stills) {
  const ImpactColumns& impacts = *stills.impacts;
  const double before = -impacts.rate_before[stills.impact];
  const double after = impacts.rate_after[stills.impact];
  return {
      "slack: the body flies",
      fmt::format("taut: closes at {}", speed_text(*stills.the_case, before)),
      fmt::format("rebound: opens at {}", speed_text(*stills.the_case, after)),
  };
}

std::string legend_html(const ImpactStills& stills) {
  const ImpactColumns& impacts = *stills.impacts;
  const RunKey& key = stills.run->key;
  const double before = -impacts.rate_before[stills.impact];
  const double after = impacts.rate_after[stills.impact];
  return fmt::format(
      "<figcaption>A cable pulls only when it is taut, and then at once. Case <code>{}</code> in "
      "<code>{} {}</code>, impact at {}: cable {} closes at {} and opens at {}. Restitution asked: "
      "<b>{:.4g}</b>; got: <b>{:.4g}</b>. Engines are held against this.</figcaption>\n",
      html_text(key.the_case), html_text(key.engine), html_text(key.model), instant_text(stills, 1),
      stills.cable, speed_text(*stills.the_case, before), speed_text(*stills.the_case, after),
      impacts.requested[stills.impact], after / before);
}

}  // namespace

std::optional<ImpactStills> impact_stills(const Report& report, const Replay& replay) {
  for (const bool of_control : {true, false}) {
    for (std::size_t run = 0; run < report.runs.size(); ++run) {
      if ((report.runs[run].key.engine == control) == of_control) {
        if (auto stills = stills_of(report, replay, run)) {
          return stills;
        }
      }
    }
  }
  return std::nullopt;
}

std::string picture_html(const Report& report, const Replay& replay) {
  const std::optional<ImpactStills> stills = impact_stills(report, replay);
  if (!stills) {
    return "";
  }
  const std::vector<std::string> texts = captions(*stills);
  std::string out = "<figure class=\"stills\">\n<ol>\n";
  for (std::size_t still = 0; still < stills->times.size(); ++still) {
    out +=
        fmt::format("<li>{}<span class=\"still\"><b>{}</b> {}</span></li>\n",
                    still_svg(*stills->the_case, stills->path, stills->times, still, stills->cable),
                    instant_text(*stills, still), texts[still]);
  }
  return out + "</ol>\n" + legend_html(*stills) + "</figure>\n";
}

}  // namespace tautline::bench
