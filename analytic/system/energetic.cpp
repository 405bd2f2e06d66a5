#include "system/energetic.hpp"

#include <Eigen/QR>
#include <utility>
#include <vector>

#include "impact/least_solution.hpp"
#include "impact/spring_impact.hpp"
#include "instantiate.hpp"
#include "system/rows.hpp"
#include "tautline/detail/projection.hpp"

namespace tautline {
namespace {

/// Rows of the same lengths and angles in as many dimensions as a planar body has freedoms.
template <class Real, int D>
RowsOf<BasicCase<Real>> compressed(const RowsOf<BasicSystem<Real, D>>& rows) {
  using Matrix = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>;
  const Eigen::HouseholderQR<Matrix> qr{Matrix(rows.transpose())};
  RowsOf<BasicCase<Real>> result(rows.rows(), 3);
  result.setZero();
  for (Eigen::Index row = 0; row < rows.rows(); ++row) {
    for (Eigen::Index k = 0; k <= row && k < rows.cols(); ++k) {
      result(row, k) = qr.matrixQR()(k, row);
    }
  }
  return result;
}

}  // namespace

template <class Real, int D>
SpringImpulses<Real> energetic_impulses(const BasicSystem<Real, D>& system,
                                        const BasicSystemState<Real, D>& before, CableSet cables) {
  using Planar = BasicCase<Real>;
  constexpr double least_restitution = 1e-4;  // [-], as in the plane
  const auto count = static_cast<Eigen::Index>(cables.size());
  if (cables.size() > most_energetic) {
    return {BasicCableVector<Real>::Constant(count, not_a_number<Real>())};
  }
  const CableRows<BasicSystem<Real, D>> wide(system, before, cables);
  const RowsOf<Planar> rows = compressed<Real, D>(wide.rows());
  const BasicCableVector<Real> rates = gap_rates(system, before, cables);
  const RowOf<Planar> velocity = least_solution<Real>(rows, rates);
  const Real row_scale = rows.rowwise().norm().maxCoeff();
  const Real speed_scale = velocity.norm();
  if (!(speed_scale > 0)) {
    return {BasicCableVector<Real>::Zero(count)};
  }
  std::vector<energetic::Spring<Planar>> springs;
  for (const std::size_t index : cables) {
    const auto row = static_cast<Eigen::Index>(springs.size());
    const Real e = restitution(system.cables[index], rates[row]);
    springs.push_back(
        {rows.row(row).transpose() / row_scale, e < least_restitution ? Real(0) : Real(e * e)});
  }
  energetic::SpringImpact<Planar> impact(std::move(springs), velocity / speed_scale);
  const int steps = impact.run();
  return {impact.impulses() * (speed_scale / row_scale), steps};
}

template SpringImpulses<Instance> energetic_impulses(const InstanceCase&,
                                                     const StateOf<InstanceCase>&, CableSet);

}  // namespace tautline
