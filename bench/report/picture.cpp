#include "bench/report/picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>
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
  for (const CableRow& cable : the_case.geometry()) {
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
  if (index >= the_case.geometry().size() || impacts.rate_after[place] <= 0.0) {
    return std::nullopt;
  }
  const CableRow& cable = the_case.geometry()[index];
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
  return ImpactStills{&the_case, &run, &impacts, path, {}, index, place, times};
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

/// The stills of the run at `index` that are clearest.
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

/// The restitution that came of the impact at `place` [-]; none is 0.
double got(const ImpactColumns& impacts, std::size_t place) {
  return std::max(0.0, impacts.rate_after[place] / -impacts.rate_before[place]);
}

/// By how much it differs from the one asked for [-].
double restitution_error(const ImpactColumns& impacts, std::size_t place) {
  return std::abs(got(impacts, place) - impacts.requested[place]);
}

/// How far apart two bodies are at an instant [m].
double distance(const DrawnPath& one, const DrawnPath& other, double time) {
  return (pose_at(one, time).centre - pose_at(other, time).centre).norm();
}

std::string length_text(const CaseRow& the_case, double length) {
  return fmt::format("{:.2g}{}", length, is_nondimensional(the_case) ? "" : " m");
}

std::vector<std::string> captions(const ImpactStills& stills) {
  const ImpactColumns& impacts = *stills.impacts;
  const double before = -impacts.rate_before[stills.impact];
  const double after = impacts.rate_after[stills.impact];
  const std::string closing =
      fmt::format("taut: closes at {}", speed_text(*stills.the_case, before));
  if (stills.exact) {
    return {"before the impact", closing,
            fmt::format("then: {} apart",
                        length_text(*stills.the_case,
                                    distance(stills.path, *stills.exact, stills.times[2])))};
  }
  return {"slack: the body flies", closing,
          fmt::format("rebound: opens at {}", speed_text(*stills.the_case, after))};
}

/// "Restitution asked: 0.5; got: 0.65."
std::string asked_and_got(const ImpactStills& stills) {
  const auto shown = [](double value) { return std::round(1000.0 * value) / 1000.0; };
  return fmt::format("Restitution asked: <b>{:.3g}</b>; got: <b>{:.3g}</b>.",
                     shown(stills.impacts->requested[stills.impact]),
                     shown(got(*stills.impacts, stills.impact)));
}

std::string legend_html(const ImpactStills& stills) {
  const ImpactColumns& impacts = *stills.impacts;
  const RunKey& key = stills.run->key;
  const double before = -impacts.rate_before[stills.impact];
  if (stills.exact) {
    return fmt::format(
        "<figcaption>\n<p>A cable does nothing until it is taut. Then it throws the body back with "
        "a "
        "part of its speed, the restitution: 1 is all of it, 0 is none.</p>\n<p>The largest error "
        "of a rebound that three stills can show: {}</p>\n"
        "<p class=\"pair\"><span class=\"is-exact\">exact motion</span> <span "
        "class=\"is-engine\">{} {}</span></p>\n<p class=\"note\">One start, case <code>{}</code>, "
        "step {:g}{}. <a href=\"#replay\">Play both</a></p>\n</figcaption>\n",
        asked_and_got(stills), html_text(key.engine), html_text(key.model), html_text(key.the_case),
        key.step, is_nondimensional(*stills.the_case) ? "" : " s");
  }
  return fmt::format(
      "<figcaption>\n<p>A cable does nothing until it is taut, and then acts in an instant. Case "
      "<code>{}</code> in <code>{} {}</code>, impact at {}: cable {} closes at {} and opens at {}. "
      "{} {}</p>\n</figcaption>\n",
      html_text(key.the_case), html_text(key.engine), html_text(key.model), instant_text(stills, 1),
      stills.cable, speed_text(*stills.the_case, before),
      speed_text(*stills.the_case, impacts.rate_after[stills.impact]), asked_and_got(stills),
      key.engine == control ? "Engines are compared with this motion." : "");
}

/// An error of a restitution that is seen [-].
constexpr double visible_error = 0.05;

/// Up to its impact a run is where the exact motion is, within this part of what the case covers
/// [-]; after it the two are seen to part by so much, better by more.
constexpr double same_place = 0.01;
constexpr double parted = 0.02;
constexpr double well_parted = 0.04;

/// A run's impact is the exact one that it is later or earlier than by no more of its steps.
constexpr double late_steps = 5.0;

/// The instants of the exact impacts of a case, of those of `cable` alone or of all [s].
std::vector<double> exact_impacts(const EventColumns& events, std::optional<std::size_t> cable) {
  std::vector<double> times;
  for (std::size_t place = 0; place < events.time.size(); ++place) {
    const auto& cables = events.cables[place];
    if (events.kind[place] == "impact" &&
        (!cable || std::find(cables.begin(), cables.end(), *cable) != cables.end())) {
      times.push_back(events.time[place]);
    }
  }
  return times;
}

/// The first of `times`, which rise, that is later than `time`.
std::optional<double> next_after(const std::vector<double>& times, double time) {
  const auto found = std::upper_bound(times.begin(), times.end(), time);
  return found != times.end() ? std::optional(*found) : std::nullopt;
}

/// The run's impact at `place` with the exact motion beside it; none where the two are not at one
/// place up to it, or do not part by `least_apart` of what the case covers before the next exact
/// one, or no cable is slack by `least_slack` before it, of its length.
std::optional<ImpactStills> pair_of(const CaseRow& the_case, const RunRow& run,
                                    const ImpactColumns& impacts, const DrawnPath& path,
                                    const EventColumns& events, const DrawnPath& exact,
                                    std::size_t place, double least_slack, double least_apart) {
  const std::size_t index = impacts.cable[place];
  const std::vector<double> of_cable = exact_impacts(events, index);
  if (index >= the_case.geometry().size() || of_cable.empty()) {
    return std::nullopt;
  }
  const double mine = impacts.time[place];
  const double time = *std::min_element(of_cable.begin(), of_cable.end(), [&](double a, double b) {
    return std::abs(a - mine) < std::abs(b - mine);
  });
  if (std::abs(time - mine) > late_steps * run.key.step) {
    return std::nullopt;  // another impact
  }
  const std::vector<double> all = exact_impacts(events, {});
  const auto found = std::lower_bound(all.begin(), all.end(), time);
  const double before = found != all.begin() ? *std::prev(found) : 0.0;
  const double end = std::min(next_after(all, time).value_or(2 * time - before), the_case.horizon);
  std::array<double, 3> times = {slackest(the_case, exact, before, time), time, time};
  for (int instant = 1; instant <= instants; ++instant) {
    const double later = time + (end - time) * instant / instants;
    if (distance(path, exact, later) > distance(path, exact, times[2])) {
      times[2] = later;
    }
  }
  const double same = same_place * the_case.extent;
  if (distance(path, exact, times[0]) > same || distance(path, exact, time) > same ||
      least_gap(the_case, exact, times[0]) < least_slack ||
      least_gap(the_case, path, times[0]) < least_slack ||
      distance(path, exact, times[2]) < least_apart * the_case.extent) {
    return std::nullopt;
  }
  return ImpactStills{&the_case, &run, &impacts, path, exact, index, place, times};
}

/// The impact of an engine that is off the most, of the runs whose rebounds are off and of the
/// impacts that can be read; none where no error is seen. `least_slack` and `least_apart`: see
/// pair_of.
std::optional<ImpactStills> worst_pair(const Report& report, const Replay& replay,
                                       double least_slack, double least_apart) {
  std::optional<ImpactStills> worst;
  double largest = visible_error;
  for (std::size_t run = 0; run < report.runs.size(); ++run) {
    const RunRow& row = report.runs[run];
    const auto& [path, impacts] = replay.of_run(run);
    const CaseRow* const the_case = case_of(report, row);
    if (row.key.engine == control || !row.judgement || !row.judgement->rebounds.wrong() ||
        the_case == nullptr || !impacts || !path) {
      continue;
    }
    const CaseReplay& of_case =
        replay.cases.at(static_cast<std::size_t>(the_case - report.cases.data()));
    const DrawnPath drawn(*path);
    const DrawnPath exact(of_case.path);
    const double slowest = row.judgement->rebounds.slowest.value_or(0.0);
    for (std::size_t place = 0; place < impacts->time.size(); ++place) {
      if (-impacts->rate_before[place] < slowest || restitution_error(*impacts, place) <= largest) {
        continue;
      }
      if (auto pair = pair_of(*the_case, row, *impacts, drawn, of_case.events, exact, place,
                              least_slack, least_apart)) {
        largest = restitution_error(*impacts, place);
        worst = std::move(pair);
      }
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

/// The instant of a point of the way from one instant to another.
double trail_time(double from, double until, int point) {
  return from + (until - from) * point / trail_points;
}

/// The end of a cable on the body [m].
Vec2 end_of(const CableRow& cable, const Pose& pose) {
  return attachment_point(State{.position = pose.centre, .angle = pose.angle},
                          Cable{.attachment = cable.attachment});
}

/// Room for the anchors, for each body at every still and for the ways between them.
Place place_of_stills(const ImpactStills& stills) {
  std::vector<Vec2> points;
  for (const CableRow& cable : stills.the_case->geometry()) {
    points.push_back(cable.anchor);
  }
  for (const DrawnPath* path : {&stills.path, stills.exact ? &*stills.exact : &stills.path}) {
    for (const CableRow& cable : stills.the_case->geometry()) {
      for (const double time : stills.times) {
        points.push_back(end_of(cable, pose_at(*path, time)));
      }
    }
    for (int point = 0; point <= trail_points; ++point) {
      const double time = trail_time(stills.times.front(), stills.times.back(), point);
      points.push_back(pose_at(*path, time).centre);
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
  const Vec2 control = place(sag(cable.anchor, end, cable.length, the_case.plane->gravity));
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
  for (const CableRow& cable : the_case.geometry()) {
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
    const Vec2 at = place(pose_at(path, trail_time(from, until, point)).centre);
    points += fmt::format("{}{:.1f} {:.1f}", points.empty() ? "M" : "L", at.x(), at.y());
  }
  return "<path class=\"trail\" d=\"" + points + "\"></path>";
}

/// A body at `still`, with its cables and the way that it came.
std::string motion_svg(const ImpactStills& stills, const DrawnPath& path, std::size_t still,
                       const Place& place) {
  const Pose pose = pose_at(path, stills.times.at(still));
  std::string out = trail_svg(path, stills.times.front(), stills.times.at(still), place);
  for (std::size_t index = 0; index < stills.the_case->geometry().size(); ++index) {
    const CableRow& cable = stills.the_case->geometry()[index];
    out += cable_svg(*stills.the_case, cable, end_of(cable, pose), place, index == stills.cable);
  }
  return out + body_svg(*stills.the_case, pose, place);
}

}  // namespace

std::optional<ImpactStills> impact_stills(const Report& report, const Replay& replay) {
  for (const double least_apart : {well_parted, parted}) {
    for (const double least_slack : {visible_gap, -1.0}) {  // better a slack cable before it
      if (auto stills = worst_pair(report, replay, least_slack, least_apart)) {
        return stills;
      }
    }
  }
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

std::string picture_html(const ImpactStills* stills) {
  if (stills == nullptr) {
    return "";
  }
  const std::vector<std::string> texts = captions(*stills);
  const RunKey& key = stills->run->key;
  std::string out =
      !stills->exact
          ? "<figure class=\"stills\">\n<ol>\n"
          : fmt::format(
                "<figure class=\"stills\" data-case=\"{}\" data-engine=\"{}\" "
                "data-model=\"{}\" data-step=\"{}\">\n<ol>\n",
                html_text(key.the_case), html_text(key.engine), html_text(key.model), key.step);
  for (std::size_t still = 0; still < stills->times.size(); ++still) {
    out += fmt::format("<li>{}<span class=\"still\"><b>{}</b> {}</span></li>\n",
                       still_svg(*stills, still), instant_text(*stills, still), texts[still]);
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

std::string still_svg(const ImpactStills& stills, std::size_t still) {
  const Place place = place_of_stills(stills);
  std::string out =
      fmt::format("<svg viewBox=\"0 0 {} {}\" aria-hidden=\"true\">", still_width, height);
  for (const CableRow& cable : stills.the_case->geometry()) {
    out += anchor_svg(place(cable.anchor));
  }
  if (!stills.exact) {
    return out + motion_svg(stills, stills.path, still, place) + "</svg>";
  }
  return out + "<g class=\"is-exact\">" + motion_svg(stills, *stills.exact, still, place) +
         "</g><g class=\"is-engine\">" + motion_svg(stills, stills.path, still, place) +
         "</g></svg>";
}

}  // namespace tautline::bench
