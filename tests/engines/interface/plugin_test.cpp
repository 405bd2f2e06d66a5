// What the program says of files that are not plug-ins, or not of this version.

#include <gtest/gtest.h>

#include <filesystem>
#include <iostream>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

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

/// Whose choice each setting called `name` of a model of ODE is.
std::vector<Origin> origins_of_ode(const std::string& model, const std::string& name) {
  const std::filesystem::path folder = TAUTLINE_ENGINE_DIR;
  std::vector<Origin> result;
  for (const Model& one : Plugin::open(folder / "tautline-engine-ode.so").engine().info().models) {
    for (const Setting& setting : one.settings) {
      if (one.name == model && setting.name == name) {
        result.push_back(setting.origin);
      }
    }
  }
  return result;
}

TEST(Plugin, SaysWhoseChoiceASettingIs) {
  const auto one = [](Origin origin) { return std::vector{origin}; };
  EXPECT_EQ(origins_of_ode("contact", "bounce_vel"), one(Origin::engine_demo));
  EXPECT_EQ(origins_of_ode("contact-tuned", "bounce_vel"), one(Origin::ours));
  const std::string erp = "dContactSoftERP, soft_erp";
  EXPECT_EQ(origins_of_ode("contact", erp), one(Origin::engine_default));
  EXPECT_EQ(origins_of_ode("row", erp), one(Origin::ours));
}

TEST(Plugin, NamesAFileThatDoesNotExist) {
  const std::string sentence = refusal("/no/such/engine.so");
  EXPECT_EQ(sentence,
            "/no/such/engine.so: no such file; give the path of a plug-in (.so) or of an "
            "engine.toml");
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

constexpr std::string_view here =
    "tautline-engine 5, C++ ABI 1017, std::string ABI 1, Eigen 3.4, alignment 16";

TEST(InterfaceText, TellsWhatToBuildOtherwise) {
  const std::pair<std::string_view, std::string_view> wanted[] = {
      {"tautline-engine 2, C++ ABI 1017, std::string ABI 1, Eigen 3.4, alignment 16",
       "rebuild it against this version's headers"},
      {"tautline-engine 5, C++ ABI 1013, std::string ABI 1, Eigen 3.4, alignment 16",
       "build it with -fabi-version=17"},
      {"tautline-engine 5, C++ ABI 1017, std::string ABI 0, Eigen 3.4, alignment 16",
       "build it with -D_GLIBCXX_USE_CXX11_ABI=1"},
      {"tautline-engine 5, C++ ABI 1002, std::string ABI _GLIBCXX_USE_CXX11_ABI, Eigen 3.4, "
       "alignment 16",
       "build it with -stdlib=libstdc++"},
      {"tautline-engine 5, C++ ABI 1017, std::string ABI 1, Eigen 3.3, alignment 16",
       "build it against Eigen 3.4"},
      {"tautline-engine 5, C++ ABI 1017, std::string ABI 1, Eigen 3.4, alignment 32",
       "add -DEIGEN_MAX_STATIC_ALIGN_BYTES=16"},
      {"what is this", "rebuild it against this version's headers"}};
  for (const auto& [theirs, advice] : wanted) {
    const std::string sentence = misfit(theirs, here);
    EXPECT_NE(sentence.find(advice), std::string::npos) << sentence;
    EXPECT_NE(sentence.find("see engines/protocol"), std::string::npos) << sentence;
  }
}

TEST(InterfaceText, LetsClangAndGccGoTogether) {
  const std::string clang =
      "tautline-engine 5, C++ ABI 1002, std::string ABI 1, Eigen 3.4, alignment 16";
  EXPECT_EQ(misfit(clang, here), "");
  EXPECT_EQ(misfit(here, clang), "");
  EXPECT_EQ(misfit(here, here), "");
  EXPECT_NE(misfit(clang + "0", here), "");
}

}  // namespace
}  // namespace tautline::bench
