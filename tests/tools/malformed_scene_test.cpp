#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>

#include "brume/error.h"
#include "core/io/image/image_file.h"
#include "core/io/scene/scene_file.h"
#include "core/scene/animation/animation.h"
#include "core/scene/fields/copies_fields.h"
#include "tests/contains.h"
#include "tests/tools/malformed_fields.h"
#include "tests/tools/malformed_scenes.h"
#include "tests/tools/run_program.h"

namespace brume {
namespace {

class MalformedScene : public ::testing::Test {
 protected:
  MalformedScene() {
    const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    write("good.obj", triangle + "f 1 2 3\n");
    write("empty", "");
    write("good.ies", "TILT=NONE\n1 -1 1 2 1 1 2 0 0 0\n1 1 60\n0 30\n0\n100 0\n");
    const std::string header =
        "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\n"
        "property float z\nproperty float radius\nproperty float density\nend_header\n";
    write("nan.ply", header + "0 0 0 1 1\n0 nan 0 1 1\n");
    write("huge.ply", "ply\nformat binary_little_endian 1.0\nelement vertex 9999999\n" +
                          header.substr(header.find("property")));
    write("mesh.ply",
          "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
          "property float z\nend_header\n0 0 0\n");
    const std::int32_t dims[3] = {90, 90, 180};
    write("short.binary", std::string(reinterpret_cast<const char*>(dims), 12) + "rest");
    write("not.exr", "I am a text");
    write("magic.exr", std::string("\x76\x2f\x31\x01\x02\0\0\0", 8) + std::string(64, '\x7f'));
    ImageLayers sky;
    sky.width = sky.height = 1;
    sky.channels = {{"R", {1.0f}}, {"G", {1.0f}}, {"B", {1.0f}}};
    write_exr(folder_ / "scene/sky.exr", sky);
    ImageLayers depth;
    depth.width = depth.height = 1;
    depth.channels["Z"] = {1.0f};
    write_exr(folder_ / "scene/depth.exr", depth);
    std::filesystem::create_directory(folder_ / "scene/folder");
    std::filesystem::create_symlink("loop.obj", folder_ / "scene/loop.obj");
    std::filesystem::create_symlink("scene.brume", folder_ / "scene/self.obj");
  }

  void write(const char* name, const std::string& content) const {
    folder_.write(std::string("scene/") + name, content);
  }

  // One line that names the file, the place and what is wrong.
  static void expect_names(const std::string& message, const std::string& scene,
                           const MalformedCase& expected) {
    EXPECT_EQ(std::ranges::count(message, '\n'), 0) << message;
    EXPECT_LT(message.size(), 6000u);
    EXPECT_TRUE(message.starts_with(scene + ": ")) << message;
    EXPECT_TRUE(contains(message, expected.place)) << expected.place << " in " << message;
    for (const std::string& part : expected.said) {
      EXPECT_TRUE(contains(message, part)) << part << " in " << message;
    }
  }

  // One by the program, which writes nothing; all of them, hundreds, by what it reads scenes with.
  void expect_each_refused(const std::vector<MalformedCase>& all, std::size_t at_least = 1) const {
    ASSERT_GE(all.size(), at_least);
    const std::string scene = (folder_ / "scene/scene.brume").string();
    write("scene.brume", "");
    const std::size_t entries = folder_.entry_count();
    write("scene.brume", all.front().text);
    const ProgramResult result = run_brume({"render", scene, "-o", (folder_ / "o.exr").string(),
                                            "--stats", (folder_ / "s.json").string()});
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_EQ(result.out, "");
    const std::string before = "brume: error: ";
    ASSERT_TRUE(result.err.starts_with(before) && result.err.ends_with('\n')) << result.err;
    expect_names(result.err.substr(before.size(), result.err.size() - before.size() - 1), scene,
                 all.front());
    EXPECT_EQ(folder_.entry_count(), entries) << "something was written";
    for (const MalformedCase& refused : all) {
      SCOPED_TRACE(refused.name);
      write("scene.brume", refused.text);
      try {
        load_scene(scene);
        ADD_FAILURE() << "not refused";
      } catch (const InputError& error) {
        expect_names(error.what(), scene, refused);
      }
    }
  }

  TemporaryFolder folder_;
};

TEST_F(MalformedScene, BaseSceneIsValid) {
  write("scene.brume", good_scene());
  const ProgramResult result = run_brume(
      {"render", (folder_ / "scene/scene.brume").string(), "-o", (folder_ / "o.exr").string()});
  EXPECT_EQ(result.exit_code, 0) << result.err;
}

TEST_F(MalformedScene, EachCaseIsRefusedInOneLine) {
  expect_each_refused(malformed_cases(), 80);
}

TEST_F(MalformedScene, EachValueOfACameraIsRefusedInOneLine) {
  expect_each_refused(malformed_fields<Camera>("camera", scene_with_camera), 100);
}

TEST_F(MalformedScene, EachValueOfTheMediumAndTheEnvironmentIsRefusedInOneLine) {
  expect_each_refused(malformed_fields<MediumOptics>("medium", scene_with_medium));
  expect_each_refused(malformed_fields<Noise>("medium.noise", [](const std::string& members) {
    return scene_with_medium("\"noise\": {" + members + "}");
  }));
  expect_each_refused(malformed_fields<Environment>("environment", scene_with_environment));
  expect_each_refused(malformed_fields<Sky>("environment.sky", scene_with_sky));
}

TEST_F(MalformedScene, EachValueOfAMaterialIsRefusedInOneLine) {
  expect_each_refused(
      malformed_fields<MetallicRoughness>("surfaces[1].material", [](const std::string& members) {
        return scene_with_surface(R"("mesh": "good.obj", "material": {
            "type": "metallic_roughness", )" +
                                  members + "}");
      }));
}

TEST_F(MalformedScene, EachValueOfScatteredCopiesIsRefusedInOneLine) {
  expect_each_refused(
      malformed_fields<Scatter>("surfaces[1].copies", [](const std::string& members) {
        return scene_with_surface(R"("mesh": "good.obj", "copies": { "over": "good", )" + members +
                                  "}");
      }));
}

TEST_F(MalformedScene, EachValueOfALightIsRefusedInOneLine) {
  expect_each_refused(malformed_lights(), 200);
}

TEST_F(MalformedScene, EachValueOfAnEmitterIsRefusedInOneLine) {
  expect_each_refused(malformed_fields<Emitter>("medium.emitters[0]", scene_with_emitter), 140);
}

TEST_F(MalformedScene, EachValueOfAPrimitiveIsRefusedInOneLine) {
  expect_each_refused(malformed_primitives(), 20);
}

TEST_F(MalformedScene, EachValueOfAGroupIsRefusedInOneLine) {
  expect_each_refused(malformed_groups(), 90);
}

TEST_F(MalformedScene, EachValueOfAKeyframeIsRefusedInOneLine) {
  expect_each_refused(malformed_keys(), 60);
}

TEST_F(MalformedScene, EachValueOfASplineIsRefusedInOneLine) {
  expect_each_refused(malformed_splines(), 80);
}

TEST_F(MalformedScene, RefusesFoldersAndDevices) {
  const std::string out = (folder_ / "o.exr").string();
  for (const std::string& scene :
       {(folder_ / "none.brume").string(), folder_.path().string(), std::string("/dev/null"),
        (folder_ / "scene/loop.obj").string(), (folder_ / "bad\nname.brume").string()}) {
    SCOPED_TRACE(scene);
    const ProgramResult result = run_brume({"render", scene, "-o", out});
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
    EXPECT_FALSE(std::filesystem::exists(out));
  }
}

TEST_F(MalformedScene, PreservesTheOldOutput) {
  write("scene.brume", "{");
  folder_.write("o.exr", "old");
  EXPECT_EQ(run_brume({"render", (folder_ / "scene/scene.brume").string(), "-o",
                       (folder_ / "o.exr").string()})
                .exit_code,
            2);
  EXPECT_EQ(content_of(folder_ / "o.exr"), "old");
}

TEST_F(MalformedScene, RefusesHugeFilesUnread) {
  const auto scene = folder_.write("scene/scene.brume", "{");
  std::filesystem::resize_file(scene, (std::uintmax_t{1} << 30) + 1);  // takes no space on disk
  const ProgramResult result =
      run_brume({"render", scene.string(), "-o", (folder_ / "o.exr").string()});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_TRUE(contains(result.err, "1073741824"));
}

}  // namespace
}  // namespace brume
