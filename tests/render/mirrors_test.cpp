// Smooth surfaces mirror what is around them.

#include <gtest/gtest.h>

#include <glm/gtc/quaternion.hpp>
#include <utility>

#include "brume/frame.h"
#include "tests/pictures.h"
#include "tests/render/test_scenes.h"

namespace brume {
namespace {

void make_metal(Surface& surface, double base_color, double roughness) {
  surface.material.type = Material::Type::metallic_roughness;
  MetallicRoughness& material = surface.material.metallic_roughness;
  material.base_color = glm::dvec3(base_color);
  material.metallic = 1.0;
  material.roughness = roughness;
}

// Boxes on a floor, lit from above.
Scene boxes_on_a_floor() {
  Scene scene;
  scene.film = {48, 36};
  scene.camera = {.eye = {0.0, 1.0, 4.0}, .target = {0.0, 0.2, 0.0}, .vertical_fov = 50.0};
  scene.surfaces = {placed(Primitive::Shape::plane, {12.0, 1.0, 12.0}, {0.0, 0.0, 0.0}),
                    placed(Primitive::Shape::box, {0.8, 1.0, 0.8}, {-0.8, 0.6, -0.5}),
                    placed(Primitive::Shape::box, {0.8, 1.6, 0.8}, {0.8, 0.9, -1.0})};
  scene.surfaces[1].material.reflectance = {0.8, 0.1, 0.1};
  scene.surfaces[2].material.reflectance = {0.1, 0.2, 0.8};
  Light light;
  light.position = {2.0, 3.0, 2.0};
  light.intensity = glm::dvec3(40.0);
  scene.lights = {light};
  return scene;
}

glm::vec3 pixel(const Frame& frame, int x, int y) {
  const auto i = 4 * static_cast<std::size_t>(y * frame.film.width + x);
  return {frame.beauty[i], frame.beauty[i + 1], frame.beauty[i + 2]};
}

// A white mirror shows what an eye below it sees where it is away.
TEST(Mirrors, ShowWhatAMirroredEyeSees) {
  Scene scene = boxes_on_a_floor();
  make_metal(scene.surfaces[0], 1.0, 0.0);
  const Frame mirrored = render_frame(scene, sliced(8));
  scene.surfaces[0].translate.y = -20.0;
  scene.surfaces[0].material.metallic_roughness.base_color = glm::dvec3(0.0);
  scene.camera.eye.y *= -1.0;
  scene.camera.target.y *= -1.0;
  const Frame from_below = render_frame(scene, sliced(8));
  int boxes = 0;
  for (int y = 24; y < 36; ++y) {
    for (int x = 0; x < 48; ++x) {
      const glm::vec3 seen = pixel(from_below, x, 35 - y);
      const glm::vec3 shown = pixel(mirrored, x, y);
      if (!(seen.x + seen.z > 0.05f) || !(shown.x + shown.z > 0.05f)) continue;
      ++boxes;
      EXPECT_NEAR(shown.x, seen.x, 0.01f * seen.x + 1e-4f) << x << " " << y;
      EXPECT_NEAR(shown.z, seen.z, 0.01f * seen.z + 1e-4f) << x << " " << y;
    }
  }
  EXPECT_GT(boxes, 40);
}

double mean_difference(const Frame& a, const Frame& b, int first_row) {
  double difference = 0.0;
  double sum = 0.0;
  for (int y = first_row; y < a.film.height; ++y) {
    for (int x = 0; x < a.film.width; ++x) {
      difference += static_cast<double>(pixel(a, x, y).x - pixel(b, x, y).x);
      sum += static_cast<double>(pixel(b, x, y).x);
    }
  }
  return difference / sum;
}

// Narrower highlights of a point light are rare, bright paths.
TEST(Mirrors, AreAsBrightInFogAsPathsHaveThem) {
  for (const double roughness : {0.2, 0.45}) {
    Scene scene = in_fog(boxes_on_a_floor(), 0.05);
    scene.optics.albedo = glm::dvec3(0.7);
    make_metal(scene.surfaces[0], 0.8, roughness);
    const Frame mirrored = render_frame(scene, sliced(24, Scattering::multiple));
    const Frame paths = render_frame(scene, path_traced(48));
    EXPECT_NEAR(mean_difference(mirrored, paths, 22), 0.0, 0.03) << roughness;
  }
}

// A glowing wall and a gray sky around what is mirrored.
Scene glowing_wall(Surface mirror, double roughness) {
  Scene scene;
  scene.film = {32, 24};
  scene.camera = {.eye = {0.0, 1.2, 4.0}, .target = {0.0, 0.3, 0.0}, .vertical_fov = 40.0};
  scene.surfaces = {std::move(mirror),
                    placed(Primitive::Shape::box, {1.5, 3.0, 0.1}, {0.3, 1.6, -1.5})};
  make_metal(scene.surfaces[0], 0.9, roughness);
  make_metal(scene.surfaces[1], 0.0, 1.0);
  scene.surfaces[1].material.metallic_roughness.emissive = glm::dvec3(2.0);
  scene.environment = even_sky(0.3f);
  return scene;
}

double error_beside_paths(const Scene& scene, int samples) {
  Settings settings = sliced(8);
  Settings paths = path_traced(512);
  settings.samples = paths.samples = samples;
  return rel_rmse(render_frame(scene, settings).beauty, render_frame(scene, paths).beauty);
}

// Neighbours share the rays of wide highlights, not what they reflect: textures stay sharp.
TEST(Mirrors, KeepTheTexturesOfMetals) {
  Scene scene =
      glowing_wall(placed(Primitive::Shape::plane, {4.0, 1.0, 4.0}, {0.0, 0.0, 0.0}), 0.3);
  scene.surfaces[0].material.metallic_roughness.base_color_texture = {
      "a.png", picture(8, [](int x, int y) { return (x + y) % 2 == 0 ? 0xffffffu : 0x202020u; })};
  scene.film = {64, 48};  // blocks of 4 x 4 pixels widen the image of the wall less
  EXPECT_LT(error_beside_paths(scene, 1), 0.07);
}

// The faces of one mesh mirror different parts of the scene, also where samples of a pixel see
// both.
TEST(Mirrors, KeepTheEdgesOfAMesh) {
  Surface box = placed(Primitive::Shape::box, {1.6, 1.0, 1.6}, {0.0, 0.3, 0.6});
  box.rotate = glm::angleAxis(0.6, glm::dvec3(0.0, 1.0, 0.0));
  EXPECT_LT(error_beside_paths(glowing_wall(box, 0.3), 16), 0.06);
}

// A surface that curves within a few pixels has few neighbours to share with.
TEST(Mirrors, AreSharpOnSmallBalls) {
  const Surface ball = placed(Primitive::Shape::sphere, glm::dvec3(1.4), {0.0, 0.5, 0.8});
  EXPECT_LT(error_beside_paths(glowing_wall(ball, 0.17), 1), 0.12);
}

// A surface that emits is seen in them, and makes no highlights beside that.
TEST(Mirrors, ShowWhatEmitsOnce) {
  Scene scene = boxes_on_a_floor();
  scene.lights.clear();
  make_metal(scene.surfaces[0], 0.8, 0.1);
  make_metal(scene.surfaces[1], 0.0, 1.0);
  scene.surfaces[1].material.metallic_roughness.emissive = glm::dvec3(3.0);
  const Frame mirrored = render_frame(scene, sliced(8, Scattering::multiple));
  const Frame paths = render_frame(scene, path_traced(256));
  EXPECT_NEAR(mean_difference(mirrored, paths, 20), 0.0, 0.03);
}

TEST(Mirrors, OfEachOtherEnd) {
  Scene scene = in_fog(boxes_on_a_floor(), 0.05);
  for (Surface& surface : scene.surfaces) make_metal(surface, 1.0, 0.0);
  expect_finite(render_frame(scene, sliced(8, Scattering::multiple)));
}

// A mirror adds as much to the airlight as paths have it.
TEST(Mirrors, SendLightIntoTheFog) {
  Scene scene = in_fog(boxes_on_a_floor(), 0.02);
  scene.surfaces.resize(1);
  scene.camera = {.eye = {0.0, 2.0, 4.0}, .target = {0.0, 2.0, 0.0}, .vertical_fov = 30.0};
  const auto airlight = [&](double base_color, const Settings& settings) {
    make_metal(scene.surfaces[0], base_color, 0.2);
    return mean_airlight(scene, settings);
  };
  const auto added = [&](const Settings& settings) {
    return airlight(1.0, settings) - airlight(0.0, settings);
  };
  EXPECT_NEAR(added(sliced(24, Scattering::multiple)) / added(path_traced(64)), 1.0, 0.05);
}

}  // namespace
}  // namespace brume
