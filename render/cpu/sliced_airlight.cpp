#include "render/cpu/sliced_airlight.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <optional>

#include "core/math/infinity.h"
#include "render/geometry/ray_range.h"
#include "render/optical_depth/increment_kernels.h"
#include "render/simd/gaussian_kernels.h"
#include "render/slices/slice_boundaries.h"
#include "render/slices/slice_kernels.h"

namespace brume {
namespace {

struct SliceScratch {
  RaySlices slices;
  GaussianBatch batch;
  PathBatch rays;
  std::vector<float> increments, moments;
  std::vector<float> depths;
  std::vector<float> lookup_weights, lobe_weights, lookup_distances;  // see SliceWeights
  std::vector<float> lookup_sums;                                     // of all rays
  PathBatch lines;                                                    // the rays without an end
  std::vector<float> along_rays, line_depths;
  std::array<std::vector<float>, 3> emission;
  std::array<std::vector<float>, light_pack> radiance;
  std::vector<SourceWeights> weights;  // of the rays
  std::vector<glm::vec3> lobe;         // what an EyeLobe adds
};

// Where airlight goes: all of it, or what comes from before the end of each look-up.
struct AirlightRows {
  std::span<glm::vec3> airlight;  // [row * rays + i]
  std::size_t rays;
  std::size_t count;   // of rows
  std::size_t slices;  // of running sums; 0: sums are total
  std::size_t stride;  // of sums

  // The number of sums that a row holds.
  [[nodiscard]] std::size_t sums(std::size_t row) const {
    if (slices == 0) return 0;
    return (std::min((row + 1) * slices_per_lookup, slices) - 1) * stride;
  }
  // radiance[c] = value(i-th of the sums) is added to each ray of each row.
  template <class Value>
  void add(Value value) const {
    for (std::size_t row = 0; row < count; ++row) {
      for (std::size_t i = 0; i < rays; ++i) airlight[row * rays + i] += value(sums(row) + i);
    }
  }
};

// Adds the source function of the slices.
void add_source_function(const SlicedSource& from, const TileRays& rays, SliceScratch& s,
                         const AirlightRows& out) {
  const SourceFunction& function = *from.function;
  const SourceLookup& source = from.lookup;
  const std::size_t stride = s.rays.padded_size();
  s.lookup_sums.assign(stride * source.sums_size(), 0.0f);
  s.weights.clear();
  bool needs_weights = function.has_lobe_on_rays();
  SourceWeights own_weights;
  // Once for each ray, or for all; kept for the rows to come.
  const auto weights_of = [&](std::size_t i) -> const SourceWeights& {
    if (!needs_weights) return own_weights;
    if (out.slices == 0) {
      if (i == 0 || function.is_anisotropic())
        own_weights = function.weights(rays.directions[i], from.lobe);
      return own_weights;
    }
    if (s.weights.empty()) {
      const std::size_t count = function.is_anisotropic() ? out.rays : 1;
      for (std::size_t k = 0; k < count; ++k) {
        s.weights.push_back(function.weights(rays.directions[k], from.lobe));
      }
    }
    return s.weights[function.is_anisotropic() ? i : 0];
  };
  const bool has_lobe = from.lobe && !from.lobe->empty();
  if (has_lobe) s.lobe.assign(out.rays, glm::vec3(0.0f));
  const auto offset = [&](std::size_t i) {
    return rays.offsets.empty() ? glm::vec3(0.0f) : glm::vec3(rays.offsets[i]);
  };
  const auto direction = [&](std::size_t i) { return glm::vec3(rays.directions[i]); };
  const std::size_t lookups = s.lookup_weights.size() / stride;
  for (std::size_t j = 0; j < lookups; ++j) {
    const float* const distances = s.lookup_distances.data() + j * stride;
    const float* const scattered_shares = s.lookup_weights.data() + j * stride;
    needs_weights |= source.add(s.rays, distances, scattered_shares,
                                s.lobe_weights.data() + j * stride, s.lookup_sums.data());
    for (std::size_t i = 0; has_lobe && i < out.rays; ++i) {
      if (!(scattered_shares[i] > 0.0f)) continue;
      s.lobe[i] += scattered_shares[i] * from.lobe->at(offset(i), direction(i), distances[i]);
    }
    if (out.slices == 0 && j + 1 < lookups) continue;
    const std::size_t row = out.slices == 0 ? 0 : j;
    for (std::size_t i = 0; i < out.rays; ++i) {
      const SourceWeights& weights = weights_of(i);
      glm::vec3 scattered = source.source(
          std::span(s.lookup_sums).subspan(i * source.sums_size(), source.sums_size()), weights);
      if (has_lobe) scattered += s.lobe[i];
      if (function.has_lobe_on_rays()) {
        scattered += s.along_rays[out.sums(row) + i] *
                     function.lobe_on_ray(source, weights, s.line_depths[i], rays, i);
      }
      out.airlight[row * out.rays + i] += glm::max(scattered, 0.0f);
    }
  }
}

// Fills distances and depths of profiles, front to back.
void set_depths(const SliceScratch& s, const MediumIndex& medium, const TileRays& tile,
                TileProfiles& profiles) {
  const double b0 = medium.homogeneous_density();
  const std::size_t rays = tile.directions.size();
  const std::size_t stride = s.rays.padded_size();
  const std::size_t boundaries = s.slices.count();
  profiles.distances.resize(boundaries * rays);
  profiles.depths.resize(boundaries * rays);
  for (std::size_t i = 0; i < rays; ++i) {
    const FogInterval fog = medium.fog().interval(tile.origin(i), tile.directions[i]);
    double depth = 0.0;
    for (std::size_t k = 0; k < boundaries; ++k) {
      const float t = *s.slices.at(i, k);
      if (k > 0) {
        const double length =
            fog.overlap(static_cast<double>(*s.slices.at(i, k - 1)), static_cast<double>(t));
        depth += b0 * length + std::max(s.increments[(k - 1) * stride + i], 0.0f);
      }
      profiles.distances[k * rays + i] = t;
      profiles.depths[k * rays + i] = depth;
    }
  }
}

}  // namespace

std::uint64_t sliced_airlight(const MediumIndex& medium, std::span<const std::uint32_t> gaussians,
                              std::span<const SlicedLight> lights, const SlicedSource* source,
                              const TileRays& rays, const SliceNodes& slices,
                              const TileAirlight& out, TileProfiles* profiles) {
  thread_local SliceScratch s;
  const std::size_t count = rays.directions.size();
  std::fill(out.airlight.begin(), out.airlight.end(), glm::vec3(0.0f));
  std::fill(out.depths.begin(), out.depths.end(), 0.0);
  if (profiles) profiles->count = 0;
  if (slices.count == 0) return 0;

  s.batch.assign(medium, rays, gaussians);
  s.batch.add_optics(medium);
  s.rays.assign(rays);
  s.slices.interpolate(slices, rays.positions, s.rays);
  if (profiles) s.slices.subdivide(slices_per_lookup * profiles->parts);
  const std::size_t stride = s.rays.padded_size();
  const std::size_t last = s.slices.count() - 1;
  SliceOptics optics{.has = s.batch.has_optics()};
  s.increments.assign(last * stride * (optics.has ? optics_increments : 1), 0.0f);
  s.moments.assign(last * stride, 0.0f);
  const std::uint64_t pairs =
      accumulate_increments(s.batch, s.rays, s.slices, s.increments.data(), s.moments.data());
  const std::size_t sums = profiles ? last : 1;
  AirlightRows rows{out.airlight, count, 1, 0, stride};
  if (profiles) {
    profiles->count = last / slices_per_lookup + 1;
    profiles->airlight.assign(profiles->count * count, glm::vec3(0.0f));
    // Nothing before the first distance.
    rows = {std::span(profiles->airlight).subspan(count), count, profiles->count - 1, last, stride};
  }

  const double b0 = medium.homogeneous_density();
  const BatchFog fog(medium, rays.eye);
  const auto negligible = static_cast<float>(medium.negligible_depth());
  s.depths.resize(stride);
  SliceWeights slice_weights;
  const float light_extinction =
      source ? static_cast<float>(source->function->light_extinction()) : 1.0f;
  if (source) {
    const std::size_t lookups = (last + slices_per_lookup - 1) / slices_per_lookup;
    s.lookup_weights.resize(lookups * stride);
    s.lobe_weights.resize(lookups * stride);
    s.lookup_distances.resize(lookups * stride);
    slice_weights.lookups = s.lookup_weights.data();
    slice_weights.lobe_lookups = s.lobe_weights.data();
    slice_weights.lookup_distances = s.lookup_distances.data();
    slice_weights.extinction = light_extinction;
    slice_weights.fog_extinction = static_cast<float>(source->function->lobe_fog_extinction());
    if (source->function->has_lobe_on_rays()) {
      s.along_rays.resize(stride * sums);
      slice_weights.along_rays = s.along_rays.data();
      s.line_depths.assign(stride, 0.0f);
      if (medium.anisotropy() > 0.0) {
        s.lines = s.rays;
        s.lines.make_endless();
        accumulate_path_depths(s.batch, s.lines, s.line_depths.data());
        for (std::size_t k = 0; k < count && !medium.fog().is_endless(); ++k) {
          s.line_depths[k] +=
              static_cast<float>(medium.fog_depth(rays.origin(k), rays.directions[k], infinity));
        }
      }
    }
  }
  const SliceScattering scattering =
      slice_scattering(medium.anisotropy(), source ? source->function : nullptr);
  for (std::size_t c = 0; c < 3 && optics.has; ++c) {
    s.emission[c].resize(stride * sums);
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
      }
      if (light.shadows) {
        const glm::dvec3 in_shadows =
            light.is_far ? light.shadows->map().components(rays.eye - light.position)
                         : glm::dvec3(0.0);
        pack[l].in_shadows = glm::vec3(in_shadows);
        pack[l].shadow_depth = static_cast<float>(in_shadows.z - light.shadows->start());
      }
      if (!light.fog.is_endless()) {
        pack[l].fog_center = glm::vec3(light.fog.center - rays.eye);
        pack[l].fog_radius = static_cast<float>(light.fog.radius);
      }
      s.radiance[l].assign(stride * sums, 0.0f);
      radiance[l] = s.radiance[l].data();
    }
    sum_slices(s.rays, s.slices, s.increments.data(), s.moments.data(), fog, scattering, negligible,
               std::span(pack).first(size), s.depths.data(),
               first == 0 ? slice_weights : SliceWeights(), optics, radiance,
               profiles ? SliceSums::running : SliceSums::total);
    optics.emission = {};
    for (std::size_t l = 0; l < size; ++l) {
      const glm::vec3 intensity(lights[first + l].intensity);
      rows.add([&](std::size_t i) { return intensity * radiance[l][i]; });
    }
  }
  if (source) add_source_function(*source, rays, s, rows);
  if (optics.has) {
    rows.add([&](std::size_t i) {
      return glm::vec3(s.emission[0][i], s.emission[1][i], s.emission[2][i]);
    });
  }
  if (profiles) {
    set_depths(s, medium, rays, *profiles);
    std::ranges::copy(std::span(profiles->airlight).last(count), out.airlight.begin());
  }
  for (std::size_t k = 0; k < count; ++k) {
    // Homogeneous fog continues behind the last slice; the Gaussians do not.
    const auto sliced = static_cast<double>(*s.slices.at(k, last));
    double rest = std::max(rays.lengths[k] - sliced, 0.0);
    if (!medium.fog().is_endless()) {
      rest = medium.fog()
                 .interval(rays.origin(k), rays.directions[k])
                 .overlap(sliced, rays.lengths[k]);
    }
    out.depths[k] = static_cast<double>(s.depths[k]) + (b0 > 0.0 ? b0 * rest : 0.0);
  }
  return pairs;
}

void sliced_airlight_along(const MediumIndex& medium, std::span<const SlicedLight> lights,
                           const SourceFunction* source, int slices, TileRays rays,
                           const TileAirlight& out) {
  thread_local std::vector<std::uint32_t> gaussians;
  thread_local std::vector<double> boundaries;
  thread_local std::vector<float> nodes;
  TileCone cone;
  cone.eye = rays.eye;
  cone.center = rays.directions.front();
  for (std::size_t k = 0; k < rays.directions.size(); ++k) {
    cone.spread = std::max(cone.spread, glm::length(rays.directions[k] - cone.center));
    cone.max_length = std::max(cone.max_length, rays.lengths[k]);
    if (!rays.offsets.empty()) cone.width = std::max(cone.width, glm::length(rays.offsets[k]));
  }
  gaussians.clear();
  medium.bvh().query(cone, [&](std::uint32_t i) { gaussians.push_back(i); });
  if (!gaussians.empty() && rays.directions.size() > 1) {
    for (std::size_t k = 0; k < rays.directions.size(); ++k) {
      sliced_airlight_along(medium, lights, source, slices,
                            {.eye = rays.origin(k),
                             .directions = rays.directions.subspan(k, 1),
                             .lengths = rays.lengths.subspan(k, 1)},
                            {out.airlight.subspan(k, 1), out.depths.subspan(k, 1)});
    }
    return;
  }
  std::ranges::sort(gaussians);
  choose_slices(medium, gaussians, lights, cone, std::max(slices / 2, 4), boundaries);
  nodes.clear();
  for (const double t : boundaries) nodes.push_back(static_cast<float>(std::min(t, endless)));
  SliceNodes same;
  same.boundaries.fill(nodes.data());
  same.count = nodes.size() < 2 ? 0 : nodes.size();
  const std::vector<glm::vec2> places(rays.directions.size(), glm::vec2(0.5f));
  rays.positions = places;
  std::optional<SlicedSource> seen;
  if (source) seen = {source, source->from_eye(rays.eye)};
  sliced_airlight(medium, gaussians, lights, seen ? &*seen : nullptr, rays, same, out);
}

AirlightAlong sliced_airlight_along(const MediumIndex& medium,
                                    std::shared_ptr<const std::vector<SlicedLight>> lights,
                                    const SourceFunction* source, int slices, double albedo) {
  return [&medium, lights = std::move(lights), source, slices, albedo](
             const glm::dvec3& origin, auto offsets, auto directions, auto lengths, auto airlight,
             auto depths) {
    sliced_airlight_along(
        medium, *lights, source, slices,
        {.eye = origin, .directions = directions, .lengths = lengths, .offsets = offsets},
        {airlight, depths});
    // The frame's own airlight is multiplied at the end.
    for (glm::vec3& radiance : airlight) radiance *= static_cast<float>(albedo);
  };
}

}  // namespace brume
