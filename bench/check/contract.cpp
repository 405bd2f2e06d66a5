#include "bench/check/contract.hpp"

#include <algorithm>
#include <optional>

#include "bench/base/input_file.hpp"
#include "bench/base/listed.hpp"
#include "bench/base/strict_table.hpp"
#include "bench/base/text.hpp"
#include "bench/base/value.hpp"
#include "bench/check/claims.hpp"

namespace tautline::bench {
namespace {

constexpr std::size_t longest_contract = 1U << 20U;  // [bytes]
constexpr std::size_t most_exceptions = 1000;

/// All that an exception may be of.
std::vector<std::string> contract_claims() {
  std::vector<std::string> names = listed<std::string>(claims(), &Claim::name);
  names.emplace_back(quiet_claim);
  names.emplace_back(accuracy_claim);
  return names;
}

/// "unknown claim x; did you mean y?"
std::string unknown(const std::string& what, const std::string& name,
                    std::span<const std::string> known) {
  const std::string near = suggestion(name, known);
  return "unknown " + what + " " + name +
         (near.empty() ? ", must be " + joined(known, "or") : near);
}

bool contains(std::span<const std::string> names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// One [[exception]] that starts at `line`.
void read_exception(StrictTable& table, std::size_t line, std::span<const std::string> models,
                    std::string_view asked, FileProblems& wrong,
                    std::vector<Exception>& exceptions) {
  const std::string engine =
      table.optional_text({"engine", "the engine that it is of; default all of the folder"})
          .value_or("");
  const std::string model = table.text({"model", "the model that it is of"});
  const std::string reason = table.text({"reason", "why the model does not keep these claims"});
  const bool of_another = !asked.empty() && !engine.empty() && engine != asked;
  if (!of_another && !models.empty() && !contains(models, model)) {
    wrong.add(line, unknown("model", model, models));
  }
  const std::vector<std::string> known = contract_claims();
  const Key key = {"claims", "claims of `tautline check` that the model does not keep"};
  for (const std::string& name : table.texts(key, "must be an array of claims", known)) {
    if (!contains(known, name)) {
      wrong.add(line, unknown("claim", name, known));
    } else if (!of_another) {
      exceptions.push_back({engine, model, name, reason});
    }
  }
  table.refuse_unknown_keys();
}

std::vector<StrictTable> exceptions_in(StrictTable& root) {
  return root.tables({"exception", "what a model of the engine is known not to keep"},
                     most_exceptions, "must be tables with model, claims and reason");
}

}  // namespace

Form contract_form() {
  Form form;
  StrictTable root(form);
  FileProblems wrong("");
  std::vector<Exception> exceptions;
  for (StrictTable& table : exceptions_in(root)) {
    read_exception(table, 0, {}, "", wrong, exceptions);
  }
  return form;
}

Contract read_contract(std::string_view text, const std::string& source_name,
                       std::span<const std::string> models, std::string_view engine) {
  FileProblems wrong(source_name);
  Contract result;
  if (const std::optional<toml::table> file = parse_toml(text, wrong)) {
    StrictTable root(&*file, "", wrong);
    std::size_t index = 0;
    for (StrictTable& table : exceptions_in(root)) {
      const std::size_t line = line_of((*file)["exception"][index++].node());
      read_exception(table, line, models, engine, wrong, result.exceptions);
    }
    root.refuse_unknown_keys();
  }
  result.problems = wrong.sentences();
  return result;
}

Contract contract_beside(const std::filesystem::path& plugin, std::string_view engine,
                         std::span<const std::string> models) {
  const std::filesystem::path path = plugin.parent_path() / "contract.toml";
  if (std::error_code error; !std::filesystem::exists(path, error)) {
    return {};
  }
  const InputFile file = read_input_file(path, longest_contract);
  if (file.problem) {
    return {{}, {path.string() + ": " + *file.problem}};
  }
  return read_contract(file.content, path.string(), models, engine);
}

void mark_known(const Contract& contract, std::string_view model,
                std::vector<SettledClaim>& settled) {
  for (SettledClaim& one : settled) {
    for (const Exception& exception : contract.exceptions) {
      if (exception.model == model && exception.claim == one.claim) {
        one.known = exception.reason;
      }
    }
  }
}

}  // namespace tautline::bench
