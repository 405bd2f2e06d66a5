#pragma once

#include <fmt/format.h>
#include <mpfr.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>
#include <string>

#include "bench/base/table.hpp"
#include "bench/base/text.hpp"
#include "tautline/multiprecision.hpp"

namespace tautline::bench {

// Numbers of which only the digits are shown that are right: both ends of the interval of the error
// round to them.

/// True for "0.00" and its like.
[[nodiscard]] inline bool is_zero(const std::string& number) {
  return number.find_first_of("123456789") == std::string::npos;
}

/// "-0.00" and its like without the sign.
[[nodiscard]] inline std::string without_signed_zero(const std::string& text) {
  return is_zero(text) && text.starts_with('-') ? text.substr(1) : text;
}

/// `value` by one of MPFR's formats. Boost's own takes no digits for all of them, and for numbers
/// smaller than the last digit too.
[[nodiscard]] inline std::string formatted(const char* format, int digits, const Multi& value) {
  char* text = nullptr;
  if (mpfr_asprintf(&text, format, digits, value.backend().data()) < 0) {
    throw std::bad_alloc();
  }
  std::string result(text);
  mpfr_free_str(text);
  return without_signed_zero(result);
}

/// `value` with so many digits after the point.
[[nodiscard]] inline std::string fixed_digits(double value, int digits) {
  return fixed_text(value, digits);
}
[[nodiscard]] inline std::string fixed_digits(const Multi& value, int digits) {
  return formatted("%.*RNf", digits, value);
}

/// `value` with so many digits after the first.
[[nodiscard]] inline std::string scientific_digits(double value, int digits) {
  return without_signed_zero(fmt::format("{:.{}e}", value, digits));
}
[[nodiscard]] inline std::string scientific_digits(const Multi& value, int digits) {
  return formatted("%.*RNe", digits, value);
}

/// `value`, which is off by at most `error`, by `text_of` with as many right digits as there are,
/// at most `most`; a dash where none is right.
template <class Real, class TextOf>
[[nodiscard]] std::string right_digits(const Real& value, const Real& error, int most,
                                       const TextOf& text_of) {
  if (error >= 0) {
    for (int digits = most; digits >= 0; --digits) {
      std::string low = text_of(Real(value - error), digits);
      if (low == text_of(Real(value + error), digits)) {
        return low;
      }
    }
  }
  return dash;
}

/// The same with at most `most` digits after the point.
template <class Real>
[[nodiscard]] std::string right_fixed(const Real& value, const Real& error, int most) {
  return right_digits(value, error, most,
                      [](const Real& end, int digits) { return fixed_digits(end, digits); });
}

/// The same in powers of ten, with at most `most` digits after the first.
template <class Real>
[[nodiscard]] std::string right_scientific(const Real& value, const Real& error, int most) {
  return right_digits(value, error, most,
                      [](const Real& end, int digits) { return scientific_digits(end, digits); });
}

/// The same with at most `most` significant digits and no zeros behind them.
template <class Real>
[[nodiscard]] std::string significant_digits(const Real& value, const Real& error, int most) {
  const double size = std::abs(static_cast<double>(value));
  if (size > 0.0 && (size < 1e-4 || size >= 1e6)) {
    return right_scientific(value, error, most - 1);
  }
  const int before = size > 0.0 ? static_cast<int>(std::floor(std::log10(size))) + 1 : 1;
  std::string text = right_fixed(value, error, std::max(0, most - before));
  const double shown_error = static_cast<double>(error);
  if (shown_error <= std::pow(10.0, -most - 3) * size && text.find('.') != std::string::npos) {
    text.erase(text.find_last_not_of('0') + 1);  // zeros of what is exactly so
    if (text.ends_with('.')) {
      text.pop_back();
    }
  }
  return text;
}

/// `significant_digits`; a number that has none but rounds to zero is the zeros that are right, as
/// many as `most` after the point: 0.00000.
template <class Real>
[[nodiscard]] std::string right_general(const Real& value, const Real& error, int most) {
  std::string text = significant_digits(value, error, most);
  if (text == dash) {
    std::string zeros = right_fixed(value, error, most);
    if (zeros.find('.') != std::string::npos && is_zero(zeros)) {
      return zeros;
    }
  }
  return text;
}

/// `text`, or where it is the dash of a number without a right digit, the number with its error.
template <class Real>
[[nodiscard]] std::string in_words(const std::string& text, const Real& value, const Real& error) {
  if (text != dash) {
    return text;
  }
  if (error < 0) {
    return "beyond the horizon";
  }
  const auto size = static_cast<double>(Real(abs(value)));
  auto off = std::max(static_cast<double>(error), std::numeric_limits<double>::min());
  std::string about = "0";
  if (size <= off) {
    off += size;
  } else {
    const int digits = off < 1.0 ? static_cast<int>(std::ceil(-std::log10(off))) : 0;
    about = fixed_digits(value, digits);
    off += std::pow(10.0, -digits) / 2.0;  // which rounding `value` adds
  }
  const double unit = std::pow(10.0, std::floor(std::log10(off)));  // of one digit, rounded up
  return fmt::format("{} to within {:.0e}", about, std::ceil(off / unit) * unit);
}

/// `significant_digits`, in words where no digit is right.
template <class Real>
[[nodiscard]] std::string number_in_words(const Real& value, const Real& error, int most) {
  return in_words(significant_digits(value, error, most), value, error);
}

}  // namespace tautline::bench
