#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>

#include "bench/base/atomic_file.hpp"
#include "bench/base/listed.hpp"
#include "bench/base/terminal.hpp"
#include "bench/base/text.hpp"
#include "bench/program/commands.hpp"
#include "bench/program/common.hpp"
#include "bench/program/manual.hpp"

namespace tautline::bench {
namespace {

/// What `tautline help` was asked.
struct HelpCommand {
  std::string command;           // or empty: the program
  bool man = false;              // as a manual page
  std::string completion;        // of this shell, or empty
  std::filesystem::path folder;  // to write all of them to, or empty
};

/// All manual pages and scripts, where they lie below a share/ folder.
void write_manual(const Outline& outline, const std::filesystem::path& share) {
  write_file(share / "man/man1/tautline.1", man_page(outline));
  for (const Command& command : outline.commands) {
    write_file(share / ("man/man1/tautline-" + command.name + ".1"), man_page(outline, command));
  }
  write_file(share / "bash-completion/completions/tautline", completion_scripts().at("bash"));
  write_file(share / "zsh/site-functions/_tautline", completion_scripts().at("zsh"));
  write_file(share / "fish/vendor_completions.d/tautline.fish", completion_scripts().at("fish"));
}

int help_command(const HelpCommand& asked, const Outline& outline) {
  if (!asked.folder.empty()) {
    if (!std::filesystem::is_directory(asked.folder)) {
      complain({fmt::format("--write {}: is not a folder that exists",
                            printable(asked.folder.string()))});
      return exit_usage;
    }
    write_manual(outline, asked.folder);
    return exit_done;
  }
  if (!asked.completion.empty()) {
    fmt::print("{}", completion_scripts().at(asked.completion));
    return exit_done;
  }
  const std::size_t width = output_style().text;
  if (asked.command.empty()) {
    fmt::print("{}", asked.man ? man_page(outline) : help_text(outline, width));
    return exit_done;
  }
  const Command* const command = find_by(outline.commands, &Command::name, asked.command);
  if (command == nullptr) {
    complain({unknown_command(asked.command, outline)});
    return exit_usage;
  }
  fmt::print("{}", asked.man ? man_page(outline, *command) : help_text(*command, width));
  return exit_done;
}

}  // namespace

void add_help(CLI::App& app, int& code) {
  CLI::App* const command = app.add_subcommand(
      "help", "The help of a command, its manual page, and completion for a shell");
  const auto asked = std::make_shared<HelpCommand>();
  command->add_option("COMMAND", asked->command, "a command of tautline (default: all of them)");
  command->add_flag("--man", asked->man, "print the manual page, for `man -l -`");
  command->add_option("--completion", asked->completion, "print the completion for this shell")
      ->option_text("SHELL")
      ->check(CLI::IsMember(completion_scripts()));
  command
      ->add_option("--write", asked->folder,
                   "write all manual pages and completions below this folder, as they lie in "
                   "/usr/share")
      ->option_text("FOLDER");
  command->footer(
      "source <(tautline help --completion bash)    complete in this shell\n"
      "tautline help run --man | man -l -           a manual page without an installation");
  command->callback([asked, &app, &code] { code = help_command(*asked, outline_of(app)); });
}

}  // namespace tautline::bench
