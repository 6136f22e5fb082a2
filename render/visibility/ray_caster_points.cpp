// Hit points of RayCaster.
#include <array>
#include <glm/geometric.hpp>
#include <limits>

#include "render/geometry/rounding.h"
#include "render/simd/surface_kernels.h"
#include "render/visibility/ray_caster_impl.h"
#include "render/visibility/surface_point.h"

namespace brume {

SurfacePoint RayCaster::point(const SurfaceHit& hit, const glm::dvec3& origin,
                              const glm::dvec3& direction,
                              std::span<const Surface> surfaces) const {
  SurfacePoint result;
  result.position = origin + hit.distance * direction;
  result.to_eye = -direction;
  result.surface = &surfaces[static_cast<std::size_t>(hit.surface)];
  const std::array<Vertex, 3> corners = impl_->corners(Impl::placed_triangle(hit));
  const double u = static_cast<double>(hit.u);
  const double v = static_cast<double>(hit.v);
  const glm::dvec3 weights(1.0 - u - v, u, v);
  std::array<glm::vec3, 3> corner_positions;  // relative to the center
  std::array<glm::dvec3, 3> positions;
  std::array<glm::dvec3, 3> normals;
  glm::dvec3 smooth(0.0);
  for (int k = 0; k < 3; ++k) {
    const auto c = static_cast<std::size_t>(k);
    const Vertex& vertex = corners[c];
    corner_positions[c] = vertex.position;
    positions[c] = impl_->center + glm::dvec3(vertex.position);
    normals[c] = glm::dvec3(vertex.normal);
    smooth += weights[k] * normals[c];
  }
  glm::dvec3 geometric = glm::cross(positions[1] - positions[0], positions[2] - positions[0]);
  geometric /= std::max(glm::length(geometric), std::numeric_limits<double>::min());
  const double length = glm::length(smooth);
  result.normal = length > 0.0 ? smooth / length : geometric;
  // Surfaces are two-sided.
  if (glm::dot(geometric, direction) > 0.0) geometric *= -1.0;
  const double side = glm::dot(result.normal, geometric) < 0.0 ? -1.0 : 1.0;
  result.normal *= side;

  result.position -= glm::dot(result.position - positions[0], geometric) * geometric;
  result.shadow_origin =
      result.position +
      off_plane_rounding(geometric, coordinate_sizes(corner_positions)) * geometric;
  for (int k = 0; k < 3; ++k) {
    // How far the point lies below the tangent plane of a corner.
    const glm::dvec3 n = side * normals[static_cast<std::size_t>(k)];
    const double below =
        std::min(glm::dot(result.position - positions[static_cast<std::size_t>(k)], n), 0.0);
    result.shadow_origin -= weights[k] * below * n;
  }
  const Material& material = result.surface->material;
  if (material.type == Material::Type::metallic_roughness) {
    const MeshFrame frame = impl_->mesh_frame(hit);
    const MaterialPoint found =
        material_at(material.metallic_roughness, frame, 0.0, side, result.normal);
    result.color = frame.values.color;
    result.ggx = found.reflection;
    result.emitted = found.emitted;
  }
  return result;
}

void RayCaster::points(std::span<const SurfaceHit> hits, const glm::dvec3& origin,
                       std::span<const glm::vec3> directions, std::span<const glm::dvec3> offsets,
                       std::span<const Surface> surfaces, SurfacePoints& points) const {
  const auto surface = static_cast<std::size_t>(hits[0].surface);
  points.surface = &surfaces[surface];
  points.count = hits.size();
  points.origin = impl_->center;
  const glm::dvec3 eye = origin - impl_->center;
  const bool near = is_near(origin);
  PointTriangles triangles;
  for (std::size_t i = 0; i < points.padded_size(); ++i) {
    const std::size_t start = std::min(i, hits.size() - 1);
    const SurfaceHit& hit = hits[start];
    const std::array<Vertex, 3> corners = impl_->corners(Impl::placed_triangle(hit));
    for (std::size_t c = 0; c < 3; ++c) {
      triangles.position[c].set(i, corners[c].position);
      triangles.normal[c].set(i, corners[c].normal);
    }
    // Weights of corners lose digits on triangles that are larger than the distance, distances
    // where the eye is far away.
    const glm::vec3& first = corners[0].position;
    const glm::dvec3 start_of_ray = offsets.empty() ? eye : eye + offsets[start];
    points.position.set(
        i, near ? glm::vec3(start_of_ray + hit.distance * glm::dvec3(directions[start]))
                : first + hit.u * (corners[1].position - first) +
                      hit.v * (corners[2].position - first));
    points.u[i] = hit.u;
    points.v[i] = hit.v;
    points.to_eye.set(i, -directions[start]);
  }
  interpolate_points(triangles, points);
  if (points.surface->material.type == Material::Type::metallic_roughness) {
    find_materials(hits, points);
  }
}

void RayCaster::find_materials(std::span<const SurfaceHit> hits, SurfacePoints& points) const {
  std::array<MeshFrame, Tiles::pixels> frames;
  std::array<double, Tiles::pixels> distances;
  const std::size_t varied = is_varied(*points.surface) ? points.count : 0;
  for (std::size_t k = 0; k < varied; ++k) {
    frames[k] = impl_->mesh_frame(hits[k]);
    distances[k] = hits[k].distance;
  }
  brume::find_materials(std::span(frames).first(varied), std::span(distances).first(varied),
                        points);
}

}  // namespace brume
