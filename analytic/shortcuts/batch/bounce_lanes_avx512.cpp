// Compiled for processors that have AVX512, and called on no others: nothing here may be of a type
// that other sources share.
#include "shortcuts/batch/bounce_lanes_xsimd.hpp"

namespace tautline {

void bounce_lanes_avx512(const LaneQuestion& question, LaneAnswer& answer) {
  bounce_lanes<PackOf<xsimd::avx512f>>(question, answer);
}

}  // namespace tautline
