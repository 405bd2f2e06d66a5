#include "tests/bench/program.hpp"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <nlohmann/json.hpp>

namespace tautline::test {
namespace {

int code_of(int status) {
  return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
}

std::string quoted(const std::string& word) {
  std::string result = "'";
  for (const char letter : word) {
    result += letter == '\'' ? std::string("'\\''") : std::string(1, letter);
  }
  return result + "'";
}

}  // namespace

Outcome program(const std::vector<std::string>& arguments, const std::string& shell) {
  const TemporaryFolder folder;
  // the width of whoever runs the tests is not that of the program
  std::string command = "unset COLUMNS; " + shell + " " + quoted(TAUTLINE_PROGRAM_PATH);
  for (const std::string& argument : arguments) {
    command += " " + quoted(argument);
  }
  command += " >" + quoted((folder.path() / "out").string());
  command += " 2>" + quoted((folder.path() / "err").string()) + " </dev/null";
  const int status = std::system(command.c_str());  // NOLINT(cert-env33-c): a shell is wanted here
  return {code_of(status), content_of(folder.path() / "out"), content_of(folder.path() / "err")};
}

int start_program(const std::vector<std::string>& arguments) {
  const pid_t child = ::fork();
  if (child != 0) {
    return child;
  }
  const int nowhere = ::open("/dev/null", O_RDWR | O_CLOEXEC);
  ::dup2(nowhere, 0);
  ::dup2(nowhere, 1);
  ::dup2(nowhere, 2);
  std::vector<std::string> words = {TAUTLINE_PROGRAM_PATH};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> raw;
  raw.reserve(words.size() + 1);
  for (std::string& word : words) {
    raw.push_back(word.data());
  }
  raw.push_back(nullptr);
  ::execv(raw.front(), raw.data());
  ::_exit(127);
}

int wait_for(int process) {
  int status = 0;
  ::waitpid(process, &status, 0);
  return code_of(status);
}

std::set<std::string> built_engines() {
  const auto list = nlohmann::json::parse(program({"engines", "--json", "-"}).output);
  std::set<std::string> result;
  for (const auto& engine : list["engines"]) {
    if (engine.contains("models")) {
      result.insert(engine["name"].get<std::string>());
    }
  }
  return result;
}

std::string bad_engine(const std::string& way) {
  return std::string(TAUTLINE_FIXTURE_DIR) + "/tautline-engine-" + way + ".so";
}

}  // namespace tautline::test
