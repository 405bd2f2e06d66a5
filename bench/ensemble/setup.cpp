#include "bench/ensemble/setup.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "bench/base/text.hpp"
#include "bench/ensemble/draw.hpp"

namespace tautline::bench {

std::vector<EnsembleSetup> setups_of(const EnsembleSpec& spec,
                                     const std::vector<RegisteredEngine>& engines) {
  const ExactVariant first{"exact", spec.law, std::nullopt, "", 1.0, spec.completion};
  std::vector<EnsembleSetup> result = {{first.name, first, std::nullopt, "", 0.0}};
  for (const ExactVariant& variant : spec.exact) {
    result.push_back({variant.name, variant, std::nullopt, "", 0.0});
  }
  for (std::size_t place = 0; place < engines.size(); ++place) {
    for (const Model& model : engines[place].info->models) {
      const auto& wanted = spec.models;
      // engines run ensembles of one body in the plane, whose cables are inextensible
      if (wanted.empty() ? model.cables == Cables::elastic
                         : std::find(wanted.begin(), wanted.end(), model.name) == wanted.end()) {
        continue;
      }
      for (const double step : spec.steps) {
        result.push_back({engines[place].name + " " + model.name + " " + shortest(step), first,
                          place, model.name, step});
      }
    }
  }
  return result;
}

SolveOptions options_of(const EnsembleSetup& setup) {
  SolveOptions options;
  options.law = setup.exact.law;
  options.completion.error = setup.exact.completion;
  return options;
}

AnyCase case_of(const EnsembleSpec& spec, const EnsembleSetup& setup, std::size_t index) {
  AnyCase the_case = case_of(spec, drawn_values(spec, setup.exact.seed.value_or(spec.seed), index));
  if (!setup.exact.quantity.empty()) {
    std::visit([&](auto& one) { scale_quantity(one, setup.exact.quantity, setup.exact.factor); },
               the_case);
  }
  return the_case;
}

AnyCase named_case_of(const EnsembleSpec& spec, const EnsembleSetup& setup, std::size_t index) {
  AnyCase the_case = case_of(spec, setup, index);
  const DrawnValues values = drawn_values(spec, setup.exact.seed.value_or(spec.seed), index);
  std::string of_draw = fmt::format(", draw {}", index);
  const char* separator = ": ";
  for (const std::size_t axis : grid_axes(spec)) {
    of_draw += fmt::format("{}{} = {:.4g}", separator, spec.varied[axis].quantity, values[axis]);
    separator = ", ";
  }
  std::visit([&](auto& one) { one.name += of_draw; }, the_case);
  return the_case;
}

}  // namespace tautline::bench
