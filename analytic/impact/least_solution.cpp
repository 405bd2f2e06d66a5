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
BasicCableVector<Real> least_solution(const BasicCableMatrix<Real>& a,
                                      const BasicCableVector<Real>& b,
                                      const std::type_identity_t<Real>& threshold) {
  Eigen::CompleteOrthogonalDecomposition<BasicCableMatrix<Real>> solver;
  solver.setThreshold(threshold);
  solver.compute(a);
  return solver.solve(b);
}

template BasicCableVector<Instance> least_solution(const BasicCableMatrix<Instance>&,
                                                   const BasicCableVector<Instance>&);
template BasicCableVector<Instance> least_solution(const BasicCableMatrix<Instance>&,
                                                   const BasicCableVector<Instance>&,
                                                   const Instance&);

}  // namespace tautline
