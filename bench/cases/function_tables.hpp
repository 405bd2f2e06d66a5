#pragma once

#include <algorithm>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "bench/base/strict_table.hpp"
#include "bench/base/text.hpp"
#include "bench/base/value.hpp"
#include "tautline/function.hpp"

// How a file says what is given over time.

namespace tautline::bench {

/// N numbers, as a function of N numbers has them; one is no array.
template <int N>
struct Ask {
  using Value = typename Function<N>::Value;
  static Value one(StrictTable& table, const Key& key, std::string_view unit,
                   const Range& /*range*/ = any_number) {
    return table.vector<N>(key, unit);
  }
  static std::optional<Value> optional_one(StrictTable& table, const Key& key,
                                           std::string_view unit) {
    return table.optional_vector<N>(key, unit);
  }
  static std::vector<Value> several(StrictTable& table, const Key& key, std::string_view unit) {
    return table.vectors<N>(key, unit, true);
  }
};

template <>
struct Ask<1> {
  using Value = Function<1>::Value;
  static Value one(StrictTable& table, const Key& key, std::string_view unit,
                   const Range& range = any_number) {
    return Value(table.number(key, range, unit));
  }
  static std::optional<Value> optional_one(StrictTable& table, const Key& key,
                                           std::string_view unit) {
    const std::optional<double> number = table.optional_number(key, any_number, unit);
    return number ? std::optional(Value(*number)) : std::nullopt;
  }
  static std::vector<Value> several(StrictTable& table, const Key& key, std::string_view unit) {
    std::vector<Value> result;
    for (const double number : table.numbers(key, unit, any_number, true)) {
      result.emplace_back(number);
    }
    return result;
  }
};

/// The constant part of a function; none where the file has none.
template <int N>
using Constant = std::optional<typename Function<N>::Value>;

template <int N>
std::vector<BasicWave<double, N>> read_waves(StrictTable& table, std::string_view unit) {
  std::vector<BasicWave<double, N>> waves;
  for (StrictTable& one :
       table.optional_tables({"waves", "each adds amplitude cos(frequency t + phase)"}, no_most,
                             "must be tables, each with amplitude and frequency")) {
    BasicWave<double, N> wave;
    wave.amplitude = Ask<N>::one(one, {"amplitude", "of the wave"}, unit);
    wave.frequency = one.number({"frequency", "of the wave"}, zero_or_above, "[rad/s]");
    wave.phase =
        one.optional_number({"phase", "at t = 0; default 0"}, any_number, "[rad]").value_or(0.0);
    one.refuse_unknown_keys();
    waves.push_back(wave);
  }
  return waves;
}

/// Reads `times` and `values`.
template <int N>
std::vector<BasicPiece<double, N>> read_values(StrictTable& table, std::string_view unit,
                                               const Constant<N>& constant) {
  std::vector<double> times =
      table.numbers({"times", "rising: when it has each of the values"}, "[s]", any_number, true);
  auto values = Ask<N>::several(
      table, {"values", "linear between the times, constant before and after"}, unit);
  const bool spline =
      table.flag({"spline", "true joins the values by a cubic spline instead of lines"});
  const auto fall = std::adjacent_find(times.begin(), times.end(), std::greater_equal<>());
  if (fall != times.end()) {
    table.refuse_value("times", "must rise: " + shortest(*fall) + " s is followed by " +
                                    shortest(*(fall + 1)) + " s" +
                                    (*fall == *(fall + 1) ? ", a jump" : ""));
  } else if (!times.empty() && !values.empty() && times.size() != values.size()) {
    table.refuse_value("values", std::to_string(values.size()) + " given, must be " +
                                     std::to_string(times.size()) + ", one for each of the times");
  } else if (times.size() == values.size() && !times.empty()) {
    for (auto& value : values) {
      value = constant ? typename Function<N>::Value(value + *constant) : value;
    }
    return (spline ? Function<N>::spline(times, values) : Function<N>::linear(times, values))
        .pieces;
  }
  return {};
}

/// Reads `pieces`.
template <int N>
std::vector<BasicPiece<double, N>> read_pieces(StrictTable& table, std::string_view unit,
                                               const Constant<N>& constant) {
  std::vector<BasicPiece<double, N>> pieces;
  for (StrictTable& one :
       table.optional_tables({"pieces", "polynomials, each until the next one starts"}, no_most,
                             "must be tables, each with from and polynomial")) {
    BasicPiece<double, N> piece{};
    piece.from = one.number({"from", "when the piece starts"}, any_number, "[s]");
    piece.coefficients = Ask<N>::several(
        one, {"polynomial", "its coefficients, in rising powers of the time since `from`"}, unit);
    one.refuse_unknown_keys();
    if (constant && !piece.coefficients.empty()) {
      piece.coefficients.front() += *constant;
    }
    pieces.push_back(std::move(piece));
  }
  return pieces;
}

/// Reads all that a table says of N numbers over time, besides their constant part, which the
/// pieces get.
template <int N>
Function<N> read_changes(StrictTable& table, std::string_view unit, const Constant<N>& constant) {
  Function<N> result;
  result.waves = read_waves<N>(table, unit);
  table.with("times", [&] { result.pieces = read_values<N>(table, unit, constant); });
  std::vector<BasicPiece<double, N>> pieces = read_pieces<N>(table, unit, constant);
  table.refuse_beside("pieces", {"times"}, "must be one of the two");
  if (!table.has("times")) {
    table.refuse_value("values", "is there without times, must have a time for each of them");
    table.refuse_value("spline", "is there without times and values, leave it out");
    result.pieces = std::move(pieces);
  }
  return result;
}

/// N numbers over time: a constant by itself, or a table.
template <int N>
Function<N> read_function(StrictTable table, std::string_view unit,
                          const Range& range = any_number) {
  const Key key = {"value", "the constant part; default 0"};
  if (table.is_short()) {
    return Function<N>::constant(Ask<N>::one(table, key, unit, range));
  }
  const Constant<N> constant = Ask<N>::optional_one(table, key, unit);
  Function<N> result = read_changes<N>(table, unit, constant);
  if (constant && result.pieces.empty()) {
    result.pieces = Function<N>::constant(*constant).pieces;
  }
  table.refuse_empty("must have value, waves, times with values, or pieces");
  table.refuse_unknown_keys();
  return result;
}

/// Likewise for a key that may be missing: then zero.
template <int N>
Function<N> read_optional_function(StrictTable& table, const Key& key, std::string_view unit) {
  if (!table.describes() && !table.has(key.name)) {
    return {};
  }
  return read_function<N>(table.table_or(key, "value", false), unit);
}

}  // namespace tautline::bench
