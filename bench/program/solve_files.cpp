#include "bench/program/solve_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>

#include "bench/base/text.hpp"
#include "bench/cases/catalogue.hpp"
#include "bench/plot/svg.hpp"

namespace tautline::bench {

bool names_case(const std::string& file) { return file.find(case_mark) != std::string::npos; }

std::string file_for(const std::string& file, const std::string& case_name) {
  std::string result = file;
  const std::size_t at = result.find(case_mark);
  if (at != std::string::npos) {
    std::string name = folder_name(case_name).string();
    std::replace(name.begin(), name.end(), '/', '-');
    result.replace(at, std::string(case_mark).size(), name);
  }
  return result;
}

std::vector<std::string> file_problems(const std::vector<OutputFile>& files,
                                       const std::vector<std::string>& cases) {
  std::vector<std::string> result;
  std::map<std::string, std::string> writers;  // option by file
  const bool several = cases.size() > 1;
  for (const OutputFile& output : files) {
    if (several && !output.takes_all && !names_case(output.file)) {
      result.push_back(
          fmt::format("{} {}: there are {} cases, and a file takes one; use {{case}} in its name "
                      "for the name of the case, as in {}",
                      output.option, printable(output.file), cases.size(),
                      output.option == "--csv" ? "'{case}.csv'" : "'{case}.svg'"));
      continue;
    }
    std::vector<std::string> names;
    for (const std::string& one : cases) {
      names.push_back(file_for(output.file, one));
    }
    names.erase(std::unique(names.begin(), names.end()), names.end());  // one list of all
    for (const std::string& name : names) {
      const std::string file =
          name == "-" ? name : std::filesystem::absolute(name).lexically_normal().string();
      const auto [writer, is_new] = writers.emplace(file, output.option);
      if (is_new) {
        continue;
      }
      result.push_back(
          name == "-" ? fmt::format("{} - and {} -: standard output takes one of them; give the "
                                    "other a file",
                                    writer->second, output.option)
          : writer->second == output.option
              ? fmt::format("{} {}: two pictures or cases would have this name; one would "
                            "overwrite the other",
                            output.option, printable(name))
              : fmt::format("{} and {} are both {}: one would overwrite the other", writer->second,
                            output.option, printable(name)));
    }
  }
  return result;
}

bool is_png(const std::string& file) { return file.ends_with(".png"); }

Picture picture_of(const std::string& asked) {
  for (const char* kind : {"path", "motion"}) {
    const std::string name = kind;
    const bool motion = name == "motion";
    if (asked == name) {
      return {motion, "-"};
    }
    if (asked.starts_with(name + "=")) {
      return {motion, asked.substr(name.size() + 1)};
    }
  }
  return {false, asked};
}

std::vector<std::string> picture_problems(const std::string& asked) {
  const Picture picture = picture_of(asked);
  if (picture.file.empty()) {
    return {fmt::format("--plot \"{}\": must be the name of a file, or -", printable(asked))};
  }
  const std::size_t equals = asked.find('=');
  if (picture.file == asked && equals != std::string::npos && asked.find_first_of("./") > equals) {
    return {fmt::format(
        "--plot {}: there is no picture {}; draw path=FILE or motion=FILE, or name the file ./{}",
        printable(asked), printable(asked.substr(0, equals)), printable(asked))};
  }
  if (is_png(picture.file) && !makes_png()) {
    return {fmt::format(
        "--plot {}: this build makes no PNG pictures, because librsvg (Debian: librsvg2-dev) was "
        "not there; name a file that ends in .svg",
        printable(asked))};
  }
  return {};
}

}  // namespace tautline::bench
