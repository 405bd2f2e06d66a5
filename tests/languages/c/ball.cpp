// The bouncing ball from C++, as text and with the library's memory in unique pointers.
#include <tautline/tautline.h>

#include <cstdio>
#include <memory>
#include <string>
#include <vector>

int main() {
  const std::string text = R"({"name": "ball", "duration": 10, "gravity": [0, -1],
    "body": {"mass": 1, "inertia": 0.4}, "initial": {"position": [0, 0.5]},
    "cables": [{"anchor": [0, 2], "attachment": [0, 0], "length": 2, "restitution": 0.5}]})";
  const std::unique_ptr<tautline_case, decltype(&tautline_case_free)> ball(
      tautline_case_from_text(text.data(), text.size(), "ball.json"), tautline_case_free);
  tautline_motion* solved = nullptr;
  if (tautline_solve(ball.get(), nullptr, &solved) != TAUTLINE_OK) {
    return 1;
  }
  const std::unique_ptr<tautline_motion, decltype(&tautline_motion_free)> motion(
      solved, tautline_motion_free);
  tautline_summary summary{};
  summary.size = sizeof summary;
  tautline_summarise(motion.get(), &summary);
  std::vector<double> time(static_cast<std::size_t>(summary.events));
  tautline_events(motion.get(), 0, time.size(), time.data(), nullptr, nullptr, nullptr, nullptr,
                  nullptr);
  double expected = 1.0;
  double wait = 1.0;  // [s], to the next impact: each comes after half the time of the one before
  bool right = summary.ending == TAUTLINE_REST && summary.impacts > 10;
  for (std::size_t impact = 0; impact < 10; ++impact, wait /= 2.0) {
    right = right && time[impact] == expected;
    expected += wait;
  }
  std::printf("%s after %d events\n", right ? "right" : "wrong", summary.events);
  return right ? 0 : 1;
}
