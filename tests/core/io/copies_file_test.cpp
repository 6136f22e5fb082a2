#include "core/io/copies_file.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "core/io/scene/gather.h"
#include "core/io/scene/scene_file.h"
#include "tests/core/io/folder_test.h"
#include "tests/core/io/input_error.h"
#include "tests/core/io/triangle_obj.h"

namespace brume {
namespace {

const std::string heading = "x,y,z,qw,qx,qy,qz,scale\n";

TEST(CopiesFile, AreReadFromCsvAndPly) {
  const TemporaryFolder folder;
  const CopyPlacements wanted{{{1, 2, 3}, {0.6, 0.0, 0.8, 0.0}, 2.0}, {{4, 5, 6}, {1, 0, 0, 0}, 1}};
  const std::string rows = "1 2 3 3 0 4 0 2\n4 5 6 1 0 0 0 1\n";  // quaternions of any length
  std::string csv = heading + rows;
  for (char& c : csv) {
    if (c == ' ') c = ',';
  }
  std::string ply = "ply\nformat ascii 1.0\nelement vertex 2\n";
  for (const char* name : {"x", "y", "z", "qw", "qx", "qy", "qz", "scale"}) {
    ply += std::string("property float ") + name + "\n";
  }
  for (const auto& file :
       {folder.write("a.csv", csv), folder.write("a.ply", ply + "end_header\n" + rows)}) {
    const CopyPlacements copies = read_copies(file, 2);
    ASSERT_EQ(copies.size(), 2u);
    for (std::size_t i = 0; i < 2; ++i) {
      EXPECT_EQ(copies[i].translate, wanted[i].translate);
      EXPECT_NEAR(glm::dot(copies[i].rotate, wanted[i].rotate), 1.0, 1e-12);
      EXPECT_EQ(copies[i].scale, wanted[i].scale);
    }
  }
  const CopyPlacements upright = read_copies(folder.write("b.csv", "x y z\n7 8 9\n"), 1);
  EXPECT_EQ(upright, (CopyPlacements{{{7, 8, 9}}}));
}

TEST(CopiesFile, SaysWhereAndWhatIsWrong) {
  const TemporaryFolder folder;
  const auto refusal = [&](const std::string& text, std::size_t max_count = 10) {
    return error_of([&] { read_copies(folder.write("a.csv", text), max_count); });
  };
  EXPECT_TRUE(contains(refusal("x,y\n1,2\n"), "there is no column z"));
  EXPECT_TRUE(contains(refusal("x,y,z,qw\n1,2,3,1\n"), "there is no column qx"));
  EXPECT_TRUE(contains(refusal(heading + "1,2,3,0,0,0,0,1\n"), "line 2", "length 0"));
  EXPECT_TRUE(contains(refusal(heading + "1,2,3,1,0,0,0,0\n"), "scale"));
  EXPECT_TRUE(contains(refusal(heading + "1,nan,3,1,0,0,0,1\n"), "line 2, y"));
  EXPECT_TRUE(contains(refusal(heading + "1,2,3,1,0,0\n"), "is missing"));
  EXPECT_TRUE(contains(refusal(""), "a.csv"));
  EXPECT_TRUE(contains(refusal("x,y,z\n1,2,3\n4,5,6\n", 1), "too many copies"));
  const std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty "
      "float y\nproperty float z\nproperty float scale\nend_header\n1 2 3 -1\n";
  EXPECT_TRUE(contains(refusal(ply), "vertex 0, scale"));
  std::vector<std::string> warnings;
  EXPECT_TRUE(read_copies(folder.write("a.csv", heading), 10, &warnings).empty());
  EXPECT_EQ(warnings, std::vector<std::string>{"there are no copies in it"});
}

class CopiesScene : public FolderTest {
 protected:
  std::filesystem::path write(const std::string& copies) {
    folder_.write("a.obj", triangle_obj);
    folder_.write("places/c.csv", "x,y,z\n1,2,3\n4,5,6\n");
    return folder_.write("a.brume", R"({ "format": "brume-scene", "version": 1, "surfaces": [
      { "mesh": "a.obj", "name": "ground" },
      { "mesh": "a.obj", "copies": { )" +
                                        copies + " } } ] }");
  }
};

TEST_F(CopiesScene, AreSavedAsTheyWere) {
  for (const char* copies :
       {R"("file": "places/c.csv", "note": 1)",
        R"("over": "ground", "density": 8.0, "seed": 5, "scale": [0.5, 2.0], "turn": 90.0)"}) {
    std::vector<std::string> warnings;
    const SceneDocument document = load_document(write(copies), &warnings);
    EXPECT_LE(warnings.size(), 1u);
    ASSERT_TRUE(document.scene.surfaces[1].copies);
    save_document(document, folder_ / "again.brume");
    const SceneDocument again = load_document(folder_ / "again.brume");
    const Copies& was = *document.scene.surfaces[1].copies;
    const Copies& is = *again.scene.surfaces[1].copies;
    EXPECT_EQ(is.file, was.file);
    EXPECT_EQ(is.scatter, was.scatter);
    ASSERT_EQ(is.placements != nullptr, was.placements != nullptr);
    if (is.placements) {
      EXPECT_EQ(*is.placements, *was.placements);
    }
    std::ifstream text(folder_ / "again.brume");
    const std::string content{std::istreambuf_iterator<char>(text), {}};
    EXPECT_EQ(content.find("note") != std::string::npos, is.placements != nullptr);
  }
}

TEST_F(CopiesScene, FilesAreGathered) {
  const SceneDocument document = load_document(write(R"("file": "places/c.csv")"));
  ASSERT_TRUE(gather_scene(document, folder_ / "out", "scene"));
  const SceneDocument there = load_document(folder_ / "out/scene.brume");
  EXPECT_EQ(there.scene.surfaces[1].copies->placements->size(), 2u);
  EXPECT_EQ(there.scene.surfaces[1].copies->file.parent_path(), folder_ / "out/files");
}

TEST_F(CopiesScene, SaysWhatIsWrong) {
  const auto refusal = [&](const std::string& copies) {
    return error_of([&] { load_document(write(copies)); });
  };
  EXPECT_TRUE(
      contains(refusal(R"("file": "places/c.csv", "over": "ground")"), "surfaces[1].copies.over"));
  EXPECT_TRUE(
      contains(refusal(R"("file": "places/c.csv", "density": 2)"), "surfaces[1].copies.density"));
  EXPECT_TRUE(contains(refusal(R"("file": "none.csv")"), "none.csv"));
  EXPECT_TRUE(contains(refusal(R"("over": "ground")"), "surfaces[1].copies.density"));
  EXPECT_TRUE(contains(refusal(R"("over": "ground", "density": 1e12)"), "as the memory"));
  std::vector<std::string> warnings;
  load_document(write(R"("over": "gone", "density": 1)"), &warnings);
  expect_only(warnings, "there is no surface gone");
}

}  // namespace
}  // namespace brume
