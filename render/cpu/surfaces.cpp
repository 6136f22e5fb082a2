#include "render/cpu/surfaces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/scene/brdf.h"
#include "render/cpu/path_depths.h"
#include "render/cpu/slice_kernels.h"
#include "render/tiles.h"

namespace brume {

namespace {

// The points of a tile that one light shines on.
struct LitPoints {
  std::vector<std::size_t> index;
  std::vector<glm::dvec3> ends;     // the points themselves
  std::vector<glm::dvec3> origins;  // of shadow rays
  std::vector<std::int32_t> none;
  std::vector<double> depths;
  PathBatch paths;
  std::vector<float> looked_up;

  void face(const PointLight& light, std::span<const SurfacePoint> points) {
    index.clear();
    origins.clear();
    for (std::size_t k = 0; k < points.size(); ++k) {
      if (!(glm::dot(points[k].normal, light.position - points[k].position) > 0.0)) continue;
      index.push_back(k);
      origins.push_back(points[k].shadow_origin);
    }
  }

  void drop_blocked(const PointLight& light, const Visibility& visibility,
                    std::span<const SurfacePoint> points) {
    std::array<bool, Tiles::pixels> blocked;
    visibility.blocked(origins, light.position, std::span(blocked).first(origins.size()));
    std::size_t kept = 0;
    ends.clear();
    for (std::size_t k = 0; k < index.size(); ++k) {
      if (blocked[k]) continue;
      index[kept++] = index[k];
      ends.push_back(points[index[k]].position);
    }
    index.resize(kept);
  }

  // T(s, p) of the Gaussians, from the light's table where there is one.
  std::uint64_t find_depths(const MediumIndex& medium, const SurfaceLight& light,
                            Settings::Arithmetic arithmetic) {
    depths.resize(ends.size());
    none.assign(ends.size(), -1);
    if (!light.table) {
      return bundle_depths(medium, light.light.position, ends, none, arithmetic, depths);
    }
    paths.assign(light.light.position, ends, none);
    looked_up.resize(paths.padded_size());
    look_up_depths(*light.table, paths, looked_up.data());
    std::copy_n(looked_up.begin(), ends.size(), depths.begin());
    return 0;
  }
};

}  // namespace

std::uint64_t surface_radiance(const MediumIndex& medium, const Visibility& visibility,
                               std::span<const SurfaceLight> lights,
                               std::span<const SurfacePoint> points,
                               Settings::Arithmetic arithmetic, std::span<glm::vec3> radiance) {
  thread_local LitPoints lit;
  std::fill(radiance.begin(), radiance.end(), glm::vec3(0.0f));
  std::uint64_t pairs = 0;
  for (const SurfaceLight& light : lights) {
    const glm::dvec3& position = light.light.position;
    lit.face(light.light, points);
    lit.drop_blocked(light.light, visibility, points);
    if (lit.index.empty()) continue;
    pairs += lit.find_depths(medium, light, arithmetic);
    for (std::size_t k = 0; k < lit.index.size(); ++k) {
      const SurfacePoint& point = points[lit.index[k]];
      const glm::dvec3 q = position - point.position;
      const double distance = glm::length(q);
      const glm::dvec3 wi = q / distance;
      const double depth = lit.depths[k] + medium.homogeneous_density() * distance;
      const double irradiance =
          glm::dot(point.normal, wi) * std::exp(-depth) / (distance * distance);
      radiance[lit.index[k]] +=
          glm::vec3(brdf(point.surface->material, wi, point.to_eye, point.normal) *
                    light.light.intensity * irradiance);
    }
  }
  return pairs;
}

}  // namespace brume
