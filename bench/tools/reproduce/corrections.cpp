#include "bench/tools/reproduce/report.hpp"

#include <fmt/args.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <sstream>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

#include "bench/tools/reproduce/checks.hpp"
#include "bench/tools/reproduce/source.hpp"
#include "tautline/geometry.hpp"
#include "tautline_bench_reproduce_words.inc"

namespace tautline::bench {

namespace {

/// `words` with the numbers by their names, and those of `more`: a line each on where the chapter
/// says something, what it says, what is right, and what shows it.
Correction told(std::string_view words, NamedNumbers numbers, const NamedNumbers& more = {},
                NumberList list = {}) {
  fmt::dynamic_format_arg_store<fmt::format_context> store;
  for (const NamedNumbers* const some : {&std::as_const(numbers), &more}) {
    for (const auto& [name, values] : *some) {
      std::visit(
          [&store, name = name.c_str()](const auto& value) {
            if constexpr (!std::is_same_v<std::decay_t<decltype(value)>, std::monostate>) {
              store.push_back(fmt::arg(name, value));
            }
          },
          static_cast<const ChapterCell::variant&>(values.front()));
    }
  }
  std::istringstream lines(fmt::vformat(words, store));
  Correction result;
  for (std::string* const line : {&result.where, &result.chapter, &result.right, &result.shown}) {
    std::getline(lines, *line);
  }
  result.numbers = std::move(numbers);
  result.list = std::move(list);
  return result;
}

Correction small_body() {
  const std::vector<Shrunk> shrunk = shrunk_bodies();
  const double point = point_rebound();
  NumberList bodies{"bodies", {}};
  std::string list;
  for (const Shrunk& one : shrunk) {
    bodies.rows.push_back({{"a", {one.size}}, {"ring", {one.ring}}, {"inertia_1", {one.fixed}}});
    list += fmt::format("{}{:.6f} at a = {:g}", list.empty() ? "" : ", ", one.ring, one.size);
  }
  return told(words::small_body, {{"point_mass", {point}}},
              {{"rings", {list}}, {"fixed", {shrunk.back().fixed}}, {"size", {shrunk.back().size}}},
              std::move(bodies));
}

Correction upper_limit(const ChapterStudy& study) {
  const ChapterCase& square = study.at("1933121100");
  return told(words::upper_limit, {{"excess", {ceiling_excess(square)}}},
              {{"case", {square.number}}});
}

Correction time_unit(const ChapterStudy& study) {
  const TimeScale scale = time_scale(study.cases.front());
  return told(words::time_unit,
              {{"ratio", {scale.ratio}}, {"sqrt_S_g", {std::sqrt(scale.spacing / scale.gravity)}}},
              {{"spacing", {scale.spacing}},
               {"gravity", {scale.gravity}},
               {"first_impact", {scale.first_impact}},
               {"g_S", {scale.gravity / scale.spacing}}});
}

Correction missing_law(const ChapterStudy& study) {
  const ChapterCase& soft = study.at("1510121100");
  const Lock& lock = soft.settling.lock.value();
  const OtherLaw other = sequential_law(soft);
  return told(words::missing_law,
              {{"lock", {lock.time}},
               {"energy", {lock.swing.value().energy}},
               {"sequential_lock", {other.lock}},
               {"sequential_energy", {other.energy}}},
              {{"case", {soft.number}}});
}

Correction spin_reversal() {
  const Share kept = spins_kept();
  return told(words::spin_reversal, {{"kept", {count(kept.times)}},
                                     {"impacts", {count(kept.of)}},
                                     {"seed", {count(chapter_seed)}}});
}

Correction slope_sign() {
  const Share wrong = slope_signs_wrong();
  return told(words::slope_sign, {{"wrong", {count(wrong.times)}},
                                  {"poses", {count(wrong.of)}},
                                  {"seed", {count(chapter_seed)}}});
}

Correction mass_and_inertia(const ChapterStudy& study) {
  const SpinChange change = heavy_spin_change(study.cases.front());
  return told(words::mass_and_inertia, {{"exact", {change.exact}}, {"printed", {change.printed}}});
}

Correction resolution(const ChapterStudy& study) {
  const ChapterCase& standard = study.cases.front();
  const double slowest = slowest_resolved(standard);
  const std::size_t all = impact_count(standard.the_case, standard.solution, 0.0);
  const std::size_t seen = impact_count(standard.the_case, standard.solution, slowest);
  return told(
      words::resolution,
      {{"speed", {slowest}}, {"impacts", {count(all)}}, {"unresolved", {count(all - seen)}}});
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
  Correction result = told(words::settling_at_rest,
                           {{"rigid_bodies", {count(dissipative)}},
                            {"swinging", {count(swinging)}},
                            {"energy_kept", {swing.energy / start}},
                            {"amplitude", {swing.amplitude}}},
                           {{"percent", {100.0 * swing.energy / start}},
                            {"degrees", {swing.amplitude * 180.0 / std::numbers::pi}}});
  result.main = true;
  return result;
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
  return told(words::rising_again,
              {{"angle", {angle}},
               {"slack", {found.slack}},
               {"impact", {found.impact}},
               {"speed", {found.speed}},
               {"swings", {count(locked)}},
               {"permanent", {count(permanent)}}},
              {{"case", {square.number}}});
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
  return told(words::radius, {}, {{"pairs", {list}}}, std::move(pairs));
}

Correction flatness(const ChapterStudy& study) {
  const auto corner = [&](std::string_view number) {
    return corner_angle(study.at(number).parameters) * 180.0 / std::numbers::pi;
  };
  const double narrow = corner("1910121100");
  const double deep = corner("1911121100");
  const double wide = corner("1920121100");
  return told(words::flatness,
              {{"a_0.1_b_0", {narrow}}, {"a_0.1_b_0.1", {deep}}, {"a_0.2_b_0", {wide}}},
              {{"narrow", {narrow}}, {"deep", {deep}}, {"wide", {wide}}});
}

Correction inertia(const ChapterStudy& study) {
  const Share against = inertia_pairs_against(study);
  const ChapterCase& ring = study.at("1910121100");
  const ChapterCase& square = study.at("1911121100");
  const ChapterCase& box = study.at("1921121100");
  return told(words::inertia,
              {{"pairs_against", {count(against.times)}}, {"pairs", {count(against.of)}}},
              {{"ring", {ring.number}},
               {"ring_inertia", {ring.the_case.body.inertia}},
               {"ring_angle", {largest_angle(ring)}},
               {"square", {square.number}},
               {"square_inertia", {square.the_case.body.inertia}},
               {"square_angle", {largest_angle(square)}},
               {"square_swing", {lock_of(square).swing.value().amplitude}},
               {"box", {box.number}},
               {"box_swing", {lock_of(box).swing.value().amplitude}}});
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
  return told(words::restitution_study, {}, {{"cases", {list}}}, std::move(cases));
}

Correction labels(const ChapterStudy& study) {
  std::size_t found = 0;
  for (const ChapterCase& one : study.cases) {
    found += one.number == "191012110" || one.number == "291012110" ? 1U : 0U;
  }
  return told(words::labels, {{"rows", {count(found)}}},
              {{"no_rows", {found == 0 ? "No row" : fmt::format("{} rows", found)}},
               {"have", {found == 0 ? "has" : "have"}}});
}

Correction special_code(const ChapterStudy& study) {
  const double difference = largest_difference(study.point_mass(), study.rigid_point);
  return told(words::special_code, {{"largest_difference", {difference}}},
              {{"inertia", {study.rigid_point.the_case.body.inertia}},
               {"until", {study.rigid_point.solution.end_time()}}});
}

Correction state_at_15(const ChapterStudy& study) {
  const std::vector<double> errors = table_5_3_errors(study, "t = 15");
  return told(words::state_at_15,
              {{"x", {errors[1]}}, {"vx", {errors[2]}}, {"y", {errors[3]}}, {"vy", {errors[4]}}});
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
  return told(
      words::late_constraints,
      {{"printed", {printed_value(printed[5])}}, {"at_impact", {own}}, {"at_step_end", {later}}},
      {{"g1", {std::string(printed[5])}}, {"end", {end}}});
}

Correction last_impact(const ChapterStudy& study) {
  const double printed = printed_value(split(printed_table_5_3().back().cells).front());
  const ChapterCase& point = study.point_mass();
  const auto later = std::count_if(
      point.solution.events().begin(), point.solution.events().end(), [&](const Event& event) {
        return event.time > printed && event.kind == EventKind::impact &&
               closing_speed(point.the_case, event.cables, event.before) > counted_speed;
      });
  return told(words::last_impact,
              {{"printed", {printed}},
               {"later_impacts", {static_cast<long>(later)}},
               {"rest", {point.settling.lock.value().time}}},
              {{"speed", {counted_speed}}});
}

Correction rotation_limit(const ChapterStudy& study) {
  std::size_t others = 0;
  for (const ChapterCase& one : study.cases) {
    others += one.parameters.e < 1.0 && largest_angle(one) >= std::numbers::pi / 2 ? 1U : 0U;
  }
  return told(words::rotation_limit, {{"time", {study.limit_time}}, {"others", {count(others)}}},
              {{"no", {others == 0 ? "no" : std::to_string(others)}}});
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
  return told(
      words::admissible_starts,
      {{"cases", {count(study.cases.size())}}, {"largest_g", {largest}}, {"case", {closest}}});
}

Correction first_impact_holds(const ChapterStudy& study) {
  const double exact = study.point_mass().solution.events().front().time;
  const double error = table_5_3_errors(study, "1st impact -").front();
  return told(words::first_impact_holds, {{"exact", {exact}}, {"error", {error}}},
              {{"printed", {exact + error}}});
}

}  // namespace

std::vector<Correction> chapter_corrections(const ChapterStudy& study) {
  std::vector<Correction> all = {small_body(),
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
                                 last_impact(study)};
  for (Correction holds :
       {admissible_starts(study), rotation_limit(study), first_impact_holds(study)}) {
    holds.holds = true;
    all.push_back(std::move(holds));
  }
  return all;
}

}  // namespace tautline::bench
