#pragma once

#include <memory>
#include <optional>
#include <string>

#include "bench/base/process.hpp"
#include "bench/run/wire.hpp"

namespace tautline::bench {

/// What came back from a worker process.
struct Exchange {
  std::optional<WorkerAnswer> answer;     // none if the worker did not come to its end
  std::optional<WorkerAnswer> last_word;  // of a worker that did not, if there is one
  ProcessEnd end;
  std::string failure;  // why the answer is none, or a failure; else empty

  [[nodiscard]] bool interrupted() const { return end.kind == ProcessEnd::Kind::interrupted; }
};

/// Where the worker processes of one thread are, one at a time. A plug-in, which lives in its
/// worker, gets a new one each time unless the request before said that more follow. The worker of
/// an engine with a process of its own stays for the next run: to start such an engine costs as
/// much as many a run.
class Workplace {
 public:
  Workplace();
  ~Workplace();
  Workplace(const Workplace&) = delete;
  Workplace& operator=(const Workplace&) = delete;

  /// Has a worker obey `request` within `time_limit` [s]. Throws std::system_error where there are
  /// no more processes, descriptors or memory.
  [[nodiscard]] Exchange exchange(const WorkerRequest& request, double time_limit);

 private:
  class Worker;
  std::unique_ptr<Worker> waiting_;  // for more to do; none if the last one is gone
};

}  // namespace tautline::bench
