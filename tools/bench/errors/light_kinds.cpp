#include "tools/bench/errors/light_kinds.h"

#include <array>
#include <glm/geometric.hpp>

#include "render/output/compare.h"
#include "tools/bench/scenes/benchmark_scenes.h"

namespace brume {
namespace {

constexpr Film kinds_error_film{48, 36};
constexpr Film kinds_speed_film{400, 300};
const glm::dvec3 from{2.0, 3.0, 1.5};

Scene lit_by(const Light& light) {
  Scene scene = cloud(300, 3.0);
  scene.lights = {light};
  return scene;
}

double error_of(Scene scene, const Settings& settings) {
  scene.film = kinds_error_film;
  Settings reference;
  reference.airlight = AirlightMethod::reference;
  const auto render = [&](const Settings& chosen) {
    return *Renderer().render(scene, scene.camera, scene.film, chosen);
  };
  const Frame frame = render(settings);
  const Frame truth = render(reference);
  const std::array<ChannelPair, 1> pair{{{frame.airlight, truth.airlight}}};
  return compare(pair).rel_rmse;
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
  (light.directional ? light.directional->direction : light.position) *= glm::dvec3(1.01, 1, 1);
}

}  // namespace

std::vector<LightKindRow> measure_light_kinds(bool quick) {
  Settings settings = sliced_settings({}, 24);
  settings.scattering = Scattering::single;
  const int frames = quick ? 3 : 15;
  const Light point{.position = from, .intensity = glm::dvec3(30.0)};
  std::vector<LightKindRow> rows;
  const auto add = [&](const char* kind, const Light& light) {
    const std::array<Scene, 2> scenes{lit_by(point), lit_by(light)};
    rows.push_back({kind, error_of(scenes[1], settings),
                    ratio(scenes, settings, frames, move_camera),
                    ratio(scenes, settings, frames, move_light)});
  };
  add("point", point);
  Light spot = point;
  spot.spot = SpotCone{-from, 5.0, 20.0};
  add("spot, 5 to 20 degrees", spot);
  spot.spot = SpotCone{-from, 9.9, 10.0};
  add("spot, 10 degrees, sharp", spot);
  if (quick) return rows;
  Light sun{.intensity = glm::dvec3(2.0), .directional = Directional{-from}};
  add("directional", sun);
  sun.directional->angular_diameter = 0.53;
  add("directional, disc of 0.53 degrees", sun);
  Light area{.position = from, .intensity = glm::dvec3(30.0)};
  area.area = AreaLight{.direction = -from, .width = 1.0, .height = 0.7};
  add("rectangle, 1 by 0.7 u, 3.9 u away", area);
  area.area->shape = AreaLight::Shape::sphere;
  area.area->radius = 0.4;
  add("sphere of radius 0.4 u", area);
  area.position *= 0.5;
  add("sphere of radius 0.4 u, 2 u away", area);
  return rows;
}

}  // namespace brume
