#include "render/visibility/ray_caster.h"

#include <algorithm>
#include <cmath>
#include <mutex>

#include "brume/limits.h"
#include "render/geometry/edge_on.h"
#include "render/visibility/ray_caster_impl.h"

namespace brume {
namespace {

constexpr std::size_t packet = 16;
// Triangles of pixels that see lights are these and those after them.
constexpr std::uint32_t first_light_triangle =
    std::numeric_limits<std::uint32_t>::max() - static_cast<std::uint32_t>(limits::lights);

// Rays that start at one point or are parallel, and see no triangle edge-on.
template <class Impl>
struct ViewQuery : CoverageQuery {
  const Impl& impl;
  glm::dvec3 eye;
  std::optional<glm::dvec3> direction;  // of parallel rays

  ViewQuery(const Impl& surfaces, const glm::dvec3& origin, RayOrder order)
      : CoverageQuery(order, refuse_edge_on), impl(surfaces), eye(origin - surfaces.center) {}

 private:
  static void refuse_edge_on(const RTCFilterFunctionNArguments* found) {
    const auto& view = static_cast<const ViewQuery&>(*found->context);
    for (unsigned i = 0; i < found->N; ++i) {
      if (found->valid[i] == 0) continue;
      const auto corners = view.impl.corners(view.impl.placed_triangle(*found, i));
      const std::array<glm::vec3, 3> positions{corners[0].position, corners[1].position,
                                               corners[2].position};
      const bool is_refused =
          view.direction ? is_along(positions, *view.direction) : is_edge_on(positions, view.eye);
      if (is_refused) found->valid[i] = 0;
    }
  }
};

}  // namespace

RayCaster::RayCaster(std::span<const Surface> surfaces, const glm::dvec3& channels)
    : impl_(std::make_unique<Impl>(surfaces, channels)) {}

RayCaster::~RayCaster() = default;

const Box& RayCaster::bounds() const {
  return impl_->bounds;
}
const Box& RayCaster::surface_bounds(std::size_t surface) const {
  return impl_->surface_bounds[surface];
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
  result.reserve(size());
  for_each_triangle([&result](const WorldTriangle& triangle) { result.push_back(triangle); });
  return result;
}

void RayCaster::for_each_triangle(const std::function<void(const WorldTriangle&)>& visit) const {
  WorldTriangle triangle;
  for (std::uint32_t s = 0; s < impl_->surfaces.size(); ++s) {
    const std::vector<glm::uvec3>& all = impl_->mesh(s).triangles;
    triangle.surface = s;
    for (std::uint32_t t = 0; t < all.size(); ++t) {
      triangle.index = t;
      triangle.vertices = all[t];
      const std::array<Vertex, 3> corners = impl_->corners({s, 0, t});
      for (std::size_t k = 0; k < 3; ++k) {
        triangle.positions[k] = corners[k].position;
        triangle.normals[k] = corners[k].normal;
      }
      visit(triangle);
    }
  }
}

std::uint32_t RayCaster::index_of(const SurfaceHit& hit) const {
  return impl_->first_triangles[static_cast<std::size_t>(hit.surface)] + hit.triangle;
}

bool RayCaster::empty() const {
  return impl_->surfaces.empty();
}

std::size_t RayCaster::size() const {
  return impl_->triangle_count;
}

namespace {

double nearest_of(double nearest, const glm::dvec3& /*origin*/, const glm::dvec3& /*direction*/) {
  return nearest;
}
double nearest_of(const auto& nearest, const glm::dvec3& origin, const glm::dvec3& direction) {
  return nearest(origin, direction);
}

}  // namespace

bool RayCaster::shows(std::span<const Surface> surfaces, const glm::dvec3& channels) const {
  if (has_panes() && channels != impl_->channels) return false;
  return std::equal(surfaces.begin(), surfaces.end(), impl_->surfaces.begin(),
                    impl_->surfaces.end(),
                    [](const Surface& s, const Placed& p) { return Placed(s) == p; });
}

SurfaceHit RayCaster::first_hit(const glm::dvec3& origin, const glm::dvec3& direction) const {
  return cast(origin, direction, {}, 0.0);
}

SurfaceHit RayCaster::first_hit(const CameraRays& rays, double x, double y) const {
  const glm::dvec3 w = rays.direction(x, y);
  const glm::dvec3 origin = rays.origin(x, y);
  return cast(origin, w, rays.is_parallel() ? std::optional(w) : std::nullopt,
              rays.clip_end(origin, w));
}

SurfaceHit RayCaster::cast(const glm::dvec3& origin, const glm::dvec3& direction,
                           const std::optional<glm::dvec3>& parallel, double nearest) const {
  if (empty()) return {};
  FloatSegment segment = impl_->to_first_hit(origin, direction);
  segment.tnear = std::max(segment.tnear, nearest - segment.skip);
  RTCRayHit query{};
  impl_->set(query.ray, 0, origin, direction, segment);
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  ViewQuery view(*impl_, origin, RayOrder::incoherent);
  view.direction = parallel;
  view.intersect(impl_->scene, query);
  return impl_->hit(segment, query);
}

HitsOnRay RayCaster::hits_on_ray(const glm::dvec3& origin, const glm::dvec3& direction,
                                 double nearest) const {
  if (empty()) return {};
  FloatSegment segment = impl_->to_first_hit(origin, direction);
  segment.tnear = std::max(nearest - segment.skip, 0.0);
  HitsOnRay result;
  RTCRayHit query{};
  impl_->set(query.ray, 0, origin, direction, segment);
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  ViewQuery view(*impl_, origin, RayOrder::incoherent);
  view.mode = CoverageQuery::Panes::collected;
  view.panes = &result.panes;
  view.intersect(impl_->scene, query);
  result.end = impl_->hit(segment, query);
  for (PaneHit& pane : result.panes) pane.hit.distance += segment.skip;
  std::erase_if(result.panes,
                [&](const PaneHit& pane) { return !(pane.hit.distance < result.end.distance); });
  std::ranges::sort(result.panes, {}, [](const PaneHit& pane) { return pane.hit.distance; });
  // A ray meets a pane twice on an edge of two triangles.
  const auto repeated = std::ranges::unique(result.panes, [](const PaneHit& a, const PaneHit& b) {
    return a.hit.surface == b.hit.surface && a.hit.copy == b.hit.copy &&
           b.hit.distance - a.hit.distance <= position_rounding * b.hit.distance;
  });
  result.panes.erase(repeated.begin(), repeated.end());
  return result;
}

void RayCaster::cast(const glm::dvec3& eye, std::span<const glm::dvec3> directions,
                     std::span<const glm::dvec3> offsets, std::span<SurfaceHit> hits,
                     const auto& nearest, bool passes_panes) const {
  std::fill(hits.begin(), hits.end(), SurfaceHit{});
  if (empty()) return;
  const bool near = offsets.empty() && is_near(eye);
  ViewQuery view(*impl_, eye, impl_->packet_order());
  if (passes_panes) view.mode = CoverageQuery::Panes::passed;
  if (!offsets.empty()) view.direction = directions.front();
  for (std::size_t first = 0; first < directions.size(); first += packet) {
    alignas(64) std::array<int, packet> valid{};
    std::array<FloatSegment, packet> segments;
    RTCRayHit16 query;
    const std::size_t count = std::min(packet, directions.size() - first);
    for (std::size_t k = 0; k < count; ++k) {
      const glm::dvec3 origin = offsets.empty() ? eye : eye + offsets[first + k];
      if (!near) segments[k] = impl_->to_first_hit(origin, directions[first + k]);
      segments[k].tnear =
          std::max(nearest_of(nearest, origin, directions[first + k]) - segments[k].skip, 0.0);
      impl_->set(query.ray, k, origin, directions[first + k], segments[k]);
      query.hit.geomID[k] = RTC_INVALID_GEOMETRY_ID;
      query.hit.instID[0][k] = RTC_INVALID_GEOMETRY_ID;
      valid[k] = -1;
    }
    view.intersect(impl_->scene, valid.data(), query);
    for (std::size_t k = 0; k < count; ++k) {
      hits[first + k] =
          impl_->hit(segments[k], query.ray.tfar[k], query.hit.geomID[k], query.hit.instID[0][k],
                     query.hit.primID[k], query.hit.u[k], query.hit.v[k]);
    }
  }
}

void RayCaster::first_hits(const glm::dvec3& origin, std::span<const glm::dvec3> directions,
                           std::span<SurfaceHit> hits, double nearest) const {
  cast(origin, directions, {}, hits, nearest);
}

void RayCaster::opaque_hits(const glm::dvec3& origin, std::span<const glm::dvec3> directions,
                            std::span<SurfaceHit> hits, double nearest) const {
  cast(origin, directions, {}, hits, nearest, true);
}

void RayCaster::first_hits(const CameraRays& rays, std::span<const glm::dvec3> directions,
                           std::span<const glm::dvec3> offsets, std::span<SurfaceHit> hits) const {
  cast(rays.eye(), directions, offsets, hits,
       [&rays](const glm::dvec3& origin, const glm::dvec3& w) { return rays.clip_end(origin, w); });
}

bool RayCaster::can_rasterize(const CameraRays& rays) const {
  // Products of three lengths must stay in the range of float, small triangles' too.
  return !rays.is_parallel() && is_near(rays.eye()) && impl_->radius > 1e-6 && impl_->radius < 1e6;
}

Raster RayCaster::raster(const CameraRays& rays, const Film& film, const Job& job) const {
  return {impl_->raster_triangles(), rays, rays.eye() - impl_->center, film, job};
}

SurfaceHit RayCaster::hit_of(const RasterPixel& pixel, std::uint32_t copy) const {
  if (!std::isfinite(pixel.distance)) return {};
  if (pixel.triangle >= first_light_triangle) {
    return SurfaceHit::on_light(static_cast<double>(pixel.distance),
                                pixel.triangle - first_light_triangle);
  }
  const std::vector<std::uint32_t>& first = impl_->first_triangles;
  const auto surface = std::ranges::upper_bound(first, pixel.triangle) - first.begin() - 1;
  return {static_cast<double>(pixel.distance),
          static_cast<std::int32_t>(surface),
          pixel.triangle - first[static_cast<std::size_t>(surface)],
          pixel.u,
          pixel.v,
          copy};
}

RasterPixel RayCaster::pixel_of(const SurfaceHit& hit) const {
  if (!hit) return {std::numeric_limits<float>::infinity()};
  const std::uint32_t triangle =
      hit.is_light() ? first_light_triangle + static_cast<std::uint32_t>(hit.light())
                     : index_of(hit);
  return {static_cast<float>(hit.distance), triangle, hit.u, hit.v};
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
  CoverageQuery shadow(impl_->packet_order());
  shadow.mode = CoverageQuery::Panes::attenuate;
  const auto light_rounding = static_cast<float>(rounding_at(glm::dvec3(position)));
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
    query.tnear[k] = 0.0f;
    query.tfar[k] =
        1.0f - static_cast<float>(light_margin) - light_rounding / light.paths.length[i];
    query.time[k] = 0.0f;
    query.mask[k] = ~0u;
    query.id[k] = static_cast<unsigned>(k);
    query.flags[k] = 0u;
    valid[k] = k < count ? -1 : 0;
  }
  if (has_panes()) {
    // In packets a ray may meet a triangle more than once.
    for (std::size_t k = 0; k < count; ++k) {
      RTCRay ray =
          rtcGetRayFromRayN(reinterpret_cast<RTCRayN*>(&query), packet, static_cast<unsigned>(k));
      shadow.occluded(impl_->scene, ray);
      query.tfar[k] = ray.tfar;
    }
  } else {
    shadow.occluded(impl_->scene, valid.data(), query);
  }
  for (std::size_t k = 0; k < count; ++k) {
    light.lit[pending[k]] = query.tfar[k] >= 0.0f ? shadow.transmittance[k] : 0.0f;
  }
}

double RayCaster::transmittance(const glm::dvec3& start, const glm::dvec3& end) const {
  const glm::dvec3 q = end - start;
  const double distance = glm::length(q);
  if (empty() || !(distance > 0.0)) return 1.0;
  const FloatSegment segment = impl_->between(start, q / distance, distance);
  if (!(segment.tnear < segment.tfar)) return 1.0;
  CoverageQuery shadow(RayOrder::incoherent);
  shadow.mode = CoverageQuery::Panes::attenuate;
  RTCRay query;
  impl_->set(query, 0, start, q / distance, segment);
  shadow.occluded(impl_->scene, query);
  return query.tfar < 0.0f ? 0.0 : static_cast<double>(shadow.transmittance[0]);
}

double RayCaster::transmittance(const glm::dvec3& origin, const glm::dvec3& direction,
                                double length) const {
  if (has_panes()) return hits_on_ray(origin, direction).passing(length);
  return first_hit(origin, direction).distance < length ? 0.0 : 1.0;
}

std::shared_ptr<const RayCaster> shared_ray_caster(std::span<const Surface> surfaces,
                                                   const glm::dvec3& channels) {
  static std::mutex mutex;
  static std::vector<std::weak_ptr<const RayCaster>> all;
  {
    const std::lock_guard lock(mutex);
    std::erase_if(all, [](const auto& each) { return each.expired(); });
    for (const auto& each : all) {
      const std::shared_ptr<const RayCaster> held = each.lock();
      if (held && held->shows(surfaces, channels)) return held;
    }
  }
  auto made = std::make_shared<const RayCaster>(surfaces, channels);
  const std::lock_guard lock(mutex);
  all.push_back(made);
  return made;
}

}  // namespace brume
