// Metallic-roughness materials and textures: both backends shade alike.

#include <glm/gtc/quaternion.hpp>

#include "brume/mesh_arrays.h"
#include "brume/primitive.h"
#include "core/scene/materials/texture.h"
#include "tests/random.h"
#include "tests/render/gl/gl_frames.h"
#include "tests/render/test_scenes.h"

namespace brume::gl {
namespace {

using Image = brume::Texture;  // not gl::Texture

class GlMaterials : public GlFrames {
 protected:
  GlMaterials() {
    scene_ = cloud_scene(6, 1.0);
    scene_.film = {48, 36};
    scene_.camera = {{0.5, 2.0, 4.0}, {0.0, 0.2, 0.0}, {0, 1, 0}, 40.0};
    scene_.lights.assign(2, {});
    scene_.lights[0].position = {2.0, 3.0, 1.0};
    scene_.lights[0].intensity = {30.0, 20.0, 20.0};
    scene_.lights[1].position = {-2.0, 2.0, 3.0};
    scene_.lights[1].intensity = {5.0, 20.0, 10.0};
    add(Primitive::Shape::plane, glm::dvec3(6.0), {0.0, -0.5, 0.0});
    add(Primitive::Shape::sphere, glm::dvec3(1.2), {-0.9, 0.3, 0.0});
    add(Primitive::Shape::box, glm::dvec3(1.0), {0.9, 0.2, 0.0});
    scene_.surfaces[2].rotate = glm::normalize(glm::dquat(0.9, 0.1, 0.4, 0.0));
  }

  void add(Primitive::Shape shape, const glm::dvec3& size, const glm::dvec3& translate) {
    Surface& surface = scene_.surfaces.emplace_back();
    surface.primitive = Primitive{shape, size};
    surface.mesh = mesh_of(*surface.primitive);
    surface.translate = translate;
    surface.material.type = Material::Type::metallic_roughness;
    MetallicRoughness& material = material_of(scene_.surfaces.size() - 1);
    material.base_color = {0.9, 0.6, 0.4};
    material.metallic = 0.3 * static_cast<double>(scene_.surfaces.size());
    material.roughness = 0.2 + 0.2 * static_cast<double>(scene_.surfaces.size());
  }
  MetallicRoughness& material_of(std::size_t surface) {
    return scene_.surfaces[surface].material.metallic_roughness;
  }

  static TextureReference noise(int width, int height, Image::Encoding encoding, unsigned seed,
                                int low) {
    Random random(seed);
    std::vector<std::uint8_t> rgba(static_cast<std::size_t>(4 * width * height));
    for (std::uint8_t& byte : rgba) byte = static_cast<std::uint8_t>(random.uniform(low, 256.0));
    return {"noise.png", std::make_shared<const Image>(width, height, rgba, encoding)};
  }

  void expect_same(const std::string& what) {
    const Frame gl = render_on_device(scene_, quick_slices(), what);
    for (const SkippedStage& stage : gl.statistics.on_cpu) {
      EXPECT_NE(stage.stage, Stage::surfaces) << what << ": " << stage.why;
    }
    EXPECT_LE(rel_rmse(gl.beauty, render_frame(scene_, quick_slices()).beauty), 5e-4) << what;
  }

  Scene scene_;
};

TEST_F(GlMaterials, MatchTheCpu) {
  expect_same("plain");
  // Other materials beside them.
  scene_.surfaces[1].material.type = Material::Type::phong;
  scene_.surfaces[1].material.specular = glm::dvec3(0.4);
  scene_.surfaces[1].material.exponent = 12.0;
  expect_same("with Phong");
  scene_.surfaces[1].material.type = Material::Type::metallic_roughness;
  material_of(1).emissive = {0.5, 0.2, 0.1};
  scene_.environment = even_sky(0.3f);
  expect_same("emissive, under a sky");
}

TEST_F(GlMaterials, MatchTheCpuWithTextures) {
  // Sizes that halve unevenly, all wraps and encodings; larger and smaller than pixels.
  material_of(0).base_color_texture = noise(301, 77, Image::Encoding::srgb, 1, 0);
  material_of(0).base_color_texture.wrap_u = TextureWrap::mirror;
  expect_same("base color");
  material_of(0).metallic_roughness_texture = noise(8, 8, Image::Encoding::linear, 2, 30);
  expect_same("metallic and roughness, too");
  material_of(2).emissive = glm::dvec3(0.5);
  material_of(2).emissive_texture = {
      "a.exr", std::make_shared<const Image>(
                   2, 1, std::vector<glm::vec3>{{3.0f, 0.1f, 0.0f}, {0.2f, 0.2f, 5.0f}})};
  expect_same("emissive, too");
  material_of(1).normal_texture = noise(16, 16, Image::Encoding::linear, 3, 100);
  material_of(1).normal_texture.wrap_u = TextureWrap::clamp;
  expect_same("normals, too");
  material_of(2).normal_texture = material_of(1).normal_texture;
  material_of(2).normal_scale = 0.5;
  expect_same("normals of a box, too");
  // Caches follow from frame to frame.
  std::swap(scene_.surfaces[0].material, scene_.surfaces[2].material);
  expect_same("textures, exchanged");
  scene_.surfaces.erase(scene_.surfaces.begin() + 1);
  expect_same("textures, a surface less");
  scene_.medium = Medium();
  expect_same("textures in clear air");
}

TEST_F(GlMaterials, MatchTheCpuWithColorsAndSecondTexcoords) {
  Random random(7);
  const auto painted = [&](std::size_t surface, bool has_second) {
    MeshArrays arrays = to_arrays(*scene_.surfaces[surface].mesh);
    for (std::size_t i = 0; i < arrays.points.size(); ++i) {
      arrays.colors.emplace_back(glm::vec3(random.point(0.5)) + 0.5f, 1.0f);
      if (has_second) arrays.second_texcoords.emplace_back(random.point(2.0));
    }
    scene_.surfaces[surface].primitive.reset();
    scene_.surfaces[surface].mesh = to_mesh(std::move(arrays));
  };
  painted(1, false);
  expect_same("colors of the ball");
  painted(2, true);
  material_of(2).base_color_texture = noise(8, 8, Image::Encoding::srgb, 1, 0);
  material_of(2).normal_texture = noise(4, 4, Image::Encoding::linear, 3, 100);
  material_of(0).base_color_texture = material_of(2).base_color_texture;
  expect_same("a texture by the first texture coordinates");
  material_of(2).base_color_texture.uses_second_texcoords = true;
  material_of(2).normal_texture.uses_second_texcoords = true;
  material_of(0).base_color_texture.uses_second_texcoords = true;  // whose mesh has none
  expect_same("by the second ones");
}

}  // namespace
}  // namespace brume::gl
