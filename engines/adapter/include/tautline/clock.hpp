#pragma once

namespace tautline {

/// The time of a simulation. The sum of many equal steps would be off by half a rounding each, all
/// to the same side; this one carries what each sum lost (Kahan 1965), so n steps of dt read n dt.
class Clock {
 public:
  [[nodiscard]] double now() const { return now_; }  // [s]

  /// Goes on by dt [s].
  void advance(double dt) {
    const double wanted = dt - lost_;
    const double sum = now_ + wanted;
    lost_ = (sum - now_) - wanted;
    now_ = sum;
  }

 private:
  double now_ = 0.0;   // [s]
  double lost_ = 0.0;  // [s], by how much now_ is too large
};

}  // namespace tautline
