#include "bench/report/html/picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "bench/base/html.hpp"
#include "bench/report/html/stills_svg.hpp"
#include "bench/report/tables/columns.hpp"
#include "bench/report/words.hpp"

namespace tautline::bench {
namespace {

/// A cable with less gap than this, of its length, does not look slack [-].
constexpr double visible = 0.03;

/// An impact and a sample this near are one [s]: paths hold their impacts' instants.
constexpr double same_instant = 1e-6;

const CaseRow* case_of(const Report& report, const RunRow& run) {
  const auto found = std::find_if(report.cases.begin(), report.cases.end(),
                                  [&](const CaseRow& row) { return row.name == run.key.the_case; });
  return found != report.cases.end() ? &*found : nullptr;
}

/// The sample with the largest gap in [first, last).
std::size_t slackest(const CableRow& cable, const Path& path, std::size_t first, std::size_t last) {
  std::size_t best = first;
  for (std::size_t sample = first; sample < last; ++sample) {
    if (gap_at(cable, path, sample) > gap_at(cable, path, best)) {
      best = sample;
    }
  }
  return best;
}

/// The first sample at or after `time`.
std::size_t sample_at(const Path& path, double time) {
  return static_cast<std::size_t>(std::lower_bound(path.time.begin(), path.time.end(), time) -
                                  path.time.begin());
}

/// The stills of the impact at `place`; none where its cable does not look slack around it.
std::optional<ImpactStills> stills_of(const CaseRow& the_case, const RunRow& run,
                                      std::size_t place) {
  const ImpactColumns& impacts = *run.impacts;
  const Path& path = *run.path;
  const std::size_t index = impacts.cable[place];
  if (index >= the_case.geometry.size() || impacts.rate_after[place] <= 0.0) {
    return std::nullopt;
  }
  const CableRow& cable = the_case.geometry[index];
  const double time = impacts.time[place];
  const double before = place > 0 ? impacts.time[place - 1] : 0.0;
  const double after = place + 1 < impacts.time.size() ? impacts.time[place + 1] : path.time.back();
  const std::size_t hit = sample_at(path, time - same_instant);
  if (hit >= path.time.size() || std::abs(path.time[hit] - time) > same_instant) {
    return std::nullopt;
  }
  const std::size_t slack =
      slackest(cable, path, sample_at(path, before + same_instant), std::max<std::size_t>(hit, 1));
  const std::size_t next = sample_at(path, time + same_instant);
  const std::size_t rebound = slackest(cable, path, next, sample_at(path, after - same_instant));
  const double least = visible * cable.length;
  if (slack >= hit || rebound <= hit || rebound >= path.time.size() ||
      gap_at(cable, path, slack) < least || gap_at(cable, path, rebound) < least) {
    return std::nullopt;
  }
  const std::size_t closing = slack + (hit - slack) / 2;
  return ImpactStills{&the_case, &run, index, place, {slack, closing, hit, rebound}};
}

std::optional<ImpactStills> stills_of(const Report& report, const RunRow& run) {
  const CaseRow* const the_case = case_of(report, run);
  if (the_case == nullptr || !run.path || run.path->time.empty() || !run.impacts) {
    return std::nullopt;
  }
  for (std::size_t place = 0; place < run.impacts->time.size(); ++place) {
    if (auto stills = stills_of(*the_case, run, place)) {
      return stills;
    }
  }
  return std::nullopt;
}

/// "1.23 m/s", or "1.23" of a case without units.
std::string speed_text(const CaseRow& the_case, double speed) {
  return fmt::format("{:.3g}{}", speed, is_nondimensional(the_case) ? "" : " m/s");
}

std::string instant_text(const ImpactStills& stills, std::size_t still) {
  return fmt::format("t = {:.3f}{}", stills.run->path->time[stills.samples.at(still)],
                     is_nondimensional(*stills.the_case) ? "" : " s");
}

std::vector<std::string> captions(const ImpactStills& stills) {
  const ImpactColumns& impacts = *stills.run->impacts;
  const double before = -impacts.rate_before[stills.impact];
  const double after = impacts.rate_after[stills.impact];
  return {
      "slack: it flies freely",
      "closing",
      fmt::format("taut: closing at {}", speed_text(*stills.the_case, before)),
      fmt::format("rebound: opens at {}", speed_text(*stills.the_case, after)),
  };
}

std::string legend_html(const ImpactStills& stills) {
  const ImpactColumns& impacts = *stills.run->impacts;
  const RunKey& key = stills.run->key;
  const double before = -impacts.rate_before[stills.impact];
  const double after = impacts.rate_after[stills.impact];
  return fmt::format(
      "<figcaption>A cable pulls only when it is taut, and then at once. Case <code>{}</code> in "
      "<code>{} {}</code>, impact at {}: cable {} closes at {} and opens at {}. Restitution asked: "
      "<b>{:.4g}</b>; got: <b>{:.4g}</b>. Engines are held against this.</figcaption>\n",
      html_text(key.the_case), html_text(key.engine), html_text(key.model), instant_text(stills, 2),
      stills.cable, speed_text(*stills.the_case, before), speed_text(*stills.the_case, after),
      impacts.requested[stills.impact], after / before);
}

}  // namespace

double gap_at(const CableRow& cable, const Path& path, std::size_t sample) {
  return cable.length - (end_of(cable, path, sample) - cable.anchor).norm();
}

std::optional<ImpactStills> impact_stills(const Report& report) {
  for (const bool of_control : {true, false}) {
    for (const RunRow& run : report.runs) {
      if ((run.key.engine == control) == of_control) {
        if (auto stills = stills_of(report, run)) {
          return stills;
        }
      }
    }
  }
  return std::nullopt;
}

std::string picture_html(const Report& report) {
  const std::optional<ImpactStills> stills = impact_stills(report);
  if (!stills) {
    return "";
  }
  const std::vector<std::string> texts = captions(*stills);
  std::string out = "<figure class=\"stills\">\n<ol>\n";
  for (std::size_t still = 0; still < stills->samples.size(); ++still) {
    out += fmt::format(
        "<li>{}<span class=\"still\"><b>{}</b> {}</span></li>\n",
        still_svg(*stills->the_case, *stills->run->path, stills->samples, still, stills->cable),
        instant_text(*stills, still), texts[still]);
  }
  return out + "</ol>\n" + legend_html(*stills) + "</figure>\n";
}

}  // namespace tautline::bench
