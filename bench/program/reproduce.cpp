#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <utility>

#include "bench/base/atomic_file.hpp"
#include "bench/base/progress.hpp"
#include "bench/base/table.hpp"
#include "bench/base/terminal.hpp"
#include "bench/program/commands.hpp"
#include "bench/program/common.hpp"
#include "bench/store/tree.hpp"
#include "bench/tools/reproduce/output.hpp"
#include "tautline/scenarios.hpp"

namespace tautline::bench {
namespace {

/// What `tautline reproduce` was asked.
struct ReproduceCommand {
  std::filesystem::path out = "results";
  std::string json;
};

/// Everything but chapter.json, which comes last: a folder with it is whole.
void write_files(const ChapterReport& report, const std::filesystem::path& out) {
  const std::filesystem::path folder = out / "chapter";
  for (const ChapterTable& table : report.tables) {
    write_file(folder / table.file, table_csv(table));
  }
  for (const ChapterFigure& figure : report.figures) {
    write_file(folder / figure.file, data_csv(figure.data));
    if (figure.boundary) {
      write_file(folder / figure.boundary->file, data_csv(figure.boundary->data));
    }
  }
  write_file(folder / "corrections.csv", corrections_csv(report.corrections));
  write_file(out / "chapter.md", chapter_markdown(report));
  write_file(out / "chapter.html", chapter_page(report, page_assets()));
}

int reproduce_command(const ReproduceCommand& command) {
  if (command.out.empty()) {
    complain({"--out: is empty; give a folder to write the chapter to"});
    return exit_usage;
  }
  std::vector<std::string> broken = missing_folder("--json", command.json, command.out);
  if (auto problem = tree_problem(command.out)) {
    broken.push_back(std::move(*problem));
  }
  if (complain(broken)) {
    return exit_usage;
  }
  // the runs and the report of `tautline bench` in the same folder stay
  const Descriptor tree = open_tree(command.out, false);
  const std::size_t cases = table_5_1().size();
  Progress progress(static_cast<double>(cases), cases, "cases");
  const ChapterStudy study = solve_chapter([&](std::size_t) { progress.ended(1.0); });
  progress.finish();
  const ChapterReport report = chapter_report(study);
  write_files(report, command.out);
  const std::string json = chapter_json(report);
  write_file(command.out / "chapter.json", json);
  if (!command.json.empty()) {
    write_output(command.json, json);
  }
  if (command.json != "-") {
    const auto wrong = std::count_if(report.corrections.begin(), report.corrections.end(),
                                     [](const Correction& one) { return !one.holds; });
    const std::string said = fmt::format(
        "{} cases, {} tables, {} figures, {} corrections: {}, with chapter.md and chapter.json "
        "next to it",
        study.cases.size(), report.tables.size(), report.figures.size(), wrong,
        (command.out / "chapter.html").string());
    fmt::print("{}", wrapped(said, output_style().text));
  }
  return exit_done;
}

}  // namespace

void add_reproduce(CLI::App& app, int& code) {
  CLI::App* const command = app.add_subcommand(
      "reproduce", "The source chapter's tables and figures, and what it got wrong");
  const auto asked = std::make_shared<ReproduceCommand>();
  command->add_option("--out", asked->out, "folder for chapter.md, chapter.json and chapter/")
      ->option_text("FOLDER")
      ->capture_default_str();
  add_target(*command, "--json", asked->json, "also write chapter.json");
  command->callback([asked, &code] { code = reproduce_command(*asked); });
}

}  // namespace tautline::bench
