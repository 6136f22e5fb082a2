// Sequences of volumes, fitted, as they are seen.

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>
#include <vector>

#include "core/fit/volume_fitter.h"
#include "tools/bench/measure/frames.h"

namespace brume {
namespace {

const std::filesystem::path volumes = BRUME_VOLUMES;

// A volume as it is: a Gaussian for each voxel, of its mass, wide enough that they add up evenly.
std::vector<Gaussian> voxels_of(const DensityGrid& grid) {
  const double radius = 0.75 * std::cbrt(grid.voxel_volume());
  const double peak = grid.voxel_volume() / std::pow(std::sqrt(std::numbers::pi) * radius, 3.0);
  std::vector<Gaussian> voxels;
  for (const DensityGrid::Block& block : grid.blocks) {
    for (int i = 0; i < static_cast<int>(DensityGrid::block_size); ++i) {
      const double density = static_cast<double>(block.values[static_cast<std::size_t>(i)]);
      const glm::ivec3 voxel = block.corner + glm::ivec3(i / 64, i / 8 % 8, i % 8);
      if (density > 0.0) voxels.push_back({grid.to_world(voxel), radius, peak * density});
    }
  }
  return voxels;
}

// Shows an entire volume, lit from the side.
Scene view_of(const DensityGrid& grid) {
  glm::dvec3 low(std::numeric_limits<double>::infinity());
  glm::dvec3 high = -low;
  for (const Gaussian& voxel : voxels_of(grid)) {
    low = glm::min(low, voxel.center);
    high = glm::max(high, voxel.center);
  }
  const glm::dvec3 center = 0.5 * (low + high);
  const double size = glm::length(high - low);
  Scene scene;
  scene.film = {32, 32};
  scene.camera = {center + size * glm::dvec3(1.3, 0.4, 0.9), center, {0.0, 0.0, 1.0}, 45.0};
  scene.lights = {{center + size * glm::dvec3(-0.7, 1.0, 0.8), glm::dvec3(size * size), {}}};
  return scene;
}

std::vector<float> picture(Scene view, const std::vector<Gaussian>& gaussians) {
  for (const Gaussian& gaussian : gaussians) view.medium.append(gaussian);
  return render_frame(view, sliced_settings({}, 64)).airlight;
}

std::vector<float> difference(const std::vector<float>& a, const std::vector<float>& b) {
  std::vector<float> result;
  for (std::size_t i = 0; i < a.size(); ++i) result.push_back(a[i] - b[i]);
  return result;
}

double norm(const std::vector<float>& values) {
  double sum = 0.0;
  for (const float value : values) sum += static_cast<double>(value) * static_cast<double>(value);
  return std::sqrt(sum);
}

// A picture of the Gaussians changes from frame to frame as much as one of the smoke itself, within
// the 10% that the project promises; and what it changes otherwise than the smoke, which is seen as
// flicker, is less than where each frame is fitted by itself.
TEST(SequenceView, FittedSmokeDoesNotFlicker) {
  VolumeFit how;
  how.options.count = 60;
  VolumeFitter fitter(how);
  const FittedVolume first = *fitter.next(volumes / "smoke_0025.vdb");
  const FittedVolume second = *fitter.next(volumes / "smoke_0026.vdb");
  const FittedVolume by_itself = *VolumeFitter(how).next(volumes / "smoke_0026.vdb");
  const Scene view = view_of(first.grid);
  const std::vector<float> before = picture(view, first.fit.gaussians);
  const std::vector<float> smoke =
      difference(picture(view, voxels_of(second.grid)), picture(view, voxels_of(first.grid)));
  const std::vector<float> fog = difference(picture(view, second.fit.gaussians), before);
  const std::vector<float> anew = difference(picture(view, by_itself.fit.gaussians), before);
  EXPECT_NEAR(norm(fog) / norm(smoke), 1.0, 0.1);
  EXPECT_LT(norm(difference(fog, smoke)), 0.9 * norm(difference(anew, smoke)));
}

}  // namespace
}  // namespace brume
