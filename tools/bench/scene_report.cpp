#include "tools/bench/scene_report.h"

#include <algorithm>
#include <cmath>

#include "core/io/image/image_file.h"
#include "render/display/to_display.h"
#include "render/renderer.h"

namespace brume {
namespace {

std::vector<Settings> tried_settings(const BenchOptions& options) {
  Settings base;
  base.threads = options.threads;
  Settings paper = base;
  paper.airlight = AirlightMethod::paper;
  std::vector<Settings> settings = {paper};
  const std::vector<int> slices = options.quick ? std::vector{4, 8, 16, 32, 96}
                                                : std::vector{4, 6, 8, 12, 16, 24, 32, 48, 64, 128};
  for (const int scale : {4, 1}) {
    Settings scaled = base;
    scaled.airlight_scale = scale;
    for (const int k : slices) settings.push_back(sliced_settings(scaled, k));
  }
  return settings;
}

// How far apart the airlights of two frames are, pixel by pixel: white is `white`.
std::string error_map(const Frame& frame, const Frame& reference, double white) {
  std::vector<std::uint8_t> rgb;
  for (std::size_t i = 0; i < frame.depth.size(); ++i) {
    double square = 0.0;
    for (std::size_t c = 0; c < 3; ++c) {
      const double d =
          static_cast<double>(frame.airlight[3 * i + c] - reference.airlight[3 * i + c]);
      square += d * d / 3.0;
    }
    const double level = std::min(std::sqrt(square) / white, 1.0);
    rgb.insert(rgb.end(), 3, static_cast<std::uint8_t>(std::lround(255.0 * level)));
  }
  return encode_png(frame.film.width, frame.film.height, rgb);
}

BenchPicture picture(const Scene& scene, const Settings& settings, bool quick) {
  const Film film = quick ? Film{64, 48} : Film{120, 90};
  Settings exact = settings;
  exact.airlight = AirlightMethod::reference;
  exact.airlight_scale = 1;
  exact.reference_tolerance = 1e-3;
  const Frame frame = *Renderer().render(scene, scene.camera, film, settings);
  const Frame reference = *Renderer().render(scene, scene.camera, film, exact);
  double square = 0.0;
  for (const float x : reference.airlight)
    square += static_cast<double>(x) * static_cast<double>(x);
  const double rms = std::sqrt(square / static_cast<double>(reference.airlight.size()));
  constexpr double white = 0.1;
  const auto png = [](const Frame& f) {
    return encode_png(f.film.width, f.film.height, to_display(f, {}));
  };
  return {setting_name(settings), png(frame), png(reference),
          error_map(frame, reference, std::max(white * rms, 1e-30)), white};
}

}  // namespace

SceneReport measure_scene(const BenchScene& bench, const BenchOptions& options, GlRenderer* gl) {
  const Scene& scene = bench.scene;
  SceneReport report;
  report.name = bench.name;
  report.gaussians = scene.medium.size();
  report.lights = scene.lights.size();
  report.environment = scene.environment.has_value();
  report.film = scene.film;
  const std::size_t pixels = scene.medium.size() > 1000 ? 150 : 400;
  const ReferenceSample reference = find_reference(scene, options.quick ? pixels / 2 : pixels);
  const double seconds = options.quick ? 0.15 : 0.4;
  report.reference_cpu_milliseconds = reference.frame_cpu_milliseconds;
  for (const Settings& settings : tried_settings(options)) {
    Renderer renderer;
    report.settings.push_back(measure(renderer, scene, settings, reference.sample, seconds));
    if (gl) report.on_gl.push_back(measure(*gl, scene, settings, reference.sample, seconds));
  }
  report.peers = other_renderers_of(options.peers, report.name, report.film);
  const auto shown = cheapest_within(report.settings, 0.02);
  report.picture = picture(
      scene, report.settings[shown.value_or(report.settings.size() - 1)].settings, options.quick);
  return report;
}

}  // namespace brume
