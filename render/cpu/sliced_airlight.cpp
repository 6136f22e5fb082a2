#include "render/cpu/sliced_airlight.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/transport/light_path.h"
#include "render/cpu/kernels.h"
#include "render/cpu/slice_kernels.h"

namespace brume {
namespace {

// Optical depth of homogeneous fog past which its light is left out: exp(-12) = 6e-6.
constexpr double fog_end = 12.0;

struct Range {
  double begin = std::numeric_limits<double>::infinity();
  double end = 0.0;
  [[nodiscard]] bool empty() const { return !(begin < end); }
};

// Where light falls off within a medium, slices of equal angle as seen from the light.
void add_equi_angular(const SlicedLight& light, const glm::dvec3& eye, const glm::dvec3& w,
                      const Range& range, int count, std::vector<double>& boundaries) {
  // A light almost on the ray would put all slices at one point: half a slice is fine enough.
  const double least = 0.25 * (range.end - range.begin) / count;
  const EquiAngular<double> angular(
      LightPath<double>(light.position, eye, w, std::max(light.h_min, least)), range.end);
  const double begin = angular.angle(range.begin);
  for (int k = 1; k < count; ++k) {
    const double t = angular.t(begin + (angular.span - begin) * k / count);
    if (t > range.begin && t < range.end) boundaries.push_back(t);
  }
}

// The boundaries of a tile's slices, chosen on its middle ray.
void choose_boundaries(const MediumIndex& medium, std::span<const std::uint32_t> gaussians,
                       std::span<const SlicedLight> lights, const TileRays& rays, int slices,
                       std::vector<double>& boundaries) {
  boundaries.clear();
  const glm::dvec3& w = rays.directions[rays.directions.size() / 2];
  const double longest = *std::max_element(rays.lengths.begin(), rays.lengths.end());

  // The Gaussians: slices over two radii to both sides, and one more for the tail at each end.
  Range reach;
  Range core;
  for (const std::uint32_t i : gaussians) {
    const GaussianTerm<double>& g = medium.gaussians()[i];
    const double t = glm::dot(g.b - rays.eye, w);
    const double r = medium.reach()[i];
    reach.begin = std::min(reach.begin, t - r);
    reach.end = std::max(reach.end, t + r);
    const double half = std::min(2.0 / g.a, r);
    core.begin = std::min(core.begin, t - half);
    core.end = std::max(core.end, t + half);
  }
  const auto clip = [longest](Range& range) {
    range.begin = std::clamp(range.begin, 0.0, longest);
    range.end = std::clamp(range.end, 0.0, longest);
  };
  clip(reach);
  clip(core);
  const double b0 = medium.homogeneous_density();
  Range whole = reach;
  if (b0 > 0.0) {
    whole.begin = 0.0;
    whole.end = std::min(longest, std::max(reach.empty() ? 0.0 : reach.end, fog_end / b0));
  }
  if (whole.empty()) return;
  boundaries.push_back(whole.begin);
  boundaries.push_back(whole.end);
  if (!reach.empty()) {
    for (int k = 0; k <= slices - 2 && !core.empty(); ++k) {
      boundaries.push_back(core.begin + (core.end - core.begin) * k / (slices - 2));
    }
    boundaries.push_back(reach.begin);
    boundaries.push_back(reach.end);
  }
  const Range& lit = b0 > 0.0 ? whole : core;
  for (const SlicedLight& light : lights) {
    // A light in or near the medium; far ones are smooth along the ray.
    const glm::dvec3 q = light.position - rays.eye;
    const double ts = glm::dot(q, w);
    const double h = glm::length(q - ts * w);
    const double gap = std::max({lit.begin - ts, ts - lit.end, 0.0});
    if (lit.empty() || std::hypot(gap, h) > 0.5 * (lit.end - lit.begin)) continue;
    const int count =
        std::max(slices / static_cast<int>(std::min<std::size_t>(lights.size(), 4)), 4);
    add_equi_angular(light, rays.eye, w, lit, count, boundaries);
  }
  if (b0 > 0.0) {
    // Slices of equal loss in the fog.
    const double opaque = -std::expm1(-b0 * whole.end);
    for (int k = 1; k < slices; ++k) {
      boundaries.push_back(-std::log1p(-opaque * k / slices) / b0);
    }
  }
  std::sort(boundaries.begin(), boundaries.end());
  const double least = 1e-6 * (whole.end - whole.begin);
  boundaries.erase(std::unique(boundaries.begin(), boundaries.end(),
                               [least](double a, double b) { return b - a < least; }),
                   boundaries.end());
}

struct Scratch {
  std::vector<double> exact_boundaries;
  std::vector<float> boundaries;
  GaussianBatch batch;
  PathBatch rays;
  std::vector<float> increments;
  std::vector<float> depths;
  std::array<std::vector<float>, light_pack> radiance;
};

}  // namespace

std::uint64_t sliced_airlight(const MediumIndex& medium, std::span<const std::uint32_t> gaussians,
                              std::span<const SlicedLight> lights, const TileRays& rays, int slices,
                              const TileAirlight& out) {
  thread_local Scratch s;
  const std::size_t count = rays.directions.size();
  std::fill(out.airlight.begin(), out.airlight.end(), glm::vec3(0.0f));
  std::fill(out.depths.begin(), out.depths.end(), 0.0);
  choose_boundaries(medium, gaussians, lights, rays, slices, s.exact_boundaries);
  if (s.exact_boundaries.size() < 2) return 0;
  s.boundaries.assign(s.exact_boundaries.begin(), s.exact_boundaries.end());

  s.batch.assign(medium, rays.eye, gaussians);
  s.rays.assign(rays.directions, rays.lengths);
  const std::size_t stride = s.rays.padded_size();
  s.increments.assign((s.boundaries.size() - 1) * stride, 0.0f);
  const std::uint64_t pairs =
      accumulate_increments(s.batch, s.rays, s.boundaries, s.increments.data());

  const double b0 = medium.homogeneous_density();
  const auto negligible = static_cast<float>(0.1 * medium.tolerance());
  s.depths.resize(stride);
  for (std::size_t first = 0; first == 0 || first < lights.size(); first += light_pack) {
    std::array<SliceLight, light_pack> pack;
    std::array<float*, light_pack> radiance{};
    const std::size_t size = std::min(light_pack, lights.size() - first);
    for (std::size_t l = 0; l < size; ++l) {
      const SlicedLight& light = lights[first + l];
      pack[l] = {glm::vec3(light.position - rays.eye), static_cast<float>(light.h_min), light.table,
                 light.shadows};
      s.radiance[l].assign(stride, 0.0f);
      radiance[l] = s.radiance[l].data();
    }
    sum_slices(s.rays, s.boundaries, s.increments.data(), static_cast<float>(b0),
               static_cast<float>(medium.anisotropy()), negligible, std::span(pack).first(size),
               s.depths.data(), radiance);
    for (std::size_t l = 0; l < size; ++l) {
      const glm::vec3 intensity(lights[first + l].intensity);
      for (std::size_t k = 0; k < count; ++k) out.airlight[k] += intensity * radiance[l][k];
    }
  }
  for (std::size_t k = 0; k < count; ++k) {
    const double length = rays.lengths[k];
    const double sliced = std::min(length, s.exact_boundaries.back());
    // Fog goes on where slices end; the Gaussians do not.
    out.depths[k] = static_cast<double>(s.depths[k]) + (b0 > 0.0 ? b0 * (length - sliced) : 0.0);
  }
  return pairs;
}

}  // namespace brume
