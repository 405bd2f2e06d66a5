#include <optional>

#include "bench/cases/literals.hpp"
#include "bench/check/contract.hpp"
#include "bench/ensemble/spec_file.hpp"
#include "bench/gate/listed_problems.hpp"
#include "fuzz/targets.hpp"
#include "tautline/case_file.hpp"

namespace tautline::fuzz {
namespace {

template <class TheSystem>
void require_same(const std::optional<TheSystem>& read,
                  std::optional<TheSystem> SystemReading::*kind) {
  if (read) {
    require(problems(*read).empty(), "a system that is read can be solved");
    const std::string written = write_system(*read);
    const SystemReading again = read_system_text(written, "written.toml");
    require((again.*kind).has_value(), "what is written reads back:\n" + written);
    require(write_system(*(again.*kind)) == written, "it reads back bit by bit:\n" + written);
  }
}

void read_as_system(std::string_view text) {
  const SystemReading reading = read_system_text(text, "input.toml");
  require_sentences(reading.problems, !reading.system && !reading.in_space);
  require_same(reading.system, &SystemReading::system);
  require_same(reading.in_space, &SystemReading::in_space);
}

void read_as_case(std::string_view text) {
  const CaseReading reading = read_case_text(text, "input.toml");
  require_sentences(reading.problems, !reading.the_case);
  static_cast<void>(bench::literals(text));
  if (reading.the_case) {
    require(problems(*reading.the_case).empty(), "a case that is read can be solved");
    const std::string written = write_case(*reading.the_case);
    const CaseReading again = read_case_text(written, "written.toml");
    require(again.the_case.has_value(), "what is written reads back:\n" + written);
    // the writer gives every double its shortest text: equal texts are equal bits
    require(write_case(*again.the_case) == written, "it reads back bit by bit:\n" + written);
  }
}

void read_as_spec(std::string_view text) {
  const bench::SpecReading reading = bench::read_spec_text(text, "input.toml");
  require_sentences(reading.problems, !reading.spec);
  if (reading.spec) {
    const std::size_t draws = bench::draw_count(*reading.spec);
    require(draws > 0 && draws <= bench::most_draws, "the number of draws has its range");
    require(bench::problems(reading.spec->the_case).empty(), "the case of a spec can be solved");
  }
}

void read_as_problems(std::string_view text) {
  const bench::ProblemsReading reading = bench::read_problems_text(text, "input.toml");
  require_sentences(reading.problems, !reading.listed);
}

void read_as_contract(std::string_view text) {
  const bench::Contract contract = bench::read_contract(text, "input.toml", {});
  require_sentences(contract.problems, !contract.problems.empty());
}

}  // namespace

void fuzz_files(std::string_view input) {
  if (input.size() <= longest_case_file) {  // a longer file is not read
    read_as_system(input);
    read_as_case(input);
    read_as_spec(input);
    read_as_problems(input);
    read_as_contract(input);
  }
}

}  // namespace tautline::fuzz
