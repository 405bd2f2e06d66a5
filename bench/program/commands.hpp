#pragma once

#include <string>

namespace CLI {
class App;
}

namespace tautline::bench {

// Each adds one command and its options to the program. Where the command line names that command,
// it runs while `app` parses, and `code`, which must outlive `app`, gets its exit code.

void add_solve(CLI::App& app, int& code);
void add_vector(CLI::App& app, int& code);
void add_run(CLI::App& app, int& code);
void add_bench(CLI::App& app, int& code, const std::string& command_line);  // as it was typed
void add_merge(CLI::App& app, int& code, const std::string& command_line);
void add_compare(CLI::App& app, int& code);
void add_trend(CLI::App& app, int& code, const std::string& command_line);
void add_ensemble(CLI::App& app, int& code);
void add_bridge(CLI::App& app, int& code);
void add_check(CLI::App& app, int& code);
void add_calibrate(CLI::App& app, int& code);
void add_reproduce(CLI::App& app, int& code);
void add_engines(CLI::App& app, int& code);
void add_cases(CLI::App& app, int& code);
void add_schema_command(CLI::App& app);
void add_help(CLI::App& app, int& code);

}  // namespace tautline::bench
