#include "tools/bench/report/bench_json.h"

#include <nlohmann/json.hpp>

#include "brume/version.h"
#include "render/util/device_name.h"
#include "tools/bench/report/error_sections.h"

namespace brume {
namespace {

using OrderedJson = nlohmann::ordered_json;

OrderedJson to_json(const Spread& spread) {
  return {{"median", spread.median}, {"min", spread.min}, {"max", spread.max}};
}

OrderedJson to_json(const Quartiles& quartiles) {
  return {{"median", quartiles.median}, {"lower", quartiles.lower}, {"upper", quartiles.upper}};
}

OrderedJson to_json(const CacheGain& gain) {
  return {{"cache", gain.cache},
          {"scene", gain.scene},
          {"with_ms", to_json(gain.with_ms)},
          {"without_ms", to_json(gain.without_ms)},
          {"cpu_ms", to_json(gain.with_cpu_ms)},
          {"gain", to_json(gain.gain)},
          {"lines", gain.code.lines},
          {"files", gain.code.files},
          {"change", gain.change}};
}

OrderedJson to_json(const HardCaseError& error) {
  return {{"airlight", error.airlight}, {"transmittance", error.transmittance}};
}

OrderedJson to_json(const HardCaseRow& row) {
  OrderedJson json;
  json["name"] = row.hard_case.name;
  json["bound"] = row.hard_case.bound;
  json["auto"] = {{"airlight", row.errors.automatic.airlight},
                  {"is_told", row.errors.automatic.is_told}};
  json["reference"] = to_json(row.errors.reference);
  json["sliced"] = to_json(row.errors.sliced);
  if (row.errors.gl) json["gl"] = to_json(*row.errors.gl);
  json["paper"] = row.errors.paper;
  return json;
}

OrderedJson to_json(const ErrorEstimate& error) {
  return {{"rel_rmse", error.rel_rmse},
          {"low", error.low},
          {"high", error.high},
          {"pixels", error.pixels}};
}

OrderedJson to_json(const StageTime& stage) {
  return {{"name", to_string(stage.stage)}, {"ms", stage.milliseconds}};
}

template <class Row>
OrderedJson to_json(const std::vector<Row>& rows);

OrderedJson to_json(const Measurement& m) {
  OrderedJson json;
  json["setting"] = m.setting;
  json["frame_ms"] = to_json(m.milliseconds);
  json["cpu_ms"] = to_json(m.cpu_milliseconds);
  json["first_frame_ms"] = m.first_milliseconds;
  json["first_frame_cpu_ms"] = m.first_cpu_milliseconds;
  json["error"] = to_json(m.error);
  json["view_pairs"] = m.pairs;
  json["stages"] = to_json(m.stages);
  return json;
}

OrderedJson to_json(const OtherRendererRow& peer) {
  return {{"program", peer.program},
          {"setting", peer.setting},
          {"cpu_ms", peer.cpu_milliseconds},
          {"rel_rmse", peer.rel_rmse}};
}

OrderedJson to_json(const SceneReport& scene) {
  OrderedJson json;
  json["name"] = scene.name;
  json["gaussians"] = scene.gaussians;
  json["lights"] = scene.lights;
  json["environment"] = scene.environment;
  json["size"] = {scene.film.width, scene.film.height};
  json["reference_cpu_ms"] = scene.reference_cpu_milliseconds;
  json["settings"] = to_json(scene.settings);
  json["on_gl"] = to_json(scene.on_gl);
  json["peers"] = to_json(scene.peers);
  OrderedJson fastest = OrderedJson::array();
  for (const double level : bench_error_levels) {
    const auto best = cheapest_within(scene.settings, level);
    fastest.push_back(
        {{"max_error", level},
         {"setting", best ? OrderedJson(scene.settings[*best].setting) : OrderedJson(nullptr)},
         {"cpu_ms", best ? OrderedJson(scene.settings[*best].cpu_milliseconds.median)
                         : OrderedJson(nullptr)}});
  }
  json["fastest"] = std::move(fastest);
  return json;
}

OrderedJson to_json(const ThreadRow& row) {
  return {{"threads", row.threads}, {"frame_ms", to_json(row.milliseconds)}};
}

OrderedJson to_json(const FogBankRow& row) {
  OrderedJson entry = to_json(row.measurement);
  entry["gaussians"] = row.gaussians;
  entry["merged"] = row.merged;
  entry["unmerged_ratio"] = to_json(row.unmerged_ratio);
  return entry;
}

OrderedJson to_json(const PlanSaving& saving) {
  return {{"stage", to_string(saving.stage)},
          {"why", saving.why},
          {"left_out_cpu_ms", to_json(saving.left_out)},
          {"made_cpu_ms", to_json(saving.made)},
          {"change", saving.change}};
}

OrderedJson to_json(const TableOneRow& row) {
  OrderedJson entry = to_json(row.measurement);
  entry["name"] = row.name;
  entry["fps"] = 1e3 / row.measurement.milliseconds.median;
  entry["paper_fps"] = row.paper_fps;
  entry["all_orders_ratio"] = to_json(row.all_orders_ratio);
  return entry;
}

OrderedJson to_json(const CostPoint& point) {
  return {{"size", point.size}, {"cpu_ms", point.cpu_milliseconds}};
}

OrderedJson to_json(const CostCurve& curve) {
  return {{"over", curve.over}, {"exponent", curve.exponent}, {"points", to_json(curve.points)}};
}

template <class Row>
OrderedJson to_json(const std::vector<Row>& rows) {
  OrderedJson json = OrderedJson::array();
  for (const Row& row : rows) json.push_back(to_json(row));
  return json;
}

void add(OrderedJson& entry, const char* key, const auto& value) {
  if constexpr (requires { to_json(value); }) {
    entry[key] = to_json(value);
  } else {
    entry[key] = value;
  }
}

void add(OrderedJson& entry, const char* key, const std::optional<ErrorEstimate>& error) {
  if (error) entry[key] = to_json(*error);
}

}  // namespace

std::string to_json(const BenchReport& report) {
  OrderedJson json;
  json["version"] = version();
  json["device"] = device_name();
  json["command"] = report.command;
  json["backends"] = OrderedJson::array({"cpu"});
  if (!report.gl_device.empty()) {
    json["backends"].push_back("gl");
    json["gl_device"] = report.gl_device;
  }
  json["threads"] = report.threads;
  json["quick"] = report.quick;
  json["scenes"] = to_json(report.scenes);
  visit_error_sections(report, [&](const char* key, const auto& rows, const char*, const char*,
                                   const auto&... columns) {
    OrderedJson& list = json[key] = OrderedJson::array();
    for (const auto& row : rows) {
      OrderedJson& entry = list.emplace_back();
      (add(entry, columns.key, row.*columns.value), ...);
    }
  });
  json["curves"] = to_json(report.curves);
  json["thread_rows"] = to_json(report.thread_rows);
  json["fog_banks"] = to_json(report.fog_banks);
  json["left_out"] = to_json(report.savings);
  json["hard_cases"] = to_json(report.hard_cases);
  json["table_one"] = to_json(report.table_one);
  json["caches"] = to_json(report.caches);
  return json.dump(2, ' ', false, OrderedJson::error_handler_t::replace) + "\n";
}

}  // namespace brume
