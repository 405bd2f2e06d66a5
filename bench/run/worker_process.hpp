#pragma once

namespace tautline::bench {

/// The hidden command of the program that makes it a worker process.
inline constexpr const char* worker_command = "worker-process";

/// Where a worker finds its request, and where it leaves its answer.
inline constexpr int request_descriptor = 0;
inline constexpr int answer_descriptor = 3;

/// What a worker process does: reads its request, obeys it, writes its answer. The exit code.
[[nodiscard]] int worker_main();

}  // namespace tautline::bench
