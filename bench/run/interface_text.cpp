#include "bench/run/interface_text.hpp"

#include <fmt/format.h>

#include <array>
#include <cstddef>
#include <optional>

namespace tautline::bench {
namespace {

/// The parts of an interface text: each is a name and what stands behind it.
constexpr std::array part_names = {"tautline-engine ", "C++ ABI ", "std::string ABI ", "Eigen ",
                                   "alignment "};
enum TextPart : std::size_t { version, compiler, strings, eigen, alignment };
using TextParts = std::array<std::string, part_names.size()>;

/// None where `text` is not made of them.
std::optional<TextParts> text_parts_of(std::string_view text) {
  TextParts parts;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    if (!text.starts_with(part_names[k])) {
      return std::nullopt;
    }
    text.remove_prefix(std::string_view(part_names[k]).size());
    const std::size_t end = k + 1 < parts.size() ? text.find(", ") : text.size();
    if (end == std::string_view::npos) {
      return std::nullopt;
    }
    parts[k] = text.substr(0, end);
    text.remove_prefix(end == text.size() ? end : end + 2);
  }
  return parts;
}

/// Clang says so whatever its version. It lays out what the interface holds as GCC does.
constexpr std::string_view abi_of_clang = "1002";

/// GCC's number is 1000 more than that of its option.
std::string abi_option(const std::string& abi) {
  return abi.size() == 4 && abi.front() == '1'
             ? fmt::format("-fabi-version={}", std::stoi(abi.substr(1)))
             : "the same -fabi-version";
}

std::string build_advice(const TextParts& theirs, const TextParts& ours) {
  if (theirs[version] != ours[version]) {
    return "rebuild it against this version's headers";
  }
  const bool by_clang = theirs[compiler] == abi_of_clang || ours[compiler] == abi_of_clang;
  if (theirs[compiler] != ours[compiler] && !by_clang) {
    return fmt::format("another version of GCC lays out classes otherwise; build it with {}",
                       abi_option(ours[compiler]));
  }
  if (theirs[strings] != ours[strings]) {
    return theirs[strings] == "0" || theirs[strings] == "1"
               ? fmt::format(
                     "its std::string is another; build it with -D_GLIBCXX_USE_CXX11_ABI={}",
                     ours[strings])
               : "its standard library is another; build it with -stdlib=libstdc++";
  }
  if (theirs[eigen] != ours[eigen]) {
    return fmt::format("build it against Eigen {}", ours[eigen]);
  }
  if (theirs[alignment] != ours[alignment]) {
    return fmt::format(
        "vector flags such as -mavx or -march=native change how Eigen aligns; keep them, and add "
        "-DEIGEN_MAX_STATIC_ALIGN_BYTES={}",
        ours[alignment]);
  }
  return "";
}

}  // namespace

std::string misfit(std::string_view theirs, std::string_view ours) {
  if (theirs == ours) {
    return "";
  }
  const auto of_theirs = text_parts_of(theirs);
  const auto of_ours = text_parts_of(ours);
  const std::string way = of_theirs && of_ours ? build_advice(*of_theirs, *of_ours)
                                               : "rebuild it against this version's headers";
  if (way.empty()) {
    return "";
  }
  return fmt::format(
      "built against another interface (\"{}\", here it is \"{}\"): {}. An engine in a process of "
      "its own needs none of this: see engines/protocol",
      theirs, ours, way);
}

}  // namespace tautline::bench
