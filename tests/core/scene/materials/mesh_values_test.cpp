#include "core/scene/materials/mesh_values.h"

#include <gtest/gtest.h>

#include "brume/error.h"
#include "core/scene/materials/coverage.h"
#include "core/scene/materials/ggx.h"
#include "core/scene/materials/texture.h"
#include "core/scene/mesh.h"

namespace brume {
namespace {

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
