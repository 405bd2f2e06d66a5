#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "bench/chapter/tables/table.hpp"

namespace tautline::bench {

/// A number with its name, or one number for each of the cases that are compared.
struct NamedNumber {
  std::string name;
  std::vector<ChapterCell> values;
};
using NamedNumbers = std::vector<NamedNumber>;

/// The same numbers of several bodies or cases.
struct NumberList {
  std::string name;
  std::vector<NamedNumbers> rows;
};

/// Something that the chapter says and that was checked.
struct Correction {
  bool holds;            // false: it is not so, or not quite
  std::string where;     // "Eq. 5.66", "Section 5.8.1"
  std::string chapter;   // what it says
  std::string right;     // what is right
  std::string shown;     // the computed numbers that show it, in a sentence
  NamedNumbers numbers;  // the same, by name
  NumberList list = {};  // and those of several cases; without a name if there are none
  bool main = false;     // what the chapter missed altogether: told first
};

/// How often something was true.
struct Share {
  std::size_t times;
  std::size_t of;
};

}  // namespace tautline::bench
