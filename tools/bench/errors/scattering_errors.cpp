#include "tools/bench/errors/scattering_errors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/trigonometric.hpp>
#include <memory>
#include <utility>

#include "brume/at_time.h"
#include "brume/frame.h"
#include "core/io/scene/scene_file.h"
#include "core/scene/lights/photometric_profile.h"
#include "render/renderer.h"
#include "render/samples/mean_frame.h"
#include "tools/bench/measure/frames.h"
#include "tools/bench/measure/measurement.h"
#include "tools/bench/measure/report_text.h"
#include "tools/bench/scenes/benchmark_scenes.h"
#include "tools/bench/scenes/hash_random.h"

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

namespace {

constexpr Film kinds_error_film{48, 36};
constexpr Film kinds_speed_film{400, 300};
const glm::dvec3 light_position{2.0, 3.0, 1.5};

Scene lit_by(const Light& light) {
  Scene scene = cloud(300, 3.0);
  scene.lights = {light};
  return scene;
}

// Two lobes along an axis, in steps of 5 degrees, as street lights have them.
LightProfile street_profile() {
  std::vector<double> polar;
  std::vector<double> azimuths;
  std::vector<double> intensities;
  for (double p = 0.0; p <= 180.0; p += 5.0) polar.push_back(p);
  for (double a = 0.0; a <= 360.0; a += 5.0) {
    azimuths.push_back(a);
    const double along = std::abs(std::sin(glm::radians(a)));
    for (const double p : polar) {
      const double off = (p - 30.0 - 32.0 * along) / 30.0;
      intensities.push_back((0.4 + 0.8 * along) * std::exp(-off * off));
    }
  }
  return {{}, std::make_shared<const PhotometricProfile>(polar, azimuths, intensities), 0.0};
}

// Every third Gaussian changed.
template <class Change>
Scene with_thirds(Scene scene, Change&& change) {
  std::size_t index = 0;
  scene.medium = scene.medium.changed(scene.medium.homogeneous_density(), [&](Gaussian g) {
    if (index++ % 3 == 0) change(g);
    return g;
  });
  return scene;
}

double error_of(Scene scene, const Settings& settings) {
  scene.film = kinds_error_film;
  Settings reference;
  reference.airlight = AirlightMethod::reference;
  return rel_rmse(render_frame(scene, settings).airlight, render_frame(scene, reference).airlight);
}

// Frame times of the second scene over those of the first, each changed by `step` before each
// frame.
Spread ratio(std::array<Scene, 2> scenes, const Settings& settings, int frames,
             void (*step)(Scene& scene)) {
  std::array<Renderer, 2> renderers;
  return frame_time_ratio(frames, [&](std::size_t k, int) {
    Scene& scene = scenes[k];
    scene.film = kinds_speed_film;
    step(scene);
    return render_frame(renderers[k], scene, settings).statistics.frame_milliseconds;
  });
}

void move_camera(Scene& scene) {
  scene.camera = moved(scene.camera, {0.5, 1}, 1);
}

void move_light(Scene& scene) {
  Light& light = scene.lights[0];
  auto* sun = light.as<light::Directional>();
  (sun ? sun->direction : light.position) *= glm::dvec3(1.01, 1, 1);
}

}  // namespace

std::vector<LightKindRow> measure_light_kinds(bool quick) {
  Settings settings = sliced_settings({}, 24);
  settings.scattering = Scattering::single;
  const int frames = quick ? 3 : 15;
  const Light point{.position = light_position, .intensity = glm::dvec3(30.0)};
  std::vector<LightKindRow> rows;
  const auto add_scene = [&](const char* kind, const Scene& scene) {
    const std::array<Scene, 2> scenes{lit_by(point), scene};
    rows.push_back({kind, error_of(scenes[1], settings),
                    ratio(scenes, settings, frames, move_camera),
                    ratio(scenes, settings, frames, move_light)});
  };
  const auto add = [&](const char* kind, const Light& light) { add_scene(kind, lit_by(light)); };
  add("point", point);
  Light spot = point;
  spot.kind = light::Spot{-light_position, 5.0, 20.0};
  add("spot, 5 to 20 degrees", spot);
  spot.kind = light::Spot{-light_position, 9.9, 10.0};
  add("spot, 10 degrees, sharp", spot);
  if (quick) return rows;
  Light street = point;
  street.kind = light::Point{street_profile()};
  add("point with the profile of a street light", street);
  add_scene("point; every third Gaussian shines", with_thirds(lit_by(point), [](Gaussian& g) {
              g.optics.emission = {3.0, 1.0, 0.2};
            }));
  add_scene("point; every third Gaussian is red", with_thirds(lit_by(point), [](Gaussian& g) {
              g.optics.albedo = {0.9, 0.3, 0.2};
            }));
  // Of the same volume, turned at random.
  HashRandom random(1);
  add_scene("point; every third Gaussian an ellipsoid of up to 10 : 1",
            with_thirds(lit_by(point), [&random](Gaussian& g) {
              glm::dvec3 logarithms = 0.5 * std::log(10.0) * random.point(1.0);
              logarithms -= (logarithms.x + logarithms.y + logarithms.z) / 3.0;
              const glm::dvec3 axis = random.point(1.0);
              g.set_radii(g.radius * glm::exp(logarithms),
                          glm::normalize(glm::dquat(random.uniform(-1.0, 1.0), axis)));
            }));
  Light sun{.intensity = glm::dvec3(2.0), .kind = light::Directional{-light_position}};
  add("directional", sun);
  sun.as<light::Directional>()->angular_diameter = 0.53;
  add("directional, disc of 0.53 degrees", sun);
  Light area{.position = light_position, .intensity = glm::dvec3(30.0)};
  area.kind = light::Rectangle{.direction = -light_position, .width = 1.0, .height = 0.7};
  add("rectangle, 1 by 0.7 u, 3.9 u away", area);
  area.kind = light::Sphere{0.4};
  add("sphere of radius 0.4 u", area);
  area.position *= 0.5;
  add("sphere of radius 0.4 u, 2 u away", area);
  return rows;
}

namespace {

constexpr int true_samples = 64;
constexpr Film sampled_film{320, 240};

SampleRow measure_scene_samples(const std::string& name, int frames) {
  Scene scene = evaluate_at(load_scene(sample_scene_file(name)), 0.0);
  scene.film = sampled_film;
  Settings one = sliced_settings({}, 24);
  one.airlight_scale = 4;
  Settings chosen = one;
  chosen.samples = edge_samples;
  Settings all = one;
  all.samples = true_samples;

  Renderer renderer;
  const auto render = [&](const Camera& camera, const Film& film, const Settings& settings) {
    return renderer.render(scene, camera, film, settings);
  };
  const Frame plain = *render(scene.camera, scene.film, one);
  const Frame sampled = *render(scene.camera, scene.film, chosen);
  const Frame truth = *render_shifted(scene.film, all, {},
                                      [&](const Film& film, const Settings& settings, const Job&) {
                                        return render(scene.camera, film, settings);
                                      });
  std::vector<double> ratios;
  for (int k = 1; k <= frames; ++k) {
    const Camera camera = moved(scene.camera, {0.5, 1}, k);
    const auto milliseconds = [&](const Settings& settings) {
      return render(camera, scene.film, settings)->statistics.frame_milliseconds;
    };
    const double plain_milliseconds = milliseconds(one);
    ratios.push_back(milliseconds(chosen) / plain_milliseconds);
  }
  const auto pairs = [](const Frame& frame) {
    return static_cast<double>(std::max<std::uint64_t>(frame.statistics.view_pairs, 1));
  };
  // Alpha is as good as black: the same in all where surfaces are.
  return {name,
          rel_rmse(plain.beauty, truth.beauty),
          rel_rmse(sampled.beauty, truth.beauty),
          static_cast<double>(sampled.statistics.sampled_pixels) /
              static_cast<double>(sampled.depth.size()),
          pairs(sampled) / pairs(plain),
          spread_of(std::move(ratios)).median};
}

}  // namespace

std::vector<SampleRow> measure_samples(bool quick) {
  std::vector<SampleRow> rows;
  for (const char* name : {"courtyard", "bunny_fog", "forest", "harbour", "stage", "room"}) {
    rows.push_back(measure_scene_samples(name, quick ? 3 : 9));
    if (quick) break;
  }
  return rows;
}

}  // namespace brume
