#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "system/elastic.hpp"
#include "system/rows.hpp"
#include "system/turning_series.hpp"
#include "tautline/solution.hpp"

namespace tautline {

/// The motion of a system from `start` with the cables of `taut` held at zero gap, as Taylor series
/// in the time since then (B1-B4). The rows of `taut` are independent, their gaps and gap rates
/// zero. With an empty set it is free flight. Elastic cables stay in their zones (E3).
template <class Real, int D>
class SystemSeries {
 public:
  using TheCase = BasicSystem<Real, D>;
  using Vector = BasicVector<Real, D>;

  /// Series up to t^order, order >= 2.
  SystemSeries(const TheCase& system, const BasicSystemState<Real, D>& start, CableSet taut,
               std::size_t order);
  SystemSeries(SystemSeries&&) noexcept = default;
  SystemSeries& operator=(SystemSeries&&) noexcept = default;
  SystemSeries(const SystemSeries&) = delete;  // its channels point into its own store
  SystemSeries& operator=(const SystemSeries&) = delete;
  ~SystemSeries() = default;

  [[nodiscard]] CableSet taut() const { return taut_; }

  /// Coefficients of all poses, one row each: of each body the position, then in the plane the
  /// angle, in space the quaternion and the spin.
  [[nodiscard]] PosesOf<TheCase> pose() const;

  /// Coefficient k of the place of a body.
  [[nodiscard]] Vector position(std::size_t body, std::size_t k) const {
    return bodies_[body].position[k];
  }
  /// The turn of a body of order k, at least 1.
  [[nodiscard]] BasicTurn<Real, D> turn(std::size_t body, std::size_t k) const {
    return bodies_[body].turning.turn_of(k);
  }

  /// Coefficients 0 to order of (length^2 - distance^2) / (2 length at the start) [m] of a slack
  /// cable, or, where it runs through rings, of its gap: both fall through zero together. Of a
  /// stretched cable, or one that resists, of its gap.
  [[nodiscard]] std::span<const Real> gap(std::size_t index) const { return cables_[index].gap; }

  /// Coefficients 0 to order - 2 of the tension [N] of a taut cable, or of what (E1) gives a
  /// stretched one.
  [[nodiscard]] std::span<const Real> tension(std::size_t index) const {
    return cables_[index].tension;
  }

  /// Coefficients 0 to order of how far [m] a stretched cable is beyond a corner of its law.
  [[nodiscard]] std::vector<Real> beyond(std::size_t index, const Real& corner) const;

  /// True while every coefficient is finite.
  [[nodiscard]] bool fits() const;

  /// How long [s] the series keep their last terms below `error` [-] of lengths and tensions: those
  /// of the poses, of what is given, and of all that is searched (T10).
  [[nodiscard]] Real reach(const Real& error) const;

  /// The work [J] up to `dt` [s] of all that acts but for impacts: gravity, forces, moments, drag,
  /// and the moving ends and lengths of taut and engaged cables (T9), with what the lengths do to
  /// laws of strain.
  [[nodiscard]] Real work(const Real& dt) const;

  /// The energy [J] up to `dt` [s] that a stretched elastic cable loses: in its damper while it is
  /// engaged, all that it stores while it is loose.
  [[nodiscard]] Real dissipated(std::size_t index, const Real& dt) const;

 private:
  using Channel = std::span<Real>;  // of coefficients, in store_
  using Places = Points<Real, D>;   // likewise
  using Given = std::vector<Vector>;
  using Unit = series::TimeUnit<Real>;
  struct BodySeries {
    const BasicBodyOfSystem<Real, D>* body;
    Places position;
    TurningSeries<Real, D> turning;
    Given force;  // [N]; empty: none
    Vector pull;  // [N], at the order that is computed
  };
  struct SegmentSeries {
    Places along;     // from its second end to its first [m]
    Places distance;  // [m], each number of the point; of a straight taut cable its length
    Places pull;      // tension / distance [N/m], each number of the point
  };
  struct CableSeries {
    std::vector<SegmentSeries> segments;
    std::vector<Given> ends;  // where they move in the world
    Channel length;
    Channel gap;      // of a slack cable, or a stretched one
    Channel tension;  // of a taut one, or a stretched one
    bool acts;        // it is hooked up and not cut
    bool steady;      // its length is constant
    bool straight;    // no rings
  };
  struct StretchSeries {  // of an elastic cable that is stretched or resists
    std::size_t index;
    bool pulls;
    bool slack;  // it has its damper alone
    const BasicElasticity<Real>* law;
    Real damping;                           // [N s/m]
    Real response;                          // [1/kg], to an impulse of its own
    ForcePiece<Real> piece;                 // of its law
    std::vector<std::vector<Real>> powers;  // of what that takes: its square, its cube, ... (E3)
    std::vector<Real> parts;  // of the gap in the length, where it takes those; else empty
  };
  struct Kept {  // what the cables do to keep their lengths, at the order that is computed
    RowOf<TheCase> sum;
    std::vector<Real> open;
  };

  [[nodiscard]] bool is_ballistic() const;
  void make_channels();
  void expand_given(const Real& time);
  void start_at(const BasicSystemState<Real, D>& start);
  void couple(const BasicSystemState<Real, D>& start);
  void advance(std::size_t k);
  void begin(std::size_t k);
  void pull(std::size_t index, std::size_t k);
  void pull_segment(std::size_t index, std::size_t i, std::size_t k);
  void find_stretched(const BasicSystemState<Real, D>& start);
  void stretch(std::size_t index, std::size_t k);
  void strain(StretchSeries& one, std::size_t k);
  [[nodiscard]] const Real* taken(const StretchSeries& one) const;
  void add_power(const StretchSeries& one, const Unit& unit, std::vector<Real>& result) const;
  void pull(const StretchSeries& one, std::size_t k);
  void expand_stretched(StretchSeries& one);
  [[nodiscard]] Real opening(std::size_t index, std::size_t k);
  [[nodiscard]] RowOf<TheCase> driving(std::size_t k) const;
  void accelerate(std::size_t k, const RowOf<TheCase>& accelerations);
  void tighten(std::size_t index, std::size_t k, const Real& tension,
               const RowOf<TheCase>& accelerations);
  void expand_gap(std::size_t index);
  void set_distance(SegmentSeries& segment, std::size_t k, const Real& value);
  void add_pull(const BasicEnd<Real, D>& end, std::size_t k, const Vector& force);
  [[nodiscard]] Vector place(std::size_t index, std::size_t end, std::size_t k) const;
  [[nodiscard]] Vector turned_place(std::size_t index, std::size_t end, std::size_t k) const;
  [[nodiscard]] Real distance_of(const SegmentSeries& segment, std::size_t k) const;
  void add_power(const BodySeries& body, const Unit& unit, std::vector<Real>& result) const;
  void add_power(const CableSeries& cable, std::size_t terms, const Unit& unit,
                 std::vector<Real>& result) const;
  [[nodiscard]] Real last_term(std::size_t k) const;
  [[nodiscard]] Real tension_scale(const StretchSeries& one, const Real& load) const;
  [[nodiscard]] Real apart_for(const SegmentSeries& segment, const Real& most) const;

  const TheCase* system_;
  CableSet taut_;
  std::size_t order_;
  std::unique_ptr<Real[]> store_;
  std::vector<BodySeries> bodies_;
  std::vector<CableSeries> cables_;
  std::vector<StretchSeries> stretched_;
  bool pulled_;  // by cables
  Given gravity_;
  RowOf<TheCase> weight_;      // M^-1/2
  RowSpace<TheCase> coupled_;  // of the rows of the taut cables
  Real length_scale_;          // [m]
};

/// The motion along an arc of a solution; none where nothing moves, or for an instant.
template <class Real, int D>
[[nodiscard]] std::optional<SystemSeries<Real, D>> motion_along(
    const BasicSystem<Real, D>& system, const BasicArc<BasicSystem<Real, D>>& arc) {
  constexpr Eigen::Index least_rows = 3;  // a series shorter than that is a rest
  if (arc.series.rows() < least_rows || !(arc.end > arc.start)) {
    return std::nullopt;
  }
  CableSet pulling;
  if (!arc.taut.empty()) {  // what redundant cables share has the same work
    const CableRows<BasicSystem<Real, D>> rows(system, arc.initial, arc.taut);
    const CableSet basis = rows.most_independent();
    std::size_t row = 0;
    for (const std::size_t index : arc.taut) {
      if (basis.contains(row++)) {
        pulling.insert(index);
      }
    }
  }
  const auto order = static_cast<std::size_t>(arc.series.rows() - 1);
  return SystemSeries<Real, D>(system, arc.initial, pulling, order);
}

/// The response of cable `index`, the only one that pulls, to an impulse of its own [1/kg], the
/// rate of that [1/(kg s)], and a length that both are not multiplied by: 1 (see bouncing.hpp).
template <class Real, int D>
[[nodiscard]] std::array<Real, 3> scaled_response(const BasicSystem<Real, D>& system,
                                                  const BasicSystemState<Real, D>& start,
                                                  const SystemSeries<Real, D>& /*motion*/,
                                                  std::size_t index) {
  using Row = RowOf<BasicSystem<Real, D>>;
  const Row row = gap_gradient(system.cables[index], start);
  const Row response = row.cwiseProduct(inverse_mass(system.bodies));
  const Row rate = gap_gradient_rate(system.cables[index], start);
  return {Real(row.dot(response)), Real(2 * rate.dot(response)), Real(1)};
}

}  // namespace tautline
