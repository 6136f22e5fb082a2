#include "tools/bench/measure/hard_cases.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "core/io/disk/file_bytes.h"
#include "core/io/disk/installed_files.h"
#include "core/io/scene/scene_file.h"
#include "render/quality/auto_quality.h"
#include "render/renderer.h"
#include "tools/bench/measure/frames.h"

namespace brume {
namespace {

// rms(values - reference) over rms(reference), or over `min_rms` if that is more.
double relative_rmse(const std::vector<float>& values, const std::vector<float>& reference,
                     double min_rms = 0.0) {
  const auto max_reference =
      std::abs(*std::ranges::max_element(reference, {}, [](float x) { return std::abs(x); }));
  constexpr float black = 1e-9f;
  if (max_reference == 0.0f && min_rms == 0.0) {
    return *std::ranges::max_element(values) < black ? 0.0
                                                     : std::numeric_limits<double>::infinity();
  }
  // In units of it: squares of radiance at the limits would not be numbers.
  const double unit = std::max({static_cast<double>(max_reference), min_rms, 1e-300});
  double difference = 0.0;
  double sum = 0.0;
  for (std::size_t i = 0; i < reference.size(); ++i) {
    difference += std::pow((static_cast<double>(values[i]) - reference[i]) / unit, 2);
    sum += std::pow(reference[i] / unit, 2);
  }
  const double n = static_cast<double>(reference.size());
  return std::sqrt(difference / n) / std::max({std::sqrt(sum / n), min_rms / unit, 1e-300});
}

HardCaseAuto auto_error(FrameRenderer& renderer, const HardCase& hard_case) {
  const Scene& scene = hard_case.scene;
  const Settings settings{.max_error = hard_case_max_error, .airlight_scale = 4};
  const RequestedFrame result =
      *render_requested(renderer, scene, scene.camera, scene.film, settings);
  return {error_of(result.frame, hard_case).airlight,
          result.error->airlight.high > hard_case_max_error};
}

}  // namespace

std::vector<HardCase> load_hard_cases() {
  const std::filesystem::path folder = resources_folder() / "hard_cases";
  const auto golden = nlohmann::json::parse(read_bytes(folder / "golden.json"));
  std::vector<HardCase> cases;
  for (const auto& entry : golden.at("cases")) {
    HardCase& added = cases.emplace_back();
    entry.at("name").get_to(added.name);
    entry.at("breaks").get_to(added.breaks);
    entry.at("remedy").get_to(added.remedy);
    entry.at("bound").get_to(added.bound);
    entry.at("why").get_to(added.why);
    entry.at("airlight").get_to(added.airlight);
    entry.at("transmittance").get_to(added.transmittance);
    added.scene = load_scene(folder / (added.name + ".brume"));
  }
  return cases;
}

HardCaseError error_of(const Frame& frame, const HardCase& hard_case) {
  HardCaseError error;
  error.airlight = relative_rmse(frame.airlight, hard_case.airlight);
  for (std::size_t i = 0; i < frame.transmittance.size(); ++i) {
    const double apart = static_cast<double>(frame.transmittance[i]) - hard_case.transmittance[i];
    if (std::isnan(apart)) return {error.airlight, apart};
    error.transmittance = std::max(error.transmittance, std::abs(apart));
  }
  return error;
}

HardCaseError sliced_error(FrameRenderer& renderer, const HardCase& hard_case) {
  const Scene& scene = hard_case.scene;
  const Settings sliced = sliced_settings({}, 24);
  return error_of(render_frame(renderer, scene, sliced), hard_case);
}

HardCaseErrors measure_hard_case(const HardCase& hard_case, FrameRenderer* gl) {
  Settings reference;
  reference.airlight = AirlightMethod::reference;
  // Lanes of a vector keep what one of them needs: nothing must be left out to compare them.
  const Settings paper{.airlight = AirlightMethod::paper, .depth_error = 1e-7};
  Settings plain = paper;
  plain.precision = Settings::Precision::plain_double;
  HardCaseErrors errors;
  errors.reference = error_of(render_frame(hard_case.scene, reference), hard_case);
  Renderer cpu;
  errors.sliced = sliced_error(cpu, hard_case);
  // A millionth of the right picture cannot be seen.
  const double brightest = *std::ranges::max_element(hard_case.airlight);
  errors.paper = relative_rmse(render_frame(hard_case.scene, paper).airlight,
                               render_frame(hard_case.scene, plain).airlight, 1e-6 * brightest);
  errors.automatic = auto_error(cpu, hard_case);
  if (gl) errors.gl = sliced_error(*gl, hard_case);
  return errors;
}

}  // namespace brume
