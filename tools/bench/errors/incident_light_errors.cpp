#include "tools/bench/errors/incident_light_errors.h"

#include <tbb/parallel_for.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "core/transport/average_depth.h"
#include "render/reference/surface_reference.h"
#include "render/scattering/environment_light.h"
#include "render/scattering/source_function.h"
#include "tools/bench/measure/report_text.h"
#include "tools/bench/scenes/benchmark_scenes.h"
#include "tools/bench/scenes/hash_random.h"

namespace brume {
namespace {

Runs reference_at(const Scene& scene, const std::vector<Receiver>& receivers, std::size_t samples) {
  Surface white;
  white.material.reflectance = glm::dvec3(1.0);
  const RayCaster nothing({});
  Runs runs;
  for (auto& run : runs) run.resize(receivers.size());
  tbb::parallel_for(std::size_t{0}, independent_runs * receivers.size(), [&](std::size_t n) {
    const std::size_t i = n % receivers.size();
    SurfacePoint point;
    point.position = receivers[i].position;
    point.normal = point.to_eye = receivers[i].normal;
    point.surface = &white;
    const ReflectedLight light =
        reflected_light(scene, nothing, point, {.samples = samples, .seed = n + 1});
    runs[n / receivers.size()][i] = light.attenuated + light.scattered;
  });
  return runs;
}

Box box_around(const std::vector<Receiver>& receivers) {
  Box box{receivers[0].position, receivers[0].position};
  for (const Receiver& r : receivers) {
    box.low = glm::min(box.low, r.position);
    box.high = glm::max(box.high, r.position);
  }
  return box;
}

Scene cloud_under(std::shared_ptr<const RadianceMap> sky, double depth, double anisotropy = 0.0) {
  Scene scene = cloud(30, depth);
  scene.lights.clear();
  scene.optics.anisotropy = anisotropy;
  scene.environment.emplace().map = std::move(sky);
  return scene;
}

ComparedError error_on_grid(const std::string& label, const Scene& scene,
                            const std::vector<Receiver>& receivers, const EnvironmentLight& light,
                            const Runs& reference, const SourceGridSize& size) {
  IncidentOptics optics;
  optics.anisotropy = scene.optics.anisotropy;
  SourceFunction source;
  source.update({&*scene.environment,
                 scene.medium,
                 scene.optics.anisotropy,
                 0.0,
                 {},
                 {},
                 SourceGrid::Receivers{box_around(receivers), optics},
                 size,
                 {}},
                Job{});
  Runs grid = reference;
  Runs average = reference;
  for (std::size_t i = 0; i < receivers.size(); ++i) {
    const Receiver& r = receivers[i];
    SurfacePoints point{};
    point.count = 1;
    std::array<NodeRadiance, 1> light_at_point;
    IncidentLookup(source.grid(), r.position).incident(point, light_at_point);
    const NodeRadiance& incident = light_at_point[0];
    const auto depth = static_cast<float>(average_depth(scene.medium, 0.0, r.position));
    for (std::size_t k = 0; k < independent_runs; ++k) {
      grid[k][i] -= glm::dvec3(diffuse_light(r.normal, incident, 1.0, &light));
      average[k][i] -= glm::dvec3(light.diffuse(r.normal, light.incident(depth, 1.0)));
    }
  }
  return {label, unbiased_error(grid, reference), unbiased_error(average, reference)};
}

}  // namespace

std::vector<Receiver> receivers_around(const glm::dvec3& center) {
  HashRandom random(5);
  std::vector<Receiver> receivers;
  for (int i = 0; i < 8; ++i) {
    const glm::dvec3 n = glm::normalize(random.in_ball());
    receivers.push_back({center + 0.1 * n, n});
  }
  return receivers;
}

ComparedError incident_light_error(const std::string& label, const Scene& scene,
                                   const std::vector<Receiver>& receivers, std::size_t samples,
                                   const SourceGridSize& size) {
  return arriving_light_errors(label, scene, receivers, samples, std::span(&size, 1)).front();
}

std::vector<ComparedError> arriving_light_errors(const std::string& label, const Scene& scene,
                                                 const std::vector<Receiver>& receivers,
                                                 std::size_t samples,
                                                 std::span<const SourceGridSize> sizes) {
  const EnvironmentLight light(*scene.environment, ScatterTable::distant());
  const Runs reference = reference_at(scene, receivers, samples);
  std::vector<ComparedError> rows;
  for (const SourceGridSize& size : sizes) {
    rows.push_back(error_on_grid(label, scene, receivers, light, reference, size));
  }
  return rows;
}

std::vector<ComparedError> measure_incident_light(std::size_t samples) {
  const std::vector<Receiver> inside = receivers_around({0, 0, 0});
  const std::vector<Receiver> edge = receivers_around({0.7, 0.3, 0});
  const std::vector<Receiver> below = receivers_around({0, -2, 0});
  std::vector<ComparedError> rows;
  const auto add = [&](const std::string& label, const Scene& scene,
                       const std::vector<Receiver>& receivers) {
    rows.push_back(incident_light_error(label, scene, receivers, samples));
  };
  for (const double depth : {0.5, 2.0, 10.0}) {
    const Scene scene = cloud_under(uniform_sky(), depth);
    add(formatted("inside a cloud %g deep", depth), scene, inside);
    add(formatted("at the edge of a cloud %g deep", depth), scene, edge);
    add(formatted("one cloud's size below a cloud %g deep", depth), scene, below);
  }
  add("one cloud's size below a cloud 10 deep, under a sun", cloud_under(sunny_sky(), 10.0), below);
  for (const double g : {-0.6, 0.6}) {
    add(formatted("inside a cloud 2 deep, anisotropy %g", g), cloud_under(uniform_sky(), 2.0, g),
        inside);
  }
  Scene dense;
  dense.environment.emplace().map = uniform_sky();
  dense.medium.append({{0, 0, 0}, 1.0, 10.0});
  add("beside a Gaussian 18 deep, facing away from it", dense,
      {{{0, 1.5, 0}, {0, 1, 0}}, {{1.5, 0, 0}, {1, 0, 0}}});
  add("beside a Gaussian 18 deep, facing it", dense,
      {{{0, 1.5, 0}, {0, -1, 0}}, {{1.5, 0, 0}, {-1, 0, 0}}});
  return rows;
}

}  // namespace brume
