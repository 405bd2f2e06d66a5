// Compiled for processors that have AVX2, and called on no others: nothing here may be of a type
// that other sources share.
#include "shortcuts/batch/bounce_lanes_xsimd.hpp"

namespace tautline {

void bounce_lanes_avx2(const LaneQuestion& question, LaneAnswer& answer) {
  bounce_lanes<PackOf<xsimd::avx2>>(question, answer);
}

}  // namespace tautline
