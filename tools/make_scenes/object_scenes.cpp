#include "tools/make_scenes/noise.h"
#include "tools/make_scenes/random.h"
#include "tools/make_scenes/sample_scene.h"
#include "tools/make_scenes/scenes.h"

namespace brume {
namespace {

const std::string bunny = "../meshes/bunny.obj";    // 10 u long, feet at y = 0
const std::string teapot = "../meshes/teapot.obj";  // 32 u from handle to spout, foot at y = -7.9

SampleSurface ground(double half_size, const glm::dvec3& reflectance) {
  return {"plane.obj", glm::dvec3(0.0), half_size, reflectance};
}

SampleScene bunny_fog() {
  SampleScene scene;
  scene.camera = {{0.4, 2.1, 8.2}, {0.0, 1.55, 0.0}, {0.0, 1.0, 0.0}, 36.0};
  scene.surfaces = {{bunny, {0.0, 0.0, 0.0}, 0.3, {0.75, 0.72, 0.68}},
                    ground(14.0, {0.32, 0.34, 0.36})};
  scene.lights = {{{-3.6, 3.4, 1.6}, {72.0, 34.0, 9.0}},
                  {{3.7, 2.4, 1.6}, {7.0, 26.0, 66.0}},
                  {{0.6, 3.6, -3.4}, {84.0, 18.0, 58.0}}};
  // Wisps: a few Gaussians each, strung along the wind, which blows along +x and a little up.
  HashRandom random(34);
  while (scene.gaussians.size() < 34) {
    glm::dvec3 center(random.uniform(-4.6, 2.4), random.uniform(0.2, 2.0),
                      random.uniform(-3.4, 1.8));
    double radius = random.uniform(0.5, 0.9);
    const double density = random.uniform(0.22, 0.5);
    for (int i = 0; i < 5 && scene.gaussians.size() < 34; ++i) {
      scene.gaussians.push_back({center, radius, density * (1.0 - 0.13 * i)});
      center += radius * (glm::dvec3(0.85, 0.16, 0.0) + 0.35 * random.in_ball());
      radius *= random.uniform(0.8, 1.05);
    }
  }
  return scene;
}

SampleScene teapot_steam() {
  SampleScene scene;
  scene.camera = {{0.9, 2.3, 7.6}, {0.45, 1.55, 0.0}, {0.0, 1.0, 0.0}, 34.0};
  scene.homogeneous_density = 0.006;
  scene.surfaces = {{teapot, {0.0, 0.79, 0.0}, 0.1, {0.55, 0.62, 0.66}},
                    ground(14.0, {0.36, 0.27, 0.2})};
  scene.lights = {{{3.9, 4.2, -2.6}, {150.0, 132.0, 110.0}},
                  {{-3.2, 3.4, 3.4}, {48.0, 58.0, 78.0}}};
  // A plume from the spout: widens and thins as it rises, displaced by noise.
  HashRandom random(7);
  const glm::dvec3 mouth(1.57, 1.27, 0.0);
  const int count = 72;
  for (int i = 0; i < count; ++i) {
    const double rise = (i + random.uniform()) / count;
    const double radius = 0.05 + 0.24 * rise;
    const glm::dvec3 bend(fractal_noise(1, {3.0 * rise, 0.5, 0.5}, 3), 0.0,
                          fractal_noise(2, {3.0 * rise, 0.5, 0.5}, 3));
    const glm::dvec3 center = mouth + glm::dvec3(0.25 * rise, 2.1 * rise, 0.0) + 0.9 * rise * bend +
                              0.8 * radius * random.in_ball();
    scene.gaussians.push_back({center, radius, 0.15 * (1.05 - rise) / radius});
  }
  return scene;
}

SampleScene light_inside() {
  SampleScene scene;
  scene.camera = {{0.0, 2.0, 7.0}, {0.0, 1.25, 0.0}, {0.0, 1.0, 0.0}, 36.0};
  scene.gaussians = {{{0.0, 1.5, 0.0}, 1.4, 0.45}};
  scene.lights = {{{-0.45, 1.75, 0.2}, {20.0, 16.0, 11.0}}};
  scene.surfaces = {{bunny, {0.75, 0.0, 0.35}, 0.11, {0.7, 0.7, 0.7}},
                    ground(10.0, {0.4, 0.4, 0.42})};
  return scene;
}

SampleScene camera_inside() {
  SampleScene scene;
  scene.camera = {{0.3, 1.5, 6.0}, {0.0, 1.35, 0.0}, {0.0, 1.0, 0.0}, 45.0};
  scene.homogeneous_density = 0.02;
  scene.surfaces = {{bunny, {0.0, 0.0, 0.0}, 0.3, {0.72, 0.7, 0.66}},
                    ground(16.0, {0.34, 0.36, 0.33})};
  scene.lights = {{{-2.8, 4.2, 2.6}, {110.0, 96.0, 76.0}}, {{3.6, 3.2, -2.8}, {50.0, 62.0, 84.0}}};
  // The first Gaussian holds the eye; the others lie around it and between it and the bunny.
  HashRandom random(11);
  scene.gaussians = {{{0.1, 1.3, 5.7}, 1.2, 0.08}};
  while (scene.gaussians.size() < 40) {
    const glm::dvec3 center =
        glm::dvec3(0.0, 1.2, 4.0) + glm::dvec3(3.6, 1.1, 4.0) * random.in_ball();
    scene.gaussians.push_back({center, random.uniform(0.45, 1.0), random.uniform(0.03, 0.13)});
  }
  return scene;
}

SampleScene evening_mist() {
  SampleScene scene;
  scene.environment = "../environments/sunset.exr";
  scene.camera = {{0.9, 1.9, 7.6}, {0.1, 1.5, 0.0}, {0.0, 1.0, 0.0}, 38.0};
  scene.surfaces = {{bunny, {-1.3, 0.0, 0.0}, 0.28, {0.8, 0.78, 0.74}},
                    {teapot, {1.7, 0.79, 0.4}, 0.1, {0.32, 0.14, 0.1}, 0.35, 25.0},
                    ground(6.0, {0.34, 0.35, 0.33})};
  scene.lights = {{{2.6, 3.6, 2.4}, {14.0, 10.0, 6.0}}};
  // Mist that lies on the ground and thins upwards.
  HashRandom random(23);
  while (scene.gaussians.size() < 48) {
    const glm::dvec3 center =
        glm::dvec3(0.0, 0.35, -0.8) + glm::dvec3(4.4, 0.5, 3.4) * random.in_ball();
    scene.gaussians.push_back({center, random.uniform(0.5, 0.95), random.uniform(0.08, 0.26)});
  }
  return scene;
}

// Four beams that cross above the bunny and sway, in haze.
SampleScene stage() {
  SampleScene scene;
  scene.camera = {{0.0, 2.3, 11.0}, {0.0, 2.15, 0.0}, {0.0, 1.0, 0.0}, 40.0};
  scene.surfaces = {{bunny, {0.0, 0.0, 0.2}, 0.2, {0.8, 0.78, 0.75}},
                    ground(9.0, {0.22, 0.2, 0.2})};
  struct Beam {
    double x;
    glm::dvec3 color;
    double sways;  // to the side, at the height of the floor [u]
  };
  for (const auto& [x, color, sways] :
       {Beam{-4.2, {0.25, 0.45, 1.0}, 1.6}, Beam{-1.4, {1.0, 0.3, 0.55}, -1.1},
        Beam{1.4, {1.0, 0.75, 0.35}, 1.1}, Beam{4.2, {0.3, 0.9, 0.75}, -1.6}}) {
    SampleLight beam{{x, 5.4, -1.2}, 420.0 * color, 5.0, 8.0, {}};
    const glm::dvec3 aim = glm::dvec3(-0.25 * x, 0.3, 0.4) - beam.position;
    for (const double time : {0.0, 2.0, 4.0, 6.0, 8.0}) {
      const double side = time == 2.0 ? sways : time == 6.0 ? -sways : 0.0;
      beam.directions.push_back({time, aim + glm::dvec3(side, 0.0, 0.3 * side)});
    }
    scene.lights.push_back(beam);
  }
  HashRandom random(11);
  for (int i = 0; i < 60; ++i) {
    const glm::dvec3 center(random.uniform(-5.5, 5.5), random.uniform(0.0, 5.5),
                            random.uniform(-2.8, 1.6));
    const double radius = random.uniform(0.8, 1.6);
    scene.gaussians.push_back({center, radius, random.uniform(0.008, 0.03)});
  }
  return scene;
}

}  // namespace

void write_object_scenes(const std::filesystem::path& folder) {
  write_sample_scene(folder / "bunny_fog.brume", bunny_fog());
  write_sample_scene(folder / "teapot_steam.brume", teapot_steam());
  write_sample_scene(folder / "light_inside.brume", light_inside());
  write_sample_scene(folder / "camera_inside.brume", camera_inside());
  write_sample_scene(folder / "evening_mist.brume", evening_mist());
  write_sample_scene(folder / "stage.brume", stage());
}

}  // namespace brume
