#pragma once

#include <string>

namespace tautline::bench {

/// Whether this build can make PNG pictures: it has librsvg.
[[nodiscard]] bool makes_png();

/// The picture `svg` as a PNG file, two pixels for each of its own. Throws std::runtime_error where
/// that fails, and where `makes_png` is false.
[[nodiscard]] std::string png_of(const std::string& svg);

}  // namespace tautline::bench
