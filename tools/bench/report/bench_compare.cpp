#include "tools/bench/report/bench_compare.h"

#include <algorithm>
#include <initializer_list>
#include <nlohmann/json.hpp>

#include "brume/error.h"
#include "tools/bench/measure/report_text.h"

namespace brume {
namespace {

using Json = nlohmann::json;

constexpr double tolerated = 1.05;

void compare_errors(const std::string& label, const Json& before, const Json& after,
                    std::vector<std::string>& lines) {
  const double high = before.at("error").at("high").get<double>();
  const double low = after.at("error").at("low").get<double>();
  if (low > high) {
    lines.push_back(label + formatted(": less accurate, now at least %.2f%%, before at most %.2f%%",
                                      100.0 * low, 100.0 * high));
  }
}

void compare_times(const std::string& label, const Json& before, const Json& after,
                   std::vector<std::string>& lines) {
  const double slowest = before.at("cpu_ms").at("max").get<double>();
  const double fastest = after.at("cpu_ms").at("min").get<double>();
  if (fastest > tolerated * slowest) {
    lines.push_back(label + formatted(": slower, now at least %.1f ms, before at most %.1f ms",
                                      fastest, slowest));
  }
}

void compare(const std::string& label, const Json& before, const Json& after,
             std::vector<std::string>& lines) {
  compare_times(label, before, after, lines);
  compare_errors(label, before, after, lines);
}

// Calls compare(old row, row) for the rows of a list of both reports that agree in some values.
void compare_rows(const Json& before, const Json& after, const char* list,
                  std::initializer_list<const char*> same, const auto& compare) {
  const Json& old_rows = before.at(list);
  for (const Json& row : after.at(list)) {
    for (const Json& old : old_rows) {
      if (std::ranges::all_of(same, [&](auto key) { return old.at(key) == row.at(key); })) {
        compare(old, row);
      }
    }
  }
}

std::string text(const Json& row, const char* key) {
  return row.at(key).get<std::string>();
}

void compare_scenes(const Json& before, const Json& after, std::vector<std::string>& lines) {
  compare_rows(before, after, "scenes", {"name", "size"}, [&](const Json& old, const Json& scene) {
    compare_rows(old, scene, "settings", {"setting"}, [&](const Json& known, const Json& setting) {
      compare(text(scene, "name") + ", " + text(setting, "setting"), known, setting, lines);
    });
  });
  compare_rows(before, after, "table_one", {"name"}, [&](const Json& old, const Json& row) {
    compare("Table 1, " + text(row, "name"), old, row, lines);
  });
}

}  // namespace

std::vector<std::string> compare_reports(const std::filesystem::path& old_file,
                                         std::string_view old_json, std::string_view new_json) {
  std::vector<std::string> lines;
  try {
    const Json before = Json::parse(old_json);
    const Json after = Json::parse(new_json);
    compare_scenes(before, after, lines);
    // Older reports lack some.
    const auto both_have = [&](const char* list) {
      return before.contains(list) && after.contains(list);
    };
    for (const char* section : {"patches", "noise", "lamp_light", "arriving_light", "transfer"}) {
      if (!both_have(section)) continue;
      compare_rows(before, after, section, {"what"}, [&](const Json& old, const Json& row) {
        compare_errors(text(row, "what"), old, row, lines);
      });
    }
    if (!both_have("caches")) return lines;
    compare_rows(before, after, "caches", {"cache", "scene"},
                 [&](const Json& old, const Json& row) {
                   compare_times(text(row, "scene") + ", " + text(row, "cache"), old, row, lines);
                 });
  } catch (const Json::exception& e) {
    throw InputError(old_file, "", std::string("is not a report of brume bench: ") + e.what());
  }
  return lines;
}

void check_report(const std::filesystem::path& file, std::string_view json) {
  compare_reports(file, json, json);
}

}  // namespace brume
