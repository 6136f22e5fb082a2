#include "core/io/merl_file.h"

#include <gtest/gtest.h>

#include <cstring>
#include <glm/geometric.hpp>
#include <limits>

#include "core/io/scene/scene_file.h"
#include "tests/core/io/folder_test.h"
#include "tests/core/io/input_error.h"
#include "tests/core/io/merl_writer.h"
#include "tests/random.h"

namespace brume {
namespace {

Material phong() {
  Material material;
  material.type = Material::Type::phong;
  material.reflectance = {0.3, 0.2, 0.1};
  material.specular = {0.2, 0.3, 0.5};
  material.exponent = 20.0;
  return material;
}

const std::string& phong_bytes() {
  static const std::string bytes = merl_of(phong());
  return bytes;
}

using MerlFile = FolderTest;

TEST_F(MerlFile, EvaluatesLikeTheModelItTabulates) {
  Material measured;
  measured.type = Material::Type::measured;
  measured.measured = read_merl(folder_.write("phong.binary", phong_bytes()));
  Random random(41);
  double worst = 0.0;
  for (int i = 0; i < 5000; ++i) {
    // Any normal: the table knows only angles to it.
    const glm::dvec3 n = glm::normalize(random.point(1.0));
    const glm::dvec3 wi = glm::normalize(random.point(1.0));
    const glm::dvec3 wo = glm::normalize(random.point(1.0));
    if (glm::dot(wi, n) < 0.05 || glm::dot(wo, n) < 0.05) continue;
    const glm::dvec3 reference = brdf(phong(), wi, wo, n);
    const glm::dvec3 got = brdf(measured, wi, wo, n);
    for (int c = 0; c < 3; ++c) worst = std::max(worst, std::abs(got[c] - reference[c]));
  }
  // The highlight is 1.75 / sr high and bends by exponent / 4 per radian^2 of a cell, which is up
  // to 1 degree wide.
  EXPECT_LT(worst, 0.01);
}

TEST_F(MerlFile, ProjectsLikeTheModelItTabulates) {
  Material measured;
  measured.type = Material::Type::measured;
  measured.measured = read_merl(folder_.write("phong.binary", phong_bytes()));
  const BrdfSh table(measured, 4);
  const BrdfSh reference(phong(), 4);
  for (const double cosine : {0.2, 0.6, 1.0}) {
    for (std::size_t i = 0; i < sh_size(4); ++i) {
      EXPECT_NEAR(table(cosine)[i].z, reference(cosine)[i].z, 3e-3) << cosine << ' ' << i;
    }
  }
}

TEST_F(MerlFile, IgnoresCellsThatWereNotMeasured) {
  std::vector<glm::vec3> values(MeasuredBrdf::samples, glm::vec3(-1.0f));
  const glm::dvec3 n(0, 0, 1);
  EXPECT_EQ(MeasuredBrdf(values)(n, n, n), glm::dvec3(0.0));
  values[0] = glm::vec3(2.0f);  // theta_h = theta_d = phi_d = 0
  EXPECT_EQ(MeasuredBrdf(values)(n, n, n), glm::dvec3(2.0));
}

TEST_F(MerlFile, RefusesWhatItIsNot) {
  const auto error = [&](const std::string& bytes) {
    return error_of([&] { read_merl(folder_.write("bad.binary", bytes)); });
  };
  EXPECT_TRUE(contains(error(""), "90 x 90 x 180"));
  EXPECT_TRUE(contains(error(std::string(12, '\1')), "90 x 90 x 180"));
  EXPECT_TRUE(contains(error(phong_bytes().substr(0, 1000)), "found 1000 bytes"));
  EXPECT_TRUE(contains(error(phong_bytes() + "x"), "34992013 bytes"));
  std::string bytes = phong_bytes();
  const double bad = std::numeric_limits<double>::quiet_NaN();
  std::memcpy(bytes.data() + 12 + 17 * sizeof(double), &bad, sizeof(bad));
  EXPECT_TRUE(contains(error(bytes), "sample 17: found nan"));
}

TEST_F(MerlFile, IsReadOncePerScene) {
  folder_.write("m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  folder_.write("phong.binary", phong_bytes());
  const std::string surface =
      R"({"mesh": "m.obj", "material": {"type": "measured", "file": "phong.binary"}})";
  std::string text = R"({"format": "brume-scene", "version": 1, "surfaces": [)";
  text += surface + ", " + surface + "]}";
  std::vector<std::string> warnings;
  const Scene scene = load_scene(folder_.write("a.brume", text), &warnings);
  ASSERT_NE(scene.surfaces[0].material.measured, nullptr);
  EXPECT_EQ(scene.surfaces[0].material.measured, scene.surfaces[1].material.measured);
  EXPECT_TRUE(warnings.empty());
  save_document(scene, folder_ / "b.brume");
  EXPECT_TRUE(contains(content_of(folder_ / "b.brume"), R"("file": "phong.binary")"));
  EXPECT_EQ(document_to_json(load_scene(folder_ / "b.brume"), folder_.path()),
            content_of(folder_ / "b.brume"));
}

}  // namespace
}  // namespace brume
