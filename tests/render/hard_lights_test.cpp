// Lights whose numbers are extreme, as every method sees them.

#include <gtest/gtest.h>

#include <memory>

#include "brume/frame.h"
#include "core/scene/fields/light_fields.h"
#include "core/scene/lights/photometric_profile.h"
#include "tests/pictures.h"
#include "tests/render/test_scenes.h"

namespace brume {
namespace {

// Spots that graze, point away, are closed or have no edge; shapes that are tiny, huge or upright;
// profiles that are a beam of a degree, a ring or shine upwards only.
std::vector<Light> hard_lights() {
  std::vector<Light> lights;
  const auto add = [&lights](const Light::Kind& kind) {
    lights.push_back({.intensity = glm::dvec3(3.0), .kind = kind});
  };
  for (const glm::dvec3& direction :
       {glm::dvec3(0.0, 0.0, -1.0), glm::dvec3(0.0, 0.0, 1.0), glm::dvec3(1e12, 1e-12, 0.0)}) {
    for (const double outer : {1e-6, 0.5, 90.0, 180.0}) add(light::Spot{direction, 0.0, outer});
    add(light::Directional{direction, 89.0});
  }
  const glm::dvec3 edge_on(1.0, 0.0, 0.0);
  const glm::dvec3 facing(0.0, 0.0, -1.0);
  for (const double size : {1e-6, 1.0, 2e5}) {
    add(light::Rectangle{edge_on, edge_on, size, size});
    add(light::Disk{size == 1.0 ? facing : edge_on, size});
    add(light::Sphere{size, true});
  }
  for (const auto& [polar, values] :
       {std::pair<std::vector<double>, std::vector<double>>({0.0, 0.5, 1.0}, {1.0, 1.0, 0.0}),
        {{90.0}, {1.0}},
        {{120.0, 180.0}, {0.0, 1e20}},
        {{0.0}, {1e-20}}}) {
    add(light::Point());
    std::vector<double> both = values;
    both.insert(both.end(), values.begin(), values.end());
    *profile_member(lights.back()) = {
        "a.ies", std::make_shared<const PhotometricProfile>(polar, std::vector{0.0, 360.0}, both)};
  }
  return lights;
}

// A usual light shines beside each, which stands in the eye, in a Gaussian, along a ray, far away
// and in a surface. Frames have 0 where a sum is no number, so that nothing may be darker than by
// the usual light alone.
TEST(Lights, HardCasesAreFinite) {
  Settings grid = all_orders(8, {.nodes = 1000, .directions = 32});
  Settings slices = sliced(8);
  for (Settings* settings : {&grid, &slices}) {
    settings->optical_depth_table = {16, 8};
    settings->shadow_cells = 16;
  }
  Scene scene = on_film(cloud_scene(6, 5.0), {4, 3});
  scene.surfaces = {wall(-1.0, 2.0)};
  const Light usual = scene.lights[0];
  for (const Settings& settings : {slices, grid, reference_settings(1e-2)}) {
    scene.lights = {usual};
    const Frame alone = render_frame(scene, settings);
    for (const Light& light : hard_lights()) {
      SCOPED_TRACE(kind_info(light).name);
      scene.lights.assign(5, light);
      scene.lights[0].position = scene.camera.eye;
      scene.lights[1].position = scene.medium.centers()[0];
      scene.lights[2].position = {0.0, 0.0, 2.0};
      scene.lights[3].position = {0.0, 1e6, 0.0};
      scene.lights[4].position = {0.0, 0.0, -1.0};
      if (settings.airlight == AirlightMethod::reference) scene.lights.resize(2);
      scene.lights.push_back(usual);
      const Frame frame = render_frame(scene, settings);
      expect_finite(frame);
      for (const auto layer : {&Frame::airlight, &Frame::beauty}) {
        for (std::size_t i = 0; i < (frame.*layer).size(); ++i) {
          EXPECT_GE((frame.*layer)[i], 0.9f * (alone.*layer)[i]);
        }
      }
    }
  }
}

}  // namespace
}  // namespace brume
