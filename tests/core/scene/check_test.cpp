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
  const auto refused = [](const std::string& place, const std::function<void(Scene&)>& spoil) {
    const std::string text = refusal(spoil);
    EXPECT_TRUE(text.starts_with(place + ": ")) << place << ": " << text;
  };
  const auto refused_gaussian = [&refused](const std::string& member, const Gaussian& gaussian) {
    refused("medium.gaussians[1]." + member, [&](Scene& s) { s.medium.append(gaussian); });
  };
  refused("medium.gaussians[0].center[2]", [](Scene& s) { s.medium.columns().centers[0].z = nan; });
  refused("medium.gaussians[0].density",
          [](Scene& s) { s.medium.columns().densities[0] = infinity; });
  refused_gaussian("albedo[0]", {{}, 1.0, 1.0, {.albedo = glm::dvec3(2.0)}});
  refused_gaussian("group", {{}, 1.0, 1.0, {}, 7});
  refused_gaussian("shape.stretch[2]", {{}, 1.0, 1.0, {}, 0, {{1.0, 1.0, 1e-5}}});
  refused_gaussian("shape.stretch", {{}, 1.0, 1.0, {}, 0, {{0.5, 0.9, 0.9}}});
  refused_gaussian("shape.rotation",
                   {{}, 1.0, 1.0, {}, 0, {{1.0, 0.5, 0.5}, {0.924, 0.0, 0.0, 0.383}}});
  refused_gaussian("shape.rotation",
                   {{}, 1.0, 1.0, {}, 0, {{1.0, 0.5, 0.5}, {nan, 0.0, 0.0, 0.0}}});
  refused("medium.density", [](Scene& s) { s.medium.set_homogeneous_density(-0.1); });
  refused("medium.albedo[0]", [](Scene& s) { s.optics.albedo.x = 0.0; });
  refused("medium.anisotropy", [](Scene& s) { s.optics.anisotropy = 1.0; });
  refused("medium.noise.amplitude", [](Scene& s) { s.optics.noise.amplitude = nan; });
  refused("camera.vertical_fov", [](Scene& s) { s.camera.vertical_fov = 180.0; });
  refused("camera.up", [](Scene& s) { s.camera.up = {}; });
  refused("film.width", [](Scene& s) { s.film.width = 0; });
  refused("cameras[0].target", [](Scene& s) { s.cameras.push_back({"b", {{}, {}}, {}}); });
  refused("lights[0].intensity[0]", [](Scene& s) { s.lights[0].intensity.x = -1.0; });
  refused("lights[0].inner_angle", [](Scene& s) {
    s.lights[0].kind = light::Spot{{0, -1, 0}, 50.0, 40.0};
  });
  refused("lights[0].outer_angle", [](Scene& s) {
    s.lights[0].kind = light::Spot{{0, -1, 0}, 0.0, 0.0};
  });
  refused("lights[0].direction", [](Scene& s) {
    s.lights[0].kind = light::Directional{{0, 0, 0}};
  });
  refused("lights[0].keys.position[1].time", [](Scene& s) {
    s.lights[0].keys.position = {{.time = 1.0}, {.time = 0.0}};
  });
  refused("surfaces[0].mesh", [](Scene& s) { s.surfaces[0].mesh = nullptr; });
  refused("surfaces[0].rotate", [](Scene& s) { s.surfaces[0].rotate = {nan, 0, 0, 0}; });
  refused("surfaces[0].scale", [](Scene& s) { s.surfaces[0].scale = 0.0; });
  refused("surfaces[0].reflectance[1]",
          [](Scene& s) { s.surfaces[0].material.reflectance.y = 1.5; });
  refused("surfaces[0].material.roughness", [](Scene& s) {
    s.surfaces[0].material.type = Material::Type::metallic_roughness;
    s.surfaces[0].material.metallic_roughness.roughness = nan;
  });
  refused("surfaces[0].material.measured",
          [](Scene& s) { s.surfaces[0].material.type = Material::Type::measured; });
  refused("environment.map", [](Scene& s) { s.environment.emplace(); });
  refused("medium.emitters[0].radius[1]",
          [](Scene& s) { s.emitters.emplace_back().radius.y = 0.0; });
  refused("medium.groups[0].parent",
          [](Scene& s) { s.groups.push_back({.id = 1, .name = "a", .parent = 1}); });
  refused("medium.groups[1].id", [](Scene& s) {
    s.groups = {{.id = 1, .name = "a"}, {.id = 1, .name = "b"}};
  });
  refused("camera.up", [](Scene& s) { s.camera.up = {0, 1e-200, 0}; });
  refused("camera.name", [](Scene& s) { s.camera_name = ""; });
  refused("cameras[0].name", [](Scene& s) { s.cameras.push_back({s.camera_name, {}, {}}); });
  refused("film.region.full_width", [](Scene& s) { s.film.region.emplace(); });
  refused("film.shift[0]", [](Scene& s) { s.film.shift.x = nan; });
  refused("output.samples", [](Scene& s) { s.output.samples = 0; });
  refused("output.paths", [](Scene& s) { s.output.paths = -1; });
  refused("output.shutter[1]", [](Scene& s) { s.output.shutter = Shutter{0.0, nan}; });
  refused("output.shutter", [](Scene& s) { s.output.shutter = Shutter{1.0, 1.0}; });
  refused("output.exposure", [](Scene& s) { s.output.exposure = infinity; });
  refused("timeline.frames_per_second",
          [](Scene& s) { s.playback = Playback{.frames_per_second = 0.0}; });
  refused("timeline.last", [](Scene& s) { s.playback = Playback{.first = 2, .last = 1}; });
  refused("lights[0].name", [](Scene& s) { s.lights[0].name = "a\nb"; });
  refused("lights[0].keys.position[0].in[1]", [](Scene& s) {
    s.lights[0].keys.position = {{.time = 0.0, .in = glm::dvec3(0.0, nan, 0.0)}};
  });
  refused("surfaces[0].name", [](Scene& s) { s.surfaces[0].name = std::string(300, 'x'); });
  refused("surfaces[0].primitive.size[0]",
          [](Scene& s) { s.surfaces[0].primitive->size.x = 1e300; });
  refused("medium.groups[0].name", [](Scene& s) { s.groups.push_back({.id = 1}); });
  refused("medium.groups[0].color[2]", [](Scene& s) {
    s.groups.push_back({.id = 1, .name = "a", .color = {0, 0, 2}});
  });
  refused("medium.splines[0].points",
          [](Scene& s) { s.splines.push_back({.id = 1, .name = "a"}); });
  refused("medium.splines[0].radius", [](Scene& s) {
    s.splines.push_back({.id = 1, .name = "a", .points = {{}}, .brush = {.radius = 0.0}});
  });
  refused("medium.sequences[0].last", [](Scene& s) { s.sequences.push_back({.first = 3}); });
  refused("medium.sequences[0].frames", [](Scene& s) { s.sequences.emplace_back(); });
  refused("medium.sequences[0].frames[0].ids", [](Scene& s) {
    s.sequences.emplace_back().frames = sequence_frames({{{}, {Gaussian{}}}});
  });
  refused("medium, with emitters and sequences",
          [](Scene& s) { s.emitters.assign(1000, Emitter{.rate = 1e5, .lifetime = 1.0}); });
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
