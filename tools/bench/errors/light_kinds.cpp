#include "tools/bench/errors/light_kinds.h"

#include <array>
#include <cmath>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/trigonometric.hpp>
#include <memory>

#include "core/scene/lights/photometric_profile.h"
#include "tools/bench/measure/frames.h"
#include "tools/bench/scenes/benchmark_scenes.h"
#include "tools/bench/scenes/hash_random.h"

namespace brume {
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

// Frames of both scenes in turn; each is changed by `step` before.
template <class Step>
Spread ratio(std::array<Scene, 2> scenes, const Settings& settings, int frames, Step step) {
  std::array<Renderer, 2> renderers;
  std::vector<double> ratios;
  for (int i = 0; i <= frames; ++i) {
    std::array<double, 2> milliseconds{};
    for (std::size_t k = 0; k < 2; ++k) {
      Scene& scene = scenes[k];
      scene.film = kinds_speed_film;
      step(scene);
      milliseconds[k] = renderers[k]
                            .render(scene, scene.camera, scene.film, settings)
                            ->statistics.frame_milliseconds;
    }
    if (i > 0) ratios.push_back(milliseconds[1] / milliseconds[0]);
  }
  return spread_of(std::move(ratios));
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

}  // namespace brume
