#pragma once

#include <optional>
#include <string>

#include "bench/base/strict_table.hpp"
#include "tautline/elasticity.hpp"

// How a file says that a cable is elastic.

namespace tautline::bench {

/// Adds a finding on each of the keys that says a second time what `law` loses in a contact.
inline void refuse_second_damping(StrictTable& table) {
  const char* first = nullptr;
  for (const char* const key : {"damping", "damping_ratio", "restitution"}) {
    if (table.has(key)) {
      if (first != nullptr) {
        table.refuse_value(key, std::string("is there with ") + first +
                                    ", must be one of damping, damping_ratio and restitution");
      }
      first = key;
    }
  }
}

/// Reads what a cable loses in a contact.
inline void read_damping(StrictTable& table, Elasticity& law) {
  law.damping = table
                    .optional_number({"damping",
                                      "the force per speed at which the cable is stretched; "
                                      "default 0"},
                                     zero_or_above, "[N s/m]")
                    .value_or(0.0);
  law.damping_ratio =
      table
          .optional_number(
              {"damping_ratio", "instead of damping: the share of critical damping at each entry"},
              zero_or_above, "")
          .value_or(0.0);
}

/// Reads how a cable pulls where it is longer than its length; none if it has no stiffness. With a
/// stiffness, `restitution` is a third way to say the damping.
inline std::optional<Elasticity> read_elasticity(StrictTable& table) {
  const bool is_elastic = table.has("stiffness");
  Elasticity law;
  table.with("stiffness", [&] {
    const Range above = {
        "a finite number above 0, or an array of numbers k1, k2, ... for k1 s + "
        "k2 s^2 + ...",
        1.0,
        0.0,
        {},
        true};
    law.stiffness = table.number_or_numbers(
        {"stiffness",
         "makes the cable elastic: the force per stretch s, or k1, k2, ... for the force k1 s + k2 "
         "s^2 + ..."},
        above, "[N/m, N/m^2, ...]");
    read_damping(table, law);
  });
  for (const char* const key : {"damping", "damping_ratio"}) {
    if (!is_elastic) {
      table.refuse_value(key, "is for an elastic cable, must be there with stiffness");
    }
  }
  if (!is_elastic) {
    return std::nullopt;
  }
  refuse_second_damping(table);
  const Range with_loss = {"in [1e-40, 1], for no damping takes all speed", 1e-40, 1e-40, 1.0};
  if (const auto share = table.optional_number({"restitution", ""}, with_loss, "")) {
    law.damping_ratio = damping_ratio_of(*share);
  }
  for (const char* const key : {"capture_speed", "restitution_table"}) {
    table.refuse_value(key, "is for an inextensible cable, must be left out with stiffness");
  }
  return law;
}

}  // namespace tautline::bench
