#include "tools/bench/report/bench_json.h"

#include <nlohmann/json.hpp>

#include "brume/version.h"
#include "render/util/device_name.h"

namespace brume {
namespace {

using OrderedJson = nlohmann::ordered_json;

OrderedJson to_json(const Spread& spread) {
  return {{"median", spread.median}, {"min", spread.min}, {"max", spread.max}};
}

OrderedJson to_json(const Quartiles& quartiles) {
  return {{"median", quartiles.median}, {"lower", quartiles.lower}, {"upper", quartiles.upper}};
}

OrderedJson to_json(const std::vector<CacheGain>& gains) {
  OrderedJson json = OrderedJson::array();
  for (const CacheGain& gain : gains) {
    json.push_back({{"cache", gain.cache},
                    {"scene", gain.scene},
                    {"with_ms", to_json(gain.with_ms)},
                    {"without_ms", to_json(gain.without_ms)},
                    {"cpu_ms", to_json(gain.with_cpu_ms)},
                    {"gain", to_json(gain.gain)},
                    {"lines", gain.code.lines},
                    {"files", gain.code.files},
                    {"change", gain.change}});
  }
  return json;
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

OrderedJson to_json(const KernelShare& share) {
  return {{"limit_per_second", to_json(share.limit_per_second)},
          {"of_limit", to_json(share.of_limit)},
          {"of_limit_with_pairs", to_json(share.of_limit_with_pairs)},
          {"sum_of_limit", to_json(share.sum_of_limit)},
          {"increments_per_pair", share.increments_per_pair},
          {"used_lanes", share.used_lanes}};
}

OrderedJson to_json(const ErrorEstimate& error) {
  return {{"rel_rmse", error.rel_rmse},
          {"low", error.low},
          {"high", error.high},
          {"pixels", error.pixels}};
}

OrderedJson to_json(const std::vector<ComparedError>& rows) {
  OrderedJson json = OrderedJson::array();
  for (const ComparedError& row : rows) {
    json.push_back({{"what", row.label}, {"error", to_json(row.error)}});
    if (row.other) json.back()["other"] = to_json(*row.other);
  }
  return json;
}

OrderedJson to_json(const Measurement& m) {
  OrderedJson json;
  json["setting"] = m.setting;
  json["frame_ms"] = to_json(m.milliseconds);
  json["cpu_ms"] = to_json(m.cpu_milliseconds);
  json["first_frame_ms"] = m.first_milliseconds;
  json["first_frame_cpu_ms"] = m.first_cpu_milliseconds;
  json["error"] = to_json(m.error);
  json["view_pairs"] = m.pairs;
  OrderedJson stages = OrderedJson::array();
  for (const StageTime& stage : m.stages) {
    stages.push_back({{"name", to_string(stage.stage)}, {"ms", stage.milliseconds}});
  }
  json["stages"] = std::move(stages);
  return json;
}

OrderedJson to_json(const SceneReport& scene) {
  OrderedJson json;
  json["name"] = scene.name;
  json["gaussians"] = scene.gaussians;
  json["lights"] = scene.lights;
  json["environment"] = scene.environment;
  json["size"] = {scene.film.width, scene.film.height};
  json["reference_cpu_ms"] = scene.reference_cpu_milliseconds;
  OrderedJson settings = OrderedJson::array();
  for (const Measurement& m : scene.settings) settings.push_back(to_json(m));
  json["settings"] = std::move(settings);
  OrderedJson on_gl = OrderedJson::array();
  for (const Measurement& m : scene.on_gl) on_gl.push_back(to_json(m));
  json["on_gl"] = std::move(on_gl);
  OrderedJson peers = OrderedJson::array();
  for (const OtherRendererRow& peer : scene.peers) {
    peers.push_back({{"program", peer.program},
                     {"setting", peer.setting},
                     {"cpu_ms", peer.cpu_milliseconds},
                     {"rel_rmse", peer.rel_rmse}});
  }
  json["peers"] = std::move(peers);
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
  OrderedJson scenes = OrderedJson::array();
  for (const SceneReport& scene : report.scenes) scenes.push_back(to_json(scene));
  json["scenes"] = std::move(scenes);
  OrderedJson thickness = OrderedJson::array();
  for (const ThicknessRow& row : report.thickness) {
    thickness.push_back({{"factor", row.factor},
                         {"max_depth", row.max_depth},
                         {"paper", to_json(row.paper)},
                         {"energy", to_json(row.energy)},
                         {"sliced", to_json(row.sliced)}});
  }
  json["thickness"] = std::move(thickness);
  OrderedJson skies = OrderedJson::array();
  for (const SkyRow& row : report.skies) {
    skies.push_back({{"gaussians", row.gaussians},
                     {"depth", row.depth},
                     {"anisotropy", row.anisotropy},
                     {"even", to_json(row.even)},
                     {"sunny", to_json(row.sunny)}});
  }
  json["skies"] = std::move(skies);
  json["patches"] = to_json(report.patches);
  OrderedJson glow = OrderedJson::array();
  for (const InscatteringRow& row : report.glow) {
    glow.push_back({{"depth", row.depth}, {"share", row.share}});
  }
  json["glow"] = std::move(glow);
  OrderedJson scales = OrderedJson::array();
  for (const ScaleRow& row : report.scales) {
    scales.push_back({{"name", row.scene},
                      {"scale", row.scale},
                      {"computed", row.computed},
                      {"change", row.change}});
  }
  json["airlight_scale"] = std::move(scales);
  OrderedJson all_orders = OrderedJson::array();
  for (const AllOrdersRow& row : report.all_orders) {
    all_orders.push_back({{"name", row.scene},
                          {"single", row.single},
                          {"multiple", row.multiple},
                          {"noise", row.noise},
                          {"sweeps", row.sweeps},
                          {"solve_ms", row.solve_milliseconds},
                          {"edit_ms", row.edit_milliseconds},
                          {"camera_ratio", to_json(row.camera_ratio)},
                          {"megabytes", row.megabytes}});
  }
  json["all_orders"] = std::move(all_orders);
  OrderedJson light_kinds = OrderedJson::array();
  for (const LightKindRow& row : report.light_kinds) {
    light_kinds.push_back({{"name", row.kind},
                           {"error", row.error},
                           {"camera_ratio", to_json(row.camera_ratio)},
                           {"edit_ratio", to_json(row.edit_ratio)}});
  }
  json["light_kinds"] = std::move(light_kinds);
  OrderedJson samples = OrderedJson::array();
  for (const SampleRow& row : report.samples) {
    samples.push_back({{"name", row.scene},
                       {"one", row.one},
                       {"chosen", row.chosen},
                       {"sampled", row.sampled},
                       {"pairs_ratio", row.pairs},
                       {"camera_ratio", row.time}});
  }
  json["samples"] = std::move(samples);
  OrderedJson noise_depths = OrderedJson::array();
  for (const NoiseDepthRow& row : report.noise_depths) {
    noise_depths.push_back(
        {{"cells", row.cells}, {"afar", to_json(row.afar)}, {"near", to_json(row.near)}});
  }
  json["noise_depths"] = std::move(noise_depths);
  json["noise"] = to_json(report.noise);
  json["lamp_light"] = to_json(report.point_light);
  json["arriving_light"] = to_json(report.incident_light);
  json["transfer"] = to_json(report.transfer);
  OrderedJson curves = OrderedJson::array();
  for (const CostCurve& curve : report.curves) {
    OrderedJson points = OrderedJson::array();
    for (const CostPoint& p : curve.points) {
      points.push_back({{"size", p.size}, {"cpu_ms", p.cpu_milliseconds}});
    }
    curves.push_back({{"over", curve.over}, {"exponent", curve.exponent}, {"points", points}});
  }
  json["curves"] = std::move(curves);
  OrderedJson threads = OrderedJson::array();
  for (const ThreadRow& row : report.thread_rows) {
    threads.push_back({{"threads", row.threads}, {"frame_ms", to_json(row.milliseconds)}});
  }
  json["thread_rows"] = std::move(threads);
  OrderedJson banks = OrderedJson::array();
  for (const FogBankRow& row : report.fog_banks) {
    OrderedJson entry = to_json(row.measurement);
    entry["gaussians"] = row.gaussians;
    entry["merged"] = row.merged;
    entry["unmerged_ratio"] = to_json(row.unmerged_ratio);
    banks.push_back(std::move(entry));
  }
  json["fog_banks"] = std::move(banks);
  OrderedJson shot = OrderedJson::array();
  for (const ShotRow& row : report.shot) {
    shot.push_back({{"workers", row.workers},
                    {"seconds", row.seconds},
                    {"frames_per_hour", row.frames_per_hour},
                    {"lost", row.lost}});
  }
  json["shot"] = std::move(shot);
  OrderedJson savings = OrderedJson::array();
  for (const PlanSaving& saving : report.savings) {
    savings.push_back({{"stage", to_string(saving.stage)},
                       {"why", saving.why},
                       {"left_out_cpu_ms", to_json(saving.left_out)},
                       {"made_cpu_ms", to_json(saving.made)},
                       {"change", saving.change}});
  }
  json["left_out"] = std::move(savings);
  OrderedJson hard_cases = OrderedJson::array();
  for (const HardCaseRow& row : report.hard_cases) hard_cases.push_back(to_json(row));
  json["hard_cases"] = std::move(hard_cases);
  OrderedJson rows = OrderedJson::array();
  for (const TableOneRow& row : report.table_one) {
    OrderedJson entry = to_json(row.measurement);
    entry["name"] = row.name;
    entry["fps"] = 1e3 / row.measurement.milliseconds.median;
    entry["paper_fps"] = row.paper_fps;
    entry["kernel"] = to_json(row.share);
    entry["all_orders_ratio"] = to_json(row.all_orders_ratio);
    rows.push_back(std::move(entry));
  }
  json["table_one"] = std::move(rows);
  json["caches"] = to_json(report.caches);
  return json.dump(2, ' ', false, OrderedJson::error_handler_t::replace) + "\n";
}

}  // namespace brume
