#include "bench/suite/run_files.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <sstream>
#include <utility>

#include "bench/base/atomic_file.hpp"
#include "bench/base/text.hpp"
#include "bench/cases/case_writer.hpp"
#include "bench/cases/catalogue.hpp"
#include "bench/report/compact_json.hpp"

namespace tautline::bench {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

/// A file that only `open_tree` makes: a folder with it is ours to clear.
constexpr const char* marker = "tautline-results.txt";

std::string state_columns(const State& state) {
  return fmt::format("{},{},{},{},{},{}", state.position.x(), state.position.y(), state.angle,
                     state.velocity.x(), state.velocity.y(), state.spin);
}

std::string file_content(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream content;  // whole buffers at a time: a program is tens of megabytes
  content << file.rdbuf();
  return std::move(content).str();
}

/// Of the program itself: what it compares, and how, may change without its version.
std::uint64_t program_hash() {
  static const std::uint64_t value = stable_hash(file_content("/proc/self/exe"));
  return value;
}

ordered_json settings_json(const SuiteOptions& options, const PlannedRun& run) {
  const EngineInfo& info = *options.engines[run.engine].info;
  ordered_json settings = ordered_json::array();
  for (const Setting& setting : run.model.settings) {
    settings.push_back(
        {{"name", setting.name}, {"value", setting.value}, {"reason", setting.reason}});
  }
  return {{"schema", 1},
          {"engine", info.name},
          {"version", info.version},
          {"precision", info.precision},
          {"model", run.model.name},
          {"sentence", run.model.sentence},
          {"step", run.step},
          {"settings", std::move(settings)}};
}

}  // namespace

fs::path run_folder(const fs::path& out, const std::string& case_name, const std::string& engine,
                    const std::string& model, double step) {
  return out / "runs" / folder_name(case_name) / folder_name(engine) / folder_name(model) /
         fmt::format("{}", step);
}

std::string trajectory_csv(const Trajectory& run, std::size_t samples) {
  std::string csv = "time,x,y,angle,vx,vy,spin,event\n";
  const std::size_t stride =
      std::max<std::size_t>(1, run.points.size() / std::max<std::size_t>(1, samples));
  auto impact = run.impacts.begin();
  const auto impacts_until = [&](double time) {
    for (; impact != run.impacts.end() && impact->time <= time; ++impact) {
      csv += fmt::format("{},{},before\n", impact->time, state_columns(impact->before));
      csv += fmt::format("{},{},after\n", impact->time, state_columns(impact->after));
    }
  };
  for (std::size_t index = 0; index < run.points.size(); ++index) {
    const auto& [time, state] = run.points[index];
    if (index % stride == 0 || index + 1 == run.points.size()) {
      impacts_until(time);
      csv += fmt::format("{},{},\n", time, state_columns(state));
    }
  }
  return csv;
}

std::string events_csv(const Trajectory& run) {
  std::string csv = "time,cable,impulse,rate_before,rate_after,restitution,steps\n";
  for (const RecordedImpact& impact : run.impacts) {
    csv += fmt::format("{},{},{},{},{},{},{}\n", impact.time, impact.cable, impact.impulse,
                       impact.rate_before, impact.rate_after,
                       -impact.rate_after / impact.rate_before, impact.steps);
  }
  return csv;
}

std::string fingerprint(const SuiteOptions& options, const PlannedRun& run) {
  const std::string text =
      write_case(options.cases[run.the_case]) + settings_json(options, run).dump() +
      fmt::format("{} {} {} {} {} {}", options.compare.count_speed, options.compare.early_impacts,
                  options.samples, run.path_samples, to_string(options.law), TAUTLINE_VERSION) +
      file_content(options.engines[run.engine].plugin);
  return fmt::format("{:016x}{:016x}", stable_hash(text), program_hash());
}

void write_run(const fs::path& folder, const SuiteOptions& options, const PlannedRun& run,
               const RunReply& reply, const RunResult& result) {
  if (reply.trajectory) {
    write_file(folder / "trajectory.csv", trajectory_csv(*reply.trajectory, options.samples));
    write_file(folder / "events.csv", events_csv(*reply.trajectory));
  }
  if (reply.printed > 0) {
    write_file(
        folder / "output.txt",
        fmt::format("[{} bytes printed, the last of them:]\n", reply.printed) + reply.output_tail);
  }
  write_file(folder / "settings.json", settings_json(options, run).dump(2) + "\n");
  const ordered_json whole = {
      {"fingerprint", fingerprint(options, run)}, {"row", result.row}, {"timing", result.timing}};
  write_file(folder / "result.json", compact_json(whole));
}

std::optional<RunResult> read_run(const fs::path& folder, const std::string& fingerprint) {
  const auto whole = ordered_json::parse(file_content(folder / "result.json"), nullptr, false);
  if (!whole.is_object() || !whole.contains("row") || !whole.contains("timing") ||
      whole.value("fingerprint", "") != fingerprint) {
    return std::nullopt;
  }
  return RunResult{whole.at("row"), whole.at("timing")};
}

Descriptor open_tree(const fs::path& out, bool clear) {
  std::error_code error;
  fs::create_directories(out, error);
  Descriptor folder(::open(out.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (folder.get() < 0) {
    const std::error_code reason(errno, std::generic_category());
    throw FileError("cannot make the folder " + printable(out.string()) + ": " + reason.message());
  }
  if (::flock(folder.get(), LOCK_EX | LOCK_NB) != 0) {
    throw FileError("another `tautline` is writing to " + printable(out.string()) +
                    "; wait for it, or give another --out");
  }
  if (clear) {
    fs::remove_all(out / "runs", error);
    for (const char* file : {"report.json", "report.md", "index.html"}) {
      fs::remove(out / file, error);
    }
  }
  write_file(out / marker,
             "A result tree of `tautline`, which may clear and rewrite this folder.\n");
  return folder;
}

std::optional<std::string> tree_problem(const fs::path& out) {
  std::error_code error;
  if (!fs::exists(out, error)) {
    return std::nullopt;
  }
  const std::string name = printable(out.string());
  if (!fs::is_directory(out, error)) {
    return fmt::format("--out {}: is not a folder; give a folder to write the results to", name);
  }
  if (fs::is_empty(out, error) || fs::exists(out / marker, error)) {
    return std::nullopt;
  }
  return fmt::format(
      "--out {}: holds files that `tautline` did not write; give an empty or new "
      "folder",
      name);
}

}  // namespace tautline::bench
