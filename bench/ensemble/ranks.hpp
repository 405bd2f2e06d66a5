#pragma once

#include <cstddef>
#include <cstdint>

// What the program and the module tautline-mpi.so agree on. The program is not linked with MPI, and
// runs where there is none.

namespace tautline::bench {

/// Changes with what is below.
inline constexpr std::uint32_t ranks_version = 1;

/// The processes that mpirun has started together, as seen by one of them. Its functions are not
/// for two threads at a time.
struct Ranks {
  std::uint32_t version;   // ranks_version
  std::size_t rank, size;  // this one, of so many

  /// 0, 1, 2, ...: each number goes to one process, once.
  std::size_t (*next)();

  /// Waits until all processes have called it: whether all said yes.
  bool (*all)(bool yes);

  /// Waits until all have called it. Nothing may be called after.
  void (*leave)();

  /// Ends every process with this exit code.
  void (*abort)(int code);
};

/// What the module exports as `tautline_join_ranks`: null where MPI cannot be used.
using JoinRanks = const Ranks*();

}  // namespace tautline::bench
