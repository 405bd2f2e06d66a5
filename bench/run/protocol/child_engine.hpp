#pragma once

#include <memory>

#include "bench/run/protocol/engine_file.hpp"
#include "tautline/model_table.hpp"

namespace tautline::bench {

class Children;

/// An engine in a process of its own, as one in this process: started when it is made, and gone
/// with it. Runs one after another share its process; runs at the same time get one each.
class ChildEngine final : public TableEngine {
 public:
  /// `memory` is what a process and all it starts may hold [bytes]. Throws where it cannot be
  /// started or does not say who it is.
  [[nodiscard]] static std::unique_ptr<ChildEngine> open(const EngineFile& file,
                                                         std::size_t memory);

  /// Processor time of its processes so far [s].
  [[nodiscard]] double processor_time() const;

  /// The most memory that one of them held at once [bytes].
  [[nodiscard]] double peak_memory() const;

  /// From here on `peak_memory` is the most that is held from here on.
  void forget_peak_memory() const;

 private:
  ChildEngine(EngineTable table, std::shared_ptr<Children> children);

  std::shared_ptr<Children> children_;
};

}  // namespace tautline::bench
