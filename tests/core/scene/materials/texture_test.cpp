#include "core/scene/materials/texture.h"

#include <gtest/gtest.h>

#include <cmath>

#include "brume/error.h"
#include "brume/mesh_arrays.h"
#include "brume/primitive.h"
#include "core/scene/materials/coverage.h"
#include "core/scene/materials/ggx.h"
#include "core/scene/materials/mesh_values.h"
#include "core/scene/mesh.h"
#include "tests/random.h"

namespace brume {
namespace {

using enum TextureWrap;

// Gray of width x height, from values in [0, 255].
Texture gray(int width, int height, const std::vector<int>& values,
             Texture::Encoding encoding = Texture::Encoding::linear) {
  std::vector<std::uint8_t> rgba;
  for (const int value : values) {
    for (int c = 0; c < 3; ++c) rgba.push_back(static_cast<std::uint8_t>(value));
    rgba.push_back(255);
  }
  return {width, height, rgba, encoding};
}

double lookup(const Texture& texture, double u, double v, TextureWrap wrap = repeat,
              double footprint = 0.0) {
  return 255.0 * texture.lookup({u, v}, footprint, wrap, wrap).r;
}

TEST(Texture, HasTexelsWhereTheyAre) {
  // The first row is the top, where v is 1.
  const Texture texture = gray(2, 2, {10, 20, 30, 40});
  EXPECT_NEAR(lookup(texture, 0.25, 0.75), 10.0, 1e-4);
  EXPECT_NEAR(lookup(texture, 0.75, 0.75), 20.0, 1e-4);
  EXPECT_NEAR(lookup(texture, 0.25, 0.25), 30.0, 1e-4);
  EXPECT_NEAR(lookup(texture, 0.5, 0.75), 15.0, 1e-4) << "between";
}

TEST(Texture, WrapsAtEdges) {
  const Texture texture = gray(4, 1, {10, 20, 30, 40});
  EXPECT_NEAR(lookup(texture, 1.125, 0.5, repeat), 10.0, 1e-4);
  EXPECT_NEAR(lookup(texture, -0.125, 0.5, repeat), 40.0, 1e-4);
  EXPECT_NEAR(lookup(texture, 0.0, 0.5, repeat), 25.0, 1e-4) << "half of the other side";
  EXPECT_NEAR(lookup(texture, 7.0, 0.5, clamp), 40.0, 1e-4);
  EXPECT_NEAR(lookup(texture, -7.0, 0.5, clamp), 10.0, 1e-4);
  EXPECT_NEAR(lookup(texture, 1.125, 0.5, mirror), 40.0, 1e-4);
  EXPECT_NEAR(lookup(texture, 1.375, 0.5, mirror), 30.0, 1e-4);
  EXPECT_NEAR(lookup(texture, 2.125, 0.5, mirror), 10.0, 1e-4);
  EXPECT_NEAR(lookup(texture, -0.125, 0.5, mirror), 10.0, 1e-4);
  EXPECT_NEAR(lookup(texture, 1.0, 0.5, mirror), 40.0, 1e-4);
}

TEST(Texture, IsAveragedInLinearLight) {
  // A checkerboard of black and white: half the light, which sRGB writes as 188.
  const Texture texture = gray(2, 2, {0, 255, 255, 0}, Texture::Encoding::srgb);
  EXPECT_NEAR(texture.average().r, 0.5, 3e-3);  // half a step of 8 bits
  EXPECT_NEAR(lookup(texture, 0.5, 0.5) / 255.0, 0.5, 1e-6);
}

TEST(Texture, LevelsConserveLight) {
  Random random(3);
  for (const auto& [width, height] : {std::pair{7, 5}, {16, 1}, {1, 9}, {13, 32}}) {
    std::vector<int> values(static_cast<std::size_t>(width * height));
    double sum = 0.0;
    for (int& value : values) sum += value = static_cast<int>(random.uniform(0, 256));
    const Texture texture = gray(width, height, values);
    EXPECT_EQ(texture.levels().back().width, 1);
    EXPECT_EQ(texture.levels().back().height, 1);
    // Each level rounds once.
    EXPECT_NEAR(255.0 * texture.average().r, sum / (width * height), 1.5) << width;
  }
}

TEST(Texture, BlursByFootprint) {
  std::vector<int> stripes(64 * 64);
  for (std::size_t i = 0; i < stripes.size(); ++i) stripes[i] = i % 2 == 0 ? 0 : 200;
  const Texture texture = gray(64, 64, stripes);
  const double texel = 1.0 / 64.0;
  EXPECT_NEAR(lookup(texture, 0.5 * texel, 0.5, repeat, 0.0), 0.0, 1e-4);
  EXPECT_NEAR(lookup(texture, 0.5 * texel, 0.5, repeat, texel), 0.0, 1e-4)
      << "a texel is the image";
  EXPECT_NEAR(lookup(texture, 0.5 * texel, 0.5, repeat, 2.0 * texel), 100.0, 0.5);
  const double between = lookup(texture, 0.5 * texel, 0.5, repeat, std::sqrt(2.0) * texel);
  EXPECT_NEAR(between, 50.0, 0.5);
  EXPECT_NEAR(lookup(texture, 0.3, 0.5, repeat, 1e9), 100.0, 0.5);
}

TEST(Texture, HoldsRadianceBeyondOne) {
  const Texture texture(2, 1, std::vector<glm::vec3>{{100.0f, 0.5f, 0.0f}, {200.0f, 0.5f, 0.0f}});
  EXPECT_NEAR(texture.lookup({0.25, 0.5}, 0.0, repeat, repeat).r, 100.0f, 0.4f);
  EXPECT_NEAR(texture.average().r, 150.0f, 0.6f);
  const Texture brighter(1, 1, std::vector<glm::vec3>{{0.0f, 0.0f, 3e9f}});
  EXPECT_EQ(brighter.average().b, 32768.0f);
}

// On primitives textures are neither mirrored nor turned: u x v points outwards.
TEST(PrimitiveTexcoords, FaceOutwards) {
  using enum Primitive::Shape;
  for (const Primitive::Shape shape : {plane, box, sphere, cylinder}) {
    const MeshArrays mesh = to_arrays(*mesh_of({shape, {1.0, 2.0, 3.0}}));
    ASSERT_EQ(mesh.texcoords.size(), mesh.points.size());
    for (const glm::uvec3& t : mesh.triangles) {
      const glm::vec2 a = mesh.texcoords[t.y] - mesh.texcoords[t.x];
      const glm::vec2 b = mesh.texcoords[t.z] - mesh.texcoords[t.x];
      EXPECT_GT(a.x * b.y - a.y * b.x, 0.0f) << static_cast<int>(shape);
    }
  }
}

TEST(PrimitiveTexcoords, AreUpright) {
  const MeshArrays mesh = to_arrays(*mesh_of({Primitive::Shape::box, glm::dvec3(2.0)}));
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    if (mesh.normals[i].y == 0.0f) {
      EXPECT_NEAR(mesh.texcoords[i].y, 0.5f * (mesh.points[i].y + 1.0f), 1e-6f);
    }
    if (mesh.normals[i].y == 1.0f) {
      EXPECT_NEAR(mesh.texcoords[i].y, 0.5f * (1.0f - mesh.points[i].z), 1e-6f);
    }
    if (mesh.normals[i].z == 1.0f) {
      EXPECT_NEAR(mesh.texcoords[i].x, 0.5f * (mesh.points[i].x + 1.0f), 1e-6f);
    }
  }
}

// Two triangles, one of them three times as large.
MeshArrays painted_mesh() {
  return {
      .points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {3, 0, 1}, {0, 1, 1}},
      .normals = std::vector<glm::vec3>(6, {0, 0, 1}),
      .triangles = {{0, 1, 2}, {3, 4, 5}},
      .texcoords = {{0, 0}, {1, 0}, {0, 1}, {0, 0}, {1, 0}, {0, 1}},
      .second_texcoords = {{0, 0}, {0, 2}, {4, 0}, {0, 0}, {0, 2}, {4, 0}},
      .colors = {
          {1, 0, 0, 1}, {0, 1, 0, 0.5f}, {0, 0, 1, 0}, {1, 1, 0, 1}, {1, 1, 0, 1}, {1, 1, 0, 1}}};
}

TEST(MeshValues, AreInterpolated) {
  const MeshValues values = values_in(painted_mesh(), 0, {0.5, 0.25, 0.25});
  EXPECT_EQ(values.texcoords[0].uv, glm::dvec2(0.25, 0.25));
  EXPECT_EQ(values.texcoords[1].uv, glm::dvec2(1.0, 0.5));
  EXPECT_EQ(values.color, glm::dvec4(0.5, 0.25, 0.25, 0.625));
}

TEST(MeshValues, AreUsualWhereAMeshHasNone) {
  MeshArrays mesh = painted_mesh();
  mesh.colors.clear();
  mesh.second_texcoords.clear();
  const MeshValues values = values_in(mesh, 0, {0.5, 0.25, 0.25});
  EXPECT_EQ(values.texcoords[1].uv, values.texcoords[0].uv) << "the first instead";
  EXPECT_EQ(values.color, glm::dvec4(1.0));
  EXPECT_EQ(mean_color(mesh), glm::dvec4(1.0));
}

TEST(MeshValues, AverageColorsOverTheArea) {
  const glm::dvec4 mean = mean_color(painted_mesh());
  EXPECT_NEAR(mean.r, (1.0 / 3.0 + 3.0) / 4.0, 1e-12);
  EXPECT_NEAR(mean.g, (1.0 / 3.0 + 3.0) / 4.0, 1e-12);
  EXPECT_NEAR(mean.b, 1.0 / 12.0, 1e-12);
  EXPECT_NEAR(mean.a, (0.5 + 3.0) / 4.0, 1e-12);
}

TEST(MeshValues, LookUpTexturesByTheirSet) {
  const std::vector<std::uint8_t> rgba{10, 0, 0, 255, 200, 0, 0, 255};
  TextureReference texture{"a.png",
                           std::make_shared<const Texture>(2, 1, rgba, Texture::Encoding::linear)};
  MeshValues values;
  values.texcoords[0].uv = {0.25, 0.5};
  values.texcoords[1].uv = {0.75, 0.5};
  EXPECT_NEAR(lookup(texture, values).r, 10.0f / 255.0f, 1e-6f);
  texture.uses_second_texcoords = true;
  EXPECT_NEAR(lookup(texture, values).r, 200.0f / 255.0f, 1e-6f);
}

TEST(MeshValues, ColorBaseColorAndCoverage) {
  Material material;
  material.type = Material::Type::metallic_roughness;
  MetallicRoughness& values = material.metallic_roughness;
  values.metallic = 0.0;
  values.base_color = {0.5, 1.0, 1.0};
  values.emissive = glm::dvec3(2.0);
  MeshValues mesh;
  mesh.color = {0.5, 0.25, 1.0, 0.5};
  const MaterialPoint point = material_at(values, mesh);
  EXPECT_NEAR(point.reflection.diffuse.r, 0.25 * 0.96, 1e-12);
  EXPECT_NEAR(point.reflection.diffuse.g, 0.25 * 0.96, 1e-12);
  EXPECT_EQ(point.reflection.f0, glm::dvec3(0.04));
  EXPECT_EQ(point.emitted, glm::dvec3(2.0)) << "they do not color what it emits";
  EXPECT_EQ(Coverage(material).covered(mesh), 1.0) << "opaque";
  values.alpha = AlphaMode::blend;
  values.opacity = 0.5;
  EXPECT_EQ(Coverage(material).covered(mesh), 0.25);
  values.alpha = AlphaMode::cutout;
  values.alpha_cutoff = 0.3;
  EXPECT_TRUE(Coverage(material).is_hole(mesh));
  values.alpha_cutoff = 0.2;
  EXPECT_FALSE(Coverage(material).is_hole(mesh));
  values.transmission = {0.5, 0.5, 0.5};
  EXPECT_EQ(Coverage(material).transmitted(mesh), glm::dvec3(0.25, 0.125, 0.5));
}

TEST(MeshValues, PanesOfColoredMeshesAreColored) {
  Surface pane;
  pane.material.type = Material::Type::metallic_roughness;
  MeshArrays mesh = painted_mesh();
  pane.mesh = to_mesh(mesh);
  EXPECT_TRUE(is_varied(pane));
  EXPECT_FALSE(has_colored_panes(std::span(&pane, 1))) << "it is none";
  pane.material.metallic_roughness.transmission = glm::dvec3(0.5);
  EXPECT_TRUE(has_colored_panes(std::span(&pane, 1)));
  mesh.colors.clear();
  pane.mesh = to_mesh(mesh);
  EXPECT_FALSE(is_varied(pane));
  EXPECT_FALSE(has_colored_panes(std::span(&pane, 1)));
}

TEST(MeshValues, AreCheckedAndCounted) {
  const MeshArrays mesh = painted_mesh();
  MeshArrays plain = mesh;
  plain.colors.clear();
  EXPECT_EQ(mesh_bytes(mesh) - mesh_bytes(plain), 6 * sizeof(glm::vec4));
  const auto refused = [](MeshArrays changed) {
    try {
      to_mesh(std::move(changed));
    } catch (const DomainError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  MeshArrays changed = mesh;
  changed.colors.pop_back();
  EXPECT_EQ(refused(changed), "colors: allowed: as many as points, or none");
  changed = mesh;
  changed.colors[2].g = 1.5f;
  EXPECT_EQ(refused(changed), "colors[2]: allowed: numbers in [0, 1]");
  changed.colors[2].g = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(refused(changed), "colors[2]: allowed: numbers in [0, 1]");
  changed = mesh;
  changed.second_texcoords.pop_back();
  EXPECT_EQ(refused(changed), "second_texcoords: allowed: as many as points, or none");
  changed = mesh;
  changed.texcoords.clear();
  EXPECT_EQ(refused(changed), "second_texcoords: allowed: with texcoords");
}

}  // namespace

}  // namespace brume
