#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace brume {

// Regressions between two reports written by to_json(), one line each: CPU time if even the fastest
// new frame takes over 5% more than the slowest old one, errors if the intervals do not overlap.
// Settings present in one only are ignored. Throws InputError naming `old_file` if its text is no
// report.
std::vector<std::string> compare_reports(const std::filesystem::path& old_file,
                                         std::string_view old_json, std::string_view new_json);

// Throws InputError naming `file` if a report lacks anything that compare_reports() asks of an old
// one.
void check_report(const std::filesystem::path& file, std::string_view json);

}  // namespace brume
