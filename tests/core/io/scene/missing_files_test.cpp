#include "core/io/scene/missing_files.h"

#include <gtest/gtest.h>

#include "core/io/scene/scene_file.h"
#include "core/scene/mesh.h"
#include "tests/core/io/input_error.h"
#include "tests/core/io/temporary_folder.h"
#include "tests/core/io/triangle_obj.h"

namespace brume {
namespace {

namespace fs = std::filesystem;

constexpr const char* scene_text = R"({
  "format": "brume-scene", "version": 1,
  "medium": { "file": "column.ply",
              "gaussians": [ { "center": [1, 2, 3], "radius": 0.5, "density": 1 } ],
              "sequences": [ { "file": "steam_%02d.csv", "first": 3, "last": 5 } ] },
  "environment": { "file": "sky/dawn.exr", "intensity": 3 },
  "surfaces": [
    { "mesh": "meshes/a.obj", "translate": [1, 0, 0],
      "material": { "type": "measured", "file": "gold.binary" } },
    { "mesh": "meshes/a.obj", "scale": 2 } ]
})";

bool is_visible(const TriangleMesh& mesh) {
  return mesh.points[0] != mesh.points[1];
}

class MissingFilesTest : public testing::Test {
 protected:
  TemporaryFolder folder_;
  fs::path scene_ = folder_.write("scene.brume", scene_text);
  MissingFiles missing_;
};

TEST_F(MissingFilesTest, AreAnErrorByDefault) {
  expect_error([&] { load_scene(scene_); }, "column.ply");
}

TEST_F(MissingFilesTest, AreListedOnce) {
  load_document(scene_, nullptr, missing_);
  EXPECT_EQ(missing_.missing,
            (std::vector<fs::path>{folder_ / "column.ply", folder_ / "steam_%02d.csv",
                                   folder_ / "sky/dawn.exr", folder_ / "meshes/a.obj",
                                   folder_ / "gold.binary"}));
}

TEST_F(MissingFilesTest, PreserveTheirReferences) {
  const SceneDocument document = load_document(scene_, nullptr, missing_);
  const Scene& scene = document.scene;
  EXPECT_EQ(scene.medium.size(), 1u);
  EXPECT_FALSE(is_visible(*scene.surfaces.at(0).mesh));
  EXPECT_EQ(scene.sequences.at(0).frames->size(), 3u);
  save_document(document, folder_ / "saved.brume");
  const std::string saved = content_of(folder_ / "saved.brume");
  for (const char* text :
       {"\"column.ply\"", "\"steam_%02d.csv\"", "\"sky/dawn.exr\"", "\"meshes/a.obj\"",
        "\"gold.binary\"", "\"measured\"", "\"intensity\": 3"}) {
    EXPECT_TRUE(contains(saved, text)) << text << " in\n" << saved;
  }
  MissingFiles again;
  const SceneDocument loaded = load_document(folder_ / "saved.brume", nullptr, again);
  EXPECT_EQ(again.missing, missing_.missing);
  EXPECT_EQ(document_to_json(loaded, folder_.path()), saved);
}

// Archives of macOS and programs of Windows leave such names.
TEST(SceneReferences, FilesNamedAlikeAreFound) {
  const TemporaryFolder folder;
  const fs::path mesh = folder.write("Gera\u0308te/Stuhl.obj", triangle_obj);
  for (const char* name :
       {"Ger\u00e4te/Stuhl.obj", "geräte/stuhl.OBJ", "Gera\u0308te\\\\Stuhl.obj"}) {
    const fs::path scene = folder.write("a.brume", std::string(
                                                       R"({ "format": "brume-scene", "version": 1,
          "surfaces": [ { "mesh": ")") + name + R"(" } ] })");
    EXPECT_EQ(load_scene(scene).surfaces.at(0).mesh_file, mesh) << name;
    MissingFiles missing;
    load_document(scene, nullptr, missing);
    EXPECT_TRUE(missing.missing.empty()) << name;
  }
}

TEST(SceneReferences, WarnsOfFacesThatAreLeftOut) {
  const TemporaryFolder folder;
  folder.write("a.obj", std::string(triangle_obj) + "f 1 2 99\n");
  const fs::path scene =
      folder.write_scene("a.brume", R"("surfaces": [ { "mesh": "a.obj" }, { "mesh": "a.obj" } ])");
  std::vector<std::string> warnings;
  load_scene(scene, &warnings);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_TRUE(contains(warnings[0], "surfaces[].mesh: " + (folder / "a.obj").string()));
}

TEST_F(MissingFilesTest, AreReadFromTheirNewPlace) {
  const fs::path mesh = folder_.write("elsewhere/b.obj", triangle_obj);
  folder_.write("elsewhere/steam_03.csv", "x,y,z,radius,density\n1,2,3,0.5,1\n");
  folder_.write("elsewhere/steam_04.csv", "x,y,z,radius,density\n1,2,3,0.5,1\n");
  missing_.found[folder_ / "meshes/a.obj"] = mesh;
  missing_.found[folder_ / "steam_%02d.csv"] = folder_ / "elsewhere/steam_%02d.csv";
  const Scene without = load_document(scene_, nullptr, missing_).scene;
  EXPECT_EQ(without.surfaces.at(1).mesh_file, mesh);
  EXPECT_TRUE(is_visible(*without.surfaces.at(1).mesh));
  // One frame is still missing: the sequence is, where it was looked for.
  EXPECT_EQ(missing_.missing.at(1), folder_ / "elsewhere/steam_%02d.csv");
  folder_.write("elsewhere/steam_05.csv", "x,y,z,radius,density\n1,2,3,0.5,1\n");
  const Scene found = load_document(scene_, nullptr, missing_).scene;
  EXPECT_EQ(found.sequences.at(0).frames->frame(2)->gaussians.size(), 1u);
}

TEST_F(MissingFilesTest, OtherMistakesStayErrors) {
  folder_.write("column.ply", "no ply");
  expect_error([&] { load_document(scene_, nullptr, missing_); }, "column.ply");
}

}  // namespace
}  // namespace brume
