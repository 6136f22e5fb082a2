// Holes and panes of RayCaster.
#include <algorithm>

#include "render/visibility/ray_caster_impl.h"

namespace brume {
namespace {

// Less light than this is none.
constexpr float negligible = 1e-6f;

}  // namespace

void RayCaster::Impl::meet_coverage(const RTCFilterFunctionNArguments* found) {
  const auto& impl = *static_cast<const Impl*>(found->geometryUserPtr);
  auto& query = static_cast<CoverageQuery&>(*found->context);
  for (unsigned i = 0; i < found->N; ++i) {
    if (found->valid[i] == 0) continue;
    const auto [surface, copy, triangle] = impl.placed_triangle(*found, i);
    const float u = RTCHitN_u(found->hit, found->N, i);
    const float v = RTCHitN_v(found->hit, found->N, i);
    const MeshValues values = values_in(
        impl.mesh(surface), triangle, barycentric(static_cast<double>(u), static_cast<double>(v)));
    const Coverage& coverage = impl.surfaces[surface].coverage;
    if (coverage.is_hole(values)) {
      found->valid[i] = 0;
      continue;
    }
    if (!coverage.is_pane() || query.mode == CoverageQuery::Panes::hit) continue;
    if (query.mode == CoverageQuery::Panes::passed) {
      found->valid[i] = 0;
      continue;
    }
    const double passing = impl.passing(coverage, values);
    if (query.mode == CoverageQuery::Panes::collected) {
      const double distance = static_cast<double>(RTCRayN_tfar(found->ray, found->N, i));
      query.panes->push_back(
          {{distance, static_cast<std::int32_t>(surface), triangle, u, v, copy}, passing});
      found->valid[i] = 0;
      continue;
    }
    float& transmittance = query.transmittance[RTCRayN_id(found->ray, found->N, i)];
    transmittance *= static_cast<float>(passing);
    if (transmittance > negligible) found->valid[i] = 0;
  }
}

double HitsOnRay::passing(double distance) const {
  if (end.distance < distance) return 0.0;
  double share = 1.0;
  for (const PaneHit& pane : panes) {
    if (pane.hit.distance >= distance) break;
    share *= pane.passing;
  }
  return share;
}

bool RayCaster::has_panes() const {
  return impl_->has_panes;
}

SurfaceHit RayCaster::first_hit_by_chance(const glm::dvec3& origin, const glm::dvec3& direction,
                                          const std::function<double()>& draw) const {
  if (!has_panes()) return first_hit(origin, direction);
  const HitsOnRay on_ray = hits_on_ray(origin, direction);
  for (const PaneHit& pane : on_ray.panes) {
    if (draw() >= pane.passing) return pane.hit;
  }
  return on_ray.end;
}

SurfaceHit RayCaster::next_hit(const glm::dvec3& origin, const glm::dvec3& direction,
                               const SurfaceHit& before) const {
  const HitsOnRay on_ray = hits_on_ray(origin, direction);
  // By its triangle: the same distance may be rounded otherwise.
  auto next = std::ranges::find_if(on_ray.panes, [&before](const PaneHit& pane) {
    return pane.hit.surface == before.surface && pane.hit.triangle == before.triangle &&
           pane.hit.copy == before.copy;
  });
  if (next != on_ray.panes.end()) {
    ++next;
  } else {
    next = std::ranges::upper_bound(on_ray.panes, before.distance, {},
                                    [](const PaneHit& pane) { return pane.hit.distance; });
  }
  return next != on_ray.panes.end() ? next->hit : on_ray.end;
}

bool RayCaster::is_pane(const SurfaceHit& hit) const {
  return has_panes() && hit && !hit.is_light() &&
         impl_->surfaces[static_cast<std::size_t>(hit.surface)].coverage.is_pane();
}

SeenPane RayCaster::pane(const SurfaceHit& hit, double width) const {
  if (!is_pane(hit)) return {};
  const Coverage& coverage = impl_->surfaces[static_cast<std::size_t>(hit.surface)].coverage;
  const MeshValues values = impl_->mesh_frame(hit).with_width(width);
  SeenPane seen;
  seen.covered = coverage.covered(values);
  seen.passing = impl_->passing(coverage, values);
  const glm::dvec3 transmitted = coverage.transmitted(values);
  seen.opaque = seen.covered * (1.0 - glm::dot(all_channels, transmitted));
  return seen;
}

double RayCaster::reflected_by_chance(const SurfaceHit& hit) const {
  if (!has_panes()) return 1.0;
  const SeenPane seen = pane(hit, 0.0);
  return seen.passing < 1.0 ? seen.covered / (1.0 - seen.passing) : 0.0;
}

}  // namespace brume
