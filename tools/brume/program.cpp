#include "tools/brume/program.h"

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <iostream>
#include <new>
#include <numeric>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "brume/error.h"
#include "brume/version.h"
#include "core/io/disk/temporary_files.h"
#include "core/printable_text.h"
#include "render/util/frame_memory.h"
#include "tools/brume/interruption.h"

namespace brume {
namespace {

// How many letters must be added, left out, replaced or swapped with their neighbour.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before;  // the rows of the usual table for i - 2, i - 1 and i
  std::vector<std::size_t> above(b.size() + 1);
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(above.begin(), above.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      row[j] = std::min({above[j] + 1, row[j - 1] + 1, above[j - 1] + (a[i - 1] != b[j - 1])});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
        row[j] = std::min(row[j], before[j - 2] + 1);
      }
    }
    before = above;
    std::swap(above, row);
  }
  return above[b.size()];
}

// "; did you mean NAME?" for the name nearest to a mistyped word, "" if none is near.
std::string suggestion(std::string_view word, std::span<const std::string> names) {
  if (word.size() > 64) return {};
  std::size_t nearest = std::max<std::size_t>(2, word.size() / 3) + 1;
  std::string_view best;
  for (const std::string& name : names) {
    const std::size_t distance = edit_distance(word, name);
    if (distance < nearest && distance < name.size()) {
      nearest = distance;
      best = name;
    }
  }
  return best.empty() ? std::string() : "; did you mean " + std::string(best) + "?";
}

// Everything written to standard error except progress.
void print_line(const std::string& text) {
  std::cerr << "brume: " << printable(text) << std::endl;
}

int fail(std::string message) {
  while (message.ends_with('\n')) message.pop_back();
  print_line("error: " + message);
  return bad_input;
}

bool is_option(const std::string& argument) {
  return argument.size() > 1 && argument[0] == '-' &&
         (argument[1] == '-' || std::isalpha(static_cast<unsigned char>(argument[1])) != 0);
}

// CLI11 first complains of what is missing; a mistyped name is the better news, so it is looked
// for before parsing.
void check_names(const CLI::App& app, const std::vector<std::string>& arguments) {
  if (arguments.empty()) return;
  std::vector<std::string> commands;
  for (const CLI::App* command : app.get_subcommands({})) commands.push_back(command->get_name());
  const std::string& first = arguments.front();
  const auto it = std::find(commands.begin(), commands.end(), first);
  if (it == commands.end() && !is_option(first)) {
    throw UsageError("unknown subcommand " + first + suggestion(first, commands));
  }

  const CLI::App* scope = it == commands.end() ? &app : app.get_subcommand(first);
  std::vector<std::string> names;
  for (const CLI::Option* option : scope->get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    for (const std::string& name : option->get_snames()) names.push_back("-" + name);
  }
  for (const std::string& argument : arguments) {
    if (argument == "--") break;
    if (!is_option(argument)) continue;
    const bool is_long = argument[1] == '-';
    const std::string name =
        is_long ? argument.substr(0, argument.find('=')) : argument.substr(0, 2);
    if (std::find(names.begin(), names.end(), name) == names.end()) {
      throw UsageError("unknown option " + name + suggestion(name, names));
    }
  }
}

std::string version_text() {
  std::string text = std::string("brume ") + version();
  for (const auto& [name, value] : build_information()) text += "\n  " + name + ": " + value;
  return text;
}

int run(int argc, char** argv, std::span<const Subcommand> commands) {
  CLI::App app("Brume renders light in fog.", "brume");
  app.set_version_flag("--version", version_text, "print the version, and what it is built with");
  std::vector<std::pair<CLI::App*, std::unique_ptr<Command>>> made;
  for (const Subcommand& command : commands) {
    CLI::App* subcommand = app.add_subcommand(command.name, command.description);
    made.emplace_back(subcommand, command.make(*subcommand));
  }

  try {
    check_names(app, {argv + 1, argv + argc});
    app.parse(argc, argv);
  } catch (const CLI::Success& wish) {  // --help, --version
    std::ostringstream text;
    const int code = app.exit(wish, text, text);
    print_result(text.str());
    return code;
  } catch (const CLI::ParseError& error) {
    throw UsageError(error.what());
  }
  std::string names;
  for (const auto& [subcommand, command] : made) {
    if (subcommand->parsed()) return command->run();
    names += (names.empty() ? "" : ", ") + subcommand->get_name();
  }
  throw UsageError("a subcommand is missing: " + names + "; brume -h explains them");
}

}  // namespace

void print_result(const std::string& text) {
  errno = 0;
  std::cout << printable_lines(text) << std::flush;
  if (std::cout) return;
  throw InputError("standard output", "",
                   std::string("cannot be written") +
                       (errno == 0 ? std::string() : ": " + std::string(std::strerror(errno))));
}

void print_note(const std::string& text) {
  print_line(text);
}

void print_warnings(const std::vector<std::string>& warnings) {
  for (const std::string& warning : warnings) print_line("warning: " + warning);
}

int run_program(int argc, char** argv, std::span<const Subcommand> commands) {
  keep_frame_memory();
  remove_temporary_files_on_signals();
  try {
    const InterruptionWatch watch;
    return run(argc, argv, commands);
  } catch (const Interrupted&) {
    end_interrupted();
  } catch (const std::bad_alloc&) {
    return fail("not enough memory");
  } catch (const std::exception& error) {
    return fail(error.what());
  }
}

}  // namespace brume
