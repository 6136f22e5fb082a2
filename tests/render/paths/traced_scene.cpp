#include "tests/render/paths/traced_scene.h"

#include <algorithm>
#include <cassert>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>
#include <vector>

#include "render/prepare/fog_extent.h"
#include "render/render_plan.h"
#include "render/util/job.h"
#include "render/visibility/exact_occlusion.h"

namespace brume {
namespace {

// Blocks of one task: what tasks sum up does not depend on the threads.
constexpr int task_blocks = 16;

}  // namespace

TracedScene::TracedScene(const Scene& scene, double albedo)
    : scene_(scene),
      albedo_(albedo),
      index_(scene.medium, culling_tolerance(scene.medium, path_depth_error),
             scene.optics.anisotropy),
      medium_(index_),
      ray_caster_(scene_.surfaces) {
  if (scene.environment) environment_.emplace(*scene.environment);
  const FogExtent extent(scene);
  fog_ = extent.ball();
  fog_depth_ = extent.surface_optical_depth(index_.homogeneous_density());
}

double TracedScene::length(const glm::dvec3& eye, const glm::dvec3& w) const {
  const SurfaceHit hit = ray_caster_.first_hit(eye, w);
  return hit ? hit.distance : FogExtent(scene_).ray_distance(eye);
}

PathScene TracedScene::scene_from(const glm::dvec3& eye) const {
  std::vector<PointSource> lights;
  for (const PointLight& light : point_lights(scene_, LightPoints::drawn)) {
    lights.push_back({light});
  }
  return PathScene::of_view(medium_, albedo_, ray_caster_, scene_.surfaces,
                            environment_ ? &*environment_ : nullptr, lights, eye, fog_);
}

// `sample(block, k, sample index)`; sums over blocks are independent of each other.
template <class Sample>
TracedScene::Estimate TracedScene::estimate(int paths, Sample sample) {
  assert(paths % path_block == 0);
  struct Sums {
    std::array<glm::dvec3, 4> sum{};
    std::array<glm::dvec3, 4> square{};
  };
  const int blocks = paths / path_block;
  std::vector<Sums> tasks(static_cast<std::size_t>((blocks + task_blocks - 1) / task_blocks));
  Job().parallel_for(tasks.size(), [&](std::size_t task) {
    const int first = static_cast<int>(task) * task_blocks;
    for (int block = first; block < std::min(first + task_blocks, blocks); ++block) {
      std::array<glm::dvec3, 4> mean{};
      for (int k = 0; k < path_block; ++k) {
        const OrderedRadiance radiance = sample(block, k);
        for (std::size_t i = 0; i < 3; ++i) mean[i] += radiance.orders[i] / double{path_block};
        mean[3] += radiance.sum() / double{path_block};
      }
      for (std::size_t i = 0; i < 4; ++i) {
        tasks[task].sum[i] += mean[i];
        tasks[task].square[i] += mean[i] * mean[i];
      }
    }
  });
  Estimate result;
  for (std::size_t i = 0; i < 4; ++i) {
    glm::dvec3 sum(0.0);
    glm::dvec3 square(0.0);
    for (const Sums& task : tasks) {
      sum += task.sum[i];
      square += task.square[i];
    }
    const double n = blocks;
    PathEstimate& estimate = i < 3 ? result.orders[i] : result.sum;
    estimate.mean = sum / n;
    estimate.error = glm::sqrt(
        glm::max(square / n - estimate.mean * estimate.mean, glm::dvec3(0.0)) / (n - 1.0));
  }
  return result;
}

TracedScene::Estimate TracedScene::airlight(const glm::dvec3& eye, const glm::dvec3& target,
                                            int paths, std::uint64_t seed) const {
  const PathScene scene = scene_from(eye);
  const PathTracer tracer(scene);
  const glm::dvec3 w = glm::normalize(target - eye);
  const CameraRay ray(index_, eye, w, length(eye, w));
  return estimate(paths, [&](int block, int k) {
    const PathRandom of_block(seed, 0, static_cast<std::uint64_t>(block), 0);
    PathRandom random(seed, 0, static_cast<std::uint64_t>(block * path_block + k), 1);
    OrderedRadiance radiance =
        tracer.airlight(ray, StratifiedPair(of_block, static_cast<unsigned>(k), random), random);
    for (glm::dvec3& order : radiance.orders) order *= albedo_;
    return radiance;
  });
}

TracedScene::Estimate TracedScene::surface(const glm::dvec3& eye, const glm::dvec3& target,
                                           int paths, std::uint64_t seed) const {
  const PathScene scene = scene_from(eye);
  const PathTracer tracer(scene);
  const glm::dvec3 w = glm::normalize(target - eye);
  const SurfaceHit hit = ray_caster_.first_hit(eye, w);
  assert(hit);
  const SurfacePoint point = ray_caster_.point(hit, eye, w, scene_.surfaces);
  return estimate(paths, [&](int block, int k) {
    PathRandom random(seed, 0, static_cast<std::uint64_t>(block * path_block + k), 2);
    return tracer.surface(point, random);
  });
}

glm::dvec3 TracedScene::single_scattering(const glm::dvec3& eye, const glm::dvec3& target) const {
  constexpr double tolerance = 1e-5;
  std::vector<PointSource> lights;
  for (const PointLight& light : point_lights(scene_, LightPoints::drawn)) {
    lights.push_back({light});
  }
  std::optional<ReferenceEnvironment> environment;
  if (scene_.environment) {
    environment.emplace(*scene_.environment, scene_.optics.anisotropy, fog_depth_, tolerance);
  }
  const glm::dvec3 w = glm::normalize(target - eye);
  return albedo_ * reference_airlight(index_, ExactOcclusion(scene_.surfaces), lights,
                                      environment ? &*environment : nullptr, eye, w, length(eye, w),
                                      tolerance)
                       .airlight;
}

}  // namespace brume
