#pragma once

#include <cstddef>
#include <functional>
#include <span>

#include "tautline/case.hpp"
#include "tautline/solution.hpp"
#include "tautline/solve.hpp"

namespace tautline {

/// What is given each solution of a batch, with the index of its case. It has to copy what is to
/// stay: the next ones are solved in the room of this one.
using TakeSolution = std::function<void(std::size_t, const Solution&)>;

/// Solves many cases side by side: the flights and impacts of several at once by the processor's
/// widest registers, what happens seldom one by one. Every solution is, event by event and bit by
/// bit, that of `solve`, whatever the processor. They come as they are done, not in order, in the
/// thread of the caller. Throws std::invalid_argument as `solve`, before any is solved.
void solve_batch(std::span<const Case> cases, const SolveOptions& options,
                 const TakeSolution& take);

}  // namespace tautline
