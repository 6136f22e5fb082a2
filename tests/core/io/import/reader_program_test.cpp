#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>

#include "brume/mesh_arrays.h"
#include "core/io/image/image_file.h"
#include "core/io/import/imported_scene_file.h"
#include "core/math/normals.h"
#include "core/scene/mesh.h"
#include "tests/core/io/folder_test.h"
#include "tests/core/io/import/small_raw_scene.h"
#include "tests/core/io/input_error.h"

namespace brume {
namespace {

constexpr const char* two_squares = R"(mtllib my.mtl
o left
v 0 0 0
v 1 0 0
v 1 1 0
v 0 1 0
vt 0 0
vt 1 0
vt 1 1
vt 0 1
vn 0 0 1
usemtl painted
f 1/1/1 2/2/1 3/3/1 4/4/1
o right
v 2 0 0
v 3 0 0
v 3 1 0
usemtl shiny
f 5//1 6//1 7//1
)";

constexpr const char* two_materials = R"(newmtl painted
Kd 0.2 0.4 0.6
map_Kd paint.png
newmtl shiny
Kd 0.2 0.4 0.6
Ks 1 1 1
Ns 126
Ke 1 2 3
)";

class ReaderProgram : public FolderTest {
 protected:
  std::shared_ptr<const ImportedScene> read_scene(const char* name, const std::string& content) {
    return read_scene(folder_.write(name, content));
  }
  std::shared_ptr<const ImportedScene> read_scene(const std::filesystem::path& file) {
    warnings_.clear();
    return read_imported_scene(file, warnings_);
  }

  std::vector<std::string> warnings_;  // of the last one
};

TEST_F(ReaderProgram, ReadsObjWithItsMaterials) {
  const auto file = folder_.write("scene.obj", two_squares);
  folder_.write("my.mtl", two_materials);
  const std::vector<std::uint8_t> pixels(12, 255);
  folder_.write("paint.png", encode_png(2, 2, pixels));
  const auto scene = read_scene(file);
  EXPECT_TRUE(warnings_.empty());
  ASSERT_EQ(scene->parts.size(), 2u);
  EXPECT_EQ(scene->nodes[scene->parts[0].node].name, "left");
  const MeshArrays mesh = to_arrays(*scene->parts[0].mesh);
  ASSERT_EQ(mesh.points.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(mesh.texcoords[i], glm::vec2(mesh.points[i])) << "v is up";
  }
  EXPECT_EQ(scene->parts[0].material.name, "painted");
  EXPECT_EQ(scene->parts[1].material.name, "shiny");
  const MetallicRoughness& painted = scene->parts[0].material.metallic_roughness;
  EXPECT_EQ(painted.base_color, glm::dvec3(1.0)) << "the texture instead";
  EXPECT_EQ(painted.base_color_texture.file, folder_ / "paint.png");
  EXPECT_NE(painted.base_color_texture.content, nullptr);
  const MetallicRoughness& shiny = scene->parts[1].material.metallic_roughness;
  EXPECT_LT(glm::distance(shiny.base_color, {0.2, 0.4, 0.6}), 1e-6);
  EXPECT_EQ(shiny.metallic, 0.0);
  EXPECT_NEAR(shiny.roughness, std::pow(2.0 / 128.0, 0.25), 1e-6);
  EXPECT_LT(glm::distance(shiny.emissive, {1, 2, 3}), 1e-6);
  EXPECT_EQ(scene->files, (std::vector{file, folder_ / "my.mtl", folder_ / "paint.png"}));
}

// 3ds Max writes pi times the color that it shows as EmissiveColor, and exponents of Phong that are
// not those of its roughness.
TEST_F(ReaderProgram, ReadsPhysicalMaterialsOf3dsMax) {
  const auto read = [&](const std::string& properties) {
    const auto file = folder_.write("max.fbx", R"(; FBX 7.7.0 project file
FBXHeaderExtension:  {
	FBXVersion: 7700
}
Objects:  {
	Geometry: 1, "Geometry::", "Mesh" {
		Vertices: *9 {
			a: 0,0,0,1,0,0,0,1,0
		}
		PolygonVertexIndex: *3 {
			a: 0,1,-3
		}
		LayerElementMaterial: 0 {
			MappingInformationType: "AllSame"
			ReferenceInformationType: "IndexToDirect"
			Materials: *1 {
				a: 0
			}
		}
		Layer: 0 {
			LayerElement:  {
				Type: "LayerElementMaterial"
				TypedIndex: 0
			}
		}
	}
	Model: 2, "Model::Triangle", "Mesh" {
		Version: 232
	}
	Material: 3, "Material::Max", "" {
		Properties70:  {
			P: "EmissiveColor", "ColorRGB", "Color", "",3.14159,1.5708,0
			P: "SpecularColor", "ColorRGB", "Color", "",1,1,1
			P: "ShininessExponent", "double", "Number", "",1024
)" + properties + R"(
		}
	}
}
Connections:  {
	C: "OO",2,0
	C: "OO",1,2
	C: "OO",3,2
}
)");
    return read_scene(file)->parts.at(0).material.metallic_roughness;
  };
  const auto number = [](const std::string& name, const char* value) {
    return "P: \"3dsMax|main|" + name + "\", \"Float\", \"\", \"A\"," + value + "\n";
  };
  const MetallicRoughness metal =
      read(number("metalness", "0.25") + number("roughness", "0.5") +
           "P: \"3dsMax|main|emit_color\", \"ColorAndAlpha\", \"\", \"A\",1,0.5,0,1\n");
  EXPECT_EQ(metal.emissive, glm::dvec3(1.0, 0.5, 0.0));
  EXPECT_EQ(metal.metallic, 0.25);
  EXPECT_EQ(metal.roughness, 0.5);
  EXPECT_EQ(read(number("glossiness", "0.375")).roughness, 0.625);
  EXPECT_NEAR(read("").emissive.x, 3.14159, 1e-5) << "of another program";
}

TEST_F(ReaderProgram, MissingTexturesAreAWarning) {
  const auto file = folder_.write("scene.obj", two_squares);
  folder_.write("my.mtl", two_materials);
  const auto scene = read_scene(file);
  expect_only(warnings_, "paint.png is missing");
  EXPECT_EQ(scene->parts[0].material.metallic_roughness.base_color_texture.content, nullptr);
}

TEST_F(ReaderProgram, CoversConcavePolygons) {
  const std::string points = "v 2 0 0\nv 2 1 0\nv 1 1 0\nv 1 2 0\nv 0 2 0\nv 0 0 0\n";
  for (const char* face : {"f 1 2 3 4 5 6\n", "f 6 5 4 3 2 1\n", "f 4 5 6 1 2 3\nl 1 2\n"}) {
    const auto scene = read_scene("l.obj", points + face);
    const MeshArrays mesh = to_arrays(*scene->parts.at(0).mesh);
    double area = 0.0;
    for (const glm::uvec3& t : mesh.triangles) {
      area += 0.5 * glm::length(area_normal(mesh.points, t));
    }
    EXPECT_NEAR(area, 3.0, 1e-6) << face;
  }
}

TEST_F(ReaderProgram, ReadsLinesThatGoOn) {
  const auto scene =
      read_scene("a.obj", "v 0 0 0\nv 1 0 0\nv 1 \\\n1 0\nv 0 1 0\nf 1 2 \\\r\n3 4\n");
  EXPECT_EQ(to_arrays(*scene->parts.at(0).mesh).triangles.size(), 2u);
}

TEST_F(ReaderProgram, LeavesOutBadFacesOfObj) {
  const std::string good = "v 0 0 0\nv 1 0 0\nv 1 1 0\nvt 0 0\nvn 0 0 1\nf 1/1/1 2/1/1 3/1/1\n";
  for (const char* bad : {"f 1 2 4", "f 0 1 2", "f -1 -2 -4", "f 1/1 2/1 \\\n9/1",
                          "f 9 8 7 # l 1 99\nl 1 99\np 99"}) {
    SCOPED_TRACE(bad);
    const auto file = folder_.write("a.obj", good + bad + "\nf 3/1/1 2/1/1 1/1/1\n");
    const auto scene = read_scene(file);
    EXPECT_EQ(to_arrays(*scene->parts.at(0).mesh).triangles.size(), 2u);
    expect_only(warnings_, file.string() + ": line 7: found a face");
  }
  const auto scene = read_scene("a.obj", good + "f 3/7/1 2/1/9 1/1/1\n");
  EXPECT_EQ(to_arrays(*scene->parts.at(0).mesh).triangles.size(), 2u)
      << "without texture coordinates";
  EXPECT_TRUE(warnings_.empty());
}

TEST_F(ReaderProgram, DamagedFilesAreAnError) {
  for (const auto& [name, content] :
       {std::pair("a.obj", "f 1 2 3\n"), std::pair("a.fbx", "f 1 2 3\n"),
        std::pair("a.fbx", "Kaydara FBX Binary  \x00\x1a\x00garbage")}) {
    const auto file = folder_.write(name, content);
    const std::string error = error_of([&] { read_scene(file); });
    EXPECT_TRUE(error.starts_with(file.string() + ": cannot be read")) << error;
  }
  expect_error([&] { read_scene(folder_ / "b.fbx"); }, "no such file");
}

TEST_F(ReaderProgram, SaysWhatAnObjWithoutFacesHas) {
  const auto error = [&](const char* name, const char* content) {
    const auto file = folder_.write(name, content);
    return error_of([&] { read_scene(file); }).substr(file.string().size());
  };
  EXPECT_EQ(error("a.obj", ""), ": is empty");
  EXPECT_EQ(error("a.fbx", ""), ": is empty");
  EXPECT_EQ(error("a.obj", "# nothing\n\nmtllib a.mtl\n"),
            ": the mesh has no faces and no vertices");
  EXPECT_EQ(error("a.obj", "v 0 0 0\nv 1 0 0\nl 1 2\np 1\np 2\n"),
            ": the mesh has no faces, only vertices (2), lines (1), points (2)");
}

// Windows' editors and PowerShell write it so.
TEST_F(ReaderProgram, ReadsObjInUtf16) {
  const auto utf16 = [](const std::string& text, bool is_big_endian) {
    std::string bytes = is_big_endian ? "\xfe\xff" : "\xff\xfe";
    for (const char c : text) {
      bytes += is_big_endian ? '\0' : c;
      bytes += is_big_endian ? c : '\0';
    }
    return bytes;
  };
  for (const bool is_big_endian : {false, true}) {
    const auto file = folder_.write("scene.obj", utf16(two_squares, is_big_endian));
    folder_.write("my.mtl", utf16("newmtl shiny\nKd 0.5 0.25 1\nnewmtl painted\n", is_big_endian));
    const auto scene = read_scene(file);
    ASSERT_EQ(scene->parts.size(), 2u);
    EXPECT_EQ(scene->parts[1].material.metallic_roughness.base_color, glm::dvec3(0.5, 0.25, 1));
    EXPECT_TRUE(obj_has_materials(file));
  }
}

TEST_F(ReaderProgram, MaterialsThatAreNotOpaqueBlend) {
  const auto file = folder_.write("scene.obj", two_squares);
  folder_.write("my.mtl", "newmtl painted\nTr 0.25\nnewmtl shiny\nd 0.25\n");
  const auto scene = read_scene(file);
  EXPECT_TRUE(warnings_.empty());
  ASSERT_EQ(scene->parts.size(), 2u);
  std::vector<double> opacities;
  for (const ImportedPart& part : scene->parts) {
    EXPECT_EQ(part.material.metallic_roughness.alpha, AlphaMode::blend);
    opacities.push_back(part.material.metallic_roughness.opacity);
  }
  std::ranges::sort(opacities);
  EXPECT_EQ(opacities, (std::vector{0.25, 0.75}));
}

TEST_F(ReaderProgram, StopsWhenAsked) {
  const auto file = folder_.write("scene.obj", two_squares);
  std::stop_source source;
  source.request_stop();
  EXPECT_EQ(read_imported_scene(file, warnings_, source.get_token()), nullptr);
}

TEST(RawSceneBytes, RoundTrip) {
  const std::string bytes = bytes_of(small_scene());
  const RawScene again = read_raw_scene("a.obj", bytes);
  EXPECT_EQ(bytes_of(again), bytes);
  EXPECT_EQ(again.nodes[1].parent, 0u);
  EXPECT_EQ(again.lights, small_scene().lights);
  EXPECT_EQ(again.parts[0].mesh, small_scene().parts[0].mesh);
}

// A hostile program may send anything.
TEST(RawSceneBytes, OthersAreRefusedOrValid) {
  const std::string bytes = bytes_of(small_scene());
  const auto read = [](const std::string& changed) {
    const RawScene scene = read_raw_scene("a.obj", changed);
    for (const RawPart& part : scene.parts) {
      ASSERT_LT(part.node, scene.nodes.size());
      ASSERT_LT(part.material, scene.materials.size());
    }
  };
  expect_truncations_refused(bytes, read);
  refused_damages(bytes, read);
}

}  // namespace
}  // namespace brume
