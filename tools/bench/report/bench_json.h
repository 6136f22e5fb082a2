#pragma once

#include <string>

#include "tools/bench/report/bench_report.h"

namespace brume {

// The report as JSON: all numbers, no pictures. compare_reports() reads it.
std::string to_json(const BenchReport& report);

}  // namespace brume
