#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <memory>
#include <new>
#include <type_traits>
#include <utility>
#include <vector>

#include "brume/mesh_arrays.h"
#include "core/scene/materials/coverage.h"
#include "core/scene/placement.h"
#include "render/geometry/rounding.h"
#include "render/visibility/coordinate_center.h"
#include "render/visibility/embree.h"
#include "render/visibility/ray_caster.h"

namespace brume {

// A surface that the caster was built from.
struct Placed {
  std::shared_ptr<const TriangleMesh> mesh;
  Placement placement;
  Coverage coverage;

  explicit Placed(const Surface& surface)
      : mesh(surface.mesh), placement(surface), coverage(surface.material) {}
  bool operator==(const Placed&) const = default;
};

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

// A query that meets holes and panes.
struct CoverageQuery : RayQuery {
  enum class Panes {
    hit,
    passed,
    attenuate,  // multiply `transmittance`
    collected   // in `panes`
  };
  Panes mode = Panes::hit;
  std::array<float, 16> transmittance;  // by the ray's id
  std::vector<PaneHit>* panes = nullptr;

  explicit CoverageQuery(RayOrder order, RTCFilterFunctionN hit_filter = nullptr)
      : RayQuery(order, hit_filter) {
    transmittance.fill(1.0f);
  }
};

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
  std::vector<Box> surface_bounds;
  glm::dvec3 center{0.0};
  double radius = -1.0;  // of the ball around `center` that holds all surfaces; < 0: none
  glm::dvec3 channels;
  bool has_panes = false;

  Impl(std::span<const Surface> built_from, const glm::dvec3& weights) : channels(weights) {
    if (built_from.empty()) return;
    constexpr double infinite = std::numeric_limits<double>::infinity();
    bounds = {glm::dvec3(infinite), glm::dvec3(-infinite)};
    std::vector<Box> boxes;
    std::vector<MeshArrays> meshes;
    std::vector<std::vector<glm::dvec3>> points;
    for (const Surface& surface : built_from) {
      surfaces.emplace_back(surface);
      meshes.push_back(to_arrays(*surface.mesh));
      points.push_back(world_points(surface, meshes.back().points));
      Box box{glm::dvec3(infinite), glm::dvec3(-infinite)};
      for (const glm::dvec3& p : points.back()) {
        box = {glm::min(box.low, p), glm::max(box.high, p)};
      }
      surface_bounds.push_back(box);
      bounds = {glm::min(bounds.low, box.low), glm::max(bounds.high, box.high)};
      if (!points.back().empty()) boxes.push_back(box);
    }
    center = coordinate_center(bounds, boxes);
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
    const Coverage& coverage = surfaces[vertices.size() - 1].coverage;
    if (coverage.is_pane()) has_panes = true;
    if (!coverage.is_opaque()) {
      rtcSetGeometryUserData(geometry, this);
      rtcSetGeometryIntersectFilterFunction(geometry, meet_coverage);
      rtcSetGeometryOccludedFilterFunction(geometry, meet_coverage);
    }
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene, geometry);
    rtcReleaseGeometry(geometry);
  }

  [[nodiscard]] glm::dvec2 texcoord(std::size_t surface, std::size_t triangle, float u,
                                    float v) const {
    if (texcoords[surface].empty()) return glm::dvec2(0.0);
    const glm::uvec3& corners = triangles[surface][triangle];
    const auto at = [&](unsigned corner) { return glm::dvec2(texcoords[surface][corner]); };
    const double first = 1.0 - static_cast<double>(u) - static_cast<double>(v);
    return first * at(corners.x) + static_cast<double>(u) * at(corners.y) +
           static_cast<double>(v) * at(corners.z);
  }

  // The share of light that passes a surface there, in the ray caster's channels.
  [[nodiscard]] double passing(const Coverage& coverage, const glm::dvec2& uv,
                               double footprint) const {
    const double crossing = glm::dot(channels, coverage.transmitted(uv, footprint));
    return 1.0 - coverage.covered(uv, footprint) * (1.0 - crossing);
  }

  // Embree's filter of surfaces with holes and of panes. All queries are a CoverageQuery.
  static void meet_coverage(const RTCFilterFunctionNArguments* found);

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

  // The segment between two points, ends excluded.
  [[nodiscard]] FloatSegment between(const glm::dvec3& start, const glm::dvec3& direction,
                                     double distance) const {
    const double along = glm::dot(center - start, direction);
    const double skip = std::clamp(along - RayCaster::start_radii * radius, 0.0, distance);
    const double tnear = skip > 0.0 ? 0.0 : rounding_at(start - center);
    return {skip, tnear,
            distance - skip - rounding_at(start + distance * direction - center) -
                RayCaster::light_margin * distance};
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

}  // namespace brume
