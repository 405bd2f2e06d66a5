#include "bench/report/report.hpp"

namespace tautline::bench {

const char* to_string(Status status) {
  constexpr std::array names = {"finished", "stopped", "diverged", "failed"};
  return names.at(static_cast<std::size_t>(status));
}

const char* to_string(Word word) {
  constexpr std::array names = {"pass", "known deviation", "breaks a limit", "not judged"};
  return names.at(static_cast<std::size_t>(word));
}

}  // namespace tautline::bench
