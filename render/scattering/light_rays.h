#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "core/math/spherical_harmonics.h"
#include "render/grid/sweep_kernels.h"
#include "render/scattering/node_point_light.h"
#include "render/util/job.h"

namespace brume {

// The light around a point light, for nodes too near for a value at their point to stand for the
// cells around them: samples on rays from the light are shared out among the nodes around each, as
// a trilinear interpolation weights them. In spherical coordinates around the light 1 / r^2
// cancels: nothing grows without bound, and what arrives varies continuously with its position. The
// rays fill the cone that the light shines into, so a beam between nodes keeps its power.
class LightRays {
 public:
  // Of a grid whose node 0 lies at `first`. Keeps a reference to the light. Invalid after the job
  // was stopped.
  LightRays(const NodePointLight& light, const glm::dvec3& first, const GridNodes& nodes, int bands,
            const Job& job);

  // How much of the light of a node at this distance from the light [u] is that of the rays: 1 near
  // it, 0 far away. The rest is that of its point.
  [[nodiscard]] double share(double distance) const;

  // The nodes (x, y, z) for all x. Calls add(x, basis, arriving) with the basis of the direction to
  // the light and what arrives from there per unit of intensity: the mean over the cells around the
  // node, weighted as it interpolates them, of what sees(x, sample) admits. Thread-safe.
  template <class Sees, class Add>
  void each_in_row(int y, int z, Sees sees, Add add) const;

 private:
  // Samples lie half a step apart from its origin, and one step from each other.
  struct Ray {
    glm::dvec3 w;            // unit, from the light
    ShVector<double> basis;  // towards it
    std::size_t begin = 0;   // index of its first sample
    std::vector<double> arriving;
  };

  // Whether node coordinates c + t slope are within 1 of `node`, for t in [begin, end], to which
  // the interval is narrowed.
  static bool clip(double c, double slope, double node, double& begin, double& end);
  [[nodiscard]] bool enters(const glm::dvec3& w, double& begin, double& end) const;
  [[nodiscard]] std::size_t ray_count() const;
  void trace(std::span<Ray> rays, int bands) const;
  [[nodiscard]] HitsOnRay panes_on(const glm::dvec3& w) const;

  const NodePointLight& light_;
  glm::dvec3 origin_;  // the light, in node coordinates
  glm::dvec3 first_;
  GridNodes nodes_;
  double range_ = 0.0;    // distance from which on points stand for their cells [spacings]
  double versine_ = 2.0;  // 1 - cos of the cone's angle
  std::vector<Ray> rays_;
};

// Samples per spacing.
inline constexpr double light_ray_samples = 4.0;

template <class Sees, class Add>
void LightRays::each_in_row(int y, int z, Sees sees, Add add) const {
  const auto width = static_cast<std::size_t>(nodes_.count.x);
  std::vector<double> arriving(width, 0.0);
  for (const Ray& ray : rays_) {
    const double samples = static_cast<double>(ray.arriving.size());
    double begin = static_cast<double>(ray.begin) / light_ray_samples;
    double end = begin + samples / light_ray_samples;
    if (!clip(origin_.y, ray.w.y, y, begin, end) || !clip(origin_.z, ray.w.z, z, begin, end)) {
      continue;
    }
    std::size_t low = width;
    std::size_t high = 0;
    const auto last = static_cast<std::size_t>(light_ray_samples * end);
    for (auto k = static_cast<std::size_t>(light_ray_samples * begin);
         k <= last && k - ray.begin < ray.arriving.size(); ++k) {
      const glm::dvec3 p = origin_ + (static_cast<double>(k) + 0.5) / light_ray_samples * ray.w;
      const double weight = std::max(1.0 - std::abs(p.y - y), 0.0) *
                            std::max(1.0 - std::abs(p.z - z), 0.0) * ray.arriving[k - ray.begin];
      if (!(weight > 0.0)) continue;
      const double below = std::floor(p.x);
      for (const double node : {below, below + 1.0}) {
        if (!(node >= 0.0 && node < static_cast<double>(width))) continue;
        const auto x = static_cast<std::size_t>(node);
        if (!sees(x, first_ + static_cast<double>(nodes_.spacing) * p)) continue;
        arriving[x] += weight * (1.0 - std::abs(p.x - node));
        low = std::min(low, x);
        high = std::max(high, x);
      }
    }
    for (std::size_t x = low; x <= high && x < width; ++x) {
      if (arriving[x] > 0.0) add(x, ray.basis, arriving[x]);
      arriving[x] = 0.0;
    }
  }
}

}  // namespace brume
