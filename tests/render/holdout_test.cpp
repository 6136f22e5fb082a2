// Surfaces that are held out, and plates behind frames.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <vector>

#include "render/display/plate_behind.h"
#include "render/display/to_display.h"
#include "render/quality/frame_errors.h"
#include "tests/render/coverage_scenes.h"
#include "tests/render/test_scenes.h"

namespace brume {
namespace {

// A wall through a cloud under a sky.
Scene walled_cloud(bool is_held_out) {
  Scene scene = on_film(in_fog(cloud_scene(30, 2.0), 0.02), {16, 12});
  scene.environment = even_sky(0.7f);
  scene.surfaces = {wall(0.05, 0.8)};
  for (Surface& surface : scene.surfaces) surface.holdout = is_held_out;
  return scene;
}

std::vector<Settings> all_methods() {
  std::vector<Settings> methods{sliced(8), paper_settings, path_traced(2)};
  for (Settings& settings : methods) settings.background_apart = true;
  return methods;
}

float mean_transmittance(const Frame& frame, std::size_t pixel) {
  const float* t = &frame.transmittance[3 * pixel];
  return (t[0] + t[1] + t[2]) / 3.0f;
}

// The fog of both frames is the same; where the wall is, there is nothing else in the second one.
void expect_held_out(const Frame& seen, const Frame& held) {
  EXPECT_EQ(held.airlight, seen.airlight);
  EXPECT_EQ(held.transmittance, seen.transmittance);
  EXPECT_EQ(held.depth, seen.depth);
  EXPECT_EQ(held.background, seen.background);
  std::size_t walls = 0;
  for (std::size_t i = 0; i < held.depth.size(); ++i) {
    const bool is_wall = std::isfinite(held.depth[i]);
    walls += is_wall ? 1 : 0;
    EXPECT_NEAR(held.beauty[4 * i + 3], 1.0f - mean_transmittance(held, i), 1e-6f) << i;
    for (std::size_t c = 0; c < 3; ++c) {
      const float expected = is_wall ? held.airlight[3 * i + c] : seen.beauty[4 * i + c];
      EXPECT_EQ(held.beauty[4 * i + c], expected) << i;
    }
  }
  EXPECT_GT(walls, 10u);
  EXPECT_LT(walls, held.depth.size());
}

TEST(Holdouts, AreNotSeenButEndTheFogAndShadowIt) {
  for (const Settings& settings : all_methods()) {
    SCOPED_TRACE(static_cast<int>(settings.airlight));
    expect_held_out(render_frame(walled_cloud(false), settings),
                    render_frame(walled_cloud(true), settings));
  }
}

TEST(Holdouts, AreNotSeenInFogThatAbsorbsColours) {
  Scene seen = walled_cloud(false);
  Scene held = walled_cloud(true);
  seen.optics.albedo = held.optics.albedo = {1.0, 0.8, 0.5};
  Settings settings = sliced(8);
  settings.background_apart = true;
  expect_held_out(render_frame(seen, settings), render_frame(held, settings));
}

TEST(Holdouts, CoverNoPartOfSampledPixels) {
  Settings settings = sliced(8);
  settings.samples = 16;
  const Frame frame = render_frame(walled_cloud(true), settings);
  ASSERT_GT(frame.statistics.sampled_pixels, 0u);
  for (std::size_t i = 0; i < frame.depth.size(); ++i) {
    EXPECT_NEAR(frame.beauty[4 * i + 3], 1.0f - mean_transmittance(frame, i), 1e-5f) << i;
  }
}

// A grey pane that covers half of what is behind it.
TEST(Holdouts, AreNotSeenThroughPanes) {
  // No ray goes through an edge of triangles.
  Scene scene = seen_by({{0.01, 3, 0.02}, {0.01, 0, 0.02}, {0, 0, -1}, 30.0}, {8, 8});
  scene.lights = {{.position = {0, 5, 1}, .intensity = {30, 30, 30}}};
  Surface floor = placed(Primitive::Shape::plane, {9, 1, 9}, {0, -1, 0});
  floor.holdout = true;
  scene.surfaces = {pane(AlphaMode::blend, 0.5, glm::dvec3(0.0)), floor};
  Scene pane_alone = scene;
  pane_alone.surfaces.pop_back();
  for (const Settings& settings : {sliced(8), path_traced(4)}) {
    const Frame frame = render_frame(scene, settings);
    const Frame alone = render_frame(pane_alone, settings);
    for (std::size_t i = 0; i < frame.depth.size(); ++i) {
      EXPECT_NEAR(frame.beauty[4 * i + 3], 0.5f, 1e-5f);
      EXPECT_NEAR(alone.beauty[4 * i + 3], 0.5f, 1e-5f);
    }
  }
}

// The camera alone does not see them: what they reflect and mirror stays.
TEST(Holdouts, ReflectLightOntoOthers) {
  Scene scene = seen_by({{0, 1, 4}, {0, 0.4, 0}, {0, 1, 0}, 40.0}, {16, 12});
  scene.lights = {{.position = {0, 3, 2}, .intensity = {30, 30, 30}}};
  scene.surfaces = {placed(Primitive::Shape::plane, {9, 1, 9}, {0, 0, 0}),
                    placed(Primitive::Shape::box, {1, 1, 1}, {0.5, 0.5, -1})};
  const Frame seen = render_frame(scene, path_traced(4));
  scene.surfaces[1].holdout = true;
  const Frame held = render_frame(scene, path_traced(4));
  std::size_t same = 0;
  for (std::size_t i = 0; i < held.depth.size(); ++i) {
    const bool is_box = held.beauty[4 * i + 3] == 0.0f;
    if (!is_box && seen.beauty[4 * i] > 0.0f) {
      EXPECT_EQ(held.beauty[4 * i], seen.beauty[4 * i]);
      ++same;
    }
  }
  EXPECT_GT(same, 50u);
  EXPECT_GT(std::ranges::count_if(seen.depth, [](float d) { return std::isfinite(d); }),
            static_cast<std::ptrdiff_t>(same));
}

TEST(Holdouts, AreBlackInThePictureThatErrorsAreMeasuredBy) {
  const Scene scene = walled_cloud(true);
  const Settings settings = sliced(64);
  FrameErrors errors(scene, scene.camera, 1, Measured::airlight_and_picture);
  const auto error = errors.measure(render_frame(scene, settings), std::nullopt, {}, {});
  ASSERT_TRUE(error && error->picture);
  EXPECT_LT(error->picture->low, 0.15);
}

PlateBehind plain_plate(const Film& film, const std::array<std::uint8_t, 3>& color) {
  PlateBehind plate{film.width, film.height, {}, 1.0};
  for (int i = 0; i < film.width * film.height; ++i) {
    plate.rgba.insert(plate.rgba.end(), {color[0], color[1], color[2], 255});
  }
  return plate;
}

TEST(PlateBehind, IsShownAsItWasPhotographedWhereNothingIsBeforeIt) {
  Scene scene = seen_by({}, {4, 4});
  const Frame frame = render_frame(scene, sliced(4));
  for (const std::array<std::uint8_t, 3>& color : {std::array<std::uint8_t, 3>{0, 0, 0},
                                                   {3, 2, 1},
                                                   {120, 60, 30},
                                                   {200, 220, 250},
                                                   {254, 100, 20},
                                                   {255, 255, 255}}) {
    for (const double exposure : {0.0, 3.0}) {
      const auto plate = std::make_shared<PlateBehind>(plain_plate(scene.film, color));
      const std::vector<std::uint8_t> shown = to_display(frame, {exposure, nullptr, plate});
      for (std::size_t i = 0; i < shown.size(); ++i) {
        EXPECT_NEAR(shown[i], color[i % 3], 2) << static_cast<int>(color[0]);
      }
    }
  }
}

TEST(PlateBehind, IsAttenuatedByTheFogInPlaceOfTheEnvironment) {
  const Scene scene = walled_cloud(true);
  Settings settings = sliced(8);
  settings.background_apart = true;
  const Frame frame = render_frame(scene, settings);
  PlateBehind plate = plain_plate(scene.film, {120, 60, 30});
  const auto row_values = 3 * static_cast<std::size_t>(frame.film.width);
  for (const double opacity : {1.0, 0.25}) {
    plate.opacity = opacity;
    for (std::size_t y = 0; y < static_cast<std::size_t>(frame.film.height); ++y) {
      const PlateRow row = plate_row(plate, frame, y);
      for (std::size_t k = 0; k < row_values; ++k) {
        const std::size_t i = y * row_values + k;
        const auto share = static_cast<float>(opacity);
        EXPECT_NEAR(row.shares[k], share * frame.transmittance[i], 1e-5f);
        EXPECT_NEAR(row.replaced[k], share * frame.background[i], 1e-5f);
      }
    }
  }
}

}  // namespace
}  // namespace brume
