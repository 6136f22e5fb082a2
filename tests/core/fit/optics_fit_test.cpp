// Optics fitted to colours and emissions on grids.

#include "core/fit/optics_fit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "brume/fit.h"
#include "core/volume/medium_grid.h"
#include "tests/core/fit/matter.h"
#include "tests/random.h"

namespace brume {
namespace {

// Colours and emissions that vary as much across the medium as its Gaussians can show.
Medium colored_medium() {
  Random random(5);
  Medium medium;
  for (int i = 0; i < 30; ++i) {
    Gaussian g{random.point(1.0), random.uniform(0.2, 0.45), random.uniform(0.2, 2.0)};
    const glm::dvec3 t = 0.5 + 0.5 * glm::sin(3.0 * g.center);
    g.optics.albedo = 0.1 + 0.85 * t;
    g.optics.emission = {5.0 * t.y * t.y, 2.0 * t.x, 0.5};
    medium.append(g);
  }
  return medium;
}

struct Sampled {
  DensityGrid density;
  OpticsTargets targets;
  VolumeColors colors;
};

Sampled sampled(const Medium& medium) {
  const MediumSampling plan = *MediumSampling::plan(medium, 0.1, 1'000'000);
  Sampled result{*plan.sample(), {}, *plan.sample_colors(glm::dvec3(1.0))};
  const DensityGrid& density = result.density;
  result.targets.extinction = {density, density, density};
  result.targets.emission = {density, density, density};
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t b = 0; b < density.blocks.size(); ++b) {
      for (std::size_t i = 0; i < DensityGrid::block_size; ++i) {
        const float albedo = (*result.colors.albedo)[k].blocks[b].values[i];
        if (!(albedo > 0.0f)) continue;
        float& extinction = (*result.targets.extinction)[k].blocks[b].values[i];
        extinction /= albedo;
        (*result.targets.emission)[k].blocks[b].values[i] =
            extinction * (*result.colors.emission)[k].blocks[b].values[i];
      }
    }
  }
  return result;
}

std::vector<Gaussian> gaussians_of(const Medium& medium) {
  std::vector<Gaussian> all;
  for (std::size_t i = 0; i < medium.size(); ++i) all.push_back(medium.gaussian(i));
  return all;
}

TEST(OpticsFit, SampledColoursAreThoseOfTheMatter) {
  const Medium medium = colored_medium();
  const Sampled grids = sampled(medium);
  const DensityGrid& density = grids.density;
  for (std::size_t b = 0; b < density.blocks.size(); b += 7) {
    for (std::size_t i = 0; i < DensityGrid::block_size; i += 11) {
      // Where what is cut off of each Gaussian, 1e-4 of its peak, hardly matters.
      if (density.blocks[b].values[i] < 0.1f) continue;
      const auto v = static_cast<int>(i);
      const glm::ivec3 place = density.blocks[b].corner + glm::ivec3(v / 64, v / 8 % 8, v % 8);
      const Matter matter = matter_at(gaussians_of(medium), density.to_world(glm::dvec3(place)));
      for (std::size_t k = 0; k < 3; ++k) {
        const auto c = static_cast<int>(k);
        EXPECT_NEAR((*grids.colors.albedo)[k].blocks[b].values[i], matter.albedo[c], 0.01);
        EXPECT_NEAR((*grids.colors.emission)[k].blocks[b].values[i], matter.emission[c], 0.05);
      }
    }
  }
}

// Twice as many Gaussians as made the volume: 0.7% and 2.5% were found, means of the colours
// weighted by density instead of least squares err by 7% and 24%.
TEST(OpticsFit, RecoversColoursAndEmissions) {
  const Medium medium = colored_medium();
  const Sampled grids = sampled(medium);
  Fit fit = *fit_gaussians(grids.density, {60, 0.0, FitShape::ball});
  const OpticsErrors errors = fit_optics(grids.density, grids.targets, fit.gaussians);
  EXPECT_LT(*errors.extinction, 0.03);
  EXPECT_LT(*errors.emission, 0.05);
  Random random(9);
  const std::vector<Gaussian> exact = gaussians_of(medium);
  double albedo_squares = 0.0;
  double emission_squares = 0.0;
  double scale = 0.0;
  int count = 0;
  while (count < 1000) {
    const glm::dvec3 x = random.point(1.0);
    if (grids.density.at(grids.density.to_voxel(x)) < 0.1) continue;
    const Matter expected = matter_at(exact, x);
    const Matter found = matter_at(fit.gaussians, x);
    const glm::dvec3 albedo_error = found.albedo - expected.albedo;
    const glm::dvec3 emission_error = found.emission - expected.emission;
    albedo_squares += glm::dot(albedo_error, albedo_error) / 3.0;
    emission_squares += glm::dot(emission_error, emission_error);
    scale += glm::dot(expected.emission, expected.emission);
    ++count;
  }
  EXPECT_LT(std::sqrt(albedo_squares / count), 0.015);
  EXPECT_LT(std::sqrt(emission_squares / scale), 0.05);
}

TEST(OpticsFit, OneColourStaysThatColour) {
  Sampled grids = sampled(colored_medium());
  const glm::dvec3 albedo(0.9, 0.5, 0.2);
  const glm::dvec3 emission(3.0, 0.0, 1e6);
  for (std::size_t k = 0; k < 3; ++k) {
    const auto c = static_cast<int>(k);
    (*grids.targets.extinction)[k] = grids.density;
    (*grids.targets.emission)[k] = grids.density;
    for (std::size_t b = 0; b < grids.density.blocks.size(); ++b) {
      for (float& value : (*grids.targets.extinction)[k].blocks[b].values) {
        value /= static_cast<float>(albedo[c]);
      }
      for (float& value : (*grids.targets.emission)[k].blocks[b].values) {
        value *= static_cast<float>(emission[c] / albedo[c]);
      }
    }
  }
  Fit fit = *fit_gaussians(grids.density, {10, 0.0});
  fit_optics(grids.density, grids.targets, fit.gaussians);
  for (const Gaussian& g : fit.gaussians) {
    // Single precision.
    EXPECT_LT(glm::length(*g.optics.albedo - albedo), 1e-4);
    EXPECT_LT(glm::length((g.optics.emission - emission) / glm::max(emission, 1.0)), 1e-4);
  }
  // Without targets there are no optics.
  fit = *fit_gaussians(grids.density, {10, 0.0});
  fit_optics(grids.density, {}, fit.gaussians);
  for (const Gaussian& g : fit.gaussians) EXPECT_EQ(g.optics, GaussianOptics());
}

}  // namespace
}  // namespace brume
