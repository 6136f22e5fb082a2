// FBX scenes besides shapes and materials: colors, texture coordinates, animations.

#include <gtest/gtest.h>

#include <array>
#include <glm/geometric.hpp>
#include <initializer_list>
#include <numbers>
#include <span>
#include <string>
#include <vector>

#include "brume/mesh_arrays.h"
#include "brume/surface.h"
#include "core/io/image/image_file.h"
#include "core/io/import/imported_scene_file.h"
#include "core/math/srgb.h"
#include "core/scene/imported_scene.h"
#include "tests/core/io/temporary_folder.h"

namespace brume {
namespace {

// A square whose node moves from (1, 2, 3) to (5, 2, 3) in a second; its texture is looked up by
// the second set of texture coordinates.
constexpr const char* moving_square = R"(; FBX 7.4.0 project file
FBXHeaderExtension:  {
	FBXVersion: 7400
}
GlobalSettings:  {
	Properties70:  {
		P: "UpAxis", "int", "Integer", "",1
		P: "UpAxisSign", "int", "Integer", "",1
		P: "FrontAxis", "int", "Integer", "",2
		P: "FrontAxisSign", "int", "Integer", "",1
		P: "CoordAxis", "int", "Integer", "",0
		P: "CoordAxisSign", "int", "Integer", "",1
		P: "UnitScaleFactor", "double", "Number", "",100
		P: "TimeMode", "enum", "", "",6
	}
}
Objects:  {
	Geometry: 100, "Geometry::quad", "Mesh" {
		Vertices: *12 {
			a: 0,0,0,1,0,0,1,1,0,0,1,0
		}
		PolygonVertexIndex: *4 {
			a: 0,1,2,-4
		}
		LayerElementColor: 0 {
			Name: "Col"
			MappingInformationType: "ByPolygonVertex"
			ReferenceInformationType: "Direct"
			Colors: *16 {
				a: 1,0,0,1,0,1,0,1,0,0,1,1,0.5,0.5,0.5,1
			}
		}
		LayerElementUV: 0 {
			Name: "first"
			MappingInformationType: "ByPolygonVertex"
			ReferenceInformationType: "Direct"
			UV: *8 {
				a: 0,0,1,0,1,1,0,1
			}
		}
		LayerElementUV: 1 {
			Name: "second"
			MappingInformationType: "ByPolygonVertex"
			ReferenceInformationType: "Direct"
			UV: *8 {
				a: 0,0,4,0,4,4,0,4
			}
		}
		LayerElementMaterial: 0 {
			Name: ""
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
			LayerElement:  {
				Type: "LayerElementColor"
				TypedIndex: 0
			}
			LayerElement:  {
				Type: "LayerElementUV"
				TypedIndex: 0
			}
		}
		Layer: 1 {
			LayerElement:  {
				Type: "LayerElementUV"
				TypedIndex: 1
			}
		}
	}
	Model: 200, "Model::mover", "Mesh" {
		Properties70:  {
			P: "Lcl Translation", "Lcl Translation", "", "A",1,2,3
		}
	}
	Material: 300, "Material::paint", "" {
		ShadingModel: "phong"
		Properties70:  {
			P: "DiffuseColor", "Color", "", "A",0.8,0.8,0.8
		}
	}
	Texture: 600, "Texture::picture", "" {
		Type: "TextureVideoClip"
		TextureName: "Texture::picture"
		FileName: "picture.png"
		RelativeFilename: "picture.png"
		Properties70:  {
			P: "UVSet", "KString", "", "", "second"
		}
	}
	AnimationStack: 400, "AnimStack::take", "" {
		Properties70:  {
			P: "LocalStop", "KTime", "Time", "",46186158000
		}
	}
	AnimationLayer: 401, "AnimLayer::base", "" {
	}
	AnimationCurveNode: 402, "AnimCurveNode::T", "" {
		Properties70:  {
			P: "d|X", "Number", "", "A",1
			P: "d|Y", "Number", "", "A",2
			P: "d|Z", "Number", "", "A",3
		}
	}
	AnimationCurve: 500, "AnimCurve::", "" {
		KeyVer: 4008
		KeyTime: *2 {
			a: 0,46186158000
		}
		KeyValueFloat: *2 {
			a: 1,5
		}
		KeyAttrFlags: *1 {
			a: 24836
		}
		KeyAttrDataFloat: *4 {
			a: 0,0,0,0
		}
		KeyAttrRefCount: *1 {
			a: 2
		}
	}
}
Connections:  {
	C: "OO",200,0
	C: "OO",100,200
	C: "OO",300,200
	C: "OP",600,300, "DiffuseColor"
	C: "OO",401,400
	C: "OO",402,401
	C: "OP",402,200, "Lcl Translation"
	C: "OP",500,402, "d|X"
}
)";

TEST(FbxScene, HasColorsSecondTexcoordsAndAnimations) {
  const TemporaryFolder folder;
  const std::array<std::uint8_t, 12> pixels{};
  folder.write("picture.png", encode_png(2, 2, pixels));
  std::vector<std::string> warnings;
  const auto scene = read_imported_scene(folder.write("a.fbx", moving_square), warnings);
  EXPECT_TRUE(warnings.empty());
  const ImportedPart& part = scene->parts.at(0);
  const MeshArrays& mesh = to_arrays(*part.mesh);
  ASSERT_EQ(mesh.colors.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) {
    const glm::vec2 corner(mesh.points[i]);
    EXPECT_EQ(mesh.texcoords.at(i), 4.0f * corner) << "those that the material's texture uses";
    if (corner == glm::vec2(0.0f, 1.0f)) {
      EXPECT_NEAR(mesh.colors[i].r, srgb_decoded(0.5), 1e-6);
    }
  }
  const Keys<glm::dvec3>& keys = part.keys.translate;
  ASSERT_GE(keys.size(), 2u);
  const auto expect_near = [&](double time, const glm::dvec3& place) {
    EXPECT_LT(glm::distance(value_at(keys, time), place), 5e-3) << time;
  };
  expect_near(0.0, {1, 2, 3});
  expect_near(1.0, {5, 2, 3});
  EXPECT_EQ(part.keys.rotate.size(), 1u);
}

// A bone along y moves the upper corners of the square.
TEST(FbxScene, SkinsMoveWithTheirBones) {
  std::string text = moving_square;
  const auto insert = [&](const std::string& before, const std::string& added) {
    text.insert(text.find(before), added);
  };
  insert("\tMaterial: 300", R"(	Model: 210, "Model::bone", "LimbNode" {
		Properties70:  {
			P: "Lcl Translation", "Lcl Translation", "", "A",1,2,3
		}
	}
	NodeAttribute: 211, "NodeAttribute::bone", "LimbNode" {
		TypeFlags: "Skeleton"
	}
	Deformer: 700, "Deformer::skin", "Skin" {
		Version: 101
	}
	Deformer: 701, "SubDeformer::bone", "Cluster" {
		Version: 100
		Indexes: *2 {
			a: 2,3
		}
		Weights: *2 {
			a: 1,1
		}
		Transform: *16 {
			a: 1,0,0,0,0,1,0,0,0,0,1,0,-1,-2,-3,1
		}
		TransformLink: *16 {
			a: 1,0,0,0,0,1,0,0,0,0,1,0,1,2,3,1
		}
	}
)");
  // The bone moves in place of the mesh, which stands at the origin.
  text.replace(text.find("\tC: \"OP\",402,200"), 16, "\tC: \"OP\",402,210");
  text.replace(text.find("\"A\",1,2,3"), 9, "\"A\",0,0,0");
  text.insert(text.rfind('}'), R"(	C: "OO",210,0
	C: "OO",211,210
	C: "OO",700,100
	C: "OO",701,700
	C: "OO",210,701
)");
  const TemporaryFolder folder;
  folder.write("picture.png", encode_png(2, 2, std::array<std::uint8_t, 12>{}));
  std::vector<std::string> warnings;
  Surface surface;
  surface.imported = read_imported_scene(folder.write("a.fbx", text), warnings);
  ASSERT_EQ(surface.imported->parts.size(), 1u);
  ASSERT_TRUE(surface.imported->parts[0].deformation);
  EXPECT_TRUE(warnings.empty());
  for (const double time : {0.0, 0.5, 1.0}) {
    const auto shown = shown_surfaces(std::span(&surface, 1), time);
    const MeshArrays& mesh = to_arrays(*shown.at(0).mesh);
    for (std::size_t i = 0; i < 4; ++i) {
      const glm::vec2 rest(surface.imported->parts[0].deformation->rest.points.at(i));
      const glm::vec3 wanted(rest.x + (rest.y > 0.5f ? 4.0 * time : 0.0), rest.y, 0.0);
      EXPECT_LT(glm::distance(mesh.points.at(i), wanted), 5e-3f) << time << ": " << i;
    }
  }
}

// The upper corners go up by 2 in a second, while the square moves.
TEST(FbxScene, MorphTargetsHaveTheWeightsOfTheTime) {
  std::string text = moving_square;
  text.insert(text.find("\tMaterial: 300"), R"(	Geometry: 110, "Geometry::tall", "Shape" {
		Version: 100
		Indexes: *2 {
			a: 2,3
		}
		Vertices: *6 {
			a: 0,2,0,0,2,0
		}
		Normals: *6 {
			a: 0,0,0,0,0,0
		}
	}
	Deformer: 710, "Deformer::", "BlendShape" {
		Version: 100
	}
	Deformer: 711, "SubDeformer::tall", "BlendShapeChannel" {
		Version: 100
		DeformPercent: 0
		FullWeights: *1 {
			a: 100
		}
	}
	AnimationCurveNode: 412, "AnimCurveNode::DeformPercent", "" {
		Properties70:  {
			P: "d|DeformPercent", "Number", "", "A",0
		}
	}
	AnimationCurve: 510, "AnimCurve::", "" {
		KeyVer: 4008
		KeyTime: *2 {
			a: 0,46186158000
		}
		KeyValueFloat: *2 {
			a: 0,100
		}
		KeyAttrFlags: *1 {
			a: 24836
		}
		KeyAttrDataFloat: *4 {
			a: 0,0,0,0
		}
		KeyAttrRefCount: *1 {
			a: 2
		}
	}
)");
  const std::string rest = R"(	C: "OO",710,100
	C: "OO",711,710
	C: "OO",110,711
)";
  const std::string weights = R"(	C: "OO",412,401
	C: "OP",412,711, "DeformPercent"
	C: "OP",510,412, "d|DeformPercent"
)";
  const TemporaryFolder folder;
  folder.write("picture.png", encode_png(2, 2, std::array<std::uint8_t, 12>{}));
  std::vector<std::string> warnings;
  Surface surface;
  const auto read = [&](const std::string& connections) {
    std::string whole = text;
    whole.insert(whole.rfind('}'), connections);
    surface.imported = read_imported_scene(folder.write("a.fbx", whole), warnings);
  };
  read(rest + weights);
  EXPECT_TRUE(warnings.empty());
  for (const double time : {0.0, 0.25, 1.0}) {
    const auto shown = shown_surfaces(std::span(&surface, 1), time);
    const auto points = world_points(shown.at(0));
    ASSERT_EQ(points.size(), 4u);
    for (std::size_t i = 0; i < 4; ++i) {
      const glm::dvec3 corner(surface.imported->parts[0].deformation->rest.points.at(i));
      const glm::dvec3 wanted = corner + glm::dvec3(1.0 + 4.0 * time, 2.0, 3.0) +
                                glm::dvec3(0.0, 2.0 * time * corner.y, 0.0);
      EXPECT_LT(glm::distance(points[i], wanted), 5e-3) << time << ": " << i;
    }
  }
  read(rest);
  EXPECT_EQ(surface.imported->parts[0].deformation, nullptr);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_TRUE(warnings[0].find("morph targets, which are not animated") != std::string::npos);
}

// Lights of FBX scenes: units and decay.

struct FbxLight {
  int type;  // 0 point, 1 directional, 2 spot, 3 area
  int decay;
};

// Lights of Intensity 250 at (0, 4, 0), 4 units from the middle, of a program.
std::string lights_fbx(const std::string& creator, double unit,
                       std::initializer_list<FbxLight> all) {
  std::string objects;
  std::string connections;
  int id = 1000;
  for (const FbxLight& light : all) {
    const std::string name = std::to_string(id);
    objects += "\tNodeAttribute: " + name + R"(, "NodeAttribute::l", "Light" {
		TypeFlags: "Light"
		Properties70:  {
			P: "LightType", "enum", "", "",)" +
               std::to_string(light.type) + R"(
			P: "DecayType", "enum", "", "",)" +
               std::to_string(light.decay) + R"(
			P: "DecayStart", "double", "Number", "",25
			P: "Color", "Color", "", "A",1,0.5,0
			P: "Intensity", "Number", "", "A",250
		}
	}
	Model: )" +
               std::to_string(id + 1) + R"(, "Model::l)" + name + R"(", "Light" {
		Properties70:  {
			P: "Lcl Translation", "Lcl Translation", "", "A",0,4,0
		}
	}
)";
    connections += "\tC: \"OO\"," + std::to_string(id + 1) + ",0\n\tC: \"OO\"," + name + "," +
                   std::to_string(id + 1) + "\n";
    id += 2;
  }
  return R"(; FBX 7.4.0 project file
FBXHeaderExtension:  {
	FBXVersion: 7400
	Creator: ")" +
         creator + R"("
}
Creator: ")" +
         creator + R"("
GlobalSettings:  {
	Properties70:  {
		P: "UnitScaleFactor", "double", "Number", "",)" +
         std::to_string(unit) + R"(
	}
}
Objects:  {
)" + objects +
         "}\nConnections:  {\n" + connections + "}\n";
}

TEST(FbxLights, HaveTheUnitsOfTheProgramThatWroteThem) {
  const TemporaryFolder folder;
  std::vector<std::string> warnings;
  constexpr double pi = std::numbers::pi;
  const auto expect_lights = [&](const std::string& text, const std::vector<double>& red) {
    warnings.clear();
    const auto scene = read_imported_scene(folder.write("a.fbx", text), warnings);
    ASSERT_EQ(scene->lights.size(), red.size());
    for (std::size_t i = 0; i < red.size(); ++i) {
      const glm::dvec3& found = scene->lights[i].intensity;
      EXPECT_NEAR(found.r, red[i], 1e-6 * red[i]) << i;
      EXPECT_NEAR(found.g, 0.5 * red[i], 1e-6 * red[i]) << i;
    }
  };
  // Watts in all directions, and W/m² of suns, whatever the decay.
  expect_lights(
      lights_fbx("Blender (stable FBX IO) - 3.4.1 - 4.37.1", 100.0, {{0, 2}, {2, 0}, {1, 2}}),
      {2.5 / (4.0 * pi), 2.5 / (4.0 * pi), 2.5});
  EXPECT_TRUE(warnings.empty());
  // A white surface at one unit has the radiance 2.5; suns and decays by the square have no
  // middle of the scene.
  const std::string maya = "FBX SDK/FBX Plugins version 2020.1";
  expect_lights(lights_fbx(maya, 100.0, {{0, 2}, {2, 2}, {1, 0}}), {2.5 * pi, 2.5 * pi, 2.5 * pi});
  EXPECT_TRUE(warnings.empty());
  expect_lights(lights_fbx(maya, 1.0, {{0, 2}}), {2.5e-4 * pi});
  // Others are as bright as there 4 m away.
  const double bright = 2.5 * pi;  // W/m²
  expect_lights(lights_fbx(maya, 100.0, {{0, 0}, {0, 1}, {0, 3}}),
                {bright * 16.0, bright * 16.0 / 4.0, bright * 16.0 / 64.0});
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_TRUE(warnings[0].find("do not decay by the square") != std::string::npos) << warnings[0];
}

TEST(FbxLights, WithoutASizeAreLeftOut) {
  const TemporaryFolder folder;
  std::vector<std::string> warnings;
  const auto file = folder.write("a.fbx", lights_fbx("x", 1.0, {{3, 2}, {3, 2}}));
  EXPECT_TRUE(read_imported_scene(file, warnings)->lights.empty());
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_TRUE(warnings[0].find("area and volume lights are left out") != std::string::npos);
}

TEST(FbxLights, ConesWhoseInsideIsWiderAreRead) {
  const TemporaryFolder folder;
  std::vector<std::string> warnings;
  std::string text = lights_fbx("Blender", 100.0, {{2, 2}});
  const std::string intensity = "P: \"Intensity\"";
  text.insert(text.find(intensity), R"(P: "InnerAngle", "Number", "", "A",60
			P: "OuterAngle", "Number", "", "A",45
			)");
  const auto scene = read_imported_scene(folder.write("a.fbx", text), warnings);
  const auto& spot = std::get<light::Spot>(scene->lights.at(0).kind);
  EXPECT_NEAR(spot.outer_angle, 22.5, 1e-5);
  EXPECT_NEAR(spot.inner_angle, 22.5, 1e-5);
}

}  // namespace

}  // namespace brume
