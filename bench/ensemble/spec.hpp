#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "bench/cases/any_case.hpp"
#include "tautline/detail/accumulation.hpp"
#include "tautline/impact.hpp"

namespace tautline::bench {

/// From which distribution a quantity is drawn, or over which grid it goes.
struct Distribution {
  enum class Kind {
    normal,   // `numbers`: the standard deviation about the case's own value
    uniform,  // `numbers`: both ends
    list,     // `numbers`: each as likely as the others
    grid,     // `numbers`: the values in their order, each with each of the other grids
  };
  Kind kind = Kind::normal;
  std::vector<double> numbers;
};

/// One quantity of the case that varies from draw to draw.
struct Varied {
  std::string quantity;  // one of `quantities_of` the case
  Distribution distribution;
  std::string unit = {};  // of the quantity, or empty
};

/// A further exact motion of every draw, which the first one is compared with.
struct ExactVariant {
  std::string name;
  ImpactLaw law = ImpactLaw::simultaneous;
  std::optional<std::uint64_t> seed;             // none: the draws of the spec
  std::string quantity;                          // that is another, or empty
  double factor = 1.0;                           // by which it is multiplied [-]
  double completion = CompletionLimits{}.error;  // of accumulations (CompletionLimits) [-]
};

/// Where the numbers of a draw come from.
enum class Sampling { random, sobol };

/// What `tautline ensemble` is asked: a case, what varies, and who solves it.
struct EnsembleSpec {
  AnyCase the_case;          // as long as the runs are
  std::size_t count = 1000;  // draws; over a grid: at each of its points
  std::uint64_t seed = 1;
  Sampling sampling = Sampling::random;
  ImpactLaw law = ImpactLaw::simultaneous;   // of the exact motion and of engines that can choose
  std::array<double, 2> speeds{1e-2, 1e-3};  // [m/s], falling; slower impacts are not counted
  double completion = CompletionLimits{}.error;  // of accumulations (CompletionLimits) [-]
  std::vector<Varied> varied;
  std::vector<ExactVariant> exact;   // beside the first
  std::vector<std::string> engines;  // names or paths
  std::vector<std::string> models;   // of them; empty: all
  std::vector<double> steps;         // [s]
};

/// Points of the grids of `spec` together; 1 without one.
[[nodiscard]] std::size_t grid_points(const EnsembleSpec& spec);

/// Draws of `spec` in all.
[[nodiscard]] std::size_t draw_count(const EnsembleSpec& spec);

/// The varied quantities that go over a grid: their places in `spec.varied`.
[[nodiscard]] std::vector<std::size_t> grid_axes(const EnsembleSpec& spec);

/// More draws than this are refused: an atlas holds them in memory, and a chunk of them is a file.
inline constexpr std::size_t most_draws = 10'000'000;

}  // namespace tautline::bench
