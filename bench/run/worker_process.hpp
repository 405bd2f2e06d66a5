#pragma once

namespace tautline::bench {

/// The hidden command of the program that makes it a worker process.
inline constexpr const char* worker_command = "worker-process";

/// Where a worker finds its request, and where it leaves its answer.
inline constexpr int request_descriptor = 0;
inline constexpr int answer_descriptor = 3;

/// A socket: it may begin when it hears a byte, and says one where it stays for more.
inline constexpr int turn_descriptor = 4;

/// What a worker process does: reads its request, obeys it, writes its answer; and that again where
/// the request says that more follow or its plug-in is an engine with a process of its own, as long
/// as all goes well and there is more to do. The exit code.
[[nodiscard]] int worker_main();

}  // namespace tautline::bench
