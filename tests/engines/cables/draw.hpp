// Random numbers that are the same with every standard library: its generators are specified to the
// bit, its distributions are not.

#pragma once

#include <Eigen/Dense>

#include <cmath>
#include <cstdint>
#include <random>

namespace tautline::test {

class Draw {
 public:
  explicit Draw(std::uint64_t seed) : generator_(seed) {}

  /// Uniform in [low, high).
  double between(double low, double high) {
    const double part = static_cast<double>(generator_() >> 11U) * 0x1p-53;
    return low + part * (high - low);
  }
  /// Uniform in [low, high].
  int whole(int low, int high) {
    return low + static_cast<int>(between(0.0, static_cast<double>(high - low + 1)));
  }
  bool chance(double of_one) { return between(0.0, 1.0) < of_one; }
  /// Its logarithm is uniform.
  double scale(double low, double high) { return std::exp(between(std::log(low), std::log(high))); }
  /// Uniform in a ball, or a disc of the plane z = 0.
  Eigen::Vector3d within(double radius, bool planar) {
    Eigen::Vector3d result;
    do {
      const double x = between(-1.0, 1.0);
      const double y = between(-1.0, 1.0);
      const double z = between(-1.0, 1.0);
      result = {x, y, planar ? 0.0 : z};
    } while (result.norm() > 1.0);
    return radius * result;
  }

 private:
  std::mt19937_64 generator_;
};

}  // namespace tautline::test
