#include "tools/bench/errors/fog_errors.h"

#include <cmath>
#include <memory>
#include <numbers>

#include "core/transport/medium_summary.h"
#include "tools/bench/measure/frames.h"
#include "tools/bench/measure/report_text.h"
#include "tools/bench/scenes/benchmark_scenes.h"
#include "tools/bench/scenes/table_one_scenes.h"

namespace brume {
namespace {

ErrorEstimate error_of(const ErrorSample& sample, const Scene& scene, const Settings& settings) {
  return sample.measure(render_frame(scene, settings));
}

ErrorEstimate sky_error(Scene scene, std::shared_ptr<const RadianceMap> sky) {
  scene.lights.clear();
  scene.environment.emplace().map = std::move(sky);
  const Frame frame = render_frame(scene, sliced_settings({}, 24));
  const std::size_t pixels = scene.medium.size() > 1000 ? 12 : 40;
  return ErrorSample::create(scene, scene.camera, frame, pixels, 1, 1e-3)->measure(frame);
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
    const Frame guide = render_frame(scene, sliced);
    const ErrorSample sample = *ErrorSample::create(scene, scene.camera, guide, pixels, 1, 1e-4);
    const Settings published{.airlight = AirlightMethod::paper};
    Settings energy = published;
    energy.paper.conserve_energy = true;
    rows.push_back({factor, summarize(medium).max_optical_depth, error_of(sample, scene, published),
                    error_of(sample, scene, energy), sample.measure(guide)});
  }
  return rows;
}

std::vector<SkyRow> measure_skies() {
  std::vector<SkyRow> rows;
  const auto add = [&](int gaussians, double depth, double anisotropy = 0.0) {
    Scene scene = cloud(gaussians, depth);
    scene.optics.anisotropy = anisotropy;
    rows.push_back({gaussians, depth, anisotropy, sky_error(scene, uniform_sky()),
                    sky_error(scene, sunny_sky())});
  };
  for (const double depth : {0.3, 3.0, 10.0}) add(30, depth);
  for (const double depth : {1.0, 3.0, 10.0}) add(300, depth);
  add(3000, 3.0);
  for (const double anisotropy : {0.6, -0.6}) add(100, 2.0, anisotropy);
  return rows;
}

std::vector<ComparedError> measure_patches() {
  std::vector<ComparedError> rows;
  for (const double anisotropy : {0.0, 0.6, 0.8}) {
    Scene scene = sample_airlight("ground_fog");
    scene.film = {200, 150};
    scene.lights.clear();
    scene.environment.emplace().map = low_sun_sky();
    scene.optics.anisotropy = anisotropy;
    const auto frame = [&](int slices) { return render_frame(scene, sliced_settings({}, slices)); };
    const ErrorSample reference = *ErrorSample::create(scene, scene.camera, frame(24), 80, 1, 1e-3);
    for (const int slices : anisotropy == 0.0 ? std::vector{12, 24, 64} : std::vector{24}) {
      rows.push_back({formatted("anisotropy %g, a grid of %d nodes, %d slices", anisotropy,
                                sliced_settings({}, slices).source_grid.nodes, slices),
                      reference.measure(frame(slices)),
                      {}});
    }
  }
  return rows;
}

std::vector<InscatteringRow> measure_inscattering() {
  std::vector<InscatteringRow> rows;
  for (const double depth : {0.1, 0.3, 1.0, 3.0}) {
    Scene scene;
    scene.environment.emplace().map = uniform_sky();
    scene.medium.append({{0, 0, 0}, 1.0, depth / std::sqrt(std::numbers::pi)});
    scene.camera = {{0, 0, 4}, {0, 0, 0}, {0, 1, 0}, 1.0};
    scene.film = {1, 1};
    const auto airlight = [&](AirlightMethod method) {
      Settings settings;
      settings.airlight = method;
      const Frame frame = render_frame(scene, settings);
      return static_cast<double>(frame.airlight[0]);
    };
    rows.push_back({depth, airlight(AirlightMethod::paper) / airlight(AirlightMethod::reference)});
  }
  return rows;
}

std::vector<ScaleRow> measure_scales() {
  std::vector<ScaleRow> rows;
  const auto add = [&](const char* name, Scene scene) {
    scene.film = {800, 600};
    const auto frame = [&](int scale) {
      Settings settings = sliced_settings({}, 24);
      settings.airlight_scale = scale;
      return render_frame(scene, settings);
    };
    const Frame full = frame(1);
    for (const int scale : {2, 4}) {
      const Frame fewer = frame(scale);
      rows.push_back({name, scale,
                      static_cast<double>(fewer.statistics.exact_pixels) /
                          static_cast<double>(full.statistics.exact_pixels),
                      rel_rmse(fewer.airlight, full.airlight)});
    }
  };
  add("cloud_300_depth_3", cloud(300, 3.0));
  add("statue", statue_scene());
  for (const char* name : {"bunny_fog", "dense_cloud", "ground_fog"}) {
    add(name, sample_airlight(name));
  }
  return rows;
}

namespace {

double mean_depth(const Scene& scene) {
  const Frame frame = render_frame(scene, {.airlight = AirlightMethod::paper});
  double sum = 0.0;
  for (const float t : frame.transmittance) sum -= std::log(static_cast<double>(t));
  return sum / static_cast<double>(frame.transmittance.size());
}

// How the mean depth changes, over seeds.
Spread changes(Scene scene, double amplitude, double cells) {
  const double still = mean_depth(scene);
  scene.optics.noise.amplitude = amplitude;
  scene.optics.noise.frequency = cells;
  std::vector<double> all;
  for (int seed = 1; seed <= 8; ++seed) {
    scene.optics.noise.seed = seed;
    all.push_back(mean_depth(scene) / still - 1.0);
  }
  return spread_of(all);
}

ErrorEstimate sliced_error(const Scene& scene, std::size_t pixels) {
  const Settings settings = sliced_settings({}, 24);
  const Frame frame = render_frame(scene, settings);
  return ErrorSample::create(scene, scene.camera, frame, pixels, 1, 1e-5)->measure(frame);
}

}  // namespace

std::vector<NoiseDepthRow> measure_noise_depths() {
  Scene near = cloud(30, 1.0);
  near.film = {64, 64};
  Scene afar = near;
  afar.camera.eye.z *= 10.0;
  afar.camera.vertical_fov = 6.0;
  std::vector<NoiseDepthRow> rows;
  for (const double cells : {0.3, 1.0, 2.0, 5.0}) {
    rows.push_back({cells, changes(afar, 0.5, cells), changes(near, 0.5, cells)});
  }
  return rows;
}

std::vector<ComparedError> measure_noise_errors(std::size_t pixels) {
  std::vector<ComparedError> rows;
  const auto add = [&](int gaussians, double depth, double amplitude, double cells) {
    Scene scene = cloud(gaussians, depth);
    const ErrorEstimate still = sliced_error(scene, pixels);
    scene.optics.noise.amplitude = amplitude;
    scene.optics.noise.frequency = cells;
    rows.push_back({formatted("%d Gaussians %g deep, amplitude %g, %g cells per u", gaussians,
                              depth, amplitude, cells),
                    sliced_error(scene, pixels), still});
  };
  add(30, 1.0, 0.3, 2.0);
  add(30, 1.0, 0.5, 2.0);
  add(30, 1.0, 0.4, 8.0);
  add(300, 3.0, 0.4, 2.0);
  return rows;
}

}  // namespace brume
