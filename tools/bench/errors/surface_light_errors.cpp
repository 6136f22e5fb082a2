#include "tools/bench/errors/surface_light_errors.h"

#include <tbb/parallel_for.h>
#include <glm/geometric.hpp>
#include <numbers>

#include "core/scene/camera_rays.h"
#include "core/transport/optical_depth.h"
#include "tools/bench/measure/frames.h"
#include "tools/bench/measure/report_text.h"
#include "tools/bench/scenes/benchmark_meshes.h"
#include "tools/bench/scenes/benchmark_scenes.h"

namespace brume {
namespace {

constexpr double ball_radius = 0.3;  // in clouds

Surface ball(double radius) {
  MeshArrays mesh;
  add_ball(mesh, 64, {0, 0, 0}, radius, std::numbers::pi, false);
  Surface surface;
  surface.mesh = to_mesh(mesh);
  return surface;
}

// Scattering near the light exists only if the light is inside the fog.
Scene ball_in_fog(double depth) {
  Scene scene;
  scene.medium.set_homogeneous_density(depth);
  scene.optics.albedo = {1.0, 1.0, 0.6};
  scene.surfaces = {ball(0.05)};
  scene.lights.push_back({{0, 0, 1}, {1, 2, 3}, {}});
  scene.camera = {{1.0, 0.0, 0.6}, {0, 0, 0}, {0, 1, 0}, 5.0};
  scene.film = {6, 6};
  return scene;
}

Scene ball_in_cloud(std::uint64_t seed, Material::Type type) {
  Scene scene = cloud(30, 3.0, seed);
  scene.surfaces = {ball(ball_radius)};
  Material& material = scene.surfaces[0].material;
  material.type = type;
  material.specular = glm::dvec3(0.3);
  material.exponent = 5.0;
  scene.camera = {0.3 * scene.lights[0].position, {0, 0, 0}, {0, 1, 0}, 20.0};
  scene.film = {6, 6};
  return scene;
}

// Seen from the light's side of the ball.
double depth_to_light(const Scene& scene) {
  const glm::dvec3& light = scene.lights[0].position;
  const glm::dvec3 facing = ball_radius * glm::normalize(light);
  double depth = 0.0;
  for (std::size_t i = 0; i < scene.medium.size(); ++i) {
    depth += optical_depth(scene.medium.gaussian(i), facing, light);
  }
  return depth;
}

Frame frame_of(const Scene& scene, bool paper_spread) {
  const Settings settings{.airlight = AirlightMethod::paper, .paper_spread = paper_spread};
  return render_frame(scene, settings);
}

}  // namespace

std::vector<ComparedError> measure_surface_light(std::size_t samples) {
  std::vector<ComparedError> rows;
  for (const double depth : {0.1, 0.3, 1.0, 3.0}) {
    const Scene scene = ball_in_fog(depth);
    const SurfaceTruth reference(scene, {.samples = samples});
    rows.push_back({formatted("diffuse ball in homogeneous fog, light at depth %g", depth),
                    reference.scattered_error(frame_of(scene, false)),
                    reference.scattered_error(frame_of(scene, true))});
  }
  const auto add_cloud = [&](std::uint64_t seed, Material::Type type, const char* kind) {
    const Scene scene = ball_in_cloud(seed, type);
    // Its error is larger: fewer samples show it.
    const SurfaceTruth reference(scene, {.samples = samples / 10});
    const Frame ours = frame_of(scene, false);
    const Frame paper = frame_of(scene, true);
    const std::string label =
        formatted("%s ball in a cloud, light outside at depth %.2g", kind, depth_to_light(scene));
    rows.push_back({label, reference.scattered_error(ours), reference.scattered_error(paper)});
    rows.push_back({label + ": of all light", reference.error(ours), reference.error(paper)});
  };
  // The first ten clouds, by increasing optical depth towards the light.
  for (const std::uint64_t seed : {1, 3, 4, 7}) add_cloud(seed, Material::Type::diffuse, "diffuse");
  add_cloud(4, Material::Type::phong, "shiny");
  return rows;
}

SurfaceTruth::SurfaceTruth(const Scene& scene, const SurfaceSampling& sampling)
    : SurfaceTruth(
          scene, sampling,
          [&](const RayCaster& ray_caster, const SurfacePoint& point, const SurfaceSampling& s) {
            return reflected_light(scene, ray_caster, point, s);
          }) {}

SurfaceTruth::SurfaceTruth(const Scene& scene, const SurfaceSampling& sampling, const Run& run) {
  const CameraRays rays(scene.camera, scene.film);
  const RayCaster ray_caster(scene.surfaces);
  std::vector<SurfacePoint> points;
  for (int y = 0; y < scene.film.height; ++y) {
    for (int x = 0; x < scene.film.width; ++x) {
      const glm::dvec3 w = rays.direction(x + 0.5, y + 0.5);
      const SurfaceHit hit = ray_caster.first_hit(rays.eye(), w);
      if (!hit) continue;
      pixels_.push_back(static_cast<std::size_t>(y * scene.film.width + x));
      points.push_back(ray_caster.point(hit, rays.eye(), w, scene.surfaces));
    }
  }
  for (std::size_t k = 0; k < independent_runs; ++k) {
    all_[k].resize(points.size());
    scattered_[k].resize(points.size());
  }
  tbb::parallel_for(std::size_t{0}, independent_runs * points.size(), [&](std::size_t n) {
    const std::size_t k = n / points.size();
    const std::size_t i = n % points.size();
    SurfaceSampling own_sampling = sampling;
    own_sampling.seed += n;
    const ReflectedLight light = run(ray_caster, points[i], own_sampling);
    all_[k][i] = light.attenuated + light.scattered;
    scattered_[k][i] = light.scattered;
  });
}

Runs SurfaceTruth::differences(const Frame& frame) const {
  Runs result = all_;
  for (std::size_t n = 0; n < pixels_.size(); ++n) {
    const std::size_t i = pixels_[n];
    for (std::size_t c = 0; c < 3; ++c) {
      const double got = static_cast<double>(frame.beauty[4 * i + c] - frame.airlight[3 * i + c]) /
                         static_cast<double>(frame.transmittance[3 * i + c]);
      for (auto& run : result) run[n][static_cast<int>(c)] -= got;
    }
  }
  return result;
}

ErrorEstimate SurfaceTruth::error(const Frame& frame) const {
  return unbiased_error(differences(frame), all_);
}

ErrorEstimate SurfaceTruth::scattered_error(const Frame& frame) const {
  return unbiased_error(differences(frame), scattered_);
}

}  // namespace brume
