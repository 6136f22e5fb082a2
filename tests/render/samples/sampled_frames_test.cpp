// Frames of several samples a pixel against the mean of many whole frames, and what they cost.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stop_token>

#include "brume/at_time.h"
#include "render/gl_renderer.h"
#include "render/paths/path_random.h"
#include "render/render_plan.h"
#include "render/renderer.h"
#include "render/samples/exposure.h"
#include "render/samples/mean_frame.h"
#include "tests/render/test_scenes.h"

namespace brume {
namespace {

Surface ball(const glm::dvec3& center, double radius, const glm::dvec3& reflectance) {
  Surface surface;
  surface.mesh = ball_mesh(24);
  surface.translate = center;
  surface.scale = radius;
  surface.material.reflectance = reflectance;
  return surface;
}

// Balls near and far, one behind the other, and a small glossy one with a highlight, in a cloud and
// fog.
Scene balls_in_fog() {
  Scene scene = on_film(in_fog(cloud_scene(20, 0.5), 0.05), {96, 72});
  scene.surfaces = {ball({-0.5, 0.1, 1.5}, 0.3, {0.8, 0.2, 0.1}),
                    ball({0.4, -0.2, -2.0}, 0.9, {0.1, 0.3, 0.8}),
                    ball({0.5, 0.35, 1.0}, 0.15, glm::dvec3(0.02)), wall(-6.0, 3.0)};
  Material& glossy = scene.surfaces[2].material;
  glossy.type = Material::Type::phong;
  glossy.specular = glm::dvec3(0.8);
  glossy.exponent = 200.0;
  return scene;
}

Settings with_samples(Settings settings, int samples) {
  settings.samples = samples;
  return settings;
}

// The plain method: whole frames of shifted films.
Frame whole_frames(const Scene& scene, const Settings& settings) {
  Renderer renderer;
  const auto render = [&](const Film& film, const Settings& single, const Job&) {
    return renderer.render(scene, scene.camera, film, single);
  };
  return *render_shifted(scene.film, settings, {}, render);
}

double rms_difference(const Frame& a, const Frame& b) {
  return rel_rmse(a.beauty, b.beauty);
}

double max_difference(const std::vector<float>& a, const std::vector<float>& b) {
  double most = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    most = std::max(most, std::abs(static_cast<double>(a[i]) - static_cast<double>(b[i])));
  }
  return most;
}

class SampledFrames : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    scene_ = new Scene(balls_in_fog());
    many_ = new Frame(whole_frames(*scene_, with_samples(sliced(24), 64)));
    one_ = new Frame(render_frame(*scene_, sliced(24)));
    chosen_ = new Frame(render_frame(*scene_, with_samples(sliced(24), edge_samples)));
  }
  static void TearDownTestSuite() {
    delete scene_;
    delete many_;
    delete one_;
    delete chosen_;
  }
  inline static Scene* scene_ = nullptr;
  inline static Frame *many_ = nullptr, *one_ = nullptr, *chosen_ = nullptr;
};

TEST_F(SampledFrames, AreTheMeanOfManyFrames) {
  EXPECT_EQ(chosen_samples(*scene_), edge_samples);
  EXPECT_GT(rms_difference(*one_, *many_), 0.02);
  EXPECT_LT(rms_difference(*chosen_, *many_), 0.01);
  const Frame more = render_frame(*scene_, with_samples(sliced(24), 64));
  EXPECT_LT(rms_difference(more, *many_), 0.005);
}

TEST_F(SampledFrames, HaveFilteredLayers) {
  const auto is_close = [](const std::vector<float>& a, const std::vector<float>& b) {
    double square = 0.0, sum = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
      square += std::pow(static_cast<double>(a[i]) - static_cast<double>(b[i]), 2);
      sum += std::pow(static_cast<double>(b[i]), 2);
    }
    return std::sqrt(square / sum);
  };
  EXPECT_LT(is_close(chosen_->airlight, many_->airlight), 0.01);
  EXPECT_LT(is_close(chosen_->transmittance, many_->transmittance), 0.01);
  EXPECT_LT(max_difference(chosen_->beauty, many_->beauty),
            0.2 * *std::ranges::max_element(many_->beauty));
  expect_finite(*chosen_);
  for (std::size_t i = 0; i < chosen_->depth.size(); ++i) {
    EXPECT_NEAR(chosen_->beauty[4 * i + 3], many_->beauty[4 * i + 3], 0.15);
  }
}

TEST_F(SampledFrames, KeepWhatCentersSee) {
  EXPECT_EQ(chosen_->depth, one_->depth);
  EXPECT_EQ(many_->depth, one_->depth);
  EXPECT_EQ(many_->airlight_at_centers, one_->airlight);
  EXPECT_TRUE(one_->airlight_at_centers.empty());
  EXPECT_EQ(&one_->center_airlight(), &one_->airlight);
  EXPECT_EQ(chosen_->airlight_at_centers, one_->airlight);
}

// Sixteen samples of edges, but few more rays through the fog.
TEST_F(SampledFrames, DoNotPayForFogAgain) {
  const std::size_t pixels = one_->depth.size();
  EXPECT_GT(chosen_->statistics.sampled_pixels, pixels / 20);
  EXPECT_LT(chosen_->statistics.sampled_pixels, pixels / 2);
  EXPECT_LT(chosen_->statistics.view_pairs, 1.3 * static_cast<double>(one_->statistics.view_pairs));
  EXPECT_GT(many_->statistics.view_pairs, 60.0 * static_cast<double>(one_->statistics.view_pairs));
}

// Light in front of an edge is between that in front of its two sides: no bright or dark rim.
TEST_F(SampledFrames, HaveNoHalos) {
  const int width = one_->film.width;
  for (int y = 1; y + 1 < one_->film.height; ++y) {
    for (int x = 1; x + 1 < width; ++x) {
      const auto at = [&](int column, int row) {
        return 3 * static_cast<std::size_t>(row * width + column);
      };
      float low = 1e30f, high = 0.0f;
      for (int row = y - 1; row <= y + 1; ++row) {
        for (int column = x - 1; column <= x + 1; ++column) {
          low = std::min(low, one_->airlight[at(column, row)]);
          high = std::max(high, one_->airlight[at(column, row)]);
        }
      }
      const float room = 0.02f * high;
      EXPECT_GE(chosen_->airlight[at(x, y)], low - room) << x << ' ' << y;
      EXPECT_LE(chosen_->airlight[at(x, y)], high + room) << x << ' ' << y;
    }
  }
}

TEST_F(SampledFrames, WorkAtACoarserAirlight) {
  Settings settings = with_samples(sliced(24), edge_samples);
  settings.airlight_scale = 4;
  EXPECT_LT(rms_difference(render_frame(*scene_, settings), *many_), 0.013);
}

TEST_F(SampledFrames, HaveOneStageMore) {
  const auto has = [](const Frame& frame) {
    return std::ranges::any_of(frame.statistics.stages, [](const StageTime& stage) {
      return stage.stage == Stage::samples;
    });
  };
  EXPECT_TRUE(has(*chosen_));
  EXPECT_FALSE(has(*one_));
  const auto runs = [&](Settings settings) {
    return RenderPlan(*scene_, scene_->film, settings).runs(Stage::samples);
  };
  EXPECT_TRUE(runs(with_samples(sliced(8), 2)));
  EXPECT_FALSE(runs(with_samples(sliced(8), 1)));
  EXPECT_FALSE(runs(with_samples(path_traced(8), 16))) << "whole frames";
}

// A light so near a wall that its spot is smaller than a pixel: without more samples there than
// elsewhere the frame is off by 29%.
TEST(SampledFramesOfHotSpots, TakeMoreSamplesThere) {
  Scene scene;
  scene.film = {24, 18};
  scene.camera.eye = {0.0, 0.0, 4.0};
  scene.surfaces = {wall(-1.0, 3.0), ball({0.8, 0.4, 0.0}, 0.4, glm::dvec3(0.5))};
  scene.lights = {{{0.05, 0.03, -0.98}, glm::dvec3(1.0), {}}};
  const Frame many = whole_frames(scene, with_samples(sliced(8), 1024));
  const Frame chosen = render_frame(scene, with_samples(sliced(8), edge_samples));
  EXPECT_LT(rms_difference(chosen, many), 0.01);
  EXPECT_LT(chosen.statistics.sampled_pixels, chosen.depth.size());
}

// Alpha is coverage, also where the channels' albedos differ and are rendered apart.
TEST(SampledAlbedos, HaveTheSameAlpha) {
  Scene scene = balls_in_fog();
  scene.surfaces.pop_back();
  scene.film = {48, 36};
  scene.optics.albedo = {0.9, 0.8, 0.7};
  const Frame few = render_frame(scene, with_samples(sliced(8), 16));
  const Frame many = whole_frames(scene, with_samples(sliced(8), 64));
  EXPECT_LT(rms_difference(few, many), 0.02);
  for (std::size_t i = 0; i < few.depth.size(); ++i) {
    EXPECT_NEAR(few.beauty[4 * i + 3], many.beauty[4 * i + 3], 0.15) << i;
  }
}

TEST(SampledFog, IsLeftAsItIs) {
  Scene scene = cloud_scene(20, 1.0);
  EXPECT_EQ(chosen_samples(scene), 1);
  scene.surfaces = {wall(0.0, 1.0)};
  EXPECT_EQ(chosen_samples(scene), edge_samples);
  scene.surfaces[0].visible = false;
  EXPECT_EQ(chosen_samples(scene), 1);
}

// Noise does not tell: of so few paths it is off by a factor of three itself.
TEST(SampledPaths, ShareWholeBlocks) {
  int sum = 0;
  for (int k = 0; k < 8; ++k) {
    const Settings share = share_of_paths(path_traced(134), k, 8);
    EXPECT_GE(share.paths, 2 * path_block);
    if (k < 7) {
      EXPECT_EQ(share.paths % path_block, 0);
    }
    sum += share.paths;
  }
  EXPECT_EQ(sum, 134);
}

TEST(SampledPaths, ShareThePathsOfAPixel) {
  Scene scene = in_fog(balls_in_fog(), 0.0);
  scene.surfaces.pop_back();
  scene.film = {24, 18};
  const Frame frame = render_frame(scene, with_samples(path_traced(134), 8));
  ASSERT_TRUE(frame.statistics.path_noise);
  EXPECT_EQ(frame.statistics.path_noise->paths, 134);
  const Frame plain = render_frame(scene, path_traced(134));
  const auto partly_covered = [](const Frame& f) {
    int pixels = 0;
    for (std::size_t i = 0; i < f.depth.size(); ++i) {
      const float open = 1.0f - f.transmittance[3 * i];
      pixels += f.beauty[4 * i + 3] > open + 0.1f && f.beauty[4 * i + 3] < 0.95f;
    }
    return pixels;
  };
  EXPECT_EQ(partly_covered(plain), 0);
  EXPECT_GT(partly_covered(frame), 10);
}

TEST(SampledFramesOfStoppedJobs, AreNone) {
  const Scene scene = balls_in_fog();
  for (const Settings& settings : {with_samples(sliced(8), 16), with_samples(path_traced(8), 4)}) {
    std::stop_source stop;
    const auto watch = [&](double done) {
      if (done > 0.6) stop.request_stop();
    };
    EXPECT_FALSE(
        Renderer().render(scene, scene.camera, scene.film, settings, stop.get_token(), watch));
  }
}

TEST(Exposures, OfOneSampleAreThoseOfTheCenter) {
  Scene scene = on_film(balls_in_fog(), {24, 18});
  scene.camera.aperture = 0.2;
  scene.camera_keys.eye = {{0.0, {0, 0, 4}}, {1.0, {1, 0, 4}}};
  Exposure exposure = exposure_of(scene);
  exposure.shutter = Shutter{};
  exposure.samples = 1;
  Renderer renderer;
  const auto scene_at = [&](double time) { return evaluate_at(scene, time); };
  const auto frame =
      render_exposure(renderer, {scene_at, 0.5, {}, scene.film, exposure}, sliced(8));
  Scene then = evaluate_at(scene, 0.5);
  EXPECT_EQ(frame->beauty, render_frame(then, sliced(8)).beauty);
}

// A ball out of focus is as bright in all, but on more pixels.
TEST(Exposures, BlurWhatIsOutOfFocus) {
  Scene scene = seen_by({{0, 0, 4}, {0, 0, 0}, {0, 1, 0}, 40.0}, {64, 48});
  scene.lights = {{.position = {0, 3, 6}, .intensity = glm::dvec3(60.0)}};
  scene.surfaces = {ball({0, 0, 0}, 0.5, glm::dvec3(0.8))};
  Renderer renderer;
  const auto covered = [&](double focus) {
    scene.camera.aperture = 0.3;
    scene.camera.focus_distance = focus;
    Exposure exposure = exposure_of(scene);
    exposure.samples = 32;
    const auto scene_at = [&](double) { return scene; };
    const Frame frame =
        *render_exposure(renderer, {scene_at, 0.0, {}, scene.film, exposure}, sliced(8));
    std::pair<double, int> sum_and_pixels{};
    for (std::size_t i = 0; i < frame.depth.size(); ++i) {
      sum_and_pixels.first += static_cast<double>(frame.beauty[4 * i]);
      sum_and_pixels.second += frame.beauty[4 * i + 3] > 0.01f;
    }
    return sum_and_pixels;
  };
  const auto sharp = covered(4.0);
  const auto blurred = covered(2.0);
  EXPECT_NEAR(blurred.first / sharp.first, 1.0, 0.03);
  EXPECT_GT(blurred.second, 1.3 * sharp.second);
}

// A camera that pans by eight pixels while the shutter is open smears an edge over eight pixels.
TEST(Exposures, BlurWhatMoves) {
  Scene scene = seen_by({{0, 0, 4}, {0, 0, 0}, {0, 1, 0}, 10.0}, {64, 12});
  scene.lights = {{.position = {0, 0, 400}, .intensity = glm::dvec3(1e6)}};
  scene.surfaces = {wall(0.0, 0.5, 1.0)};
  // A pixel is this wide at the wall.
  const double pixel = 2.0 * 4.0 * std::tan(5.0 * M_PI / 180.0) / 12.0;
  scene.camera_keys.eye = {{0.0, {0, 0, 4}, Interpolation::linear},
                           {1.0, {16 * pixel, 0, 4}, Interpolation::linear}};
  scene.camera_keys.target = {{0.0, {0, 0, 0}, Interpolation::linear},
                              {1.0, {16 * pixel, 0, 0}, Interpolation::linear}};
  Exposure exposure = exposure_of(scene);
  exposure.samples = 64;
  exposure.shutter = Shutter{0.0, 0.5};
  exposure.frames_per_second = 1.0;
  EXPECT_TRUE(exposure.animated);
  Renderer renderer;
  const auto scene_at = [&](double time) { return evaluate_at(scene, time); };
  const Frame frame =
      *render_exposure(renderer, {scene_at, 0.0, {}, scene.film, exposure}, sliced(8));
  // Coverage falls linearly over eight pixels, from where the right edge is to eight to the left.
  const double edge = 32.0 + 0.5 / pixel;
  for (int x = 0; x < 64; ++x) {
    const double from_edge = x + 0.5 - edge;
    if (from_edge < -15.0 || std::abs(from_edge) < 1.0 || std::abs(from_edge + 8.0) < 1.0) continue;
    const double expected = std::clamp(-from_edge / 8.0, 0.0, 1.0);
    // Three of 64 samples.
    EXPECT_NEAR(frame.beauty[4 * (6 * 64 + static_cast<std::size_t>(x)) + 3], expected, 0.05) << x;
  }
}

}  // namespace
}  // namespace brume
