// The functions of <cmath> that round as each library likes, by arithmetic alone.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "flight/turn.hpp"
#include "tautline/geometry.hpp"

namespace tautline {
namespace {

constexpr std::size_t parts_of_window = 6;  // of 32 binary digits each: 192
using Window = std::array<std::uint32_t, parts_of_window>;

/// 2 / pi as a fraction, in parts of 32 binary digits, behind two parts of zeros.
constexpr std::array<std::uint32_t, 39> two_over_pi = {
    0,          0,          0xa2f9836e, 0x4e441529, 0xfc2757d1, 0xf534ddc0, 0xdb629599, 0x3c439041,
    0xfe5163ab, 0xdebbc561, 0xb7246e3a, 0x424dd2e0, 0x06492eea, 0x09d1921c, 0xfe1deb1c, 0xb129a73e,
    0xe88235f5, 0x2ebb4484, 0xe99c7026, 0xb45f7e41, 0x3991d639, 0x835339f4, 0x9c845f8b, 0xbdf9283b,
    0x1ff897ff, 0xde05980f, 0xef2f118b, 0x5a0a6d1f, 0x6d367ecf, 0x27cb09b7, 0x4f463f66, 0x9e5fea2d,
    0x7527bac7, 0xebe5f17b, 0x3d0739f7, 0x8a5292ea, 0x6bfb5fb1, 0x1f8d5d08, 0x56033046};

/// Its digits from the one at `place` on; the last part comes first.
Window digits_from(std::size_t place) {
  Window result{};
  const std::size_t shift = place % 32;
  for (std::size_t k = 0; k < parts_of_window; ++k) {
    const std::size_t part = place / 32 + parts_of_window - 1 - k;
    const std::uint64_t pair = std::uint64_t{two_over_pi[part]} << 32U | two_over_pi[part + 1];
    result[k] = static_cast<std::uint32_t>(pair >> (32U - shift));
  }
  return result;
}

/// The last 192 digits of `window` times `factor`.
Window times(const Window& window, std::uint64_t factor) {
  Window result{};
  for (std::size_t half = 0; half < 2; ++half) {
    const std::uint64_t by = half == 0 ? factor & 0xffffffffU : factor >> 32U;
    std::uint64_t carry = 0;
    for (std::size_t k = half; k < parts_of_window; ++k) {
      carry += result[k] + window[k - half] * by;
      result[k] = static_cast<std::uint32_t>(carry);
      carry >>= 32U;
    }
  }
  return result;
}

/// The logarithm of `value` > 0 to the base e, to 1e-9: the series of the area tangent.
double logarithm(double value) {
  int exponent = 0;
  double rest = std::frexp(value, &exponent) * std::numbers::sqrt2;  // 0.71 to 1.41
  const double s = (rest - 1.0) / (rest + 1.0);
  const double x = s * s;  // up to 0.03
  const double series =
      1.0 + x * (1.0 / 3 + x * (1.0 / 5 + x * (1.0 / 7 + x * (1.0 / 9 + x * (1.0 / 11)))));
  return 2.0 * s * series + (exponent - 0.5) * std::numbers::ln2;
}

/// e to the power of `value`, 745 at most in size, to 1e-10: its series, to the power of eight.
double exponential(double value) {
  const double doublings = nearest(value / std::numbers::ln2);
  const double x = (value - doublings * std::numbers::ln2) / 8.0;  // up to 0.044
  double power =
      1.0 + x * (1.0 + x / 2 * (1.0 + x / 3 * (1.0 + x / 4 * (1.0 + x / 5 * (1.0 + x / 6)))));
  for (int squared = 0; squared < 3; ++squared) {
    power *= power;
  }
  return std::ldexp(power, static_cast<int>(doublings));
}

}  // namespace

/// M. H. Payne and R. N. Hanek's reduction: of the product with 2 / pi only the digits next to the
/// point are needed, and those of a multiple of four quarters are never computed. A double is no
/// nearer to a multiple of a quarter than 2^-62, and the product is right to 2^-137 of one.
Direction<double> far_direction(double angle) {
  if (!std::isfinite(angle)) {
    return {not_a_number<double>(), not_a_number<double>()};
  }
  constexpr int digits = 53;       // of a double
  constexpr int first_digit = 62;  // of the window, for an integer: its first two are quarters
  int exponent = 0;
  const double fraction = std::frexp(abs(angle), &exponent);
  const auto integer = static_cast<std::uint64_t>(std::ldexp(fraction, digits));
  const auto place = static_cast<std::size_t>(first_digit + exponent - digits);
  Window product = times(digits_from(place), integer);
  std::uint32_t& top = product.back();
  int quarters = static_cast<int>(top >> 30U);
  top &= 0x3fffffffU;
  const bool beyond_half = (top >> 29U) != 0;  // the next quarter is nearer, and the rest negative
  if (beyond_half) {
    ++quarters;
    top |= 0xc0000000U;
    std::uint64_t carry = 1;  // the complement of two
    for (std::uint32_t& part : product) {
      carry += std::uint32_t(~part);
      part = static_cast<std::uint32_t>(carry);
      carry >>= 32U;
    }
  }
  double rest = 0.0;  // [quarters], in size
  for (std::size_t k = 0; k < parts_of_window; ++k) {
    rest = (rest + product[k]) / (k + 1 < parts_of_window ? 0x1p32 : 0x1p30);
  }
  rest *= (beyond_half ? -0.5 : 0.5) * pi<double>();
  const double k = quarters == 3 ? -1.0 : static_cast<double>(quarters % 4);
  const auto [cosine, sine] = beyond_quarters(k, rest);
  return {cosine, angle < 0.0 ? -sine : sine};
}

Heading<double> compute_heading(double angle) {
  const auto [cosine, sine] = direction(angle);
  return {cosine, sine};
}

double sin(double angle) { return direction(angle).sine; }

double cos(double angle) { return direction(angle).cosine; }

double atan2(double y, double x) {
  const double largest = max(abs(x), abs(y));
  if (largest == 0.0) {
    return copysign(std::signbit(x) ? pi<double>() : 0.0, y);
  }
  const double along = abs(x) / largest;
  const double across = abs(y) / largest;
  const double sine = min(along, across) / sqrt(along * along + across * across);
  double angle = sine * (1.0 + sine * sine / 6.0);  // up to an eighth of a turn, to 0.02
  constexpr int enough = 4;                         // by Newton's method: 2e-4, 2e-8, rounding
  for (int iteration = 0; iteration < enough; ++iteration) {
    const auto turned = small_turn(angle);
    angle += (sine - turned.sine) / (1.0 - turned.versine);
  }
  if (across > along) {
    angle = pi<double>() / 2 - angle;
  }
  return copysign(std::signbit(x) ? pi<double>() - angle : angle, y);
}

double exp(double value) {
  constexpr double largest = 746.0;  // in size: beyond it is 0 or infinite
  const double power = std::clamp(value, -largest, largest);
  const double doublings = nearest(power / std::numbers::ln2);
  constexpr double high = 0x1.62e42fefap-1;  // of ln 2, whose products with integers are exact
  constexpr double low = 0x1.cf79abc9e3b39p-40;
  const double x = (power - doublings * high) - doublings * low;  // up to 0.35
  double sum = 0.0;
  constexpr int terms = 16;  // 0.35^16 / 16! is below rounding
  for (int k = terms; k > 0; --k) {
    sum = x * (1.0 + sum) / k;
  }
  return std::ldexp(1.0 + sum, static_cast<int>(doublings));
}

double log(double value) {
  const double near = logarithm(value);
  return near + (value * exp(-near) - 1.0);  // Newton's method doubles its nine digits
}

double root(double value, double degree) {
  return value > 0.0 && isfinite(value) ? exponential(logarithm(value) / degree) : value;
}

}  // namespace tautline
