#pragma once

#include <atomic>
#include <cstddef>
#include <mutex>

#include "bench/ensemble/ranks.hpp"

namespace tautline::bench {

/// The processes that do one piece of work: this one alone, or those that mpirun has started.
class Team {
 public:
  /// Joins the others where mpirun or srun has started this process, by the module tautline-mpi.so.
  /// Throws std::runtime_error that says what is missing for it.
  Team();
  Team(const Team&) = delete;
  Team& operator=(const Team&) = delete;
  ~Team();  // waits for the others

  /// How many processes there are.
  [[nodiscard]] std::size_t size() const { return ranks_ == nullptr ? 1 : ranks_->size; }

  /// True in one of them: the one that speaks and writes the report.
  [[nodiscard]] bool leads() const { return ranks_ == nullptr || ranks_->rank == 0; }

  /// 0, 1, 2, ...: each number goes to one process, once. From any thread.
  [[nodiscard]] std::size_t next();

  /// Waits until every process has called it: whether all said yes.
  [[nodiscard]] bool all(bool yes);

  /// Where there are others, ends them and this one with that exit code: they would wait for ever.
  void abandon(int code);

 private:
  const Ranks* ranks_ = nullptr;  // none: alone
  std::mutex guard_;              // of ranks_
  std::atomic<std::size_t> next_{0};
};

}  // namespace tautline::bench
