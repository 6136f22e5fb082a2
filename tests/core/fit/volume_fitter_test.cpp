// Volumes with colours, temperatures and flames, as Gaussians.

#include "core/fit/volume_fitter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <set>

#include "brume/fit.h"
#include "core/fit/optics_fit.h"
#include "core/fit/volume_survey.h"
#include "core/scene/lights/photometry.h"
#include "core/volume/medium_grid.h"
#include "tests/core/fit/matter.h"
#include "tests/core/io/folder_test.h"
#include "tests/core/io/input_error.h"
#include "tests/core/io/volume/vdb_test_grid.h"
#include "tests/random.h"

namespace brume {
namespace {

using Numbers = openvdb::FloatGrid;
constexpr double voxel = 0.1;

// A ball of peak `peak` around a point of the x axis.
Numbers::Ptr ball(const char* name, double x, double peak = 1.0) {
  return vdb_cube<Numbers>(name, 14, voxel, [=](const glm::dvec3& p) {
    const glm::dvec3 d = (p - glm::dvec3(x, 0.0, 0.0)) / 0.35;
    const double value = peak * std::exp(-glm::dot(d, d));
    return static_cast<float>(value > 1e-4 ? value : 0.0);
  });
}

Numbers::Ptr constant(const char* name, double value) {
  return vdb_cube<Numbers>(name, 14, voxel,
                           [=](const glm::dvec3&) { return static_cast<float>(value); });
}

class VolumeFitterTest : public FolderTest {
 protected:
  VolumeFitterTest() { how_.options.count = 10; }

  FittedVolume fitted(const openvdb::GridCPtrVec& grids, const VolumeFit& how) {
    write_vdb(folder_ / "a.vdb", grids);
    return *VolumeFitter(how).next(folder_ / "a.vdb");
  }

  VolumeFit how_;
};

TEST_F(VolumeFitterTest, FlamesShineWithoutSmoke) {
  const FittedVolume both =
      fitted({ball("density", 0.7), ball("flame", -0.7), constant("temperature", 1.0)}, how_);
  ASSERT_TRUE(both.flames);
  EXPECT_EQ(both.gaussians().size(), 10u);
  // Smoke of 1 K is dark and has the medium's albedo.
  for (const Gaussian& g : both.fit.gaussians) EXPECT_EQ(g.optics, GaussianOptics());
  double extinction = 0.0;
  for (const Gaussian& g : both.flames->gaussians) {
    // 1850 K; single precision.
    const glm::dvec3 radiance = black_body_radiance(1850.0);
    EXPECT_LT(glm::length(g.optics.emission - radiance), 1e-4 * glm::length(radiance));
    EXPECT_EQ(g.optics.albedo, glm::dvec3(flame_albedo));
    const glm::dvec3 d = warp(g.shape) * (g.center + glm::dvec3(0.7, 0.0, 0.0)) / g.radius;
    extinction += g.density / flame_albedo * std::exp(-glm::dot(d, d));
  }
  // A flame of 1; the fit's error is 1%.
  EXPECT_NEAR(extinction, 0.1, 0.003);

  // However few Gaussians there may be, smoke and flames have one each.
  VolumeFit few = how_;
  few.options.count = 2;
  const FittedVolume two = fitted({ball("density", 0.7, 0.01), ball("flame", -0.7)}, few);
  EXPECT_EQ(two.fit.gaussians.size(), 1u);
  EXPECT_EQ(two.flames->gaussians.size(), 1u);

  VolumeFit flames_alone = how_;
  flames_alone.grid = no_grid;
  const FittedVolume alone = fitted({ball("flame", -0.7)}, flames_alone);
  EXPECT_TRUE(alone.fit.gaussians.empty());
  EXPECT_EQ(alone.gaussians().size(), 10u);
  EXPECT_TRUE(fitted({constant("flame", 0.0)}, flames_alone).gaussians().empty());
  expect_error([&] { fitted({ball("smoke", 0.0)}, flames_alone); }, "no flames");
}

TEST_F(VolumeFitterTest, HotMatterShinesAsABlackBody) {
  how_.appearance.temperature_scale = 1000.0;
  how_.appearance.emission_scale = 0.5;
  const openvdb::GridCPtrVec grids{ball("density", 0.0), ball("flame", 0.0),
                                   constant("temperature", 1.5)};
  const glm::dvec3 radiance = 0.5 * black_body_radiance(1500.0);
  const FittedVolume fit = fitted(grids, how_);
  for (const Gaussian& g : fit.gaussians()) {
    EXPECT_LT(glm::length(g.optics.emission - radiance), 1e-4 * glm::length(radiance));
  }
  EXPECT_TRUE(fit.errors.emission);
  how_.appearance.grids = {.temperature = no_grid, .flame = no_grid};
  for (const Gaussian& g : fitted(grids, how_).gaussians()) EXPECT_EQ(g.optics, GaussianOptics());
}

// Blender's caches multiply colours by the density; other programs do not.
TEST_F(VolumeFitterTest, ColoursAreAlbedosWhicheverWayTheyAreStored) {
  how_.density_scale = 3.0;
  const openvdb::GridCPtrVec split{ball("density", 0.0), ball("color_r", 0.0, 0.8),
                                   ball("color_g", 0.0, 0.4), ball("color_b", 0.0, 0.0)};
  const auto colors = vdb_cube<openvdb::Vec3SGrid>(
      "Cd", 14, voxel, [](const glm::dvec3&) { return openvdb::Vec3s(0.8f, 0.4f, 0.0f); });
  for (const openvdb::GridCPtrVec& grids :
       {split, openvdb::GridCPtrVec{ball("density", 0.0), colors}}) {
    for (const Gaussian& g : fitted(grids, how_).gaussians()) {
      ASSERT_TRUE(g.optics.albedo);
      // An albedo of 0 becomes the least that may be fitted. The cut of a ball at 1e-4 is another
      // for its colours.
      EXPECT_LT(glm::length(*g.optics.albedo - glm::dvec3(0.8, 0.4, min_fitted_albedo)), 0.01);
    }
  }
}

// Red grows along x, green along z, which becomes y.
TEST_F(VolumeFitterTest, ColoursTurnWithTheVolume) {
  how_.options.count = 20;
  how_.z_up = true;
  const auto colors = vdb_cube<openvdb::Vec3SGrid>("color", 14, voxel, [](const glm::dvec3& x) {
    return to_vdb({0.5 + 0.3 * x.x, 0.5 + 0.3 * x.z, 0.5});
  });
  const std::vector<Gaussian> found = fitted({ball("density", 0.0), colors}, how_).gaussians();
  for (const glm::dvec3& x : {glm::dvec3(0.3, 0.3, 0.0), glm::dvec3(-0.3, 0.3, 0.1)}) {
    const glm::dvec3 albedo = matter_at(found, x).albedo;
    // The change over a fifth of the ball's radius.
    EXPECT_LT(glm::length(albedo - glm::dvec3(0.5 + 0.3 * x.x, 0.5 + 0.3 * x.y, 0.5)), 0.02);
  }
}

// Flames that begin in the second frame get ids of their own, and smoke keeps its ids.
TEST_F(VolumeFitterTest, FlamesOfASequenceBeginLater) {
  VolumeFitter fitter(how_);
  write_vdb(folder_ / "1.vdb", {ball("density", 0.0), constant("flame", 0.0)});
  write_vdb(folder_ / "2.vdb", {ball("density", 0.0), ball("flame", 0.5)});
  write_vdb(folder_ / "3.vdb", {ball("density", 0.0), ball("flame", 0.6)});
  fitter.next(folder_ / "1.vdb");
  const std::vector<GaussianNumber> first(fitter.ids().begin(), fitter.ids().end());
  EXPECT_EQ(first.size(), 10u);
  std::vector<GaussianNumber> before;
  for (const char* name : {"2.vdb", "3.vdb"}) {
    const FittedVolume frame = *fitter.next(folder_ / name);
    ASSERT_TRUE(frame.flames);
    const std::span<const GaussianNumber> ids = fitter.ids();
    EXPECT_EQ(ids.size(), frame.gaussians().size());
    EXPECT_EQ(std::set(ids.begin(), ids.end()).size(), ids.size());
    EXPECT_TRUE(std::equal(first.begin(), first.end(), ids.begin()));
    for (const Gaussian& g : frame.flames->gaussians) EXPECT_GT(g.optics.emission.r, 0.0);
    EXPECT_TRUE(std::equal(before.begin(), before.end(), ids.begin()));
    before.assign(ids.begin(), ids.end());
  }
}

// Optics fitted to colours and emissions on grids.

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

TEST_F(VolumeFitterTest, PreviewIsAlreadyLikeTheVolume) {
  how_.options.count = 100'000;
  how_.is_preview = true;
  const FittedVolume preview = fitted({ball("density", 0.0)}, how_);
  EXPECT_LE(preview.gaussians().size(), 500u);
  EXPECT_LT(preview.fit.density_error, 0.2);
}

TEST(VolumeSurvey, GuessesTheUpAxis) {
  const auto is_z_up = [](const glm::dvec3& extent) {
    VolumeGridInfo grid;
    grid.max_corner = extent;
    return is_probably_z_up(grid);
  };
  EXPECT_TRUE(is_z_up({1.0, 1.1, 3.0}));   // a plume
  EXPECT_TRUE(is_z_up({9.0, 8.0, 2.0}));   // a cloud
  EXPECT_FALSE(is_z_up({1.0, 3.0, 1.1}));  // the same
  EXPECT_FALSE(is_z_up({9.0, 2.0, 8.0}));
  EXPECT_FALSE(is_z_up({2.0, 2.0, 2.05}));
  EXPECT_FALSE(is_z_up({3.0, 2.0, 20.0}));  // a tunnel
}

TEST(VolumeSurvey, CostGrowsWithVoxelsAndGaussians) {
  const auto seconds = [](std::uint64_t blocks, std::size_t count, unsigned threads = 2) {
    return estimate_fit_cost(blocks, {.count = count}, threads).seconds;
  };
  EXPECT_LT(seconds(100, 500), seconds(1000, 500));
  EXPECT_LT(seconds(1000, 500), seconds(1000, 5000));
  EXPECT_LT(seconds(1000, 500, 8), seconds(1000, 500));
  EXPECT_GT(estimate_fit_cost(200'000, {}, 2).bytes, 1e9);
}

}  // namespace

}  // namespace brume
