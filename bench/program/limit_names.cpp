#include "bench/program/limit_names.hpp"

#include <algorithm>
#include <utility>

#include "bench/base/listed.hpp"
#include "tautline/scenarios.hpp"

namespace tautline::bench {
namespace {

LimitNames::Engine names_of(const RegisteredEngine& engine) {
  LimitNames::Engine names{engine.name, std::nullopt};
  if (engine.info) {
    names.models = listed(engine.info->models, &Model::name);
  }
  return names;
}

}  // namespace

LimitNames limit_names(const std::vector<RegisteredEngine>& given, const std::vector<Case>& cases) {
  std::vector<RegisteredEngine> engines = given;
  for (RegisteredEngine& engine : registered_engines(Asked::plugins)) {
    const bool is_given = std::any_of(given.begin(), given.end(), [&](const auto& one) {
      return one.name == engine.name;  // one of the user's own may stand for it
    });
    if (!is_given) {
      engines.push_back(std::move(engine));
    }
  }
  LimitNames names;
  names.engines = listed(engines, names_of);
  for (const std::vector<Case>& some : {shipped_cases(), cases}) {
    for (const Case& the_case : some) {
      names.cases.push_back(the_case.name);
    }
  }
  return names;
}

}  // namespace tautline::bench
