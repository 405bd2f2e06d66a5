#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "tautline/case.hpp"
#include "tautline/system.hpp"

namespace tautline {

/// How the mass of a breakwater is spread (source chapter, Eqs. 5.5 and 5.6).
enum class Shape {
  ring,  // thin ring of radius a: inertia a^2; the point mass is the ring with a = 0
  box,   // solid box 2a wide and 2b deep: inertia (a^2 + b^2) / 3
};

/// A breakwater hung from two equal cables (source chapter, Fig. 5.1): nondimensional, mass and
/// gravity 1, anchors at (-1, h + b) and (1, h + b), attachments at (-a, b) and (a, b); the origin
/// is the equilibrium. Cable 0 is the left one, cable 1 the right.
template <class Real>
struct BasicBreakwater {
  Real r = Real(15) / 10;         // [-], cable length; > 1 - a, or the body cannot float (Eq. 5.1)
  Real e = Real(9) / 10;          // [-], restitution of both cables
  Real a = Real(1) / 10;          // [-], half width, >= 0
  Real b = Real(0);               // [-], depth of the centre of mass below the attachments
  Shape shape = Shape::ring;      // of what has dimensions
  BasicState<Real> initial = {};  // at time 0
  Real duration = Real(20);       // [sqrt(S/g)]
};
using Breakwater = BasicBreakwater<double>;

/// The chapter's validity limits: rotation within +-pi/2, attachments below the anchors.
enum class ChapterLimits { off, on };

/// The case of a breakwater. Throws std::invalid_argument if r <= 1 - a.
template <class Real>
[[nodiscard]] BasicCase<Real> breakwater(const BasicBreakwater<Real>& parameters,
                                         const std::string& name,
                                         ChapterLimits limits = ChapterLimits::off);

/// One row of the source chapter's Table 5.1.
template <class Real>
struct BasicTableRow {
  std::string_view number;           // the chapter's case number
  BasicBreakwater<Real> parameters;  // as printed
};
using TableRow = BasicTableRow<double>;

/// The 21 distinct cases of Table 5.1, in the order of their first mention; the last is the point
/// mass. The numbers are the nearest of type Real to the table's decimals.
template <class Real = double>
[[nodiscard]] std::vector<BasicTableRow<Real>> table_5_1();

/// Case zero: a ball on one cable through its centre of mass, dropped straight below the anchor.
/// Bounces form a geometric series that ends at (1 + e) / (1 - e) times the time of the first fall.
[[nodiscard]] Case bouncing_ball(double restitution = 0.5);

/// Every case that ships, by name: `breakwater/<number>` and the others in this file.
[[nodiscard]] std::vector<Case> shipped_cases();

/// A system that ships, of D dimensions.
template <int D>
struct BasicShippedSystem {
  BasicSystem<double, D> system;  // as its file has it
  std::string_view shows;         // in two sentences
};
using ShippedSystem = BasicShippedSystem<2>;         // in the plane
using ShippedSpatialSystem = BasicShippedSystem<3>;  // in space

/// Every system that ships. No case is one of them: each has several bodies, or something changes
/// over time.
[[nodiscard]] std::vector<ShippedSystem> shipped_systems();

/// Every system in space that ships.
[[nodiscard]] std::vector<ShippedSpatialSystem> shipped_spatial_systems();

}  // namespace tautline
