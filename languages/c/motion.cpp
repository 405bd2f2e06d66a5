#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "bench/base/text.hpp"
#include "handles.hpp"
#include "tautline/geometry.hpp"
#include "tautline/settling.hpp"

namespace tautline::c {
namespace {

using bench::shortest;

/// A count that fits an int32: a solution never has as many as that.
std::int32_t counted(std::size_t count) {
  constexpr std::size_t most = std::numeric_limits<std::int32_t>::max();
  return static_cast<std::int32_t>(std::min(count, most));
}

/// Options as the library has them, with a sentence for each that is wrong.
SolveOptions options_from(const tautline_options* from, std::vector<std::string>& wrong) {
  SolveOptions to;
  if (from == nullptr) {
    return to;
  }
  tautline_options given{};
  const std::size_t size = size_of(from);
  if (size == 0 || !take(from, size, given)) {
    wrong.push_back(wrong_size("tautline_options", sizeof given, from));
    return to;
  }
  const auto is_law = [&] { return given.law >= 0 && given.law <= TAUTLINE_ENERGETIC; };
  if (!is_law()) {
    wrong.push_back("law " + std::to_string(given.law) + " is unknown: must be 0 to 3");
  }
  to.law = is_law() ? static_cast<ImpactLaw>(given.law) : to.law;
  const auto number = [&](const char* name, double value, double most) {
    if (!(value >= 0.0 && value <= most)) {
      wrong.push_back(std::string(name) + " " + shortest(value) +
                      " must be 0, for the default, to " + shortest(most));
    }
    return value > 0.0;
  };
  if (number("completion_error", given.completion_error, 1.0)) {
    to.completion.error = given.completion_error;
  }
  if (number("completion_speed", given.completion_speed, largest_number)) {
    to.completion.speed = given.completion_speed;
  }
  if (number("completion_margin", given.completion_margin, largest_number)) {
    to.completion.margin = given.completion_margin;
  }
  const auto count = [&](const char* name, std::int32_t value, std::size_t& member) {
    if (value < 0) {
      wrong.push_back(std::string(name) + " " + std::to_string(value) +
                      " must be above 0, or 0 for the default");
    } else if (value > 0) {
      member = static_cast<std::size_t>(value);
    }
  };
  count("max_events", given.max_events, to.max_events);
  count("max_steps", given.max_steps, to.max_steps);
  to.until_locked = given.until_locked != 0;
  to.swing_ahead = given.swing_ahead != 0;
  return to;
}

/// Checks what all functions of times are given, and calls `row` with each time and its index.
template <class Row>
std::int32_t at_times(const tautline_motion* motion, const double* times, std::size_t count,
                      std::size_t* wrong, const Row& row) {
  if (motion == nullptr || (times == nullptr && count > 0)) {
    return TAUTLINE_NULL;
  }
  if (!fits_memory(count, std::max(coordinate_count, motion->the_case.cables.size()))) {
    return TAUTLINE_BAD_RANGE;
  }
  return guarded([&]() -> std::int32_t {
    if (const std::int32_t status = check_times(times, count, motion->solution.end_time(), wrong);
        status != TAUTLINE_OK) {
      return status;
    }
    for (std::size_t index = 0; index < count; ++index) {
      row(index, times[index]);
    }
    return TAUTLINE_OK;
  });
}

/// Fills a struct of the caller with what `of` makes of a motion.
template <class Struct, class Of>
std::int32_t give_what(const tautline_motion* motion, Struct* to, const Of& of) {
  if (motion == nullptr || to == nullptr) {
    return TAUTLINE_NULL;
  }
  const std::size_t size = size_of(to);
  if (size == 0) {
    return TAUTLINE_BAD_SIZE;
  }
  return guarded([&] {
    give(of(motion->the_case, motion->solution), to, size);
    return TAUTLINE_OK;
  });
}

}  // namespace

std::int32_t take_options(const tautline_options* from, SolveOptions& to) {
  std::vector<std::string> wrong;
  to = options_from(from, wrong);
  return wrong.empty() ? TAUTLINE_OK : TAUTLINE_BAD_OPTION;
}

std::int32_t check_times(const double* times, std::size_t count, double end, std::size_t* wrong) {
  for (std::size_t index = 0; index < count; ++index) {
    if (!(times[index] >= 0.0 && times[index] <= end)) {
      give_number(wrong, index);
      return TAUTLINE_BAD_TIME;
    }
  }
  return TAUTLINE_OK;
}

tautline_summary summary_of(const Case& the_case, const Solution& solution) {
  tautline_summary to{};
  to.status = TAUTLINE_OK;
  to.ending = static_cast<std::int32_t>(solution.ending());
  const auto& events = solution.events();
  to.events = counted(events.size());
  to.impacts = counted(
      static_cast<std::size_t>(std::count_if(events.begin(), events.end(), [](const Event& event) {
        return event.kind == EventKind::impact;
      })));
  to.arcs = counted(solution.arcs().size());
  to.accumulations = counted(solution.accumulations().size());
  to.end_time = solution.end_time();
  to.taut = bits(solution.arcs()[solution.place(to.end_time).arc].taut);
  to.start_energy = energy(the_case, solution.at(0.0));
  to.end_energy = energy(the_case, solution.at(to.end_time));
  const std::optional<Repetition>& again = solution.repetition();
  to.repeat_start = again ? solution.arcs()[again->first].start : none;
  to.repeat_period = again ? again->period : none;
  to.repeat_turn = again ? again->turn : none;
  return to;
}

tautline_settling settling_of(const Case& the_case, const Solution& solution) {
  const Settling found = settling(the_case, solution);
  tautline_settling to{};
  for (std::size_t index = 0; index < std::size(to.last_impact_speed); ++index) {
    const bool known = index < found.last_impacts.size();
    to.last_impact_speed[index] = known ? found.last_impacts[index].speed : none;
    to.last_impact_time[index] = known ? found.last_impacts[index].time.value_or(none) : none;
  }
  const Lock lock = found.lock.value_or(Lock{none, none, {}, false, false, std::nullopt});
  to.cables = bits(lock.cables);
  to.permanent = lock.permanent ? 1 : 0;
  to.rests = lock.rests ? 1 : 0;
  to.time = lock.time;
  to.uncertainty = lock.uncertainty;
  const Swing swing =
      lock.swing.value_or(Swing{none, none, none, none, none, SwingAngle::body, false, {}});
  to.swings = lock.swing ? 1 : 0;
  to.goes_round = swing.goes_round ? 1 : 0;
  to.angle_of_cable = swing.angle == SwingAngle::cable ? 1 : 0;
  to.swing_energy = swing.energy;
  to.swing_period = swing.period;
  to.swing_least = swing.least;
  to.swing_largest = swing.largest;
  to.swing_amplitude = swing.amplitude;
  to.swing_tension = swing.largest_tension.value_or(none);
  return to;
}

}  // namespace tautline::c

using namespace tautline::c;  // NOLINT(google-build-using-namespace)

size_t tautline_option_problems(const tautline_options* options, char* text, size_t room) {
  std::size_t length = 0;
  const std::int32_t status = guarded([&] {
    std::vector<std::string> wrong;
    static_cast<void>(options_from(options, wrong));
    length = give_text(lines_of(wrong), text, room);
    return TAUTLINE_OK;
  });
  return status == TAUTLINE_OK ? length : give_text(tautline_status_text(status), text, room);
}

int32_t tautline_solve(const tautline_case* the_case, const tautline_options* options,
                       tautline_motion** to) {
  if (to == nullptr) {
    return TAUTLINE_NULL;
  }
  *to = nullptr;
  if (the_case == nullptr) {
    return TAUTLINE_NULL;
  }
  if (!the_case->problems.empty()) {
    return TAUTLINE_BAD_CASE;
  }
  return guarded([&] {
    tautline::SolveOptions how;
    const std::int32_t status = take_options(options, how);
    if (status == TAUTLINE_OK) {
      *to = std::make_unique<tautline_motion>(the_case->the_case, how).release();
    }
    return status;
  });
}

void tautline_motion_free(tautline_motion* motion) { delete motion; }

int32_t tautline_summarise(const tautline_motion* motion, tautline_summary* to) {
  return give_what(motion, to, summary_of);
}

int32_t tautline_settle(const tautline_motion* motion, tautline_settling* to) {
  return give_what(motion, to, settling_of);
}

int32_t tautline_states(const tautline_motion* motion, const double* times, size_t count,
                        double* states, int32_t* taut, size_t* wrong) {
  return at_times(motion, times, count, wrong, [&](std::size_t index, double time) {
    if (states != nullptr) {
      give_state(motion->solution.at(time), states + index * coordinate_count);
    }
    if (taut != nullptr) {
      taut[index] = bits(motion->solution.arcs()[motion->solution.place(time).arc].taut);
    }
  });
}

int32_t tautline_tensions(const tautline_motion* motion, const double* times, size_t count,
                          double* tensions, size_t* wrong) {
  return at_times(motion, times, count, wrong, [&](std::size_t index, double time) {
    if (tensions != nullptr) {
      const tautline::CableVector pulls = motion->solution.tensions(time);
      const auto width = static_cast<std::size_t>(pulls.size());
      std::copy_n(pulls.data(), width, tensions + index * width);
    }
  });
}

int32_t tautline_energy(const tautline_motion* motion, const double* times, size_t count,
                        double* kinetic, double* potential, double* total, size_t* wrong) {
  return at_times(motion, times, count, wrong, [&](std::size_t index, double time) {
    const tautline::Case& the_case = motion->the_case;
    const tautline::State state = motion->solution.at(time);
    if (kinetic != nullptr) {
      kinetic[index] = tautline::kinetic_energy(the_case.body, state);
    }
    if (potential != nullptr) {
      potential[index] = -the_case.body.mass * the_case.gravity.dot(state.position);
    }
    if (total != nullptr) {
      total[index] = tautline::energy(the_case, state);
    }
  });
}

int32_t tautline_state_errors(const tautline_motion* motion, const double* times, size_t count,
                              double* states, double* energy, size_t* wrong) {
  return at_times(motion, times, count, wrong, [&](std::size_t index, double time) {
    const tautline::Uncertainty& errors = motion->errors();
    if (states != nullptr) {
      double* row = states + index * coordinate_count;
      const auto state = errors.at(time);
      state ? give_state(*state, row) : give_no_state(row);
    }
    if (energy != nullptr) {
      energy[index] = errors.energy(time).value_or(none);
    }
  });
}
