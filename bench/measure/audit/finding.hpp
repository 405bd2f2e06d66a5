#pragma once

#include <cstddef>
#include <optional>
#include <string>

namespace tautline::bench {

/// What a model does to impacts, found from its runs.
struct Finding {
  std::string engine;
  std::string model;
  std::string kind;             // "threshold", "sleeping", ...: bench/report/report.schema.json
  std::string sentence;         //
  std::optional<double> value;  // in `unit`
  std::string unit;             // "" for a ratio
  std::size_t runs = 0;         // that it is drawn from
  std::size_t impacts = 0;      // of these; 0 where it is not drawn from impacts
};

}  // namespace tautline::bench
