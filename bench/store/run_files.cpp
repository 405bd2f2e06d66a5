#include "bench/store/run_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <fstream>
#include <functional>
#include <iterator>
#include <limits>
#include <map>
#include <mutex>
#include <string_view>
#include <vector>

#include "bench/base/atomic_file.hpp"
#include "bench/base/text.hpp"
#include "bench/cases/catalogue.hpp"
#include "bench/data/coordinates.hpp"
#include "bench/report/json/json.hpp"
#include "bench/run/protocol/engine_file.hpp"
#include "tautline/case_file.hpp"

namespace tautline::bench {
namespace {

namespace fs = std::filesystem;

template <class BodyState>
std::string state_columns(const BodyState& state) {
  std::string columns;
  for (const auto& one : coordinates(state)) {
    columns += fmt::format("{},", one.value);
  }
  return columns;
}
std::string state_columns(const SpatialSystemState& state) {
  std::string columns;
  for (const SpatialState& body : state.bodies) {
    columns += state_columns(body);
  }
  return columns;
}

std::string state_names(const Case& the_case) {
  std::string names;
  for (const auto& one : coordinates(the_case.initial)) {
    names += fmt::format("{},", one.name);
  }
  return names;
}
std::string state_names(const SpatialSystem& system) {
  std::string names;
  for (std::size_t index = 0; index < system.bodies.size(); ++index) {
    std::string body = system.bodies[index].name;
    if (body.empty() && system.bodies.size() > 1) {
      body = fmt::format("body_{}", index);
    }
    std::replace_if(
        body.begin(), body.end(),
        [](unsigned char letter) { return std::isalnum(letter) == 0 && letter != '_'; }, '_');
    for (const auto& one : coordinates(system.initial.bodies[index])) {
      names += fmt::format("{}{}{},", body, body.empty() ? "" : "_", one.name);
    }
  }
  return names;
}

/// One side of an impact.
template <class TheCase>
struct ImpactLine {
  double time;                    // [s]
  const StateOf<TheCase>* state;  // not null
  const char* side;
};

/// The state before and after the impacts of each instant, in rising time. Cables that act at one
/// instant share one pair: the state before the first and after the last. A push over several steps
/// ends after it began.
template <class TheCase>
std::vector<ImpactLine<TheCase>> impact_lines(const BasicTrajectory<TheCase>& run) {
  std::vector<ImpactLine<TheCase>> before;
  std::vector<ImpactLine<TheCase>> after;
  for (const BasicRecordedImpact<TheCase>& impact : run.impacts) {
    before.push_back({impact.time, &impact.before, "before"});
    after.push_back({impact.ended, &impact.after, "after"});
  }
  const auto earlier = [](const auto& a, const auto& b) { return a.time < b.time; };
  const auto one_instant = [](const auto& a, const auto& b) { return a.time == b.time; };
  std::stable_sort(before.begin(), before.end(), earlier);
  std::stable_sort(after.begin(), after.end(), earlier);
  before.erase(std::unique(before.begin(), before.end(), one_instant), before.end());
  after.erase(after.begin(), std::unique(after.rbegin(), after.rend(), one_instant).base());
  std::vector<ImpactLine<TheCase>> lines;
  std::merge(before.begin(), before.end(), after.begin(), after.end(), std::back_inserter(lines),
             earlier);
  return lines;
}

/// Adds the rows of the impacts from `impact` on up to `time` [s]; the next one.
template <class Iterator>
Iterator add_impacts(std::string& csv, Iterator impact, Iterator end, double time,
                     const std::string& no_tensions) {
  for (; impact != end && impact->time <= time; ++impact) {
    csv += fmt::format("{},{}{}{}\n", impact->time, state_columns(*impact->state), impact->side,
                       no_tensions);
  }
  return impact;
}

std::string file_content(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// Of a file's content, piece by piece: a program with its debug information is a hundred
/// megabytes. The standard library's hash takes eight bytes at a time, and is the same wherever the
/// same program is.
std::uint64_t content_hash(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::vector<char> piece(std::size_t{1} << 18U);
  std::string hashes;
  do {
    file.read(piece.data(), static_cast<std::streamsize>(piece.size()));
    const auto size = static_cast<std::size_t>(file.gcount());
    hashes += fmt::format("{:x} ", std::hash<std::string_view>{}({piece.data(), size}));
  } while (file);
  return stable_hash(hashes);
}

/// Of a file's content, read the first time it is asked for.
std::uint64_t file_hash(const fs::path& path) {
  static std::mutex guard;
  static std::map<fs::path, std::uint64_t> known;
  const std::scoped_lock lock(guard);
  const auto [place, is_new] = known.try_emplace(path, 0);
  if (is_new) {
    place->second = content_hash(path);
  }
  return place->second;
}

}  // namespace

std::uint64_t program_hash() { return file_hash("/proc/self/exe"); }

std::uint64_t plugin_hash(const SuiteOptions& options, std::size_t engine) {
  if (!options.plugins.empty()) {
    return options.plugins[engine];
  }
  const fs::path& plugin = options.engines[engine].plugin;
  if (!is_engine_file(plugin)) {
    return file_hash(plugin);
  }
  std::string hashes;
  for (const fs::path& file : named_files(plugin)) {
    hashes += fmt::format("{:016x} ", file_hash(file));
  }
  return stable_hash(hashes);
}

fs::path run_folder(const fs::path& out, const RunKey& run) {
  return out / "runs" / folder_name(run.the_case) / folder_name(run.engine) /
         folder_name(run.model) / fmt::format("{}", run.step);
}

template <class TheCase>
std::string trajectory_csv(const TheCase& the_case, const BasicTrajectory<TheCase>& run,
                           std::size_t samples) {
  const std::size_t cables = run.tensions.size() / run.points.size();
  std::string csv = "time," + state_names(the_case) + "event";
  for (std::size_t cable = 0; cable < cables; ++cable) {
    csv += fmt::format(",tension_{}", cable);
  }
  csv += '\n';
  const std::string no_tensions(cables, ',');
  const std::size_t stride =
      std::max<std::size_t>(1, run.points.size() / std::max<std::size_t>(1, samples));
  const std::vector<ImpactLine<TheCase>> impacts = impact_lines(run);
  auto impact = impacts.begin();
  for (std::size_t index = 0; index < run.points.size(); ++index) {
    const auto& [time, state] = run.points[index];
    if (index % stride == 0 || index + 1 == run.points.size()) {
      impact = add_impacts(csv, impact, impacts.end(), time, no_tensions);
      csv += fmt::format("{},{}", time, state_columns(state));
      for (std::size_t cable = 0; cable < cables; ++cable) {
        const double tension = run.tensions[index * cables + cable];
        csv += std::isfinite(tension) ? fmt::format(",{}", tension) : ",";
      }
      csv += '\n';
    }
  }
  add_impacts(csv, impact, impacts.end(), std::numeric_limits<double>::infinity(), no_tensions);
  return csv;
}

template <class TheCase>
std::string events_csv(const BasicTrajectory<TheCase>& run) {
  std::string csv = "time,cable,impulse,rate_before,rate_after,restitution,steps\n";
  for (const BasicRecordedImpact<TheCase>& impact : run.impacts) {
    csv += fmt::format("{},{},{},{},{},{},{}\n", impact.time, impact.cable, impact.impulse,
                       impact.rate_before, impact.rate_after,
                       -impact.rate_after / impact.rate_before, impact.steps);
  }
  return csv;
}

template std::string trajectory_csv(const Case&, const Trajectory&, std::size_t);
template std::string trajectory_csv(const SpatialSystem&, const SystemTrajectory&, std::size_t);
template std::string events_csv(const Trajectory&);
template std::string events_csv(const SystemTrajectory&);

std::string fingerprint(const SuiteOptions& options, const PlannedRun& run) {
  const RegisteredEngine& engine = options.engines[run.engine];
  const std::string text =
      written(options.cases[run.the_case]) + settings_json(*engine.info, run.model, run.step) +
      fmt::format("{} {} {} {} {}", options.compare.count_speed, options.compare.early_impacts,
                  options.samples, to_string(options.law), TAUTLINE_VERSION) +
      fmt::format(" {:016x}", plugin_hash(options, run.engine));
  return fmt::format("{:016x}{:016x}", stable_hash(text), program_hash());
}

void write_run(const fs::path& folder, const SuiteOptions& options, const PlannedRun& run,
               const RunReply& reply, const RunRecord& record) {
  const auto write_motion = [&]<class TheCase>(const BasicTrajectory<TheCase>& motion) {
    const auto& the_case = std::get<TheCase>(options.cases[run.the_case]);
    write_file(folder / "trajectory.csv", trajectory_csv(the_case, motion, options.samples));
    write_file(folder / "events.csv", events_csv(motion));
  };
  if (reply.trajectory) {
    write_motion(*reply.trajectory);
  } else if (reply.in_space) {
    write_motion(*reply.in_space);
  }
  if (reply.printed > 0) {
    write_file(
        folder / "output.txt",
        fmt::format("[{} bytes printed, the last of them:]\n", reply.printed) + reply.output_tail);
  }
  write_file(folder / "settings.json",
             settings_json(*options.engines[run.engine].info, run.model, run.step));
  write_file(folder / "result.json", record_json(record, fingerprint(options, run)));
}

std::optional<RunRecord> read_run(const fs::path& folder, const std::string& fingerprint) {
  return record_from(file_content(folder / "result.json"), fingerprint);
}

}  // namespace tautline::bench
