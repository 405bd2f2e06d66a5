#include <atomic>
#include <cmath>
#include <span>
#include <vector>

#include "handles.hpp"
#include "tautline/solve_batch.hpp"

#ifdef TAUTLINE_C_THREADS
#include <system_error>
#include <thread>
#endif

namespace tautline::c {
namespace {

/// Cases that a thread takes at a time: many, so that its lanes stay full to the end, but not so
/// many that other threads wait for the last.
constexpr std::size_t most_at_a_time = 1000;
constexpr std::size_t least_at_a_time = 16;
constexpr std::size_t shares_of_a_thread = 8;

/// What the caller wants of each case.
struct Wanted {
  const double* times;  // [s]
  std::size_t time_count;
  tautline_summary* summaries;
  tautline_settling* settlings;
  double* states;
  std::size_t summary_size = 0;   // [bytes]
  std::size_t settling_size = 0;  // [bytes]

  /// Returns a status.
  std::int32_t check(std::size_t count, std::size_t* wrong) {
    summary_size = summaries != nullptr && count > 0 ? size_of(summaries) : 0;
    settling_size = settlings != nullptr && count > 0 ? size_of(settlings) : 0;
    if (count > 0 && ((summaries != nullptr && summary_size == 0) ||
                      (settlings != nullptr && settling_size == 0))) {
      return TAUTLINE_BAD_SIZE;
    }
    if (times == nullptr && time_count > 0) {
      return TAUTLINE_NULL;
    }
    // a row of states, or a summary, for each case and time
    constexpr std::size_t widest = largest_size / sizeof(double);
    if (!fits_memory(time_count, coordinate_count) ||
        !fits_memory(count, std::max(widest, time_count * coordinate_count))) {
      return TAUTLINE_BAD_RANGE;
    }
    return check_times(times, time_count, std::numeric_limits<double>::max(), wrong);
  }

  void give_solution(std::size_t index, const Case& the_case, const Solution& solution) const {
    if (summaries != nullptr) {
      give(summary_of(the_case, solution), at(summaries, index, summary_size), summary_size);
    }
    if (settlings != nullptr) {
      give(settling_of(the_case, solution), at(settlings, index, settling_size), settling_size);
    }
    if (states != nullptr) {
      double* row = states + index * time_count * coordinate_count;
      for (std::size_t k = 0; k < time_count; ++k, row += coordinate_count) {
        times[k] <= solution.end_time() ? give_state(solution.at(times[k]), row)
                                        : give_no_state(row);
      }
    }
  }

  void give_none(std::size_t index) const {
    if (summaries != nullptr) {
      tautline_summary summary{};
      summary.status = TAUTLINE_BAD_CASE;
      for (double* number : {&summary.end_time, &summary.start_energy, &summary.end_energy,
                             &summary.repeat_start, &summary.repeat_period, &summary.repeat_turn}) {
        *number = none;
      }
      give(summary, at(summaries, index, summary_size), summary_size);
    }
    if (settlings != nullptr) {
      tautline_settling settling{};
      double* const numbers = &settling.time;  // the first of the doubles, which end the struct
      const std::size_t ints = offsetof(tautline_settling, time);
      std::fill_n(numbers, (sizeof settling - ints) / sizeof(double), none);
      give(settling, at(settlings, index, settling_size), settling_size);
    }
    if (states != nullptr) {
      std::fill_n(states + index * time_count * coordinate_count, time_count * coordinate_count,
                  none);
    }
  }
};

/// Solves all cases in shares that threads take from a common heap. `case_of` returns the case of
/// an index, or null for one with problems; it may put it into a room that is its thread's own.
template <class CaseOf>
class Sweep {
 public:
  Sweep(std::size_t count, std::size_t threads, const SolveOptions& options, const Wanted& wanted,
        const CaseOf& case_of)
      : count_(count), options_(options), wanted_(wanted), case_of_(case_of) {
    const std::size_t shares = threads > 1 ? threads * shares_of_a_thread : 1;
    share_ = std::clamp(count / shares, least_at_a_time, most_at_a_time);
  }

  /// Takes shares until none is left, or until something has failed in any thread.
  void work() noexcept {
    const std::int32_t status = guarded([&] {
      std::vector<Case> cases;
      std::vector<std::size_t> places;
      Case room;
      while (status_.load() == TAUTLINE_OK) {
        const std::size_t first = next_.fetch_add(share_);
        if (first >= count_) {
          break;
        }
        cases.clear();
        places.clear();
        for (std::size_t index = first; index < std::min(count_, first + share_); ++index) {
          if (const Case* one = case_of_(index, room)) {
            cases.push_back(*one);
            places.push_back(index);
          } else {
            wanted_.give_none(index);
          }
        }
        solve_batch(cases, options_, [&](std::size_t place, const Solution& solution) {
          wanted_.give_solution(places[place], cases[place], solution);
        });
      }
      return TAUTLINE_OK;
    });
    if (status != TAUTLINE_OK) {
      status_.store(status);
    }
  }

  [[nodiscard]] std::int32_t status() const { return status_.load(); }

 private:
  std::size_t count_;
  std::size_t share_;
  const SolveOptions& options_;
  const Wanted& wanted_;
  const CaseOf& case_of_;
  std::atomic<std::size_t> next_{0};
  std::atomic<std::int32_t> status_{TAUTLINE_OK};
};

#ifdef TAUTLINE_C_THREADS
constexpr std::size_t most_threads = 256;

std::size_t threads_for(std::int32_t asked) {
  const std::size_t threads =
      asked > 0 ? static_cast<std::size_t>(asked) : std::thread::hardware_concurrency();
  return std::clamp<std::size_t>(threads, 1, most_threads);
}

/// Calls `work` in this thread and in `others` more, fewer if the system gives no more.
template <class Work>
void in_threads(std::size_t others, const Work& work) {
  std::vector<std::thread> team;
  team.reserve(others);
  try {
    while (team.size() < others) {
      team.emplace_back(work);
    }
  } catch (const std::system_error&) {
    // those that run do the work of the others
  } catch (const std::bad_alloc&) {
    // likewise
  }
  work();
  for (std::thread& one : team) {
    one.join();
  }
}
#else
std::size_t threads_for(std::int32_t /*asked*/) { return 1; }

template <class Work>
void in_threads(std::size_t /*others*/, const Work& work) {
  work();
}
#endif

template <class CaseOf>
std::int32_t sweep(std::size_t count, const tautline_options* options, std::int32_t threads,
                   Wanted& wanted, std::size_t* wrong, const CaseOf& case_of) {
  if (threads < 0) {
    return TAUTLINE_BAD_THREADS;
  }
  SolveOptions how;
  if (const std::int32_t status = take_options(options, how); status != TAUTLINE_OK) {
    return status;
  }
  if (const std::int32_t status = wanted.check(count, wrong); status != TAUTLINE_OK) {
    return status;
  }
  const std::size_t team =
      std::min(threads_for(threads), std::max<std::size_t>(count / least_at_a_time, 1));
  Sweep all(count, team, how, wanted, case_of);
  in_threads(team - 1, [&all] { all.work(); });
  return all.status();
}

}  // namespace
}  // namespace tautline::c

using namespace tautline::c;  // NOLINT(google-build-using-namespace)

int32_t tautline_sweep(const tautline_case* const* cases, size_t count,
                       const tautline_options* options, int32_t threads, const double* times,
                       size_t time_count, tautline_summary* summaries, tautline_settling* settlings,
                       double* states, size_t* wrong) {
  if (cases == nullptr && count > 0) {
    return TAUTLINE_NULL;
  }
  if (!fits_memory(count, 1)) {
    return TAUTLINE_BAD_RANGE;
  }
  for (std::size_t index = 0; index < count; ++index) {
    if (cases[index] == nullptr) {
      give_number(wrong, index);
      return TAUTLINE_NULL;
    }
  }
  return guarded([&] {
    Wanted wanted{times, time_count, summaries, settlings, states};
    return sweep(count, options, threads, wanted, wrong, [&](std::size_t index, tautline::Case&) {
      return cases[index]->problems.empty() ? &cases[index]->the_case : nullptr;
    });
  });
}

int32_t tautline_sweep_varied(const tautline_case* base, const char* const* names,
                              size_t name_count, const double* values, size_t count,
                              const tautline_options* options, int32_t threads, const double* times,
                              size_t time_count, tautline_summary* summaries,
                              tautline_settling* settlings, double* states, size_t* wrong) {
  if (base == nullptr || (values == nullptr && count > 0 && name_count > 0)) {
    return TAUTLINE_NULL;
  }
  if (!base->problems.empty()) {
    return TAUTLINE_BAD_CASE;
  }
  if (!fits_memory(name_count, 1) || !fits_memory(count, std::max<std::size_t>(name_count, 1))) {
    return TAUTLINE_BAD_RANGE;
  }
  return guarded([&]() -> std::int32_t {
    Variation variation;
    if (const std::int32_t status = variation.read(base->the_case, names, name_count, wrong);
        status != TAUTLINE_OK) {
      return status;
    }
    Wanted wanted{times, time_count, summaries, settlings, states};
    return sweep(count, options, threads, wanted, wrong,
                 [&](std::size_t index, tautline::Case& room) -> const tautline::Case* {
                   room = base->the_case;
                   variation.apply(room, values + index * name_count);
                   return tautline::problems(room).empty() ? &room : nullptr;
                 });
  });
}
