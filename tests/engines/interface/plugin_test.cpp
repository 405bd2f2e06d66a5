// What the program says of files that are not plug-ins, or not of this version.

#include <gtest/gtest.h>

#include <filesystem>
#include <iostream>
#include <type_traits>

#include "bench/run/plugin.hpp"
#include "tautline/plugin.hpp"

namespace tautline::bench {
namespace {

static_assert(!std::is_copy_constructible_v<Plugin> && std::is_move_constructible_v<Plugin>);

/// The sentence `file` is refused with.
std::string refusal(const std::filesystem::path& file) {
  try {
    const Plugin plugin = Plugin::open(file);
    return "accepted: " + plugin.engine().info().name;
  } catch (const PluginError& error) {
    std::cout << "  " << error.what() << '\n';
    return error.what();
  }
}

TEST(Plugin, OpensAModuleOfThisVersion) {
  const std::filesystem::path folder = TAUTLINE_ENGINE_DIR;
  Plugin plugin = Plugin::open(folder / "tautline-engine-exact.so");
  EXPECT_EQ(plugin.engine().info().name, "exact");
  const Plugin moved = std::move(plugin);
  EXPECT_EQ(moved.engine().info().name, "exact");
}

TEST(Plugin, NamesAFileThatDoesNotExist) {
  const std::string sentence = refusal("/no/such/engine.so");
  EXPECT_EQ(sentence, "/no/such/engine.so: no such file; give the path of a plug-in (.so)");
}

TEST(Plugin, NamesAFileThatIsNotASharedLibrary) {
  const std::string sentence = refusal(TAUTLINE_TEST_DATA "/README.md");
  EXPECT_NE(sentence.find(TAUTLINE_TEST_DATA), std::string::npos) << sentence;
  EXPECT_NE(sentence.find("not a shared library"), std::string::npos) << sentence;
  EXPECT_NE(sentence.find("ELF"), std::string::npos) << "the loader's own reason: " << sentence;
}

TEST(Plugin, NamesALibraryThatIsNotAPlugin) {
  const std::string sentence = refusal(TAUTLINE_STRANGER);
  EXPECT_NE(sentence.find("not a tautline plug-in"), std::string::npos) << sentence;
  EXPECT_NE(sentence.find("tautline_plugin_interface"), std::string::npos) << sentence;
}

TEST(Plugin, RefusesAnotherInterfaceBeforeCallingIntoIt) {
  const std::string sentence = refusal(TAUTLINE_OUTDATED);  // its create function aborts
  EXPECT_NE(sentence.find("tautline-engine 0, C++ ABI 1"), std::string::npos) << sentence;
  EXPECT_NE(sentence.find(TAUTLINE_INTERFACE), std::string::npos) << sentence;
  EXPECT_NE(sentence.find("rebuild it against this version's headers"), std::string::npos)
      << sentence;
}

}  // namespace
}  // namespace tautline::bench
