#include "bench/report/report.hpp"

namespace tautline::bench {

const char* to_string(Status status) {
  switch (status) {
    case Status::finished:
      return "finished";
    case Status::stopped:
      return "stopped";
    case Status::diverged:
      return "diverged";
    case Status::failed:
      break;
  }
  return "failed";
}

const char* to_string(Word word) {
  switch (word) {
    case Word::pass:
      return "pass";
    case Word::known_deviation:
      return "known deviation";
    case Word::breaks_limit:
      return "breaks a limit";
    case Word::not_judged:
      break;
  }
  return "not judged";
}

}  // namespace tautline::bench
