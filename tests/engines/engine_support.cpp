#include "engines/engine_support.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "tautline/scenarios.hpp"
#include "tautline/solve.hpp"

namespace tautline::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

bench::RegisteredEngine engine_from_list(const ordered_json& row) {
  bench::RegisteredEngine engine;
  engine.name = row.at("name");
  engine.plugin = row.at("plugin").get<std::string>();
  engine.failure = row.at("failure");
  engine.missing = row.at("missing");
  if (row.contains("models")) {
    engine.info = {row.at("name"), row.at("version"), row.at("precision"), {}};
    for (const ordered_json& model : row.at("models")) {
      engine.info->models.push_back({model.at("name"), model.at("sentence"), {}});
      if (const auto cables = model.find("cables"); cables != model.end()) {
        engine.info->models.back().cables = *cables == "any" ? Cables::any : Cables::elastic;
      }
    }
  }
  return engine;
}

std::vector<ModelUnderTest> models_of_the_build(bool outside) {
  std::vector<ModelUnderTest> result;
  for (const bench::RegisteredEngine& engine : engines_of_the_build()) {
    if (!engine.info || outside != (engine.plugin.extension() != ".so")) {
      continue;
    }
    for (const Model& model : engine.info->models) {
      if (model.cables == Cables::elastic) {
        continue;  // it runs no case of the plane: elastic_test.cpp has its tests
      }
      result.push_back({engine.plugin, engine.name, model.name, engine.info->precision});
    }
  }
  return result;
}

}  // namespace

std::vector<bench::RegisteredEngine> engines_of_the_build() {
  std::ifstream file(TAUTLINE_ENGINE_LIST);
  const auto list = ordered_json::parse(file, nullptr, false);
  if (list.is_discarded()) {
    throw std::runtime_error("the build made no " TAUTLINE_ENGINE_LIST);
  }
  std::vector<bench::RegisteredEngine> engines;
  for (const ordered_json& row : list.at("engines")) {
    engines.push_back(engine_from_list(row));
  }
  return engines;
}

// an engine in a process of its own has tests of its own (npm/), and may be here or not
std::vector<ModelUnderTest> models_under_test() { return models_of_the_build(false); }

std::vector<ModelUnderTest> models_outside() { return models_of_the_build(true); }

std::vector<ModelUnderTest> event_models() {
  std::vector<ModelUnderTest> result = models_under_test();
  std::erase_if(result, [](const ModelUnderTest& model) { return model.model != "event"; });
  return result;
}

void PrintTo(const ModelUnderTest& model, std::ostream* out) {
  *out << model.engine << " " << model.model;
}

std::string test_name(const testing::TestParamInfo<ModelUnderTest>& info) {
  std::string name = info.param.engine + "_" + info.param.model;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

std::optional<bench::Plugin> plugin_of(const std::string& engine) {
  const fs::path file = fs::path(TAUTLINE_ENGINE_DIR) / ("tautline-engine-" + engine + ".so");
  if (!fs::exists(file)) {
    return std::nullopt;
  }
  return bench::Plugin::open(file);
}

double largest_deviation(const Engine& engine, const std::string& model, const Case& the_case,
                         double step, double end) {
  const Solution exact = solve(the_case);
  const auto simulation = engine.start(the_case, model, step);
  double largest = 0.0;
  double reached = 0.0;
  run(*simulation, step, end, [&](const Moment& moment) {
    const State wanted = exact.at(moment.time);
    largest = std::max(largest, (moment.after.position - wanted.position).norm());
    reached = moment.time;
  });
  EXPECT_NEAR(reached, end, step) << "the run stopped early";
  return largest;
}

bool is_finite(const State& state) {
  return state.position.allFinite() && state.velocity.allFinite() && std::isfinite(state.angle) &&
         std::isfinite(state.spin);
}

}  // namespace tautline::test
