// Memory runs out at each place in turn: every function says so, loses nothing, and ends nothing.
// This program's malloc stands before that of the C library, also for libtautline.so.

#include <gtest/gtest.h>
#include <malloc.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cstdlib>
#include <limits>
#include <string>
#include <vector>

#include "owned.hpp"
#include "tautline/scenarios.hpp"

// glibc's own, under the names that it keeps for programs like this
extern "C" {
void* __libc_malloc(std::size_t size);              // NOLINT(bugprone-reserved-identifier)
void* __libc_calloc(std::size_t n, std::size_t s);  // NOLINT(bugprone-reserved-identifier)
void* __libc_realloc(void* old, std::size_t size);  // NOLINT(bugprone-reserved-identifier)
void __libc_free(void* old);                        // NOLINT(bugprone-reserved-identifier)
}

namespace {

constexpr long never = std::numeric_limits<long>::max();
std::atomic<long> until_failure{never};  // allocations that still succeed
std::atomic<bool> fails_once{true};      // or from then on
std::atomic<bool> counting{false};
std::atomic<long> alive{0};  // allocations less frees
std::atomic<bool> failed{false};

bool fails() {
  if (!counting) {
    return false;
  }
  const long left = until_failure.fetch_sub(1);
  const bool now = left == 0 || (left < 0 && !fails_once);
  if (now) {
    failed = true;
    errno = ENOMEM;
  }
  return now;
}

void* counted(void* made) {
  alive += counting && made != nullptr ? 1 : 0;
  return made;
}

}  // namespace

#pragma GCC visibility push(default)
void* malloc(std::size_t size) { return fails() ? nullptr : counted(__libc_malloc(size)); }
void* calloc(std::size_t n, std::size_t size) {
  return fails() ? nullptr : counted(__libc_calloc(n, size));
}
void* realloc(void* old, std::size_t size) {
  if (fails()) {
    return nullptr;
  }
  return old == nullptr ? counted(__libc_realloc(old, size)) : __libc_realloc(old, size);
}
void free(void* old) {
  alive -= counting && old != nullptr ? 1 : 0;
  __libc_free(old);
}
#pragma GCC visibility pop

namespace tautline::c::test {
namespace {

const std::string ball_json =
    R"({"name": "ball", "duration": 4, "gravity": [0, -1], "body": {"mass": 1, "inertia": 0.4},
        "initial": {"position": [0, 0.5]}, "cables": [{"anchor": [0, 2], "attachment": [0, 0],
        "length": 2, "restitution": 0.5, "restitution_table": [[0, 0.5], [1, 0.4]]}]})";

/// Room for all that is asked for: made before memory is counted.
struct Room {
  std::array<double, 6 * 64> numbers{};
  std::array<std::int32_t, 64> bits{};
  std::array<char, 4096> text{};
  std::array<tautline_summary, 20> summaries{};
  std::array<tautline_settling, 20> settlings{};
  std::array<const tautline_case*, 20> cases{};
};

void expect_known(std::int32_t status) {
  if (status != TAUTLINE_OK && status != TAUTLINE_OUT_OF_MEMORY) {
    counting = false;
    ADD_FAILURE() << tautline_status_text(status);
    counting = true;
  }
}

/// Asks everything of one motion.
void ask(const tautline_motion* motion, Room& room) {
  const std::array<double, 3> times = {0.0, 0.5, 1.5};
  tautline_summary& summary = room.summaries[0];
  summary.size = sizeof summary;
  room.settlings[0].size = sizeof room.settlings[0];
  expect_known(tautline_summarise(motion, &summary));
  expect_known(tautline_settle(motion, room.settlings.data()));
  expect_known(
      tautline_states(motion, times.data(), 3, room.numbers.data(), room.bits.data(), nullptr));
  expect_known(tautline_tensions(motion, times.data(), 3, room.numbers.data(), nullptr));
  expect_known(
      tautline_energy(motion, times.data(), 3, room.numbers.data(), nullptr, nullptr, nullptr));
  expect_known(tautline_horizon(motion, &room.numbers[0], &room.numbers[1], nullptr));
  expect_known(tautline_event_errors(motion, 0, 2, &room.numbers[0], nullptr, &room.numbers[6],
                                     nullptr, &room.numbers[30], nullptr));
  expect_known(
      tautline_state_errors(motion, times.data(), 3, room.numbers.data(), nullptr, nullptr));
}

/// Everything that takes memory, once.
void use_all(const std::string& toml, Room& room) {
  tautline_case* one = tautline_case_from_text(toml.data(), toml.size(), "case.toml");
  tautline_case* two = tautline_case_from_text(ball_json.data(), ball_json.size(), "ball.json");
  tautline_case* bad = tautline_case_from_text("name = 3", 8, nullptr);
  tautline_case_free(bad);
  if (one != nullptr && two != nullptr) {
    const std::array<const char*, 2> names = {"restitution", "vx"};
    const std::array<double, 2> values = {0.7, 0.1};
    tautline_case* varied = nullptr;
    expect_known(tautline_case_vary(one, names.data(), values.data(), 2, &varied, nullptr));
    tautline_case_free(varied);
    std::size_t length = 0;
    expect_known(tautline_case_text(one, TAUTLINE_TOML, room.text.data(), 4096, &length));
    expect_known(tautline_case_text(one, TAUTLINE_JSON, room.text.data(), 4096, &length));
    tautline_options options{};
    options.size = sizeof options;
    options.until_locked = 1;
    tautline_motion* motion = nullptr;
    expect_known(tautline_solve(one, &options, &motion));
    if (motion != nullptr) {
      ask(motion, room);
    }
    tautline_motion_free(motion);
    options.law = 7;
    tautline_option_problems(&options, room.text.data(), room.text.size());
    options.law = TAUTLINE_ENERGETIC;
    for (std::size_t index = 0; index < room.cases.size(); ++index) {
      room.cases[index] = index % 2 == 0 ? one : two;
    }
    room.summaries[0].size = sizeof room.summaries[0];
    expect_known(tautline_sweep(room.cases.data(), room.cases.size(), &options, 1, nullptr, 0,
                                room.summaries.data(), nullptr, nullptr, nullptr));
  }
  tautline_case_free(two);
  tautline_case_free(one);
}

/// Lets `use` fail at each of its allocations, and expects that all memory is free again.
template <class Use>
void expect_nothing_lost(bool once, const Use& use) {
  use();  // what is made once for the whole program
  fails_once = once;
  long place = 0;
  do {
    alive = 0;
    failed = false;
    until_failure = place;
    counting = true;
    use();
    counting = false;
    ASSERT_EQ(alive, 0) << "allocation " << place << (once ? " alone fails" : " and later fail");
    place += 1 + place / 1000;  // the first ones all
  } while (failed);
  testing::Test::RecordProperty("allocations", static_cast<int>(place));
  EXPECT_GT(place, 100);
}

std::string short_case() {
  Breakwater parameters = table_5_1()[0].parameters;
  parameters.duration = 3.0;
  const OwnedCase made = from_numbers(breakwater(parameters, "short"));
  return text_of(made, TAUTLINE_TOML);
}

TEST(Memory, OneAllocationThatFailsIsSaidAndLosesNothing) {
  const std::string text = short_case();
  Room room;
  expect_nothing_lost(true, [&] { use_all(text, room); });
}

TEST(Memory, NoMemoryLeftIsSaidAndLosesNothing) {
  const std::string text = short_case();
  Room room;
  expect_nothing_lost(false, [&] { use_all(text, room); });
}

TEST(Memory, ASweepWithoutMemoryForThreadsEnds) {
  const std::string text = short_case();
  const OwnedCase base(tautline_case_from_text(text.data(), text.size(), nullptr));
  const std::array<const char*, 1> names = {"restitution"};
  std::vector<double> values(64);
  for (std::size_t row = 0; row < values.size(); ++row) {
    values[row] = 0.01 * static_cast<double>(row);
  }
  std::vector<tautline_summary> summaries(values.size(), sized<tautline_summary>());
  for (const bool once : {true, false}) {
    fails_once = once;
    failed = true;
    for (long place = 0; failed; place += 1 + place / 8) {
      failed = false;
      until_failure = place;
      counting = true;
      const std::int32_t status =
          tautline_sweep_varied(base.get(), names.data(), 1, values.data(), values.size(), nullptr,
                                4, nullptr, 0, summaries.data(), nullptr, nullptr, nullptr);
      counting = false;
      ASSERT_TRUE(status == TAUTLINE_OK || status == TAUTLINE_OUT_OF_MEMORY) << status;
      ASSERT_TRUE(status == TAUTLINE_OK || failed);
    }
  }
}

}  // namespace
}  // namespace tautline::c::test
