#include "render/cpu/visibility.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <limits>
#include <new>
#include <vector>

#include "core/scene/mesh.h"

namespace brume {
namespace {

// Rays start and end this share of their length away from the surfaces they leave or reach, which
// is a few roundings of float.
constexpr double self_hit_margin = 1e-5;

glm::dvec3 mesh_point(const TriangleMesh& mesh, int vertex) {
  const auto& p = mesh.point(OpenMesh::VertexHandle(vertex));
  return {p[0], p[1], p[2]};
}

glm::dvec3 to_world(const Surface& surface, const glm::dvec3& p) {
  return surface.translate + surface.rotate * (surface.scale * p);
}

struct Placement {
  std::shared_ptr<const TriangleMesh> mesh;
  glm::dvec3 translate;
  glm::dquat rotate;
  double scale;

  explicit Placement(const Surface& s)
      : mesh(s.mesh), translate(s.translate), rotate(s.rotate), scale(s.scale) {}
  bool operator==(const Placement&) const = default;
};

}  // namespace

struct Visibility::Impl {
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;
  std::vector<Placement> placements;
  std::vector<std::vector<glm::uvec3>> triangles;  // vertex indices, per surface
  glm::dvec3 middle{0.0};
  double radius = -1.0;  // of the ball around `middle` that holds all surfaces; < 0: none

  explicit Impl(std::span<const Surface> surfaces) {
    for (const Surface& surface : surfaces) placements.emplace_back(surface);
    glm::dvec3 low(std::numeric_limits<double>::infinity());
    glm::dvec3 high(-std::numeric_limits<double>::infinity());
    for (const Surface& surface : surfaces) {
      for (int v = 0; v < static_cast<int>(surface.mesh->n_vertices()); ++v) {
        const glm::dvec3 p = to_world(surface, mesh_point(*surface.mesh, v));
        low = glm::min(low, p);
        high = glm::max(high, p);
      }
    }
    if (surfaces.empty()) return;
    middle = 0.5 * (low + high);
    device = rtcNewDevice(nullptr);
    if (!device) throw std::bad_alloc();
    scene = rtcNewScene(device);
    rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
    for (const Surface& surface : surfaces) add(surface);
    rtcCommitScene(scene);
  }

  ~Impl() {
    if (scene) rtcReleaseScene(scene);
    if (device) rtcReleaseDevice(device);
  }

  void add(const Surface& surface) {
    const TriangleMesh& mesh = *surface.mesh;
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* vertex = static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0,
                                                               RTC_FORMAT_FLOAT3, 3 * sizeof(float),
                                                               mesh.n_vertices()));
    if (!vertex) throw std::bad_alloc();
    for (int v = 0; v < static_cast<int>(mesh.n_vertices()); ++v) {
      const glm::dvec3 p = to_world(surface, mesh_point(mesh, v)) - middle;
      radius = std::max(radius, glm::length(p));
      for (int k = 0; k < 3; ++k) *vertex++ = static_cast<float>(p[k]);
    }
    auto* index = static_cast<unsigned*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                3 * sizeof(unsigned), mesh.n_faces()));
    if (!index) throw std::bad_alloc();
    auto& own = triangles.emplace_back();
    for (const auto face : mesh.faces()) {
      glm::uvec3 corners(0);
      int k = 0;
      for (const auto v : face.vertices()) corners[k++] = static_cast<unsigned>(v.idx());
      own.push_back(corners);
      for (k = 0; k < 3; ++k) *index++ = corners[k];
    }
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene, geometry);
    rtcReleaseGeometry(geometry);
  }

  [[nodiscard]] RTCRay ray(const glm::dvec3& origin, const glm::dvec3& direction, double tnear,
                           double tfar) const {
    const glm::dvec3 o = origin - middle;
    RTCRay r{};
    r.org_x = static_cast<float>(o.x);
    r.org_y = static_cast<float>(o.y);
    r.org_z = static_cast<float>(o.z);
    r.dir_x = static_cast<float>(direction.x);
    r.dir_y = static_cast<float>(direction.y);
    r.dir_z = static_cast<float>(direction.z);
    r.tnear = static_cast<float>(tnear);
    r.tfar = static_cast<float>(tfar);
    r.mask = ~0u;
    return r;
  }
};

Visibility::Visibility(std::span<const Surface> surfaces)
    : impl_(std::make_unique<Impl>(surfaces)) {}

Visibility::~Visibility() = default;

bool Visibility::empty() const {
  return impl_->placements.empty();
}

bool Visibility::shows(std::span<const Surface> surfaces) const {
  return std::equal(surfaces.begin(), surfaces.end(), impl_->placements.begin(),
                    impl_->placements.end(),
                    [](const Surface& s, const Placement& p) { return Placement(s) == p; });
}

SurfaceHit Visibility::first_hit(const glm::dvec3& origin, const glm::dvec3& direction) const {
  if (empty()) return {};
  // A ray from far away starts at the ball around the surfaces, where float has digits for it.
  const double along = glm::dot(impl_->middle - origin, direction);
  const double skip = std::max(0.0, along - 1.01 * impl_->radius);
  RTCRayHit query{};
  query.ray = impl_->ray(origin + skip * direction, direction, 0.0,
                         std::numeric_limits<double>::infinity());
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcIntersect1(impl_->scene, &context, &query);
  // Triangles near the end of float's range come out infinitely far.
  if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID || !std::isfinite(query.ray.tfar)) return {};
  return {skip + static_cast<double>(query.ray.tfar), static_cast<std::int32_t>(query.hit.geomID),
          query.hit.primID, query.hit.u, query.hit.v};
}

SurfacePoint Visibility::point(const SurfaceHit& hit, const glm::dvec3& origin,
                               const glm::dvec3& direction,
                               std::span<const Surface> surfaces) const {
  SurfacePoint result;
  result.position = origin + hit.distance * direction;
  result.to_eye = -direction;
  result.surface = &surfaces[static_cast<std::size_t>(hit.surface)];
  const Surface& surface = *result.surface;
  const glm::uvec3 corners = impl_->triangles[static_cast<std::size_t>(hit.surface)][hit.triangle];
  const double u = static_cast<double>(hit.u);
  const double v = static_cast<double>(hit.v);
  const glm::dvec3 weights(1.0 - u - v, u, v);
  std::array<glm::dvec3, 3> positions;
  std::array<glm::dvec3, 3> normals;
  glm::dvec3 smooth(0.0);
  for (int k = 0; k < 3; ++k) {
    const auto vertex = static_cast<int>(corners[k]);
    const auto& n = surface.mesh->normal(OpenMesh::VertexHandle(vertex));
    positions[static_cast<std::size_t>(k)] = to_world(surface, mesh_point(*surface.mesh, vertex));
    normals[static_cast<std::size_t>(k)] = surface.rotate * glm::dvec3(n[0], n[1], n[2]);
    smooth += weights[k] * normals[static_cast<std::size_t>(k)];
  }
  glm::dvec3 geometric = glm::cross(positions[1] - positions[0], positions[2] - positions[0]);
  geometric /= std::max(glm::length(geometric), std::numeric_limits<double>::min());
  const double length = glm::length(smooth);
  result.normal = length > 0.0 ? smooth / length : geometric;
  // Both sides of a surface are seen and lit alike.
  if (glm::dot(geometric, direction) > 0.0) geometric *= -1.0;
  const double side = glm::dot(result.normal, geometric) < 0.0 ? -1.0 : 1.0;
  result.normal *= side;

  result.shadow_origin = result.position + self_hit_margin * impl_->radius * geometric;
  for (int k = 0; k < 3; ++k) {
    // How far the point lies below the tangent plane of a corner.
    const glm::dvec3 n = side * normals[static_cast<std::size_t>(k)];
    const double below =
        std::min(glm::dot(result.position - positions[static_cast<std::size_t>(k)], n), 0.0);
    result.shadow_origin -= weights[k] * below * n;
  }
  return result;
}

bool Visibility::blocked(const glm::dvec3& from, const glm::dvec3& to) const {
  if (empty()) return false;
  const glm::dvec3 q = to - from;
  const double distance = glm::length(q);
  if (!(distance > 0.0)) return false;
  const glm::dvec3 direction = q / distance;
  const double along = glm::dot(impl_->middle - from, direction);
  const double skip = std::clamp(along - 1.01 * impl_->radius, 0.0, distance);
  const double margin = self_hit_margin * std::min(distance, 2.0 * impl_->radius);
  RTCRay ray = impl_->ray(from + skip * direction, direction, skip > 0.0 ? 0.0 : margin,
                          distance - skip - margin);
  if (!(ray.tnear < ray.tfar)) return false;
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT;
  rtcOccluded1(impl_->scene, &context, &ray);
  return ray.tfar < 0.0f;
}

}  // namespace brume
