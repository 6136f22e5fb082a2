#include "tools/bench/bench_json.h"

#include <fstream>
#include <nlohmann/json.hpp>

namespace brume {
namespace {

using Json = nlohmann::ordered_json;

Json to_json(const Spread& spread) {
  return {{"median", spread.median}, {"min", spread.least}, {"max", spread.greatest}};
}

Json to_json(const Measurement& m) {
  Json json;
  json["setting"] = m.setting;
  json["frame_ms"] = to_json(m.milliseconds);
  json["cpu_ms"] = to_json(m.cpu_milliseconds);
  json["first_frame_ms"] = m.first_milliseconds;
  json["error"] = {{"rel_rmse", m.error.rel_rmse},
                   {"low", m.error.low},
                   {"high", m.error.high},
                   {"pixels", m.error.pixels}};
  json["view_pairs"] = m.pairs;
  Json stages = Json::array();
  for (const StageTime& stage : m.stages) {
    stages.push_back({{"name", stage.name}, {"ms", stage.milliseconds}});
  }
  json["stages"] = std::move(stages);
  return json;
}

Json to_json(const SceneReport& scene) {
  Json json;
  json["name"] = scene.name;
  json["gaussians"] = scene.gaussians;
  json["lights"] = scene.lights;
  json["environment"] = scene.environment;
  json["size"] = {scene.film.width, scene.film.height};
  json["reference_cpu_ms"] = scene.reference_cpu_milliseconds;
  Json settings = Json::array();
  for (const Measurement& m : scene.settings) settings.push_back(to_json(m));
  json["settings"] = std::move(settings);
  Json fastest = Json::array();
  for (const double level : bench_error_levels) {
    const auto best = cheapest_within(scene.settings, level);
    fastest.push_back(
        {{"max_error", level},
         {"setting", best ? Json(scene.settings[*best].setting) : Json(nullptr)},
         {"cpu_ms", best ? Json(scene.settings[*best].cpu_milliseconds.median) : Json(nullptr)}});
  }
  json["fastest"] = std::move(fastest);
  return json;
}

}  // namespace

std::string device_name() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);) {
    if (!line.starts_with("model name")) continue;
    const std::size_t begin = line.find_first_not_of(" \t:", line.find(':'));
    if (begin != std::string::npos) return line.substr(begin);
  }
  return "unknown";
}

std::string to_json(const BenchReport& report) {
  Json json;
  json["version"] = BRUME_VERSION;
  json["device"] = device_name();
  json["backend"] = "cpu";
  json["threads"] = report.threads;
  json["quick"] = report.quick;
  Json scenes = Json::array();
  for (const SceneReport& scene : report.scenes) scenes.push_back(to_json(scene));
  json["scenes"] = std::move(scenes);
  Json curves = Json::array();
  for (const CostCurve& curve : report.curves) {
    Json points = Json::array();
    for (const CostPoint& p : curve.points) {
      points.push_back({{"size", p.size}, {"cpu_ms", p.cpu_milliseconds}});
    }
    curves.push_back({{"over", curve.over}, {"exponent", curve.exponent}, {"points", points}});
  }
  json["curves"] = std::move(curves);
  Json rows = Json::array();
  for (const TableOneRow& row : report.table_one) {
    Json entry = to_json(row.measurement);
    entry["name"] = row.name;
    entry["fps"] = 1e3 / row.measurement.milliseconds.median;
    entry["paper_fps"] = row.paper_fps;
    rows.push_back(std::move(entry));
  }
  json["table_one"] = std::move(rows);
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace brume
