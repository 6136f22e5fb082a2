#pragma once

#include <string>

#include "tools/bench/bench_run.h"

namespace brume {

// The report as one HTML file that needs no other: plots as SVG, pictures embedded.
std::string to_html(const BenchReport& report, const std::string& command);

}  // namespace brume
