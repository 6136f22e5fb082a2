// Volumes with colours, temperatures and flames, as Gaussians.

#include "core/fit/volume_fitter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <set>

#include "brume/error.h"
#include "core/scene/lights/photometry.h"
#include "tests/core/fit/matter.h"
#include "tests/core/io/input_error.h"
#include "tests/core/io/temporary_folder.h"
#include "tests/core/io/volume/vdb_test_grid.h"

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

class VolumeFitterTest : public testing::Test {
 protected:
  VolumeFitterTest() { how_.options.count = 10; }

  FittedVolume fitted(const openvdb::GridCPtrVec& grids, const VolumeFit& how) {
    write_vdb(folder_ / "a.vdb", grids);
    return *VolumeFitter(how).next(folder_ / "a.vdb");
  }

  TemporaryFolder folder_;
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

}  // namespace
}  // namespace brume
