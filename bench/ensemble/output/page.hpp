#pragma once

#include <string>

#include "bench/ensemble/output/words.hpp"
#include "bench/page/page_assets.hpp"

namespace tautline::bench {

/// One page that needs no other file but the pictures of an atlas' cells: what differs, each
/// distribution over the others, and the atlas. `command` made it.
[[nodiscard]] std::string ensemble_html(const EnsembleReport& report, const std::string& command,
                                        const PageAssets& assets);

}  // namespace tautline::bench
