#include "tools/bench/fog_errors.h"

#include <memory>

#include "core/medium/medium_summary.h"
#include "render/renderer.h"
#include "tools/bench/benchmark_scenes.h"

namespace brume {
namespace {

ErrorEstimate error_of(const ErrorSample& sample, const Scene& scene, const Settings& settings) {
  return sample.measure(*Renderer().render(scene, scene.camera, scene.film, settings));
}

ErrorEstimate sky_error(Scene scene, std::shared_ptr<const RadianceMap> sky) {
  scene.lights.clear();
  scene.environment.emplace().map = std::move(sky);
  const Frame frame = *Renderer().render(scene, scene.camera, scene.film, sliced_settings({}, 24));
  const std::size_t pixels = scene.medium.size() > 1000 ? 12 : 40;
  return ErrorSample::take(scene, scene.camera, frame, pixels, 1, 1e-3)->measure(frame);
}

}  // namespace

std::vector<ThicknessRow> measure_thickness(std::size_t pixels) {
  std::vector<ThicknessRow> rows;
  for (const double factor : {0.03, 0.1, 0.3, 1.0, 3.0}) {
    Scene scene = sample_airlight("dense_cloud");
    scene.film = {200, 150};
    Medium medium;
    for (std::size_t i = 0; i < scene.medium.size(); ++i) {
      Gaussian g = scene.medium.gaussian(i);
      g.density *= factor;
      medium.append(g);
    }
    scene.medium = medium;
    const Settings sliced = sliced_settings({}, 24);
    const Frame guide = *Renderer().render(scene, scene.camera, scene.film, sliced);
    const ErrorSample sample = *ErrorSample::take(scene, scene.camera, guide, pixels, 1, 1e-4);
    rows.push_back({factor, summarize(medium).greatest_optical_depth,
                    error_of(sample, scene, Settings{}), sample.measure(guide)});
  }
  return rows;
}

std::vector<SkyRow> measure_skies() {
  std::vector<SkyRow> rows;
  const auto add = [&](int gaussians, double depth, double anisotropy = 0.0) {
    Scene scene = cloud(gaussians, depth);
    scene.optics.anisotropy = anisotropy;
    rows.push_back({gaussians, depth, anisotropy, sky_error(scene, even_sky()),
                    sky_error(scene, sunny_sky())});
  };
  for (const double depth : {0.3, 3.0, 10.0}) add(30, depth);
  for (const double depth : {1.0, 3.0, 10.0}) add(300, depth);
  add(3000, 3.0);
  for (const double anisotropy : {0.6, -0.6}) add(100, 2.0, anisotropy);
  return rows;
}

}  // namespace brume
