#include "render/cpu/paper_airlight.h"

#include <algorithm>
#include <cmath>

#include "core/transport/gaussian_airlight.h"
#include "core/transport/homogeneous_airlight.h"
#include "render/cpu/kernels.h"

namespace brume {
namespace {

double homogeneous_depth(double b0, double length) {
  return b0 > 0.0 ? b0 * length : 0.0;
}

// Stage by stage as the formulas stand, in double: what the SIMD path is held against.
std::uint64_t plain(const MediumIndex& medium, std::span<const std::uint32_t> gaussians,
                    std::span<const PaperLight> lights, const TileRays& rays,
                    const TileAirlight& out) {
  const double b0 = medium.homogeneous_density();
  std::uint64_t pairs = 0;
  for (std::size_t k = 0; k < rays.directions.size(); ++k) {
    const glm::dvec3& w = rays.directions[k];
    const double length = rays.lengths[k];
    double depth = homogeneous_depth(b0, length);
    glm::dvec3 radiance(0.0);
    for (const PaperLight& light : lights) {
      const LightPath<double> path(light.position, rays.eye, w, light.h_min);
      radiance += light.intensity * std::exp(-light.depth_to_eye) *
                  homogeneous_airlight(b0, path, length, medium.anisotropy());
    }
    for (const std::uint32_t i : gaussians) {
      const GaussianTerm<double>& g = medium.gaussians()[i];
      const LineProfile<double> line = line_profile(g, rays.eye, w);
      const double reach = g.a * medium.reach()[i];
      if (line.e > reach * reach) continue;
      ++pairs;
      depth += optical_depth(g, line, length);
      for (const PaperLight& light : lights) {
        const LightPath<double> path(light.position, rays.eye, w, light.h_min);
        radiance += light.intensity * gaussian_airlight(g, rays.eye, w, length, light.position,
                                                        path, light.frozen[i], medium.anisotropy());
      }
    }
    out.airlight[k] = radiance;
    out.depths[k] = depth;
  }
  return pairs;
}

struct Scratch {
  GaussianBatch batch;
  PathBatch rays;
  LightBatch pack;
  std::vector<float> depths;
  std::array<std::vector<float>, light_pack> radiance;
};

std::uint64_t simd(const MediumIndex& medium, std::span<const std::uint32_t> gaussians,
                   std::span<const PaperLight> lights, const TileRays& rays,
                   const TileAirlight& out) {
  thread_local Scratch s;
  const std::size_t count = rays.directions.size();
  s.batch.assign(medium, rays.eye, gaussians);
  s.rays.assign(rays.directions, rays.lengths);
  s.depths.assign(s.rays.padded_size(), 0.0f);
  std::fill(out.airlight.begin(), out.airlight.end(), glm::vec3(0.0f));

  const double b0 = medium.homogeneous_density();
  std::uint64_t pairs = 0;
  // Without lights there is still the depth to sum.
  for (std::size_t first = 0; first == 0 || first < lights.size(); first += light_pack) {
    s.pack.anisotropy = static_cast<float>(medium.anisotropy());
    s.pack.count = std::min(light_pack, lights.size() - first);
    std::array<float*, light_pack> radiance{};
    for (std::size_t l = 0; l < s.pack.count; ++l) {
      const PaperLight& light = lights[first + l];
      const glm::vec3 position(light.position - rays.eye);
      s.pack.x[l] = position.x;
      s.pack.y[l] = position.y;
      s.pack.z[l] = position.z;
      s.pack.h_min[l] = static_cast<float>(light.h_min);
      s.pack.frozen[l].resize(gaussians.size());
      for (std::size_t j = 0; j < gaussians.size(); ++j) {
        s.pack.frozen[l][j] = static_cast<float>(light.frozen[gaussians[j]]);
      }
      s.radiance[l].assign(s.rays.padded_size(), 0.0f);
      radiance[l] = s.radiance[l].data();
    }
    const std::uint64_t pack_pairs = accumulate_paper_airlight(
        s.batch, s.rays, s.pack, first == 0 ? s.depths.data() : nullptr, radiance);
    if (first == 0) pairs = pack_pairs;
    for (std::size_t l = 0; l < s.pack.count; ++l) {
      const PaperLight& light = lights[first + l];
      if (b0 > 0.0) {
        accumulate_homogeneous_airlight(static_cast<float>(b0),
                                        static_cast<float>(std::exp(-light.depth_to_eye)),
                                        glm::vec3(s.pack.x[l], s.pack.y[l], s.pack.z[l]),
                                        s.pack.h_min[l], s.pack.anisotropy, s.rays, radiance[l]);
      }
      const glm::vec3 intensity(light.intensity);
      for (std::size_t k = 0; k < count; ++k) out.airlight[k] += intensity * radiance[l][k];
    }
  }
  for (std::size_t k = 0; k < count; ++k) {
    out.depths[k] = static_cast<double>(s.depths[k]) + homogeneous_depth(b0, rays.lengths[k]);
  }
  return pairs;
}

}  // namespace

std::uint64_t paper_airlight(const MediumIndex& medium, std::span<const std::uint32_t> gaussians,
                             std::span<const PaperLight> lights, const TileRays& rays,
                             Settings::Arithmetic arithmetic, const TileAirlight& out) {
  return arithmetic == Settings::Arithmetic::plain_double
             ? plain(medium, gaussians, lights, rays, out)
             : simd(medium, gaussians, lights, rays, out);
}

}  // namespace brume
