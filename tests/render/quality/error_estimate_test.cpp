#include "render/quality/error_estimate.h"
#include "core/scene/camera_rays.h"

#include <gtest/gtest.h>

#include "render/quality/auto_quality.h"
#include "render/quality/sample_probabilities.h"
#include "render/quality/view_reference.h"
#include "render/renderer.h"
#include "tests/render/test_scenes.h"

namespace brume {
namespace {

Settings method(AirlightMethod airlight, int slices = 16) {
  Settings settings;
  settings.airlight = airlight;
  settings.slices = slices;
  return settings;
}

std::vector<Scene> scenes() {
  std::vector<Scene> all;
  all.push_back(cloud_scene(30, 1.0));
  all.push_back(cloud_scene(300, 3.0));
  all.push_back(cloud_scene(100, 1.0));
  all.back().lights[0].position = {0.4, 0.3, 0.2};  // inside
  all.push_back(cloud_scene(50, 0.5));
  all.back().medium.set_homogeneous_density(0.05);
  all.push_back(cloud_scene(50, 2.0));
  all.back().surfaces.push_back(wall(0.0, 0.6));
  return all;
}

// The interval holds the error of the whole frame in at least 95% of cases.
TEST(ErrorEstimate, IntervalHoldsTheTruth) {
  int held = 0;
  int cases = 0;
  int narrow = 0;
  for (Scene& scene : scenes()) {
    scene.film = {40, 40};
    const Frame reference = render_frame(scene, method(AirlightMethod::reference));
    const auto view_reference =
        std::make_shared<ViewReference>(scene, scene.camera, scene.film, 1e-4);
    for (const Settings& settings :
         {method(AirlightMethod::paper), method(AirlightMethod::sliced, 8),
          method(AirlightMethod::sliced, 16)}) {
      const Frame frame = render_frame(scene, settings);
      const double error = rel_rmse(frame.airlight, reference.airlight);
      for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        const auto sample =
            ErrorSample::create(view_reference, scene, scene.camera, frame, 150, seed);
        const ErrorEstimate estimate = sample->measure(frame);
        // So many by chance, and a quarter more around errors.
        EXPECT_NEAR(estimate.pixels, 170.0, 50.0);
        held += estimate.low <= error && error <= estimate.high ? 1 : 0;
        ++cases;
        narrow += estimate.high < 3.0 * estimate.low ? 1 : 0;
      }
    }
  }
  EXPECT_GE(held, 0.95 * cases) << held << " of " << cases;
  // And it says something.
  EXPECT_GE(narrow, 0.9 * cases) << narrow << " of " << cases;
}

TEST(ErrorEstimate, ReferenceHasNoError) {
  Scene scene = on_film(cloud_scene(30, 1.0), {20, 20});
  const Frame reference = render_frame(scene, method(AirlightMethod::reference));
  const auto sample = ErrorSample::create(scene, scene.camera, reference, 60, 1, 1e-4);
  EXPECT_LT(sample->measure(reference).high, 1e-6);
}

// The reference of a view, and a frame with errors where lose() sets them.
class WrongFrame {
 public:
  explicit WrongFrame(const Scene& scene)
      : scene_(on_film(scene)),
        frame(render_frame(scene_, method(AirlightMethod::reference))),
        reference_(std::make_shared<ViewReference>(scene_, scene_.camera, scene_.film, 1e-4)) {}

  [[nodiscard]] std::size_t pixel(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(scene_.film.width) +
           static_cast<std::size_t>(x);
  }
  void lose(std::size_t pixel) {
    for (std::size_t k = 0; k < 3; ++k) frame.airlight[3 * pixel + k] = 0.0f;
  }
  [[nodiscard]] ErrorSample sample(std::size_t count, std::uint64_t seed) const {
    return *ErrorSample::create(reference_, scene_, scene_.camera, frame, count, seed);
  }
  [[nodiscard]] std::vector<double> probabilities(std::size_t count) const {
    return sample_probabilities(scene_, scene_.camera, frame, count, Measured::airlight);
  }

 private:
  static Scene on_film(Scene scene) {
    scene.film = {40, 40};
    return scene;
  }

  Scene scene_;

 public:
  Frame frame;

 private:
  std::shared_ptr<ViewReference> reference_;
};

// A cloud with a small thing in the middle of one pixel of 40 x 40, which holds nearly all light.
constexpr int small_x = 22;
constexpr int small_y = 13;

Scene thin_cloud(glm::dvec3& cloud_center) {
  Scene scene = on_film(cloud_scene(30, 0.01), {40, 40});
  const CameraRays rays(scene.camera, scene.film);
  cloud_center = rays.eye() + 3.0 * rays.direction(small_x + 0.52, small_y + 0.48);
  return scene;
}

Light light_at(const glm::dvec3& position, double intensity) {
  Light light;
  light.position = position;
  light.intensity = glm::dvec3(intensity);
  return light;
}

Scene light_in_view() {
  glm::dvec3 cloud_center;
  Scene scene = in_fog(thin_cloud(cloud_center), 0.01);
  scene.lights.push_back(light_at(cloud_center, 10.0));
  return scene;
}

Scene small_opaque_gaussian() {
  glm::dvec3 cloud_center;
  Scene scene = thin_cloud(cloud_center);
  scene.medium.append({cloud_center, 0.005, 2000.0});
  return scene;
}

TEST(ErrorEstimate, FindsALightThatAFrameMissed) {
  WrongFrame wrong(light_in_view());
  Scene dark = light_in_view();
  dark.lights.pop_back();
  wrong.frame = WrongFrame(dark).frame;
  const std::vector<double> probabilities = wrong.probabilities(60);
  for (int y = small_y - 1; y <= small_y + 1; ++y) {
    for (int x = small_x - 1; x <= small_x + 1; ++x) {
      EXPECT_EQ(probabilities[wrong.pixel(x, y)], 1.0) << x << ' ' << y;
    }
  }
  EXPECT_GT(wrong.sample(60, 1).measure(wrong.frame).low, 0.3);
}

// Whatever the draw: one lost pixel of 1600, of which 60 are measured.
TEST(ErrorEstimate, FindsASmallGaussianThatAFrameMissed) {
  WrongFrame wrong(small_opaque_gaussian());
  wrong.lose(wrong.pixel(small_x, small_y));
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const ErrorEstimate error = wrong.sample(60, seed).measure(wrong.frame);
    EXPECT_GT(error.low, 0.3) << seed;
  }
}

// Neighbours of a pixel with a large error are sampled too.
TEST(ErrorEstimate, SamplesAroundErrors) {
  WrongFrame wrong(light_in_view());
  for (int y = small_y - 1; y <= small_y + 1; ++y) {
    for (int x = small_x - 2; x <= small_x + 2; ++x) wrong.lose(wrong.pixel(x, y));
  }
  const Frame reference = WrongFrame(light_in_view()).frame;
  const double error = rel_rmse(wrong.frame.airlight, reference.airlight);
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    EXPECT_NEAR(wrong.sample(60, seed).measure(wrong.frame).rel_rmse, error, 0.01 * error) << seed;
  }
}

TEST(ErrorEstimate, ChancesAddUpToTheSample) {
  const WrongFrame even(cloud_scene(30, 1.0));
  const WrongFrame peaked(light_in_view());
  for (const WrongFrame* frame : {&even, &peaked}) {
    for (const std::size_t count : {40u, 200u, 1000u}) {
      double sum = 0.0;
      for (const double probability : frame->probabilities(count)) {
        EXPECT_GT(probability, 0.0);
        EXPECT_LE(probability, 1.0);
        sum += probability;
      }
      EXPECT_NEAR(sum, count, 0.01 * static_cast<double>(count));
    }
  }
}

// There are as many lights as pixels: they do not take all of the sample, whatever light is the
// brightest.
TEST(ErrorEstimate, ManyLightsLeavePixelsForTheRest) {
  Scene scene = light_in_view();
  const CameraRays rays(scene.camera, scene.film);
  for (int y = 0; y < 40; ++y) {
    for (int x = 0; x < 40; ++x) {
      scene.lights.push_back(light_at(rays.eye() + 3.0 * rays.direction(x + 0.5, y + 0.5), 1.0));
    }
  }
  Frame guide;
  guide.film = scene.film;
  guide.airlight.assign(3 * 1600, 1.0f);
  guide.depth.assign(1600, 1.0f);
  const std::vector<double> probabilities =
      sample_probabilities(scene, scene.camera, guide, 80, Measured::airlight);
  EXPECT_EQ(std::ranges::count(probabilities, 1.0), 20);
  EXPECT_EQ(probabilities[small_y * 40 + small_x], 1.0);
}

TEST(ErrorEstimate, GrowingKeepsPixelsAndNarrowsTheInterval) {
  Scene scene = on_film(cloud_scene(100, 3.0), {40, 40});
  const Frame frame = render_frame(scene, method(AirlightMethod::paper));
  auto sample = ErrorSample::create(scene, scene.camera, frame, 60, 1, 1e-3);
  const ErrorEstimate small = sample->measure(frame);
  ASSERT_TRUE(sample->grow({}));
  ASSERT_TRUE(sample->grow({}));
  const ErrorEstimate large = sample->measure(frame);
  EXPECT_GT(large.pixels, 2 * small.pixels);  // not all may become more
  EXPECT_LT(large.high / large.low, 0.8 * small.high / small.low);
  // Until all are there.
  for (int k = 0; k < 8; ++k) ASSERT_TRUE(sample->grow({}));
  EXPECT_EQ(sample->measure(frame).pixels, 1600u);
}

// Light of all orders is measured against paths, of which there may be more; that of one is exact.
TEST(ErrorEstimate, PathsNarrowTheInterval) {
  Scene scene = on_film(cloud_scene(30, 3.0), {24, 24});
  Settings settings = method(AirlightMethod::sliced);
  const Frame once = render_frame(scene, settings);
  auto exact = ErrorSample::create(scene, scene.camera, once, 40, 1, 1e-3);
  EXPECT_EQ(exact->measure(once).noise, 0.0);
  EXPECT_FALSE(exact->refine({}));

  settings.scattering = Scattering::multiple;
  const Frame frame = render_frame(scene, settings);
  auto sample = ErrorSample::create(scene, scene.camera, frame, 40, 1, 1e-3);
  const ErrorEstimate few = sample->measure(frame);
  EXPECT_GT(few.noise, 0.0);
  int doublings = 0;
  while (sample->refine({})) ++doublings;
  EXPECT_EQ(doublings, 7);  // from 64 paths to 8192
  const ErrorEstimate many = sample->measure(frame);
  EXPECT_EQ(many.pixels, few.pixels);
  EXPECT_LT(many.high - many.low, 0.7 * (few.high - few.low));
}

// A pixel whose error dominates the sum says little about unsampled ones: the interval is wide.
TEST(ErrorEstimate, ADominantPixelWidensTheInterval) {
  WrongFrame even(cloud_scene(30, 1.0));
  for (float& x : even.frame.airlight) x *= 1.01f;
  WrongFrame ruled(light_in_view());
  ruled.lose(ruled.pixel(small_x, small_y));
  const auto width = [](const ErrorEstimate& error) { return error.high / error.rel_rmse; };
  EXPECT_LT(width(even.sample(60, 1).measure(even.frame)), 1.02);
  EXPECT_GT(width(ruled.sample(60, 1).measure(ruled.frame)), 1.05);
}

TEST(ErrorEstimate, LightWhereAllIsBlackIsWrong) {
  Scene scene = cloud_scene(30, 1.0);
  scene.lights.clear();
  WrongFrame wrong(scene);
  EXPECT_EQ(wrong.sample(60, 1).measure(wrong.frame).high, 0.0);
  for (float& x : wrong.frame.airlight) x = 1.0f;
  EXPECT_EQ(wrong.sample(60, 1).measure(wrong.frame).low, 1.0);
}

// The sample grows only while that may decide about the bound.
TEST(FrameErrors, GrowOnlyWhileTheBoundIsInTheInterval) {
  Scene scene = on_film(cloud_scene(100, 3.0), {60, 60});
  const Frame frame = render_frame(scene, method(AirlightMethod::sliced, 8));
  const auto measured = [&](std::optional<double> bound) {
    return FrameErrors(scene, scene.camera, 1).measure(frame, bound)->airlight;
  };
  const ErrorEstimate free = measured(std::nullopt);
  EXPECT_EQ(measured(1.1 * free.high).pixels, free.pixels);
  EXPECT_EQ(measured(0.9 * free.low).pixels, free.pixels);
  const ErrorEstimate close = measured(free.rel_rmse);
  EXPECT_GT(close.pixels, 1.5 * static_cast<double>(free.pixels));
  EXPECT_LT(close.high / close.low, free.high / free.low);
}

TEST(AutoQuality, MeetsTheRequestedError) {
  for (Scene& scene : scenes()) {
    scene.film = {60, 60};
    const Frame reference = render_frame(scene, method(AirlightMethod::reference));
    Renderer renderer;
    for (const double asked : {0.05, 0.01}) {
      const RequestedFrame made =
          *render_requested(renderer, scene, scene.camera, scene.film, {.max_error = asked});
      EXPECT_EQ(made.settings.airlight, AirlightMethod::sliced);
      EXPECT_LE(made.error->airlight.high, asked);
      EXPECT_LT(rel_rmse(made.frame.airlight, reference.airlight), asked);
    }
  }
}

TEST(AutoQuality, LeavesGivenSettingsAlone) {
  const Scene scene = cloud_scene(30, 1.0);
  Renderer renderer;
  const RequestedFrame made =
      *render_requested(renderer, scene, scene.camera, scene.film, paper_settings);
  EXPECT_EQ(made.frame.beauty, render_frame(scene, paper_settings).beauty);
  EXPECT_EQ(made.settings, paper_settings);
  EXPECT_FALSE(made.error);
}

TEST(AutoQuality, RenderersRenderItAsSliced) {
  const Scene scene = cloud_scene(30, 1.0);
  EXPECT_EQ(Settings{}.airlight, AirlightMethod::auto_);
  EXPECT_EQ(render_frame(scene, {}).beauty,
            render_frame(scene, sliced_settings({}, Settings{}.slices)).beauty);
}

TEST(AutoQuality, CostsLessForALooserBound) {
  const Scene scene = cloud_scene(300, 3.0);
  Renderer renderer;
  const auto loose = choose_settings(renderer, scene, scene.camera, scene.film, {.max_error = 0.1});
  const auto tight =
      choose_settings(renderer, scene, scene.camera, scene.film, {.max_error = 0.003});
  EXPECT_LT(loose->slices, tight->slices);
}

}  // namespace
}  // namespace brume
