// Colors of vertices in frames: where they are the same everywhere, those of a base color.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "brume/mesh_arrays.h"
#include "tests/render/test_scenes.h"

namespace brume {
namespace {

constexpr glm::vec4 rust(0.75f, 0.5f, 0.25f, 0.5f);

// A ball over a floor in fog, which both send light into.
Scene foggy_room(AlphaMode alpha) {
  Scene scene = in_fog(Scene(), 0.3);
  scene.film = {8, 6};
  scene.camera = {{0, 1, 4}, {0, 0, 0}, {0, 1, 0}, 40.0};
  scene.lights = {{.position = {1, 2, 1}, .intensity = {20, 20, 20}}};
  scene.surfaces = {placed(Primitive::Shape::plane, glm::dvec3(6.0), {0, -0.8, 0}),
                    placed(Primitive::Shape::sphere, glm::dvec3(1.0), {0, 0, 0})};
  for (Surface& surface : scene.surfaces) {
    surface.material.type = Material::Type::metallic_roughness;
    MetallicRoughness& material = surface.material.metallic_roughness;
    material.metallic = 0.0;
    material.roughness = 0.8;
    material.alpha = alpha;
  }
  return scene;
}

Scene with_vertices(Scene scene, auto&& color_at) {
  for (Surface& surface : scene.surfaces) {
    MeshArrays arrays = to_arrays(*surface.mesh);
    for (const glm::vec3& point : arrays.points) arrays.colors.push_back(color_at(point));
    surface.primitive.reset();
    surface.mesh = to_mesh(std::move(arrays));
  }
  return scene;
}

void expect_base_color(AlphaMode alpha, const std::vector<Settings>& all_settings) {
  const Scene plain = foggy_room(alpha);
  const Scene painted = with_vertices(plain, [](const glm::vec3&) { return rust; });
  Scene same = plain;
  for (Surface& surface : same.surfaces) {
    surface.material.metallic_roughness.base_color = glm::vec3(rust);
    if (alpha == AlphaMode::blend) surface.material.metallic_roughness.opacity = 0.5;
  }
  for (const Settings& settings : all_settings) {
    const Frame wanted = render_frame(same, settings);
    // Numbers are rounded in another order; light of all orders is iterated from there.
    EXPECT_LT(difference(render_frame(painted, settings).beauty, wanted.beauty).relative_rmse,
              1e-4);
  }
  // It matters.
  EXPECT_GT(difference(render_frame(plain, all_settings.front()).beauty,
                       render_frame(same, all_settings.front()).beauty)
                .relative_rmse,
            0.05);
}

TEST(VertexColors, AreThoseOfABaseColor) {
  expect_base_color(AlphaMode::opaque,
                    {sliced(4), all_orders(4, {.nodes = 20'000}), path_traced(1)});
}

TEST(VertexColors, HaveAnOpacity) {
  expect_base_color(AlphaMode::blend, {sliced(4), path_traced(1)});
}

TEST(VertexColors, AreInterpolatedWithoutTextures) {
  Scene scene = foggy_room(AlphaMode::opaque);
  scene.medium = Medium();
  scene.surfaces.resize(1);
  scene.film = {9, 9};
  scene.camera = {{0, 5, 0}, {0, -0.8, 0}, {0, 0, -1}, 40.0};
  scene.lights = {{.position = {0, 1e3, 0}, .intensity = glm::dvec3(1e6)}};
  const Scene red_to_blue = with_vertices(scene, [](const glm::vec3& point) {
    const float blue = 0.5f + point.x / 6.0f;
    return glm::vec4(1.0f - blue, 0.0f, blue, 1.0f);
  });
  for (const Settings& settings : {sliced(4), path_traced(1)}) {
    const Frame white = render_frame(scene, settings);
    const Frame frame = render_frame(red_to_blue, settings);
    const double half_width = 5.8 * std::tan(20.0 * std::numbers::pi / 180.0);
    for (std::size_t x = 0; x < 9; ++x) {
      const std::size_t pixel = 4 * (4 * 9 + x);
      const double middle = (static_cast<double>(x) - 4.0) / 4.5 * half_width;
      // Fresnel's part, 0.04, has no color.
      const auto share = [&](std::size_t c) {
        return static_cast<double>(frame.beauty[pixel + c]) /
               static_cast<double>(white.beauty[pixel + c]);
      };
      EXPECT_NEAR(share(2), 0.5 + middle / 6.0, 0.03) << x;
      EXPECT_NEAR(share(0), 0.5 - middle / 6.0, 0.03) << x;
      EXPECT_LT(share(1), 0.05) << x;
    }
  }
}

}  // namespace
}  // namespace brume
