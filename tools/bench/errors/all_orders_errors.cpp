#include "tools/bench/errors/all_orders_errors.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "brume/frame.h"
#include "core/io/scene/scene_file.h"
#include "render/renderer.h"
#include "tools/bench/measure/frames.h"
#include "tools/bench/measure/report_text.h"
#include "tools/bench/scenes/benchmark_scenes.h"

namespace brume {
namespace {

constexpr Film error_film{48, 36};
constexpr Film speed_film{200, 150};
constexpr int paths = 512;

Settings settings_of(Scattering scattering) {
  Settings settings = sliced_settings({}, 24);
  settings.scattering = scattering;
  return settings;
}

// Relative RMSE of the airlight without the paths' noise.
double error_of(const Frame& frame, const Frame& reference, double noise) {
  const double measured = rel_rmse(frame.airlight, reference.airlight);
  return std::sqrt(std::max(measured * measured - noise * noise, 0.0));
}

double stage_milliseconds(const Frame& frame, Stage stage) {
  const auto& stages = frame.statistics.stages;
  const auto it = std::ranges::find(stages, stage, &StageTime::stage);
  return it == stages.end() ? 0.0 : it->milliseconds;
}

// The median over some frames, before each of which a Gaussian was moved.
double edit_milliseconds(Scene scene, int frames) {
  const Settings settings = settings_of(Scattering::multiple);
  Renderer renderer;
  std::vector<double> milliseconds;
  for (int i = 0; i <= frames; ++i) {
    const Medium before = std::exchange(scene.medium, {});
    scene.medium.set_homogeneous_density(before.homogeneous_density());
    for (std::size_t k = 0; k < before.size(); ++k) {
      Gaussian g = before.gaussian(k);
      if (k == 0) g.center.x += 0.02 * g.radius;
      scene.medium.append(g);
    }
    const Frame frame =
        *renderer.render(scene, scene.camera, scene.film, settings, {}, {}, {.warm_start = true});
    if (i > 0) milliseconds.push_back(stage_milliseconds(frame, Stage::scattering));
  }
  return spread_of(std::move(milliseconds)).median;
}

AllOrdersRow measure(std::string name, Scene scene, int frames) {
  scene.film = error_film;
  Settings path;
  path.airlight = AirlightMethod::path;
  path.paths = paths;
  const Frame reference = render_frame(scene, path);
  const Frame multiple = render_frame(scene, settings_of(Scattering::multiple));
  AllOrdersRow row;
  row.scene = std::move(name);
  const auto noise = relative_noise(reference);
  row.noise = noise ? noise->airlight : 0.0;
  row.single = error_of(render_frame(scene, settings_of(Scattering::single)), reference, row.noise);
  row.multiple = error_of(multiple, reference, row.noise);
  if (multiple.statistics.scattering) row.sweeps = multiple.statistics.scattering->sweeps;
  row.solve_milliseconds = stage_milliseconds(multiple, Stage::scattering);
  row.edit_milliseconds = edit_milliseconds(scene, frames);
  row.megabytes = 1e-6 * static_cast<double>(multiple.statistics.grid_bytes);
  scene.film = speed_film;
  row.camera_ratio = frame_time_ratio(
      {}, scene, {settings_of(Scattering::single), settings_of(Scattering::multiple)}, frames);
  return row;
}

// A cloud of 300 Gaussians, or of more that overlap as much.
Scene thick_cloud(double depth, double albedo, double anisotropy, int gaussians = 300) {
  Scene scene = cloud(gaussians, depth, 1, 0.3 * std::cbrt(300.0 / gaussians));
  scene.optics.albedo = glm::dvec3(albedo);
  scene.optics.anisotropy = anisotropy;
  return scene;
}

}  // namespace

std::vector<AllOrdersRow> measure_all_orders(bool quick) {
  const int frames = quick ? 3 : 9;
  std::vector<AllOrdersRow> rows;
  const auto add_cloud = [&](double depth, double albedo, double anisotropy) {
    rows.push_back(
        measure(formatted("cloud: depth %g, albedo %g, anisotropy %g", depth, albedo, anisotropy),
                thick_cloud(depth, albedo, anisotropy), frames));
  };
  add_cloud(10.0, 0.999, 0.0);
  if (quick) return rows;
  for (const double depth : {1.0, 3.0, 30.0}) add_cloud(depth, 0.999, 0.0);
  for (const double albedo : {0.5, 0.9}) add_cloud(10.0, albedo, 0.0);
  for (const double anisotropy : {-0.3, 0.6, 0.85}) add_cloud(10.0, 0.999, anisotropy);
  for (const int gaussians : {3000, 30'000, 100'000}) {
    rows.push_back(measure(formatted("%d Gaussians of depth 10", gaussians),
                           thick_cloud(10.0, 0.999, 0.0, gaussians), frames));
  }
  Scene backlit = thick_cloud(10.0, 0.999, 0.0);
  backlit.lights[0].position = 2.0 * backlit.camera.target - backlit.camera.eye;
  rows.push_back(measure("the same as the first, lit from behind", backlit, frames));
  backlit.optics.anisotropy = 0.85;
  rows.push_back(measure("the same, anisotropy 0.85", backlit, frames));
  for (const char* name :
       {"bunny_fog", "ground_fog", "evening_mist", "courtyard", "room", "tunnel"}) {
    rows.push_back(measure(name, load_scene(sample_scene_file(name)), frames));
  }
  return rows;
}

}  // namespace brume
