#pragma once

#include "bench/report/report.hpp"

namespace tautline::bench {

/// True where both ask the same of their runs, up to the rounding of another compiler; a case of a
/// suite may be changed and keep its name.
[[nodiscard]] bool same_case(const CaseRow& one, const CaseRow& two);

}  // namespace tautline::bench
