// The module tautline-mpi.so: `tautline ensemble` under mpirun.

#include <mpi.h>

#include "bench/ensemble/ranks.hpp"

namespace {

using tautline::bench::Ranks;

/// The next number, in the memory of rank 0, which all may add to.
struct Counter {
  MPI_Win window = MPI_WIN_NULL;
  std::uint64_t* memory = nullptr;
};
Counter counter;  // NOLINT: MPI itself is one for the whole process

bool start() {
  int initialised = 0;
  MPI_Initialized(&initialised);
  if (initialised != 0) {
    return false;
  }
  int level = 0;
  return MPI_Init_thread(nullptr, nullptr, MPI_THREAD_SERIALIZED, &level) == MPI_SUCCESS &&
         level >= MPI_THREAD_SERIALIZED;
}

void make_counter(bool here) {
  const MPI_Aint size = here ? sizeof(std::uint64_t) : 0;
  MPI_Win_allocate(size, sizeof(std::uint64_t), MPI_INFO_NULL, MPI_COMM_WORLD,
                   static_cast<void*>(&counter.memory), &counter.window);
  MPI_Win_lock_all(MPI_MODE_NOCHECK, counter.window);
  if (here) {
    *counter.memory = 0;
    MPI_Win_sync(counter.window);
  }
  MPI_Barrier(MPI_COMM_WORLD);
}

std::size_t next() {
  const std::uint64_t one = 1;
  std::uint64_t number = 0;
  MPI_Fetch_and_op(&one, &number, MPI_UINT64_T, 0, 0, MPI_SUM, counter.window);
  MPI_Win_flush(0, counter.window);
  return number;
}

bool all(bool yes) {
  int mine = yes ? 1 : 0;
  int together = 0;
  MPI_Allreduce(&mine, &together, 1, MPI_INT, MPI_MIN, MPI_COMM_WORLD);
  return together != 0;
}

void leave() {
  MPI_Win_unlock_all(counter.window);
  MPI_Win_free(&counter.window);
  MPI_Finalize();
}

void abort(int code) { MPI_Abort(MPI_COMM_WORLD, code); }

}  // namespace

extern "C" __attribute__((visibility("default"))) const Ranks* tautline_join_ranks() {
  static Ranks ranks{};
  if (!start()) {
    return nullptr;
  }
  int rank = 0;
  int size = 1;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &size);
  make_counter(rank == 0);
  ranks = {tautline::bench::ranks_version,
           static_cast<std::size_t>(rank),
           static_cast<std::size_t>(size),
           next,
           all,
           leave,
           abort};
  return &ranks;
}
