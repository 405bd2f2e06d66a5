#include "bench/ensemble/draw.hpp"

#include <algorithm>
#include <boost/random/sobol.hpp>
#include <cmath>
#include <functional>
#include <optional>

#include "bench/ensemble/normal.hpp"
#include "bench/ensemble/random.hpp"

namespace tautline::bench {
namespace {

/// The points of Sobol's sequence in so many dimensions.
class SobolPoints {
 public:
  explicit SobolPoints(std::size_t dimensions) : sequence_(dimensions) {}

  [[nodiscard]] std::size_t dimensions() const { return sequence_.dimension(); }
  void go_to(std::size_t index) { sequence_.seed(index); }

  /// The next number of the point, turned by a random shift (Cranley and Patterson 1976): so that a
  /// seed has its say, and no number is 0.
  double next(std::uint64_t seed, std::size_t place) {
    constexpr double points = 0x1p64;  // of the sequence's numbers, which are integers
    const double shift = random_part(seed, Purpose::shift, 0, place);
    const double part = static_cast<double>(sequence_()) / points + shift;
    const double turned = part - std::floor(part);
    return std::clamp(turned, 0x1p-54, 1.0 - 0x1p-53);
  }

 private:
  boost::random::sobol sequence_;
};

/// The points of the last draw of this thread: the numbers that the sequence begins from are many.
SobolPoints& sobol_points(std::size_t dimensions) {
  static thread_local std::optional<SobolPoints> kept;
  if (!kept || kept->dimensions() != dimensions) {
    kept.emplace(dimensions);
  }
  return *kept;
}

/// What a number in (0, 1) means.
double value_at(const Distribution& distribution, double centre, double part) {
  const std::vector<double>& numbers = distribution.numbers;
  switch (distribution.kind) {
    case Distribution::Kind::normal:
      return centre + numbers.front() * normal_quantile(part);
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
  const auto is_grid = [](const Varied& one) {
    return one.distribution.kind == Distribution::Kind::grid;
  };
  const auto drawn = static_cast<std::size_t>(
      std::count_if(spec.varied.begin(), spec.varied.end(), std::not_fn(is_grid)));
  SobolPoints* const sobol =
      spec.sampling == Sampling::sobol && drawn > 0 ? &sobol_points(drawn) : nullptr;
  if (sobol != nullptr) {
    sobol->go_to(index);
  }
  std::size_t place = 0;  // among those that are drawn
  std::size_t rest = drawn < spec.varied.size() ? grid_point(spec, index) : 0;
  DrawnValues values;
  values.reserve(spec.varied.size());
  for (const Varied& one : spec.varied) {
    const Distribution& distribution = one.distribution;
    if (is_grid(one)) {  // the first grid goes fastest
      values.push_back(distribution.numbers[rest % distribution.numbers.size()]);
      rest /= distribution.numbers.size();
      continue;
    }
    const double part = sobol != nullptr ? sobol->next(seed, place)
                                         : random_part(seed, Purpose::draw, index, place);
    const double centre = std::visit(
        [&](const auto& the_case) { return quantity(the_case, one.quantity); }, spec.the_case);
    values.push_back(value_at(distribution, centre, part));
    ++place;
  }
  return values;
}

AnyCase case_of(const EnsembleSpec& spec, const DrawnValues& values) {
  AnyCase the_case = spec.the_case;
  for (std::size_t place = 0; place < values.size(); ++place) {
    std::visit([&](auto& one) { set_quantity(one, spec.varied[place].quantity, values[place]); },
               the_case);
  }
  return the_case;
}

}  // namespace tautline::bench
