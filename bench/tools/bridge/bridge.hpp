#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "bench/base/terminal.hpp"
#include "bench/cases/any_case.hpp"
#include "bench/page/page_assets.hpp"

namespace tautline::bench {

// The way from elastic cables to inextensible ones: each cable becomes a spring of a stiffness k,
// with the damping ratio that belongs to its restitution (E6). For k to infinity its motion becomes
// the inextensible one, and what is between them falls with 1/sqrt(k) (analytic/README.md,
// section 13).

/// Over which stiffnesses, and how far, the motions are compared.
struct BridgeOptions {
  double softest = 0.0;     // [N/m]; 0: both are chosen, see `bridge_of`
  double stiffest = 0.0;    // [N/m], at least 10 times as large
  std::size_t impacts = 5;  // that are compared, at most
};

/// The softest and the stiffest differ by at most this many powers of ten.
inline constexpr double most_decades = 12.0;
inline constexpr double chosen_decades = 4.0;  // at most

/// A cable on both sides.
struct BridgeCable {
  double restitution;    // [-], of the inextensible one
  double damping_ratio;  // [-], of the elastic one
};

/// An impact of the inextensible motion.
struct BridgeImpact {
  double time;        // [s]
  std::size_t cable;  // the only one that takes part
};

/// The contact of an elastic cable that comes in its place.
struct BridgeContact {
  double shift;              // [s], of its entry, which is later than the impact where this is > 0
  double restitution_error;  // [-], its exit speed over its entry speed, less the restitution
};

/// The motion on elastic cables of one stiffness, compared with the inextensible one.
struct BridgeRow {
  double stiffness;                     // [N/m]
  double deviation;                     // [m], the largest of all centres of mass
  double shift;                         // [s], the largest of all contacts
  double restitution_error;             // [-], likewise
  std::vector<BridgeContact> contacts;  // one for each impact
};

/// All of them.
struct Bridge {
  std::string name;  // of the case
  std::vector<BridgeCable> cables;
  std::vector<BridgeImpact> impacts;  // those that are compared, at least one
  double until;                       // [s], the deviations are those up to here
  std::vector<BridgeRow> rows;        // by rising stiffness, at least two
  std::string why;                    // a sentence: why no more impacts are compared; may be empty
  /// Exponents of k, by least squares; none where a difference is 0, or of the shift of one impact.
  std::optional<double> deviation_slope;
  std::optional<double> shift_slope;
};

/// A bridge, or in one sentence why there is none.
struct BridgeReading {
  std::optional<Bridge> bridge;
  std::string problem;
};

/// Solves `any`, a case without problems, on inextensible and on elastic cables whose stiffness
/// rises by factors of ten. The impacts that are compared are the first ones, while each is one of
/// a single cable that rebounds, and the contacts come in the same order at every stiffness. The
/// chosen stiffnesses begin where a contact takes about 3 % of the shortest time between impacts.
[[nodiscard]] BridgeReading bridge_of(const AnyCase& any, const BridgeOptions& options);

/// The slopes that large stiffnesses have, and how far others may be off [-].
inline constexpr double expected_slope = -0.5;
inline constexpr double slope_tolerance = 0.02;

/// `bridge` for a terminal, as a page that needs no other file, and as JSON with its schema.
[[nodiscard]] std::string bridge_text(const Bridge& bridge, const TerminalStyle& style);
[[nodiscard]] std::string bridge_html(const Bridge& bridge, const PageAssets& assets);
[[nodiscard]] std::string bridge_json(const Bridge& bridge);
[[nodiscard]] std::string bridge_schema_json();

}  // namespace tautline::bench
