// Lights of FBX scenes: units and decay.

#include <gtest/gtest.h>

#include <initializer_list>
#include <numbers>
#include <string>
#include <vector>

#include "core/io/import/imported_scene_file.h"
#include "core/scene/imported_scene.h"
#include "tests/core/io/temporary_folder.h"

namespace brume {
namespace {

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
