// Errors measured for at most so much counted work, and the sampled part of the reference.

#include <gtest/gtest.h>
#include <tbb/task_arena.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <optional>
#include <vector>

#include "brume/render.h"
#include "render/paths/path_random.h"
#include "render/quality/auto_quality.h"
#include "render/quality/view_reference.h"
#include "render/quality/work.h"
#include "render/renderer.h"
#include "tests/render/test_scenes.h"

namespace brume {
namespace {

Scene thick_cloud(int side = 60) {
  Scene scene = on_film(cloud_scene(100, 3.0), {side, side});
  return scene;
}

Settings solved_settings(int slices = 8) {
  Settings settings = sliced_settings({}, slices);
  settings.scattering = Scattering::multiple;
  return settings;
}

struct MeasuredWithin {
  ErrorEstimate error;
  double work;
};
MeasuredWithin measured_within(const Scene& scene, const Frame& frame, double max_work,
                               std::optional<double> bound) {
  FrameErrors errors(scene, scene.camera, evaluation_seed);
  const ErrorEstimate error = errors.measure_within(max_work, frame, bound)->airlight;
  return {error, errors.work()};
}

TEST(QuickError, PathsCountWhatTheyDraw) {
  PathRandom random(1, 2, 3, 4);
  const PathRandom start = random;
  EXPECT_EQ(random.drawn_since(start), 0u);
  for (int k = 0; k < 1000; ++k) static_cast<void>(random.uniform());
  EXPECT_EQ(random.drawn_since(start), 1000u);
}

TEST(QuickError, SpendsWhatItMayAndNoMore) {
  const Scene scene = thick_cloud();
  const Frame frame = render_frame(scene, solved_settings());
  // Nothing decides whether an error is above 0.
  double last_high = 1e9;
  for (const double max_work : {3e7, 1e8, 4e8}) {
    const auto [error, work] = measured_within(scene, frame, max_work, 1e-9);
    EXPECT_GT(work, 0.7 * max_work);
    EXPECT_LT(work, 1.1 * max_work) << "what is added costs about what was before";
    EXPECT_LT(error.high, last_high);
    last_high = error.high;
  }
}

TEST(QuickError, EndsWhereTheBoundIsDecided) {
  const Scene scene = thick_cloud();
  const Frame frame = render_frame(scene, solved_settings());
  const double max_work = 1e9;
  EXPECT_LT(measured_within(scene, frame, max_work, 1e3).work, 0.05 * max_work);
  EXPECT_GT(measured_within(scene, frame, max_work, 1e-9).work, 0.7 * max_work);
}

TEST(QuickError, IsTheSameForAnyNumberOfThreads) {
  const Scene scene = thick_cloud();
  const Frame frame = render_frame(scene, solved_settings());
  const ErrorEstimate many = measured_within(scene, frame, 1e8, 0.001).error;
  ErrorEstimate one;
  tbb::task_arena(1).execute([&] { one = measured_within(scene, frame, 1e8, 0.001).error; });
  EXPECT_EQ(one.rel_rmse, many.rel_rmse);
  EXPECT_EQ(one.high, many.high);
  EXPECT_EQ(one.pixels, many.pixels);
  EXPECT_EQ(one.block_median, many.block_median);
}

// The cost of a picture does not depend on what its renderer has kept: nor does its error.
TEST(QuickError, DoesNotDependOnFramesBefore) {
  const Scene scene = thick_cloud(48);
  const RenderRequest request{.backend = Backend::cpu};
  SceneRenderer renderer;
  const Frame first = *renderer.render(scene, request);
  const Frame second = *renderer.render(scene, request);
  ASSERT_TRUE(first.error && second.error);
  EXPECT_EQ(first.error->rel_rmse, second.error->rel_rmse);
  EXPECT_EQ(first.error->high, second.error->high);
  EXPECT_EQ(first.error->pixels, second.error->pixels);
  EXPECT_EQ(first.beauty, second.beauty);
}

TEST(QuickError, PicturesAreTheSameWithAndWithoutIt) {
  const Scene scene = thick_cloud(48);
  RenderRequest request{.error = ErrorMeasurement::none, .backend = Backend::cpu};
  const Frame unmeasured = *render(scene, request);
  EXPECT_FALSE(unmeasured.error);
  request.error = ErrorMeasurement::quick;
  const Frame quick = *render(scene, request);
  ASSERT_TRUE(quick.error);
  EXPECT_EQ(quick.beauty, unmeasured.beauty);
  request.error.reset();
  EXPECT_EQ(render(scene, request)->error->high, quick.error->high) << "it is the default";
}

TEST(QuickError, LargerPicturesCostMore) {
  const Settings settings = solved_settings();
  const double small = picture_work(render_frame(thick_cloud(20), settings), settings);
  const double large = picture_work(render_frame(thick_cloud(200), settings), settings);
  EXPECT_GT(small, 0.0);
  EXPECT_GT(large, small + 150.0 * (200.0 * 200.0 - 20.0 * 20.0) - 1.0);
  EXPECT_GT(integral_work(100, 3, false), integral_work(100, 1, false));
  EXPECT_GT(integral_work(100, 3, true), integral_work(100, 3, false));
  EXPECT_GT(path_work(100, 200), path_work(100, 20));
}

// The median of blocks against that over all blocks: of a dark part beside a bright one, of which
// only the dark one is wrong.
TEST(BlockErrors, ADarkPartCountsAsMuchAsABrightOne) {
  Scene scene = thick_cloud();
  Settings reference;
  reference.airlight = AirlightMethod::reference;
  const Frame truth = render_frame(scene, reference);
  for (const double share : {0.3, 0.7}) {  // of the picture, from the top, that is off by a fifth
    Frame frame = truth;
    const auto rows = static_cast<std::size_t>(share * scene.film.height);
    for (std::size_t i = 0; i < 3 * rows * 60; ++i) frame.airlight[i] *= 1.2f;
    FrameErrors errors(scene, scene.camera, evaluation_seed);
    const ErrorEstimate error = errors.measure(frame, std::nullopt)->airlight;
    const double median = share < 0.5 ? 0.0 : 0.2;
    EXPECT_LE(error.block_low, median + 1e-3);
    EXPECT_GE(error.block_high, median - 1e-3);
    EXPECT_NEAR(error.block_median, median, 0.25 * median + 1e-3) << share;
  }
}

TEST(BlockErrors, ABlackPictureHasNone) {
  Scene scene = thick_cloud();
  scene.lights.clear();
  const Frame frame = render_frame(scene, sliced_settings({}, 8));
  const ErrorEstimate error = measure_error(scene, scene.camera, frame)->airlight;
  EXPECT_EQ(error.block_median, 0.0);
  EXPECT_EQ(error.block_high, 0.0);
}

// Points of area lights are drawn for the reference: their mean is the sum over all of them.
TEST(SampledReference, AreaLightsAreWhatTheirPointsAre) {
  Scene scene = thick_cloud(12);
  scene.lights = {{.position = {1.5, 2.0, 1.5}, .intensity = glm::dvec3(5.0)},
                  {.position = {-1.5, 1.0, 2.0}, .intensity = glm::dvec3(12.0)}};
  scene.lights[1].kind =
      light::Rectangle{.direction = {1.0, -0.5, -1.0}, .width = 1.0, .height = 0.7};
  std::vector<std::size_t> pixels{40, 65, 66, 78, 90, 101};
  const std::vector<glm::dvec3> summed =
      ReferencePixels(scene, scene.camera, scene.film, 1e-4).airlight(pixels, {});
  ViewReference sampled(scene, scene.camera, scene.film, 1e-4);
  EXPECT_TRUE(sampled.is_noisy());
  ASSERT_TRUE(sampled.evaluate(pixels, [](std::size_t) { return 4096; }, {}));
  for (std::size_t k = 0; k < pixels.size(); ++k) {
    const PixelRadiance& pixel = sampled.airlight(pixels[k]);
    EXPECT_GT(pixel.variance, 0.0);
    const double off = glm::length(pixel.radiance - summed[k]);
    EXPECT_LT(off, 4.0 * std::sqrt(pixel.variance) + 2e-3 * glm::length(summed[k])) << pixels[k];
    EXPECT_LT(std::sqrt(pixel.variance), 0.02 * glm::length(summed[k]));
  }
  scene.lights.pop_back();
  EXPECT_FALSE(ViewReference(scene, scene.camera, scene.film, 1e-4).is_noisy());
}

}  // namespace
}  // namespace brume
