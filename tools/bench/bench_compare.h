#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace brume {

// What got slower or less accurate from an old report to a new one, both as to_json() writes them,
// a line for each: CPU time counts where even the fastest of the new frames takes over 5% more than
// the slowest of the old, the error where the intervals do not touch. Settings that only one of
// them has are left out. Throws InputError naming `old_file` if its text is no report.
std::vector<std::string> compare_reports(const std::filesystem::path& old_file,
                                         std::string_view old_json, std::string_view new_json);

// Throws InputError naming `file` if a report lacks anything that compare_reports() asks of an old
// one.
void check_report(const std::filesystem::path& file, std::string_view json);

}  // namespace brume
