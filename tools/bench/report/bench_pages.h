#pragma once

#include <string>

#include "tools/bench/report/bench_report.h"

namespace brume {

// The report as a page of the manual: tables, and the command that made them.
std::string to_markdown(const BenchReport& report);

// The report as one HTML file that needs no other: plots as SVG, pictures embedded.
std::string to_html(const BenchReport& report);

}  // namespace brume
