// Frames are shown without leaving the device, in textures of its own.

#include "render/display/to_display.h"
#include "render/gl/composite_stage.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <glm/vec4.hpp>
#include <limits>

#include "render/gl_renderer.h"
#include "tests/contains.h"
#include "tests/render/gl/gl_frames.h"
#include "tests/render/test_scenes.h"

namespace brume::gl {
namespace {

// A renderer whose objects the test's own context sees.
class Display : public GlTest {
 protected:
  void SetUp() override {
    GlTest::SetUp();
    std::string problem;
    auto sharing = context_->create_sharing();
    ASSERT_TRUE(sharing);
    gl_ = GlRenderer::create(std::move(sharing), nullptr, problem, pool_);
    ASSERT_TRUE(gl_) << problem;
    ASSERT_TRUE(context_->make_current());
  }
  void TearDown() override {
    gl_.reset();
    pool_->trim();
    GlTest::TearDown();
  }

  GlRenderer::DisplayFrame show(const Scene& scene, const Settings& settings,
                                const DisplayOptions& options) {
    auto shown = gl_->show(scene, scene.camera, scene.film, settings, options);
    EXPECT_TRUE(context_->make_current());
    return std::move(*shown);
  }

  // The bytes in the layout of to_display(): RGB, rows from the top.
  static std::vector<std::uint8_t> bytes_of(const DevicePicture& picture) {
    const auto width = static_cast<std::size_t>(picture.texture().size().x);
    const auto height = static_cast<std::size_t>(picture.texture().size().y);
    std::vector<std::uint8_t> rgba(4 * width * height);
    glGetTextureImage(picture.texture().name(), 0, GL_RGBA, GL_UNSIGNED_BYTE,
                      static_cast<GLsizei>(rgba.size()), rgba.data());
    std::vector<std::uint8_t> rgb;
    for (std::size_t y = height; y-- > 0;) {
      for (std::size_t x = 0; x < width; ++x) {
        const auto pixel = rgba.begin() + static_cast<std::ptrdiff_t>(4 * (y * width + x));
        EXPECT_EQ(pixel[3], 255);
        rgb.insert(rgb.end(), pixel, pixel + 3);
      }
    }
    return rgb;
  }

  static int furthest(const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b) {
    if (a.size() != b.size()) return 256;
    int max_difference = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
      max_difference = std::max(max_difference, std::abs(a[i] - b[i]));
    return max_difference;
  }

  std::shared_ptr<PicturePool> pool_ = PicturePool::create();
  std::unique_ptr<GlRenderer> gl_;
};

// Fog before a wall, lit from bright to dark.
Scene scene_with_wall() {
  Scene scene = on_film(cloud_scene(10, 2.0), {45, 34});
  scene.surfaces.push_back(wall(-0.5, 1.0));
  return scene;
}

Settings quick() {
  Settings settings = sliced_settings({}, 6);
  settings.optical_depth_table = {16, 8};
  return settings;
}

bool has_stage(const Frame& frame, Stage stage) {
  return std::ranges::any_of(frame.statistics.stages,
                             [&](const StageTime& ran) { return ran.stage == stage; });
}

// The texels of a film of 1 x n, shown.
TEST_F(Display, MatchesToDisplayForAllRadiances) {
  constexpr int steps = 2000;
  Frame frame;
  std::vector<float> airlight;
  for (int k = 0; k < steps; ++k) {
    const float x = std::pow(10.0f, 12.0f * static_cast<float>(k) / steps - 6.0f);
    const glm::vec4 colors[]{{x, x, x, 1.0f}, {x, 0.5f * x, 0.1f * x, 1.0f}, {0.0f, 0.0f, x, 1.0f}};
    for (const glm::vec4& c : colors) frame.beauty.insert(frame.beauty.end(), &c.x, &c.x + 4);
  }
  for (const float x : {0.0f, 1e30f}) frame.beauty.insert(frame.beauty.end(), {x, x, x, 1.0f});
  FilmTextures film;
  frame.film = {static_cast<int>(frame.beauty.size() / 4), 1};
  film.reserve(frame.film);
  film.beauty.upload(frame.beauty);
  film.airlight.fill(0.0f);
  Programs programs;
  DisplayStage stage;
  const AlbedoGroup all{1.0, {0, 1, 2}};
  for (const double exposure :
       {0.0, -3.5, 20.0, -20.0, 1e9, std::numeric_limits<double>::quiet_NaN()}) {
    const auto picture = pool_->acquire({frame.film.width, 1});
    stage.run(programs, film, {.exposure = exposure}, {}, all, true, true, picture->texture());
    EXPECT_LE(furthest(bytes_of(*picture), to_display(frame, {exposure})), 1) << exposure;
  }
}

// Rounding may change a few bytes whose value is next to a threshold.
TEST_F(Display, RegionsHaveThePatternOfToDisplay) {
  Frame frame;
  frame.film = {64, 48, FilmRegion{5, 11, 200, 200}};
  for (int i = 0; i < 64 * 48; ++i) {
    const float x = 0.02f + 1e-5f * static_cast<float>(i);
    frame.beauty.insert(frame.beauty.end(), {x, x, x, 1.0f});
  }
  FilmTextures film;
  film.reserve(frame.film);
  film.beauty.upload(frame.beauty);
  film.airlight.fill(0.0f);
  Programs programs;
  DisplayStage stage;
  const auto picture = pool_->acquire({frame.film.width, frame.film.height});
  stage.run(programs, film, {}, {5, 11}, {1.0, {0, 1, 2}}, true, true, picture->texture());
  const std::vector<std::uint8_t> found = bytes_of(*picture);
  const std::vector<std::uint8_t> expected = to_display(frame, {});
  ASSERT_EQ(found.size(), expected.size());
  std::size_t different = 0;
  for (std::size_t i = 0; i < found.size(); ++i) different += found[i] != expected[i] ? 1u : 0u;
  EXPECT_LT(different, found.size() / 500);
}

TEST_F(Display, MatchesTheDownloadedFrame) {
  Scene scene = scene_with_wall();
  for (const glm::dvec3 albedo :
       {glm::dvec3(1.0), glm::dvec3(0.7), glm::dvec3(0.9, 0.5, 0.9), glm::dvec3(0.9, 0.5, 0.2)}) {
    scene.optics.albedo = albedo;
    for (const double exposure : {0.0, 2.5}) {
      const GlRenderer::DisplayFrame shown = show(scene, quick(), {.exposure = exposure});
      ASSERT_TRUE(shown.picture);
      EXPECT_EQ(shown.frame.statistics.backend, "gl");
      const Frame frame = *gl_->render(scene, scene.camera, scene.film, quick());
      ASSERT_TRUE(context_->make_current());
      EXPECT_LE(furthest(bytes_of(*shown.picture), to_display(frame, {exposure})), 1);
      const GlRenderer::DisplayFrame medium =
          show(scene, quick(), {DisplayOptions::Layer::airlight, exposure});
      Frame airlight = frame;
      for (std::size_t i = 0; i < frame.depth.size(); ++i) {
        std::copy_n(&frame.airlight[3 * i], 3, &airlight.beauty[4 * i]);
      }
      EXPECT_LE(furthest(bytes_of(*medium.picture), to_display(airlight, {exposure})), 1);
    }
  }
}

TEST_F(Display, DownloadsOnlyRequestedLayers) {
  const Scene scene = scene_with_wall();
  const Frame whole = *gl_->render(scene, scene.camera, scene.film, quick());
  EXPECT_TRUE(has_stage(whole, Stage::read_back));
  const Frame shown = show(scene, quick(), {}).frame;
  EXPECT_FALSE(has_stage(shown, Stage::read_back));
  EXPECT_FALSE(has_stage(shown, Stage::read_depth));
  EXPECT_TRUE(has_stage(shown, Stage::display));
  EXPECT_TRUE(shown.beauty.empty() && shown.airlight.empty() && shown.transmittance.empty());
  EXPECT_TRUE(shown.depth.empty() && shown.statistics.pixel_pairs.empty());
  EXPECT_EQ(shown.film, whole.film);
  EXPECT_EQ(shown.statistics.view_pairs, whole.statistics.view_pairs);
  EXPECT_EQ(shown.statistics.gaussians_used, whole.statistics.gaussians_used);
  const Frame with_depth = show(scene, quick(), {.depth = true}).frame;
  EXPECT_TRUE(has_stage(with_depth, Stage::read_depth));
  EXPECT_EQ(with_depth.depth, whole.depth);
  Scene bare = scene;
  bare.surfaces.clear();
  EXPECT_TRUE(show(bare, quick(), {.depth = true}).frame.depth.empty());
}

TEST_F(Display, WithoutAPoolAllLayersAreDownloaded) {
  std::string problem;
  const auto alone = GlRenderer::create(context_->create_sharing(), nullptr, problem);
  const Scene scene = scene_with_wall();
  const auto shown = alone->show(scene, scene.camera, scene.film, quick(), {});
  ASSERT_TRUE(context_->make_current());
  EXPECT_FALSE(shown->picture);
  EXPECT_FALSE(shown->frame.beauty.empty());
}

TEST_F(Display, UnsupportedFramesAreRenderedByTheCpu) {
  const Scene scene = scene_with_wall();
  const auto expect_cpu = [&](const char* why) {
    const GlRenderer::DisplayFrame shown = show(scene, quick(), {});
    EXPECT_FALSE(shown.picture);
    EXPECT_EQ(shown.frame.statistics.backend, "cpu");
    EXPECT_EQ(shown.frame.beauty.size(), 4u * 45 * 34);
    ASSERT_FALSE(shown.frame.statistics.on_cpu.empty());
    EXPECT_TRUE(contains(shown.frame.statistics.on_cpu[0].why, why));
  };
  failures().memory = true;
  expect_cpu("out of device memory");
  failures() = {};
  EXPECT_TRUE(show(scene, quick(), {}).picture);
  failures().context = true;
  expect_cpu("lost");
  failures() = {};
  expect_cpu("lost");
}

TEST_F(Display, PicturesOutliveTheirRenderer) {
  const Scene scene = scene_with_wall();
  const auto picture = show(scene, quick(), {}).picture;
  const std::vector<std::uint8_t> before = bytes_of(*picture);
  gl_.reset();
  ASSERT_TRUE(context_->make_current());
  EXPECT_EQ(bytes_of(*picture), before);
}

TEST_F(Display, NoPictureIsWrittenWhileItIsHeld) {
  const Scene scene = scene_with_wall();
  std::vector<std::shared_ptr<DevicePicture>> held;
  std::vector<std::vector<std::uint8_t>> shown;
  for (int k = 0; k < 5; ++k) {
    held.push_back(show(scene, quick(), {.exposure = 0.5 * k}).picture);
    held.back()->drawn();
    shown.push_back(bytes_of(*held.back()));
    if (k > 0) {
      EXPECT_NE(shown.back(), shown[shown.size() - 2]) << k;
    }
  }
  for (std::size_t k = 0; k < held.size(); ++k) EXPECT_EQ(bytes_of(*held[k]), shown[k]);
}

TEST_F(Display, PicturesAreUsedAgain) {
  pool_->trim();
  const std::size_t objects = live_objects();
  const unsigned first = pool_->acquire({8, 6})->texture().name();
  {
    const auto again = pool_->acquire({8, 6});
    EXPECT_EQ(again->texture().name(), first);
    const auto another = pool_->acquire({8, 6});
    EXPECT_NE(another->texture().name(), first);
    again->drawn();
  }
  // Only some of many sizes are kept.
  for (int k = 1; k < 40; ++k) pool_->acquire({8 + k, 6})->drawn();
  EXPECT_LE(live_objects(), objects + 10);
  pool_->trim();
  EXPECT_EQ(live_objects(), objects);
}

// The program may end while a frame is under way.
TEST_F(Display, PicturesMayOutliveTheirContexts) {
  const std::size_t objects = live_objects();
  std::shared_ptr<DevicePicture> picture;
  {
    const auto other = EglContext::create();
    auto pool = PicturePool::create();
    picture = pool->acquire({8, 6});
    picture->drawn();
  }
  picture.reset();
  EXPECT_EQ(live_objects(), objects);
  ASSERT_TRUE(context_->make_current());
}

}  // namespace
}  // namespace brume::gl
