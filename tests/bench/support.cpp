#include "tests/bench/support.hpp"

#include <stdlib.h>  // mkdtemp is POSIX, not in <cstdlib>

#include <algorithm>
#include <bit>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "bench/base/value.hpp"

namespace tautline::bench::test {

namespace fs = std::filesystem;

namespace {

nlohmann::json as_json(const toml::node& node) {
  if (const toml::table* const table = node.as_table()) {
    nlohmann::json object = nlohmann::json::object();
    for (const auto& [key, value] : *table) {
      object[std::string(key.str())] = as_json(value);
    }
    return object;
  }
  if (const toml::array* const array = node.as_array()) {
    nlohmann::json list = nlohmann::json::array();
    for (const toml::node& value : *array) {
      list.push_back(as_json(value));
    }
    return list;
  }
  if (const auto* const text = node.as_string()) {
    return text->get();
  }
  if (const auto* const number = node.as_integer()) {
    return number->get();
  }
  if (const auto* const number = node.as_floating_point()) {
    const double value = number->get();
    const bool whole = std::abs(value) <= 0x1p53 && value == std::floor(value);
    // for JSON 2.0 is the integer 2, but valijson asks how it is stored
    return whole ? nlohmann::json(static_cast<std::int64_t>(value)) : nlohmann::json(value);
  }
  if (const auto* const flag = node.as_boolean()) {
    return flag->get();
  }
  return "a date or time";
}

}  // namespace

TemporaryFolder::TemporaryFolder() {
  std::string pattern = fs::temp_directory_path() / "tautline-test-XXXXXX";
  if (::mkdtemp(pattern.data()) == nullptr) {
    throw std::runtime_error("no temporary folder " + pattern);
  }
  path_ = pattern;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

fs::path TemporaryFolder::file(const std::string& name, std::string_view content) const {
  std::ofstream stream(path_ / name, std::ios::binary);
  stream << content;
  return path_ / name;
}

std::vector<std::uint64_t> bits(const Case& the_case) {
  std::vector<std::uint64_t> result;
  const auto add = [&result](auto... values) {
    (result.push_back(std::bit_cast<std::uint64_t>(values)), ...);
  };
  const auto add_pair = [&add](const Vec2& value) { add(value.x(), value.y()); };
  const State& initial = the_case.initial;
  add(the_case.body.mass, the_case.body.inertia, the_case.duration, initial.angle, initial.spin);
  add_pair(the_case.gravity);
  add_pair(initial.position);
  add_pair(initial.velocity);
  for (const std::optional<double>& limit : {the_case.angle_limit, the_case.ceiling}) {
    result.push_back(limit.has_value() ? 1 : 0);
    add(limit.value_or(0.0));
  }
  for (const Cable& cable : the_case.cables) {
    add_pair(cable.anchor);
    add_pair(cable.attachment);
    add(cable.length, cable.restitution, cable.capture_speed);
    result.push_back(cable.restitution_table.size());
    for (const RestitutionPoint& point : cable.restitution_table) {
      add(point.speed, point.restitution);
    }
  }
  return result;
}

std::vector<std::string> names_in(const fs::path& folder) {
  std::vector<std::string> result;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    result.push_back(entry.path().filename());
  }
  std::sort(result.begin(), result.end());
  return result;
}

std::string content_of(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  std::ostringstream content;
  content << stream.rdbuf();
  return std::move(content).str();
}

nlohmann::json file_as_json(std::string_view text) {
  FileProblems wrong("");
  const auto file = parse_toml(text, wrong);
  return file ? as_json(*file) : nlohmann::json();
}

}  // namespace tautline::bench::test
