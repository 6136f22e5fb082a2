#include "core/fit/volume_appearance.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <glm/common.hpp>
#include <utility>

#include "core/scene/lights/photometry.h"

namespace brume {
namespace {

// The voxels of a grid times what times(value, point in the world) gives.
template <class Times>
ColorGrid times_colors(const DensityGrid& grid, Times times) {
  ColorGrid result{grid, grid, grid};
  tbb::parallel_for(std::size_t{0}, grid.blocks.size(), [&](std::size_t b) {
    const DensityGrid::Block& block = grid.blocks[b];
    for (std::size_t i = 0; i < DensityGrid::block_size; ++i) {
      const double value = block.values[i];
      if (!(value > 0.0)) continue;
      const auto v = static_cast<int>(i);
      const glm::ivec3 voxel = block.corner + glm::ivec3(v / 64, v / 8 % 8, v % 8);
      const glm::dvec3 product = value * times(value, grid.to_world(glm::dvec3(voxel)));
      for (std::size_t k = 0; k < 3; ++k) {
        result[k].blocks[b].values[i] = static_cast<float>(product[static_cast<int>(k)]);
      }
    }
  });
  return result;
}

bool is_dark(const ColorGrid& colors) {
  return std::ranges::all_of(colors, [](const DensityGrid& grid) {
    return std::ranges::all_of(grid.blocks, [](const DensityGrid::Block& block) {
      return std::ranges::all_of(block.values, [](float value) { return value == 0.0f; });
    });
  });
}

// 0 where there is none.
double local_temperature(const VolumeOptics& optics, const glm::dvec3& x) {
  const auto found = optics.temperature ? optics.temperature->at(x) : std::nullopt;
  return found ? found->x : 0.0;
}

}  // namespace

OpticsTargets smoke_targets(const DensityGrid& density, double density_scale,
                            const VolumeOptics& optics, const AppearanceOptions& options) {
  const auto albedo = [&](double b, const glm::dvec3& x) {
    const auto color = optics.color ? optics.color->at(x) : std::nullopt;
    if (!color) return glm::dvec3(1.0);
    const double divisor = optics.is_color_of_density ? b / density_scale : 1.0;
    return glm::clamp(*color / divisor, min_fitted_albedo, 1.0);
  };
  OpticsTargets targets;
  if (optics.color) {
    targets.extinction =
        times_colors(density, [&](double b, const glm::dvec3& x) { return 1.0 / albedo(b, x); });
  }
  if (optics.emission || optics.temperature) {
    ColorGrid emission = times_colors(density, [&](double b, const glm::dvec3& x) {
      glm::dvec3 radiance = black_body_radiance(local_temperature(optics, x));
      if (optics.emission) radiance += optics.emission->at(x).value_or(glm::dvec3(0.0));
      return options.emission_scale * radiance / albedo(b, x);
    });
    if (!is_dark(emission)) targets.emission = std::move(emission);
  }
  return targets;
}

OpticsTargets flame_targets(const DensityGrid& extinction, const VolumeOptics& optics,
                            const AppearanceOptions& options) {
  OpticsTargets targets;
  targets.emission = times_colors(extinction, [&](double, const glm::dvec3& x) {
    glm::dvec3 radiance = black_body_radiance(local_temperature(optics, x));
    if (radiance == glm::dvec3(0.0)) radiance = black_body_radiance(options.flame_temperature);
    return options.emission_scale * radiance;
  });
  return targets;
}

}  // namespace brume
