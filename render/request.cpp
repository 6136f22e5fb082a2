#include "render/request.h"

#include <tbb/info.h>

#include <algorithm>

#include "brume/error.h"
#include "brume/limits.h"
#include "brume/request_options.h"
#include "core/io/text_scanner.h"
#include "core/scene/check.h"
#include "render/layers/frame_layers.h"

namespace brume {
namespace {

bool is_interpolated(AirlightMethod method) {
  return method != AirlightMethod::path && method != AirlightMethod::reference;
}

void check_count(const char* name, int value, int high) {
  if (value >= 1 && value <= high) return;
  throw DomainError(name,
                    "found " + std::to_string(value) + "; allowed: 1 to " + std::to_string(high));
}

}  // namespace

Settings settings_of(const RenderRequest& request) {
  Settings settings = sliced_settings({}, request.slices);
  settings.airlight = request.airlight;
  settings.max_error = request.max_error;
  settings.scattering = request.scattering;
  settings.paths = request.paths;
  settings.path_seed = request.seed;
  settings.paper = {request.paper_mean, request.paper_energy};
  settings.paper_spread = request.paper_spread;
  settings.reference_tolerance = request.tolerance;
  settings.airlight_scale =
      request.airlight_scale.value_or(request.airlight == AirlightMethod::auto_ ? 4 : 1);
  // TBB warns of more.
  settings.threads = std::min(request.threads.value_or(0), tbb::info::default_concurrency());
  return settings;
}

RenderRequest chosen(RenderRequest request, const Settings& settings) {
  request.airlight = settings.airlight;
  request.slices = settings.slices;
  request.airlight_scale = settings.airlight_scale;
  request.samples = settings.samples;
  request.threads = settings.threads > 0 ? settings.threads : tbb::info::default_concurrency();
  return request;
}

std::string denoise_problem(const RenderRequest& request) {
  if (request.airlight != AirlightMethod::path || request.paths < 2) {
    return "it is of the noise of paths; allowed with path:2 or more";
  }
  if (request.film && request.film->region) {
    return "it takes the pixels around each; allowed: no region";
  }
  if (has_light_layers(request.layers)) {
    return "the sum of denoised layers is not the picture; allowed: layers without light";
  }
  return {};
}

void trace_paths(RenderRequest& request, int paths, Denoising denoise) {
  request.airlight = AirlightMethod::path;
  request.paths = paths;
  request.airlight_scale.reset();
  request.denoise = denoise;
}

Exposure exposure_of(const Scene& animation, const RenderRequest& request) {
  Exposure exposure = exposure_of(animation);
  if (request.samples) exposure.samples = request.samples;
  if (request.deep_error) exposure.samples = 1;
  if (request.shutter) exposure.shutter = request.shutter;
  if (exposure.shutter == no_shutter) exposure.shutter.reset();
  return exposure;
}

std::optional<RequestProblem> problem_of(const RenderRequest& request) {
  for (const RequestOption& option : request_options()) {
    const std::string text = option.get ? option.get(request) : "";
    if (text.empty()) continue;
    RenderRequest read;
    if (const std::string why = option.set(read, text, {}); !why.empty()) {
      return RequestProblem{option.name, why};
    }
  }
  const std::string method = to_string(request.airlight);
  if (request.airlight_scale.value_or(1) > 1 && !is_interpolated(request.airlight)) {
    return RequestProblem{"airlight-scale", method + " is never interpolated; allowed: 1"};
  }
  if (request.denoise != Denoising::none) {
    const std::string why = denoise_problem(request);
    if (!why.empty()) return RequestProblem{"denoise", why};
  }
  if (request.deep_error && request.airlight != AirlightMethod::auto_ &&
      request.airlight != AirlightMethod::sliced) {
    return RequestProblem{"airlight",
                          "found " + method + "; allowed for a deep frame: auto, sliced"};
  }
  return std::nullopt;
}

void check(const RenderRequest& request) {
  if (request.film) check_film("film", *request.film);
  if (request.camera) brume::check(*request.camera);
  check_count("paths", request.paths, limits::paths);
  const std::optional<RequestProblem> problem = problem_of(request);
  if (problem) throw DomainError(replaced(problem->option, "-", "_"), problem->why);
}

}  // namespace brume
