#include "bench/cases/catalogue.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "tautline/case_file.hpp"
#include "tautline/scenarios.hpp"
#include "tests/bench/support.hpp"

namespace tautline::bench {
namespace {

namespace fs = std::filesystem;
using test::TemporaryFolder;
using Strings = std::vector<std::string>;

Strings names(const std::vector<Case>& cases) {
  Strings result;
  for (const Case& the_case : cases) {
    result.push_back(the_case.name);
  }
  return result;
}

/// The names selected; an empty list and a failure if something is wrong.
Strings selected(const Strings& arguments) {
  const CaseSelection selection = select_cases(arguments);
  EXPECT_EQ(selection.problems, Strings{});
  return names(selection.cases);
}

std::string named(const std::string& name) {
  Case the_case = bouncing_ball();
  the_case.name = name;
  return write_case(the_case);
}

TEST(CaseSelection, StarIsEveryShippedCaseInTheirOrder) {
  EXPECT_EQ(selected({"*"}), names(shipped_cases()));
}

TEST(CaseSelection, KeepsCatalogueOrderAndTakesEachCaseOnce) {
  EXPECT_EQ(selected({"crane-load", "breakwater/2*", "bouncing-ball", "breakwater/2910121100"}),
            (Strings{"breakwater/2910121100", "breakwater/2911121100", "breakwater/2921121100",
                     "bouncing-ball", "crane-load"}));
}

TEST(CaseSelection, FilesFollowShippedCasesInTheOrderGiven) {
  const TemporaryFolder folder;
  const std::string one = folder.file("one.toml", named("z"));
  const std::string two = folder.file("two", named("a"));
  const std::string one_again = folder.path() / "." / "one.toml";
  EXPECT_EQ(selected({one, two, "bouncing-ball", one_again}), (Strings{"bouncing-ball", "z", "a"}));
}

TEST(CaseSelection, NothingSelectsNothing) { EXPECT_EQ(selected({}), Strings{}); }

TEST(CaseSelection, SaysWhatIsWrongWithEachArgument) {
  const std::string right = ": must be a shipped name, a glob of them or a case file";
  const CaseSelection selection = select_cases(
      Strings{"bouncingball", "1933121100", "qwertz", "zz*", "winch", "", "\x1b", "crane-load"});
  EXPECT_EQ(selection.problems,
            (Strings{"unknown case \"bouncingball\"; did you mean bouncing-ball?",
                     "unknown case \"1933121100\"; did you mean breakwater/1933121100?",
                     "unknown case \"qwertz\"" + right, "no shipped case matches \"zz*\"",
                     "winch is a system; must be a case here: one body, and constants alone",
                     "unknown case \"\"" + right, "unknown case \"\\x1b\"" + right}));
  EXPECT_TRUE(selection.cases.empty());
}

TEST(CaseSelection, PassesOnWhatIsWrongWithAFile) {
  const TemporaryFolder folder;
  const std::string missing = folder.path() / "none.toml";
  EXPECT_EQ(select_cases(Strings{missing}).problems, Strings{missing + ": no such file"});
  EXPECT_EQ(select_cases(Strings{folder.path()}).problems,
            Strings{folder.path().native() + ": is a directory, must be a file"});
}

TEST(CaseSelection, TwoFilesOfOneNameCannotBeToldApart) {
  const TemporaryFolder folder;
  const std::string one = folder.file("one.toml", named("twin"));
  const std::string two = folder.file("two.toml", named("twin"));
  EXPECT_EQ(select_cases(Strings{one, two}).problems,
            Strings{two + ": name = \"twin\" is also the name of " + one +
                    "; two cases of one selection must differ in name"});
}

TEST(CaseSelection, FileMayHaveTheNameOfAShippedCaseThatIsNotSelected) {
  const TemporaryFolder folder;
  const std::string file = folder.file("x.toml", named("crane-load"));
  EXPECT_EQ(selected({file, "bouncing-ball"}), (Strings{"bouncing-ball", "crane-load"}));
  EXPECT_EQ(select_cases(Strings{file, "crane-load"}).problems,
            Strings{file + ": name = \"crane-load\" is also the name of a shipped case; two cases "
                           "of one selection must differ in name"});
}

TEST(FolderName, KeepsEveryShippedName) {
  for (const Case& the_case : shipped_cases()) {
    EXPECT_EQ(folder_name(the_case.name), the_case.name);
  }
}

TEST(FolderName, IsTheSameOnEveryMachine) {
  EXPECT_EQ(folder_name("../../etc"), "_./_./etc-b2d9fe41e2c00c1f");
  EXPECT_EQ(folder_name("/abs"), "abs-3744499cb46df78a");
  EXPECT_EQ(folder_name(""), "case-cbf29ce484222325");  // the hash of nothing is FNV's offset basis
  EXPECT_EQ(folder_name("a b"), "a_b-e63f991904833892");
}

TEST(FolderName, NamesThatLookAlikeHaveDifferentFolders) {
  const Strings alike = {"a b", "a_b", "a\tb", "a/b", "a//b", "/a/b", "a/b/", "a/./b", "a/../b"};
  for (std::size_t i = 0; i < alike.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      EXPECT_NE(folder_name(alike[i]), folder_name(alike[j])) << alike[i] << " and " << alike[j];
    }
  }
  // no name can be the folder of another one
  EXPECT_NE(folder_name(folder_name("a b").native()), folder_name("a b"));
}

RC_GTEST_PROP(FolderName, IsHarmlessWhateverTheNameHolds, ()) {
  const auto piece = rc::gen::oneOf(rc::gen::arbitrary<std::string>(),
                                    rc::gen::element<std::string>("/", "..", ".", "-", "a", "~"));
  std::string name;
  for (const std::string& part : *rc::gen::container<std::vector<std::string>>(piece)) {
    name += part;
  }
  const fs::path folder = folder_name(name);
  RC_ASSERT(!folder.empty());
  RC_ASSERT(folder.is_relative());
  RC_ASSERT(folder.native().size() <= 120U);
  RC_ASSERT(folder.lexically_normal() == folder);
  for (const fs::path& component : folder) {
    const std::string& text = component.native();
    RC_ASSERT(!text.empty());
    RC_ASSERT(text.front() != '.' && text.front() != '-');
    RC_ASSERT(text.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz"
                                     "0123456789._-") == std::string::npos);
  }
}

}  // namespace
}  // namespace tautline::bench
