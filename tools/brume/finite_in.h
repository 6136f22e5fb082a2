#pragma once

#include <CLI/CLI.hpp>

namespace brume {

// The check of a numeric option: a number from `low` to `high`. CLI::Range lets NaN through.
CLI::Validator finite_in(double low, double high);

}  // namespace brume
