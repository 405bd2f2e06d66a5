#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "bench/base/strict_table.hpp"
#include "tautline/system.hpp"

namespace tautline::bench {

/// All that the tables of a case file say of a case or of a system.
template <class TheCase>
struct CaseTables {
  TheCase the_case;
  CableSet taut = {};  // cables that start taut
};

/// The place in a file of the first key that a system alone has, such as "cables[0].from".
struct SystemKey {
  std::string name;
  std::size_t line;
};

/// None where the file is a case: one [body], and constants alone.
[[nodiscard]] std::optional<SystemKey> system_key(const toml::table& file);

/// True where gravity has three numbers, and not all points have two: then it is mistyped.
[[nodiscard]] bool is_in_space(const toml::table& file);

/// By which the cables of a file name body `index` of `bodies`, whose own name is `name`.
[[nodiscard]] std::string name_in_file(const std::string& name, std::size_t index,
                                       std::size_t bodies);

/// Reads the tables of a file that is a case. Who reads cases alone links no reader of systems.
[[nodiscard]] CaseTables<Case> read_case_tables(StrictTable root);

/// Reads the tables of any other file, a `System` or a `SpatialSystem`.
template <class TheSystem>
[[nodiscard]] TheSystem read_system_tables(StrictTable root);

}  // namespace tautline::bench
