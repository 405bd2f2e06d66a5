// Many random worlds, or the cases of the list, on one engine, held against what the cables
// promise.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <exception>
#include <fstream>
#include <nlohmann/json.hpp>
#include <thread>

#include "engines/cables/worlds/cases.hpp"
#include "engines/cables/worlds/pool.hpp"
#include "engines/cables/worlds/random_world.hpp"
#include "engines/cables/worlds/tables.hpp"

namespace tautline::test {
namespace {

using nlohmann::ordered_json;

struct Options {
  int worlds = 100;
  std::uint64_t first = 1;
  double seconds = 0.0;  // 0: 60 for worlds, 600 for cases
  double rate = 60.0;
  bool events = false;
  bool quick = false;
  bool run_cases = false;
  bool print_tables = false;
  std::string json;
  int workers = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));

  [[nodiscard]] Playing playing() const {
    return {rate, events ? Stepping::by_events : Stepping::fixed, quick};
  }
  [[nodiscard]] std::string title() const {
    return fmt::format("{}, {:g} Hz, {}{}", Scene::engine, rate,
                       events ? "by events" : "fixed steps", quick ? ", QuickStep" : "");
  }
};

ordered_json json_of(const Worst& worst) {
  return {{"value", worst.value}, {"time", worst.time}, {"cable", worst.cable}};
}

ordered_json json_of(const Findings& found) {
  return {{"overstretch", json_of(found.overstretch)},
          {"beyond_a_steps_way", json_of(found.beyond)},
          {"energy_gained", json_of(found.gain)},
          {"energy_range", found.range},
          {"restitution_error", json_of(found.restitution)},
          {"isolated_impacts", found.impacts},
          {"most_parts", found.most_parts},
          {"not_a_number", found.not_a_number.value > 0.0}};
}

void write(const std::string& file, const ordered_json& content) {
  if (file.empty()) {
    return;
  }
  std::ofstream out(file);
  out << content.dump(1) << '\n';
  if (!out) {
    throw std::runtime_error("cannot write " + file);
  }
}

/// One of the measures, over all worlds.
struct Measure {
  std::string name;
  double allowed;  // of a world without hooks
  double (*value)(const Findings&);
  Worst (*where)(const Findings&);
  bool (*broken)(const Broken&);
};

std::vector<Measure> measures(const Claims& claims) {
  return {{"overstretch beyond a step's way [m]", claims.way_allowance,
           [](const Findings& found) { return found.beyond.value; },
           [](const Findings& found) { return found.beyond; },
           [](const Broken& broken) { return broken.overstretch; }},
          {"energy gained, of its range [-]", claims.gain_part,
           [](const Findings& found) { return found.gain_part(); },
           [](const Findings& found) { return found.gain; },
           [](const Broken& broken) { return broken.energy; }},
          {"restitution error [-]", claims.restitution,
           [](const Findings& found) { return found.restitution.value; },
           [](const Findings& found) { return found.restitution; },
           [](const Broken& broken) { return broken.restitution; }},
          {"not a number", 0.0, [](const Findings& found) { return found.not_a_number.value; },
           [](const Findings& found) { return found.not_a_number; },
           [](const Broken& broken) { return broken.number; }}};
}

/// A world and what was found in it.
struct Seen {
  World world;
  Findings found;
};

void print_measure(const Measure& measure, std::vector<const Seen*> seen, Stepping stepping) {
  const auto value = [&measure](const Seen* one) {
    const double result = measure.value(one->found);
    return std::isnan(result) ? std::numeric_limits<double>::infinity() : result;
  };
  std::stable_sort(seen.begin(), seen.end(), [&value](const Seen* one, const Seen* other) {
    return value(one) > value(other);
  });
  const auto breaking = std::count_if(seen.begin(), seen.end(), [&](const Seen* one) {
    return measure.broken(broken(one->found, claims(stepping, !one->world.hooks.empty())));
  });
  const Seen& worst = *seen.front();
  const Worst where = measure.where(worst.found);
  fmt::print("{:<36} {:>8.1e} {:>9.2e} {:>7} {:>7.2f} {:>6} {:>7}\n", measure.name, measure.allowed,
             measure.value(worst.found), worst.world.seed, where.time, where.cable, breaking);
  if (breaking > 0) {
    fmt::print("  worst seeds:");
    for (std::size_t rank = 0; rank < std::min<std::size_t>(10, seen.size()); ++rank) {
      fmt::print(" {} ({}, {:.1e})", seen[rank]->world.seed, seen[rank]->world.kind,
                 measure.value(seen[rank]->found));
    }
    fmt::print("\n");
  }
}

int run_worlds(const Options& options) {
  const double seconds = options.seconds > 0.0 ? options.seconds : 60.0;
  const Playing playing = options.playing();
  const auto world = [&options](int number) {
    return random_world(options.first + static_cast<std::uint64_t>(number));
  };
  const auto start = std::chrono::steady_clock::now();
  const auto results = in_processes<Findings>(options.worlds, options.workers, [&](int number) {
    return findings_of(world(number), playing, seconds);
  });
  const double took =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();

  ordered_json json{{"title", options.title()}, {"seconds", seconds}, {"took", took}};
  std::vector<Seen> seen;
  std::vector<std::uint64_t> aborted;
  long impacts = 0;
  int breaking = 0;
  for (int number = 0; number < options.worlds; ++number) {
    const auto& result = results[static_cast<std::size_t>(number)];
    if (!result) {
      aborted.push_back(options.first + static_cast<std::uint64_t>(number));
      continue;
    }
    seen.push_back({world(number), *result});
    impacts += result->impacts;
    breaking +=
        broken(*result, claims(playing.stepping, !seen.back().world.hooks.empty())).any() ? 1 : 0;
    ordered_json row{{"seed", seen.back().world.seed}, {"kind", seen.back().world.kind}};
    row.update(json_of(*result));
    json["worlds"].push_back(row);
  }
  fmt::print("{}: {} worlds of {:g} s from seed {}, {:.0f} s on {} processes\n", options.title(),
             options.worlds, seconds, options.first, took, options.workers);
  if (!seen.empty()) {
    fmt::print("{:<36} {:>8} {:>9} {:>7} {:>7} {:>6} {:>7}\n", "measure", "allowed", "worst",
               "seed", "at [s]", "cable", "worlds");
    std::vector<const Seen*> all;
    all.reserve(seen.size());
    for (const Seen& one : seen) {
      all.push_back(&one);
    }
    // of worlds with hooks more may be allowed; the table shows what is of the others
    for (const Measure& measure : measures(claims(playing.stepping, false))) {
      print_measure(measure, all, playing.stepping);
    }
  }
  fmt::print("{} isolated impacts; {} worlds break a claim, {} abort", impacts, breaking,
             aborted.size());
  for (const std::uint64_t seed : aborted) {
    fmt::print(" {}", seed);
  }
  fmt::print("\n\n");
  json["aborted"] = aborted;
  write(options.json, json);
  return breaking > 0 || !aborted.empty() ? 1 : 0;
}

/// A case, the worst of its starts, and how many of them break a claim.
struct CaseRow {
  std::string name;
  int starts = 0;
  int breaking = 0;
  int aborted = 0;
  bool rests = false;
  CaseFindings worst;
  double gain_part = 0.0;

  void hold(const CaseFindings& found) {
    worst.off = std::max(worst.off, found.off);
    worst.tension_error = std::max(worst.tension_error, found.tension_error);
    worst.overstretch = std::max(worst.overstretch, found.overstretch);
    const auto worse = [](Worst& one, const Worst& other) {
      one = other.value > one.value ? other : one;
    };
    worse(worst.findings.overstretch, found.findings.overstretch);
    worse(worst.findings.beyond, found.findings.beyond);
    worse(worst.findings.restitution, found.findings.restitution);
    gain_part = std::max(gain_part, found.findings.gain_part());
  }
};

int run_cases(const Options& options) {
  const double seconds = options.seconds > 0.0 ? options.seconds : 600.0;
  const Playing playing = options.playing();
  const auto results = in_processes<CaseFindings>(
      static_cast<int>(cases().size()), options.workers, [&](int number) {
        return findings_of(cases()[static_cast<std::size_t>(number)], playing, seconds);
      });
  std::vector<CaseRow> rows;
  for (std::size_t number = 0; number < cases().size(); ++number) {
    const Case& the_case = cases()[number];
    if (rows.empty() || rows.back().name != the_case.name) {
      rows.emplace_back().name = the_case.name;
    }
    CaseRow& row = rows.back();
    ++row.starts;
    row.rests = the_case.rests;
    if (!results[number]) {
      ++row.aborted;
      continue;
    }
    row.hold(*results[number]);
    row.breaking += is_broken(the_case, *results[number], playing.stepping) ? 1 : 0;
  }
  fmt::print("{}: cases of {:g} s\n", options.title(), seconds);
  fmt::print("{:<34} {:>6} {:>7} {:>8} {:>9} {:>8} {:>9} {:>9} {:>9} {:>9}\n", "case", "starts",
             "breaks", "at rest", "off [m]", "tension", "stretch", "beyond", "gain", "e error");
  ordered_json json{{"title", options.title()}, {"seconds", seconds}};
  int breaking = 0;
  for (const CaseRow& row : rows) {
    const Findings& found = row.worst.findings;
    const std::string off = row.rests ? fmt::format("{:.1e}", row.worst.off) : "-";
    const std::string tension = row.rests ? fmt::format("{:.1e}", row.worst.tension_error) : "-";
    fmt::print("{:<34} {:>6} {:>7} {:>8} {:>9} {:>8} {:>9.1e} {:>9.1e} {:>9.1e} {:>9.1e}{}\n",
               row.name, row.starts, row.breaking, row.rests ? "yes" : "no", off, tension,
               row.worst.overstretch, found.beyond.value, row.gain_part, found.restitution.value,
               row.aborted > 0 ? fmt::format("  {} abort", row.aborted) : "");
    breaking += row.breaking + row.aborted;
    json["cases"].push_back({{"name", row.name},
                             {"starts", row.starts},
                             {"breaking", row.breaking},
                             {"aborted", row.aborted},
                             {"rests", row.rests},
                             {"off", row.worst.off},
                             {"tension_error", row.worst.tension_error},
                             {"overstretch_at_end", row.worst.overstretch},
                             {"gain_part", row.gain_part},
                             {"findings", json_of(found)}});
  }
  fmt::print(
      "off, tension, stretch: of the last 10 s; beyond: overstretch beyond a step's way\n\n");
  write(options.json, json);
  return breaking > 0 ? 1 : 0;
}

int run(int argc, char** argv) {
  Options options;
  CLI::App app("Drop-in cables in " + Scene::engine + ", held against their claims");
  app.add_option("--worlds", options.worlds, "how many random worlds")->check(CLI::PositiveNumber);
  app.add_option("--first", options.first, "seed of the first; the others follow");
  app.add_option("--seconds", options.seconds, "of each: 60 for worlds, 600 for cases unless set")
      ->check(CLI::PositiveNumber);
  app.add_option("--rate", options.rate, "steps a second")->check(CLI::PositiveNumber);
  app.add_flag("--events", options.events, "steps split at the impacts");
  app.add_flag("--quick", options.quick, "ODE's iterative solver");
  app.add_flag("--cases", options.run_cases, "the cases of the list, not random worlds");
  app.add_flag("--tables", options.print_tables,
               "mass ratios and cost beside the engine's own joints, as Markdown");
  app.add_option("--json", options.json, "writes all findings to a file");
  app.add_option("-j", options.workers, "processes")->check(CLI::PositiveNumber);
  CLI11_PARSE(app, argc, argv);
  if (options.quick && !Scene(0.0).use_quick_step()) {
    fmt::print(stderr, "{} has no QuickStep\n", Scene::engine);
    return 2;
  }
  if (options.print_tables) {
    print_tables(options.rate);
    return 0;
  }
  return options.run_cases ? run_cases(options) : run_worlds(options);
}

}  // namespace
}  // namespace tautline::test

int main(int argc, char** argv) {
  try {
    return tautline::test::run(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
