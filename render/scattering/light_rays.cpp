#include "render/scattering/light_rays.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numbers>

#include "core/math/basis.h"
#include "core/math/golden_angle.h"
#include "core/math/infinity.h"
#include "render/geometry/rounding.h"

namespace brume {
namespace {

// Distance from which on points stand for the cells of a light that shines everywhere: their light
// is 2% below the mean there [spacings].
constexpr double near_spacings = 3.0;

// Rays are this far apart there: what nodes get is within 0.5% [spacings].
constexpr double ray_gap = 0.43;

// What one task traces.
constexpr std::size_t rays_together = 16;

// 1 - cos of the half angle of a cone that holds all directions in which a light shines.
double cone_versine(const LightFalloff& falloff) {
  if (falloff.has_cone()) return std::min(falloff.dark_versine(), 2.0);
  return falloff.shape() == LightFalloff::Shape::cosine ? 1.0 : 2.0;
}

}  // namespace

LightRays::LightRays(const NodePointLight& light, const glm::dvec3& first, const GridNodes& nodes,
                     int bands, const Job& job)
    : light_(light),
      origin_((light.source.position - first) / static_cast<double>(nodes.spacing)),
      first_(first),
      nodes_(nodes),
      versine_(cone_versine(light.source.falloff)) {
  // A narrow cone is as wide farther away.
  const double sine = versine_ < 1.0 ? std::sqrt(versine_ * (2.0 - versine_)) : 1.0;
  range_ = near_spacings / std::max(sine, 1e-9);
  const glm::dvec3 last(nodes.count - 1);
  const glm::dvec3 outside = glm::max(glm::max(-origin_, origin_ - last), 0.0);
  if (!(versine_ > 0.0) || glm::length(outside) > range_ + 2.0 * std::numbers::sqrt3) return;

  rays_.resize(ray_count());
  const LightFalloff& falloff = light.source.falloff;
  const glm::dvec3 axis = falloff.is_isotropic() ? glm::dvec3(0.0, 1.0, 0.0) : falloff.axis();
  const auto [u, v] = make_basis(axis);
  for (std::size_t k = 0; k < rays_.size(); ++k) {
    const double index = static_cast<double>(k);
    const double versine = versine_ * (index + 0.5) / static_cast<double>(rays_.size());
    const double radius = std::sqrt(versine * (2.0 - versine));
    const double turn = golden_angle * index;
    rays_[k].w =
        glm::normalize((1.0 - versine) * axis + radius * (std::cos(turn) * u + std::sin(turn) * v));
  }
  job.parallel_for((rays_.size() + rays_together - 1) / rays_together, [&](std::size_t group) {
    const std::size_t begin = group * rays_together;
    trace(std::span(rays_).subspan(begin, std::min(rays_together, rays_.size() - begin)), bands);
  });
}

std::size_t LightRays::ray_count() const {
  const double area = 2.0 * std::numbers::pi * versine_ * range_ * range_;
  return static_cast<std::size_t>(std::ceil(area / (ray_gap * ray_gap)));
}

double LightRays::share(double distance) const {
  if (rays_.empty()) return 0.0;
  const double t = 3.0 * distance / (range_ * static_cast<double>(nodes_.spacing)) - 2.0;
  const double points = std::clamp(t, 0.0, 1.0);
  return 1.0 - points * points * (3.0 - 2.0 * points);
}

bool LightRays::clip(double c, double slope, double node, double& begin, double& end) {
  const double to_node = node - c;
  if (std::abs(slope) < 1e-12) return std::abs(to_node) < 1.0 && begin < end;
  const double middle = to_node / slope;
  const double half = 1.0 / std::abs(slope);
  begin = std::max(begin, middle - half);
  end = std::min(end, middle + half);
  return begin < end;
}

bool LightRays::enters(const glm::dvec3& w, double& begin, double& end) const {
  begin = 0.0;
  end = range_ + std::numbers::sqrt3;  // as far as the cells of nodes reach
  for (int axis = 0; axis < 3; ++axis) {
    const double half = 0.5 * (nodes_.count[axis] + 1);  // one spacing around the grid
    const double middle = 0.5 * (nodes_.count[axis] - 1);
    if (!clip(origin_[axis] / half, w[axis] / half, middle / half, begin, end)) return false;
  }
  return true;
}

HitsOnRay LightRays::panes_on(const glm::dvec3& w) const {
  if (!light_.surfaces || !light_.surfaces->has_panes()) return {};
  HitsOnRay on_ray = light_.surfaces->hits_on_ray(
      light_.source.position, w, rounding_at(light_.source.position - light_.surfaces->center()));
  on_ray.end = {};  // trace() ends there
  return on_ray;
}

void LightRays::trace(std::span<Ray> rays, int bands) const {
  const double spacing = static_cast<double>(nodes_.spacing);
  std::vector<glm::dvec3> directions;
  for (const Ray& ray : rays) directions.push_back(ray.w);
  std::vector<SurfaceHit> hits(rays.size());
  if (light_.surfaces) {
    light_.surfaces->opaque_hits(light_.source.position, directions, hits,
                                 rounding_at(light_.source.position - light_.surfaces->center()));
  }
  // The volume around a sample is step * solid angle * r^2.
  const double solid_angle = 2.0 * std::numbers::pi * versine_ / static_cast<double>(ray_count());
  const double volume = solid_angle / light_ray_samples / (spacing * spacing);
  LightTransmittance transmittance(light_);
  std::vector<glm::dvec3> points;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    Ray& ray = rays[i];
    double begin = 0.0;
    double end = 0.0;
    const double falloff = light_.source.falloff.at(ray.w);
    if (!(falloff > 0.0) || !enters(ray.w, begin, end)) continue;
    ray.basis = sh_basis(bands, -ray.w);
    ray.begin = static_cast<std::size_t>(light_ray_samples * begin);
    end = std::min(end, hits[i].distance / spacing);
    points.clear();
    for (std::size_t k = ray.begin;; ++k) {
      const double r = (static_cast<double>(k) + 0.5) / light_ray_samples;
      if (r > end) break;
      points.push_back(light_.source.position + spacing * r * ray.w);
    }
    const HitsOnRay panes = panes_on(ray.w);
    for (const double value : transmittance.at(points)) {
      const double r = (static_cast<double>(ray.begin + ray.arriving.size()) + 0.5) /
                       light_ray_samples * spacing;
      ray.arriving.push_back(volume * falloff * value * panes.passing(r) * r * r *
                             light_.inverse_square(r * r));
    }
  }
}

}  // namespace brume
