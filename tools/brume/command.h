#pragma once

#include <CLI/CLI.hpp>
#include <memory>
#include <stdexcept>

namespace brume {

// The exit codes of the program.
enum ExitCode : int { done = 0, check_failed = 1, bad_input = 2 };

// A mistake on the command line; what() is one line.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// A subcommand: declares its options on `app` when made; run() is called once they are parsed.
class Command {
 public:
  virtual ~Command() = default;
  virtual ExitCode run() = 0;
};

std::unique_ptr<Command> make_render_command(CLI::App& app);
std::unique_ptr<Command> make_compare_command(CLI::App& app);
std::unique_ptr<Command> make_info_command(CLI::App& app);
std::unique_ptr<Command> make_fit_command(CLI::App& app);
std::unique_ptr<Command> make_export_command(CLI::App& app);
std::unique_ptr<Command> make_gather_command(CLI::App& app);
std::unique_ptr<Command> make_submit_command(CLI::App& app);

// Writes a result to standard output, its lines printable (core/printable_text.h). Throws
// InputError if it cannot be written.
void print_result(const std::string& text);
// A line on standard error: "brume: ...".
void print_note(const std::string& text);
// A line on standard error for each: "brume: warning: ...".
void print_warnings(const std::vector<std::string>& warnings);

}  // namespace brume
