#include "bench/cases/catalogue.hpp"

#include <fnmatch.h>

#include <algorithm>
#include <cstdint>
#include <system_error>

#include "bench/base/text.hpp"
#include "tautline/case_file.hpp"
#include "tautline/scenarios.hpp"

namespace tautline::bench {
namespace {

namespace fs = std::filesystem;

bool is_case_file(const std::string& argument) {
  std::error_code ignored;
  return argument.ends_with(".toml") || fs::exists(fs::path(argument), ignored);
}

/// The system of this name, if `shipped` has it.
template <class Shipped>
auto named(const std::vector<Shipped>& shipped, const std::string& name) {
  const auto found = std::find_if(shipped.begin(), shipped.end(),
                                  [&](const Shipped& one) { return one.system.name == name; });
  return found != shipped.end() ? std::optional(found->system) : std::nullopt;
}

bool is_glob(const std::string& argument) {
  return argument.find_first_of("*?[") != std::string::npos;
}

/// Gathers what the arguments name.
class Selector {
 public:
  Selector(CableSet taut, Kinds kinds)
      : taut_(taut), kinds_(kinds), shipped_(shipped_cases()), chosen_(shipped_.size(), false) {
    for (const Case& the_case : shipped_) {
      names_.push_back(the_case.name);
    }
  }

  void add(const std::string& argument) {
    const auto name = std::find(names_.begin(), names_.end(), argument);
    if (name != names_.end()) {
      chosen_[static_cast<std::size_t>(name - names_.begin())] = true;
    } else if (is_case_file(argument)) {
      add_file(argument);
    } else if (is_glob(argument)) {
      add_matches(argument);
    } else if (auto system = named(shipped_systems(), argument)) {
      add_shipped(std::move(*system), systems_);
    } else if (auto in_space = named(shipped_spatial_systems(), argument)) {
      add_shipped(std::move(*in_space), in_space_);
    } else {
      const std::string near = suggestion(argument, names_);
      problems_.push_back(
          "unknown case \"" + printable(argument) + "\"" +
          (near.empty() ? ": must be a shipped name, a glob of them or a case file" : near));
    }
  }

  CaseSelection finish() {
    std::vector<Chosen> all;
    for (std::size_t index = 0; index < shipped_.size(); ++index) {
      if (chosen_[index]) {
        const StartChange change = start_taut(shipped_[index], taut_);
        add_of(shipped_[index].name, change.problems, problems_);
        add_of(shipped_[index].name, change.notes, notes_);
        all.push_back({std::move(shipped_[index]), "a shipped case"});
      }
    }
    std::move(files_.begin(), files_.end(), std::back_inserter(all));
    refuse_equal_names(all);
    CaseSelection result;
    result.problems = std::move(problems_);
    result.notes = std::move(notes_);
    if (result.problems.empty()) {
      for (Chosen& chosen : all) {
        result.cases.push_back(std::move(chosen.the_case));
      }
      result.systems = std::move(systems_);
      result.in_space = std::move(in_space_);
    }
    return result;
  }

 private:
  struct Chosen {
    Case the_case;
    std::string source;  // printable: the path of its file, or "a shipped case"
  };

  /// Adds `sentences` on the shipped case of this name.
  static void add_of(const std::string& name, const std::vector<std::string>& sentences,
                     std::vector<std::string>& all) {
    for (const std::string& sentence : sentences) {
      all.push_back(name + ": " + sentence);
    }
  }

  void add_matches(const std::string& pattern) {
    bool found = false;
    for (std::size_t index = 0; index < names_.size(); ++index) {
      if (::fnmatch(pattern.c_str(), names_[index].c_str(), 0) == 0) {
        chosen_[index] = true;
        found = true;
      }
    }
    if (!found) {
      problems_.push_back("no shipped case matches \"" + printable(pattern) + "\"" +
                          suggestion(pattern, names_));
    }
  }

  void add_file(const std::string& path) {
    std::error_code error;
    const fs::path file = fs::weakly_canonical(path, error);
    if (!error && std::find(read_.begin(), read_.end(), file) != read_.end()) {
      return;
    }
    read_.push_back(file);
    if (kinds_ == Kinds::cases_alone) {
      CaseReading reading = read_case(path, taut_);
      add_read(reading, path);
      return;
    }
    SystemReading reading = read_system(path, taut_);
    const bool is_case = reading.the_case.has_value();
    add_read(reading, path);
    if (!is_case && reading.problems.empty() && !taut_.empty()) {
      problems_.push_back(printable(path) + ": is a system; --taut is for cases alone");
    }
    if (!is_case && reading.system) {
      add_system(std::move(*reading.system), printable(path), systems_);
    }
    if (reading.in_space) {
      add_system(std::move(*reading.in_space), printable(path), in_space_);
    }
  }

  /// The case of a reading, and all that is said of it.
  template <class Reading>
  void add_read(Reading& reading, const std::string& path) {
    if (reading.the_case) {
      files_.push_back({std::move(*reading.the_case), printable(path)});
    }
    problems_.insert(problems_.end(), reading.problems.begin(), reading.problems.end());
    notes_.insert(notes_.end(), reading.notes.begin(), reading.notes.end());
  }

  template <class TheSystem>
  void add_shipped(TheSystem system, std::vector<TheSystem>& same_kind) {
    if (kinds_ == Kinds::cases_alone) {
      problems_.push_back(printable(system.name) +
                          " is a system; must be a case here: one body, and constants alone");
    }
    add_system(std::move(system), "a shipped system", same_kind);
  }

  template <class TheSystem>
  void add_system(TheSystem system, const std::string& source, std::vector<TheSystem>& same_kind) {
    const auto has_its_name = [&](const auto& other) { return other.name == system.name; };
    const bool known = std::any_of(systems_.begin(), systems_.end(), has_its_name) ||
                       std::any_of(in_space_.begin(), in_space_.end(), has_its_name);
    if (!known) {
      same_kind.push_back(std::move(system));
    } else if (source != "a shipped system") {
      problems_.push_back(source + ": name = \"" + printable(system.name) +
                          "\" is also the name of another system; two systems of one selection "
                          "must differ in name");
    }
  }

  /// Results are kept by name, so two cases of one name cannot be told apart.
  void refuse_equal_names(const std::vector<Chosen>& all) {
    for (std::size_t j = 0; j < all.size(); ++j) {
      const auto equal = std::find_if(
          all.begin(), all.begin() + static_cast<std::ptrdiff_t>(j),
          [&all, j](const Chosen& other) { return other.the_case.name == all[j].the_case.name; });
      if (equal != all.begin() + static_cast<std::ptrdiff_t>(j)) {
        problems_.push_back(all[j].source + ": name = \"" + printable(all[j].the_case.name) +
                            "\" is also the name of " + equal->source +
                            "; two cases of one selection must differ in name");
      }
    }
  }

  CableSet taut_;
  Kinds kinds_;
  std::vector<Case> shipped_;
  std::vector<std::string> names_;  // of `shipped_`
  std::vector<bool> chosen_;        // of `shipped_`
  std::vector<fs::path> read_;      // files seen so far
  std::vector<Chosen> files_;
  std::vector<System> systems_;
  std::vector<SpatialSystem> in_space_;
  std::vector<std::string> problems_;
  std::vector<std::string> notes_;
};

constexpr std::size_t hash_digits = 16;

std::string hexadecimal(std::uint64_t value) {
  std::string result(hash_digits, '0');
  for (auto digit = result.rbegin(); digit != result.rend(); ++digit, value >>= 4U) {
    *digit = "0123456789abcdef"[value & 0xFU];
  }
  return result;
}

/// Such a name could be the folder of another one.
bool ends_like_a_hash(const std::string& name) {
  return name.size() > hash_digits && name[name.size() - hash_digits - 1] == '-' &&
         name.find_last_not_of("0123456789abcdef") == name.size() - hash_digits - 1;
}

bool is_plain(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.' ||
         c == '_' || c == '-';
}

/// `name` without what a path must not hold: no empty, hidden or option-like component.
std::string harmless(const std::string& name) {
  std::string result;
  for (const char c : name) {
    const bool starts = result.empty() || result.back() == '/';
    if (c == '/') {
      result += starts ? "" : "/";
    } else {
      result += is_plain(c) && !(starts && (c == '.' || c == '-')) ? c : '_';
    }
  }
  if (result.ends_with('/')) {
    result.pop_back();
  }
  return result;
}

}  // namespace

CaseSelection select_cases(std::span<const std::string> arguments, CableSet taut, Kinds kinds) {
  Selector selector(taut, kinds);
  for (const std::string& argument : arguments) {
    selector.add(argument);
  }
  return selector.finish();
}

fs::path folder_name(const std::string& case_name) {
  constexpr std::size_t longest = 120;  // leaves room for the rest of a path within 255
  std::string name = harmless(case_name);
  if (name == case_name && !name.empty() && name.size() <= longest && !ends_like_a_hash(name)) {
    return name;
  }
  name.resize(std::min(name.size(), longest - hash_digits - 1));
  if (name.ends_with('/')) {
    name.pop_back();
  }
  return (name.empty() ? "case" : name) + "-" + hexadecimal(stable_hash(case_name));
}

}  // namespace tautline::bench
