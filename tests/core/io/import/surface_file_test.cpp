// Surfaces whose meshes and materials are those of another program's scene.

#include <gtest/gtest.h>

#include <algorithm>

#include "brume/at_time.h"
#include "brume/mesh_arrays.h"
#include "core/io/image/image_file.h"
#include "core/io/scene/gather.h"
#include "core/io/scene/missing_files.h"
#include "core/io/scene/scene_file.h"
#include "core/io/scene/scene_files.h"
#include "core/scene/imported_scene.h"
#include "core/scene/mesh.h"
#include "tests/core/io/folder_test.h"
#include "tests/core/io/import/gltf_builder.h"
#include "tests/core/io/input_error.h"

namespace brume {
namespace {

namespace fs = std::filesystem;

class SurfaceFile : public FolderTest {
 protected:
  // A tree of two squares below `house`, and one beside it; one has a texture outside its folder.
  SurfaceFile() {
    GltfBuilder builder;
    builder.json["scenes"][0]["nodes"] = {0, 3};
    builder.json["nodes"] = {{{"name", "house"}, {"children", {1, 2}}},
                             {{"name", "wall"}, {"mesh", 0}},
                             {{"name", "roof"}, {"mesh", 0}, {"translation", {0, 5, 0}}},
                             {{"name", "tree"}, {"mesh", 0}, {"translation", {9, 0, 0}}}};
    builder.json["images"] = {{{"uri", "../textures/t.png"}}};
    builder.json["textures"] = {{{"source", 0}}};
    builder.json["materials"] = {
        {{"pbrMetallicRoughness",
          {{"baseColorFactor", {0.5, 0.25, 1, 1}}, {"baseColorTexture", {{"index", 0}}}}}}};
    builder.primitive()["material"] = 0;
    folder_.write("model/town.bin", builder.buffer());
    folder_.write("model/town.gltf", builder.text("town.bin"));
    folder_.write("textures/t.png", encode_png(1, 1, std::vector<std::uint8_t>{255, 0, 0}));
  }

  fs::path write(const std::string& surface) {
    return folder_.write("scene.brume", R"({ "format": "brume-scene", "version": 1,
      "surfaces": [ { )" + surface + " } ] }");
  }
  std::vector<Surface> shown(const std::string& surface) {
    return evaluate_at(load_scene(write(surface)), 0.0).surfaces;
  }
};

std::vector<std::string> names(const std::vector<Surface>& surfaces) {
  std::vector<std::string> result;
  for (const Surface& surface : surfaces) result.push_back(surface.name);
  return result;
}

TEST_F(SurfaceFile, IsShownInParts) {
  const Scene scene = evaluate_at(
      load_scene(write(
          R"("name": "town", "file": "model/town.gltf", "translate": [1, 2, 3], "scale": 2)")),
      0.0);
  const std::vector<Surface>& parts = scene.surfaces;
  EXPECT_EQ(names(parts), (std::vector<std::string>{"town/wall", "town/roof", "town/tree"}));
  EXPECT_EQ(world_points(parts[1])[0], glm::dvec3(1, 12, 3));
  EXPECT_EQ(parts[0].material.metallic_roughness.base_color, glm::dvec3(0.5, 0.25, 1));
  EXPECT_NE(parts[0].material.metallic_roughness.base_color_texture.content, nullptr);
  for (const Surface& part : parts) EXPECT_EQ(part.imported, nullptr);
  EXPECT_EQ(evaluate_at(scene, 0.0).surfaces, parts) << "they are as they are";
}

TEST_F(SurfaceFile, NamesAreNotDoubled) {
  EXPECT_EQ(names(shown(R"("name": "house", "file": "model/town.gltf", "nodes": ["house"])")),
            (std::vector<std::string>{"house/wall", "house/roof"}));
  EXPECT_EQ(names(shown(R"("name": "tree", "file": "model/town.gltf", "nodes": ["tree"])")),
            (std::vector<std::string>{"tree"}));
  GltfBuilder builder;
  builder.json["nodes"][0].erase("name");
  builder.json["meshes"][0]["name"] = "table";
  folder_.write("a.glb", builder.binary());
  EXPECT_EQ(names(shown(R"("file": "a.glb")")), std::vector<std::string>{"table"});
  EXPECT_EQ(names(shown(R"("file": "a.glb", "nodes": ["node 0"])")),
            std::vector<std::string>{"table"});
}

TEST_F(SurfaceFile, NodesAreChosenWithWhatIsBelowThem) {
  EXPECT_EQ(names(shown(R"("file": "model/town.gltf", "nodes": ["house"])")),
            (std::vector<std::string>{"wall", "roof"}));
  EXPECT_EQ(names(shown(R"("file": "model/town.gltf", "nodes": ["tree", "wall"])")),
            (std::vector<std::string>{"wall", "tree"}));
  EXPECT_TRUE(shown(R"("file": "model/town.gltf", "visible": false)").empty());
}

// Picking, bounds and snapping ask it.
TEST_F(SurfaceFile, HasAllChosenPartsAsOneMesh) {
  const Scene scene = load_scene(write(R"("file": "model/town.gltf", "nodes": ["house"])"));
  const TriangleMesh& mesh = *scene.surfaces[0].mesh;
  EXPECT_EQ(mesh.n_faces(), 4u);
  EXPECT_EQ(box_of(mesh).high, glm::dvec3(1, 6, 0));
}

TEST_F(SurfaceFile, IsSavedAsItWas) {
  const SceneDocument document = load_document(
      write(R"("file": "model/town.gltf", "nodes": ["house"], "material": { "x": 1 })"));
  save_document(document, folder_ / "again.brume");
  const std::string text = content_of(folder_ / "again.brume");
  EXPECT_TRUE(contains(text, R"("file": "model/town.gltf")", R"("nodes": ["house"])",
                       R"("material": { "x": 1 })"));
  EXPECT_FALSE(contains(text, "\"mesh\""));
  save_document(load_document(folder_ / "again.brume"), folder_ / "third.brume");
  EXPECT_EQ(content_of(folder_ / "third.brume"), text);
}

TEST_F(SurfaceFile, MaterialsTakeThePlaceOfThoseOfItsFile) {
  const std::string town = R"("file": "model/town.gltf", "materials": [ { "name": "material 0", )";
  const std::vector<Surface> parts =
      shown(town + R"("type": "metallic_roughness", "base_color": [1, 0, 0] } ])");
  ASSERT_EQ(parts.size(), 3u);
  for (const Surface& part : parts) {
    EXPECT_EQ(part.material.metallic_roughness.base_color, glm::dvec3(1, 0, 0));
    EXPECT_NE(part.material.metallic_roughness.base_color_texture.content, nullptr)
        << "textures stay";
    EXPECT_TRUE(part.materials.empty());
  }
  const Material green =
      shown(town + R"("type": "diffuse", "reflectance": [0, 1, 0] } ])")[0].material;
  EXPECT_EQ(green.type, Material::Type::diffuse);
  EXPECT_EQ(green.reflectance, glm::dvec3(0, 1, 0));
  const std::string removed =
      town + R"("type": "metallic_roughness", "base_color_texture": {}, "x": 1 } ])";
  EXPECT_EQ(shown(removed)[0].material.metallic_roughness.base_color_texture, TextureReference());

  save_document(load_document(write(removed)), folder_ / "again.brume");
  const std::string text = content_of(folder_ / "again.brume");
  EXPECT_TRUE(contains(text, R"("base_color_texture": {})", R"("x": 1)"));
  EXPECT_EQ(load_scene(folder_ / "again.brume").surfaces[0].materials,
            load_scene(write(removed)).surfaces[0].materials);
  save_document(load_document(write(town + R"("type": "metallic_roughness" } ])")),
                folder_ / "again.brume");
  EXPECT_FALSE(contains(content_of(folder_ / "again.brume"), "texture"));
}

// They were copied twice; one within a GLB named the GLB as an image.
TEST_F(SurfaceFile, MaterialsAreGatheredWithoutTheTexturesOfTheirFile) {
  const fs::path file = write(R"("file": "model/town.gltf", "materials": [ { "name": "material 0",
      "type": "metallic_roughness", "base_color": [1, 0, 0] } ])");
  const fs::path gathered = folder_ / "gathered";
  ASSERT_TRUE(gather_scene(load_document(file), gathered, "scene"));
  EXPECT_FALSE(contains(content_of(gathered / "scene.brume"), "texture"));
  const Scene scene = load_scene(gathered / "scene.brume");
  EXPECT_NE(scene.surfaces[0].materials[0].metallic_roughness.base_color_texture.content, nullptr);
}

// A file that changed may lack a material or its image; what was saved of it is still read.
TEST_F(SurfaceFile, TexturesAreRemovedWhetherTheFileHasThemOrNot) {
  for (const std::string name : {"material 0", "brick"}) {
    const std::string material = R"("file": "model/town.gltf", "materials": [ { "name": ")" + name +
                                 R"(", "type": "metallic_roughness", "normal_texture": )";
    EXPECT_EQ(load_scene(write(material + "{} } ]")).surfaces[0].materials.size(), 1u) << name;
    const std::string error =
        error_of([&] { (void)load_scene(write(material + R"({"wrap_u": "clamp"} } ])")); });
    EXPECT_TRUE(contains(error, "normal_texture.file: missing")) << error;
  }
}

TEST_F(SurfaceFile, AMaterialThatItsFileLacksIsWarnedOf) {
  std::vector<std::string> warnings;
  const fs::path file = write(
      R"("file": "model/town.gltf", "materials": [ { "name": "brick", "type": "diffuse" } ])");
  EXPECT_EQ(load_scene(file, &warnings).surfaces[0].materials.size(), 1u);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_TRUE(
      contains(warnings[0], "surfaces[].materials[].name", "no material brick in town.gltf"));
}

TEST_F(SurfaceFile, OneFileIsReadOnce) {
  const Scene scene = load_scene(write(
      R"("file": "model/town.gltf", "nodes": ["tree"] }, { "file": "model/../model/town.gltf")"));
  EXPECT_EQ(scene.surfaces[0].imported, scene.surfaces[1].imported);
}

TEST_F(SurfaceFile, MistakesAreNamed) {
  const auto error = [this](const std::string& surface) {
    return error_of([&] { load_scene(write(surface)); });
  };
  const std::string scene = (folder_ / "scene.brume").string() + ": surfaces[0].";
  for (const auto& [surface, place, said] : std::vector<std::array<std::string, 3>>{
           {R"("file": "model/town.gltf", "nodes": ["hose"])", "nodes[0]",
            "found hose; allowed: a node of"},
           {R"("file": "model/town.gltf", "nodes": [1])", "nodes[0]", "found 1; allowed: a name"},
           {R"("file": "model/town.gltf", "nodes": [""])", "nodes[0]", "allowed: a name"},
           {R"("file": "model/town.gltf", "nodes": [])", "nodes", "at least one"},
           {R"("file": "model/town.gltf", "nodes": "house")", "nodes", "allowed: an array"},
           {R"("file": "model/town.gltf", "materials": [{}])", "materials[0].name", "missing"},
           {R"("file": "model/town.gltf", "materials": [{"name": "a"}, {"name": "a"}])",
            "materials[1].name", "found a twice; allowed: once"},
           {R"("file": "model/town.gltf", "mesh": "a.obj")", "mesh", "besides file"},
           {R"("file": "model/town.gltf", "primitive": { "type": "box" })", "file",
            "besides primitive"},
           {R"("file": 3)", "file", "a string"},
           {R"("file": "model/none.gltf")", "file", "no such file"},
           {R"("file": "model/town.bin")", "file", "allowed: .gltf, .glb, .obj, .fbx"}}) {
    const std::string text = error(surface);
    EXPECT_TRUE(text.starts_with(scene + place + ":")) << text;
    EXPECT_TRUE(contains(text, said));
  }
}

TEST_F(SurfaceFile, OfPointsAndLinesAloneIsRefusedWithItsName) {
  GltfBuilder builder;
  builder.primitive()["mode"] = 1;
  const fs::path lines = folder_.write("lines.glb", builder.binary());
  const std::string left_out =
      "surfaces[0].file: " + lines.string() + ": meshes[0].primitives[0]: found ";
  expect_error([&] { load_scene(write(R"("file": "lines.glb")")); },
               left_out + "lines, and no triangles anywhere");
  builder.primitive()["mode"] = 0;
  folder_.write("lines.glb", builder.binary());
  expect_error([&] { load_scene(write(R"("file": "lines.glb")")); },
               left_out + "points, and no triangles anywhere");
  builder.json["nodes"][0].erase("mesh");
  folder_.write("lines.glb", builder.binary());
  expect_error([&] { load_scene(write(R"("file": "lines.glb")")); },
               "surfaces[0].file: " + lines.string() + ": has no triangles");
}

TEST_F(SurfaceFile, WarnsOfWhatIsMissingInIt) {
  fs::remove(folder_ / "textures/t.png");
  std::vector<std::string> warnings;
  const fs::path file = write(R"("file": "model/town.gltf")");
  load_scene(file, &warnings);
  expect_only(warnings, "surfaces[].file: ");
  EXPECT_TRUE(contains(warnings[0], "textures/t.png is missing"));
}

TEST_F(SurfaceFile, MayBeMissingAsAWhole) {
  MissingFiles missing;
  const SceneDocument document =
      load_document(write(R"("file": "model/gone.glb", "nodes": ["any"])"), nullptr, missing);
  EXPECT_EQ(missing.missing, std::vector{folder_ / "model/gone.glb"});
  save_document(document, folder_ / "again.brume");
  const std::string text = content_of(folder_ / "again.brume");
  EXPECT_TRUE(contains(text, R"("file": "model/gone.glb")", R"("nodes": ["any"])"));
}

TEST_F(SurfaceFile, IsGatheredWithItsFiles) {
  const SceneDocument document = load_document(
      write(R"("file": "model/town.gltf" }, { "file": "model/town.gltf", "nodes": ["tree"])"));
  const std::vector<fs::path> files = files_of(document);
  for (const char* name : {"model/town.gltf", "model/town.bin", "textures/t.png"}) {
    EXPECT_EQ(std::ranges::count(files, folder_ / name), 2) << name;
  }
  ASSERT_TRUE(gather_scene(document, folder_ / "out", "scene"));
  fs::rename(folder_ / "out", folder_ / "moved");
  fs::remove_all(folder_ / "model");
  fs::remove_all(folder_ / "textures");
  std::vector<std::string> warnings;
  const Scene scene = load_scene(folder_ / "moved/scene.brume", &warnings);
  EXPECT_TRUE(warnings.empty()) << warnings.front();
  EXPECT_EQ(scene.surfaces[0].mesh_file, scene.surfaces[1].mesh_file);
  EXPECT_EQ(scene.surfaces[0].imported->files.size(), 3u);
}

}  // namespace
}  // namespace brume
