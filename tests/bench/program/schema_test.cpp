// The schemas of the files that people write: the committed ones are those that the program
// prints, what ships keeps them, and they agree with the readers.

#include <gtest/gtest.h>

#include <fstream>
#include <functional>
#include <map>
#include <random>

#include "bench/check/contract.hpp"
#include "bench/ensemble/spec_file.hpp"
#include "bench/gate/listed_problems.hpp"
#include "bench/run/protocol/engine_file.hpp"
#include "tautline/case_file.hpp"
#include "tests/bench/schema.hpp"

namespace tautline::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using Sentences = std::vector<std::string>;

const fs::path sources = TAUTLINE_SOURCES;

const std::map<std::string, fs::path> committed_schemas = {
    {"case", sources / "docs/reference/schemas/case.schema.json"},
    {"spec", sources / "docs/reference/schemas/spec.schema.json"},
    {"problems", sources / "bench/gate/problems.schema.json"},
    {"engine", sources / "engines/protocol/engine.schema.json"},
    {"contract", sources / "engines/protocol/contract.schema.json"}};

/// The file of a system is a case file.
json schema_of(const std::string& kind) {
  const auto found = committed_schemas.find(kind);
  return json::parse(
      content_of(found != committed_schemas.end() ? found->second : committed_schemas.at("case")));
}

TEST(FileSchemas, AreThoseThatTheProgramPrints) {
  for (const auto& [kind, path] : committed_schemas) {
    const Outcome outcome = program({"schema", kind});
    EXPECT_EQ(outcome.code, 0) << outcome.errors;
    EXPECT_EQ(content_of(path), outcome.output) << "write it again: tautline schema " << kind;
  }
  const Outcome outcome = program({"schema", "cse"});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_NE(outcome.errors.find("case"), std::string::npos) << outcome.errors;
}

/// Calls `visit` with each key that `schema` describes, and its schema.
void visit_keys(const json& schema,
                const std::function<void(const std::string&, const json&)>& visit) {
  if (schema.contains("items")) {
    visit_keys(schema.at("items"), visit);
  }
  if (schema.contains("anyOf")) {  // a value by itself or a table
    for (const json& one : schema.at("anyOf")) {
      visit_keys(one, visit);
    }
  }
  if (schema.contains("properties")) {
    for (const auto& [key, value] : schema.at("properties").items()) {
      visit(key, value);
      visit_keys(value, visit);
    }
  }
}

TEST(FileSchemas, SayWhatEachKeyMeans) {
  for (const auto& one : committed_schemas) {
    std::size_t keys = 0;
    visit_keys(schema_of(one.first), [&](const std::string& key, const json& value) {
      EXPECT_GE(value.value("description", "").size(), 8U) << one.first << " " << key;
      ++keys;
    });
    EXPECT_GE(keys, 5U) << one.first;
  }
}

TEST(FileSchemas, AreNamedInTheFirstLineOfWhatShipsWhichKeepsThem) {
  std::map<fs::path, std::size_t> files;  // that name each schema
  for (const char* const folder : {"bench", "docs", "engines"}) {
    for (auto entry = fs::recursive_directory_iterator(sources / folder);
         entry != fs::recursive_directory_iterator(); ++entry) {
      const std::string name = entry->path().filename().string();
      if (name == "node_modules" || name == "build") {
        entry.disable_recursion_pending();
      }
      if (entry->path().extension() != ".toml" || name == "findings.toml" ||
          name == "pyproject.toml") {  // which tautline does not read
        continue;
      }
      const std::string text = content_of(entry->path());
      const std::string mark = "#:schema ";
      ASSERT_TRUE(text.starts_with(mark)) << entry->path();
      const fs::path schema = fs::weakly_canonical(
          entry->path().parent_path() / text.substr(mark.size(), text.find('\n') - mark.size()));
      ASSERT_TRUE(fs::exists(schema)) << entry->path() << " names " << schema;
      ++files[schema];
      EXPECT_EQ(broken_rules(file_as_json(text), json::parse(content_of(schema))), "")
          << entry->path();
    }
  }
  for (const auto& [kind, path] : committed_schemas) {
    EXPECT_GE(files[fs::weakly_canonical(path)], 1U) << kind;
  }
  EXPECT_EQ(files.size(), committed_schemas.size());
}

/// A kind of file: a sound one with every key, what its reader says of a text, and parts of the
/// sentences by which the reader refuses what a schema cannot.
struct FileKind {
  std::string sound;
  std::function<Sentences(const std::string&)> problems;
  Sentences of_reader_alone;
};

std::string fuzz_seed(const std::string& name) {
  return content_of(sources / "tests/fuzz/corpus/files" / name);
}

const std::map<std::string, FileKind>& file_kinds() {
  static const std::map<std::string, FileKind> all = {
      {"case",
       {fuzz_seed("case.toml"),
        [](const std::string& text) { return read_system_text(text, "f").problems; },
        {"overstretched", "cannot reach", "above ceiling", "beyond angle_limit",
         "restitution_table[", "larger in size than", "is an array of length 3, must be two"}}},
      {"system",
       {fuzz_seed("system.toml"),
        [](const std::string& text) { return read_system_text(text, "f").problems; },
        {"overstretched", "larger in size than", "must be above from_time",
         "one for each of the times", "must rise", "is for a point mass",
         "which a point mass has not", "from 0.25 must be above", "too, must be another one",
         "unknown body", "restitution_table[", "as long as the cable acts",
         "is an array of length 3, must be two"}}},
      {"elastic",
       {fuzz_seed("elastic.toml"),
        [](const std::string& text) { return read_system_text(text, "f").problems; },
        {"larger in size than", "is an array of length 3, must be two", "unknown body",
         ": stiffness ", ": corners[", "one of them must be on a body",
         "for no damping takes all speed", " rad/s, must be at most"}}},
      {"spec",
       {fuzz_seed("spec.toml"),
        [](const std::string& text) { return bench::read_spec_text(text, "f").problems; },
        {"unknown case", "two falling speeds", "low below high", "varied twice", "two are called",
         "given twice"}}},
      {"problems",
       {fuzz_seed("problems.toml"),
        [](const std::string& text) { return bench::read_problems_text(text, "f").problems; },
        {".each["}}},
      {"contract",
       {fuzz_seed("contract.toml"),
        [](const std::string& text) { return bench::read_contract(text, "f", {}).problems; },
        {}}},
      {"engine",
       {"name = \"mine\"\ncommand = [\"node\", \"engine.mjs\"]\npackage = \"p\"\nlock = \"l\"\n"
        "installed = \"i\"\nbring = \"npm ci\"\nversions = \">=1\"\nshares = [\"../common\"]\n",
        [](const std::string& text) {
          static const TemporaryFolder folder;
          return bench::read_engine_file(folder.file("engine.toml", text)).problems;
        },
        {"small letters", "folders next to this one"}}}};
  return all;
}

/// A value as TOML has it.
std::string as_toml(const json& value) {
  std::string text;
  if (value.is_object()) {
    for (const auto& [key, one] : value.items()) {
      text += (text.empty() ? "" : ", ") + json(key).dump() + " = " + as_toml(one);
    }
    return "{" + text + "}";
  }
  if (value.is_array()) {
    for (const json& one : value) {
      text += (text.empty() ? "" : ", ") + as_toml(one);
    }
    return "[" + text + "]";
  }
  return value.dump();
}

std::string file_of(const json& value) {
  std::string text;
  for (const auto& [key, one] : value.items()) {
    text += json(key).dump() + " = " + as_toml(one) + "\n";
  }
  return text;
}

/// The places of `value` and of all that is in it.
void add_places(const json& value, const json::json_pointer& at,
                std::vector<json::json_pointer>& places) {
  if (!at.empty()) {
    places.push_back(at);
  }
  if (value.is_object()) {
    for (const auto& [key, one] : value.items()) {
      add_places(one, at / key, places);
    }
  } else if (value.is_array()) {
    for (std::size_t index = 0; index < value.size(); ++index) {
      add_places(value[index], at / index, places);
    }
  }
}

/// `file` with a value replaced, moved to another key, given twice or left out.
json mutated(json file, std::mt19937& random) {
  const auto below = [&](std::size_t count) { return random() % count; };
  static const json values = json::parse(
      R"(["", "row", "exact", 0, 1, 2, 2.0, -1, 0.5, 1e-12, 1000, 1e6, 1e25, true, false, [], {},
          ["x"], [1], [0, 1], [1, 0], [[0, 1]], [{}]])");
  std::vector<json::json_pointer> places;
  add_places(file, json::json_pointer(), places);
  if (places.empty()) {
    return file;
  }
  const json::json_pointer place = places[below(places.size())];
  const json::json_pointer other = places[below(places.size())];
  json& parent = file.at(place.parent_pointer());
  switch (below(5)) {
    case 0:
      file.at(place) = values[below(values.size())];
      break;
    case 1:
      file.at(place) = json(file.at(other));
      break;
    case 2:
      if (parent.is_object()) {
        parent[below(3) == 0 ? "colour" : other.back()] = json(file.at(place));
      } else {
        parent.push_back(json(file.at(place)));
      }
      break;
    case 3:
      if (json& one = file.at(place); one.is_number()) {
        one = one.get<double>() * (below(2) == 0 ? -1.0 : 100.0);
      }
      break;
    default:
      if (parent.is_object()) {
        parent.erase(place.back());
      } else {
        parent.erase(std::stoul(place.back()));
      }
  }
  return file;
}

class FileSchema : public testing::TestWithParam<std::string> {};

TEST_P(FileSchema, AcceptsWhatTheReaderAcceptsAndRefusesTheRestButForRulesOfTheReader) {
  const FileKind& kind = file_kinds().at(GetParam());
  const json schema = schema_of(GetParam());
  const json sound = file_as_json(kind.sound);
  ASSERT_EQ(kind.problems(file_of(sound)), Sentences());
  ASSERT_EQ(broken_rules(sound, schema), "");
  std::mt19937 random(1);
  std::size_t accepted = 0;
  std::size_t refused = 0;
  std::set<std::string> alone;
  for (int file = 0; file < 2000; ++file) {
    json changed = mutated(sound, random);
    if (file % 4 == 0) {
      changed = mutated(changed, random);
    }
    const std::string text = file_of(changed);
    const Sentences problems = kind.problems(text);
    const std::string broken = broken_rules(file_as_json(text), schema);
    if (problems.empty()) {
      ++accepted;
      ASSERT_EQ(broken, "") << text;
      continue;
    }
    ++refused;
    if (!broken.empty()) {
      continue;
    }
    for (const std::string& problem : problems) {
      const auto says = [&](const std::string& part) {
        return problem.find(part) != std::string::npos;
      };
      const auto rule =
          std::find_if(kind.of_reader_alone.begin(), kind.of_reader_alone.end(), says);
      EXPECT_TRUE(rule != kind.of_reader_alone.end())
          << "the schema accepts what the reader refuses: " << problem << "\n"
          << text;
      if (rule != kind.of_reader_alone.end()) {
        alone.insert(*rule);
      }
    }
  }
  EXPECT_GE(accepted, 100U);
  EXPECT_GE(refused, 300U);
  for (const std::string& rule : kind.of_reader_alone) {
    EXPECT_TRUE(alone.contains(rule)) << "no file met this rule of the reader alone: " << rule;
  }
}

INSTANTIATE_TEST_SUITE_P(Of, FileSchema,
                         testing::Values("case", "system", "elastic", "spec", "problems",
                                         "contract", "engine"),
                         [](const auto& one) { return one.param; });

/// A sound file with one line of it replaced, and if a schema can refuse what is wrong with it.
struct WrongFile {
  std::string kind;
  std::string line;
  std::string instead;
};

TEST(FileSchemas, RefuseUnknownKeysWrongTypesRangesAndWhatIsMissing) {
  const std::vector<WrongFile> wrong = {
      {"spec", "case = \"bouncing-ball\"\n", ""},
      {"spec", "count = 3", "count = 2.5"},
      {"spec", "count = 3", "count = 0"},
      {"spec", "seed = 7", "seed = -1"},
      {"spec", "seed = 7", "sead = 7"},
      {"spec", "\"sobol\"", "\"sobel\""},
      {"spec", "\"poisson\"", "\"poison\""},
      {"spec", "completion = 1e-13", "completion = 1e-3"},
      {"spec", "[1e-2, 1e-3]", "[1e-2]"},
      {"spec", "normal = 1e-3", "normal = 0"},
      {"spec", "normal = 1e-3", "normal = 1\nuniform = [0, 1]"},
      {"spec", "normal = 1e-3", ""},
      {"spec", "points = 9\n", ""},
      {"spec", "points = 9\n", "points = 1\n"},
      {"spec", "normal = 1e-3", "normal = 1e-3\npoints = 3"},
      {"spec", "[\"mass\"]", "[\"mas\"]"},
      {"spec", "factor = 1.1\n", ""},
      {"spec", "names = [\"ode\"]\n", ""},
      {"spec", "steps = [0.01, 0.001]", "steps = [0.01, 0]"},
      {"system", "mass = 0.5", "mass = 0.0"},
      {"system", "[0.1, -0.5]", "[0.1, 0.0, 0.0, -0.5]"},
      {"system", "frequency = 1.5", "frequency = -1.5"},
      {"system", "frequency = 1.5", "omega = 1.5"},
      {"system", "amplitude = [0.1, 0.0]", "amplitude = 0.1"},
      {"system", ", values = [2.5, 1.5]", ""},
      {"system", "times = [0.5, 2.5], ", ""},
      {"system", "length = 5.5", "length = -5.5"},
      {"system", "length = 5.5", "length = {}"},
      {"system", "length = 5.5", "length = [5.5]"},
      {"system", "to = { body = \"hook\" }\n", ""},
      {"system", "to = { body = \"hook\" }\n", "to = {}\n"},
      {"system", "to = { body = \"hook\" }\n", "to = \"hook\"\n"},
      {"system", "from = { body = \"hook\" }", "anchor = [0.0, 0.0]"},
      {"system", "spline = true", "spline = 1"},
      {"system", "polynomial = [0.5, 0.75]", "polynomial = []"},
      {"system", "{ from = 0.25, polynomial", "{ polynomial"},
      {"system", "cut_at = 12.5", "cut_at = 0"},
      {"system", "drag = 0.1", "drag = -0.1"},
      {"system", "restitution = 0.9\n", ""},
      {"system", "restitution = 0.9\ncapture_speed = 1e-3", "stiffness = 0"},
      {"system", "restitution = 0.9\ncapture_speed = 1e-3", "stiffness = []"},
      {"system", "restitution = 0.9\ncapture_speed = 1e-3", "stiffness = [1.0, \"2\"]"},
      {"system", "restitution = 0.9\ncapture_speed = 1e-3", "stiffness = 1.0\ndamping = -1.0"},
      {"system", "restitution = 0.9\ncapture_speed = 1e-3", "damping = 1.0"},
      {"system", "restitution = 0.9", "restitution = 0.9\ndamping = 1.0"},
      {"system", "[[bodies]]\nname = \"load\"",
       "[initial]\nposition = [0, 0]\n[[bodies]]\nname = \"load\""},
      {"problems", "schema = 2\n", "schema = 1\n"},
      {"problems", "schema = 2\n", ""},
      {"problems", "version = \"4\"", "version = \"\""},
      {"problems", "version = \"4\"", "version = \"4\"\nlimits = []"},
      {"problems", "step = 0.01", "step = 0.0"},
      {"problems", "kind = \"failure\"", "kind = \"fialure\""},
      {"problems", "in_some = true", "in_some = 1"},
      {"problems", "reason = \"a singular system\"\n", ""},
      {"problems", "kind = \"restitution\"", "colour = \"red\""},
      {"contract", "\"quiet\"", "\"quite\""},
      {"contract", "reason = \"float\"", "since = \"ever\""},
      {"contract", "[\"accuracy\"]", "\"accuracy\""},
      {"contract", "[\"accuracy\"]", "[]"},
      {"contract", "model = \"row\"", "model = 3"},
      {"engine", "[\"node\", \"engine.mjs\"]", "\"node engine.mjs\""},
      {"engine", "[\"node\", \"engine.mjs\"]", "[\"node\", 3]"},
      {"engine", "lock = \"l\"", "lock = 1"},
      {"engine", "installed", "instaled"},
      {"engine", "name = \"mine\"\n", ""},
  };
  for (const auto& [kind, line, instead] : wrong) {
    std::string text = file_kinds().at(kind).sound;
    const std::size_t at = text.find(line);
    ASSERT_NE(at, std::string::npos) << kind << ": " << line;
    text.replace(at, line.size(), instead);
    EXPECT_FALSE(file_kinds().at(kind).problems(text).empty()) << text;
    EXPECT_NE(broken_rules(file_as_json(text), schema_of(kind)), "") << text;
  }
}

TEST(FileSchemas, AcceptElasticCables) {
  for (const std::string keys :
       {"stiffness = 10", "stiffness = [10.0, 0.0, 5.0]\ndamping = 1.0",
        "stiffness = 10.0\ndamping_ratio = 0.1", "stiffness = 10.0\nrestitution = 0.9"}) {
    const std::string line = "restitution = 0.9\ncapture_speed = 1e-3";
    std::string text = fuzz_seed("system.toml");
    text.replace(text.find(line), line.size(), keys);
    EXPECT_EQ(read_system_text(text, "f").problems, Sentences());
    EXPECT_EQ(broken_rules(file_as_json(text), schema_of("system")), "") << text;
  }
}

TEST(FileSchemas, AreOfCasesAsJsonToo) {
  for (const auto& entry : fs::directory_iterator(sources / "docs/guides/recipes")) {
    const SystemReading reading = read_system(entry.path());
    ASSERT_TRUE(reading.the_case || reading.system) << entry.path();
    json written = json::parse(reading.the_case ? write_case_json(*reading.the_case)
                                                : write_system_json(*reading.system));
    EXPECT_EQ(broken_rules(written, schema_of("case")), "") << entry.path();
    (reading.the_case ? written["body"] : written["bodies"][0])["mass"] = nullptr;
    EXPECT_NE(broken_rules(written, schema_of("case")), "");
  }
}

}  // namespace
}  // namespace tautline::test
