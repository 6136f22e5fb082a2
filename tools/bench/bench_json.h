#pragma once

#include <string>

#include "tools/bench/bench_run.h"

namespace brume {

// The report as JSON: all numbers, no pictures. compare_reports() reads it.
std::string to_json(const BenchReport& report);

// The name of the processor, as Linux tells it.
std::string device_name();

}  // namespace brume
