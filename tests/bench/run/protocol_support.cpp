#include "tests/bench/run/protocol_support.hpp"

#include <cctype>
#include <fstream>
#include <iterator>
#include <system_error>
#include <thread>

namespace tautline::test {
namespace {

namespace fs = std::filesystem;

std::string toml_quoted(const std::string& word) { return "\"" + word + "\""; }

std::string written(const TemporaryFolder& folder, const std::string& name,
                    const std::string& text) {
  fs::create_directories(folder.path() / name);
  return folder.file(name + "/engine.toml", text).string();
}

}  // namespace

std::string engine_toml(const std::string& name, const std::vector<std::string>& command,
                        const std::string& more) {
  std::string words;
  for (const std::string& word : command) {
    words += (words.empty() ? "" : ", ") + toml_quoted(word);
  }
  return "name = " + toml_quoted(name) + "\ncommand = [" + words + "]\n" + more;
}

std::string bad_child(const TemporaryFolder& folder, const std::string& way) {
  return written(folder, way,
                 engine_toml(way, {"python3", (children_folder / "bad.py").string(), way}));
}

std::string space_child(const TemporaryFolder& folder, const std::string& way) {
  return written(folder, way,
                 engine_toml(way, {"python3", (children_folder / "ball.py").string(), way}));
}

std::string sound_child(const TemporaryFolder& folder) {
  return written(folder, "twin",
                 engine_toml("twin", {"python3", (children_folder / "twin.py").string()}));
}

std::vector<int> marked_processes(const std::string& mark) {
  std::vector<int> found;
  std::error_code error;
  const std::string entry = "TAUTLINE_MARK=" + mark;
  for (const auto& process : fs::directory_iterator("/proc", error)) {
    const std::string name = process.path().filename().string();
    if (std::isdigit(static_cast<unsigned char>(name.front())) == 0) {
      continue;
    }
    std::ifstream file(process.path() / "environ", std::ios::binary);
    const std::string environment(std::istreambuf_iterator<char>(file), {});
    if (environment.find(entry) != std::string::npos) {
      found.push_back(std::stoi(name));
    }
  }
  return found;
}

std::vector<int> left_of(const std::string& mark) {
  using Clock = std::chrono::steady_clock;
  constexpr auto patience = std::chrono::seconds(60);
  const auto deadline = Clock::now() + patience;
  while (Clock::now() < deadline && !marked_processes(mark).empty()) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return marked_processes(mark);
}

}  // namespace tautline::test
