#include "render/visibility/ray_caster.h"
#include "core/scene/camera_rays.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <new>
#include <type_traits>
#include <vector>

#include "brume/mesh_arrays.h"
#include "core/scene/placement.h"
#include "render/geometry/edge_on.h"

#include "render/simd/surface_kernels.h"
#include "render/visibility/embree.h"
#include "render/visibility/surface_materials.h"

namespace brume {
namespace {

// What the caster was built from.
struct Placed {
  std::shared_ptr<const TriangleMesh> mesh;
  Placement placement;

  explicit Placed(const Surface& surface) : mesh(surface.mesh), placement(surface) {}
  bool operator==(const Placed&) const = default;
};

}  // namespace

struct Vertex {
  glm::vec3 position;  // relative to the middle of the surfaces
  glm::vec3 normal;    // any length
};

// A ray for Embree, relative to the center of the surfaces, starting at `skip`.
struct FloatSegment {
  double skip = 0.0;
  double tnear = 0.0;
  double tfar = std::numeric_limits<double>::infinity();
};

constexpr std::size_t packet = 16;

struct RayCaster::Impl {
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;
  std::vector<Placed> surfaces;
  std::vector<std::vector<glm::uvec3>> triangles;  // vertex indices, per surface
  std::vector<std::vector<Vertex>> vertices;       // per surface
  std::vector<std::vector<glm::vec2>> texcoords;   // per surface; empty: none
  RasterTriangles raster;
  std::vector<std::uint32_t> first_triangles;  // per surface, in raster.corners
  Box bounds;
  glm::dvec3 center{0.0};
  double radius = -1.0;  // of the ball around `center` that holds all surfaces; < 0: none

  explicit Impl(std::span<const Surface> built_from) {
    if (built_from.empty()) return;
    glm::dvec3 low(std::numeric_limits<double>::infinity());
    glm::dvec3 high(-std::numeric_limits<double>::infinity());
    std::vector<MeshArrays> meshes;
    std::vector<std::vector<glm::dvec3>> points;
    for (const Surface& surface : built_from) {
      surfaces.emplace_back(surface);
      meshes.push_back(to_arrays(*surface.mesh));
      points.push_back(world_points(surface, meshes.back().points));
      for (const glm::dvec3& p : points.back()) {
        low = glm::min(low, p);
        high = glm::max(high, p);
      }
    }
    bounds = {low, high};
    center = 0.5 * (low + high);
    device = rtcNewDevice(nullptr);
    if (!device) throw std::bad_alloc();
    scene = rtcNewScene(device);
    rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST | scene_flag_filter);
    for (std::size_t s = 0; s < surfaces.size(); ++s) {
      add(surfaces[s].placement, points[s], std::move(meshes[s]));
    }
    raster.pad();
    rtcCommitScene(scene);
  }

  ~Impl() {
    if (scene) rtcReleaseScene(scene);
    if (device) rtcReleaseDevice(device);
  }

  void add(const Placement& placement, std::span<const glm::dvec3> points, MeshArrays mesh) {
    auto& own_vertices = vertices.emplace_back();
    for (std::size_t v = 0; v < points.size(); ++v) {
      const glm::dvec3 p = points[v] - center;
      own_vertices.push_back(
          {glm::vec3(p), glm::vec3(placement.normal_to_world(glm::dvec3(mesh.normals[v])))});
      radius = std::max(radius, glm::length(p));
    }
    texcoords.push_back(std::move(mesh.texcoords));
    const auto& own_triangles = triangles.emplace_back(std::move(mesh.triangles));
    const glm::uvec3 first_vertex(static_cast<unsigned>(raster.x.size()));
    first_triangles.push_back(static_cast<std::uint32_t>(raster.corners.size()));
    for (const Vertex& vertex : own_vertices) raster.add_vertex(vertex.position);
    for (const glm::uvec3& corners : own_triangles)
      raster.corners.push_back(first_vertex + corners);
    // Embree reads the very arrays.
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                               own_vertices.data(), 0, sizeof(Vertex), own_vertices.size());
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                               own_triangles.data(), 0, sizeof(glm::uvec3), own_triangles.size());
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene, geometry);
    rtcReleaseGeometry(geometry);
  }

  [[nodiscard]] TextureFrame texture_frame(const SurfaceHit& hit) const {
    const auto surface = static_cast<std::size_t>(hit.surface);
    if (texcoords[surface].empty()) return {};
    const glm::uvec3& corners = triangles[surface][hit.triangle];
    std::array<glm::dvec3, 3> positions;
    std::array<glm::dvec2, 3> own_texcoords;
    for (int k = 0; k < 3; ++k) {
      positions[static_cast<std::size_t>(k)] = glm::dvec3(vertices[surface][corners[k]].position);
      own_texcoords[static_cast<std::size_t>(k)] = glm::dvec2(texcoords[surface][corners[k]]);
    }
    const double u = static_cast<double>(hit.u);
    const double v = static_cast<double>(hit.v);
    return {positions, own_texcoords, {1.0 - u - v, u, v}};
  }

  // A ray from far away starts at the ball around the surfaces, where float has digits for it.
  [[nodiscard]] FloatSegment to_first_hit(const glm::dvec3& origin,
                                          const glm::dvec3& direction) const {
    return {std::max(0.0, glm::dot(center - origin, direction) - RayCaster::start_radii * radius)};
  }

  // Of the way between two points, ends excluded.
  [[nodiscard]] FloatSegment between(const glm::dvec3& start, const glm::dvec3& direction,
                                     double distance) const {
    const double along = glm::dot(center - start, direction);
    const double skip = std::clamp(along - RayCaster::start_radii * radius, 0.0, distance);
    const double margin = self_hit_margin * std::min(distance, 2.0 * radius);
    return {skip, skip > 0.0 ? 0.0 : margin, distance - skip - margin};
  }

  // Sets lane `k` of RTCRay16 or the only one of RTCRay.
  void set(auto& ray, std::size_t k, const glm::dvec3& origin, const glm::dvec3& direction,
           const FloatSegment& segment) const {
    const auto put = [k](auto& field, auto value) {
      if constexpr (std::is_array_v<std::remove_reference_t<decltype(field)>>) {
        field[k] = value;
      } else {
        field = value;
      }
    };
    const glm::dvec3 o = origin - center + segment.skip * direction;
    put(ray.org_x, static_cast<float>(o.x));
    put(ray.org_y, static_cast<float>(o.y));
    put(ray.org_z, static_cast<float>(o.z));
    put(ray.dir_x, static_cast<float>(direction.x));
    put(ray.dir_y, static_cast<float>(direction.y));
    put(ray.dir_z, static_cast<float>(direction.z));
    put(ray.tnear, static_cast<float>(segment.tnear));
    put(ray.tfar, static_cast<float>(segment.tfar));
    put(ray.time, 0.0f);
    put(ray.mask, ~0u);
    put(ray.id, 0u);
    put(ray.flags, 0u);
  }
};

namespace {

// Rays that start at one point, and see no triangle edge-on.
struct ViewQuery : RayQuery {
  const std::vector<std::vector<Vertex>>& vertices;
  const std::vector<std::vector<glm::uvec3>>& triangles;
  glm::dvec3 eye;
  double height;

  ViewQuery(const auto& impl, const glm::dvec3& origin, RayOrder order)
      : RayQuery(order, refuse_edge_on),
        vertices(impl.vertices),
        triangles(impl.triangles),
        eye(origin - impl.center),
        height(edge_on_height(eye, impl.radius)) {}

 private:
  static void refuse_edge_on(const RTCFilterFunctionNArguments* found) {
    const auto& view = static_cast<const ViewQuery&>(*found->context);
    for (unsigned i = 0; i < found->N; ++i) {
      if (found->valid[i] == 0) continue;
      const unsigned surface = RTCHitN_geomID(found->hit, found->N, i);
      const unsigned triangle = RTCHitN_primID(found->hit, found->N, i);
      const std::vector<Vertex>& all = view.vertices[surface];
      const glm::uvec3& corners = view.triangles[surface][triangle];
      const std::array<glm::vec3, 3> positions{all[corners.x].position, all[corners.y].position,
                                               all[corners.z].position};
      if (is_edge_on(positions, view.eye, view.height)) found->valid[i] = 0;
    }
  }
};

SurfaceHit hit(const FloatSegment& segment, float tfar, unsigned geometry, unsigned triangle,
               float u, float v) {
  // Triangles near the end of float's range come out infinitely far.
  if (geometry == RTC_INVALID_GEOMETRY_ID || !std::isfinite(tfar)) return {};
  return {segment.skip + static_cast<double>(tfar), static_cast<std::int32_t>(geometry), triangle,
          u, v};
}

}  // namespace

RayCaster::RayCaster(std::span<const Surface> surfaces) : impl_(std::make_unique<Impl>(surfaces)) {}

RayCaster::~RayCaster() = default;

const Box& RayCaster::bounds() const {
  return impl_->bounds;
}
const glm::dvec3& RayCaster::center() const {
  return impl_->center;
}
double RayCaster::radius() const {
  return impl_->radius;
}
bool RayCaster::is_near(const glm::dvec3& origin) const {
  return glm::length(origin - impl_->center) < near_radii * impl_->radius;
}

std::vector<WorldTriangle> RayCaster::triangles() const {
  std::vector<WorldTriangle> result;
  for (std::size_t s = 0; s < impl_->triangles.size(); ++s) {
    const std::vector<Vertex>& vertices = impl_->vertices[s];
    for (std::size_t t = 0; t < impl_->triangles[s].size(); ++t) {
      WorldTriangle& triangle = result.emplace_back();
      triangle.surface = static_cast<std::uint32_t>(s);
      triangle.index = static_cast<std::uint32_t>(t);
      triangle.vertices = impl_->triangles[s][t];
      for (int k = 0; k < 3; ++k) {
        const Vertex& vertex = vertices[impl_->triangles[s][t][k]];
        triangle.positions[static_cast<std::size_t>(k)] = vertex.position;
        triangle.normals[static_cast<std::size_t>(k)] = vertex.normal;
      }
    }
  }
  return result;
}

std::uint32_t RayCaster::index_of(const SurfaceHit& hit) const {
  return impl_->first_triangles[static_cast<std::size_t>(hit.surface)] + hit.triangle;
}

bool RayCaster::empty() const {
  return impl_->surfaces.empty();
}

std::size_t RayCaster::size() const {
  return impl_->raster.corners.size();
}

bool RayCaster::shows(std::span<const Surface> surfaces) const {
  return std::equal(surfaces.begin(), surfaces.end(), impl_->surfaces.begin(),
                    impl_->surfaces.end(),
                    [](const Surface& s, const Placed& p) { return Placed(s) == p; });
}

SurfaceHit RayCaster::first_hit(const glm::dvec3& origin, const glm::dvec3& direction) const {
  if (empty()) return {};
  const FloatSegment segment = impl_->to_first_hit(origin, direction);
  RTCRayHit query{};
  impl_->set(query.ray, 0, origin, direction, segment);
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  ViewQuery view(*impl_, origin, RayOrder::incoherent);
  view.intersect(impl_->scene, query);
  return hit(segment, query.ray.tfar, query.hit.geomID, query.hit.primID, query.hit.u, query.hit.v);
}

void RayCaster::first_hits(const glm::dvec3& origin, std::span<const glm::dvec3> directions,
                           std::span<SurfaceHit> hits, double nearest) const {
  std::fill(hits.begin(), hits.end(), SurfaceHit{});
  if (empty()) return;
  const bool near = is_near(origin);
  ViewQuery view(*impl_, origin, RayOrder::coherent);
  for (std::size_t first = 0; first < directions.size(); first += packet) {
    alignas(64) std::array<int, packet> valid{};
    std::array<FloatSegment, packet> segments;
    RTCRayHit16 query;
    const std::size_t count = std::min(packet, directions.size() - first);
    for (std::size_t k = 0; k < count; ++k) {
      if (!near) segments[k] = impl_->to_first_hit(origin, directions[first + k]);
      segments[k].tnear = std::max(nearest - segments[k].skip, 0.0);
      impl_->set(query.ray, k, origin, directions[first + k], segments[k]);
      query.hit.geomID[k] = RTC_INVALID_GEOMETRY_ID;
      query.hit.instID[0][k] = RTC_INVALID_GEOMETRY_ID;
      valid[k] = -1;
    }
    view.intersect(impl_->scene, valid.data(), query);
    for (std::size_t k = 0; k < count; ++k) {
      hits[first + k] = hit(segments[k], query.ray.tfar[k], query.hit.geomID[k],
                            query.hit.primID[k], query.hit.u[k], query.hit.v[k]);
    }
  }
}

bool RayCaster::can_rasterize(const CameraRays& rays) const {
  // Products of three lengths must stay in the range of float, small triangles' too.
  return is_near(rays.eye()) && impl_->radius > 1e-6 && impl_->radius < 1e6;
}

Raster RayCaster::raster(const CameraRays& rays, const Film& film, const Job& job) const {
  const glm::dvec3 eye = rays.eye() - impl_->center;
  return {impl_->raster, rays, eye, edge_on_height(eye, impl_->radius), film, job};
}

SurfaceHit RayCaster::hit_of(const RasterPixel& pixel) const {
  if (!std::isfinite(pixel.distance)) return {};
  const std::vector<std::uint32_t>& first = impl_->first_triangles;
  const auto surface = std::ranges::upper_bound(first, pixel.triangle) - first.begin() - 1;
  return {static_cast<double>(pixel.distance), static_cast<std::int32_t>(surface),
          pixel.triangle - first[static_cast<std::size_t>(surface)], pixel.u, pixel.v};
}

RasterPixel RayCaster::pixel_of(const SurfaceHit& hit) const {
  if (!hit) return {std::numeric_limits<float>::infinity()};
  return {static_cast<float>(hit.distance), index_of(hit), hit.u, hit.v};
}

double RayCaster::min_gap() const {
  return 1e-6 * impl_->radius;
}

SurfacePoint RayCaster::point(const SurfaceHit& hit, const glm::dvec3& origin,
                              const glm::dvec3& direction,
                              std::span<const Surface> surfaces) const {
  SurfacePoint result;
  result.position = origin + hit.distance * direction;
  result.to_eye = -direction;
  result.surface = &surfaces[static_cast<std::size_t>(hit.surface)];
  const glm::uvec3 corners = impl_->triangles[static_cast<std::size_t>(hit.surface)][hit.triangle];
  const double u = static_cast<double>(hit.u);
  const double v = static_cast<double>(hit.v);
  const glm::dvec3 weights(1.0 - u - v, u, v);
  std::array<glm::dvec3, 3> positions;
  std::array<glm::dvec3, 3> normals;
  glm::dvec3 smooth(0.0);
  const std::vector<Vertex>& vertices = impl_->vertices[static_cast<std::size_t>(hit.surface)];
  for (int k = 0; k < 3; ++k) {
    const Vertex& vertex = vertices[corners[k]];
    const auto c = static_cast<std::size_t>(k);
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

  result.shadow_origin = result.position + self_hit_margin * impl_->radius * geometric;
  for (int k = 0; k < 3; ++k) {
    // How far the point lies below the tangent plane of a corner.
    const glm::dvec3 n = side * normals[static_cast<std::size_t>(k)];
    const double below =
        std::min(glm::dot(result.position - positions[static_cast<std::size_t>(k)], n), 0.0);
    result.shadow_origin -= weights[k] * below * n;
  }
  const Material& material = result.surface->material;
  if (material.type == Material::Type::metallic_roughness) {
    const MaterialPoint found = material_at(material.metallic_roughness, impl_->texture_frame(hit),
                                            0.0, side, result.normal);
    result.ggx = found.reflection;
    result.emitted = found.emitted;
  }
  return result;
}

void RayCaster::points(std::span<const SurfaceHit> hits, std::span<const glm::vec3> directions,
                       std::span<const Surface> surfaces, SurfacePoints& points) const {
  const auto surface = static_cast<std::size_t>(hits[0].surface);
  const std::vector<glm::uvec3>& all_corners = impl_->triangles[surface];
  const std::vector<Vertex>& vertices = impl_->vertices[surface];
  points.surface = &surfaces[surface];
  points.count = hits.size();
  points.origin = impl_->center;
  PointTriangles triangles;
  for (std::size_t i = 0; i < points.padded_size(); ++i) {
    const std::size_t start = std::min(i, hits.size() - 1);
    const SurfaceHit& hit = hits[start];
    const glm::uvec3& corners = all_corners[hit.triangle];
    for (std::size_t c = 0; c < 3; ++c) {
      const Vertex& vertex = vertices[corners[static_cast<int>(c)]];
      triangles.position[c].set(i, vertex.position);
      triangles.normal[c].set(i, vertex.normal);
    }
    points.u[i] = hit.u;
    points.v[i] = hit.v;
    points.to_eye.set(i, -directions[start]);
  }
  interpolate_points(triangles, static_cast<float>(self_hit_margin * impl_->radius), points);
  if (points.surface->material.type == Material::Type::metallic_roughness) {
    find_materials(hits, points);
  }
}

void RayCaster::find_materials(std::span<const SurfaceHit> hits, SurfacePoints& points) const {
  std::array<TextureFrame, Tiles::pixels> frames;
  std::array<double, Tiles::pixels> distances;
  const std::size_t textured =
      has_textures(points.surface->material.metallic_roughness) ? points.count : 0;
  for (std::size_t k = 0; k < textured; ++k) {
    frames[k] = impl_->texture_frame(hits[k]);
    distances[k] = hits[k].distance;
  }
  brume::find_materials(std::span(frames).first(textured), std::span(distances).first(textured),
                        points);
}

void RayCaster::trace_shadow_rays(const SurfacePoints& points, const glm::vec3& position,
                                  LightAtPoints& light) const {
  std::array<std::uint8_t, Tiles::pixels> facing;
  std::size_t count = 0;
  for (std::size_t i = 0; i < points.padded_size(); ++i) {
    light.lit[i] = 0.0f;
    if (i < points.count && light.cosine[i] > 0.0f) facing[count++] = static_cast<std::uint8_t>(i);
  }
  for (std::size_t first = 0; first < count; first += packet) {
    cast_shadow_rays(points, position, std::span(facing).first(count).subspan(first), light);
  }
}

// Packs the first points of `pending` into a ray packet.
void RayCaster::cast_shadow_rays(const SurfacePoints& points, const glm::vec3& position,
                                 std::span<const std::uint8_t> pending,
                                 LightAtPoints& light) const {
  RayQuery shadow(RayOrder::coherent);
  const auto margin = static_cast<float>(self_hit_margin);
  const float max_offset = margin * 2.0f * static_cast<float>(impl_->radius);
  const std::size_t count = std::min(packet, pending.size());
  alignas(64) std::array<int, packet> valid;
  RTCRay16 query;
  for (std::size_t k = 0; k < packet; ++k) {
    const std::size_t i = pending[std::min(k, count - 1)];
    const float x = points.shadow_origin.x[i];
    const float y = points.shadow_origin.y[i];
    const float z = points.shadow_origin.z[i];
    query.org_x[k] = x;
    query.org_y[k] = y;
    query.org_z[k] = z;
    // Parametrised so that the light is at t = 1.
    query.dir_x[k] = position.x - x;
    query.dir_y[k] = position.y - y;
    query.dir_z[k] = position.z - z;
    const float offset = std::min(margin, max_offset / light.paths.length[i]);
    query.tnear[k] = offset;
    query.tfar[k] = 1.0f - offset;
    query.time[k] = 0.0f;
    query.mask[k] = ~0u;
    query.id[k] = 0u;
    query.flags[k] = 0u;
    valid[k] = k < count ? -1 : 0;
  }
  shadow.occluded(impl_->scene, valid.data(), query);
  for (std::size_t k = 0; k < count; ++k) {
    light.lit[pending[k]] = query.tfar[k] >= 0.0f ? 1.0f : 0.0f;
  }
}

bool RayCaster::occluded(const glm::dvec3& start, const glm::dvec3& end) const {
  const glm::dvec3 q = end - start;
  const double distance = glm::length(q);
  if (empty() || !(distance > 0.0)) return false;
  const FloatSegment segment = impl_->between(start, q / distance, distance);
  if (!(segment.tnear < segment.tfar)) return false;
  RayQuery shadow(RayOrder::incoherent);
  RTCRay query;
  impl_->set(query, 0, start, q / distance, segment);
  shadow.occluded(impl_->scene, query);
  return query.tfar < 0.0f;
}

}  // namespace brume
