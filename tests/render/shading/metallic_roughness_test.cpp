// Metallic-roughness materials in frames: against the plain BRDF, and against paths.

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "brume/mesh_arrays.h"
#include "brume/primitive.h"
#include "core/scene/materials/ggx.h"
#include "core/scene/materials/texture.h"
#include "render/visibility/surface_point.h"
#include "tests/render/test_scenes.h"

namespace brume {
namespace {

Surface painted(const Primitive& primitive, const MetallicRoughness& material) {
  Surface surface;
  surface.primitive = primitive;
  surface.mesh = mesh_of(primitive);
  surface.material.type = Material::Type::metallic_roughness;
  surface.material.metallic_roughness = material;
  return surface;
}

MetallicRoughness metal(double metallic, double roughness) {
  MetallicRoughness material;
  material.base_color = {0.9, 0.6, 0.3};
  material.metallic = metallic;
  material.roughness = roughness;
  return material;
}

// A ball of that material, seen from z = 4, without fog.
Scene ball(const MetallicRoughness& material) {
  Scene scene;
  scene.film = {16, 16};
  scene.camera = {{0, 0, 4}, {0, 0, 0}, {0, 1, 0}, 30.0};
  scene.surfaces = {painted({Primitive::Shape::sphere, glm::dvec3(2.0)}, material)};
  return scene;
}

TextureReference texture_of(int width, int height, const std::vector<std::uint8_t>& rgba,
                            Texture::Encoding encoding) {
  return {"a.png", std::make_shared<const Texture>(width, height, rgba, encoding)};
}

// RGB of the pixel in the middle.
glm::vec3 middle(const Frame& frame) {
  const auto x = static_cast<std::size_t>(frame.film.width / 2);
  const auto y = static_cast<std::size_t>(frame.film.height / 2);
  const std::size_t i = 4 * (y * static_cast<std::size_t>(frame.film.width) + x);
  return {frame.beauty[i], frame.beauty[i + 1], frame.beauty[i + 2]};
}

TEST(MetallicRoughnessFrames, ReflectPointLightsAsPathsDo) {
  for (const auto& [metallic, roughness] : {std::pair{1.0, 0.3}, {0.0, 0.6}, {0.5, 0.05}}) {
    Scene scene = ball(metal(metallic, roughness));
    scene.lights = {{.position = {2, 3, 4}, .intensity = {40, 30, 20}}};
    // A ball sends no light to itself: paths are one light sample, without noise.
    const Difference found = difference(render_frame(scene, sliced(12)).beauty,
                                        render_frame(scene, path_traced(1)).beauty);
    EXPECT_LT(found.relative_rmse, 2e-3) << metallic << ' ' << roughness;
  }
}

TEST(MetallicRoughnessFrames, ReflectUniformSkiesAsPathsDo) {
  for (const auto& [metallic, roughness] : {std::pair{1.0, 0.3}, {0.0, 0.8}}) {
    Scene scene = ball(metal(metallic, roughness));
    scene.film = {9, 9};
    scene.camera.vertical_fov = 20.0;  // nothing but the ball
    scene.environment = even_sky(0.7f);
    const Frame paths = render_frame(scene, path_traced(400));
    const Difference found = difference(render_frame(scene, sliced(12)).beauty, paths.beauty);
    EXPECT_LT(std::abs(found.bias), 0.01) << metallic << ' ' << roughness;
    EXPECT_LT(found.relative_rmse, 0.03) << metallic << ' ' << roughness;
  }
}

TEST(MetallicRoughnessFrames, ShowWhatTheyEmit) {
  MetallicRoughness material = metal(0.0, 0.5);
  material.emissive = {3.0, 2.0, 1.0};
  const Scene dark = ball(material);
  EXPECT_EQ(middle(render_frame(dark, sliced(12))), glm::vec3(3.0f, 2.0f, 1.0f));
  EXPECT_EQ(middle(render_frame(dark, path_traced(1))), glm::vec3(3.0f, 2.0f, 1.0f));
  // Through fog, which it lights.
  const Scene foggy = in_fog(dark, 0.1);
  const glm::vec3 seen = middle(render_frame(foggy, sliced(12)));
  const double attenuated = 3.0 * std::exp(-0.1 * 3.0);
  EXPECT_GT(seen.x, attenuated);
  EXPECT_LT(seen.x, 1.03 * attenuated);
}

// Emitted light arrives elsewhere, in paths: within a furnace of emission E, of albedo a.
TEST(MetallicRoughnessFrames, LightOthersInPaths) {
  MetallicRoughness material = metal(0.0, 1.0);
  material.base_color = glm::dvec3(0.5);
  material.emissive = glm::dvec3(1.0);
  Scene scene;
  scene.film = {6, 6};
  scene.camera = {{0, 0, 0}, {0.3, 0.2, 1}, {0, 1, 0}, 60.0};
  scene.surfaces = {painted({Primitive::Shape::box, glm::dvec3(4.0)}, material)};
  const Frame frame = render_frame(scene, path_traced(400));
  double mean = 0.0;
  for (std::size_t i = 0; i < frame.beauty.size(); i += 4) {
    mean += static_cast<double>(frame.beauty[i]) / 36.0;
  }
  // L = E + a L; the albedo of this material is 0.46 to 0.52, by angle.
  EXPECT_GT(mean, 1.0 / (1.0 - 0.45));
  EXPECT_LT(mean, 1.0 / (1.0 - 0.53));
}

TEST(MetallicRoughnessFrames, AverageTexturesOverPixels) {
  std::vector<std::uint8_t> checker;
  for (int i = 0; i < 256 * 256; ++i) {
    const auto value = static_cast<std::uint8_t>((i / 256 + i) % 2 == 0 ? 0 : 255);
    checker.insert(checker.end(), {value, value, value, 255});
  }
  MetallicRoughness material;
  material.emissive = glm::dvec3(1.0);
  material.emissive_texture = texture_of(256, 256, checker, Texture::Encoding::srgb);
  Scene scene;
  scene.film = {16, 16};
  scene.camera = {{0, 20, 0.01}, {0, 0, 0}, {0, 1, 0}, 2.0};
  scene.surfaces = {painted({Primitive::Shape::plane, glm::dvec3(4.0)}, material)};
  const Frame frame = render_frame(scene, sliced(12));
  // Four texels a pixel: black and white are gray everywhere.
  for (std::size_t i = 0; i < frame.beauty.size(); i += 4) {
    EXPECT_NEAR(frame.beauty[i], 0.5f, 0.02f);
  }
  // From close by, the film sees the middle of a single texel.
  scene.camera.eye = {0.0078, 0.05, 0.0078};
  scene.camera.target = {0.0078, 0.0, 0.0077};
  scene.camera.vertical_fov = 1.0;
  const float near = middle(render_frame(scene, sliced(12))).x;
  EXPECT_TRUE(near < 0.1f || near > 0.9f) << near;
}

TEST(MetallicRoughnessFrames, TurnNormalsByTheirMap) {
  // A plane whose map leans towards +u, which is +x, against one that is turned.
  constexpr double lean = 0.3;
  const auto byte = [](double x) {
    return static_cast<std::uint8_t>(std::lround(127.5 * (x + 1.0)));
  };
  const std::vector<std::uint8_t> rgba{byte(std::sin(lean)), byte(0.0), byte(std::cos(lean)), 255};
  MetallicRoughness material = metal(0.0, 0.7);
  material.normal_texture = texture_of(1, 1, rgba, Texture::Encoding::linear);
  Scene scene;
  scene.film = {1, 1};
  scene.camera = {{0, 5, 0.01}, {0, 0, 0}, {0, 1, 0}, 1.0};
  scene.lights = {{.position = {4, 6, 1}, .intensity = {100, 100, 100}}};
  scene.surfaces = {painted({Primitive::Shape::plane, glm::dvec3(4.0)}, material)};

  const glm::dvec3 n = glm::normalize(2.0 / 255.0 * glm::dvec3(rgba[0], rgba[2], -rgba[1]) +
                                      glm::dvec3(-1.0, -1.0, 1.0));
  const glm::dvec3 to_light = scene.lights[0].position;
  const glm::dvec3 wi = glm::normalize(to_light);
  const glm::dvec3 wo = glm::normalize(scene.camera.eye);
  const GgxReflection reflection(material.base_color, material.metallic, material.roughness);
  const glm::dvec3 expected =
      100.0 * glm::dot(n, wi) * ggx_brdf(reflection, wi, wo, n) / glm::dot(to_light, to_light);
  for (const Settings& settings : {sliced(12), path_traced(1)}) {
    const glm::vec3 found = middle(render_frame(scene, settings));
    EXPECT_NEAR(found.x, expected.x, 2e-3 * expected.x);
    EXPECT_NEAR(found.z, expected.z, 2e-3 * expected.x);
  }
}

TEST(MetallicRoughnessFrames, RefuseRadianceTransfer) {
  Scene scene = ball(metal(0.0, 0.5));
  scene.surfaces[0].transfer = Surface::Transfer::shadow;
  scene.environment = even_sky(0.7f);
  const Frame frame = render_frame(scene, sliced(12));
  const auto& skipped = frame.statistics.skipped;
  EXPECT_TRUE(std::ranges::any_of(skipped, [](const SkippedStage& stage) {
    return stage.stage == Stage::transfer &&
           stage.why.find("metallic-roughness") != std::string::npos;
  }));
  scene.surfaces[0].transfer = Surface::Transfer::none;
  EXPECT_EQ(frame.beauty, render_frame(scene, sliced(12)).beauty);
}

TEST(TextureFrame, FollowsTheTexture) {
  // u runs along +y here, v along +x: mirrored as seen from +z.
  const std::array<glm::dvec3, 3> positions{{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}}};
  const std::array<glm::dvec2, 3> texcoords{{{0, 0}, {0, 1}, {1, 0}}};
  const TextureFrame frame(positions, texcoords);
  EXPECT_NEAR(frame.density, 0.5, 1e-12);
  const glm::dvec3 n(0, 0, 1);
  EXPECT_NEAR(glm::length(frame.to_world({1, 0, 0}, n) - glm::dvec3(0, 1, 0)), 0.0, 1e-12);
  EXPECT_NEAR(glm::length(frame.to_world({0, 1, 0}, n) - glm::dvec3(1, 0, 0)), 0.0, 1e-12);
  EXPECT_NEAR(glm::length(frame.to_world({0, 0, 1}, n) - n), 0.0, 1e-12);
  EXPECT_EQ(TextureFrame().to_world({1, 0, 0}, n), n) << "without texture coordinates";
}

}  // namespace
}  // namespace brume
