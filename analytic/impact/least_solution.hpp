#pragma once

#include <optional>

#include "tautline/case.hpp"

namespace tautline {

/// The shortest of the x that leave the smallest |a x - b|. A source of its own, because what it
/// takes is the dearest to compile of all.
template <class Real>
[[nodiscard]] BasicCableVector<Real> least_solution(const BasicCableMatrix<Real>& a,
                                                    const BasicCableVector<Real>& b);

/// The same where pivots below `threshold` [-] of the largest count as zero; none with a rank of
/// `full` or more.
template <class Real>
[[nodiscard]] std::optional<BasicCableVector<Real>> least_solution(const BasicCableMatrix<Real>& a,
                                                                   const BasicCableVector<Real>& b,
                                                                   double threshold,
                                                                   Eigen::Index full);

}  // namespace tautline
