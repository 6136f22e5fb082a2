// The cost of precomputed radiance transfer.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "core/scene/lights/radiance_map.h"
#include "core/scene/mesh.h"
#include "render/renderer.h"
#include "render/transfer/radiance_transfer.h"
#include "render/transfer/transfer_store.h"
#include "tests/render/test_meshes.h"
#include "tools/bench/scenes/benchmark_scenes.h"

namespace brume {
namespace {

// A ball of 70,225 vertices with bumps that shadow and light each other.
std::shared_ptr<const TriangleMesh> bumpy_ball() {
  MeshArrays mesh;
  add_patch(mesh, 264, [](double u, double v) {
    const double theta = std::numbers::pi * u;
    const double phi = -2.0 * std::numbers::pi * v;
    const auto at = [](double t, double p) {
      const double r = 1.0 + 0.1 * std::sin(8.0 * t) * std::sin(8.0 * p) * std::sin(t);
      return r * glm::dvec3(std::sin(t) * std::cos(p), std::sin(t) * std::sin(p), -std::cos(t));
    };
    const double step = 1e-5;
    const double t = std::clamp(theta, step, std::numbers::pi - step);
    const glm::dvec3 n =
        glm::cross(at(t, phi + step) - at(t, phi - step), at(t + 1e-6, phi) - at(t - 1e-6, phi));
    const glm::dvec3 p = at(theta, phi);
    return MeshVertex{p, glm::normalize(glm::dot(n, p) < 0.0 ? -n : n)};
  });
  return to_mesh(mesh);
}

// Order 6 with 256 directions, shadows alone and by number of bounces. relative_error is that of
// the light of a white sky, rms over vertices, against 4096 directions.
void transfer_of_70000_vertices(benchmark::State& state) {
  const std::shared_ptr<const TriangleMesh> mesh = bumpy_ball();
  TransferSettings settings{.bounces = static_cast<int>(state.range(0))};
  RadianceTransfer transfer;
  const double before = cpu_seconds();
  for (auto _ : state) transfer = *radiance_transfer(mesh, settings);
  state.counters["cpu_seconds"] = cpu_seconds() - before;
  settings.directions = 4096;
  settings.bounces = 0;
  settings.order = 1;
  const RadianceTransfer reference = *radiance_transfer(mesh, settings);
  double error2 = 0.0;
  double sum2 = 0.0;
  double shadowed = 0.0;
  for (std::uint32_t v = 0; v < mesh->n_vertices(); ++v) {
    const double a = transfer.reflected(MeshSide::front, 0, at_vertex(v))[0];
    const double b = reference.reflected(MeshSide::front, 0, at_vertex(v))[0];
    error2 += (a - b) * (a - b);
    sum2 += b * b;
    shadowed += 1.0 - b * std::sqrt(4.0 * std::numbers::pi);
  }
  const auto n = static_cast<double>(mesh->n_vertices());
  state.counters["vertices"] = n;
  state.counters["in_shadow"] = shadowed / n;
  state.counters["relative_error"] = std::sqrt(error2 / sum2);
}
BENCHMARK(transfer_of_70000_vertices)
    ->Arg(0)
    ->Arg(3)
    ->Iterations(1)
    ->UseRealTime()
    ->Unit(benchmark::kSecond);

// The light at its vertices after fog, lights or environment have changed: a frame of one pixel,
// the light a little brighter each time. With interreflection; of a diffuse material and of
// Phong's.
void light_of_70000_vertices(benchmark::State& state) {
  Scene scene;
  Surface& surface = scene.surfaces.emplace_back();
  surface.mesh = bumpy_ball();
  surface.transfer = Surface::Transfer::interreflection;
  if (state.range(0) != 0) {
    surface.material.type = Material::Type::phong;
    surface.material.specular = glm::dvec3(0.4);
    surface.material.exponent = 20.0;
  }
  scene.medium.append({{0.5, 0.5, 1.0}, 1.0, 0.3});
  scene.lights.push_back({{2, 3, 2}, {10, 10, 10}, {}});
  scene.environment.emplace().map =
      std::make_shared<const RadianceMap>(RadianceMap{1, 1, {glm::vec3(1.0f)}});
  scene.camera.eye = {0, 0, 4};
  const auto transfers = std::make_shared<TransferStore>();
  transfers->make(std::array{transfer_request(surface)}, {});
  Renderer renderer(transfers);
  const auto render = [&] {
    static_cast<void>(
        renderer.render(scene, scene.camera, {1, 1}, {.airlight = AirlightMethod::paper}));
  };
  render();
  const double before = cpu_seconds();
  for (auto _ : state) {
    scene.lights[0].intensity *= 1.01;
    render();
  }
  state.counters["cpu_ms"] =
      1e3 * (cpu_seconds() - before) / static_cast<double>(state.iterations());
}
BENCHMARK(light_of_70000_vertices)
    ->ArgName("phong")
    ->Arg(0)
    ->Arg(1)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace brume
