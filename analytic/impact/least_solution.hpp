#pragma once

#include <type_traits>

#include "tautline/case.hpp"

namespace tautline {

/// The shortest of the x that leave the smallest |a x - b|. A source of its own, because what it
/// takes is the dearest to compile of all.
template <class Real>
[[nodiscard]] BasicCableVector<Real> least_solution(const BasicCableMatrix<Real>& a,
                                                    const BasicCableVector<Real>& b);

/// The same where pivots below `threshold` [-] of the largest count as zero.
template <class Real>
[[nodiscard]] BasicCableVector<Real> least_solution(const BasicCableMatrix<Real>& a,
                                                    const BasicCableVector<Real>& b,
                                                    const std::type_identity_t<Real>& threshold);

}  // namespace tautline
