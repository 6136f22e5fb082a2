#include "core/scene/materials/texture.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "brume/mesh_arrays.h"
#include "brume/primitive.h"
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

}  // namespace
}  // namespace brume
