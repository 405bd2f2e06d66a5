#include "bench/run/versions/version_request.hpp"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <string_view>
#include <tuple>

#include "bench/base/text.hpp"

namespace tautline::bench {
namespace {

/// Major, minor and patch, and what is after a hyphen: without it a version is the newer one.
struct VersionParts {
  std::array<unsigned long, 3> numbers{};
  std::string_view pre;
};

VersionParts parts_of(std::string_view version) {
  VersionParts parts;
  const char* at = version.data();
  const char* const end = at + version.size();
  for (unsigned long& number : parts.numbers) {
    at = std::from_chars(at, end, number).ptr;
    if (at == end || *at != '.') {
      break;
    }
    ++at;
  }
  const std::string_view rest(at, static_cast<std::size_t>(end - at));
  parts.pre = rest.starts_with('-') ? rest.substr(1) : std::string_view();
  return parts;
}

/// What npm reads for `FROM..TO`; either may be missing.
std::string npm_range(const std::string& range) {
  const std::size_t dots = range.find("..");
  if (dots == std::string::npos) {
    return range;
  }
  const std::string from = range.substr(0, dots);
  const std::string to = range.substr(dots + 2);
  return (from.empty() ? "" : ">=" + from) + (from.empty() || to.empty() ? "" : " ") +
         (to.empty() ? "" : "<=" + to);
}

}  // namespace

VersionRequest version_request(const std::string& text) {
  const std::size_t at = text.rfind('@');
  VersionRequest request;
  request.engine = text.substr(0, at);
  if (at != std::string::npos) {
    request.range = npm_range(text.substr(at + 1));
  }
  if (request.engine.empty() || (at != std::string::npos && request.range.empty())) {
    request.problem = fmt::format("{}: must be an engine and its versions, such as planck@1.0..1.4",
                                  printable(text));
  }
  return request;
}

bool is_older(const std::string& one, const std::string& other) {
  const VersionParts left = parts_of(one);
  const VersionParts right = parts_of(other);
  return std::tuple(left.numbers, left.pre.empty(), left.pre) <
         std::tuple(right.numbers, right.pre.empty(), right.pre);
}

std::vector<std::string> newest_of_each_minor(const std::vector<std::string>& versions) {
  std::vector<std::string> newest;  // in rising order, as `versions`
  for (const std::string& version : versions) {
    const auto same_minor = [&](const std::string& other) {
      const auto one = parts_of(version).numbers;
      const auto two = parts_of(other).numbers;
      return one[0] == two[0] && one[1] == two[1];
    };
    if (!newest.empty() && same_minor(newest.back())) {
      newest.back() = version;
    } else {
      newest.push_back(version);
    }
  }
  return newest;
}

}  // namespace tautline::bench
