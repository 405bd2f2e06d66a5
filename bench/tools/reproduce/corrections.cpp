#include "bench/tools/reproduce/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <utility>

#include "bench/tools/reproduce/checks.hpp"
#include "bench/tools/reproduce/source.hpp"
#include "tautline/geometry.hpp"

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

Correction special_code(const ChapterStudy& study) {
  const double difference = largest_difference(study.point_mass(), study.rigid_point);
  return {
      false,
      "Section 5.8.2",
      "The point mass needs a modified matrix, or Eq. 5.80 is singular.",
      "It needs none: with a lever arm of 0 the closed form of the impulse holds at any inertia "
      "above 0. The angle then takes no part.",
      fmt::format("The point mass and a body with inertia {:g} and no lever arm differ by {:g} at "
                  "most, up to t = {:g}.",
                  study.rigid_point.the_case.body.inertia, difference,
                  study.rigid_point.solution.end_time()),
      {{"largest_difference", {difference}}}};
}

Correction state_at_15(const ChapterStudy& study) {
  const std::vector<double> errors = table_5_3_errors(study, "t = 15");
  return {
      false,
      "Table 5.3, t = 15",
      "Six decimals of the state after 15 time units.",
      "Not all of them are right: each impact is located to 1e-6 in g only, and there are many.",
      fmt::format("Printed less exact: x {:+.1e}, x' {:+.1e}, y {:+.1e}, y' {:+.1e}.", errors[1],
                  errors[2], errors[3], errors[4]),
      {{"x", {errors[1]}}, {"vx", {errors[2]}}, {"y", {errors[3]}}, {"vy", {errors[4]}}}};
}

Correction late_constraints(const ChapterStudy& study) {
  const std::vector<std::string_view> printed = split(find_printed_state("1st impact -").cells);
  const ChapterCase& point = study.point_mass();
  const Cable& right = point.the_case.cables[1];
  const auto g1 = [&](const Vec2& position) {
    State state;
    state.position = position;
    const double open = gap(right, state);
    return open * (open - 2.0 * right.length);
  };
  const double own = g1({printed_value(printed[1]), printed_value(printed[3])});
  const double end = std::ceil(printed_value(printed[0]) / figure_step) * figure_step;
  const Arc& flight = point.solution.arcs().front();
  const double later = g1(flight.after(end, point.solution.gravity()).position);
  return {
      false,
      "Table 5.3, g1 at the first impact",
      fmt::format("g1 = {} at the first impact.", printed[5]),
      "That is g1 at the end of the time step in which the impact falls, as if there had been no "
      "impact.",
      fmt::format("From the printed x and y of the impact: g1 = {:.6f}. From the flight before it, "
                  "followed to t = {:g}: g1 = {:.6f}.",
                  own, end, later),
      {{"printed", {printed_value(printed[5])}}, {"at_impact", {own}}, {"at_step_end", {later}}}};
}

Correction last_impact(const ChapterStudy& study) {
  const double printed = printed_value(split(printed_table_5_3().back().cells).front());
  const ChapterCase& point = study.point_mass();
  const auto later = std::count_if(
      point.solution.events().begin(), point.solution.events().end(), [&](const Event& event) {
        return event.time > printed && event.kind == EventKind::impact &&
               closing_speed(point.the_case, event) > counted_speed;
      });
  return {
      false,
      "Table 5.3, last impact",
      fmt::format("The last impact is at t = {:.6f}.", printed),
      "A program that cannot tell small bounces from none ends in the first accumulation of "
      "impacts on one cable. From there the body slides along that cable's boundary until it hits "
      "the other cable, again and again.",
      fmt::format("{} impacts faster than {:g} follow; the point mass rests from t = {:.4f} on.",
                  later, counted_speed, point.settling.lock.value().time),
      {{"printed", {printed}},
       {"later_impacts", {static_cast<long>(later)}},
       {"rest", {point.settling.lock.value().time}}}};
}

Correction rotation_limit(const ChapterStudy& study) {
  std::size_t others = 0;
  for (const ChapterCase& one : study.cases) {
    others += one.parameters.e < 1.0 && largest_angle(one) >= std::numbers::pi / 2 ? 1U : 0U;
  }
  return {true,
          "Section 5.8.1, e = 1",
          "Without losses the rotation passes pi/2.",
          "It does.",
          fmt::format("Case 1110121100 reaches it at t = {:.5f}; {} other case does.",
                      study.limit_time, others == 0 ? "no" : std::to_string(others)),
          {{"time", {study.limit_time}}, {"others", {count(others)}}}};
}

Correction admissible_starts(const ChapterStudy& study) {
  double largest = -std::numeric_limits<double>::infinity();  // of g1 and g2
  std::string closest;
  for (const ChapterCase& one : study.cases) {
    for (const Cable& cable : one.the_case.cables) {
      const double open = gap(cable, one.the_case.initial);
      const double g = open * (open - 2.0 * cable.length);
      if (g > largest) {
        largest = g;
        closest = one.number;
      }
    }
  }
  return {true,
          "Table 5.1",
          "Every case starts with both cables slack.",
          "It does.",
          fmt::format("The largest g of {} starts is {:.4f}, below 0, of case {}.",
                      study.cases.size(), largest, closest),
          {{"cases", {count(study.cases.size())}}, {"largest_g", {largest}}, {"case", {closest}}}};
}

Correction first_impact_holds(const ChapterStudy& study) {
  const double exact = study.point_mass().solution.events().front().time;
  const double error = table_5_3_errors(study, "1st impact -").front();
  return {true,
          "Table 5.3, first impact",
          fmt::format("At t = {:.6f}.", exact + error),
          "To the last printed digit.",
          fmt::format("Exact: t = {:.10f}.", exact),
          {{"exact", {exact}}, {"error", {error}}}};
}

}  // namespace

std::vector<Correction> chapter_corrections(const ChapterStudy& study) {
  return {small_body(),
          upper_limit(study),
          time_unit(study),
          missing_law(study),
          spin_reversal(),
          slope_sign(),
          mass_and_inertia(study),
          resolution(study),
          settling_at_rest(study),
          rising_again(study),
          radius(study),
          flatness(study),
          inertia(study),
          restitution_study(study),
          labels(study),
          special_code(study),
          late_constraints(study),
          state_at_15(study),
          last_impact(study),
          admissible_starts(study),
          rotation_limit(study),
          first_impact_holds(study)};
}

}  // namespace tautline::bench
