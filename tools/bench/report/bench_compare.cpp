#include "tools/bench/report/bench_compare.h"

#include <cstdio>
#include <nlohmann/json.hpp>

#include "brume/error.h"

namespace brume {
namespace {

using Json = nlohmann::json;

constexpr double tolerated = 1.05;

std::string percent(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2f%%", 100.0 * x);
  return text;
}

std::string milliseconds(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1f ms", x);
  return text;
}

void compare_errors(const std::string& label, const Json& before, const Json& after,
                    std::vector<std::string>& lines) {
  const double high = before.at("error").at("high").get<double>();
  const double low = after.at("error").at("low").get<double>();
  if (low > high) {
    lines.push_back(label + ": less accurate, now at least " + percent(low) + ", before at most " +
                    percent(high));
  }
}

void compare_times(const std::string& label, const Json& before, const Json& after,
                   std::vector<std::string>& lines) {
  const double slowest = before.at("cpu_ms").at("max").get<double>();
  const double fastest = after.at("cpu_ms").at("min").get<double>();
  if (fastest > tolerated * slowest) {
    lines.push_back(label + ": slower, now at least " + milliseconds(fastest) +
                    ", before at most " + milliseconds(slowest));
  }
}

void compare(const std::string& label, const Json& before, const Json& after,
             std::vector<std::string>& lines) {
  compare_times(label, before, after, lines);
  compare_errors(label, before, after, lines);
}

void compare_scenes(const Json& before, const Json& after, std::vector<std::string>& lines) {
  const Json& old_scenes = before.at("scenes");
  const Json& old_rows = before.at("table_one");
  for (const Json& scene : after.at("scenes")) {
    for (const Json& old : old_scenes) {
      if (old.at("name") != scene.at("name") || old.at("size") != scene.at("size")) continue;
      for (const Json& setting : scene.at("settings")) {
        for (const Json& known : old.at("settings")) {
          if (known.at("setting") != setting.at("setting")) continue;
          compare(
              scene.at("name").get<std::string>() + ", " + setting.at("setting").get<std::string>(),
              known, setting, lines);
        }
      }
    }
  }
  for (const Json& row : after.at("table_one")) {
    for (const Json& old : old_rows) {
      if (old.at("name") != row.at("name")) continue;
      compare("Table 1, " + row.at("name").get<std::string>(), old, row, lines);
    }
  }
}

// Rows identified by their label. Older reports do not have them.
void compare_rows(const char* section, const Json& before, const Json& after,
                  std::vector<std::string>& lines) {
  if (!before.contains(section) || !after.contains(section)) return;
  for (const Json& row : after.at(section)) {
    for (const Json& old : before.at(section)) {
      if (old.at("what") != row.at("what")) continue;
      compare_errors(row.at("what").get<std::string>(), old, row, lines);
    }
  }
}

// Frames with a cache. Older reports do not have them.
void compare_caches(const Json& before, const Json& after, std::vector<std::string>& lines) {
  if (!before.contains("caches") || !after.contains("caches")) return;
  for (const Json& row : after.at("caches")) {
    for (const Json& old : before.at("caches")) {
      if (old.at("cache") != row.at("cache") || old.at("scene") != row.at("scene")) continue;
      compare_times(row.at("scene").get<std::string>() + ", " + row.at("cache").get<std::string>(),
                    old, row, lines);
    }
  }
}

}  // namespace

std::vector<std::string> compare_reports(const std::filesystem::path& old_file,
                                         std::string_view old_json, std::string_view new_json) {
  std::vector<std::string> lines;
  try {
    const Json before = Json::parse(old_json);
    const Json after = Json::parse(new_json);
    compare_scenes(before, after, lines);
    for (const char* section : {"patches", "noise", "lamp_light", "arriving_light", "transfer"}) {
      compare_rows(section, before, after, lines);
    }
    compare_caches(before, after, lines);
  } catch (const Json::exception& e) {
    throw InputError(old_file, "", std::string("is not a report of brume bench: ") + e.what());
  }
  return lines;
}

void check_report(const std::filesystem::path& file, std::string_view json) {
  compare_reports(file, json, json);
}

}  // namespace brume
