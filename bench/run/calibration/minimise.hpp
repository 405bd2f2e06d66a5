#pragma once

#include <functional>
#include <optional>
#include <vector>

namespace tautline::bench {

/// How a unit box is looked through: all of it, or around a point.
enum class Pass { whole_box, refinement };

/// Looks for a point of the unit box where `objective` is smallest, from `start`; the caller keeps
/// the best. Ends after so many `evaluations`, below `good_enough`, or where the objective is none.
/// The same objective is asked the same questions. Throws std::runtime_error in a program that was
/// built without NLopt.
void minimise(Pass pass, std::vector<double> start, int evaluations, double good_enough,
              const std::function<std::optional<double>(const std::vector<double>&)>& objective);

}  // namespace tautline::bench
