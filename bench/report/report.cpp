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
    case Word::flagged:
      return "deviation-flagged";
    case Word::informative:
      return "informative";
    case Word::unsupported:
      break;
  }
  return "unsupported";
}

}  // namespace tautline::bench
