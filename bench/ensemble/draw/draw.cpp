#include "bench/ensemble/draw/draw.hpp"

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <boost/random/sobol.hpp>
#include <cmath>

#include "bench/ensemble/draw/random.hpp"
#include "bench/ensemble/spec/quantity.hpp"

namespace tautline::bench {
namespace {

/// Numbers in (0, 1), one for each quantity that is drawn.
std::vector<double> random_parts(std::uint64_t seed, std::size_t index, std::size_t count) {
  std::vector<double> parts;
  parts.reserve(count);
  for (std::size_t place = 0; place < count; ++place) {
    parts.push_back(random_part(seed, Purpose::draw, index, place));
  }
  return parts;
}

/// The same from Sobol's sequence, turned by a random shift (Cranley and Patterson 1976): so that a
/// seed has its say, and no number is 0.
std::vector<double> sobol_parts(std::uint64_t seed, std::size_t index, std::size_t count) {
  if (count == 0) {
    return {};
  }
  boost::random::sobol sequence(count);
  sequence.seed(index);
  constexpr double points = 0x1p64;  // of the sequence's numbers, which are integers
  std::vector<double> parts;
  parts.reserve(count);
  for (std::size_t place = 0; place < count; ++place) {
    const double shift = random_part(seed, Purpose::shift, 0, place);
    const double part = static_cast<double>(sequence()) / points + shift;
    const double turned = part - std::floor(part);
    parts.push_back(std::clamp(turned, 0x1p-54, 1.0 - 0x1p-53));
  }
  return parts;
}

/// What a number in (0, 1) stands for.
double value_at(const Distribution& distribution, double centre, double part) {
  const std::vector<double>& numbers = distribution.numbers;
  switch (distribution.kind) {
    case Distribution::Kind::normal:
      return boost::math::quantile(boost::math::normal(centre, numbers.front()), part);
    case Distribution::Kind::uniform:
      return numbers[0] + (numbers[1] - numbers[0]) * part;
    case Distribution::Kind::list:
    case Distribution::Kind::grid:
      break;
  }
  const auto place = static_cast<std::size_t>(part * static_cast<double>(numbers.size()));
  return numbers[std::min(place, numbers.size() - 1)];
}

}  // namespace

std::size_t grid_point(const EnsembleSpec& spec, std::size_t index) {
  return index % grid_points(spec);
}

DrawnValues drawn_values(const EnsembleSpec& spec, std::uint64_t seed, std::size_t index) {
  const std::size_t drawn = spec.varied.size() - grid_axes(spec).size();
  const std::vector<double> parts = spec.sampling == Sampling::sobol
                                        ? sobol_parts(seed, index, drawn)
                                        : random_parts(seed, index, drawn);
  auto part = parts.begin();
  std::size_t rest = grid_point(spec, index);  // the first grid goes fastest
  DrawnValues values;
  values.reserve(spec.varied.size());
  for (const auto& [name, distribution] : spec.varied) {
    if (distribution.kind == Distribution::Kind::grid) {
      values.push_back(distribution.numbers[rest % distribution.numbers.size()]);
      rest /= distribution.numbers.size();
    } else {
      values.push_back(value_at(distribution, quantity(spec.the_case, name), *part++));
    }
  }
  return values;
}

Case case_of(const EnsembleSpec& spec, const DrawnValues& values) {
  Case the_case = spec.the_case;
  for (std::size_t place = 0; place < values.size(); ++place) {
    set_quantity(the_case, spec.varied[place].quantity, values[place]);
  }
  return the_case;
}

}  // namespace tautline::bench
