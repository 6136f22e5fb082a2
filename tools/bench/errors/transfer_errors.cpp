#include "tools/bench/errors/transfer_errors.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <numbers>

#include "tools/bench/errors/surface_light_errors.h"
#include "tools/bench/measure/frames.h"
#include "tools/bench/measure/report_text.h"
#include "tools/bench/scenes/benchmark_meshes.h"
#include "tools/bench/scenes/benchmark_scenes.h"
#include "tools/bench/scenes/hash_random.h"

namespace brume {
namespace {

using std::numbers::pi;

Frame frame_with(Scene scene, Surface::Transfer transfer) {
  for (Surface& surface : scene.surfaces) surface.transfer = transfer;
  return render_frame(scene, {.airlight = AirlightMethod::paper});
}

ComparedError shadow_error(const char* label, const Scene& scene, std::size_t samples) {
  const SurfaceTruth reference(scene, {.samples = samples});
  return {label, reference.error(frame_with(scene, Surface::Transfer::shadow)),
          reference.error(frame_with(scene, Surface::Transfer::none))};
}

// The object is turned, so that its frame is not the world's.
Scene floor_under_a_sky(Material::Type type) {
  Scene scene = ball_over_floor(Surface::Transfer::shadow);
  scene.environment.emplace().map = smooth_sky();
  Surface& surface = scene.surfaces[0];
  surface.rotate = glm::normalize(glm::dquat(0.9, -0.5, 0.1, 0.2));
  for (glm::dvec3* p : {&scene.camera.eye, &scene.camera.target, &scene.camera.up}) {
    *p = surface.rotate * *p;
  }
  surface.material.type = type;
  surface.material.reflectance = {0.8, 0.5, 0.3};
  surface.material.specular = glm::dvec3(0.3);
  surface.material.exponent = 8.0;
  return scene;
}

// Direct light of a point light reflected at a point, diffuse, 0.5.
double unscattered(const Light& light, const RayCaster& ray_caster, const SurfacePoint& p) {
  const glm::dvec3 q = light.position - p.position;
  const double cosine = glm::dot(p.normal, q);
  if (!(cosine > 0.0) || ray_caster.occluded(p.shadow_origin, light.position)) return 0.0;
  return 0.5 / pi * light.intensity.x * cosine / std::pow(glm::length(q), 3);
}

// One path from a point: light reflected by two further points.
double path(const Scene& scene, const RayCaster& ray_caster, SurfacePoint point,
            HashRandom& random) {
  double sum = 0.0;
  double weight = 1.0;
  for (int reflection = 0; reflection < 2; ++reflection) {
    // Directions as dense as the cosine.
    const glm::dvec3 w = glm::normalize(point.normal + glm::normalize(random.in_ball()));
    const SurfaceHit hit = ray_caster.first_hit(point.shadow_origin, w);
    if (!hit) break;
    point = ray_caster.point(hit, point.shadow_origin, w, scene.surfaces);
    weight *= 0.5;
    sum += weight * unscattered(scene.lights[0], ray_caster, point);
  }
  return sum;
}

ComparedError light_in_bowl_error(double distance, std::size_t samples) {
  Scene scene = bowl_scene(0.5 * pi, Surface::Transfer::interreflection);
  scene.film = {6, 6};
  scene.surfaces[0].material.reflectance = glm::dvec3(0.5);
  scene.lights.push_back(
      {distance * glm::normalize(glm::dvec3(0.8, 0.3, 1.0)), glm::dvec3(distance * distance), {}});
  const SurfaceTruth reference(
      scene, {.samples = samples},
      [&](const RayCaster& ray_caster, const SurfacePoint& point, const SurfaceSampling& s) {
        HashRandom random(s.seed);
        double sum = 0.0;
        for (std::size_t i = 0; i < s.samples; ++i) sum += path(scene, ray_caster, point, random);
        return ReflectedLight{glm::dvec3(sum / static_cast<double>(s.samples)), {}, {}};
      });
  const Frame direct = frame_with(scene, Surface::Transfer::none);
  Frame indirect = frame_with(scene, Surface::Transfer::interreflection);
  for (std::size_t i = 0; i < direct.beauty.size(); ++i) indirect.beauty[i] -= direct.beauty[i];
  return {formatted("what walls of a bowl send each other, light %g radii away", distance),
          reference.error(indirect),
          {}};
}

}  // namespace

std::vector<ComparedError> measure_transfer(std::size_t samples) {
  const Scene diffuse = floor_under_a_sky(Material::Type::diffuse);
  Scene in_fog = diffuse;
  in_fog.medium = cloud(20, 0.3).medium;
  Scene bowl = bowl_scene(2.6, Surface::Transfer::shadow);
  bowl.medium.set_homogeneous_density(0.2);
  bowl.lights.push_back({{1.5, 0, 2.5}, {9, 9, 9}, {}});
  return {shadow_error("floor under a ball in a smooth sky", diffuse, samples),
          shadow_error("the same, shiny", floor_under_a_sky(Material::Type::phong), samples),
          shadow_error("the same, diffuse, in a cloud 0.3 deep", in_fog, samples),
          shadow_error("deep bowl in fog, lit by a point light", bowl, samples),
          light_in_bowl_error(2.0, samples),
          light_in_bowl_error(4.0, samples),
          light_in_bowl_error(20.0, samples)};
}

Scene bowl_scene(double to, Surface::Transfer transfer) {
  MeshArrays mesh;
  add_ball(mesh, 40, {0, 0, 0}, 1.0, to, true);
  Scene scene;
  Surface& surface = scene.surfaces.emplace_back();
  surface.mesh = to_mesh(mesh);
  surface.transfer = transfer;
  scene.camera = {{0.4, -0.3, 5.0}, {0, 0, 0}, {0, 1, 0}, 14.0};
  scene.film = {12, 12};
  return scene;
}

Scene ball_over_floor(Surface::Transfer transfer) {
  MeshArrays mesh;
  add_floor(mesh, 40, 1.0);
  add_ball(mesh, 32, {0.3, 0.1, 0.7}, 0.4, std::numbers::pi, false);
  Scene scene;
  Surface& surface = scene.surfaces.emplace_back();
  surface.mesh = to_mesh(mesh);
  surface.transfer = transfer;
  scene.camera = {{-1.2, -2.5, 2.6}, {0, 0, 0.2}, {0, 0, 1}, 34.0};
  scene.film = {16, 12};
  return scene;
}

}  // namespace brume
