#include "core/io/scene/gather.h"

#include <gtest/gtest.h>

#include "core/io/gaussians/gaussian_file.h"
#include "core/io/image/image_file.h"
#include "core/io/scene/scene_file.h"
#include "core/io/scene/scene_files.h"
#include "core/scene/imported_scene.h"
#include "tests/core/io/folder_test.h"
#include "tests/core/io/input_error.h"
#include "tests/core/io/triangle_obj.h"

namespace brume {
namespace {

namespace fs = std::filesystem;

const std::vector<Gaussian> two_gaussians{{{0, 1, 0}, 0.5, 0.1}, {{0, 2, 0}, 0.7, 0.2}};

class Gather : public FolderTest {
 protected:
  Gather() {
    for (const char* name : {"a", "b", "smoke"}) fs::create_directory(folder_ / name);
    folder_.write("a/mesh.obj", triangle_obj);
    folder_.write("b/Mesh.OBJ", triangle_obj);
    write_gaussians(folder_ / "column.ply", two_gaussians);
    for (const char* name : {"smoke/s_1.csv", "smoke/s_2.csv", "smoke/s_3.csv"}) {
      write_gaussians(folder_ / name, two_gaussians);
    }
    ImageLayers sky;
    sky.width = sky.height = 1;
    for (const char* name : {"R", "G", "B"}) sky.channels[name] = {1.0f};
    write_exr(folder_ / "sky.exr", sky);
    scene_ = folder_.write_scene(
        "here.brume",
        R"("medium": { "file": "column.ply", "sequences": [ { "file": "smoke/s_%d.csv", "first": 1, "last": 2 } ] },
      "environment": { "file": "sky.exr" },
      "surfaces": [ { "mesh": "a/mesh.obj" }, { "mesh": "b/Mesh.OBJ" }, { "mesh": "a/mesh.obj" } ])");
  }

  fs::path scene_;
};

std::size_t entries(const fs::path& folder) {
  return static_cast<std::size_t>(
      std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

TEST_F(Gather, MakesARelocatableFolder) {
  const SceneDocument document = load_document(scene_);
  ASSERT_TRUE(gather_scene(document, folder_ / "out/", "scene"));
  fs::rename(folder_ / "out", folder_ / "moved");
  for (const char* gone : {"a", "b", "smoke", "column.ply", "sky.exr", "here.brume"}) {
    fs::remove_all(folder_ / gone);
  }
  const SceneDocument there = load_document(folder_ / "moved/scene.brume");
  const Scene& moved = there.scene;
  EXPECT_EQ(moved.medium.size(), 2u);
  EXPECT_NE(there.extras.medium_file, nullptr);
  ASSERT_EQ(moved.surfaces.size(), 3u);
  EXPECT_EQ(moved.surfaces[0].mesh_file.filename(), "mesh.obj");
  EXPECT_EQ(moved.surfaces[1].mesh_file.filename(), "Mesh_2.OBJ");
  EXPECT_EQ(moved.surfaces[0].mesh_file, moved.surfaces[2].mesh_file) << "copied once";
  const SequenceFrames& frames = *document.scene.sequences.at(0).frames;
  ASSERT_EQ(moved.sequences.at(0).frames->size(), frames.size());
  for (std::size_t i = 0; i < frames.size(); ++i) {
    EXPECT_EQ(*moved.sequences[0].frames->frame(i), *frames.frame(i));
  }
  EXPECT_EQ(entries(moved.sequences[0].file.parent_path()), 2u) << "not those of other frames";
  EXPECT_EQ(entries(folder_.path()), 1u) << "nothing else is left";
}

// An OBJ whose textures are beside it, elsewhere by a relative path, and elsewhere by an absolute
// one.
class GatherObj : public FolderTest {
 protected:
  GatherObj() {
    const std::string png = encode_png(1, 1, std::vector<std::uint8_t>{255, 0, 0});
    folder_.write("work/scene/own.png", png);
    folder_.write("work/maps/wood.png", png);
    folder_.write("private/metal.png", png);
    folder_.write("work/scene/a.obj",
                  "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nvt 0 0\nusemtl own\nf 1/1 2/1 3/1\n"
                  "usemtl wood\nf 1/1 3/1 2/1\nusemtl metal\nf 2/1 1/1 3/1\n");
    write_mtl("private/metal.png");
    scene_ = folder_.write_scene("work/scene/a.brume", R"("surfaces": [ { "file": "a.obj" } ])");
  }

  void write_mtl(const char* absolute) {
    folder_.write("work/scene/a.mtl",
                  "newmtl own\nmap_Kd own.png\nnewmtl wood\nmap_Kd ../maps/wood.png\n"
                  "newmtl metal\nmap_Kd " +
                      (folder_ / absolute).string() + "\n");
  }

  fs::path scene_;
};

TEST_F(GatherObj, TexturesOfAbsolutePathsAreFoundThere) {
  const SceneDocument document = load_document(scene_);
  EXPECT_EQ(files_outside(document, folder_ / "work/scene"),
            (std::vector<fs::path>{folder_ / "work/maps/wood.png", folder_ / "private/metal.png"}));
  EXPECT_TRUE(files_outside(document, folder_.path()).empty());
  ASSERT_TRUE(gather_scene(document, folder_ / "out", "scene"));
  fs::remove_all(folder_ / "work");
  fs::remove_all(folder_ / "private");
  std::vector<std::string> warnings;
  const Scene scene = load_scene(folder_ / "out/scene.brume", &warnings);
  EXPECT_TRUE(warnings.empty()) << warnings[0];
  const std::vector<fs::path>& files = scene.surfaces.at(0).imported->files;
  EXPECT_EQ(files.size(), 5u);
  for (const fs::path& file : files) {
    EXPECT_TRUE(file.string().starts_with((folder_ / "out/files/a").string())) << file;
  }
}

TEST_F(GatherObj, TwoOfOneNameAreRefused) {
  folder_.write("private/own.png", content_of(folder_ / "private/metal.png"));
  write_mtl("private/own.png");
  expect_error([&] { gather_scene(load_document(scene_), folder_ / "out", "scene"); },
               {(folder_ / "private/own.png").string(), "which have one name"});
}

TEST_F(Gather, LeavesNothingWhereItFails) {
  const SceneDocument document = load_document(scene_);
  fs::remove(folder_ / "smoke/s_2.csv");
  const std::size_t before = entries(folder_.path());
  expect_error([&] { gather_scene(document, folder_ / "out", "scene"); }, "s_2.csv");
  EXPECT_EQ(entries(folder_.path()), before);
  std::stop_source stop;
  stop.request_stop();
  EXPECT_FALSE(gather_scene(document, folder_ / "out", "scene", stop.get_token()));
  EXPECT_EQ(entries(folder_.path()), before);
  expect_error([&] { gather_scene(document, folder_ / "nowhere/out", "scene"); },
               "cannot be created");
}

TEST_F(Gather, ReplacesNothing) {
  const SceneDocument document = load_document(scene_);
  expect_error([&] { gather_scene(document, folder_ / "smoke", "scene"); }, "already exists");
  EXPECT_EQ(entries(folder_ / "smoke"), 3u);
  fs::create_directory(folder_ / "empty");
  EXPECT_TRUE(gather_scene(document, folder_ / "empty", "scene"));
  EXPECT_TRUE(fs::exists(folder_ / "empty/scene.brume"));
}

}  // namespace
}  // namespace brume
