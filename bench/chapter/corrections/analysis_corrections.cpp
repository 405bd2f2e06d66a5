#include "bench/chapter/corrections/corrections.hpp"

#include <fmt/format.h>

#include <numbers>
#include <string>
#include <utility>

#include "bench/chapter/corrections/checks.hpp"
#include "tautline/geometry.hpp"

namespace tautline::bench {
namespace {

const Lock& lock_of(const ChapterCase& solved) { return solved.settling.lock.value(); }

Correction settling_at_rest(const ChapterStudy& study) {
  std::size_t dissipative = 0;
  std::size_t swinging = 0;
  for (const ChapterCase& one : study.cases) {
    const auto& lock = one.settling.lock;
    dissipative += one.parameters.e < 1.0 && one.parameters.a > 0.0 ? 1U : 0U;
    swinging += lock && lock->permanent && lock->swing ? 1U : 0U;
  }
  const ChapterCase& standard = study.cases.front();
  const Swing& swing = lock_of(standard).swing.value();
  const double start = energy(standard.the_case, standard.the_case.initial);
  return {
      false,
      "Section 5.8",
      "Once g1 and g2 are close to zero the body settles to the equilibrium.",
      "With both cables taut one degree of freedom is left: a swing without losses. Only the "
      "point mass comes to rest.",
      fmt::format("{} of {} rigid bodies with e < 1 end in a swing that never stops. The standard "
                  "case keeps {:.1f} % of its energy and swings by {:.4f} rad ({:.0f} degrees).",
                  swinging, dissipative, 100.0 * swing.energy / start, swing.amplitude,
                  swing.amplitude * 180.0 / std::numbers::pi),
      {{"rigid_bodies", {count(dissipative)}},
       {"swinging", {count(swinging)}},
       {"energy_kept", {swing.energy / start}},
       {"amplitude", {swing.amplitude}}},
      {},
      true};
}

Correction rising_again(const ChapterStudy& study) {
  const ChapterCase& square = study.at("1933121100");
  constexpr double angle = 0.7;
  const Release found = release(square, angle);
  std::size_t permanent = 0;
  std::size_t locked = 0;
  for (const ChapterCase& one : study.cases) {
    const auto& lock = one.settling.lock;
    locked += lock && lock->swing ? 1U : 0U;
    permanent += lock && lock->swing && lock->permanent ? 1U : 0U;
  }
  return {
      false,
      "Section 5.8",
      "The body cannot rise out of the state with both cables taut, as gravity alone acts.",
      "It does when the swing is wide enough for a tension to fall to zero.",
      fmt::format("The body of case {}, let go at rest at {:g} rad with both cables taut, loses a "
                  "cable at t = {:.6f} and hits it again at t = {:.6f} with speed {:.4f}. Table "
                  "5.1's own swings are narrower: {} of {} keep both cables taut over a whole "
                  "period.",
                  square.number, angle, found.slack, found.impact, found.speed, permanent, locked),
      {{"angle", {angle}},
       {"slack", {found.slack}},
       {"impact", {found.impact}},
       {"speed", {found.speed}},
       {"swings", {count(locked)}},
       {"permanent", {count(permanent)}}}};
}

Correction radius(const ChapterStudy& study) {
  NumberList pairs{"pairs", {}};
  std::string list;
  for (const std::string_view body : {"910121100", "911121100", "921121100"}) {
    const ChapterCase& near = study.at("1" + std::string(body));
    const ChapterCase& far = study.at("2" + std::string(body));
    pairs.rows.push_back({{"cases", {near.number, far.number}},
                          {"largest_angle", {largest_angle(near), largest_angle(far)}},
                          {"lock", {lock_of(near).time, lock_of(far).time}}});
    list += fmt::format("{}{} and {}: {:.3f} and {:.3f} rad, {:.2f} and {:.2f}",
                        list.empty() ? "" : "; ", near.number, far.number, largest_angle(near),
                        largest_angle(far), lock_of(near).time, lock_of(far).time);
  }
  return {
      false,
      "Section 5.8.1, r",
      "No significant difference between r = 1.5 and r = 2.5.",
      "The largest rotation and the lock time change, and not in one direction: two bodies turn "
      "further on the longer cables, the third less far.",
      "Largest |theta| and lock time of cases " + list + ".",
      {},
      std::move(pairs)};
}

Correction flatness(const ChapterStudy& study) {
  const auto corner = [&](std::string_view number) {
    return corner_angle(study.at(number).parameters) * 180.0 / std::numbers::pi;
  };
  const double narrow = corner("1910121100");
  const double deep = corner("1911121100");
  const double wide = corner("1920121100");
  return {false,
          "Section 5.8.1, a and b",
          "The bottom of the region becomes flatter as a and b grow.",
          "With a it does. At angle 0 b drops out of Eqs. 5.65 and 5.93.",
          fmt::format("The boundaries meet at {:.2f} degrees for a = 0.1, b = 0, at {:.2f} for "
                      "a = b = 0.1, and at {:.2f} for a = 0.2, b = 0 (r = 1.5).",
                      narrow, deep, wide),
          {{"a_0.1_b_0", {narrow}}, {"a_0.1_b_0.1", {deep}}, {"a_0.2_b_0", {wide}}}};
}

Correction inertia(const ChapterStudy& study) {
  const Share against = inertia_pairs_against(study);
  const ChapterCase& ring = study.at("1910121100");
  const ChapterCase& square = study.at("1911121100");
  const ChapterCase& box = study.at("1921121100");
  return {
      false,
      "Section 5.8.1, rotation",
      "The smaller the body and its inertia, the more it rotates; larger bodies rotate less.",
      "So it is along each of the chapter's series, for the largest rotation. Inertia alone does "
      "not decide, and what rotation is left at the end follows no such rule.",
      fmt::format("In {} of {} pairs of bodies the one with more inertia turns further: case {} "
                  "with {:.4f} turns by {:.3f} rad, case {} with {:.4f} by {:.3f}. Case {} ends "
                  "in a swing of {:.4f} rad, the larger body of case {} in one of {:.4f}.",
                  against.times, against.of, ring.number, ring.the_case.body.inertia,
                  largest_angle(ring), square.number, square.the_case.body.inertia,
                  largest_angle(square), square.number, lock_of(square).swing.value().amplitude,
                  box.number, lock_of(box).swing.value().amplitude),
      {{"pairs_against", {count(against.times)}}, {"pairs", {count(against.of)}}}};
}

Correction restitution_study(const ChapterStudy& study) {
  NumberList cases{"cases", {}};
  std::string list;
  for (const char* number : {"1910121100", "1710121100", "1510121100"}) {
    const ChapterCase& one = study.at(number);
    const std::size_t impacts = impact_count(one.the_case, one.solution, counted_speed);
    const double kept = lock_of(one).swing.value().energy;
    cases.rows.push_back({{"case", {number}},
                          {"impacts", {count(impacts)}},
                          {"lock", {lock_of(one).time}},
                          {"energy", {kept}}});
    list += fmt::format("{}e = {}: {} impacts, t = {:.3f}, {:.5f}", list.empty() ? "" : "; ",
                        one.parameters.e, impacts, lock_of(one).time, kept);
  }
  return {false,
          "Section 5.8.1, e",
          "Varying e makes no characteristic difference.",
          "The kind of motion is the same; its length and what is left are not. Here the body that "
          "rebounds least keeps most.",
          "Counted impacts, lock time and energy of the swing that stays: " + list + ".",
          {},
          std::move(cases)};
}

Correction labels(const ChapterStudy& study) {
  std::size_t found = 0;
  for (const ChapterCase& one : study.cases) {
    found += one.number == "191012110" || one.number == "291012110" ? 1U : 0U;
  }
  return {false,
          "Figs. 5.6 and 5.7",
          "They show cases 191012110 and 291012110.",
          "The last digit is missing: 1910121100 and 2910121100, by the parameters printed below.",
          found == 0 ? "No row of Table 5.1 has such a number."
                     : fmt::format("{} rows of Table 5.1 have such a number.", found),
          {{"rows", {count(found)}}}};
}

}  // namespace

std::vector<Correction> analysis_corrections(const ChapterStudy& study) {
  return {settling_at_rest(study), rising_again(study),      radius(study), flatness(study),
          inertia(study),          restitution_study(study), labels(study)};
}

}  // namespace tautline::bench
