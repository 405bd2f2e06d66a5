#include "bench/run/protocol/child_engine.hpp"

#include <fmt/format.h>

#include <utility>

#include "bench/base/text.hpp"
#include "bench/run/protocol/children.hpp"
#include "bench/run/protocol/simulations.hpp"

namespace tautline::bench {
namespace {

ModelEntry entry_of(const ChildModel& model, const std::string& precision,
                    const std::shared_ptr<Children>& children) {
  const auto start = [=](const Case& the_case,
                         const RunSettings& settings) -> std::unique_ptr<Simulation> {
    return model.by_events ? start_by_events(*children, the_case, model, precision, settings)
                           : start_by_steps(*children, the_case, model, settings);
  };
  return {model.model, start, model.by_events || model.follows_speed};
}

}  // namespace

std::unique_ptr<ChildEngine> ChildEngine::open(const EngineFile& file, std::size_t memory) {
  const auto children = std::make_shared<Children>(
      KeptCommand{file.command, file.path.parent_path().string(), memory});
  const ChildInfo info = Children::Lease(*children)->info();
  if (info.name != file.name) {
    throw ProtocolError(fmt::format("the engine says that its name is {}, {} says {}", info.name,
                                    printable(file.path.native(), 1024), file.name));
  }
  EngineTable table{info.name, info.version, info.precision, {{}}};
  for (const ChildModel& model : info.models) {
    table.families.front().push_back(entry_of(model, info.precision, children));
  }
  return std::unique_ptr<ChildEngine>(new ChildEngine(std::move(table), children));
}

ChildEngine::ChildEngine(EngineTable table, std::shared_ptr<Children> children)
    : TableEngine(std::move(table)), children_(std::move(children)) {}

double ChildEngine::processor_time() const { return children_->processor_time(); }

double ChildEngine::peak_memory() const { return children_->peak_memory(); }

void ChildEngine::forget_peak_memory() const { children_->forget_peak_memory(); }

}  // namespace tautline::bench
