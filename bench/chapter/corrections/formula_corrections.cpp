#include "bench/chapter/corrections/corrections.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string>

#include "bench/chapter/corrections/checks.hpp"
#include "bench/chapter/corrections/draws.hpp"

namespace tautline::bench {
namespace {

Correction small_body() {
  const std::vector<Shrunk> shrunk = shrunk_bodies();
  const double point = point_rebound();
  NumberList bodies{"bodies", {}};
  std::string list;
  for (const Shrunk& one : shrunk) {
    bodies.rows.push_back({{"a", {one.size}}, {"ring", {one.ring}}, {"inertia_1", {one.fixed}}});
    list += fmt::format("{}{:.6f} at a = {:g}", list.empty() ? "" : ", ", one.ring, one.size);
  }
  return {
      false,
      "Sections 5.1 and 5.8.2",
      "The point mass is the rigid body whose dimensions are infinitely small.",
      "It is the body whose cables have no lever arm, at any inertia. A ring that shrinks keeps "
      "the ratio of arm to radius of gyration, so its impacts never become those of a point.",
      fmt::format("Speed of the centre after the standard start's first impact: point mass "
                  "{:.6f}; ring {}; with the inertia kept at 1 instead, {:.6f} at a = {:g}.",
                  point, list, shrunk.back().fixed, shrunk.back().size),
      {{"point_mass", {point}}},
      std::move(bodies)};
}

Correction upper_limit(const ChapterStudy& study) {
  const ChapterCase& square = study.at("1933121100");
  const double excess = ceiling_excess(square);
  return {
      false,
      "Eq. 5.4",
      "Y <= H + B keeps the body below the supports.",
      "It keeps the centre below them; an upright body needs Y <= H. Eqs. 5.22 and 5.23 are the "
      "conditions meant.",
      fmt::format("Case {}: Eq. 5.4 lets the attachments rise {:.2f} above the supports.",
                  square.number, excess),
      {{"excess", {excess}}}};
}

Correction time_unit(const ChapterStudy& study) {
  const TimeScale scale = time_scale(study.cases.front());
  return {false,
          "Eq. 5.24",
          "Times are divided by g/S (as the text reaches us).",
          "By sqrt(S/g), as Eq. 5.31 has it.",
          fmt::format("The standard case with S = {:g} m, g = {:g} m/s^2 has its first impact at "
                      "{:.6f} s, {:.6f} s per unit of nondimensional time: sqrt(S/g) = {:.6f} s, "
                      "g/S = {:.3f} 1/s^2.",
                      scale.spacing, scale.gravity, scale.first_impact, scale.ratio,
                      std::sqrt(scale.spacing / scale.gravity), scale.gravity / scale.spacing),
          {{"ratio", {scale.ratio}}, {"sqrt_S_g", {std::sqrt(scale.spacing / scale.gravity)}}}};
}

Correction missing_law(const ChapterStudy& study) {
  const ChapterCase& soft = study.at("1510121100");
  const Lock& lock = soft.settling.lock.value();
  const OtherLaw other = sequential_law(soft);
  return {
      false,
      "Section 5.5",
      "One law, for one cable, is all that impacts need.",
      "A cable also closes while the other is held taut, and there the law decides. These tables "
      "use the simultaneous law, to which time stepping converges; the sequential one differs.",
      fmt::format("Case {}: lock at t = {:.5f} with swing energy {:.6f}; under the sequential law "
                  "at t = {:.5f} with {:.6f}.",
                  soft.number, lock.time, lock.swing.value().energy, other.lock, other.energy),
      {{"lock", {lock.time}},
       {"energy", {lock.swing->energy}},
       {"sequential_lock", {other.lock}},
       {"sequential_energy", {other.energy}}}};
}

Correction spin_reversal() {
  const Share kept = spins_kept();
  return {
      false,
      "Section 5.5.2",
      "An impact makes the body turn in the opposite direction.",
      "The spin changes by -(1 + e) v_n l / (Ic + l^2), l being the cable's lever arm; its sign "
      "may stay.",
      fmt::format("{} of {} random impacts keep it (seed {}).", kept.times, kept.of, chapter_seed),
      {{"kept", {count(kept.times)}},
       {"impacts", {count(kept.of)}},
       {"seed", {count(chapter_seed)}}}};
}

Correction slope_sign() {
  const Share wrong = slope_signs_wrong();
  return {
      false,
      "Eq. 5.66",
      "The slope of g1 = 0 is positive where KWx is (as the text reaches us; its minus sign may "
      "have been lost there).",
      "It needs a minus sign. The unit vector along the cable needs no slope, and also holds "
      "where the cable is level.",
      fmt::format("The sign is wrong in {} of {} random poses (seed {}).", wrong.times, wrong.of,
                  chapter_seed),
      {{"wrong", {count(wrong.times)}},
       {"poses", {count(wrong.of)}},
       {"seed", {count(chapter_seed)}}}};
}

Correction mass_and_inertia(const ChapterStudy& study) {
  const SpinChange change = heavy_spin_change(study.cases.front());
  return {false,
          "Eqs. 5.75 to 5.79",
          "The mass cancels, while Ic stays as it is.",
          "Ic must be divided by the mass (and by S^2) as well; with m = 1 it makes no difference.",
          fmt::format("The standard body with mass 2: its first impact changes the spin by {:.6f}; "
                      "Eq. 5.79 says {:.6f}.",
                      change.exact, change.printed),
          {{"exact", {change.exact}}, {"printed", {change.printed}}}};
}

Correction resolution(const ChapterStudy& study) {
  const ChapterCase& standard = study.cases.front();
  const double slowest = slowest_resolved(standard);
  const std::size_t all = impact_count(standard.the_case, standard.solution, 0.0);
  const std::size_t seen = impact_count(standard.the_case, standard.solution, slowest);
  return {false,
          "Section 5.6",
          "Impacts are located by Newton's method to 1e-6 in g.",
          "A bounce that opens g by less than that cannot be told from none; the accumulations of "
          "impacts in which all these motions end are made of such bounces.",
          fmt::format("Standard case, near the equilibrium: impacts slower than {:.1e}. Of the {} "
                      "that precede the completed accumulation, {} are slower.",
                      slowest, all, all - seen),
          {{"speed", {slowest}}, {"impacts", {count(all)}}, {"unresolved", {count(all - seen)}}}};
}

}  // namespace

std::vector<Correction> formula_corrections(const ChapterStudy& study) {
  return {small_body(),    upper_limit(study), time_unit(study),        missing_law(study),
          spin_reversal(), slope_sign(),       mass_and_inertia(study), resolution(study)};
}

}  // namespace tautline::bench
