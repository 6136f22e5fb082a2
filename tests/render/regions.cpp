#include "tests/render/regions.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <cstring>
#include <string>

#include "render/samples/brightness.h"
#include "tests/render/random_scene.h"
#include "tests/render/test_scenes.h"

namespace brume {
namespace {

// Two corners, at times on the film's border.
Film random_region(const Film& film, Random& random) {
  const auto side = [&random] {
    const double x = random.uniform(-0.2, 1.2);
    return glm::clamp(x, 0.0, 1.0);
  };
  const glm::dvec2 corner(side(), side());
  // Small ones leave most of the film out.
  const double size = random.power(-2.0, -0.3);
  return film_region(film, corner, glm::clamp(corner + size, 0.0, 1.0));
}

Scene scene_of(unsigned seed, const Film& film) {
  Scene scene = random_fog_scene(seed);
  scene.film = film;
  if (seed % 2 == 0) {
    scene.surfaces.push_back(ball_surface(24, 0.7, scene.camera.target));
  }
  if (seed % 3 == 0 && !scene.environment) scene.environment = even_sky(0.3f);
  return scene;
}

void expect_same_layer(const char* name, const std::vector<float>& whole, const Film& film,
                       const std::vector<float>& part, const Film& region) {
  if (whole.empty() && part.empty()) return;
  const std::size_t channels =
      whole.size() / (static_cast<std::size_t>(film.width) * static_cast<std::size_t>(film.height));
  ASSERT_EQ(part.size(), channels * static_cast<std::size_t>(region.width) *
                             static_cast<std::size_t>(region.height))
      << name;
  for (int y = 0; y < region.height; ++y) {
    for (int x = 0; x < region.width; ++x) {
      const auto a =
          static_cast<std::size_t>((region.region->y + y) * film.width + region.region->x + x);
      const auto b = static_cast<std::size_t>(y * region.width + x);
      const float* const expected = whole.data() + channels * a;
      const float* const found = part.data() + channels * b;
      ASSERT_EQ(std::memcmp(expected, found, channels * sizeof(float)), 0)
          << name << " at " << x << ", " << y << ": " << found[0] << ", not " << expected[0];
    }
  }
}

}  // namespace

void expect_same_pixels(const Frame& whole, const Frame& part) {
  const auto expect_same = [&](const char* name, const std::vector<float>& a,
                               const std::vector<float>& b) {
    expect_same_layer(name, a, whole.film, b, part.film);
  };
  expect_same("depth", whole.depth, part.depth);
  expect_same("transmittance", whole.transmittance, part.transmittance);
  expect_same("airlight", whole.airlight, part.airlight);
  expect_same("airlight at centers", whole.airlight_at_centers, part.airlight_at_centers);
  expect_same("background", whole.background, part.background);
  expect_same("beauty", whole.beauty, part.beauty);
  EXPECT_EQ(whole.layers.channels.size(), part.layers.channels.size());
  for (const auto& [name, layer] : whole.layers.channels) {
    expect_same(name.c_str(), layer, part.layers.channels.at(name));
  }
}

void expect_region_matches(FrameRenderer& renderer, unsigned seed, const RegionRequest& request) {
  if (const char* one = std::getenv("BRUME_REGION_SEED"); one && std::stoul(one) != seed) return;
  const Scene scene = scene_of(seed, request.film);
  const Settings settings =
      *with_brightness(renderer, scene, scene.camera, scene.film, request.settings, {});
  Random random(seed);
  const Frame whole = render_frame(renderer, scene, settings);
  const Film region = random_region(scene.film, random);
  SCOPED_TRACE("BRUME_REGION_SEED=" + std::to_string(seed) + " " + airlight_name(settings) + " / " +
               std::to_string(settings.airlight_scale) + ", " + std::to_string(region.width) +
               " x " + std::to_string(region.height) + " at " + std::to_string(region.region->x) +
               ", " + std::to_string(region.region->y));
  expect_same_pixels(whole, *renderer.render(scene, scene.camera, region, settings));
}

}  // namespace brume
