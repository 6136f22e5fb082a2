// Frames by paths that begin with the solved picture: what is kept of the paths.

#include "render/samples/denoised_frame.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <random>
#include <stop_token>

#include "brume/render.h"
#include "tests/render/test_scenes.h"
#include "tools/bench/measure/frames.h"

namespace brume {
namespace {

constexpr int width = 96;
constexpr int height = 64;

// A solved picture that is a tenth too dark on one side and right on the other, and two by paths
// with noise.
struct Pictures {
  std::vector<glm::vec3> truth;
  SolvedAndTraced all;

  Pictures(float noise, float missing) {
    std::mt19937 random(7);
    std::normal_distribution<float> normal;
    all.width = width;
    for (int i = 0; i < width * height; ++i) {
      const float x = static_cast<float>(i % width) / width;
      const float y = static_cast<float>(i / width) / height;
      const glm::vec3 light = (0.3f + y * y) * glm::vec3(1.0f, 0.8f, 0.5f);
      truth.push_back(light);
      all.solved.push_back((1.0f - missing * x) * light);
      for (std::vector<glm::vec3>& traced : all.traced) {
        traced.push_back((1.0f + noise * normal(random)) * light);
      }
    }
  }

  // The relative RMSE of what is made of them.
  [[nodiscard]] double error(std::span<const glm::vec3> difference) const {
    double squares = 0.0;
    double sum = 0.0;
    for (std::size_t i = 0; i < truth.size(); ++i) {
      const glm::vec3 off = all.solved[i] + difference[i] - truth[i];
      squares += static_cast<double>(glm::dot(off, off));
      sum += static_cast<double>(glm::dot(truth[i], truth[i]));
    }
    return std::sqrt(squares / sum);
  }
  [[nodiscard]] double error_of_solved() const {
    return error(std::vector<glm::vec3>(truth.size(), glm::vec3(0.0f)));
  }
};

TEST(SignificantDifference, IsAllOfItWithoutNoise) {
  const Pictures pictures(0.0f, 0.1f);
  EXPECT_GT(pictures.error_of_solved(), 0.05);
  EXPECT_LT(pictures.error(significant_difference(pictures.all, {})), 1e-6);
}

TEST(SignificantDifference, IsLittleOfNoiseAlone) {
  constexpr float noise = 0.5f;
  const Pictures pictures(noise, 0.0f);
  // Of the mean of both noise / sqrt(2) would be left.
  EXPECT_LT(pictures.error(significant_difference(pictures.all, {})), 0.05 * noise);
}

TEST(SignificantDifference, MendsWhatIsSmoothBelowTheNoise) {
  constexpr float noise = 0.5f;
  const Pictures pictures(noise, 0.2f);
  const double error = pictures.error(significant_difference(pictures.all, {}));
  EXPECT_LT(error, 0.3 * pictures.error_of_solved());
  EXPECT_LT(error, 0.1 * noise);
}

TEST(SignificantDifference, IsAllOfItWhereTheSolvedPictureIsBlack) {
  Pictures pictures(0.0f, 0.0f);
  pictures.all.solved.assign(pictures.truth.size(), glm::vec3(0.0f));
  EXPECT_LT(pictures.error(significant_difference(pictures.all, {})), 1e-6);
}

TEST(SignificantDifference, IsFiniteWhateverTheSolvedPictureLacks) {
  for (const float solved : {1e-42f, 1e-20f, 1e25f}) {
    Pictures pictures(0.5f, 0.0f);
    pictures.all.solved.assign(pictures.truth.size(), glm::vec3(solved));
    pictures.all.traced[0][40] = pictures.all.traced[1][40] = glm::vec3(1e28f);
    pictures.all.traced[1][50] = glm::vec3(1e28f);
    for (const glm::vec3& difference : significant_difference(pictures.all, {})) {
      EXPECT_FALSE(std::isnan(difference.x + difference.y + difference.z)) << solved;
    }
  }
}

TEST(DenoisedFrames, HaveAThirdOfTheNoise) {
  Scene scene = on_film(cloud_scene(20, 0.5), {32, 24});
  scene.surfaces = {wall(-3.0, 3.0)};
  SceneRenderer renderer;
  RenderRequest request;
  request.backend = Backend::cpu;
  request.airlight = AirlightMethod::path;
  request.samples = 1;
  request.paths = 512;
  const Frame truth = *renderer.render(scene, request);
  request.paths = 16;
  request.seed = 1;
  const Frame noisy = *renderer.render(scene, request);
  request.denoise = Denoising::solved;
  const Frame denoised = *renderer.render(scene, request);
  EXPECT_LT(brume::rel_rmse(denoised.beauty, truth.beauty),
            brume::rel_rmse(noisy.beauty, truth.beauty) / 3.0);
  EXPECT_LT(brume::rel_rmse(denoised.airlight, truth.airlight),
            brume::rel_rmse(noisy.airlight, truth.airlight) / 3.0);
  EXPECT_FALSE(denoised.statistics.path_noise);
  EXPECT_EQ(denoised.statistics.airlight, "path:16+denoised");
  EXPECT_EQ(SceneRenderer().render(scene, request)->beauty, denoised.beauty);
  std::stop_source stop;
  stop.request_stop();
  EXPECT_FALSE(renderer.render(scene, request, stop.get_token()));
}

TEST(DenoisedFrames, FollowTheDoublingPathsOfAView) {
  Scene scene = on_film(cloud_scene(20, 0.5), {32, 24});
  scene.surfaces = {wall(-3.0, 3.0)};
  const Frame truth = render_frame(scene, path_traced(512));
  Renderer renderer;
  const Frame solved = render_frame(renderer, scene, solved_settings(24));
  DenoisedView view(solved);
  Frame noisy, denoised;
  for (int paths = 1; paths <= 16; paths *= 2) {
    Settings settings = path_traced(paths);
    settings.path_seed = 1;
    denoised = noisy = render_frame(renderer, scene, settings);
    view.denoise(denoised, {});
    if (paths == 1) {
      EXPECT_LT(brume::rel_rmse(denoised.beauty, solved.beauty), 1e-5);  // rounding
    }
  }
  EXPECT_LT(brume::rel_rmse(denoised.airlight, truth.airlight),
            brume::rel_rmse(noisy.airlight, truth.airlight) / 3.0);
}

TEST(DenoisedFrames, KeepFilteredEdges) {
  // Two paths a pixel see the centers alone; edges stay those of the solved picture.
  Scene scene = on_film(cloud_scene(20, 0.5), {32, 24});
  scene.surfaces = {wall(-3.0, 0.7)};
  SceneRenderer renderer;
  RenderRequest request;
  request.backend = Backend::cpu;
  request.samples = 16;
  request.airlight = AirlightMethod::sliced;
  const Frame solved = *renderer.render(scene, request);
  request.airlight = AirlightMethod::path;
  request.denoise = Denoising::solved;
  request.paths = 2;
  const Frame denoised = *renderer.render(scene, request);
  ASSERT_FALSE(denoised.beauty_at_centers.empty());
  for (std::size_t i = 3; i < solved.beauty.size(); i += 4) {
    EXPECT_EQ(denoised.beauty[i], solved.beauty[i]);
  }
  EXPECT_LT(brume::rel_rmse(denoised.beauty, solved.beauty), 0.2);
}

}  // namespace
}  // namespace brume
