#include "render/cpu/sliced_airlight.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "render/lighting/slice_kernels.h"
#include "render/simd/gaussian_kernels.h"

namespace brume {
namespace {

struct SliceScratch {
  RaySlices slices;
  GaussianBatch batch;
  PathBatch rays;
  std::vector<float> increments;
  std::vector<float> depths;
  std::vector<float> lookup_weights, lookup_distances;  // see SliceWeights
  std::vector<float> lookup_sums;                       // of all rays
  PathBatch lines;                                      // the rays without an end
  std::vector<float> along_rays, line_depths;
  std::array<std::vector<float>, 3> emission;
  std::array<std::vector<float>, light_pack> radiance;
};

// Adds the source function of the slices.
void add_source_function(const SlicedSource& from, const TileRays& rays, SliceScratch& s,
                         std::span<glm::vec3> airlight) {
  const SourceFunction& function = *from.function;
  const SourceLookup& source = from.lookup;
  const std::size_t stride = s.rays.padded_size();
  s.lookup_sums.assign(stride * source.sums_size(), 0.0f);
  bool needs_weights = function.has_forward_lobe();
  for (std::size_t at = 0; at < s.lookup_weights.size(); at += stride) {
    needs_weights |= source.add(s.rays, s.lookup_distances.data() + at,
                                s.lookup_weights.data() + at, s.lookup_sums.data());
  }
  SourceWeights weights;
  for (std::size_t i = 0; i < rays.directions.size(); ++i) {
    if (needs_weights && (i == 0 || function.is_anisotropic())) {
      weights = function.weights(rays.directions[i]);
    }
    glm::vec3 scattered = source.source(
        std::span(s.lookup_sums).subspan(i * source.sums_size(), source.sums_size()), weights);
    if (function.has_forward_lobe()) {
      scattered += s.along_rays[i] * function.lobe(source, weights, s.line_depths[i]);
    }
    airlight[i] += glm::max(scattered, 0.0f);
  }
}

}  // namespace

std::uint64_t sliced_airlight(const MediumIndex& medium, std::span<const std::uint32_t> gaussians,
                              std::span<const SlicedLight> lights, const SlicedSource* source,
                              const TileRays& rays, const SliceNodes& slices,
                              const TileAirlight& out) {
  thread_local SliceScratch s;
  const std::size_t count = rays.directions.size();
  std::fill(out.airlight.begin(), out.airlight.end(), glm::vec3(0.0f));
  std::fill(out.depths.begin(), out.depths.end(), 0.0);
  if (slices.count == 0) return 0;

  s.batch.assign(medium, rays.eye, gaussians, medium.noise());
  s.batch.add_optics(medium);
  s.rays.assign(rays.directions, rays.lengths);
  s.slices.interpolate(slices, rays.positions, s.rays);
  const std::size_t stride = s.rays.padded_size();
  const std::size_t last = s.slices.count() - 1;
  SliceOptics optics{.has = s.batch.has_optics()};
  s.increments.assign(last * stride * (optics.has ? optics_increments : 1), 0.0f);
  const std::uint64_t pairs = accumulate_increments(s.batch, s.rays, s.slices, s.increments.data());

  const double b0 = medium.homogeneous_density();
  const auto negligible = static_cast<float>(medium.negligible_depth());
  s.depths.resize(stride);
  SliceWeights slice_weights;
  const float light_extinction =
      source ? static_cast<float>(source->function->light_extinction()) : 1.0f;
  if (source) {
    const std::size_t lookups = (last + slices_per_lookup - 1) / slices_per_lookup;
    s.lookup_weights.resize(lookups * stride);
    s.lookup_distances.resize(lookups * stride);
    slice_weights.lookups = s.lookup_weights.data();
    slice_weights.lookup_distances = s.lookup_distances.data();
    slice_weights.extinction = light_extinction;
    if (source->function->has_forward_lobe()) {
      s.along_rays.resize(stride);
      slice_weights.along_rays = s.along_rays.data();
      s.line_depths.assign(stride, 0.0f);
      if (medium.anisotropy() > 0.0) {
        s.lines = s.rays;
        s.lines.make_endless();
        accumulate_path_depths(s.batch, s.lines, s.line_depths.data());
      }
    }
  }
  const SliceScattering scattering =
      slice_scattering(medium.anisotropy(), source ? source->function : nullptr);
  for (std::size_t c = 0; c < 3 && optics.has; ++c) {
    s.emission[c].resize(stride);
    optics.emission[c] = s.emission[c].data();
  }
  for (std::size_t first = 0; first == 0 || first < lights.size(); first += light_pack) {
    std::array<SliceLight, light_pack> pack;
    std::array<float*, light_pack> radiance{};
    const std::size_t size = std::min(light_pack, lights.size() - first);
    for (std::size_t l = 0; l < size; ++l) {
      const SlicedLight& light = lights[first + l];
      pack[l] = {glm::vec3(light.position - rays.eye),
                 static_cast<float>(light.h_min),
                 light_extinction,
                 light.table,
                 light.shadows,
                 light.falloff};
      pack[l].map_origin = pack[l].position;
      if (light.is_far) {
        const glm::dvec3 from_light = rays.eye - light.position;
        pack[l].map_origin = glm::vec3(0.0f);
        if (light.table) pack[l].in_table = glm::vec3(light.table->map().components(from_light));
        if (light.shadows) {
          pack[l].in_shadows = glm::vec3(light.shadows->map().components(from_light));
        }
      }
      if (!light.fog.is_endless()) {
        pack[l].fog_center = glm::vec3(light.fog.center - rays.eye);
        pack[l].fog_radius = static_cast<float>(light.fog.radius);
      }
      s.radiance[l].assign(stride, 0.0f);
      radiance[l] = s.radiance[l].data();
    }
    sum_slices(s.rays, s.slices, s.increments.data(), static_cast<float>(b0), scattering,
               negligible, std::span(pack).first(size), s.depths.data(),
               first == 0 ? slice_weights : SliceWeights(), optics, radiance);
    optics.emission = {};
    for (std::size_t l = 0; l < size; ++l) {
      const glm::vec3 intensity(lights[first + l].intensity);
      for (std::size_t k = 0; k < count; ++k) out.airlight[k] += intensity * radiance[l][k];
    }
  }
  if (source) add_source_function(*source, rays, s, out.airlight);
  for (std::size_t k = 0; optics.has && k < count; ++k) {
    out.airlight[k] += glm::vec3(s.emission[0][k], s.emission[1][k], s.emission[2][k]);
  }
  for (std::size_t k = 0; k < count; ++k) {
    // Homogeneous fog continues behind the last slice; the Gaussians do not.
    const auto sliced = static_cast<double>(*s.slices.at(k, last));
    const double rest = std::max(rays.lengths[k] - sliced, 0.0);
    out.depths[k] = static_cast<double>(s.depths[k]) + (b0 > 0.0 ? b0 * rest : 0.0);
  }
  return pairs;
}

}  // namespace brume
