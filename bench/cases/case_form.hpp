#pragma once

#include "bench/base/form.hpp"

namespace tautline::bench {

/// The keys of a case file, as TOML and as JSON.
[[nodiscard]] Form case_form();

}  // namespace tautline::bench
