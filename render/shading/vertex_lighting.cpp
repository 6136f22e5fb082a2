#include "render/shading/vertex_lighting.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <glm/common.hpp>

#include "brume/mesh_arrays.h"
#include "core/scene/placement.h"
#include "render/shading/surface_shading.h"
#include "render/simd/reflection_kernels.h"
#include "render/simd/surface_kernels.h"

namespace brume {
namespace {

using IncidentBlock = std::vector<ShVector<glm::dvec3>>;  // at some points

constexpr auto lighting_block = static_cast<std::size_t>(Tiles::pixels);  // vertices taken together

// Beyond any light, and sums of some of these stay in the range of float.
glm::vec3 bounded(const glm::dvec3& x) {
  return glm::vec3(glm::clamp(x, -1e30, 1e30));
}

// The places of a block of vertices; they have neither normals nor an eye.
SurfacePoints places(const Surface& surface, std::span<const glm::vec3> vertices,
                     std::size_t first) {
  const Placement placement(surface);
  const auto place = [&](std::size_t vertex) {
    return placement.point_to_world(glm::dvec3(vertices[vertex]));
  };
  SurfacePoints points{};
  points.surface = &surface;
  points.count = std::min(lighting_block, vertices.size() - first);
  points.origin = place(first);
  for (std::size_t k = 0; k < points.padded_size(); ++k) {
    const std::size_t vertex = first + std::min(k, points.count - 1);
    points.position.set(k, glm::vec3(place(vertex) - points.origin));
  }
  return points;
}

// light += light from one direction, with factors per band.
template <class Factor>
void add_direction(const ShVector<double>& direction, const glm::dvec3& irradiance, Factor factor,
                   ShVector<glm::dvec3>& light) {
  for (int l = 0; l < light.order(); ++l) {
    const glm::dvec3 band = irradiance * static_cast<double>(factor(l));
    for (int m = -l; m <= l; ++m) light[sh_index(l, m)] += direction[sh_index(l, m)] * band;
  }
}

// light += light of a point light scattered by the medium; traced += its direct light.
std::uint64_t add_light_sphere(const MediumIndex& medium, const SurfaceLighting& lighting,
                               const SurfaceLight& surface_light, const SurfacePoints& points,
                               Settings::Precision precision, IncidentBlock& light,
                               IncidentBlock& traced) {
  thread_local LightAtPoints light_at_points;
  thread_local std::array<PointArray, sh_max_bands> factors;
  point_to_light(points, surface_light.source, light_at_points);
  const std::uint64_t pairs =
      find_depths(medium, surface_light, points, precision, lighting.extinction, light_at_points);
  if (lighting.point) {
    find_spread(light_at_points, points.padded_size(),
                {lighting.point, lighting.distant, static_cast<float>(surface_light.density)},
                false, factors);
  }
  for (std::size_t k = 0; k < points.count; ++k) {
    const glm::dvec3 wi(-light_at_points.paths.x[k], -light_at_points.paths.y[k],
                        -light_at_points.paths.z[k]);
    const ShVector<double> direction = sh_basis(light[k].order(), wi);
    const glm::dvec3 irradiance =
        static_cast<double>(light_at_points.inverse_square[k]) * surface_light.source.intensity;
    const float unscattered = std::exp(-light_at_points.depths[k]);
    add_direction(
        direction, irradiance, [&](int) { return unscattered; }, traced[k]);
    if (!lighting.point) continue;
    add_direction(
        direction, lighting.albedo * irradiance,
        [&](int l) { return factors[static_cast<std::size_t>(l)][k]; }, light[k]);
  }
  return pairs;
}

void add_environment(const SurfaceLighting& lighting, const AverageDepthGrid* average_depth,
                     const SurfacePoints& points, IncidentBlock& light) {
  for_each_incident(lighting, average_depth, points, [&](std::size_t k, const auto& incident) {
    const ShVector<glm::dvec3> sky = incident_light(lighting, incident);
    for (std::size_t i = 0; i < light[k].size(); ++i) light[k][i] += sky[i];
  });
}

}  // namespace

VertexLightingInputs::VertexLightingInputs(const MediumIndex& index,
                                           const SurfaceLighting& lighting,
                                           Settings::Precision arithmetic)
    : medium(index.revision()),
      point(lighting.point),
      distant(lighting.distant),
      environment(lighting.environment ? lighting.environment->revision() : 0),
      incident(lighting.incident ? lighting.incident->revision() : 0),
      fog_depth(lighting.fog_depth),
      fog(lighting.fog),
      albedo(lighting.albedo),
      precision(arithmetic) {
  for (const SurfaceLight& light : lighting.lights) {
    lights.push_back({light.source.position, light.source.intensity, light.source.falloff,
                      light.source.fog, light.density, light.table ? light.table->revision() : 0});
  }
}

VertexLighting::VertexLighting(const MediumIndex& medium, const SurfaceLighting& lighting,
                               const Surface& surface, const SurfaceShading& shading,
                               Settings::Precision precision, const Job& job, std::uint64_t& pairs)
    : rotate_(surface.rotate),
      material_(shading.material),
      order_(shading.transfer->settings.order) {
  const RadianceTransfer& transfer = *shading.transfer;
  const MeshArrays& mesh = to_arrays(*surface.mesh);
  triangles_ = mesh.triangles;
  for (std::size_t s = 0; s < sides_.size(); ++s) {
    if (transfer.sides[s].visibility.empty()) continue;
    sides_[s].radiance.resize(transfer.vertices);
    if (!material_->is_diffuse()) sides_[s].incident.resize(transfer.vertices * sh_size(order_));
  }
  std::atomic<std::uint64_t> pair_count = 0;
  job.parallel_for((transfer.vertices + lighting_block - 1) / lighting_block, [&](std::size_t b) {
    const SurfacePoints points = places(surface, mesh.points, b * lighting_block);
    IncidentBlock light(points.count, ShVector<glm::dvec3>(order_));
    IncidentBlock traced = light;
    for (const SurfaceLight& surface_light : lighting.lights) {
      pair_count +=
          add_light_sphere(medium, lighting, surface_light, points, precision, light, traced);
    }
    if (lighting.environment) add_environment(lighting, shading.average_depth, points, light);
    for (std::size_t k = 0; k < points.count; ++k) {
      receive(transfer, b * lighting_block + k, light[k], traced[k]);
    }
  });
  pairs += pair_count;
}

void VertexLighting::receive(const RadianceTransfer& transfer, std::size_t vertex,
                             const ShVector<glm::dvec3>& light,
                             const ShVector<glm::dvec3>& traced) {
  const bool is_turned = rotate_ != glm::dquat(1.0, 0.0, 0.0, 0.0);
  const auto on_mesh = [&](const ShVector<glm::dvec3>& in_world) {
    return is_turned ? sh_rotate(in_world, glm::conjugate(rotate_)) : in_world;
  };
  const ShVector<glm::dvec3> light_on_mesh = on_mesh(light);
  const ShVector<glm::dvec3> traced_on_mesh =
      transfer.settings.bounces > 0 ? on_mesh(traced) : traced;
  for (std::size_t s = 0; s < sides_.size(); ++s) {
    Side& side = sides_[s];
    if (side.radiance.empty()) continue;
    ReceivedLight received =
        material_->received(light_on_mesh, traced_on_mesh, transfer, static_cast<MeshSide>(s),
                            at_vertex(static_cast<std::uint32_t>(vertex)));
    side.radiance[vertex] = bounded(received.radiance);
    if (side.incident.empty()) continue;
    if (is_turned) received.incident = sh_rotate(received.incident, rotate_);
    for (std::size_t i = 0; i < received.incident.size(); ++i) {
      side.incident[vertex * received.incident.size() + i] = bounded(received.incident[i]);
    }
  }
}

void VertexLighting::add(std::span<const SurfaceHit> hits, const SurfacePoints& points,
                         PointRadiance& radiance) const {
  const bool is_diffuse = material_->is_diffuse();
  const std::size_t size = sh_size(order_);
  std::array<glm::vec3, Tiles::pixels> outgoing;
  std::array<MixedLight, Tiles::pixels> incident;
  for (std::size_t p = 0; p < hits.size(); ++p) {
    outgoing[p] = glm::vec3(0.0f);
    incident[p] = {};
    const Side& side =
        sides_[static_cast<std::size_t>(points.side[p] < 0.0f ? MeshSide::back : MeshSide::front)];
    if (side.radiance.empty()) continue;
    const glm::uvec3& corners = triangles_[hits[p].triangle];
    const glm::vec3 weights(1.0f - hits[p].u - hits[p].v, hits[p].u, hits[p].v);
    for (int k = 0; k < 3; ++k) outgoing[p] += weights[k] * side.radiance[corners[k]];
    if (is_diffuse) continue;
    incident[p].weights = weights;
    for (int k = 0; k < 3; ++k) {
      incident[p].corners[static_cast<std::size_t>(k)] = side.incident.data() + corners[k] * size;
    }
  }
  if (!is_diffuse) {
    PointRadiance reflected;
    reflect(points, material_->table(), std::span(incident).first(hits.size()), size, reflected);
    for (std::size_t p = 0; p < hits.size(); ++p) {
      outgoing[p] += glm::vec3(reflected.r[p], reflected.g[p], reflected.b[p]);
    }
  }
  for (std::size_t p = 0; p < hits.size(); ++p) {
    radiance.r[p] += std::max(outgoing[p].r, 0.0f);
    radiance.g[p] += std::max(outgoing[p].g, 0.0f);
    radiance.b[p] += std::max(outgoing[p].b, 0.0f);
  }
}

}  // namespace brume
