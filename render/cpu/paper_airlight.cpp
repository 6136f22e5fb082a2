#include "render/cpu/paper_airlight.h"

#include <algorithm>
#include <cmath>

#include "core/transport/closed_form_airlight.h"
#include "core/transport/view_line.h"
#include "render/reference/airlight_integral.h"
#include "render/simd/gaussian_kernels.h"

namespace brume {
namespace {

bool any_conserves_energy(const PaperLights& paper) {
  return std::any_of(paper.lights.begin(), paper.lights.end(),
                     [](const PaperLight& light) { return light.conserve_energy; });
}

// Gaussians of total depth T scatter 1 - exp(-T) along a ray (the integral of b exp(-T(v, x)));
// `scattered` is their estimate of it. Homogeneous fog is excluded: it attenuates both alike and
// its airlight is exact.
double energy_gain(double scattered, double depth) {
  constexpr double nothing = 1e-30;
  return scattered > nothing ? -std::expm1(-depth) / scattered : 1.0;
}

// Airlight of a ball of fog, where the closed form does not hold, per unit of radiant intensity.
double airlight_of_ball(const MediumIndex& medium, const PaperLight& light, const glm::dvec3& eye,
                        const glm::dvec3& w, double length) {
  const FogInterval fog = medium.fog().interval(eye, w);
  const double end = std::min(length, fog.end);
  if (!(medium.homogeneous_density() > 0.0 && fog.begin < end)) return 0.0;
  const ViewRayMedium<double> ray({}, medium.homogeneous_density(), eye, w, end, {}, {}, fog);
  const LightSource<double> source{.position = light.position,
                                   .h_min = light.h_min,
                                   .gaussians = {},
                                   .anisotropy = medium.anisotropy(),
                                   .lit = {{{fog.begin, end}}},
                                   .fog = medium.fog()};
  return airlight_integral(ray, source, 1e-6);
}

// The formulas as written in the paper, in double: the reference for the SIMD path.
std::uint64_t plain(const MediumIndex& medium, std::span<const std::uint32_t> gaussians,
                    const PaperLights& paper, const TileRays& rays, const TileAirlight& out) {
  const double b0 = medium.homogeneous_density();
  const bool conserve = any_conserves_energy(paper);
  const ScatterPoint point = paper.at_mean ? ScatterPoint::mean : ScatterPoint::projection;
  std::uint64_t pairs = 0;
  for (std::size_t k = 0; k < rays.directions.size(); ++k) {
    const glm::dvec3& w = rays.directions[k];
    const glm::dvec3 origin = rays.origin(k);
    const double length = rays.lengths[k];
    double depth = 0.0;
    double scattered = 0.0;
    std::vector<double> radiance(paper.lights.size());
    for (const std::uint32_t i : gaussians) {
      const GaussianTerm<double>& g = medium.gaussians()[i];
      const LineProfile<double> line = view_line_profile(g, origin, w, medium.noise());
      const double cutoff_in_radii = g.a * medium.cutoff_radii()[i];
      if (line.e > cutoff_in_radii * cutoff_in_radii) continue;
      ++pairs;
      const PointScattering<double> scattering = point_scattering(g, line, length, point);
      depth += scattering.depth;
      if (conserve)
        scattered += scattering.depth * std::exp(-(paper.from_eye[i] + scattering.depth_to_point));
      for (std::size_t l = 0; l < paper.lights.size(); ++l) {
        const PaperLight& light = paper.lights[l];
        const PointLightRay<double> path(light.position, origin, w, light.h_min);
        radiance[l] += gaussian_airlight(g, scattering, origin, w, light.position, path,
                                         light.frozen[i], medium.anisotropy());
      }
    }
    const double gain = energy_gain(scattered, depth);
    glm::dvec3 airlight(0.0);
    for (std::size_t l = 0; l < paper.lights.size(); ++l) {
      const PaperLight& light = paper.lights[l];
      const PointLightRay<double> path(light.position, origin, w, light.h_min);
      const double fog = medium.fog().is_endless()
                             ? homogeneous_airlight(b0, path, length, medium.anisotropy())
                             : airlight_of_ball(medium, light, origin, w, length);
      airlight += light.intensity * ((light.conserve_energy ? gain : 1.0) * radiance[l] +
                                     std::exp(-light.depth_to_eye) * fog);
    }
    out.airlight[k] = airlight;
    out.depths[k] = depth + medium.fog_depth(origin, w, length);
  }
  return pairs;
}

struct PaperScratch {
  GaussianBatch batch;
  PathBatch rays;
  LightBatch pack;
  std::vector<float> depths, scattered;
  std::array<std::vector<float>, light_pack> radiance;
};

// The values of the Gaussians of a batch, in its order.
void gather(std::span<const double> values, std::span<const std::uint32_t> gaussians,
            std::vector<float>& out) {
  out.resize(gaussians.size());
  for (std::size_t j = 0; j < gaussians.size(); ++j) {
    out[j] = static_cast<float>(values[gaussians[j]]);
  }
}

std::uint64_t simd(const MediumIndex& medium, std::span<const std::uint32_t> gaussians,
                   const PaperLights& paper, const TileRays& rays, const TileAirlight& out) {
  thread_local PaperScratch s;
  const std::vector<PaperLight>& lights = paper.lights;
  const std::size_t count = rays.directions.size();
  s.batch.assign(medium, rays, gaussians);
  s.rays.assign(rays);
  s.depths.assign(s.rays.padded_size(), 0.0f);
  std::fill(out.airlight.begin(), out.airlight.end(), glm::vec3(0.0f));

  const BatchFog fog(medium, rays.eye);
  std::uint64_t pairs = 0;
  const bool conserve = any_conserves_energy(paper);
  s.pack.at_mean = paper.at_mean;
  s.pack.anisotropy = static_cast<float>(medium.anisotropy());
  if (conserve) gather(paper.from_eye, gaussians, s.pack.from_eye);
  s.scattered.assign(conserve ? s.rays.padded_size() : 0, 0.0f);
  // Without lights there is still the depth to sum.
  for (std::size_t first = 0; first == 0 || first < lights.size(); first += light_pack) {
    s.pack.count = std::min(light_pack, lights.size() - first);
    std::array<float*, light_pack> radiance{};
    for (std::size_t l = 0; l < s.pack.count; ++l) {
      const PaperLight& light = lights[first + l];
      const glm::vec3 position(light.position - rays.eye);
      s.pack.x[l] = position.x;
      s.pack.y[l] = position.y;
      s.pack.z[l] = position.z;
      s.pack.h_min[l] = static_cast<float>(light.h_min);
      gather(light.frozen, gaussians, s.pack.frozen[l]);
      s.radiance[l].assign(s.rays.padded_size(), 0.0f);
      radiance[l] = s.radiance[l].data();
    }
    // The first pack sums what is the same for all of them.
    const std::uint64_t pack_pairs =
        accumulate_paper_airlight(s.batch, s.rays, s.pack, first == 0 ? s.depths.data() : nullptr,
                                  first == 0 && conserve ? s.scattered.data() : nullptr, radiance);
    if (first == 0) pairs = pack_pairs;
    for (std::size_t l = 0; l < s.pack.count; ++l) {
      const PaperLight& light = lights[first + l];
      for (std::size_t k = 0; light.conserve_energy && k < count; ++k) {
        radiance[l][k] *= static_cast<float>(
            energy_gain(static_cast<double>(s.scattered[k]), static_cast<double>(s.depths[k])));
      }
      if (fog.density > 0.0f) {
        accumulate_homogeneous_airlight(fog, static_cast<float>(std::exp(-light.depth_to_eye)),
                                        glm::vec3(s.pack.x[l], s.pack.y[l], s.pack.z[l]),
                                        s.pack.h_min[l], s.pack.anisotropy, s.rays, radiance[l]);
      }
      const glm::vec3 intensity(light.intensity);
      for (std::size_t k = 0; k < count; ++k) out.airlight[k] += intensity * radiance[l][k];
    }
  }
  for (std::size_t k = 0; k < count; ++k) {
    out.depths[k] = static_cast<double>(s.depths[k]) +
                    medium.fog_depth(rays.origin(k), rays.directions[k], rays.lengths[k]);
  }
  return pairs;
}

}  // namespace

std::uint64_t paper_airlight(const MediumIndex& medium, std::span<const std::uint32_t> gaussians,
                             const PaperLights& paper, const TileRays& rays,
                             Settings::Precision precision, const TileAirlight& out) {
  return precision == Settings::Precision::plain_double ? plain(medium, gaussians, paper, rays, out)
                                                        : simd(medium, gaussians, paper, rays, out);
}

}  // namespace brume
