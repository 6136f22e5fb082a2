#include "render/cpu/marched_airlight.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <optional>
#include <vector>

#include "core/math/infinity.h"
#include "render/cpu/march_kernels.h"
#include "render/geometry/ray_range.h"
#include "render/optical_depth/path_depths.h"

namespace brume {
namespace {

// The part of a ray that lies in the medium; empty (0, 0) if none does.
RayRange medium_range(const MediumIndex& medium, std::span<const std::uint32_t> gaussians,
                      const glm::dvec3& eye, const glm::dvec3& w, double length) {
  RayRange range;
  for (const std::uint32_t i : gaussians) {
    const glm::dvec3 q = medium.gaussians()[i].b - eye;
    const double t = glm::dot(q, w);
    const glm::dvec3 offset = q - t * w;
    const double cutoff_radius = medium.view_cutoff_radius(i);
    const double chord2 = cutoff_radius * cutoff_radius - glm::dot(offset, offset);
    if (!(chord2 > 0.0)) continue;
    range.add(t - std::sqrt(chord2), t + std::sqrt(chord2));
  }
  if (const double b0 = medium.homogeneous_density(); b0 > 0.0) {
    const FogInterval fog = medium.fog().interval(eye, w);
    if (fog.begin < fog.end) {
      range.add(fog.begin, std::min(fog.begin + opaque_fog_depth / b0, fog.end));
    }
  }
  range.clip(length);
  return range.empty() ? RayRange{0.0, 0.0} : range;
}

struct MarchScratch {
  GaussianBatch batch;
  PathBatch rays;
  std::vector<double> begin, step;  // per ray [u]
  std::vector<FogInterval> fog;     // the same
  std::vector<float> t, weights, depths, light_depths, lit_weights;
  std::vector<std::vector<float>> radiance;  // per light
  // Samples with a relevant contribution, towards a light.
  std::vector<std::size_t> relevant;
  std::vector<glm::dvec3> points;
  std::vector<std::int32_t> no_self;
  std::vector<double> exact;
  std::vector<SourceWeights> source_weights;
  std::vector<float> source_sums;      // of all rays, see SourceLookup::add()
  std::vector<glm::vec3> environment;  // per ray
  std::vector<float> along_rays;       // see SliceWeights
  // Gaussians with optics: the batch with its scale times each of them, and its sums.
  std::array<GaussianBatch, 4> weighted;
  std::array<std::vector<float>, 4> sums;
  std::vector<float> ignored;
  std::vector<glm::vec3> emitted;  // per ray
};

// Sets up the steps of every ray and clears what is summed over them.
void prepare(const MediumIndex& medium, std::span<const std::uint32_t> gaussians,
             std::size_t lights, const TileRays& rays, int steps, MarchScratch& s) {
  s.batch.assign(medium, rays, gaussians);
  s.batch.add_optics(medium);
  s.rays.assign(rays);
  const std::size_t count = rays.directions.size();
  s.begin.resize(count);
  s.step.resize(count);
  s.fog.resize(count);
  for (std::size_t k = 0; k < count; ++k) {
    const RayRange range =
        medium_range(medium, gaussians, rays.origin(k), rays.directions[k], rays.lengths[k]);
    s.fog[k] = medium.fog().interval(rays.origin(k), rays.directions[k]);
    s.begin[k] = range.begin;
    s.step[k] = (range.end - range.begin) / steps;
  }
  for (auto* array : {&s.t, &s.weights, &s.depths, &s.light_depths, &s.lit_weights}) {
    array->assign(s.rays.padded_size(), 0.0f);
  }
  if (s.batch.has_optics()) {
    for (std::size_t k = 0; k < s.weighted.size(); ++k) {
      s.weighted[k] = s.batch;
      for (std::size_t j = 0; j < s.batch.size(); ++j)
        s.weighted[k].scale[j] *= s.batch.optics[k][j];
      s.sums[k].resize(s.rays.padded_size());
    }
    s.ignored.resize(s.rays.padded_size());
  }
  s.emitted.assign(count, glm::vec3(0.0f));
  s.radiance.resize(lights);
  for (auto& radiance : s.radiance) radiance.assign(s.rays.padded_size(), 0.0f);
}

// The sample of every ray at one step: where it is, what it scatters, and which samples of the
// tile are worth asking the lights for.
std::uint64_t add_samples(const MediumIndex& medium, const TileRays& rays, int index, int steps,
                          MarchScratch& s) {
  for (std::size_t k = 0; k < rays.directions.size(); ++k) {
    s.t[k] = static_cast<float>(s.begin[k] + (index + 0.5) * s.step[k]);
  }
  const std::uint64_t pairs =
      sample_medium(s.batch, s.rays, s.t.data(), s.weights.data(), s.depths.data());
  for (std::size_t k = 0; s.batch.has_optics() && k < s.weighted.size(); ++k) {
    sample_medium(s.weighted[k], s.rays, s.t.data(), s.sums[k].data(), s.ignored.data());
  }
  const auto b0 = static_cast<float>(medium.homogeneous_density());
  // A ray whose every step is as thin as this lies below what other methods leave out.
  const auto negligible = static_cast<float>(medium.negligible_depth() / steps);
  constexpr float opaque = 45.0f;
  s.relevant.clear();
  s.points.clear();
  for (std::size_t k = 0; k < rays.directions.size(); ++k) {
    const auto step = static_cast<float>(s.step[k]);
    const auto t = static_cast<double>(s.t[k]);
    const float fog = s.fog[k].contains(t) ? b0 : 0.0f;
    s.weights[k] = (s.weights[k] + fog) * step;
    s.depths[k] += b0 * static_cast<float>(s.fog[k].before(t));
    if (!(s.weights[k] > negligible) || s.depths[k] > opaque) continue;
    s.relevant.push_back(k);
    s.points.push_back(rays.origin(k) + static_cast<double>(s.t[k]) * rays.directions[k]);
    if (!s.batch.has_optics()) continue;
    s.weights[k] = (s.sums[0][k] + fog) * step;  // what is scattered of it
    s.emitted[k] +=
        step * std::exp(-s.depths[k]) * glm::vec3(s.sums[1][k], s.sums[2][k], s.sums[3][k]);
  }
  return pairs;
}

// Adds what the samples scatter of one light.
std::uint64_t add_light(const MediumIndex& medium, const RayCaster& ray_caster,
                        const PointSource& light, const glm::dvec3& eye, MarchScratch& s,
                        std::vector<float>& radiance) {
  s.no_self.assign(s.relevant.size(), -1);
  s.exact.resize(s.relevant.size());
  const std::uint64_t pairs = bundle_depths(medium, light.position, s.points, s.no_self,
                                            Settings::Precision::simd_float, s.exact);
  std::fill(s.lit_weights.begin(), s.lit_weights.end(), 0.0f);
  for (std::size_t i = 0; i < s.relevant.size(); ++i) {
    const std::size_t k = s.relevant[i];
    s.light_depths[k] = static_cast<float>(s.exact[i] + medium.homogeneous_density() *
                                                            light.fog_length(s.points[i]));
    const double visible = ray_caster.transmittance(s.points[i], light.position);
    if (!(visible > 0.0)) continue;
    const glm::dvec3 q = s.points[i] - light.position;
    const double r = glm::length(q);
    const double falloff = r > 0.0 ? light.falloff.at(q / r) : 1.0;
    s.lit_weights[k] = static_cast<float>(visible * falloff) * s.weights[k];
  }
  add_scattered(s.rays, {s.t.data(), s.lit_weights.data(), s.depths.data(), s.light_depths.data()},
                glm::vec3(light.position - eye), static_cast<float>(light.h_min),
                static_cast<float>(medium.anisotropy()), radiance.data());
  return pairs;
}

// Sums the source function at the samples.
void add_environment(const SourceFunction& environment, const SourceLookup& source,
                     const MediumIndex& medium, MarchScratch& s) {
  const auto b0 = static_cast<float>(medium.homogeneous_density());
  const auto even_share = static_cast<float>(1.0 - environment.lobe_fog_extinction());
  std::ranges::fill(s.lit_weights, 0.0f);
  for (const std::size_t k : s.relevant) {
    s.lit_weights[k] = s.weights[k] * std::exp(-s.depths[k]);
    if (!environment.has_lobe_on_rays()) continue;
    const float fog = even_share * b0 * static_cast<float>(s.fog[k].before(s.t[k]));
    s.along_rays[k] +=
        s.weights[k] * std::exp(medium.anisotropy() > 0.0 ? -fog : fog - 2.0f * s.depths[k]);
  }
  source.add(s.rays, s.t.data(), s.lit_weights.data(), s.source_sums.data());
}

// Adds what the peak of the phase function scatters of it.
void add_forward_lobe(const SourceFunction& environment, const SourceLookup& source,
                      const MediumIndex& medium, const TileRays& rays, MarchScratch& s) {
  PathBatch lines = s.rays;
  lines.make_endless();
  std::fill(s.depths.begin(), s.depths.end(), 0.0f);
  accumulate_path_depths(s.batch, lines, s.depths.data());
  for (std::size_t k = 0; k < rays.directions.size(); ++k) {
    if (!medium.fog().is_endless()) {
      s.depths[k] +=
          static_cast<float>(medium.fog_depth(rays.origin(k), rays.directions[k], infinity));
    }
    s.environment[k] += s.along_rays[k] *
                        environment.lobe_on_ray(source, s.source_weights[k], s.depths[k], rays, k);
  }
}

}  // namespace

std::uint64_t marched_airlight(const MediumIndex& medium, std::span<const std::uint32_t> gaussians,
                               const RayCaster& ray_caster, std::span<const PointSource> lights,
                               const SourceFunction* environment, const TileRays& rays, int steps,
                               const TileAirlight& out) {
  thread_local MarchScratch s;
  prepare(medium, gaussians, lights.size(), rays, steps, s);
  std::uint64_t pairs = 0;
  s.source_weights.clear();
  for (std::size_t k = 0; environment && k < rays.directions.size(); ++k) {
    s.source_weights.push_back(environment->weights(rays.directions[k]));
  }
  std::optional<SourceLookup> source;
  if (environment) {
    source = environment->from_eye(rays.eye);
    s.source_sums.assign(s.rays.padded_size() * source->sums_size(), 0.0f);
  }
  s.environment.assign(rays.directions.size(), glm::vec3(0.0f));
  s.along_rays.assign(rays.directions.size(), 0.0f);
  const bool is_lit = environment || !lights.empty() || s.batch.has_optics();
  for (int index = 0; index < steps && is_lit; ++index) {
    pairs += add_samples(medium, rays, index, steps, s);
    if (s.relevant.empty()) continue;
    if (environment) add_environment(*environment, *source, medium, s);
    for (std::size_t l = 0; l < lights.size(); ++l) {
      pairs += add_light(medium, ray_caster, lights[l], rays.eye, s, s.radiance[l]);
    }
  }

  for (std::size_t k = 0; environment && k < rays.directions.size(); ++k) {
    s.environment[k] = source->source(
        std::span(s.source_sums).subspan(k * source->sums_size(), source->sums_size()),
        s.source_weights[k]);
  }
  if (environment && environment->has_lobe_on_rays()) {
    add_forward_lobe(*environment, *source, medium, rays, s);
  }
  std::fill(s.depths.begin(), s.depths.end(), 0.0f);
  accumulate_path_depths(s.batch, s.rays, s.depths.data());
  for (std::size_t k = 0; k < rays.directions.size(); ++k) {
    out.depths[k] = static_cast<double>(s.depths[k]) +
                    medium.fog_depth(rays.origin(k), rays.directions[k], rays.lengths[k]);
    out.airlight[k] = glm::max(s.environment[k], 0.0f) + s.emitted[k];
    for (std::size_t l = 0; l < lights.size(); ++l) {
      out.airlight[k] += glm::vec3(lights[l].intensity) * s.radiance[l][k];
    }
  }
  return pairs;
}

}  // namespace brume
