#include "bench/ensemble/output/energy_distance.hpp"

#include <boost/random/uniform_int_distribution.hpp>
#include <utility>

#include "bench/ensemble/random.hpp"

namespace tautline::bench {
namespace {

/// As many permutations that are further apart settle that the samples are not.
constexpr std::size_t enough = 20;

/// Both samples as one, in rising order.
struct Pooled {
  Pooled(const std::vector<double>& one, const std::vector<double>& other)
      : first(one.size()), second(other.size()) {
    widths.reserve(first + second);  // the values, for now
    of_first.reserve(first + second);
    for (auto next = one.begin(), rival = other.begin();
         next != one.end() || rival != other.end();) {
      const bool is_first = rival == other.end() || (next != one.end() && *next < *rival);
      of_first.push_back(is_first ? 1 : 0);
      widths.push_back(is_first ? *next++ : *rival++);
    }
    for (std::size_t place = 0; place + 1 < widths.size(); ++place) {
      widths[place] = widths[place + 1] - widths[place];
    }
    widths.back() = 0.0;
  }

  std::size_t first;
  std::size_t second;
  std::vector<unsigned char> of_first;  // of each value in order: 1 if it is the first sample's
  std::vector<double> widths;           // from each value to the next
};

/// The integrals over F and G, the distribution functions of the samples.
struct Integrals {
  double squared = 0.0;  // of (F - G)^2
  double mixed = 0.0;    // of F (1 - G) + G (1 - F), which is E|X-Y|
};

Integrals integrals_of(const Pooled& pooled) {
  Integrals result;
  const double one = 1.0 / static_cast<double>(pooled.first);
  const double other = 1.0 / static_cast<double>(pooled.second);
  std::size_t below = 0;  // of the first sample
  for (std::size_t place = 0; place < pooled.widths.size(); ++place) {
    below += pooled.of_first[place];
    const double f = static_cast<double>(below) * one;
    const double g = static_cast<double>(place + 1 - below) * other;
    result.squared += (f - g) * (f - g) * pooled.widths[place];
    result.mixed += (f * (1.0 - g) + g * (1.0 - f)) * pooled.widths[place];
  }
  return result;
}

/// The bits of one seed in a row, for Boost.Random.
class Bits {
 public:
  using result_type = std::uint64_t;
  explicit Bits(std::uint64_t seed) : seed_(seed) {}
  static constexpr result_type min() { return 0; }
  static constexpr result_type max() { return ~result_type{0}; }
  result_type operator()() { return random_bits(seed_, Purpose::permutation, next_++, 0); }

 private:
  std::uint64_t seed_;
  std::uint64_t next_ = 0;
};

/// Fisher and Yates's shuffle: that of the standard library is another in each implementation.
void shuffle(std::vector<unsigned char>& labels, Bits& bits) {
  for (std::size_t last = labels.size() - 1; last > 0; --last) {
    const boost::random::uniform_int_distribution<std::size_t> up_to(0, last);
    std::swap(labels[last], labels[up_to(bits)]);
  }
}

}  // namespace

double energy_coefficient(const std::vector<double>& one, const std::vector<double>& other) {
  const Integrals integrals = integrals_of(Pooled(one, other));
  return integrals.mixed > 0.0 ? integrals.squared / integrals.mixed : 0.0;
}

double energy_probability(const std::vector<double>& one, const std::vector<double>& other,
                          std::uint64_t seed, std::size_t permutations) {
  Pooled pooled(one, other);
  // the order of summation is the same for all: a permutation that is none is not further apart
  const double found = integrals_of(pooled).squared;
  Bits bits(seed);
  std::size_t further = 0;
  for (std::size_t round = 1; round <= permutations; ++round) {
    shuffle(pooled.of_first, bits);
    further += integrals_of(pooled).squared >= found ? 1U : 0U;
    if (further == enough) {
      return static_cast<double>(further) / static_cast<double>(round);
    }
  }
  return static_cast<double>(further + 1) / static_cast<double>(permutations + 1);
}

}  // namespace tautline::bench
