#include "bench/chapter/figures/figures.hpp"

#include <fmt/format.h>

#include <numbers>

#include "bench/base/listed.hpp"
#include "bench/chapter/corrections/checks.hpp"
#include "bench/chapter/tables/print.hpp"
#include "tautline/geometry.hpp"

namespace tautline::bench {
namespace {

enum class Plot { trajectory, rotation, impacts };

/// A figure of the chapter: what its caption names.
struct Caption {
  std::string_view figure;
  Plot plot;
  std::string_view number;   // of the case
  std::string_view chapter;  // what the text says of it
};

constexpr std::string_view of_size =
    "The chapter sees no significant difference between the two radii, but for the size of the "
    "region and its sharper point at the bottom when r = 1.5.";
constexpr std::string_view of_flatness =
    "The chapter says that the bottom of the region becomes flatter as a, b and r grow.";
constexpr std::string_view of_rotation =
    "The chapter says that rotations become smaller and fewer as a grows from 0.1 to 0.3, because "
    "the moment of inertia grows.";
constexpr std::string_view of_restitution =
    "The chapter sees no characteristic difference as e falls from 1 to 0.5.";
constexpr std::string_view of_elastic =
    "The chapter notes that the rotation passes pi/2, its limit, as no energy is lost; its time "
    "scale is not the one of the next three figures.";
constexpr std::string_view of_point =
    "The chapter shows the same trajectory twice, once by the formulas of the point mass and once "
    "by those of the rigid body without dimensions.";

constexpr Caption captions[] = {
    {"5.6", Plot::trajectory, "1910121100", of_size},
    {"5.7", Plot::trajectory, "2910121100", of_size},
    {"5.8", Plot::trajectory, "1911121100", of_flatness},
    {"5.9", Plot::trajectory, "2911121100", of_flatness},
    {"5.10", Plot::trajectory, "1921121100", of_flatness},
    {"5.11", Plot::trajectory, "2921121100", of_flatness},
    {"5.12", Plot::rotation, "1911121100", of_rotation},
    {"5.13", Plot::rotation, "1921121100", of_rotation},
    {"5.14", Plot::rotation, "1931121100", of_rotation},
    {"5.15", Plot::impacts, "1110121100", of_elastic},
    {"5.16", Plot::impacts, "1910121100", of_restitution},
    {"5.17", Plot::impacts, "1710121100", of_restitution},
    {"5.18", Plot::impacts, "1510121100", of_restitution},
    {"5.19", Plot::trajectory, "1900461100", of_point},
    {"5.20", Plot::trajectory, "1900461100", of_point},
};

/// "5.6" as "figure_5_06": sorted by name is sorted by number.
std::string stem(std::string_view figure) {
  return fmt::format("figure_5_{:0>2}", figure.substr(2));
}

/// The last impact that Table 5.3 prints.
double last_printed_impact() {
  return printed_value(split(printed_table_5_3().back().cells).front());
}

/// From where the chapter and the exact motion part, for a plot to show.
std::vector<FigureMark> marks(const ChapterStudy& study, const ChapterCase& solved) {
  std::vector<FigureMark> result;
  if (is_point_mass(solved.the_case) || &solved == &study.rigid_point) {
    result.push_back({last_printed_impact(), "the chapter's last impact"});
  }
  if (solved.parameters.e == 1.0) {  // exactly: as given
    result.push_back({study.limit_time, "the chapter's rotation limit"});
  }
  if (const auto& lock = solved.settling.lock) {
    result.push_back({lock->time, lock->rests ? "at rest" : "both cables taut from here on"});
  }
  return result;
}

/// What the motion does at its end, and where the chapter takes leave of it.
std::string end_sentence(const ChapterStudy& study, const ChapterCase& solved) {
  const auto& lock = solved.settling.lock;
  const double start = energy(solved.the_case, solved.the_case.initial);
  if (!lock) {
    return fmt::format(
        "**The chapter's run stops at its limit of pi/2, at t = {:.4f}; the exact motion goes "
        "on.** "
        "No cable ever stays taut, and the energy is {:.6f} at t = {:g} as at the start.",
        study.limit_time, energy(solved.the_case, solved.solution.at(solved.solution.end_time())),
        solved.solution.end_time());
  }
  if (lock->rests) {
    return fmt::format(
        "**The chapter's motion ends with an impact at t = {:.6f}; the exact one goes on until it "
        "comes to rest at t = {:.4f}.**",
        last_printed_impact(), lock->time);
  }
  return fmt::format(
      "**From t = {:.4f} on both cables are taut, which the chapter takes for settled; the body "
      "swings on without end:** amplitude {:.4f} rad, period {:.4f}, energy {:.6f}, which is "
      "{:.1f} % of the {:.3f} it started with.",
      lock->time, lock->swing->amplitude, lock->swing->period, lock->swing->energy,
      100.0 * lock->swing->energy / start, start);
}

/// What the motion shows on the point that the chapter makes.
std::string finding(const ChapterStudy& study, const ChapterCase& solved, Plot plot) {
  const Breakwater& p = solved.parameters;
  if (plot == Plot::impacts) {
    return fmt::format("{} impacts are faster than {:g}, the fastest {:.4f}. ",
                       impact_count(solved.the_case, solved.solution, counted_speed), counted_speed,
                       fastest_impact(solved));
  }
  if (plot == Plot::rotation) {
    return fmt::format("Inertia {:.4f}, largest |theta| {:.4f} rad. ", solved.the_case.body.inertia,
                       largest_angle(solved));
  }
  std::string result =
      fmt::format("At angle 0 the boundaries meet at {:.1f} degrees{}. ",
                  corner_angle(p) * 180.0 / std::numbers::pi, p.b > 0.0 ? ", for any b" : "");
  if (p.a > 0.0) {
    result += fmt::format("The largest |theta| is {:.4f} rad. ", largest_angle(solved));
  } else {
    const double difference = largest_difference(study.at(solved.number), study.rigid_point);
    result +=
        difference == 0.0
            ? "The motions of Figs. 5.19 and 5.20 are the same to the last bit. "
            : fmt::format("The motions of Figs. 5.19 and 5.20 differ by up to {:g}. ", difference);
  }
  return result;
}

ChapterFigure figure(const ChapterStudy& study, const Caption& caption) {
  const bool rigid_point = caption.figure == "5.20";
  const ChapterCase& solved = rigid_point ? study.rigid_point : study.at(caption.number);
  ChapterFigure result;
  result.number = caption.figure;
  result.case_number = caption.number;
  result.file = stem(caption.figure) + ".csv";
  result.chapter = caption.chapter;
  result.truth = finding(study, solved, caption.plot) + end_sentence(study, solved);
  result.marks = marks(study, solved);
  const auto& [r, e, a, b, shape, initial, duration] = solved.parameters;
  const std::string body = fmt::format("r = {}, e = {}, a = {}, b = {}", r, e, a, b);
  switch (caption.plot) {
    case Plot::trajectory:
      result.title = fmt::format("y over x, {}case {} ({})",
                                 a > 0.0       ? ""
                                 : rigid_point ? "a rigid body without dimensions, "
                                               : "the point mass, ",
                                 caption.number, body);
      result.data = motion_data(solved);
      result.x = motion_column::x;
      result.y = motion_column::y;
      result.boundary = {stem(caption.figure) + "_boundary.csv", boundary_data(solved.parameters)};
      break;
    case Plot::rotation:
      result.title = fmt::format("theta over t, case {} ({})", caption.number, body);
      result.data = motion_data(solved);
      result.x = motion_column::time;
      result.y = motion_column::angle;
      break;
    case Plot::impacts:
      result.title =
          fmt::format("normal velocity before impact over t, case {} ({})", caption.number, body);
      result.data = impacts_data(solved);
      result.x = impacts_column::time;
      result.y = impacts_column::speed;
      result.by = impacts_column::cable;
      break;
  }
  return result;
}

}  // namespace

std::vector<ChapterFigure> chapter_figures(const ChapterStudy& study) {
  return listed(captions, [&](const Caption& caption) { return figure(study, caption); });
}

}  // namespace tautline::bench
