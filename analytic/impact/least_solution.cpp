#include "least_solution.hpp"

#include <Eigen/QR>

#include "instantiate.hpp"

namespace tautline {

template <class Real>
BasicCableVector<Real> least_solution(const BasicCableMatrix<Real>& a,
                                      const BasicCableVector<Real>& b) {
  return a.completeOrthogonalDecomposition().solve(b);
}

template <class Real>
std::optional<BasicCableVector<Real>> least_solution(const BasicCableMatrix<Real>& a,
                                                     const BasicCableVector<Real>& b,
                                                     double threshold, Eigen::Index full) {
  Eigen::CompleteOrthogonalDecomposition<BasicCableMatrix<Real>> solver;
  solver.setThreshold(Real(threshold));
  solver.compute(a);
  if (solver.rank() >= full) {
    return std::nullopt;
  }
  return BasicCableVector<Real>(solver.solve(b));
}

template BasicCableVector<Instance> least_solution(const BasicCableMatrix<Instance>&,
                                                   const BasicCableVector<Instance>&);
template std::optional<BasicCableVector<Instance>> least_solution(const BasicCableMatrix<Instance>&,
                                                                  const BasicCableVector<Instance>&,
                                                                  double, Eigen::Index);

}  // namespace tautline
