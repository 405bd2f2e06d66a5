#pragma once

#include <boost/multiprecision/eigen.hpp>
#include <boost/multiprecision/mpfr.hpp>

namespace tautline {

/// A number of as many digits as `Digits` says where it is made; MPFR does the arithmetic.
using Multi = boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<0>,
                                            boost::multiprecision::et_off>;

/// While it lives, numbers of type Multi are made with this many decimal digits. One at a time and
/// in one thread: the setting is global.
class Digits {
 public:
  explicit Digits(unsigned digits) : before_(Multi::default_precision()) {
    Multi::default_precision(digits);
  }
  ~Digits() { Multi::default_precision(before_); }
  Digits(const Digits&) = delete;
  Digits& operator=(const Digits&) = delete;
  Digits(Digits&&) = delete;
  Digits& operator=(Digits&&) = delete;

 private:
  unsigned before_;
};

}  // namespace tautline
