#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <string>

#include "brume/error.h"
#include "brume/primitive.h"
#include "brume/scene.h"

namespace brume {
namespace {

Scene sound_scene() {
  Scene scene;
  scene.medium.append({{0, 0, 0}, 1.0, 0.5});
  scene.lights.push_back({.position = {0, 2, 0}});
  Surface floor;
  floor.primitive = Primitive{};
  floor.mesh = mesh_of(*floor.primitive);
  scene.surfaces.push_back(floor);
  return scene;
}

std::string refusal(const std::function<void(Scene&)>& spoil) {
  Scene scene = sound_scene();
  spoil(scene);
  try {
    check(scene);
  } catch (const DomainError& error) {
    return error.what();
  }
  return "";
}

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

TEST(Check, AcceptsWhatIsSound) {
  EXPECT_EQ(refusal([](Scene&) {}), "");
  EXPECT_EQ(refusal([](Scene& scene) { scene = {}; }), "");
}

TEST(Check, NamesThePlaceTheValueAndWhatIsAllowed) {
  EXPECT_EQ(refusal([](Scene& s) { s.medium.columns().radii[0] = -1.0; }),
            "medium.gaussians[0].radius: found -1; allowed: a number > 0 (from 1e-12 to 1e12)");
  EXPECT_EQ(refusal([](Scene& s) { s.lights[0].position.y = nan; }),
            "lights[0].position[1]: found nan; allowed: a number from -1e12 to 1e12");
  EXPECT_EQ(refusal([](Scene& s) { s.camera.target = s.camera.eye; }),
            "camera.target: found the position of the eye; allowed: any other point");
}

TEST(Check, RefusesWhatNoFileCouldHave) {
  const struct {
    const char* place;
    std::function<void(Scene&)> spoil;
  } cases[] = {
      {"medium.gaussians[0].center[2]", [](Scene& s) { s.medium.columns().centers[0].z = nan; }},
      {"medium.gaussians[0].density", [](Scene& s) { s.medium.columns().densities[0] = infinity; }},
      {"medium.gaussians[1].albedo[0]",
       [](Scene& s) {
         s.medium.append({{}, 1.0, 1.0, {.albedo = glm::dvec3(2.0)}});
       }},
      {"medium.gaussians[1].group",
       [](Scene& s) {
         s.medium.append({{}, 1.0, 1.0, {}, 7});
       }},
      {"medium.gaussians[1].shape.stretch[2]",
       [](Scene& s) {
         s.medium.append({{}, 1.0, 1.0, {}, 0, {{1.0, 1.0, 1e-5}}});
       }},
      {"medium.gaussians[1].shape.stretch",
       [](Scene& s) {
         s.medium.append({{}, 1.0, 1.0, {}, 0, {{0.5, 0.9, 0.9}}});
       }},
      {"medium.gaussians[1].shape.rotation",
       [](Scene& s) {
         s.medium.append({{}, 1.0, 1.0, {}, 0, {{1.0, 0.5, 0.5}, {0.924, 0.0, 0.0, 0.383}}});
       }},
      {"medium.gaussians[1].shape.rotation",
       [](Scene& s) {
         s.medium.append({{}, 1.0, 1.0, {}, 0, {{1.0, 0.5, 0.5}, {nan, 0.0, 0.0, 0.0}}});
       }},
      {"medium.density", [](Scene& s) { s.medium.set_homogeneous_density(-0.1); }},
      {"medium.albedo[0]", [](Scene& s) { s.optics.albedo.x = 0.0; }},
      {"medium.anisotropy", [](Scene& s) { s.optics.anisotropy = 1.0; }},
      {"medium.noise.amplitude", [](Scene& s) { s.optics.noise.amplitude = nan; }},
      {"camera.vertical_fov", [](Scene& s) { s.camera.vertical_fov = 180.0; }},
      {"camera.up", [](Scene& s) { s.camera.up = {}; }},
      {"film.width", [](Scene& s) { s.film.width = 0; }},
      {"cameras[0].target",
       [](Scene& s) {
         s.cameras.push_back({"b", {{}, {}}, {}});
       }},
      {"lights[0].intensity[0]", [](Scene& s) { s.lights[0].intensity.x = -1.0; }},
      {"lights[0].inner_angle",
       [](Scene& s) {
         s.lights[0].kind = light::Spot{{0, -1, 0}, 50.0, 40.0};
       }},
      {"lights[0].outer_angle",
       [](Scene& s) {
         s.lights[0].kind = light::Spot{{0, -1, 0}, 0.0, 0.0};
       }},
      {"lights[0].direction",
       [](Scene& s) {
         s.lights[0].kind = light::Directional{{0, 0, 0}};
       }},
      {"lights[0].keys.position[1].time",
       [](Scene& s) {
         s.lights[0].keys.position = {{.time = 1.0}, {.time = 0.0}};
       }},
      {"surfaces[0].mesh", [](Scene& s) { s.surfaces[0].mesh = nullptr; }},
      {"surfaces[0].rotate",
       [](Scene& s) {
         s.surfaces[0].rotate = {nan, 0, 0, 0};
       }},
      {"surfaces[0].scale", [](Scene& s) { s.surfaces[0].scale = 0.0; }},
      {"surfaces[0].reflectance[1]", [](Scene& s) { s.surfaces[0].material.reflectance.y = 1.5; }},
      {"surfaces[0].material.roughness",
       [](Scene& s) {
         s.surfaces[0].material.type = Material::Type::metallic_roughness;
         s.surfaces[0].material.metallic_roughness.roughness = nan;
       }},
      {"surfaces[0].material.measured",
       [](Scene& s) { s.surfaces[0].material.type = Material::Type::measured; }},
      {"environment.map", [](Scene& s) { s.environment.emplace(); }},
      {"medium.emitters[0].radius[1]", [](Scene& s) { s.emitters.emplace_back().radius.y = 0.0; }},
      {"medium.groups[0].parent",
       [](Scene& s) { s.groups.push_back({.id = 1, .name = "a", .parent = 1}); }},
      {"medium.groups[1].id",
       [](Scene& s) {
         s.groups = {{.id = 1, .name = "a"}, {.id = 1, .name = "b"}};
       }},
      {"camera.up",
       [](Scene& s) {
         s.camera.up = {0, 1e-200, 0};
       }},
      {"camera.name", [](Scene& s) { s.camera_name = ""; }},
      {"cameras[0].name",
       [](Scene& s) {
         s.cameras.push_back({s.camera_name, {}, {}});
       }},
      {"film.region.full_width", [](Scene& s) { s.film.region.emplace(); }},
      {"film.shift[0]", [](Scene& s) { s.film.shift.x = nan; }},
      {"output.samples", [](Scene& s) { s.output.samples = 0; }},
      {"output.paths", [](Scene& s) { s.output.paths = -1; }},
      {"output.shutter[1]",
       [](Scene& s) {
         s.output.shutter = Shutter{0.0, nan};
       }},
      {"output.shutter",
       [](Scene& s) {
         s.output.shutter = Shutter{1.0, 1.0};
       }},
      {"output.exposure", [](Scene& s) { s.output.exposure = infinity; }},
      {"timeline.frames_per_second",
       [](Scene& s) { s.playback = Playback{.frames_per_second = 0.0}; }},
      {"timeline.last", [](Scene& s) { s.playback = Playback{.first = 2, .last = 1}; }},
      {"lights[0].name", [](Scene& s) { s.lights[0].name = "a\nb"; }},
      {"lights[0].keys.position[0].in[1]",
       [](Scene& s) {
         s.lights[0].keys.position = {{.time = 0.0, .in = glm::dvec3(0.0, nan, 0.0)}};
       }},
      {"surfaces[0].name", [](Scene& s) { s.surfaces[0].name = std::string(300, 'x'); }},
      {"surfaces[0].primitive.size[0]", [](Scene& s) { s.surfaces[0].primitive->size.x = 1e300; }},
      {"medium.groups[0].name", [](Scene& s) { s.groups.push_back({.id = 1}); }},
      {"medium.groups[0].color[2]",
       [](Scene& s) {
         s.groups.push_back({.id = 1, .name = "a", .color = {0, 0, 2}});
       }},
      {"medium.splines[0].points", [](Scene& s) { s.splines.push_back({.id = 1, .name = "a"}); }},
      {"medium.splines[0].radius",
       [](Scene& s) {
         s.splines.push_back({.id = 1, .name = "a", .points = {{}}, .brush = {.radius = 0.0}});
       }},
      {"medium.sequences[0].last", [](Scene& s) { s.sequences.push_back({.first = 3}); }},
      {"medium.sequences[0].frames", [](Scene& s) { s.sequences.emplace_back(); }},
      {"medium.sequences[0].frames[0].ids",
       [](Scene& s) {
         s.sequences.emplace_back().frames = sequence_frames({{{}, {Gaussian{}}}});
       }},
      {"medium, with emitters and sequences",
       [](Scene& s) { s.emitters.assign(1000, Emitter{.rate = 1e5, .lifetime = 1.0}); }},
  };
  for (const auto& [place, spoil] : cases) {
    const std::string text = refusal(spoil);
    EXPECT_TRUE(text.starts_with(std::string(place) + ": ")) << place << ": " << text;
  }
}

// A file may have it.
TEST(Check, AcceptsADirectionThatItsKeysGive) {
  EXPECT_EQ(refusal([](Scene& s) {
              s.lights[0].kind = light::Spot{{0, 0, 0}};
              s.lights[0].keys.direction = {{.time = 0.0, .value = {0, -1, 0}}};
            }),
            "");
}

}  // namespace
}  // namespace brume
