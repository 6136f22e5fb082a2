#pragma once

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x3.hpp>
#include <limits>
#include <memory>
#include <mutex>
#include <new>
#include <type_traits>
#include <vector>

#include "brume/mesh_arrays.h"
#include "core/scene/copies.h"
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
  std::shared_ptr<const CopyPlacements> copies;

  explicit Placed(const Surface& surface)
      : mesh(surface.mesh),
        placement(surface),
        coverage(surface.material),
        copies(surface.placed_copies) {}
  bool operator==(const Placed& other) const {
    return mesh == other.mesh && placement == other.placement && coverage == other.coverage &&
           (copies == other.copies || (copies && other.copies && *copies == *other.copies));
  }

  [[nodiscard]] std::size_t placement_count() const { return 1 + (copies ? copies->size() : 0); }
  [[nodiscard]] Placement placement_of(std::size_t copy) const {
    return copy == 0 ? placement : Placement((*copies)[copy - 1]);
  }
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

// A triangle of a surface, and at which of its placements.
struct PlacedTriangle {
  std::uint32_t surface = 0;
  std::uint32_t copy = 0;
  std::uint32_t triangle = 0;
};

// A surface with copies is a scene of its own, of its mesh around a point of it; each placement is
// an instance of that. Others are geometries with vertices in the world.
struct RayCaster::Impl {
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;
  std::vector<Placed> surfaces;
  std::vector<std::vector<Vertex>> vertices;   // per surface; of one with copies in its mesh
  std::vector<glm::dvec3> mesh_centers;        // per surface, that vertices are relative to then
  std::vector<RTCScene> instanced;             // per surface; null: it has no copies
  std::vector<std::uint32_t> first_instances;  // per surface: the geometry of its own placement
  std::vector<std::uint32_t> surfaces_of_instances;  // by geometry, beyond those of surfaces
  std::vector<std::uint32_t> first_triangles;        // per surface, in raster.corners
  std::size_t triangle_count = 0;                    // of all, copies not counted
  // Made on first use.
  mutable std::once_flag raster_flag;
  mutable RasterTriangles raster;
  Box bounds;
  std::vector<Box> surface_bounds;
  glm::dvec3 center{0.0};
  double radius = -1.0;  // of the ball around `center` that holds all surfaces; < 0: none
  glm::dvec3 channels;
  bool has_panes = false;
  bool is_compact = false;  // one of the scenes

  Impl(std::span<const Surface> built_from, const glm::dvec3& weights) : channels(weights) {
    if (built_from.empty()) return;
    constexpr double infinite = std::numeric_limits<double>::infinity();
    bounds = {glm::dvec3(infinite), glm::dvec3(-infinite)};
    std::vector<Box> boxes;
    for (const Surface& surface : built_from) {
      surfaces.emplace_back(surface);
      const MeshBox around = world_box(surface);
      const Box box{around.low, around.high};
      surface_bounds.push_back(box);
      bounds = {glm::min(bounds.low, box.low), glm::max(bounds.high, box.high)};
      if (box.low.x <= box.high.x) boxes.push_back(box);
    }
    center = coordinate_center(bounds, boxes);
    for (const Surface& surface : built_from) {
      radius = std::max(radius, farthest_vertex(surface, center));
    }
    device = rtcNewDevice(nullptr);
    if (!device) throw std::bad_alloc();
    std::size_t own_triangles = 0;
    for (std::size_t s = 0; s < surfaces.size(); ++s) {
      if (!surfaces[s].copies) own_triangles += mesh(s).triangles.size();
    }
    scene = new_scene(own_triangles);
    for (std::size_t s = 0; s < surfaces.size(); ++s) add(s);
    for (std::size_t s = 0; s < surfaces.size(); ++s) add_instances(s);
    rtcCommitScene(scene);
    if (rtcGetDeviceError(device) == RTC_ERROR_OUT_OF_MEMORY) throw std::bad_alloc();
  }

  ~Impl() {
    if (scene) rtcReleaseScene(scene);
    for (const RTCScene own_scene : instanced) {
      if (own_scene) rtcReleaseScene(own_scene);
    }
    if (device) rtcReleaseDevice(device);
  }

  // `triangles` of a scene: large ones take half the memory, for rays that are a little slower.
  [[nodiscard]] RTCScene new_scene(std::size_t triangles) {
    constexpr std::size_t large = 2'000'000;
    const RTCScene result = rtcNewScene(device);
    const auto compact = triangles > large ? RTC_SCENE_FLAG_COMPACT : RTC_SCENE_FLAG_NONE;
    is_compact = is_compact || triangles > large;
    rtcSetSceneFlags(result, RTC_SCENE_FLAG_ROBUST | scene_flag_filter | compact);
    return result;
  }

  [[nodiscard]] const MeshArrays& mesh(std::size_t surface) const {
    return to_arrays(*surfaces[surface].mesh);
  }

  void add(std::size_t s) {
    const Placed& placed = surfaces[s];
    const MeshArrays& arrays = mesh(s);
    const bool has_copies = placed.copies != nullptr;
    const MeshBox box = box_of(*placed.mesh);
    mesh_centers.push_back(has_copies ? 0.5 * (box.low + box.high) : glm::dvec3(0.0));
    auto& own_vertices = vertices.emplace_back(arrays.points.size());
    tbb::parallel_for(std::size_t{0}, own_vertices.size(), [&](std::size_t v) {
      const glm::dvec3 p(arrays.points[v]);
      const glm::dvec3 n(arrays.normals[v]);
      own_vertices[v] = has_copies ? Vertex{glm::vec3(p - mesh_centers[s]), arrays.normals[v]}
                                   : Vertex{glm::vec3(placed.placement.point_to_world(p) - center),
                                            glm::vec3(placed.placement.normal_to_world(n))};
    });
    first_triangles.push_back(static_cast<std::uint32_t>(triangle_count));
    triangle_count += arrays.triangles.size();
    // Embree reads the very arrays.
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                               own_vertices.data(), 0, sizeof(Vertex), own_vertices.size());
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                               arrays.triangles.data(), 0, sizeof(glm::uvec3),
                               arrays.triangles.size());
    if (placed.coverage.is_pane()) has_panes = true;
    if (!placed.coverage.is_opaque()) {
      rtcSetGeometryUserData(geometry, this);
      rtcSetGeometryIntersectFilterFunction(geometry, meet_coverage);
      rtcSetGeometryOccludedFilterFunction(geometry, meet_coverage);
    }
    rtcCommitGeometry(geometry);
    instanced.push_back(has_copies ? new_scene(arrays.triangles.size()) : nullptr);
    if (has_copies) {
      rtcAttachGeometry(instanced[s], geometry);
      rtcCommitScene(instanced[s]);
    } else {
      rtcAttachGeometryByID(scene, geometry, static_cast<unsigned>(s));
    }
    rtcReleaseGeometry(geometry);
  }

  void add_instances(std::size_t s) {
    first_instances.push_back(
        static_cast<std::uint32_t>(surfaces.size() + surfaces_of_instances.size()));
    if (!instanced[s]) return;
    for (std::size_t copy = 0; copy < surfaces[s].placement_count(); ++copy) {
      RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_INSTANCE);
      rtcSetGeometryInstancedScene(geometry, instanced[s]);
      rtcSetGeometryTimeStepCount(geometry, 1);
      const Placement placement = surfaces[s].placement_of(copy);
      const glm::mat3 axes(placement.scale * glm::mat3_cast(placement.rotate));
      const glm::vec3 origin(placement.point_to_world(mesh_centers[s]) - center);
      const glm::mat4x3 transform(axes[0], axes[1], axes[2], origin);
      rtcSetGeometryTransform(geometry, 0, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR, &transform);
      rtcCommitGeometry(geometry);
      rtcAttachGeometryByID(scene, geometry, first_instances[s] + static_cast<std::uint32_t>(copy));
      rtcReleaseGeometry(geometry);
      surfaces_of_instances.push_back(static_cast<std::uint32_t>(s));
    }
  }

  // Embree 3.13 loops forever in coherent packets of shadow rays that meet instances or triangles
  // of compact scenes.
  [[nodiscard]] RayOrder packet_order() const {
    return is_compact || !surfaces_of_instances.empty() ? RayOrder::incoherent : RayOrder::coherent;
  }

  // What Embree found.
  [[nodiscard]] PlacedTriangle placed_triangle(unsigned geometry, unsigned instance,
                                               unsigned triangle) const {
    if (instance == RTC_INVALID_GEOMETRY_ID) return {geometry, 0, triangle};
    const std::uint32_t surface = surfaces_of_instances[instance - surfaces.size()];
    return {surface, instance - first_instances[surface], triangle};
  }
  [[nodiscard]] PlacedTriangle placed_triangle(const RTCFilterFunctionNArguments& found,
                                               unsigned i) const {
    return placed_triangle(RTCHitN_geomID(found.hit, found.N, i),
                           RTCHitN_instID(found.hit, found.N, i, 0),
                           RTCHitN_primID(found.hit, found.N, i));
  }
  static PlacedTriangle placed_triangle(const SurfaceHit& hit) {
    return {static_cast<std::uint32_t>(hit.surface), hit.copy, hit.triangle};
  }

  [[nodiscard]] SurfaceHit hit(const FloatSegment& segment, float tfar, unsigned geometry,
                               unsigned instance, unsigned triangle, float u, float v) const {
    // Triangles near the end of float's range come out infinitely far.
    if (geometry == RTC_INVALID_GEOMETRY_ID || !std::isfinite(tfar)) return {};
    const PlacedTriangle found = placed_triangle(geometry, instance, triangle);
    return {segment.skip + static_cast<double>(tfar),
            static_cast<std::int32_t>(found.surface),
            triangle,
            u,
            v,
            found.copy};
  }
  [[nodiscard]] SurfaceHit hit(const FloatSegment& segment, const RTCRayHit& query) const {
    return hit(segment, query.ray.tfar, query.hit.geomID, query.hit.instID[0], query.hit.primID,
               query.hit.u, query.hit.v);
  }

  // Its corners in the world, relative to the center.
  [[nodiscard]] std::array<Vertex, 3> corners(const PlacedTriangle& of) const {
    const glm::uvec3& indices = mesh(of.surface).triangles[of.triangle];
    const std::vector<Vertex>& all = vertices[of.surface];
    std::array<Vertex, 3> result{all[indices.x], all[indices.y], all[indices.z]};
    if (!instanced[of.surface]) return result;
    const Placement placement = surfaces[of.surface].placement_of(of.copy);
    for (Vertex& vertex : result) {
      const glm::dvec3 p = mesh_centers[of.surface] + glm::dvec3(vertex.position);
      vertex = {glm::vec3(placement.point_to_world(p) - center),
                glm::vec3(placement.normal_to_world(glm::dvec3(vertex.normal)))};
    }
    return result;
  }

  const RasterTriangles& raster_triangles() const {
    std::call_once(raster_flag, [this] {
      for (std::size_t s = 0; s < surfaces.size(); ++s) {
        const glm::uvec3 first_vertex(static_cast<unsigned>(raster.x.size()));
        for (const Vertex& vertex : vertices[s]) raster.add_vertex(vertex.position);
        for (const glm::uvec3& indices : mesh(s).triangles)
          raster.corners.push_back(first_vertex + indices);
      }
      raster.pad();
    });
    return raster;
  }

  // The weights of a triangle's corners by those of the second and third.
  [[nodiscard]] static glm::dvec3 barycentric(double u, double v) { return {1.0 - u - v, u, v}; }

  // The share of light that passes a surface there, in the ray caster's channels.
  [[nodiscard]] double passing(const Coverage& coverage, const MeshValues& values) const {
    const double crossing = glm::dot(channels, coverage.transmitted(values));
    return 1.0 - coverage.covered(values) * (1.0 - crossing);
  }

  // Embree's filter of surfaces with holes and of panes. All queries are a CoverageQuery.
  static void meet_coverage(const RTCFilterFunctionNArguments* found);

  [[nodiscard]] MeshFrame mesh_frame(const SurfaceHit& hit) const {
    const PlacedTriangle found = placed_triangle(hit);
    const MeshArrays& arrays = mesh(found.surface);
    MeshFrame frame;
    if (arrays.texcoords.empty() && arrays.colors.empty()) return frame;
    const std::array<MeshValues, 3> values = corner_values(arrays, found.triangle);
    frame.values =
        interpolate(values, barycentric(static_cast<double>(hit.u), static_cast<double>(hit.v)));
    if (arrays.texcoords.empty()) return frame;
    const std::array<Vertex, 3> own_corners = corners(found);
    std::array<glm::dvec3, 3> positions;
    for (std::size_t k = 0; k < 3; ++k) positions[k] = glm::dvec3(own_corners[k].position);
    const auto texture_frame = [&](std::size_t set) -> TextureFrame {
      return {
          positions,
          {values[0].texcoords[set].uv, values[1].texcoords[set].uv, values[2].texcoords[set].uv}};
    };
    frame.textures[0] = texture_frame(0);
    frame.textures[1] = arrays.second_texcoords.empty() ? frame.textures[0] : texture_frame(1);
    return frame;
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
