#include "render/cpu/surfaces.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/scene/brdf.h"
#include "render/cpu/path_depths.h"

namespace brume {

std::uint64_t surface_radiance(const MediumIndex& medium, const Visibility& visibility,
                               std::span<const PointLight> lights,
                               std::span<const SurfacePoint> points,
                               Settings::Arithmetic arithmetic, std::span<glm::dvec3> radiance) {
  std::fill(radiance.begin(), radiance.end(), glm::dvec3(0.0));
  std::uint64_t pairs = 0;
  std::vector<std::size_t> lit;  // points that face the light and see it
  std::vector<double> cosine;
  std::vector<glm::dvec3> ends;
  std::vector<double> depths;
  for (const PointLight& light : lights) {
    lit.clear();
    cosine.clear();
    ends.clear();
    for (std::size_t k = 0; k < points.size(); ++k) {
      const SurfacePoint& point = points[k];
      const glm::dvec3 q = light.position - point.position;
      const double distance = glm::length(q);
      if (!(distance > 0.0)) continue;
      const double c = glm::dot(point.normal, q) / distance;
      if (c <= 0.0 || visibility.blocked(point.shadow_origin, light.position)) continue;
      lit.push_back(k);
      cosine.push_back(c);
      ends.push_back(point.position);
    }
    if (lit.empty()) continue;
    depths.resize(lit.size());
    const std::vector<std::int32_t> none(lit.size(), -1);
    pairs += bundle_depths(medium, light.position, ends, none, arithmetic, depths);
    for (std::size_t k = 0; k < lit.size(); ++k) {
      const double distance = glm::length(light.position - ends[k]);
      const double depth = depths[k] + medium.homogeneous_density() * distance;
      const double irradiance = cosine[k] * std::exp(-depth) / (distance * distance);
      const SurfacePoint& point = points[lit[k]];
      const glm::dvec3 wi = (light.position - point.position) / distance;
      radiance[lit[k]] += brdf(point.surface->material, wi, point.to_eye, point.normal) *
                          light.intensity * irradiance;
    }
  }
  return pairs;
}

}  // namespace brume
