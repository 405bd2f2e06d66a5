#include "bench/report/picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "bench/base/html.hpp"
#include "bench/base/listed.hpp"
#include "bench/report/columns.hpp"
#include "bench/report/words.hpp"
#include "tautline/geometry.hpp"

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

/// By how much the restitution got differs from the one asked for [-].
double restitution_error(const ImpactStills& stills) {
  const ImpactColumns& impacts = *stills.impacts;
  return std::abs(impacts.rate_after[stills.impact] / -impacts.rate_before[stills.impact] -
                  impacts.requested[stills.impact]);
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

/// The stills of the run at `index` that are best by `measure`.
std::optional<ImpactStills> stills_of(const Report& report, const Replay& replay, std::size_t index,
                                      double (*measure)(const ImpactStills&)) {
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
    if (stills && (!best || measure(*stills) > measure(*best))) {
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
      "<figcaption>A cable does nothing until it is taut, and then acts in an instant. Case "
      "<code>{}</code> in <code>{} {}</code>, impact at {}: cable {} closes at {} and opens at {}. "
      "Restitution asked: <b>{:.4g}</b>; got: <b>{:.4g}</b>. {}</figcaption>\n",
      html_text(key.the_case), html_text(key.engine), html_text(key.model), instant_text(stills, 1),
      stills.cable, speed_text(*stills.the_case, before), speed_text(*stills.the_case, after),
      impacts.requested[stills.impact], after / before,
      key.engine == control ? "Engines are compared with this motion."
                            : "The exact motion rebounds as asked.");
}

/// An error of a restitution that is seen [-].
constexpr double visible_error = 0.05;

/// The impact of an engine that is off the most, of the runs whose rebounds are off; none where no
/// error is seen.
std::optional<ImpactStills> worst_stills(const Report& report, const Replay& replay) {
  std::optional<ImpactStills> worst;
  for (std::size_t run = 0; run < report.runs.size(); ++run) {
    const RunRow& row = report.runs[run];
    if (row.key.engine == control || !row.judgement || !row.judgement->rebounds.wrong()) {
      continue;
    }
    const auto stills = stills_of(report, replay, run, restitution_error);
    if (stills && restitution_error(*stills) > visible_error &&
        (!worst || restitution_error(*stills) > restitution_error(*worst))) {
      worst = stills;
    }
  }
  return worst;
}

constexpr double still_width = 220.0;  // [px] of a still
constexpr double height = 190.0;       //
constexpr double rim = 16.0;           //

/// A gap below this, of the length, is drawn taut: about a pixel [-].
constexpr double looks_taut = 5e-3;

/// From metres to the pixels of a still.
struct Place {
  double scale;  // [px/m]
  Vec2 middle;   // [m]

  [[nodiscard]] Vec2 operator()(const Vec2& at) const {
    return {0.5 * still_width + scale * (at.x() - middle.x()),
            0.5 * height - scale * (at.y() - middle.y())};
  }
};

/// Points of the way a body came.
constexpr int trail_points = 60;

/// The end of a cable on the body [m].
Vec2 end_of(const CableRow& cable, const Pose& pose) {
  return attachment_point(State{.position = pose.centre, .angle = pose.angle},
                          Cable{.attachment = cable.attachment});
}

/// Room for the anchors and for the body at every still.
Place place_of_stills(const CaseRow& the_case, const DrawnPath& path,
                      const std::array<double, 3>& times) {
  std::vector<Vec2> points;
  for (const CableRow& cable : the_case.geometry) {
    points.push_back(cable.anchor);
    for (const double time : times) {
      points.push_back(end_of(cable, pose_at(path, time)));
      points.push_back(pose_at(path, time).centre);
    }
  }
  Vec2 low = points.front();
  Vec2 high = points.front();
  for (const Vec2& point : points) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  const Vec2 size = (high - low).cwiseMax(1e-9);
  return {std::min((still_width - 2 * rim) / size.x(), (height - 2 * rim) / size.y()),
          0.5 * (low + high)};
}

/// The length of the curve from `from` to `to` that hangs `depth` towards `down` at its control
/// point.
double length_of(const Vec2& from, const Vec2& to, const Vec2& control) {
  constexpr int pieces = 24;
  double sum = 0.0;
  Vec2 before = from;
  for (int piece = 1; piece <= pieces; ++piece) {
    const double t = static_cast<double>(piece) / pieces;
    const Vec2 now = (1 - t) * (1 - t) * from + 2 * t * (1 - t) * control + t * t * to;
    sum += (now - before).norm();
    before = now;
  }
  return sum;
}

/// Where the sagging curve of that length has its control point, by bisection.
Vec2 sag(const Vec2& from, const Vec2& to, double length, const Vec2& gravity) {
  const Vec2 down = gravity.norm() > 0.0 ? Vec2(gravity.normalized()) : Vec2(0.0, -1.0);
  const Vec2 middle = 0.5 * (from + to);
  double low = 0.0;
  double high = 2.0 * length;
  for (int round = 0; round < 40; ++round) {
    const double half = 0.5 * (low + high);
    (length_of(from, to, middle + half * down) < length ? low : high) = half;
  }
  return middle + low * down;
}

std::string cable_svg(const CaseRow& the_case, const CableRow& cable, const Vec2& end,
                      const Place& place, bool struck) {
  const Vec2 from = place(cable.anchor);
  const Vec2 to = place(end);
  const bool is_taut = cable.length - (end - cable.anchor).norm() <= looks_taut * cable.length;
  const std::string look = std::string(is_taut ? "taut" : "slack") + (struck ? " struck" : "");
  if (is_taut) {
    return fmt::format("<path class=\"{}\" d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\"></path>", look,
                       from.x(), from.y(), to.x(), to.y());
  }
  const Vec2 control = place(sag(cable.anchor, end, cable.length, the_case.gravity));
  return fmt::format("<path class=\"{}\" d=\"M{:.1f} {:.1f}Q{:.1f} {:.1f} {:.1f} {:.1f}\"></path>",
                     look, from.x(), from.y(), control.x(), control.y(), to.x(), to.y());
}

std::string anchor_svg(const Vec2& at) {
  return fmt::format(
      "<path class=\"anchor\" d=\"M{:.1f} {:.1f}h14m-14 0l4-5m1 5l4-5m1 5l4-5\"></path>",
      at.x() - 7.0, at.y());
}

std::string body_svg(const CaseRow& the_case, const Pose& pose, const Place& place) {
  const Vec2 centre = place(pose.centre);
  std::string out;
  for (const CableRow& cable : the_case.geometry) {
    const Vec2 end = place(end_of(cable, pose));
    out += fmt::format("M{:.1f} {:.1f}L{:.1f} {:.1f}", centre.x(), centre.y(), end.x(), end.y());
  }
  return fmt::format(
      "<path class=\"body\" d=\"{}\"></path><circle class=\"body\" cx=\"{:.1f}\" cy=\"{:.1f}\" "
      "r=\"5\"></circle>",
      out, centre.x(), centre.y());
}

/// The centre from one instant to another.
std::string trail_svg(const DrawnPath& path, double from, double until, const Place& place) {
  std::string points;
  for (int point = 0; point <= trail_points; ++point) {
    const double time = from + (until - from) * point / trail_points;
    const Vec2 at = place(pose_at(path, time).centre);
    points += fmt::format("{}{:.1f} {:.1f}", points.empty() ? "M" : "L", at.x(), at.y());
  }
  return "<path class=\"trail\" d=\"" + points + "\"></path>";
}

}  // namespace

std::optional<ImpactStills> impact_stills(const Report& report, const Replay& replay) {
  if (auto stills = worst_stills(report, replay)) {
    return stills;
  }
  for (const bool of_control : {true, false}) {
    for (std::size_t run = 0; run < report.runs.size(); ++run) {
      if ((report.runs[run].key.engine == control) == of_control) {
        if (auto stills = stills_of(report, replay, run, clearness)) {
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

Pose pose_at(const DrawnPath& path, double time) {
  const Eigen::Vector3d pose = path.pose(time);
  return {Vec2(pose.head<2>()), pose[2]};
}

double gap_of(const CableRow& cable, const Pose& pose) {
  return cable.length - (end_of(cable, pose) - cable.anchor).norm();
}

std::string still_svg(const CaseRow& the_case, const DrawnPath& path,
                      const std::array<double, 3>& times, std::size_t still, std::size_t struck) {
  const Place place = place_of_stills(the_case, path, times);
  const Pose pose = pose_at(path, times.at(still));
  std::string out =
      fmt::format("<svg viewBox=\"0 0 {} {}\" aria-hidden=\"true\">", still_width, height) +
      trail_svg(path, times.front(), times.at(still), place);
  for (std::size_t index = 0; index < the_case.geometry.size(); ++index) {
    const CableRow& cable = the_case.geometry[index];
    out += cable_svg(the_case, cable, end_of(cable, pose), place, index == struck) +
           anchor_svg(place(cable.anchor));
  }
  return out + body_svg(the_case, pose, place) + "</svg>";
}

}  // namespace tautline::bench
