#pragma once

#include <exception>
#include <optional>
#include <stop_token>
#include <thread>
#include <vector>

#include "bench/measure/reference.hpp"
#include "bench/solution/certificate.hpp"

namespace tautline::bench {

/// Until when the exact solution of each case is right: found while the runs go on, in a thread of
/// its own, since numbers of many digits are for one thread. Ends early, and without the cases that
/// are left, when it goes or the program is told to stop.
class Certification {
 public:
  /// Begins with `references`, which must outlive it; with none of them unless `wanted`. Systems
  /// stay without: `tautline solve` says it of them.
  Certification(const std::vector<Reference>& references, bool wanted);

  /// Waits for the last case. One entry for each; throws what went wrong.
  [[nodiscard]] std::vector<std::optional<CertifiedDigits>> digits();

 private:
  void work(const std::stop_token& stop, const std::vector<Reference>& references);

  std::vector<std::optional<CertifiedDigits>> digits_;
  std::exception_ptr failure_;
  std::jthread thread_;  // last: it goes before what it writes to
};

}  // namespace tautline::bench
