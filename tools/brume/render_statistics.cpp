#include "tools/brume/render_statistics.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <vector>

#include "brume/render.h"
#include "brume/version.h"
#include "core/math/spread.h"
#include "render/util/device_name.h"

namespace brume {
namespace {

using Json = nlohmann::ordered_json;

// `low` and `high`: 95% confidence intervals.
Json estimate_json(const ErrorEstimate& error) {
  return {
      {"rel_rmse", error.rel_rmse},
      {"pixels", error.pixels},
      {"low", error.low},
      {"high", error.high},
      {"blocks",
       Json{{"median", error.block_median}, {"low", error.block_low}, {"high", error.block_high}}}};
}

// Each stage's median, in the order in which stages first ran.
Json stage_medians(std::span<const FrameStatistics> frames) {
  std::vector<Stage> names;
  for (const FrameStatistics& frame : frames) {
    for (const StageTime& stage : frame.stages) {
      if (std::find(names.begin(), names.end(), stage.stage) == names.end()) {
        names.push_back(stage.stage);
      }
    }
  }
  Json stages = Json::array();
  for (const Stage name : names) {
    std::vector<double> times;
    for (const FrameStatistics& frame : frames) {
      double time = 0.0;  // a frame that did not need the stage spent nothing on it
      for (const StageTime& stage : frame.stages) {
        if (stage.stage == name) time += stage.milliseconds;
      }
      times.push_back(time);
    }
    Json stage;
    stage["name"] = to_string(name);
    stage["ms"] = spread_of(std::move(times)).median;
    stages.push_back(std::move(stage));
  }
  return stages;
}

Json reasons(std::span<const SkippedStage> stages) {
  Json list = Json::array();
  for (const SkippedStage& stage : stages) {
    list.push_back(Json{{"stage", to_string(stage.stage)}, {"why", stage.why}});
  }
  return list;
}

}  // namespace

std::string statistics_json(const RenderRun& run, const Frame& frame,
                            std::span<const FrameStatistics> moved) {
  const FrameStatistics& first = frame.statistics;
  const RenderRequest& request = *frame.request;
  const bool is_sliced = request.airlight == AirlightMethod::sliced;
  std::vector<double> times;
  for (const FrameStatistics& it : moved) times.push_back(it.frame_milliseconds);
  const Spread spread = spread_of(times);
  Json json;
  json["version"] = version();
  json["scene"] = run.scene;
  if (run.frame) json["frame"] = *run.frame;
  json["time"] = frame.time;
  json["size"] = Json::array({frame.film.width, frame.film.height});
  json["backend"] = first.backend;
  json["device"] = first.device.empty() ? device_name() : first.device;
  // The number of slices has a key of its own.
  json["airlight"] = is_sliced ? to_string(request.airlight) : first.airlight;
  json["slices"] = is_sliced ? Json(request.slices) : Json(nullptr);
  json["seed"] = request.airlight == AirlightMethod::path ? Json(request.seed) : Json(nullptr);
  json["airlight_scale"] = *request.airlight_scale;
  json["samples"] = *request.samples;
  json["sampled_pixels"] = first.sampled_pixels;  // that took so many
  json["exact_pixels"] = first.exact_pixels;      // whose airlight is not interpolated
  json["threads"] = *request.threads;
  json["repeat"] = run.repeat;
  json["frame_ms"] = Json{{"median", spread.median}, {"min", spread.min}, {"max", spread.max}};
  json["first_frame_ms"] = run.first_frame_milliseconds;
  json["transfer_ms"] = first.transfer_milliseconds;
  json["stages"] = stage_medians(moved);
  json["skipped"] = reasons(first.skipped);
  if (!first.on_cpu.empty()) json["on_cpu"] = reasons(first.on_cpu);
  json["gaussians"] = Json{{"total", first.gaussians_total}, {"used", first.gaussians_used}};
  if (first.gaussians_merged > 0) json["gaussians"]["merged"] = first.gaussians_merged;
  json["pairs"] = Json{{"light", first.light_pairs}, {"view", first.view_pairs}};
  json["scattering"] = nullptr;
  if (first.scattering) {
    json["scattering"] =
        Json{{"sweeps", first.scattering->sweeps}, {"residual", first.scattering->residual}};
  }
  json["error"] = nullptr;
  if (frame.error) {
    // That of the airlight has always been there by itself.
    json["error"] = estimate_json(*frame.error);
    json["error"]["airlight"] = estimate_json(*frame.error);
    if (frame.picture_error) json["error"]["picture"] = estimate_json(*frame.picture_error);
  }
  json["noise"] = nullptr;
  if (const auto noise = relative_noise(frame)) {
    // Standard errors, relative to the RMS of the layer.
    json["noise"] =
        Json{{"paths", noise->paths}, {"airlight", noise->airlight}, {"picture", noise->picture}};
  }
  if (run.deep) {
    const DeepStatistics& image = run.deep->image;
    json["deep"] = Json{{"samples_per_pixel",
                         static_cast<double>(image.samples) / static_cast<double>(image.pixels)},
                        {"max_samples", image.max_samples},
                        {"coarse_tiles", image.coarse_tiles},
                        {"bytes", run.deep->bytes},
                        {"ms", run.deep->milliseconds}};
  }
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string sequence_statistics_json(std::span<const std::string> frames) {
  std::string text = "{\"frames\": [\n";
  for (const std::string& frame : frames) text += (&frame == frames.data() ? "" : ",\n") + frame;
  return text + "]}\n";
}

}  // namespace brume
