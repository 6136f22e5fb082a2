#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "brume/request_options.h"

namespace brume {

// The options of a RenderRequest (request_options()) on the command line.

void add_request_options(CLI::App& app);

// Sets what is given on the command line; `film`: the scene's. Throws UsageError.
RenderRequest request_of(const CLI::App& app, const Film& film);

// Sets one of them by its name. Throws UsageError.
void set_option(RenderRequest& request, const std::string& name, const std::string& text);

// The check of a numeric option: a number from `low` to `high`. CLI::Range lets NaN through.
CLI::Validator finite_in(double low, double high);

}  // namespace brume
