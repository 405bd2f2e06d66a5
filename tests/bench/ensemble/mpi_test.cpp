// `tautline ensemble` under mpirun: the same results from any number of processes.

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "tests/bench/program.hpp"

namespace tautline::test {
namespace {

namespace fs = std::filesystem;

/// Processes on this machine, which talk by shared memory and the loopback device, more than there
/// may be cores.
std::string together(int ranks) {
  return "OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMPI_MCA_plm=isolated "
         "OMPI_MCA_btl=self,vader OMPI_MCA_pml=ob1 OMPI_MCA_oob_tcp_if_include=lo "
         "OMPI_MCA_rmaps_base_oversubscribe=1 '" TAUTLINE_MPIRUN "' -n " +
         std::to_string(ranks);
}

const char* const of_a_case =
    "case = \"breakwater/1510121100\"\nuntil = 5\n"
    "[[vary]]\nquantities = [\"x\", \"y\", \"spin\"]\nnormal = 1e-3\n"
    "[[exact]]\nname = \"sequential\"\nlaw = \"sequential\"\n";
const char* const of_a_system_in_space =
    "case = \"tethered-ball\"\nuntil = 2\n"
    "[[vary]]\nquantities = [\"x\", \"rotation_z\", \"spin_y\"]\nnormal = 1e-3\n";

/// A spec in a folder of its own, beside the results.
class Spec {
 public:
  explicit Spec(const std::string& text = of_a_case) : file_(folder_.file("spec.toml", text)) {}
  [[nodiscard]] Outcome run(const std::string& shell, const fs::path& out,
                            const std::vector<std::string>& more = {}) const {
    std::vector<std::string> words = {"ensemble", file_.string(), "--out",  out.string(),
                                      "--count",  "1500",         "--jobs", "1"};
    words.insert(words.end(), more.begin(), more.end());
    return program(words, shell);
  }
  [[nodiscard]] fs::path out(const std::string& name) const { return folder_.path() / name; }

 private:
  TemporaryFolder folder_;
  fs::path file_;
};

TEST(EnsembleOfProcesses, FindsTheSameInAnyNumberOfThem) {
  const Spec spec;
  EXPECT_EQ(spec.run("", spec.out("alone")).code, 0);
  const std::string alone = content_of(spec.out("alone") / "ensemble.json");
  for (const int ranks : {1, 2, 4}) {
    const fs::path out = spec.out(std::to_string(ranks));
    const Outcome outcome = spec.run(together(ranks), out);
    EXPECT_EQ(outcome.code, 0) << outcome.errors;
    EXPECT_EQ(content_of(out / "ensemble.json"), alone) << ranks << " processes";
    EXPECT_EQ(content_of(out / "index.html"), content_of(spec.out("alone") / "index.html"))
        << ranks << " processes";
    EXPECT_NE(outcome.output.find("index.html, with"), std::string::npos);
    EXPECT_EQ(outcome.output.find("index.html, with"), outcome.output.rfind("index.html, with"))
        << "one of them speaks";
  }
}

TEST(EnsembleOfProcesses, FindsTheSameOfASystemInSpace) {
  const Spec spec(of_a_system_in_space);
  EXPECT_EQ(spec.run("", spec.out("alone")).code, 0);
  const Outcome outcome = spec.run(together(2), spec.out("two"));
  EXPECT_EQ(outcome.code, 0) << outcome.errors;
  for (const char* const file : {"ensemble.json", "index.html", "draws/exact/00000200.csv"}) {
    EXPECT_EQ(content_of(spec.out("two") / file), content_of(spec.out("alone") / file)) << file;
  }
}

TEST(EnsembleOfProcesses, ARankThatIsKilledCostsItsDrawsAlone) {
  const Spec spec;
  EXPECT_EQ(spec.run("", spec.out("alone")).code, 0);
  const fs::path out = spec.out("killed");
  const fs::path first = out / "draws/exact/00000000.csv";
  // the second kills itself once draws are kept
  const Outcome killed = spec.run(
      together(2) + " sh -c 'if [ \"${OMPI_COMM_WORLD_RANK:-$PMI_RANK}\" = 1 ]; then (until [ -e " +
          first.string() + " ]; do sleep 0.01; done; kill -9 $$) & fi; exec \"$@\"' sh",
      out);
  EXPECT_NE(killed.code, 0);
  ASSERT_FALSE(fs::exists(out / "ensemble.json")) << "it was killed too late to show anything";
  const std::string kept = content_of(first);
  ASSERT_FALSE(kept.empty());
  const Outcome resumed = spec.run(together(2), out, {"--resume"});
  EXPECT_EQ(resumed.code, 0) << resumed.errors;
  EXPECT_EQ(content_of(first), kept);
  EXPECT_EQ(content_of(out / "ensemble.json"), content_of(spec.out("alone") / "ensemble.json"));
}

TEST(EnsembleOfProcesses, OneOfThemSaysWhatIsWrong) {
  const Spec spec;
  const Outcome usage = spec.run(together(2), spec.out("wrong"), {"--time-limit", "0"});
  EXPECT_EQ(usage.code, 2);
  const std::size_t said = usage.errors.find("tautline: --time-limit 0");
  EXPECT_NE(said, std::string::npos) << usage.errors;
  EXPECT_EQ(said, usage.errors.rfind("tautline: --time-limit 0"));
  const Outcome folder = spec.run(together(2), "/dev/null/x");
  EXPECT_EQ(folder.code, 1);
  EXPECT_NE(folder.errors.find("/dev/null/x"), std::string::npos) << folder.errors;
}

}  // namespace
}  // namespace tautline::test
