// engine.toml: every mistake a sentence, what is not installed greyed out, and nothing started in
// vain.
#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>

#include "bench/run/protocol/engine_file.hpp"
#include "tests/bench/run/protocol_support.hpp"

namespace tautline::test {
namespace {

using nlohmann::json;

/// What is wrong with an engine.toml of this text, without the file's name.
std::vector<std::string> problems_of(const std::string& text) {
  const TemporaryFolder folder;
  const auto path = folder.file("engine.toml", text);
  std::vector<std::string> problems = bench::read_engine_file(path).problems;
  for (std::string& problem : problems) {
    EXPECT_TRUE(problem.starts_with(path.string() + ":")) << problem;
    problem.erase(0, path.string().size());
  }
  return problems;
}

using Sentences = std::vector<std::string>;

TEST(EngineFile, SaysWhatIsWrongWithIt) {
  EXPECT_EQ(problems_of(engine_toml("mine", {"./mine"})), Sentences());
  EXPECT_EQ(problems_of("name = \"My engine\"\ncommand = [\"a\"]\n"),
            Sentences{":1: name = \"My engine\": must be small letters, digits and hyphens"});
  EXPECT_EQ(problems_of("name = \"mine\"\n"),
            Sentences{": command: is missing, must be the words of a command, such as "
                      "[\"node\", \"engine.mjs\"]"});
  EXPECT_EQ(problems_of("name = \"mine\"\ncommand = \"node engine.mjs\"\n").size(), 1U);
  EXPECT_EQ(problems_of("name = \"mine\"\ncommand = [\"node\", 3]\n").size(), 1U);
  EXPECT_EQ(problems_of("name = \"mine\"\ncommand = [\"a\"]\ninstaled = \"node_modules\"\n"),
            Sentences{":3: instaled = \"node_modules\": unknown key; did you mean installed?"});
  EXPECT_EQ(
      problems_of(engine_toml("mine", {"a"}, "installed = \"/usr/lib/x\"\n")),
      Sentences{":3: installed = \"/usr/lib/x\": must be relative to the folder of this file"});
  EXPECT_EQ(problems_of("name = \n").size(), 1U);
}

/// Folders of engines as they are installed: two in a group, one of which is not there, one alone.
class EngineFolder {
 public:
  EngineFolder() {
    const std::string twin = (children_folder / "twin.py").string();
    const std::string marker = (folder_.path() / "was-started").string();
    add("group/twin", engine_toml("twin", {"python3", twin}));
    add("group/absent", engine_toml("absent", {"python3", twin},
                                    "installed = \"node_modules/absent\"\nbring = \"npm ci\"\n"));
    add("no-command", engine_toml("no-command", {"tautline-has-no-such-command"}));
    add("unasked", engine_toml("unasked", {"sh", "-c", "touch " + marker}));
    add("broken", "name = 3\ncommand = 4\n");
  }
  [[nodiscard]] Outcome program(const std::vector<std::string>& arguments) const {
    return test::program(arguments, "TAUTLINE_ENGINE_PATH='" + folder_.path().string() + "'");
  }
  [[nodiscard]] std::filesystem::path path() const { return folder_.path(); }

 private:
  void add(const std::string& name, const std::string& text) const {
    std::filesystem::create_directories(folder_.path() / name);
    static_cast<void>(folder_.file(name + "/engine.toml", text));
  }

  TemporaryFolder folder_;
};

TEST(EngineFolders, AreListedWithWhatIsMissing) {
  if (!has_python()) {
    GTEST_SKIP() << no_python;
  }
  const EngineFolder folder;
  const json list = json::parse(folder.program({"engines", "--json", "-"}).output);
  std::map<std::string, json> engines;
  for (const json& engine : list.at("engines")) {
    engines[engine.at("name")] = engine;
  }
  EXPECT_EQ(engines.at("twin").at("models").size(), 2U);
  EXPECT_EQ(engines.at("absent").at("missing"),
            "node_modules/absent is not installed; run npm ci in " +
                (folder.path() / "group/absent").string());
  EXPECT_EQ(engines.at("no-command").at("missing"), "tautline-has-no-such-command is not on PATH");
  EXPECT_NE(engines.at("broken").at("failure").get<std::string>().find("engine.toml:1: name = 3"),
            std::string::npos);
}

TEST(EngineFolders, StandForTheEnginesInThem) {
  if (!has_python()) {
    GTEST_SKIP() << no_python;
  }
  const EngineFolder folder;
  const TemporaryFolder out;
  const Outcome outcome = folder.program({"bench", "bouncing-ball", "--engines", "group", "--steps",
                                          "1e-2", "--out", (out.path() / "r").string()});
  EXPECT_EQ(outcome.code, 0) << outcome.errors;
  const json report = json::parse(content_of(out.path() / "r/report.json"));
  EXPECT_EQ(report.at("runs").size(), 2U);
  ASSERT_EQ(report.at("engines").size(), 2U);
  EXPECT_EQ(report.at("engines").at(0).at("name"), "absent");
  EXPECT_NE(report.at("engines").at(0).at("problem").get<std::string>().find("is not installed"),
            std::string::npos);
}

TEST(EngineFolders, AreNoPartOfABareBenchAndAreNotStartedForIt) {
  const EngineFolder folder;
  const TemporaryFolder out;
  const Outcome outcome = folder.program({"bench", "bouncing-ball", "--engines", bad_engine("twin"),
                                          "--steps", "1e-2", "--out", (out.path() / "r").string()});
  EXPECT_EQ(outcome.code, 0) << outcome.errors;
  const Outcome bare = folder.program(
      {"bench", "bouncing-ball", "--steps", "1e-2", "--out", (out.path() / "bare").string()});
  EXPECT_EQ(content_of(out.path() / "bare/report.json").find("\"twin\""), std::string::npos)
      << bare.errors;
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "was-started"));
}

TEST(EngineFile, WhoseCommandCannotBeStartedIsOneSentence) {
  const TemporaryFolder folder;
  const auto script = folder.file("script", "#!/no/such/interpreter\n");
  std::filesystem::permissions(script, std::filesystem::perms::owner_all);
  const auto file = folder.file("engine.toml", engine_toml("mine", {"./script"}));
  const Outcome outcome = program({"check", file.string()});
  EXPECT_EQ(outcome.code, 1);
  EXPECT_EQ(outcome.errors,
            "tautline: engine mine: the engine could not be started (./script: No such file or "
            "directory) before it answered info\n");
}

TEST(EngineFile, LeadsToAllFilesThatDecideWhatTheEngineDoes) {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder.path() / "mine");
  std::filesystem::create_directories(folder.path() / "common/sub");
  const auto file =
      folder.file("mine/engine.toml", engine_toml("mine", {"python3", "engine.py"}) +
                                          "lock = \"lock.txt\"\nshares = [\"../common\"]\n");
  for (const char* name :
       {"mine/engine.py", "mine/lock.txt", "mine/notes.txt", "common/step.py", "common/sub/x.py"}) {
    static_cast<void>(folder.file(name, ""));
  }
  std::vector<std::string> found;
  for (const std::filesystem::path& one : bench::named_files(file)) {
    found.push_back(one.lexically_normal().lexically_relative(folder.path()).string());
  }
  EXPECT_EQ(found, std::vector<std::string>(
                       {"common/step.py", "mine/engine.py", "mine/engine.toml", "mine/lock.txt"}));
}

TEST(EngineFolders, SayWhyAnEngineThatIsNamedIsNotHere) {
  const EngineFolder folder;
  for (const std::string& name : {std::string("absent"), std::string("no-command"),
                                  (folder.path() / "no-command/engine.toml").string()}) {
    const Outcome outcome = folder.program(
        {"run", "bouncing-ball", "--engine", name, "--model", "row", "--step", "1e-2"});
    EXPECT_EQ(outcome.code, 2) << name;
    EXPECT_NE(outcome.errors.find(" is not here: "), std::string::npos) << outcome.errors;
  }
  const Outcome broken = folder.program({"check", (folder.path() / "broken/engine.toml").string()});
  EXPECT_EQ(broken.code, 2) << broken.errors;
  for (const char* const line : {"engine.toml:1: name = 3", "engine.toml:2: command = 4"}) {
    EXPECT_NE(broken.errors.find(line), std::string::npos) << broken.errors;
  }
}

}  // namespace
}  // namespace tautline::test
