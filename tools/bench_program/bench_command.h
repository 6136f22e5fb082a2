#pragma once

#include <filesystem>

#include "tools/brume/program.h"

namespace brume {

// `program` is the file of `brume`, whose renderings are measured as whole processes.
std::unique_ptr<Command> make_bench_command(CLI::App& app, const std::filesystem::path& program);

}  // namespace brume
