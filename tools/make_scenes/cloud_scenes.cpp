#include <algorithm>
#include <glm/vec3.hpp>

#include "core/transport/medium_summary.h"
#include "tools/make_scenes/generated_files.h"
#include "tools/make_scenes/noise.h"
#include "tools/make_scenes/random.h"
#include "tools/make_scenes/sample_scene.h"
#include "tools/make_scenes/scenes.h"

namespace brume {
namespace {

// 3,008 small Gaussians inside the open box, most of them where a noise is high.
std::vector<Gaussian> box_of_gaussians() {
  HashRandom random(3008);
  std::vector<Gaussian> gaussians;
  while (gaussians.size() < 3008) {
    const glm::dvec3 center(random.uniform(-1.85, 1.85), random.uniform(0.12, 1.85),
                            random.uniform(-1.85, 1.7));
    const glm::dvec3 turned(center.x + 0.6 * center.z, center.y + 0.4 * center.x,
                            center.z - 0.6 * center.x);
    if (fractal_noise(5, 1.2 * turned, 3) < random.uniform(-0.25, 0.3)) continue;
    gaussians.push_back({center, random.uniform(0.08, 0.14), random.uniform(0.2, 0.9)});
  }
  return gaussians;
}

SampleScene box_3008() {
  SampleScene scene;
  scene.camera = {{0.0, 3.1, 6.9}, {0.0, 0.8, 0.0}, {0.0, 1.0, 0.0}, 32.0};
  scene.medium_file = "box_3008.ply";
  scene.lights = {{{0.5, 3.6, 0.4}, {64.0, 58.0, 50.0}}};
  scene.surfaces = {{"open_box.off", {0.0, 0.0, 0.0}, 2.0, {0.16, 0.13, 0.11}}};
  return scene;
}

SampleScene dense_cloud() {
  SampleScene scene;
  scene.camera = {{0.0, 0.4, 8.5}, {0.1, 0.1, 0.0}, {0.0, 1.0, 0.0}, 31.0};
  scene.lights = {{{-3.6, 3.6, 3.2}, {400.0, 350.0, 280.0}},
                  {{4.2, 1.0, -1.5}, {110.0, 150.0, 220.0}}};
  // A heap of lobes with a flat base, each lobe filled with Gaussians.
  struct Lobe {
    glm::dvec3 center;
    double radius;
  };
  const Lobe lobes[] = {{{-1.3, -0.35, 0.0}, 0.8},  {{-0.35, 0.25, 0.1}, 1.05},
                        {{0.65, 0.05, -0.1}, 0.95}, {{1.5, -0.4, 0.1}, 0.65},
                        {{0.1, -0.5, 0.35}, 0.8},   {{0.15, 0.95, -0.1}, 0.65}};
  HashRandom random(300);
  while (scene.gaussians.size() < 300) {
    const Lobe& lobe = lobes[scene.gaussians.size() % std::size(lobes)];
    glm::dvec3 center = lobe.center + lobe.radius * random.in_ball();
    center.y = std::max(center.y, -0.8 + 0.1 * random.uniform());
    scene.gaussians.push_back({center, random.uniform(0.16, 0.34), random.uniform(0.7, 1.3)});
  }
  Medium medium;
  for (const Gaussian& g : scene.gaussians) medium.append(g);
  const double scale = 10.0 / summarize(medium).max_optical_depth;
  for (Gaussian& g : scene.gaussians) g.density *= scale;
  return scene;
}

}  // namespace

void write_cloud_scenes(const std::filesystem::path& folder) {
  write_open_box(folder / "open_box.off");
  write_gaussian_ply(folder / "box_3008.ply", box_of_gaussians());
  write_sample_scene(folder / "box_3008.brume", box_3008());
  write_sample_scene(folder / "dense_cloud.brume", dense_cloud());
}

}  // namespace brume
