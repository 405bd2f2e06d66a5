#include "bench/ensemble/random.hpp"

#include <Random123/philox.h>

#include <Random123/uniform.hpp>

namespace tautline::bench {

std::uint64_t random_bits(std::uint64_t seed, Purpose purpose, std::uint64_t index,
                          std::uint64_t place) {
  const r123::Philox4x64 philox;
  return philox({{index, place, static_cast<std::uint64_t>(purpose), 0}}, {{seed, 0}})[0];
}

double random_part(std::uint64_t seed, Purpose purpose, std::uint64_t index, std::uint64_t place) {
  return r123::u01fixedpt<double>(random_bits(seed, purpose, index, place));
}

}  // namespace tautline::bench
